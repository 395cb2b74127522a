#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Who may include whom: the layers of the house, read from its #include lines.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
cd "$WEFT_SOURCE" || exit 1

# includes FOLDER...: "file header" for each of our own headers its sources include.
includes() {
    find "$@" -name '*.[chly]' -exec grep -H '^ *# *include *"' {} + |
        sed 's/^\([^:]*\):.*"\(.*\)".*/\1 \2/'
}

# only FOLDER PATTERN: sources of the folder include nothing of ours but that.
only() {
    if [ -d "$1" ]; then
        includes "$1" | grep -Ev " ($2|config\.h)\$" >"$work/strangers"
        empty "$1 includes only $2" "$work/strangers"
    fi
}

only lang '(lang/.*|parser\.h)'
only lang/page 'lang/(page/.*|(arena|ast|diag|grid|limits|parse|refused|scanner|settings|syntax|typos)\.h)'
only lang/rows 'lang/(rows/.*|page/page_(chart|facts)\.h|(ast|eval|grid|limits|names)\.h)'
only drawing 'drawing/.*'
only charts '(lang|charts|drawing)/.*'
only solver '(solver/.*|lang/(scene|grid)\.h)'
only output '(output/.*|drawing/.*|charts/drawn_body\.h|solver/surface\.h|lang/(scene|grid)\.h)'

includes solver | grep ' lang/' | grep -v '^solver/sheet\.[ch] ' >"$work/strangers"
empty 'of the solver, only sheet.[ch] reads the scene' "$work/strangers"

# keeps HEADER PATTERN: only files like that include a library's header.
keeps() {
    find lang drawing charts solver output cli weft.c -name '*.[chly]' -exec grep -l "include *<$1" {} + 2>/dev/null |
        grep -Ev "^($2)\$" >"$work/strangers"
    empty "$1 stays in $2" "$work/strangers"
}

keeps 'cjson/' '(output|cli)/.*'
keeps 'lbfgs\.h' 'solver/.*lbfgs\.[ch]'
keeps '\(suitesparse/\)*cholmod\.h' 'solver/(factor|newton|plbfgs)\.[ch]'
keeps 'sha2\.h' 'output/file\.c'
keeps 'cairo.*\.h' 'drawing/.*'
keeps 'png\.h' '(charts/picture|drawing/packed)\.c'
keeps 'cmocka\.h' 'none'

finish
