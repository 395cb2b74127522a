#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Knitout: what weft writes runs on a machine that is not weft's and knits the
# chart; what others write is read, and refused where it is not plain.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
. "$WEFT_SOURCE/tests/charts/grids.sh"
machine=$PWD/tests/charts/machine

# ---- out ----

"$WEFT" import "$work/flag.txt" >"$work/flag.knit"
exits 0 'the flag' "$WEFT" chart "$work/flag.knit" -o "$work/flag.k"
check 'is knitted bottom row first, and moves two stitches' diff - "$work/flag.k" <<'TEXT'
;!knitout-2
;;Carriers: 1 2 3 4 5 6 7 8 9 10

; cast on 4
inhook 1
tuck - b3 1
tuck - f1 1
tuck + b2 1
tuck + b4 1

; row 1
knit - b4 1
knit - b3 1
knit - b2 1
knit - f1 1
releasehook 1

; row 2
xfer b2 f2
knit + f1 1
knit + f2 1
knit + b3 1
knit + b4 1

; row 3
xfer b3 f3
knit - b4 1
knit - f3 1
knit - f2 1
knit - f1 1

; off the machine
outhook 1
drop f1
drop f2
drop f3
drop b4
TEXT
printf 'motif flag { chart { kp } }\nswatch flag\noutput chart "%s/run.k"\nsolve { steps = 1 }\n' "$work" >"$work/run.knit"
exits 0 'as an output of a run' "$WEFT" "$work/run.knit"
check 'is knitout' grep -q '^knit - b2 1$' "$work/run.k"
printf 'swatch tile(P, 3, 1)\n' >"$work/three.knit"
cat >"$work/cast" <<'TEXT'
tuck - b3 1
tuck - b1 1
tuck + b2 1
miss + b3 1

; row 1
knit - b3 1
TEXT
exits 0 'an odd number of stitches' "$WEFT" chart "$work/three.knit" -o "$work/three.k"
check 'is cast on with a step past the last' sh -c \
    'sed -n "/^tuck/,/^knit/p" "$1/three.k" | diff - "$1/cast"' - "$work"
printf 'stitch T { kx = 1 }\nswatch tile(T, 2, 2)\n' >"$work/own.knit"
exits 3 'a stitch of the script itself' "$WEFT" chart "$work/own.knit" -o "$work/own.k"
err 'is not one of a machine' 'the stitch T is neither knit nor purl'
check 'and leaves no file' test ! -e "$work/own.k"

# The machine itself: it refuses what cannot be.
stops() {
    sed "$2" "$work/flag.k" >"$work/bad.k"
    check "the machine stops: $1" sh -c '! "$1" <"$2" >/dev/null 2>&1' - "$machine" "$work/bad.k"
}
check 'the machine runs the flag' sh -c '"$1" <"$2/flag.k" | diff "$2/flag.txt" -' - "$machine" "$work"
stops 'a needle is empty' 's/^knit - f3/knit - b3/'
stops 'a transfer from an empty needle' 's/^xfer b3 f3/xfer f3 b3/'
stops 'a loop stays' '/^drop f1/d'
stops 'a stitch is left out' '/^knit + f2/d'
stops 'the yarn stays' '/^outhook/d'
stops 'the yarn was never in' '/^inhook/d'
stops 'the header is missing' '/^;;/d'
stops 'the wrong way' 's/^knit + /knit - /'

# ---- there and back, by way of the machine ----

# back FILE: the machine knits the script's chart with as many transfers as
# stitches differ from those below, and weft reads it back.
back() {
    "$WEFT" chart -q --grid "$1" >"$work/wanted"
    "$WEFT" chart -q "$1" -o "$work/x.k" && "$machine" <"$work/x.k" >"$work/knitted" 2>"$work/moves" &&
        cmp "$work/wanted" "$work/knitted" &&
        awk 'NR > 1 { for (i = 1; i <= NF; i++) { n += NR > 2 && $i != below[i]; below[i] = $i } }
             END { print "transfers", n + 0 }' "$work/wanted" | cmp - "$work/moves" &&
        "$WEFT" import -q "$work/x.k" >"$work/x.knit" && "$WEFT" chart --grid "$work/x.knit" | cmp "$work/wanted" -
}
all_back 30

# ---- in ----

# reads NAME TEXT: lines separated by |, behind the two first; the grid is standard input.
reads() {
    cat >"$work/wanted"
    printf ';!knitout-2\n;;Carriers: 1 2 3\n%s\n' "$2" | tr '|' '\n' >"$work/y.k"
    exits 0 "$1" sh -c '"$1" import "$2/y.k" >"$2/y.knit" && "$1" chart --grid "$2/y.knit" 2>/dev/null' - "$WEFT" "$work"
    check 'shows' diff "$work/wanted" "$work/out"
}
two='in 1|tuck - f2 1|tuck + f1 1'
rows='knit - f2 1|knit - f1 1|xfer f1 b1|knit + b1 1|knit + f2 1'
grid='# 1 1
K K
P K'
reads 'a row to the left, one to the right' "$two|$rows|out 1" <<TEXT
$grid
TEXT
err 'what was taken for what is said' 'y.k: the front bed is taken as knit, the back bed as purl; rows from line 6 to line 10$'
check 'and stands in the script' grep '^# the front bed is taken as knit, the back bed as purl; rows from line 6' "$work/y.knit"
reads 'knits on empty needles as a cast-on, comments, extensions, a hook, settings of the machine' \
    "x-stitch-number 61|inhook 1 ; in|knit - f2 1|knit + f1 1; on|stitch 1 -2.5|rack 0|$rows|releasehook 1|;;Gauge: 15|pause stop|outhook 1" <<TEXT
$grid
TEXT
reads 'extensions of several kinds, one of them twice' "x-speed-number 9|$two|x-vendor|$rows|x-speed-number 10|out 1" <<TEXT
$grid
TEXT
check 'are named, each once' test "$(grep -c 'warning: the extension .* is not read \[W0910\]' "$work/err")" = 2
err 'with their code' 'the extension .x-vendor. is not read .*W0910'
err 'with the lines they stand on' '^note: it stands on 2 lines'
err 'at the first of them' "y.k:3:1: warning: the extension 'x-speed-number'"
reads 'needles with gaps and below nothing' \
    'in 3|tuck + f-5 3|tuck + f-3 3|tuck + f7 3|knit - f7 3|knit - f-3 3|knit - f-5 3|xfer f-5 b-5|knit + b-5 3|knit + f-3 3|knit + f7 3' <<'TEXT'
# 1 1
K K K
P K K
TEXT
reads 'a cast-on of both beds with a turn before its end' \
    'in 1|tuck - f2 1|tuck - b1 1|knit + f2 1|knit - f2 1|knit - b1 1|knit + b1 1|knit + f2 1' <<'TEXT'
# 1 1
P K
P K
TEXT
three='in 1|tuck - f3 1|tuck - f1 1|tuck + f2 1|knit - f3 1|knit - f2 1|knit - f1 1'
reads 'a bind-off that draws each stitch through the next' \
    "$three|knit + f1 1|xfer f1 b1|rack 1|xfer b1 f2|rack 0|knit + f2 1|xfer f2 b2|rack 1|xfer b2 f3|rack 0|knit + f3 1|tuck - f3 1|drop f3" <<'TEXT'
# 1 1
K K K
TEXT
err 'is said' 'rows from line 7 to line 9, bound off behind them$'
reads 'one that begins with the last stitch knitted, of six' "in 1|$(for i in 6 4 2; do printf 'tuck - f%d 1|' $i; done
    )$(for i in 1 3 5; do printf 'tuck + f%d 1|' $i; done)miss + f6 1$(for i in 6 5 4 3 2 1; do printf '|knit - f%d 1' $i; done
    )$(for i in 1 2 3 4 5; do printf '|xfer f%d b%d|rack 1|xfer b%d f%d|rack 0|knit + f%d 1' $i $i $i $((i + 1)) $((i + 1)); done
    )|out 1|drop f6" <<'TEXT'
# 1 1
K K K K K K
TEXT
err 'is said, too' 'bound off behind them$'
reads 'drops in any wording, and stitches left on the needles' "$three|knit + f1|drop f2" <<'TEXT'
# 1 1
K K K
TEXT
check 'by another name and by standard input' sh -c 'cp "$2/flag.k" "$2/flag.dat"
    "$1" import -q "$2/flag.dat" | "$1" chart --grid - | diff "$2/flag.txt" - &&
    "$1" import -q - <"$2/flag.k" | "$1" chart --grid - | diff "$2/flag.txt" -' - "$WEFT" "$work"

# ---- what is wrong ----

# wrong NAME TEXT: lines as above; the messages are standard input.
wrong() {
    printf ';!knitout-2\n;;Carriers: 1 2 3\n%s\n' "$2" | tr '|' '\n' >"$work/w.k"
    refused "$1" w.k
}
wrong 'a short row' "$three|knit + f1 1|knit + f2 1|knit - f2 1|knit - f1 1|knit + f1 1" <<'TEXT'
w.k:11:1: error: this row works 2 of 3 stitches; short rows and slipped stitches are not plain knit and purl [E0810]
  11 | knit + f2 1
     | ^~~~~~~~~~~
TEXT
wrong 'a cable' "$three|xfer f1 b1|rack 1|xfer b1 f2|rack 0|knit + f2 1|knit + f3 1" <<'TEXT'
w.k:12:1: error: a transfer while the beds are racked moves a stitch aside: cables and lace are not plain [E0810]
  12 | xfer b1 f2
     | ^~~~~~~~~~
TEXT
wrong 'a new stitch at the edge' "$three|knit + f1 1|knit + f2 1|knit + f3 1|knit - f4 1" <<'TEXT'
w.k:13:8: error: needle f4 holds no stitch: a new one would be an increase [E0810]
  13 | knit - f4 1
     |        ^~
TEXT
wrong 'stitches dropped within' "$three|drop f2|knit + f1 1|knit + f3 1" <<'TEXT'
w.k:11:1: error: stitches were dropped before this one; a plain fabric keeps all of them to its last row [E0810]
  11 | knit + f1 1
     | ^~~~~~~~~~~
TEXT
wrong 'an increase' "$three|split + f1 b1 1|knit + f2 1|knit + f3 1" <<'TEXT'
w.k:10:1: error: a split makes two stitches of one: an increase is not plain knit and purl [E0810]
  10 | split + f1 b1 1
     | ^~~~~~~~~~~~~~~
TEXT
wrong 'a tuck' "$three|tuck + f1 1|knit + f2 1|knit + f3 1|knit - f3 1|knit - f2 1|knit - f1 1" <<'TEXT'
w.k:10:1: error: a tuck puts a second loop on a needle; that is not plain knit and purl [E0810]
  10 | tuck + f1 1
     | ^~~~~~~~~~~
TEXT
wrong 'two colours' "$three|in 2|knit + f1 2|knit + f2 2|knit + f3 2" <<'TEXT'
w.k:11:11: error: a second carrier, '2': another yarn is another colour [E0810]
  11 | knit + f1 2
     |           ^
TEXT
wrong 'two yarns at once' 'in 1 2|tuck - f2 1 2' <<'TEXT'
w.k:4:11: error: several carriers in one stitch are several colours [E0810]
   4 | tuck - f2 1 2
     |           ^~~
TEXT
wrong 'a tube' 'in 1|tuck - f2 1|tuck - f1 1|tuck + b1 1|tuck + b2 1|knit - f2 1|knit - f1 1|knit + b1 1|knit + b2 1' <<'TEXT'
w.k:11:1: error: 2 needles of the front bed and those that face them both hold stitches: a tube or a double fabric is not one sheet of knit and purl [E0810]
  11 | knit + b2 1
     | ^~~~~~~~~~~
TEXT
wrong 'racked beds' "$three|rack 0.25|knit + f1 1|knit + f2 1|knit + f3 1" <<'TEXT'
w.k:11:1: error: the beds are racked by 0.25 here; a plain fabric is knitted unracked [E0810]
  11 | knit + f1 1
     | ^~~~~~~~~~~
TEXT
wrong 'the same direction twice' "$three|knit - f3 1|knit - f2 1|knit - f1 1" <<'TEXT'
w.k:10:1: error: this row goes in the direction of the one below; plain rows take turns [E0810]
  10 | knit - f3 1
     | ^~~~~~~~~~~
TEXT
wrong 'a file cut short' "$three|knit + f1 1|knit + f2" <<'TEXT'
w.k:10:1: error: this row works 1 of 3 stitches; short rows and slipped stitches are not plain knit and purl [E0810]
  10 | knit + f1 1
     | ^~~~~~~~~~~
TEXT
wrong 'a needle that does not face' "$three|xfer f1 b2" <<'TEXT'
w.k:10:1: error: f1 does not face b2 [E0809]
  10 | xfer f1 b2
     | ^~~~~~~~~~
TEXT
wrong 'a transfer within a bed' "$three|xfer f1 f1" <<'TEXT'
w.k:10:1: error: f1 does not face f1 [E0809]
  10 | xfer f1 f1
     | ^~~~~~~~~~
TEXT
wrong 'a word that is no operation' "$three|knot + f1 1" <<'TEXT'
w.k:10:1: error: 'knot' is no operation of knitout [E0809]
  10 | knot + f1 1
     | ^~~~
hint: did you mean 'knit'?
TEXT
wrong 'a needle that is none' 'in 1|tuck - f99999999999999999999 1' <<'TEXT'
w.k:4:8: error: a needle is wanted here: f or b and its number, to 1000000 [E0809]
   4 | tuck - f99999999999999999999 1
     |        ^~~~~~~~~~~~~~~~~~~~~
TEXT
wrong 'a slider' 'in 1|tuck - fs2 1' <<'TEXT'
w.k:4:8: error: sliders are not needed for plain knit and purl [E0810]
   4 | tuck - fs2 1
     |        ^~~
TEXT
wrong 'a yarn that is not in' 'tuck - f2 1' <<'TEXT'
w.k:3:11: error: the carrier '1' was not brought in [E0809]
   3 | tuck - f2 1
     |           ^
TEXT
wrong 'a carrier without a name' 'in 7' <<'TEXT'
w.k:3:4: error: the header does not name a carrier '7' [E0809]
   3 | in 7
     |    ^
TEXT
wrong 'too few words' 'in 1|knit +' <<'TEXT'
w.k:4:1: error: knit has too few words behind it [E0809]
   4 | knit +
     | ^~~~~~
TEXT
wrong 'too many words' 'in 1|drop f1 f2' <<'TEXT'
w.k:4:1: error: drop has too many words behind it [E0809]
   4 | drop f1 f2
     | ^~~~~~~~~~
TEXT
wrong 'a yarn brought in twice' 'in 1|in 1' <<'TEXT'
w.k:4:4: error: the carrier '1' is in already [E0809]
   4 | in 1
     |    ^
TEXT
wrong 'a yarn taken out that is out' 'out 2' <<'TEXT'
w.k:3:5: error: the carrier '2' is out already [E0809]
   3 | out 2
     |     ^
TEXT
wrong 'a header without a colon' ';;Gauge 15' <<'TEXT'
w.k:3:1: error: a header is a name, a colon and a value: `;;Carriers: 1 2 3` [E0805]
   3 | ;;Gauge 15
     | ^~~~~~~~~~
TEXT
wrong 'no stitch' 'in 1|out 1' <<'TEXT'
w.k:1:1: error: there is no stitch in this file [E0806]
   1 | ;!knitout-2
     | ^
TEXT
for first in '' ';!knitout' ';!knitout-x' 'knit'; do
    printf '%s\n;;Carriers: 1\n' "$first" >"$work/w.k"
    exits 3 "the first line '$first'" "$WEFT" import "$work/w.k"
    err 'is refused' 'w.k:1:1: error: a knitout file begins with the line `;!knitout-2`.*E0809'
done
printf ';!knitout-2\nin 1\n' >"$work/w.k"
exits 3 'no header' "$WEFT" import "$work/w.k"
err 'is refused' 'w.k:2:1: error: the header `;;Carriers: ..` is missing above this.*E0805'
sed 's/knitout-2/knitout-3/' "$work/flag.k" >"$work/newer.k"
exits 0 'a later version' "$WEFT" import "$work/newer.k"
err 'is read with a warning' 'newer.k:1:1: warning: .*W0903'

finish
