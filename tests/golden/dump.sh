# SPDX-License-Identifier: GPL-3.0-or-later
# For the language's tests: sourced behind tap.sh. Scripts given as one argument
# with '|' for line ends; `grid` compares the rows from the bottom up.
# shellcheck shell=sh
dump=$(dirname "$WEFT")/tests/golden/knit_dump

script() {
    printf '%s\n' "$1" | tr '|' '\n' >"$work/x.knit"
}

# same NAME WANTED: what was printed, its lines joined by blanks.
same() {
    got=$(tr '\n' ' ' <"$work/out" | sed 's/ $//')
    if [ "$got" = "$2" ]; then
        pass "$1"
    else
        fail "$1"
        echo "# wanted $2"
        sed 's/^/# got /' "$work/out"
    fi
}

# grid SCRIPT ROWS
grid() {
    script "$1"
    "$dump" "$work/x.knit" >"$work/out" 2>&1 </dev/null
    same "$1" "$2"
}

# size SCRIPT 'COLUMNS x ROWS'
size() {
    script "$1"
    "$dump" --size "$work/x.knit" >"$work/out" 2>&1 </dev/null
    same "$1" "$2"
}

# wrong CODE SCRIPT [TEXT]: the script is refused with this code and nothing else.
wrong() {
    script "$2"
    status=0
    "$dump" "$work/x.knit" >"$work/out" 2>&1 </dev/null || status=$?
    if [ $status = 3 ] && [ "$(grep -c 'error:.*\[E' "$work/out")" = 1 ] &&
        grep -q "error: .*${3-}.*\[$1\]" "$work/out"; then
        pass "$1: $2"
    else
        fail "$1: $2"
        echo "# exit status $status"
        sed 's/^/# /' "$work/out"
    fi
}
