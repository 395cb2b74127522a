#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Seconds against the gradient that is left: the minimisers on the same unknowns,
# from the flat sheet in one growth step, one thread.
# On triangles at two cells a stitch all start on that mesh; elsewhere the factored ones come through coarser ones.
. "${srcdir:-.}/bench/lib.sh"
table=$results/gradient.csv
echo "scene,discretisation,per_stitch,method,tolerance,gradient,energy,iterations,evaluations,factorisations,cpu_s,wall_s,runs,status" >"$table"
for at in ${BENCH_SCENES:-miura:triangle:2 miura:triangle:4 miura_2x2:triangle:2 \
    miura:patch:1 miura_2x2:patch:1 miura_2x2:patch:2}; do
    scene=${at%%:*}
    cells=${at##*:}
    mesh=${at#*:}
    mesh=${mesh%:*}
    tolerances=1e-6     # on patches the bar's own
    [ $mesh = patch ] || tolerances="1e-2 1e-3 1e-4 1e-5 1e-6 1e-8"
    for method in lbfgs plbfgs newton auto; do
        for tolerance in $tolerances; do
            measure "$(with_settings "$scenes/$scene.knit" "solve { tolerance = $tolerance; max_iterations = 1000000 }")" \
                --discretisation "$mesh" --per-stitch $cells --steps 1 --method $method -j 1
            echo "$scene,$mesh,$cells,$method,$tolerance,$(figures solve.gradient_max energy.total solve.iterations solve.evaluations \
                solve.factorisations),$cpu,$wall,$runs,$(figure solve.status)" >>"$table"
            say "$(tail -n 1 "$table")"
        done
    done
done
