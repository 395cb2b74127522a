#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The page's bundle where npm is missing or its registry out of reach: the build
# goes on and says what is lost.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

mkdir "$work/viewer" "$work/bin"
cp "$WEFT_SOURCE/viewer/make.sh" "$WEFT_SOURCE/viewer/package-lock.json" "$work/viewer/"
for tool in sh dirname mktemp rm tail touch; do
    ln -s "$(command -v $tool)" "$work/bin/$tool"
done
exits 0 'without npm the build goes on' env PATH="$work/bin" sh "$work/viewer/make.sh"
err 'says what is lost' 'output "x.html" will not be possible: npm is missing'
check 'leaves an empty page' test -f "$work/viewer/template.html" -a ! -s "$work/viewer/template.html"

printf '#!/bin/sh\necho no way to the registry >&2\nexit 1\n' >"$work/bin/npm"
cp "$work/bin/npm" "$work/bin/node"
chmod +x "$work/bin/npm" "$work/bin/node"
rm -f "$work/viewer/template.html"
exits 0 'without the registry, too' env PATH="$work/bin" sh "$work/viewer/make.sh"
err 'shows what npm said' 'no way to the registry'
err 'says how to try again' 'to try again: rm viewer/template.html'
check 'leaves an empty page' test -f "$work/viewer/template.html" -a ! -s "$work/viewer/template.html"

mkdir "$work/viewer/node_modules"
echo '{}' >"$work/viewer/node_modules/.package-lock.json"
touch -d '2000-01-01' "$work/viewer/package-lock.json"
exits 1 'a mistake in the sources is an error' env PATH="$work/bin" sh "$work/viewer/make.sh"
check 'the lock names no registry' sh -c "! grep -q '\"resolved\"' '$WEFT_SOURCE/viewer/package-lock.json'"

# An empty page in the binary: embed.awk gives an empty table, a quoted one gives C.
printf 'a "b" \\n ??(\n' >"$work/text"
check 'lines become C strings' sh -c "awk -f '$WEFT_SOURCE/viewer/embed.awk' '$work/text' | grep -F '\"a \\\"b\\\" \\\\n \\?\\?(\",'"

# ---- a weft without the page ----

without=$PWD/tests/page/without
cd "$work" || exit 1
cat >rib.knit <<'KNIT'
Cast on 4 sts
Row 1: k2, p2
output "rib.html"
output "rib.txt"
KNIT
exits 0 'a script that asks for the page is good' "$without" rib.knit
err 'and says what it goes without' "^rib.knit:3: warning: this weft cannot write the page 'rib.html': npm"
out 'the rest is written' '^wrote rib.txt'
check 'and no page' test ! -e rib.html
exits 3 'with -W error it is an error' "$without" -W error rib.knit
err 'as it says' '^rib.knit:3: error: this weft cannot write the page'
exits 2 'as on the command line' "$without" -q rib.knit -o other.html
err 'with the reason' "^weft: -o other.html: this weft cannot write the page 'other.html': npm"

finish
