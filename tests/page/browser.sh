#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The page in a headless Chromium: what a person sees, turns and points at.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

cp "$WEFT_SOURCE/examples/rib.knit" "$work/a <b> & c.knit"
cd "$work" || exit 1
if [ ! -s "$WEFT_SOURCE/viewer/template.html" ]; then
    skip 'the page' 'built without npm'
    finish
    exit
fi

exits 0 'a page is written' "$WEFT" "a <b> & c.knit" -q -o page.html
cp page.html once.html
exits 0 'and again' "$WEFT" "a <b> & c.knit" -q -o page.html
check 'the same bytes' cmp once.html page.html
check 'the title is the file' grep -Fx 'a &#60;b> &#38; c.knit' page.html
printf 'swatch tile(beside(K, P), 2, 4)\nsolve { steps = 101; accuracy = 50%%; tolerance = 0.001 }\n' >many.knit
exits 0 'one of many steps' "$WEFT" many.knit -q -o many.html
check 'data end no script' test "$(grep -c '</script>' page.html)" = 2

# The size depends on stitches, steps and the folded shape, little on how closely it is solved.
cat >miura.knit <<'KNIT'
use miura from std
swatch tile(miura, 4, 4)
solve { steps = 10; accuracy = 50%; tolerance = 0.001 }
output "miura.html"
KNIT
"$WEFT" miura.knit -q >/dev/null 2>&1
check 'the Miura swatch with ten steps is under 3 MB' \
    awk -v size="$(wc -c <miura.html)" 'BEGIN { exit !(size > 1e6 && size < 3e6) }'

browser=$(command -v chromium || command -v chromium-browser || command -v google-chrome) || browser=
if ! command -v node >/dev/null 2>&1 || [ ! -d "$WEFT_SOURCE/viewer/node_modules/playwright-core" ]; then
    skip 'in a browser' 'no playwright-core (npm)'
elif ! node -e 'process.exit(parseInt(process.versions.node, 10) < 20 ? 1 : 0)'; then
    skip 'in a browser' "playwright-core needs Node 20, this is $(node --version)"
elif [ -z "$browser" ]; then
    skip 'in a browser' 'no chromium'
else
    mkdir "$work/tmp"           # where the browser keeps what it goes by
    TMPDIR=$work/tmp node "$WEFT_SOURCE/tests/page/browser.js" "$browser" "$work/page.html" "$WEFT_SOURCE/viewer" \
        "$work/many.html" \
        >"$work/tests" 2>"$work/trouble" </dev/null
    while read -r result name; do
        case $result in
            pass) pass "$name" ;;
            fail) fail "$name" ;;
            *) echo "# $result $name" ;;
        esac
    done <"$work/tests"
    check 'all of it was tried' grep -qx 'done' "$work/tests"
    check 'no browser is left behind' sh -c '! pgrep -f "$1"' - "$work/tmp/[p]laywright"
    sed 's/^/# /' "$work/trouble"
fi
finish
