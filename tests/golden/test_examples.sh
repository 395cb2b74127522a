#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Every example compiles without a message, to the size it promises.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
. "$WEFT_SOURCE/tests/golden/dump.sh"

# example NAME 'COLUMNS x ROWS'
example() {
    exits 0 "$1 compiles" "$dump" --size "$WEFT_SOURCE/examples/$1.knit"
    same "$1 is $2" "$2"
    exits 0 "$1 has settings" "$dump" --settings "$WEFT_SOURCE/examples/$1.knit"
    check "$1 writes a surface and a report" sh -c "grep -q '^output pvd' '$work/out' && grep -q '^output report' '$work/out'"
    echo "$1.knit" >>"$work/seen"
}
# setting NAME VALUE
setting() {
    check "... with $1 = $2" grep -q "^$1 = $2 " "$work/out"
}

example miura '48 x 92'
setting thickness 0.5
setting young 1
setting poisson 0.4
setting width 1.4
setting height 1.2
setting stiffness 0
setting steps 10
example chains '48 x 36'
setting stiffness 0.0001
example columns '66 x 58'
setting stiffness 0.0001
example peaks '80 x 79'
setting stiffness 0
example squiggles '48 x 40'
setting stiffness 0
example bars '64 x 40'
setting stiffness 0.0001
example weave '96 x 72'
setting stiffness 0.0001
example rib '22 x 20'
example seed '16 x 20'
example stockinette '12 x 12'
example flag '30 x 32'
example own_stitch '12 x 12'

ls "$WEFT_SOURCE/examples" | grep '\.knit$' | sort >"$work/all"
sort -o "$work/seen" "$work/seen"
check 'every example is here' diff "$work/all" "$work/seen"

exits 3 'a param has its range' "$dump" -D half=20 "$WEFT_SOURCE/examples/miura.knit"
exits 0 'and can be set' "$dump" --size -D half=3 "$WEFT_SOURCE/examples/miura.knit"
same 'which changes the fabric' '24 x 44'

finish
