#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Seconds against the gradient that is left: the minimisers on the same unknowns,
# one triangle mesh, from the flat sheet in one growth step, one thread.
# At two cells a stitch all start on that mesh; at four the factored ones come through the coarser one.
. "${srcdir:-.}/bench/lib.sh"
table=$results/gradient.csv
echo "scene,per_stitch,method,tolerance,gradient,energy,iterations,evaluations,factorisations,cpu_s,wall_s,runs,status" >"$table"
for at in ${BENCH_SCENES:-miura:2 miura:4 miura_2x2:2}; do
    scene=${at%:*}
    cells=${at#*:}
    for method in lbfgs plbfgs newton auto; do
        for tolerance in 1e-2 1e-3 1e-4 1e-5 1e-6 1e-8; do
            measure "$(with_settings "$scenes/$scene.knit" "solve { tolerance = $tolerance; max_iterations = 1000000 }")" \
                --discretisation triangle --per-stitch $cells --steps 1 --method $method -j 1
            echo "$scene,$cells,$method,$tolerance,$(figures solve.gradient_max energy.total solve.iterations solve.evaluations \
                solve.factorisations),$cpu,$wall,$runs,$(figure solve.status)" >>"$table"
            say "$(tail -n 1 "$table")"
        done
    done
done
