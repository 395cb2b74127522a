#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Charts as pictures: which way up, every kind of PNG, the key, and what is no stitch.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
. "$WEFT_SOURCE/tests/charts/grids.sh"
paint=$PWD/tests/charts/paint

# same NAME FILE [OPTION]...: the script made of FILE has the flag's grid.
same() {
    name=$1
    shift
    exits 0 "$name" "$WEFT" import "$@"
    mv "$work/out" "$work/again.knit"
    check 'has the grid' sh -c '"$1" chart --grid "$2/again.knit" | diff "$2/flag.txt" -' - "$WEFT" "$work"
}

for kind in rgb rgba gray indexed deep deep_srgb interlaced deep_interlaced; do
    printf 'kkkp\nkkpp\nkppp\n' | "$paint" "$kind" "$work/flag.png"
    same "$kind" "$work/flag.png"
    err 'what the colours are taken for is said' 'flag.png: black is taken as knit, white as purl'
done
check 'and stands in the script' grep '^# black is taken as knit, white as purl$' "$work/again.knit"
exits 0 'quietly' "$WEFT" import -q "$work/flag.png" -o "$work/flag.knit"
empty 'it is not' "$work/err"
cp "$work/flag.png" "$work/flag.dat"
same 'a picture by another name' "$work/flag.dat"

printf 'ppprrr\n' | sed 's/ppprrr/rrrk/;p;s/.*/rrkk/;p;s/.*/rkkk/' | "$paint" rgb "$work/red.png"
same 'a key' "$work/red.png" --key '#ff0000=k,black=p'
empty 'needs no saying' "$work/err"
same 'a key of capitals' "$work/red.png" --key '#000000=P,#FF0000=K,#123456=k'
same 'a key with blanks, words and short colours' "$work/red.png" --key ' #000=purl, #f00=Knit '

for kind in rgb deep_srgb deep_interlaced linear; do
    printf 'gggk\nggkk\ngkkk\n' | "$paint" "$kind" "$work/gray.png"
    same "a gray of its own, $kind" "$work/gray.png" --key '#808080=k,black=p'
done

exits 3 'another colour' sh -c 'cd "$2" && "$1" import red.png' - "$WEFT" "$work"
check 'is an error with its place' diff - "$work/err" <<'TEXT'
red.png:1:1: error: the pixel at x = 0, y = 0 is #ff0000, which the key does not have [E0807]
   1 | ???k
     | ^
note: x counts from 0 at the left, y from 0 at the top; 5 more pixels are not in the key
hint: `weft import` says what colours mean: `--key '#ff0000=k,#000000=p'`
TEXT
empty 'nothing comes out' "$work/out"
printf 'rrg\n' | "$paint" rgb "$work/two.png"
exits 3 'two other colours' "$WEFT" import "$work/two.png"
err 'stand in the key that is proposed' "^hint: .*--key '#ff0000=k,#808080=p'"
exits 3 'a colour that is missing in a key' "$WEFT" import "$work/two.png" --key '#808080=p'
err 'is one to add' '^hint: add it to the key: `#ff0000=k` or `#ff0000=p`$'
"$WEFT" import "$work/flag.txt" | "$WEFT" chart - -o "$work/drawn.png"
exits 3 'a drawing of a chart' "$WEFT" import "$work/drawn.png"
err 'is no chart of a pixel a stitch' \
    '^hint: a chart has a pixel for each stitch and a colour for each kind of stitch; this picture has [0-9]* colours$'
printf 'kkpk\nkprk\n' | "$paint" indexed "$work/one.png"
exits 3 'one pixel' "$WEFT" import "$work/one.png"
err 'at x, y' 'x = 2, y = 1 is #ff0000'
printf 'kkpk\nktpk\n' | "$paint" rgba "$work/clear.png"
exits 3 'for programs' sh -c 'cd "$2" && "$1" import one.png --diagnostics json' - "$WEFT" "$work"
err 'the line and the column count from 1' '^{"file": "one.png", "line": 2, "column": 3, "end": 4, .*"code": "E0807"'
exits 3 'a transparent one' "$WEFT" import "$work/clear.png"
err 'is said to be that' 'x = 1, y = 1 is transparent'
err 'with what to do' '^hint: fill what is transparent with a colour$'
printf 'kh\n' | "$paint" rgba "$work/half.png"
exits 3 'one that can be seen through a little' "$WEFT" import "$work/half.png"
err 'is no colour, either' 'x = 1, y = 0 is transparent'

# keys N: N colours, black and white not among them.
keys() { awk -v n="$1" 'BEGIN { for (i = 1; i <= n; i++) printf "%s#%06x=k", (i > 1 ? "," : ""), i }'; }
exits 0 'a key of 256 colours' "$WEFT" import -q "$work/red.png" --key "$(keys 254),#ff0000=k,black=p"
exits 2 'of one more' "$WEFT" import -q "$work/red.png" --key "$(keys 255),#ff0000=k,black=p"
err 'is too many' '^weft: --key: a key may have 256 colours'
for key in '' k=k '#12345=k' '#1234567=k' '#000000' '#000000=' '#000000=kp' 'black=k,' 'black=k;white=p' 'black=k,#000000=p'; do
    exits 2 "the key '$key'" "$WEFT" import "$work/red.png" --key "$key"
    err 'is refused' '^weft: --key: '
done
exits 2 'a key for a text' "$WEFT" import "$work/flag.txt" --key black=k
err 'is useless' 'for pictures'

head -c 60 "$work/red.png" >"$work/cut.png"
exits 3 'a picture cut short' "$WEFT" import "$work/cut.png"
err 'cannot be read' 'cut.png:1:1: error: this picture cannot be read.*E0808'
limit=1000000
! sanitized "$WEFT" || limit=unlimited
exits 3 'a chunk of two gigabytes that are not there' \
    sh -c 'ulimit -v "$3"; exec "$1" import "$2"' - "$WEFT" "${srcdir:-.}/tests/fuzz/found/png-long-chunk" $limit
err 'takes no room' 'this picture cannot be read: it ends too early'
{
    printf '\211PNG\r\n\032\n\000\000\000\015IHDR'
    printf '\000\000\013\270\000\000\013\270\001\000\000\000\000\131\156\310\324'
    printf '\000\000\000\000IDAT\065\257\006\036\000\000\000\000IEND\256\102\140\202'
} >"$work/photograph.png"
exits 3 'a photograph' "$WEFT" import "$work/photograph.png"
err 'is too large' 'the picture is 3000 x 3000 pixels; a fabric may have 4000000 stitches \[E0707\]'
printf '\377\330\377\340\000\020JFIF' >"$work/jpeg.png"
exits 3 'a JPEG called .png' "$WEFT" import "$work/jpeg.png"
err 'is named' 'this is a JPEG picture, not a chart'
err 'with what to do' '^hint: save it as PNG, with a pixel for each stitch'
exits 3 'a text called .png' sh -c 'cp "$2/flag.txt" "$2/text.png" && "$1" import "$2/text.png"' - "$WEFT" "$work"
err 'cannot be read' 'text.png:1:1: error: this is no PNG picture.*E0808'

# ---- and out ----

"$WEFT" import "$work/flag.txt" >"$work/flag.knit"
exits 0 'a picture of a pixel for each stitch' "$WEFT" chart "$work/flag.knit" -o "pixels:$work/pixels.png"
same 'comes back' "$work/pixels.png"
printf 'motif flag { chart { kp } }\nswatch flag\noutput pixels "%s/run.png"\nsolve { steps = 1 }\n' "$work" >"$work/run.knit"
exits 0 'as an output of a run' "$WEFT" "$work/run.knit"
check 'is a picture' test -s "$work/run.png"
printf 'stitch T { kx = 1 }\nswatch tile(T, 2, 2)\noutput pixels "%s/own.png"\n' "$work" >"$work/own.knit"
exits 3 'a stitch of the script itself' "$WEFT" "$work/own.knit"
err 'has no colour' 'the stitch T is neither knit nor purl'
exits 3 'nor in a chart' "$WEFT" chart "$work/own.knit" -o "pixels:$work/own.png"

# ---- there and back: grids painted, and imported ----

mkdir "$work/random" "$work/library"
# back FILE: its grid, painted and imported, is its grid.
back() {
    sed '1d;s/ //g' "$1" | tr KP kp | awk '{ row[NR] = $0 } END { for (i = NR; i > 0; i--) print row[i] }' |
        "$paint" indexed "$work/x.png" && "$WEFT" import -q "$work/x.png" >"$work/x.knit" &&
        "$WEFT" chart --grid "$work/x.knit" | cmp "$1" -
}
library_scripts "$work/library"
for file in "$work"/library/*.knit; do
    "$WEFT" chart -q --grid "$file" >"$work/grid.txt"
    check "$(basename "$file" .knit)" back "$work/grid.txt"
done
random_grids "$work/random" 40
bad=0
for file in "$work"/random/*.txt; do
    back "$file" || bad=$((bad + 1))
done
check 'random grids come back' test "$bad" = 0

finish
