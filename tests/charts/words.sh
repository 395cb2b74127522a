#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Written rows from a page, by way of weft import: the words stay, nothing is added silently.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

# reads NAME TEXT: lines separated by |; the grid is standard input.
reads() {
    cat >"$work/wanted"
    printf '%s\n' "$2" | tr '|' '\n' >"$work/x.txt"
    exits 0 "$1" sh -c '"$1" import "$2/x.txt" >"$2/x.knit" && "$1" chart --grid "$2/x.knit" 2>"$2/chart.err"' - "$WEFT" "$work"
    check 'shows' diff "$work/wanted" "$work/out"
}

reads 'rows without a cast-on' 'Rows 1 and 3 (RS): *k2, p2, repeat from * to last 2 sts, k2.|Rows 2 and 4 (WS): *p2, k2, repeat from * to last 2 sts, p2.' <<'TEXT'
# 1 1
K K P P K K
K K P P K K
K K P P K K
K K P P K K
TEXT
err 'the width is said' '^weft: .*x.txt: how many stitches to cast on is not said; 6 is the least the rows fit$'
check 'and stands in the script, the words as they were' diff - "$work/x.knit" <<'TEXT'
# Written rows, from x.txt: 6 stitches x 4 rows
# how many stitches to cast on is not said; 6 is the least the rows fit
Cast on 6 sts.
Rows 1 and 3 (RS): *k2, p2, repeat from * to last 2 sts, k2.
Rows 2 and 4 (WS): *p2, k2, repeat from * to last 2 sts, p2.
TEXT
reads 'a width of their own' 'Row 1 (RS): k1, p1.|Row 2 (WS) and all even rows: Purl.|Row 3: *p1, k1; repeat from *.' <<'TEXT'
# 1 1
P K
K K
K P
K K
TEXT
empty 'nothing needs saying' "$work/err"
reads 'a cast-on of their own' 'Cast on 5 sts.|1st row: K1, *p1, k1; rep from *.|2nd row: *K1, p1; rep from * to last st, k1.' <<'TEXT'
# 1 1
K P K P K
P K P K P
TEXT
empty 'nothing needs saying' "$work/err"
check 'only a comment is added' sh -c 'sed 1d "$1/x.knit" | diff "$1/x.txt" -' - "$work"
reads 'rounds, work from *, tails of other lengths' 'Rnds 1 and 2: *k1, p1; work from *.|Rnd 3: Knit.' <<'TEXT'
# 1 1
P K
P K
K K
TEXT
reads 'brackets and what is left' 'Row 1: k1, [p2, k1] to last st, p1.|Row 2: k1, p to last 2 sts, k2.|Rep rows 1 and 2 once more.' <<'TEXT'
# 1 1
P K P P K
P K K P P
P K P P K
P K K P P
TEXT
printf '\357\273\277Row 1: *k1, p1; rep from *\r\nRow 2: purl' >"$work/y.ks"
exits 0 'line ends of two bytes, a byte order mark' "$WEFT" import "$work/y.ks"
check 'are gone' diff - "$work/out" <<'TEXT'
# Written rows, from y.ks: 2 stitches x 2 rows
# how many stitches to cast on is not said; 2 is the least the rows fit
Cast on 2 sts.
Row 1: *k1, p1; rep from *
Row 2: purl
TEXT

# wrong NAME TEXT CODE PATTERN
wrong() {
    printf '%s\n' "$2" | tr '|' '\n' >"$work/w.txt"
    exits 3 "$1" sh -c 'cd "$2" && "$1" import w.txt' - "$WEFT" "$work"
    err 'is shown at its place' "$3"
    empty 'nothing comes out' "$work/out"
}
wrong 'lace' 'Row 1 (RS): k1, *yo, k2tog; repeat from *, k1.' '^w.txt:1:18: error: .yo. (an increase).*E0302'
wrong 'rows that do not go together' 'Row 1: *k2, p2; rep from *|Row 2: *k2, p2; rep from * to last st, k1' '^w.txt:2:[0-9]*: error: .*E03'
wrong 'a row that is missing' 'Row 1: *k2, p2; rep from *|Row 4: purl' '^w.txt:2:1: error: .*E0306'

finish
