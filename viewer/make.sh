#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The page's sources beside this script in, template.html beside it out: whole,
# or empty with a word on what is lost. Never fails for want of npm.
cd "$(dirname "$0")" || exit 1
log=$(mktemp) || exit 1
trap 'rm -f "$log" template.new' EXIT

lost() {
    echo "weft: output \"x.html\" will not be possible: $1" >&2
    : >template.html
    exit 0
}

command -v node >/dev/null 2>&1 && command -v npm >/dev/null 2>&1 ||
    lost 'npm is missing (a release tarball has the page ready-made)'

# What is there already is not fetched again.
if [ ! node_modules/.package-lock.json -nt package-lock.json ]; then
    npm ci --prefer-offline --fetch-retries=1 --fetch-timeout=60000 --loglevel=error >"$log" 2>&1 </dev/null || {
        tail -n 5 "$log" >&2
        lost 'npm could not get three.js and esbuild; to try again: rm viewer/template.html'
    }
    touch node_modules/.package-lock.json
fi

# A mistake in our own sources is an error.
node build.js template.new || exit 1
mv template.new template.html
