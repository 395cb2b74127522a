#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Words of a pattern over and over, as no pattern has them: an answer or an error, and the time it takes grows with
# the text's length, not with its square (measured: 0.1 s of processor each; with the square of it, many seconds).
. "${WEFT_SOURCE:-.}/tests/tap.sh"

cd "$work" || exit 1
bytes=100000 seconds=2
# The address sanitizer takes ten times as long.
(ulimit -v 1500000; "$WEFT" version) >/dev/null 2>&1 || seconds=20

# repeated FRAGMENT HOW: so many bytes of it.
repeated() {
    case $2 in
        blanks) yes "$1 " | tr -d '\n' ;;
        nothing) yes "$1" | tr -d '\n' ;;
        commas) yes "$1, " | tr -d '\n' ;;
        lines) yes "$1" ;;
    esac | head -c $bytes
}

# takes WHAT COMMAND...: weft ends by itself within the processor time, with an answer or an error of the script.
takes() {
    what=$1
    shift
    status=0
    (ulimit -t $seconds; exec "$WEFT" "$@") >out 2>&1 </dev/null || status=$?
    case $1:$status in
        *:0 | *:3 | fmt:1) return ;;
    esac
    echo "$what: weft $*: exit status $status: $(head -c 200 out)" >>wrong
}

# ---- words again and again, within a row and behind one ----

while read -r fragment; do
    : >wrong
    for how in blanks nothing commas lines; do
        { printf 'Cast on 4\nRow 1: '; repeated "$fragment" $how; echo; } >row.knit
        takes "$how between" check -q row.knit
    done
    { printf 'Cast on 4\nRow 1: k4\n'; repeated "$fragment" blanks; echo; } >text.knit
    takes 'behind a row' check -q text.knit
    { echo 'Cast on 4'; repeated "$fragment" blanks; echo; } >first.knit
    takes 'first' check -q first.knit
    takes 'written again' fmt --check text.knit
    empty "$fragment" wrong
done <<'END'
k2
*k2*
*
**
rep
repeat until
row 1:
rows 1, 3, 5:
Row 1 (RS): k2, p2.
1st row
first row
for 8 in
28 rows
work
work in
cont in patt
st st
purl 2 rows
cast on 4
Cast on 4 st
to last 2 sts
the rest of the row
how to knit it
k2, p2 rib.
knit the knits
same as
swatch
if
for
output "x"
|k|
1
.
;
(edge
"
then
END

# ---- lines just as long as a page may have them ----

# filled FRAGMENT BYTES: so many bytes in lines of 3,900 each.
filled() {
    yes "$1 " | tr -d '\n' | fold -w 3900 | head -c "$2"
}

while read -r fragment; do
    : >wrong
    for size in 120000 990000; do      # all turns of phrase are looked for; it is more than a page has
        { printf 'Cast on 4\nRow 1: k4\n'; filled "$fragment" $size; echo; } >page.knit
        takes "$size bytes" check -q page.knit
    done
    { echo 'Cast on 4'; filled "$fragment" 120000 | awk '{ print "Row " NR ": " $0 }'; } >rows.knit
    takes 'in rows' check -q rows.knit
    empty "$fragment, in lines of 3,900 bytes" wrong
done <<'END'
*
**
*k2*
:
.
//
a
cm
rep
work
work in
cast on 4
same as
[ ]
**1**
/1/1
rep from *
END

# ---- ten million bytes ----

# Refused within the processor time (measured: 1.0 s at most) and in less than 1.5 GB of memory.
bytes=10000000
while read -r fragment; do
    : >wrong
    for length in 12 3900 990000; do
        case $length in
            12) yes "$fragment $fragment" | head -c $bytes ;;
            *) yes "$fragment " | tr -d '\n' | fold -b -w $length | head -c $bytes ;;
        esac >x.knit
        (ulimit -t $seconds; [ $seconds -gt 2 ] || ulimit -v 1500000; exec "$WEFT" check x.knit) >out 2>&1 </dev/null
        [ $? = 3 ] || echo "in lines of $length: $(head -c 200 out)" >>wrong
    done
    yes "$fragment" | head -c $bytes >x.knit
    (ulimit -t $seconds; [ $seconds -gt 2 ] || ulimit -v 1500000; exec "$WEFT" fmt x.knit) >out 2>&1 </dev/null
    [ $? = 3 ] || echo "to be formatted: $(head -c 200 out)" >>wrong
    empty "ten million bytes of $fragment" wrong
done <<'END'
st st
work in
k2
repeat
row
*
until
Row 1: [x](y)
Row 1: k2
“
&
<b>
END

# ---- one long word ----

# long NAME CHARACTER: as a name, a number, a gap in every register of the language.
long() {
    word=$(head -c 20000 /dev/zero | tr '\000' "$2")
    : >wrong
    for around in '@' 'Row 1: @' 'Row 1: k@' 'Row @: k4' 'Cast on @ sts' 'Cast on 4 sts@ and' 'Rep row @ times' 'let a = @' 'let @ = 1' '# @' 'use @ from std' \
        'motif m { chart { @ } }' 'output "@.svg"' 'Materials: @' 'Row 1: *k2@ rep from *' 'Row 1: (k1@) twice' 'Work in@garter' 'for i in @ {' 'gauge { @ }'; do
        printf 'Cast on 4\n%s\nRow 2: k4\n' "${around%@*}$word${around#*@}" >x.knit
        takes "$around" check -q x.knit
    done
    empty "20,000 times $1" wrong
}
long 'a letter' x
long 'a figure' 1
long 'a blank' ' '
long 'a star' '*'
long 'a bracket' '('
long 'an underscore' _

finish
