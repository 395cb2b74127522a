# SPDX-License-Identifier: GPL-3.0-or-later
# For the tests that are shell scripts: commands in, TAP out.  Sourced; each
# script ends with `finish`.  $work is a folder of its own, removed at the end.
# shellcheck shell=sh

: "${WEFT:=$PWD/weft}" "${WEFT_SOURCE:=$PWD}"
LC_ALL=C
export LC_ALL
unset NO_COLOR WEFT_PATH SOURCE_DATE_EPOCH
work=$(mktemp -d)
trap 'chmod -R u+w "$work"; rm -rf "$work"' EXIT
count=0

# pass NAME; fail NAME
pass() {
    count=$((count + 1))
    echo "ok $count - $1"
}

fail() {
    count=$((count + 1))
    echo "not ok $count - $1"
}

# skip NAME REASON
skip() {
    count=$((count + 1))
    echo "ok $count - $1 # SKIP $2"
}

# check NAME COMMAND...: the command succeeds.
check() {
    name=$1
    shift
    if "$@" >"$work/.check" 2>&1; then
        pass "$name"
    else
        fail "$name"
        printf '%s\n' "$*" | sed 's/^/# /'
        sed 's/^/# /' "$work/.check"
    fi
}

# exits STATUS NAME COMMAND...: the command ends with this status; what it
# printed is then in $work/out and $work/err.
exits() {
    wanted=$1
    name=$2
    shift 2
    status=0
    "$@" >"$work/out" 2>"$work/err" </dev/null || status=$?
    if [ "$status" = "$wanted" ]; then
        pass "$name"
    else
        fail "$name"
        echo "# $*"
        echo "# exit status $status instead of $wanted"
        sed 's/^/# /' "$work/out" "$work/err"
    fi
}

# out NAME PATTERN; err NAME PATTERN: what was printed has a line like that.
out() { check "$1" grep -e "$2" "$work/out"; }
err() { check "$1" grep -e "$2" "$work/err"; }

# empty NAME FILE
empty() {
    if [ -s "$2" ]; then
        fail "$1"
        sed 's/^/# /' "$2"
    else
        pass "$1"
    fi
}

# holds NAME FOLDER FILE...: the folder holds these files and no others.
holds() {
    name=$1
    folder=$2
    shift 2
    check "$name" test "$(cd "$folder" && find . -mindepth 1 | sort | tr '\n' ' ')" = \
        "$(for file in "$@"; do echo "./$file"; done | sort | tr '\n' ' ')"
}

# opens NAME PROGRAM ARGUMENT...: another program can read it.
opens() {
    name=$1
    shift
    if command -v "$1" >/dev/null; then
        check "$name opens" "$@"
    else
        skip "$name opens" "no $1"
    fi
}

# await COMMAND...: waits until the command succeeds, a minute at most.
await() {
    tries=0
    until "$@" || [ "$tries" -ge 1200 ]; do
        sleep 0.05
        tries=$((tries + 1))
    done
}

# no_kind COMMAND FILE: a kind before the name, as `weft run -o` has it, is none of a script's.
no_kind() {
    exits 2 'a kind before the name' sh -c 'cd "$1" && "$2" "$3" "$4" -o foo:x.knit' - "$work" "$WEFT" "$@"
    err 'is refused' "'foo:x.knit' names another"
    check 'and nothing is written' test ! -e "$work/foo:x.knit"
    exits 0 'with its folder' sh -c 'cd "$1" && "$2" "$3" "$4" -o ./foo:x.knit' - "$work" "$WEFT" "$@"
    check 'it is a name' test -s "$work/foo:x.knit"
}

# sanitized PROGRAM: is it built with the address sanitizer, whose own memory is beyond any limit?
sanitized() {
    grep -aq __asan_init "$1"
}

# A ribbed swatch of 8 columns and 4 rows, to which settings and outputs are added.
rib_script() {
    echo 'Cast on 8 sts'
    echo 'Row 1: *k2, p2; rep from * to end.'
    echo 'Row 2: *k2, p2; rep from * to end.'
    echo 'Repeat rows 1-2 2 times.'
}

# same_again 'FILE...' COMMAND...: the command writes the same bytes a second time.
same_again() {
    files=$1
    shift
    mkdir first
    # shellcheck disable=SC2086
    mv $files first
    exits 0 'and again' "$@"
    for file in $files; do
        check "$file has the same bytes" cmp "$file" "first/$file"
    done
}

finish() {
    echo "1..$count"
}
