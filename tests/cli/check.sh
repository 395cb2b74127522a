#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# weft check: exit status and messages; what is on which stream.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

printf 'Cast on 6 sts\nRow 1: *k2, p1; rep from * to end\n' >"$work/good.knit"
printf 'Cast on 6 sts\nRow 1: k5\n' >"$work/short.knit"
printf 'swatch nothing\n' >"$work/name.knit"

exits 0 'a good script' "$WEFT" check "$work/good.knit"
out 'says the size of its swatch' ': 6 stitches x 1 row, 4 knit, 2 purl$'
empty 'and no message' "$work/err"

# Threads of a library that find no memory do not keep the program from its end.
if sanitized "$WEFT"; then
    skip 'under a limit of memory' 'the address sanitizer needs more'
else
    exits 0 'under a limit of memory' timeout -s KILL 60 sh -c 'ulimit -v 200000; exec "$@"' - "$WEFT" check "$work/good.knit"
fi

printf 'Row 1: k1\nRow 2: p1\n' >"$work/one.knit"
exits 0 'a narrow one' "$WEFT" check "$work/one.knit"
out 'of one stitch' ': 1 stitch x 2 rows, 2 knit'

exits 0 'quietly' "$WEFT" check -q "$work/good.knit"
empty 'prints nothing' "$work/out"
printf 'Cast on 6 sts\nRow 1: knit\nRow 2: purl\nA line of text behind the rows of a page.\nRepeat rows 1-2\n' >"$work/doubtful.knit"
exits 0 'a doubtful one' "$WEFT" check "$work/doubtful.knit"
err 'has warnings' 'warning: .*W0902'
exits 0 'quietly' "$WEFT" check -q "$work/doubtful.knit"
empty 'has none' "$work/err"
sed '$aRow 3: k5' "$work/doubtful.knit" >"$work/wrong.knit"
exits 3 'one with an error, too, quietly' "$WEFT" check -q "$work/wrong.knit"
err 'has the error' 'error: .*E0303'
check 'and no warning' sh -c '! grep -q warning "$1"' - "$work/err"
exits 3 'a doubtful one, quietly, where warnings are errors' "$WEFT" check -q -W error "$work/doubtful.knit"
err 'has them' 'error: .*W0904'

printf 'Row 1: knit across and so we all cast on 60 sts\n' >"$work/late.knit"
exits 3 'a cast-on in a row, and none before' "$WEFT" check "$work/late.knit"
err 'is told where it belongs' '^hint: .* on a line of their own, above its rows: .Cast on 60 sts.'
printf 'Cast on 4\nRow 1: cast on 60 sts\n' >"$work/late.knit"
exits 3 'one behind another' "$WEFT" check "$work/late.knit"
check 'is not' sh -c '! grep -q "above its rows" "$1"' - "$work/err"

exits 3 'a bad script' "$WEFT" check "$work/short.knit"
err 'its error has a place' 'short.knit:2:.*error'
empty 'and no result' "$work/out"

exits 3 'a good and a bad one' "$WEFT" check "$work/good.knit" "$work/name.knit"
out 'the good one has its line' 'good.knit: 6 stitches'
err 'the bad one its error' 'name.knit:1:'

exits 4 'a file that is not there' "$WEFT" check "$work/none.knit"
err 'is named' "cannot read '.*none.knit': No such file"
# Misspelt paths: the nearest file that is there, folder by folder.
mkdir "$work/examples"
printf 'swatch tile(K, 2, 2)\n' >"$work/examples/miura.knit"
cp "$work/examples/miura.knit" "$work/rib.knit"
misspelt() {
    exits 4 "$1" sh -c 'cd "$1" && "$2" "$3" "$4"' - "$work" "$WEFT" "$2" "$1"
    err 'is known' "^weft: cannot read '$1': No such file or directory; did you mean '$3'?\$"
}
misspelt rib.knitt check rib.knit
misspelt ./rbi.knit fmt ./rib.knit
misspelt rib check rib.knit
misspelt exmples/miura.knit run examples/miura.knit
misspelt exmples/mirua.knit import examples/miura.knit
exits 4 'a name like none of them' "$WEFT" check "$work/other.csv"
err 'is not guessed' "other.csv': No such file or directory$"
exits 4 'a folder that is not there' "$WEFT" check "$work/nothing/rib.knit"
err 'is not guessed, either' "rib.knit': No such file or directory$"
exits 4 'an empty name' "$WEFT" check ''
exits 2 'a file without its extension for a command' sh -c 'cd "$1" && "$2" rib' - "$work" "$WEFT"
err 'is known' "no command or file 'rib'; did you mean rib.knit?"
printf 'use "exmples/miura.knit" as m\nuse "rib.csv" as r\nuse "unlike.csv" as u\nswatch K\n' >"$work/used.knit"
exits 3 'misspelt files that a script uses' "$WEFT" check "$work/used.knit"
err 'a folder' "did you mean 'examples/miura.knit'?"
check 'one alone' test "$(grep -c 'did you mean' "$work/err")" = 1
printf 'K K\n' >"$work/rib.cvs"
exits 3 'a chart' "$WEFT" check "$work/used.knit"
err 'too' "did you mean 'rib.cvs'?"
exits 3 'in a folder of -I' sh -c 'cd "$1/examples" && printf "use \"rbi.knit\" as r\nswatch K\n" | "$2" check - -I ..' - "$work" "$WEFT"
err 'named from there' "did you mean 'rib.knit'?"

exits 4 'a folder' "$WEFT" check "$work/."
err 'is not a script' "cannot read '.*': Is a directory"

exits 0 'standard input' sh -c '"$1" check - <"$2"' - "$WEFT" "$work/good.knit"
out 'is named so' '^standard input: 6 stitches x 1 row,'
exits 3 'a bad standard input' sh -c '"$1" check - <"$2"' - "$WEFT" "$work/short.knit"

# Files that are something else: one sentence each.
printf '\377\376R\000o\000w\000' >"$work/wide.knit"
exits 3 'a text in UTF-16' "$WEFT" check "$work/wide.knit"
err 'is named' 'this is a text in UTF-16, not a script'
err 'and how it is read' 'save it as UTF-8'
printf '\211PNG\r\n\032\n\000' >"$work/p.knit"
exits 3 'a picture' "$WEFT" check "$work/p.knit"
err 'is named, too' 'this is a picture, not a script'

printf 'param n = 2\nparam wide = 3\nRow 1: k{n}, p{wide}\n' >"$work/params.knit"
exits 2 'a param far from all' "$WEFT" check -D q=1 "$work/params.knit"
err 'is told which there are' 'its params: n, wide'

# Every line of --diagnostics json is an object by itself, or all are one value.
exits 3 'messages as JSON' "$WEFT" check --diagnostics json "$work/short.knit"
check 'are JSON' tests/cli/json "$work/err"

exits 3 'colour on request' "$WEFT" check --color always "$work/short.knit"
check 'has escapes' grep -q "$(printf '\033')" "$work/err"
exits 3 'no colour in a pipe' "$WEFT" check "$work/short.knit"
check 'has none' sh -c '! grep -q "$(printf "\033")" "$1"' - "$work/err"

finish
