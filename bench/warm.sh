# SPDX-License-Identifier: GPL-3.0-or-later
# Points of a sweep from the flat sheet and from their neighbour's shape: time, and is it one minimum?
. "${srcdir:-.}/bench/lib.sh"
table=$results/warm.csv
echo "sweep,points,cold_s,warm_s,ratio,other_minima,of_them_lower" >"$table"

# chain MOTIF SWATCH PARAM VALUE...: of the library's motif; its curvature c or thickness t goes through the values.
chain()
{
    what="$1; $3 $4"
    cat >"$work/scene.knit" <<KNIT
use $1 from std
param c = 1 in 0..3
param t = 0.5 in 0.01..3
stitch K { kx = -c; ky = c }
material { thickness = t }
swatch $2
KNIT
    shift 2
    bench/warm "$work/scene.knit" "$@" >"$work/rows.csv"
    for value; do last=$value; done
    awk -F , -v what="$what to $last" '
        NR > 1 { n++; cold += $5; warm += $8; other += $9 != "same"; lower += $9 == "lower" }
        END { printf "%s,%d,%.2f,%.2f,%.2f,%d,%d\n", what, n, cold, warm, cold / warm, other, lower }' "$work/rows.csv" >>"$table"
    say "$(tail -n 1 "$table")"
}

chain rib_2x2 'fill(rib_2x2, 20, 20)' t 0.3 0.35 0.4 0.45 0.5 0.55 0.6
chain rib_2x2 'fill(rib_2x2, 20, 20)' t 0.6 0.55 0.5 0.45 0.4 0.35 0.3
chain rib_2x2 'fill(rib_2x2, 20, 20)' t 0.2 0.4 0.8 1.6
chain miura 'miura' c 0.7 0.75 0.8 0.85 0.9 0.95 1
chain miura 'miura' c 1 0.95 0.9 0.85 0.8 0.75 0.7
chain miura 'miura' c 0.3 0.6 1 1.5
chain miura 'tile(miura, 2, 2)' c 0.8 0.85 0.9 0.95 1
chain squiggles 'squiggles' c 0.7 0.8 0.9 1 1.1
chain garter 'fill(garter, 20, 20)' t 0.3 0.4 0.5 0.6
chain seed 'fill(seed, 20, 20)' t 0.3 0.4 0.5 0.6
chain stockinette 'fill(stockinette, 12, 60)' c 0.5 0.7 0.9 1.1 1.3
chain stockinette 'fill(stockinette, 12, 60)' c 1.3 1.1 0.9 0.7 0.5
chain stockinette 'fill(stockinette, 12, 60)' t 0.3 0.5 0.7 0.9
