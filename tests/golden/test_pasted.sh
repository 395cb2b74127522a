#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Whole patterns as pages have them: each against the library's fabric (pasted.txt),
# with the warnings it must give and no other.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
. "$WEFT_SOURCE/tests/golden/dump.sh"
pages=$WEFT_SOURCE/tests/golden/pasted

while IFS='|' read -r page expression codes; do
    case $page in
    '#'*) continue ;;
    esac
    page=${page% }
    names=$(printf '%s' "$expression" | grep -o '[a-z_0-9]*' | grep -vx -e fill -e tile -e above -e beside -e inset -e crop -e '[0-9]*' | sort -u |
        tr '\n' ',' | sed 's/,$//')
    if [ "$expression" = ' - ' ]; then
        : >"$work/wanted"
    else
        printf '%sswatch %s\n' "${names:+use $names from std;}" "$expression" >"$work/x.knit"
        "$dump" "$work/x.knit" >"$work/wanted" 2>&1
    fi
    "$dump" "$pages/$page.knit" >"$work/all" 2>&1 || :
    grep -E '^[KP]+$' "$work/all" >"$work/got" || :
    check "$page" diff "$work/wanted" "$work/got"
    got=$(sed -n 's/.*\(error\|warning\): .*\[\([EW][0-9]*\)\]$/\2/p' "$work/all" | sort -u | tr '\n' ' ')
    wanted=$(printf '%s' "$codes" | tr ' ' '\n' | grep . | sort -u | tr '\n' ' ')
    check "$page: says '$wanted', got '$got'" test "$got" = "$wanted"

    # In the canonical layout it is the same.
    [ "$expression" != ' - ' ] || continue
    "$WEFT" fmt - <"$pages/$page.knit" >"$work/y.knit" 2>/dev/null
    "$dump" "$work/y.knit" 2>/dev/null | grep -E '^[KP]+$' >"$work/formatted" || :
    check "$page: formatted" cmp "$work/got" "$work/formatted"
done <"$pages/pasted.txt"
finish
