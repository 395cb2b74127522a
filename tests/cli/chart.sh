#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# weft chart: which way up, and what happens when it cannot be printed.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

# A motif that equals none of its mirror, upside-down and inverse images.
cat >"$work/flag.knit" <<'KNIT'
motif flag {
  chart (x = P, o = K) {
    o o o x   3
    o o x x   2
    o x x x   1
  }
}
swatch flag
output "unused.txt"
KNIT

exits 0 'text chart' "$WEFT" chart "$work/flag.knit"
check 'top row first, odd numbers at the right' diff - "$work/out" <<'TEXT'
  k k k p  3
2 k k p p
  k p p p  1
TEXT

exits 0 'grid' "$WEFT" chart --grid "$work/flag.knit"
printf '# 1 1\nK P P P\nK K P P\nK K K P\n' >"$work/grid"
check 'bottom row first' diff "$work/grid" "$work/out"

exits 0 'grid to a file' "$WEFT" chart "$work/flag.knit" -o "$work/x.txt" -o "chart:$work/y.txt"
empty 'prints nothing' "$work/out"
check 'the file is the grid' diff "$work/grid" "$work/x.txt"
check 'with a kind, too' diff "$work/grid" "$work/y.txt"
check "the script's own outputs are not written" test ! -e unused.txt

exits 4 'a folder that is not there' "$WEFT" chart "$work/flag.knit" -o "$work/none/x.txt"
err 'is named' "there is no folder '.*none'"

# Drawings.
exits 0 'drawn' "$WEFT" chart "$work/flag.knit" -o "$work/x.svg" -o "$work/x.pdf" -o chart:"$work/x.PNG"
check 'svg' grep -q '^<svg' "$work/x.svg"
check 'pdf' grep -aq '^%PDF-' "$work/x.pdf"
check 'png' grep -aq 'PNG' "$work/x.PNG"
exits 0 'again' "$WEFT" chart "$work/flag.knit" -o "$work/y.svg" -o "$work/y.pdf" -o "$work/y.PNG"
for kind in svg pdf PNG; do
    check "$kind has the same bytes" cmp "$work/x.$kind" "$work/y.$kind"
done
exits 2 'a kind of drawing that is not there' "$WEFT" chart "$work/flag.knit" -o "$work/x.gif"
err 'is told from those that are' 'written as .svg, .pdf, .png, .txt'
echo 'swatch each (x, y) in 2 by 20000 : x * y mod 7 < 2 ? K : P' >"$work/tall.knit"
exits 3 'more pixels than a PNG may have' "$WEFT" chart "$work/tall.knit" -o "$work/tall.png"
err 'are refused' "tall.knit: .*tall.png': a PNG has at most 30000 pixels"
check 'and nothing is written' test ! -e "$work/tall.png"

printf 'Cast on 4 sts\nRounds 1-3: k3, p1\n' >"$work/round.knit"
exits 0 'rounds' "$WEFT" chart "$work/round.knit"
check 'have their numbers at the right' diff - "$work/out" <<'TEXT'
 p k k k  3
 p k k k  2
 p k k k  1
TEXT

printf 'Cast on 4\nRow 1 (WS): k2, p2\nRow 2: k1, p3\nRow 3: knit\n' >"$work/ws.knit"
exits 0 'a first row from the wrong side' "$WEFT" chart "$work/ws.knit"
check 'has its number at the left' diff - "$work/out" <<'TEXT'
3 p p p p
  p p p k  2
1 p p k k
TEXT
exits 0 'and is written' "$WEFT" write "$work/ws.knit"
out 'as such' '^Row 1 (WS): k2, p2\.'
cp "$work/out" "$work/written.knit"
exits 0 'and read again' "$WEFT" chart --grid "$work/written.knit"
printf '# 1 1\nP P K K\nP P P K\nP P P P\n' >"$work/grid"
check 'the same fabric' diff "$work/grid" "$work/out"

# Blanks between letters as long as a terminal's 80 columns hold the numbers, too.
for width in 38 39; do
    echo "swatch each (x, y) in $width by 2 : x == 0 || y == 1 && x == 1 ? P : K" >"$work/wide.knit"
    exits 0 "$width stitches" "$WEFT" chart "$work/wide.knit"
    cp "$work/out" "$work/out.$width"
done
check 'are 80 columns' test "$(awk 'length($0) > n { n = length($0) } END { print n }' "$work/out.38")" = 80
out '39 have no blanks' '^2 ppk\{37\}$'
out 'and their numbers as before' '^  pk\{38\}  1$'
printf 'stitch T { symbol = "tt" }\nswatch tile(T, 30, 1)\n' >"$work/wide.knit"
exits 0 'symbols of several characters' "$WEFT" chart "$work/wide.knit"
out 'keep their blanks' '^  tt tt tt '

exits 2 'a kind that no chart is of' "$WEFT" chart "$work/flag.knit" -o "report:$work/x.svg"
err 'is named' "not as 'report:"

if [ -w /dev/full ]; then
    exits 4 'a full disk' sh -c '"$1" chart "$2" >/dev/full' - "$WEFT" "$work/flag.knit"
    err 'is said' 'standard output: No space left'
    exits 4 'a full disk, for the other commands' sh -c '"$1" help >/dev/full' - "$WEFT"
    err 'is said by them, too' 'standard output: No space left'
else
    skip 'a full disk' 'no /dev/full'
fi
exits 4 'no standard output' sh -c '"$1" chart "$2" >&-' - "$WEFT" "$work/flag.knit"
exits 0 'no standard error' sh -c '"$1" chart "$2" 2>&-' - "$WEFT" "$work/flag.knit"

# A reader that goes away early gets its line; weft ends quietly with status 4.
echo "swatch tile(K, 900, 900)" >"$work/large.knit"
check 'a pipe cut short' sh -c '{ "$1" chart "$2" 2>"$3/err"; echo $? >"$3/status"; } | head -n 1 >"$3/out"' - \
    "$WEFT" "$work/large.knit" "$work"
check 'gives its first line' test "$(wc -l <"$work/out")" = 1
check 'ends with status 4' test "$(cat "$work/status")" = 4
empty 'without a message' "$work/err"

finish
