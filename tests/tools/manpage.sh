#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The man page: well formed, of this version, and all that weft can do is in it.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

page=$WEFT_SOURCE/docs/weft.1
[ -f "$page" ] || page=$(dirname "$WEFT")/docs/weft.1
sh "$WEFT_SOURCE/docs/manpage.sh" "$WEFT" "$WEFT_SOURCE/docs/weft.1.in" >"$work/weft.1"
check 'the page is that of this weft' diff "$page" "$work/weft.1"

if command -v mandoc >/dev/null 2>&1; then
    mandoc -Tlint -Wwarning "$page" >"$work/lint" 2>&1
    empty 'mandoc finds nothing wrong' "$work/lint"
    mandoc -Tascii -Owidth=80 "$page" | sed 's/.\x08//g' >"$work/text"
elif command -v groff >/dev/null 2>&1; then
    groff -man -ww -Tascii -P-c -P-b -P-u "$page" >"$work/text" 2>"$work/lint"
    empty 'groff finds nothing wrong' "$work/lint"
else
    skip 'the page is well formed' 'neither mandoc nor groff is here'
    sed 's/\\-/-/g; s/^\.B[I]* //' "$page" >"$work/text"
fi
check 'no line is wider than 80 columns' sh -c '! grep -n ".\{81\}" "$1"' sh "$work/text"

"$WEFT" help | sed -n '/^Commands:/,/^$/p' | sed '1d; /^$/d; s/^ *\([a-z]*\).*/\1/' >"$work/commands"
check 'there are commands' test "$(wc -l <"$work/commands")" -ge 10
while read -r command; do
    check "$command is explained" grep -q "^ *$command\( \|\$\)" "$work/text"
    for option in $("$WEFT" help "$command" | sed -n '/^Options:/,$p' | sed 1d | cut -c 1-29 | grep -o -e '--*[A-Za-z-]*' | sort -u); do
        grep -q -e "^ *\(-.,  *\)*$option\(,\| \|\$\)" "$work/text" || echo "$option" >>"$work/unexplained"
    done
done <"$work/commands"
touch "$work/unexplained"
empty 'every option is explained' "$work/unexplained"
for status in 0 1 2 3 4; do
    check "exit status $status" grep -q "^ *$status\(  \|\$\)" "$work/text"
done

finish
