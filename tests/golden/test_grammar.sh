#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The table of the language, grammar.txt: each case to its grid or its message.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
. "$WEFT_SOURCE/tests/golden/dump.sh"

# A file for each case: what is expected in its first line, then the script.
mkdir "$work/case"
awk -v folder="$work/case/" '
    function begin(expected) { close(file); file = sprintf("%s%04d", folder, ++n); print expected, "| " about >file }
    /^@@ /    { about = substr($0, 4); file = ""; next }
    /^@each / { each = substr($0, 7); line = "Row 1: k2, %s, k2\n"; file = ""; next }
    /^@after / { each = substr($0, 8); line = "Cast on 4\nRow 1: knit\n%s\n"; file = ""; next }
    /^@ /     { each = ""; begin(substr($0, 3)); next }
    each != "" && NF { begin(each); printf line, $0 >file; next }
    file != "" { print >file }
' "$WEFT_SOURCE/tests/golden/grammar.txt"

# Codes of errors or warnings among the messages, each once.
codes() {
    sed -n "s/.*$1: .*\[\([EW][0-9]*\)\]\$/\1/p" "$work/out" | sort -u | tr '\n' ' '
}

for file in "$work"/case/*; do
    read -r expected <"$file"
    about=${expected#*| }
    expected=${expected%% | *}
    sed 1d "$file" >"$work/x.knit"
    "$dump" "$work/x.knit" >"$work/out" 2>&1 </dev/null || :
    case $expected in
    E[0-9]*)
        text=${expected#E????}
        got="$(codes error)"
        grep -qF -e "${text# }" "$work/out" || got="$got(another text)"
        wanted="${expected%"$text"} "
        ;;
    *)
        got="$(grep -E '^[A-Za-z]+$' "$work/out" | tr '\n' ' ')$(codes error)$(codes warning)"
        wanted="$expected "
        ;;
    esac
    name="$about: $(sed 1d "$file" | tr '\n' '|')"
    if [ "$got" = "$wanted" ]; then
        pass "$name"
    else
        fail "$name"
        echo "# wanted $expected"
        sed 's/^/# got /' "$work/out"
    fi
done
finish
