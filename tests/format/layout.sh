#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# weft fmt: the layout itself, each .knit here against the .expected beside it;
# what becomes of files. `layout.sh --update` writes the .expected files anew.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

here=$WEFT_SOURCE/tests/format
for file in "$here"/*.knit; do
    stem=$(basename "$file" .knit)
    if [ "${1-}" = --update ]; then
        "$WEFT" fmt - <"$file" >"$here/$stem.expected"
        continue
    fi
    check "$stem can be formatted" sh -c '"$WEFT" fmt - <"$1" >"$2"' sh "$file" "$work/once"
    check "$stem: layout" diff -u "$here/$stem.expected" "$work/once"
    if "$WEFT" chart "$file" >"$work/chart" 2>/dev/null; then
        check "$stem: the same fabric" sh -c '"$WEFT" chart "$1" | cmp - "$2"' sh "$work/once" "$work/chart"
    fi
    check "$stem: formatted again" sh -c '"$WEFT" fmt - <"$1" | cmp - "$1"' sh "$work/once"
done
[ "${1-}" != --update ] || exit 0

# ---- files ----

mkdir "$work/files"
cd "$work/files" || exit 1
printf 'CAST ON 4\nRow 1: K2,P2\n' >wild.knit
printf 'Cast on 4 sts\nRow 1: k2, p2\n' >even.knit
printf 'Cast on 4\nRow 1: k2 %% p2\nlet a = (3\n' >wrong.knit
printf 'motif m { Row 1: K9 }\n' >parts.knit
cp wild.knit was.knit
cp wrong.knit wrong.was

exits 1 'check of a file that is not formatted' "$WEFT" fmt --check wild.knit even.knit
check 'names it, and the other not' test "$(cat "$work/out")" = wild.knit
check 'and changes nothing' cmp wild.knit was.knit
exits 0 'check of one that is' "$WEFT" fmt --check even.knit
empty 'says nothing' "$work/out"
exits 1 'check, quietly' "$WEFT" fmt --check -q wild.knit
empty 'says nothing at all' "$work/out"

inode=$(ls -i even.knit)
exits 3 'several files, one with errors' "$WEFT" fmt wild.knit wrong.knit even.knit parts.knit
err 'errors are shown at their place' '^wrong.knit:2:11: error: '
err 'with carets' '^ *| *\^'
check 'the file with errors is left alone' cmp wrong.knit wrong.was
check 'the first is formatted' cmp wild.knit even.knit
check 'and the one behind the errors' grep -q '^motif m { Row 1: k9 }$' parts.knit
check 'what was formatted is not touched' test "$(ls -i even.knit)" = "$inode"
holds 'nothing else is left' . wild.knit even.knit wrong.knit wrong.was parts.knit was.knit
exits 0 'all is well now' "$WEFT" fmt --check wild.knit even.knit parts.knit

# Parts of a line that read otherwise on lines of their own.
printf 'Cast on 4 sts., an$ work 2 rows in plain knitting.\n' >glued.knit
cp glued.knit glued.was
exits 0 'what cannot be laid out' "$WEFT" fmt glued.knit
err 'is named' "'glued.knit' is left as it is"
check 'and stays' cmp glued.knit glued.was
rm glued.*

# An error of the source is one of its layout.
printf 'Row 1: knit front and back, k5\n' >other.knit
cp other.knit other.was
exits 0 'what would have another error' "$WEFT" fmt other.knit
err 'is named' "'other.knit' is left as it is"
check 'and stays, too' cmp other.knit other.was
rm other.*

exits 3 'errors for editors' "$WEFT" fmt --diagnostics json wrong.knit
err 'are JSON' '^{"file": "wrong.knit", "line": 2,'
exits 4 'a file that is not there' "$WEFT" fmt missing.knit
err 'is named' "cannot read 'missing.knit'"
exits 2 'no file' "$WEFT" fmt
: >empty.knit
exits 3 'an empty file' "$WEFT" fmt empty.knit
if [ "$(id -u)" = 0 ]; then
    skip 'a folder that cannot be written' 'root can write everywhere'
else
    mkdir closed
    cp was.knit closed/a.knit
    chmod a-w closed
    exits 4 'a folder that cannot be written' "$WEFT" fmt closed/a.knit
    chmod u+w closed
fi
chmod 640 was.knit
exits 0 'a file with rights of its own' "$WEFT" fmt was.knit
check 'keeps them' test "$(ls -l was.knit | cut -c 1-10)" = -rw-r-----
ln -s was.knit link.knit
printf 'swatch  K\n' >was.knit
exits 0 'a link' "$WEFT" fmt link.knit
check 'stays a link' test -L link.knit
check 'to the formatted file' grep -q '^swatch K$' was.knit

finish
