#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Each .knit here and the .expected beside it: messages, carets and grids to the
# letter. `golden.sh --update` writes the .expected files anew; read the diff.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
. "$WEFT_SOURCE/tests/golden/dump.sh"
dump=$(cd "$(dirname "$dump")" && pwd)/knit_dump
cd "$WEFT_SOURCE/tests/golden" || exit 1

# The options stand in the first line.
run() {
    options=$(sed -n '1s/^# options: //p' "$1" | tr -d '\000')
    status=0
    # shellcheck disable=SC2086
    "$dump" $options "$1" 2>&1 || status=$?
    echo "exit status $status"
}

for file in *.knit; do
    if [ "${1-}" = --update ]; then
        run "$file" >"${file%.knit}.expected"
    else
        run "$file" >"$work/out"
        check "$file" diff -u "${file%.knit}.expected" "$work/out"
    fi
done

# Every message has its golden text, except limits (limits.sh), what the row
# and motif tests cover, and imports (tests/charts).
if [ "${1-}" != --update ]; then
    for code in $(sed -n 's/.*X(CODE_[A-Z_]*, *\([0-9]*\),.*/\1/p' "$WEFT_SOURCE/lang/codes.h"); do
        name=$([ "$code" -ge 900 ] && echo "W0$code" || echo "E0$code")
        check "$name is tested" grep -rqe "\[$name\]" -e "[*]$name'" -e "wrong $name" -e "limit $name" . ../charts
    done
    finish
fi
