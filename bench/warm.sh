# SPDX-License-Identifier: GPL-3.0-or-later
# `weft sweep` and `weft sweep --warm`, checks and what they take back included: time, and is it one minimum?
. "${srcdir:-.}/bench/lib.sh"
table=$results/warm.csv
echo "sweep,points,flat_s,warm_s,ratio,from_flat,other_minima" >"$table"

# spent WORDS...: CPU seconds of a sweep into a folder of this name, a thread for each point.
spent()
{
    rm -rf "$work/$1"
    (
        "$weft" sweep "$work/scene.knit" -q -j "$(nproc)" --into "$work/$1" $2 >/dev/null 2>&1 || say "$1: not all converged"
        times) | tail -n 1 | seconds_of >>"$work/$1.s"
}

# rows FOLDER COLUMN...: of its table.
rows()
{
    awk -F , -v names="$2 ${3:-}" '
        NR == 1 { for (i = 1; i <= NF; i++) at[$i] = i; n = split(names, name, " ") }
        NR > 1 { for (i = 1; i <= n; i++) printf "%s%s", $at[name[i]], i < n ? " " : "\n" }' "$work/$1/table.csv"
}

# chain MOTIF SWATCH SWEEP: of the library's motif, whose curvature c or thickness t is swept.
chain()
{
    cat >"$work/scene.knit" <<KNIT
use $1 from std
param c = 1 in 0..3
param t = 0.5 in 0.01..3
stitch K { kx = -c; ky = $4 }
material { thickness = t }
swatch $2
sweep $3
KNIT
    : >"$work/flat.s"
    : >"$work/warm.s"
    for run in $(seq "$BENCH_RUNS"); do
        spent flat ''
        spent warm --warm
    done
    rows flat energy.total >"$work/flat.e"
    rows warm energy.total start >"$work/warm.e"
    paste -d ' ' "$work/flat.e" "$work/warm.e" | awk -v what="\"$2; $3\"" -v flat="$(median <"$work/flat.s")" -v warm="$(median <"$work/warm.s")" '
        { off = ($2 - $1) / $1; other += off > 1e-8 || off < -1e-8; kept += $3 == "flat" }
        END { printf "%s,%d,%.2f,%.2f,%.2f,%d,%d\n", what, NR, flat, warm, flat / warm, kept, other }' >>"$table"
    say "$(tail -n 1 "$table")"
}

chain rib_2x2 'fill(rib_2x2, 20, 20)' 't in 0.3..0.6 by 0.05' c
chain rib_2x2 'fill(rib_2x2, 20, 20)' 't in [0.1, 0.2, 0.4, 0.8, 1.6]' c
chain rib_2x2 'fill(rib_2x2, 20, 20)' 't in 0.3..0.6 by 0.01' c
chain miura 'miura' 'c in 0.7..1 by 0.05' c
chain miura 'miura' 'c in 0.7..1 by 0.01' c
chain miura 'tile(miura, 2, 2)' 'c in 0.8..1 by 0.05' c
chain squiggles 'squiggles' 'c in 0.7..1.1 by 0.05' c
chain garter 'fill(garter, 20, 20)' 't in 0.3..0.6 by 0.05' c
chain seed 'fill(seed, 20, 20)' 't in 0.3..0.6 by 0.075' c
chain stockinette 'fill(stockinette, 12, 60)' 'c in 0.5..1.3 by 0.1' c
chain stockinette 'fill(stockinette, 12, 60)' 'c in [1.3, 1.2, 1.1, 1, 0.9, 0.8, 0.7, 0.6, 0.5]' c
chain stockinette 'fill(stockinette, 12, 60)' 't in 0.3..0.9 by 0.1' c
chain stockinette 'fill(stockinette, 20, 20)' 'c in 0.1..0.9 by 0.1' c
chain stockinette 'fill(stockinette, 12, 12)' 'c in 0.6..1.6 by 0.1' 1
