#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# --diagnostics json: an object a line, and where it says the mistake stands.
# Columns count characters from 1, the end is behind the last.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

json=$(pwd)/tests/cli/json
cd "$work" || exit 1

# messages NAME ARGUMENTS...: each line of the messages as a file of its own.
messages() {
    title=$1
    shift
    rm -f message.*
    "$WEFT" "$@" --diagnostics json >out 2>err </dev/null || :
    split -l 1 -a 2 err message.
    check "$title: every line is an object" every_line
}
every_line() {
    for file in message.*; do
        for key in file line column end severity code text notes hints; do
            "$json" "$file" $key >/dev/null || return 1
        done
    done
}

# says NUMBER 'file line column end severity code': the message of this number.
says() {
    file=$(ls message.* | sed -n "$1p")
    got=
    for key in file line column end severity code; do
        got="$got$("$json" "$file" $key) "
    done
    check "$title: $2" test "$got" = "$2 "
}

# also NUMBER WHICH 'file line column end': another place it names.
also() {
    file=$(ls message.* | sed -n "$1p")
    got=
    for key in file line column end; do
        got="$got$("$json" "$file" "notes.$2.$key") "
    done
    check "$title: and $3" test "$got" = "$3 "
}

printf 'Cast on 4\nRow 1: k2, q2\n' >plain.knit
messages 'plain text' check plain.knit
says 1 'plain.knit 2 12 14 error E0301'
check 'its text' sh -c '"$1" message.aa text | grep -q "q2. is no stitch"' - "$json"
check 'its hint' sh -c '"$1" message.aa hints.0 | grep -q "stitches are k, p"' - "$json"

printf '\357\273\277Row 1: k2, q2\r\nRow 2: k2, z2\r\n' >windows.knit
messages 'byte order mark, lines of Windows' check windows.knit
says 1 'windows.knit 1 12 14 error E0301'
says 2 'windows.knit 2 12 14 error E0301'

printf 'Row 1: k2, q2\rRow 2: k2, z2\r' >mac.knit
messages 'lines of old Macs' check mac.knit
says 2 'mac.knit 2 12 14 error E0301'

printf '# \303\251t\303\251 \360\237\247\266\nRow 1:\tk2 \342\200\223\302\240q2\n' >utf8.knit
messages 'tabs, dashes, letters of two to four bytes' check utf8.knit
says 1 'utf8.knit 2 13 15 error E0301'

printf 'let \303\251 = 1\nswatch K\n' >letter.knit
messages 'the letter itself' check letter.knit
says 1 'letter.knit 1 5 6 error E0102'

printf 'Row 1: k2 \377\376\n' >bytes.knit
messages 'bytes that are no text' check bytes.knit
says 1 'bytes.knit 1 11 12 error E0102'

printf 'Cast on 4\nRow 1: p1, k the rest of the row; (q2)\n' >phrase.knit
messages 'behind a turn of phrase' check phrase.knit
says 1 'phrase.knit 2 36 38 error E0301'

printf '' >empty.knit
messages 'an empty file' check empty.knit
says 1 'empty.knit 1 1 1 error E0105'

printf 'swatch K\nsprings { edges = [left,\n  up] }\n' >block.knit
messages 'a word in a block of several lines' check block.knit
says 1 'block.knit 3 3 5 error E0502'

printf 'swatch K\n\n\nswatch "' >end.knit
messages 'the end of the text' check end.knit
says 1 'end.knit 4 8 9 error E0103'

printf 'Work 4 rows in moss stitch\nRow 5: k2\n' >warning.knit
messages 'a warning' check warning.knit
says 1 'warning.knit 1 16 27 warning W0901'
messages 'a warning taken for an error' check -W error warning.knit
says 1 'warning.knit 1 16 27 error W0901'

# Several: each, in the order of the text.
printf 'Cast on 4\nRow 1: k5\nRow 2: q2\nRow 3: k2tog, k2\n' >three.knit
messages 'three mistakes' check three.knit
says 1 'three.knit 2 8 10 error E0303'
says 2 'three.knit 3 8 10 error E0301'
says 3 'three.knit 4 8 13 error E0302'
messages 'two files' check three.knit plain.knit
says 4 'plain.knit 2 12 14 error E0301'

# In a motif: where it is written and where it is used.
printf 'motif m(n) {\n  Row 1: k{n}\n  Row 2: k{n + 1}\n}\nswatch tile(m(3), 2, 2)\n' >motif.knit
messages 'a motif' check motif.knit
says 1 'motif.knit 3 10 18 error E0303'
also 1 0 'motif.knit 2 10 14'
also 1 1 'motif.knit 5 13 17'

# In a file that is used, through another.
printf '\357\273\277motif low {\r\n  Row 1: k2, q2\r\n}\r\n' >low.knit
printf 'use low from "low.knit"\nmotif middle = tile(low, 2, 1)\n' >middle.knit
printf '# \303\274\nuse middle from "middle.knit"; swatch middle\n' >top.knit
messages 'a motif of a file of a file' check top.knit
says 1 'low.knit 2 14 16 error E0301'
also 1 0 'middle.knit 2 21 24'
also 1 1 'top.knit 2 39 45'

printf 'let a = \n' >broken.knit
printf 'swatch K; use "broken.knit" as b\n' >using.knit
messages 'a file that cannot be read as a script' check using.knit
says 1 'broken.knit 1 9 9 error E0101'
also 1 0 'using.knit 1 11 33'

printf 'K P\nK\n' >ragged.txt
printf 'use "ragged.txt" as r\nswatch r\n' >chart.knit
messages 'a chart from elsewhere' check chart.knit
says 1 'ragged.txt 2 2 2 error E0801'
also 1 1 'chart.knit 1 1 22'

# The command line has no place; standard input is '-'.
messages 'the command line' check -D q=1 motif.knit
says 1 'command line 0 0 0 error E0604'
"$WEFT" check --diagnostics json - <plain.knit 2>message.aa
check 'standard input' test "$("$json" message.aa file)" = -

# The other commands say it the same way, and nothing else.
for command in run chart write params; do
    messages "weft $command" $command plain.knit
    says 1 'plain.knit 2 12 14 error E0301'
done
messages 'weft fmt' fmt letter.knit
says 1 'letter.knit 1 5 6 error E0102'
messages 'weft import' import ragged.txt
says 1 'ragged.txt 2 2 2 error E0801'
finish
