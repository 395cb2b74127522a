#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Hard input: a message of its own for each limit, in little time and memory.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

# Its threads would ask for memory beyond a limit without end.
export OPENBLAS_NUM_THREADS=1
. "$WEFT_SOURCE/tests/golden/dump.sh"

# make AWK-PROGRAM: writes the script.
make() {
    awk "BEGIN { $1 }" >"$work/x.knit"
}

# limit CODE NAME: the script made before is refused with this code, within $room kilobytes if that is set.
limit() {
    status=0
    (
        sanitized "$dump" || ulimit -t "${seconds-20}"
        [ -z "${room-}" ] || ulimit -v "$room"
        exec "$dump" --size "$work/x.knit" >"$work/out" 2>&1
    ) || status=$?
    if [ $status = 3 ] && grep -q "\[$1\]" "$work/out"; then
        pass "$1: $2"
    else
        fail "$1: $2 (exit status $status)"
        head -c 2000 "$work/out" | sed 's/^/# /'
    fi
}

make 'for (i = 0; i < 7000000; i++) print "# line of ten"'
limit E0701 'a file of 91 MB'
make 'for (i = 0; i < 1000000; i++) printf "xxxxxxxxxx"; print ""'
limit E0702 'a line of 10 MB'
make 'printf "let a = "; for (i = 0; i < 100000; i++) printf "("; print 1'
limit E0703 'brackets'
make 'printf "let a = "; for (i = 0; i < 100000; i++) printf "-"; print 1'
limit E0703 'signs'
make 'printf "let a = "; for (i = 0; i < 100000; i++) printf "1 ? "; print 1'
limit E0703 'choices'
make 'printf "Row 1: "; for (i = 0; i < 5000; i++) printf "("; printf "k1"; for (i = 0; i < 5000; i++) printf ") 2 times"; print ""'
limit E0703 'groups of stitches'
make 'for (i = 0; i < 300; i++) printf "motif a {"; print ""'
limit E0703 'blocks'
make 'for (i = 0; i < 20000; i++) printf "if 1 { } else "; print "{ }"'
limit E0703 'else if'
make 'printf "let a = "; for (i = 0; i < 200000; i++) printf "1+"; print 1'
limit E0704 'a sum of 200000 terms'
make 'print "let a0 = 1"; for (i = 1; i < 9000; i++) printf "let a%d = a%d\n", i, i - 1; print "swatch tile(K, a8999, 1)"'
limit E0705 'definitions in a chain'
make 'print "motif f(n) = f(n + 1)"; print "swatch f(1)"'
limit E0705 'a motif that uses itself'
i=1
while [ $i -le 20 ]; do
    echo "use \"$((i + 1)).txt\"" >"$work/$i.txt"
    i=$((i + 1))
done
echo 'use "1.txt"' >"$work/x.knit"
limit E0706 'files that use files'
make 'print "swatch tile(K, 2000, 2001)"'
limit E0707 'a large fabric'
make 'print "Cast on 5\nRow 1: k1, (k1) x 99999999"'
limit E0204 'x 99999999'
make 'print "Cast on 4000000\nRow 1: knit\nRow 2: purl"'
limit E0707 'a wide fabric'
make 'print "Row 1: "; for (i = 0; i < 9; i++) printf "("; printf "k1"; for (i = 0; i < 9; i++) printf ") x 999999"; print ""'
limit E0707 'repeats of repeats'
make 'print "Cast on 2\nRow 1: k2\nRow 2: p2\nRepeat rows 1-2 999999 times"'
limit E0708 'many rows'
make 'print "for j in 1..11 { for i in 1..10000 { Row {i + 10000 * (j - 1)}: k1 } }"'
limit E0708 'many written rows'
make 'print "Cast on 1000"; for (i = 1; i < 1002; i++) { printf "Row %d: ", i; for (j = 0; j < 500; j++) printf "k1, p1, "; print "" }'
limit E0708 'more than a million stitches one by one'
make 'print "motif m { Row 100001: k1 }\nswatch m"'
limit E0204 'a high row number'
make 'print "swatch each (x, y) in 2000 by 2000 : (x * x + y * y) mod 7 < 3 && (x + y) mod 5 > 1 ? P : K"'
limit E0709 'a long calculation'
make 'for (i = 0; i < 20000; i++) printf "let a%d = 1\n", i'
limit E0710 'many names'
make 'printf "let "; for (i = 0; i < 3000; i++) printf "q"; print " = 1"'
limit E0710 'a long name'
make 'print "motif m { for i in 1..1000000 { Row {i}: k2 } }\nswatch m"'
limit E0711 'a long range'
make 'print "param a = 1\nparam b = 1\nswatch K\nsweep a in 1..2000, b in 1..2000"'
limit E0711 'a large sweep'
make 'for (i = 0; i < 300; i++) printf "stitch s%d { kx = 1 }\n", i; print "swatch K"'
limit E0712 'many kinds of stitches'
make 'print "swatch K"; for (i = 0; i < 200; i++) printf "output \"%d.obj\"\n", i'
limit E0713 'many outputs'
make 'printf "let a = "; for (i = 0; i < 5000; i++) printf "9"; print ""'
limit E0104 'a long number'
make 'for (i = 0; i < 100000; i++) print "}"'
limit E0108 'braces that close nothing'
make 'printf "let a = ("; for (i = 0; i < 300000; i++) print "# comment"'
limit E0101 'a bracket before many lines'

make 'for (i = 0; i < 150000; i++) printf "("; for (i = 0; i < 300000; i++) printf "(k"; print ""'
limit E0107 'brackets of a rib that never end'

# What is within the limits is done, and quickly enough.
large() {
    make "$1"
    exits 0 "$2" "$dump" --size "$work/x.knit"
    same "$2: its size" "$3"
}
large 'print "swatch tile(K, 2000, 2000)"' 'four million stitches' '2000 x 2000'
large 'print "Cast on 4\nRow 1: k4\nRow 2: p4\nRepeat rows 1-2 499999 times"' 'a million rows' '4 x 1000000'
large 'print "Cast on 1000000\nRow 1: *k1, p1; rep from *"' 'a million stitches in a row' '1000000 x 1'
large 'print "swatch each (x, y) in 1000 by 1000 : (x + y) mod 12 < 6 ? P : K"' 'a formula for a million stitches' '1000 x 1000'
large 'printf "Cast on 200000\nRow 1: "; for (i = 0; i < 100000; i++) printf "k1, p1, "; print ""' 'a row of a million letters' '200000 x 1'

# 32 bytes of memory for each of a million stitches, and what a single one needs.
within() {
    limit=$1
    shift
    sh -c "ulimit -v $limit && exec \"\$@\"" sh "$@"
}
lean() {
    make "$1"
    exits 0 "$2: 32 bytes for each of a million stitches" within $((base + 31250)) "$dump" --size "$work/x.knit"
}
if sanitized "$dump"; then
    skip 'memory for a million stitches' 'built with the address sanitizer'
else
    make 'print "swatch K"'
    base=1024
    until within $base "$dump" --size "$work/x.knit" >"$work/out" 2>&1 || [ $base -gt 65536 ]; do
        base=$((base + 256))
    done
    lean 'print "use miura from std\nswatch fill(miura, 1200, 851)"' 'a motif'
    rows='print "Cast on 1000"; for (i = 1; i <= 1000; i++) { printf "Row %d:", i; for (j = 1; j <= 1000; j += n)'
    lean "$rows { n = 1; printf \" %s1,\", i * j % 7 < 3 ? \"k\" : \"p\" } print \"\" }" 'rows of k1, p1'
    lean "$rows { n = 2; printf \" %s 2,\", i * j % 7 < 3 ? \"knit\" : \"purl\" } print \"\" }" 'rows of knit 2, purl 2'
fi

# Errors on every line: after ten thousand of them the file is read no further, with
# $each bytes of memory for each of the file; a hang ends at the processor time allowed.
each=5
lean_limit() {
    [ -z "${base-}" ] || room=$((base + each * $(wc -c <"$work/x.knit") / 1024))
    limit "$@"
}
make 'print "Cast on 4\nRow 1: k4"; for (i = 0; i < 800000; i++) print "rep from x"'
lean_limit E0714 'errors within one row'
make 'print "Cast on 4"; for (i = 0; i < 500000; i++) print "Row 1: rep from x"'
lean_limit E0714 'an error in every row'
make 'for (i = 0; i < 800000; i++) print "swatch ((("'
lean_limit E0714 'brackets left open'
make 'for (i = 0; i < 800000; i++) print "rep from x"'
lean_limit E0714 'lines read as text'
make 'print "Cast on 4\nRow 1: k4"; for (i = 0; i < 800000; i++) print "= a line of a head"'
lean_limit E0714 'lines of text that need no message'
make 'for (i = 0; i < 900000; i++) print "; ; ; ;"'
lean_limit E0714 'statements of nothing'
make 'for (i = 0; i < 1000001; i++) print "# remark"'
lean_limit E0701 'more than a million lines'
make 'for (i = 0; i < 10; i++) { for (j = 0; j < 240000; j++) printf "<b>"; print "" }'
lean_limit E0714 'words behind an error'
each=8
make 'for (i = 0; i < 900000; i++) print "Row 1: [x](y)"'
lean_limit E0714 'more rows than may be worked'

# What was meant is looked for only where it is told: these took five times as long.
seconds=6
room=
make 'for (i = 0; i < 400000; i++) print "use nothing from std"'
limit E0601 'a name the library does not have, on every line'
seconds=4
make 'for (i = 0; i < 110000; i++) printf "Row %d: q1, q2, q3, q4, q5, q6, q7, q8\n", i + 1'
limit E0301 'no stitch on any line'

finish
