#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The motifs of Fig. 3 at reduced tiling, free and with the paper's springs, each
# folded from five seeds; a table for the manual on standard output.
# motifs.sh [MOTIF...]: these alone.
: "${WEFT:=$PWD/weft}"
LC_ALL=C
export LC_ALL
work=$(mktemp -d)
trap 'rm -rf "$work"' EXIT

# row MOTIF COLUMNS ROWS STIFFNESS
row() {
    cat >"$work/x.knit" <<KNIT
use $1 from std
swatch tile($1, $2, $3)
mesh { per_stitch = 1 }
springs { stiffness = $4; edges = all }
KNIT
    status=0
    timeout 900 "$WEFT" run "$work/x.knit" --seeds 5 >"$work/out" 2>/dev/null || status=$?
    awk -v name="$1" -v tiles="$2 x $3" -v stiffness="$4" -v exit_status=$status '
        /^seed / { n++; energy = $4 + 0; status[$5]++; if (n == 1 || energy < low) low = energy; if (n == 1 || energy > high) high = energy
                   if (!(energy in seen)) seen[energy] = 1 }
        / s$/ { seconds = $1 }
        END {
            for (s in status) ends = ends (ends ? ", " : "") status[s] " " s
            if (n < 5) ends = "ended with " exit_status
            printf "| %s | %s | %s | %.9g | %.2g | %s | %s |\n", name, tiles, stiffness, low, low ? (high - low) / low : 0, ends, seconds
        }' "$work/out"
}

echo '| motif | tiles | springs | lowest energy | largest difference | ends of five seeds | seconds, all |'
echo '|---|---|---|---|---|---|---|'
for motif in ${*:-miura chains squiggles bars weave columns peaks}; do
    case $motif in
    chains) tiles='3 3' ;;
    squiggles) tiles='1 2' ;;
    *) tiles='1 1' ;;
    esac
    for stiffness in 0 1e-4; do
        # shellcheck disable=SC2086
        row "$motif" $tiles $stiffness
    done
done
