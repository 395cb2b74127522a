#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The tables of the language, grammar.txt, books.txt, web.txt and ways.txt: each case to its grid or its message, and
# to the same grid in the canonical layout, which is that of itself.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
. "$WEFT_SOURCE/tests/golden/dump.sh"

# A script for each case, and what is expected of all.
mkdir "$work/case"
awk -v folder="$work/case/" -v wanted="$work/wanted" -f "$WEFT_SOURCE/tests/golden/cases.awk" \
    "$WEFT_SOURCE/tests/golden/grammar.txt" "$WEFT_SOURCE/tests/golden/books.txt" "$WEFT_SOURCE/tests/golden/web.txt" "$WEFT_SOURCE/tests/golden/ways.txt"

# What each comes to.
for file in "$work"/case/*.knit; do
    echo '@case'
    "$dump" "$file"
    "$WEFT" fmt - <"$file" >"$work/y.knit" || continue
    echo '@formatted'
    "$dump" "$work/y.knit"
    "$WEFT" fmt - <"$work/y.knit" 2>&1 | cmp -s - "$work/y.knit" || echo '@changed'
done >"$work/out" 2>&1 </dev/null

# Rows, then the codes of errors, then those of warnings, each once.
awk -v wanted="$work/wanted" '
    function finish(    n, expected, about, code, text, good) {
        if (!ncases++)
            return
        getline expected <wanted
        about = substr(expected, 1, index(expected, "|") - 1)
        expected = substr(expected, length(about) + 2)
        if (expected ~ /^E[0-9][0-9][0-9][0-9]/) {
            code = substr(expected, 1, 5)
            text = substr(expected, 7)
            good = errors == code " " && index(all, text)
        } else {
            good = rows errors warnings == expected " " && (!formatted || (rows == again && !changed))
        }
        print (good ? "ok " : "not ok ") ncases - 1 " - " about ": " expected
        if (!good)
            print all
        rows = again = errors = warnings = all = ""
        formatted = changed = 0
    }
    /^@case$/      { finish(); next }
    /^@formatted$/ { formatted = 1 }
    /^@changed$|is left as it is: laid out anew/ { changed = 1 }
    { all = all "# " $0 "\n" }
    /^[A-Za-z]+$/  { if (formatted) again = again $0 " "; else rows = rows $0 " " }
    !formatted && /(error|warning): .*\[[EW][0-9]+\]$/ {
        code = substr($0, length($0) - 5, 5) " "
        if ($0 ~ /error: /) { if (!index(errors, code)) errors = errors code }
        else if (!index(warnings, code)) warnings = warnings code
    }
    END { finish(); print "1.." ncases - 1 }
' "$work/out"
