#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# bootstrap where nothing may be installed: what it says, and that it does no
# work before it knows what is wanted.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

bootstrap=$WEFT_SOURCE/bootstrap
exits 2 'no command' "$bootstrap"
err 'gives the usage' '^Usage: ./bootstrap run FILE'
exits 2 'an unknown command' "$bootstrap" rnu
exits 2 'run without a file' "$bootstrap" run
exits 0 'help' "$bootstrap" --help
out 'gives the usage on standard output' 'bootstrap check'

# A machine with a shell and little else: Debian without our packages, and no right to install.
mkdir "$work/tree" "$work/bin"
cp "$bootstrap" "$work/tree/"
for tool in sh env dirname mktemp rm tail cat grep sed awk; do
    ln -s "$(command -v $tool)" "$work/bin/$tool"
done
printf '#!/bin/sh\nexit 1\n' >"$work/bin/dpkg-query"
printf '#!/bin/sh\necho 1000\n' >"$work/bin/id"
printf '#!/bin/sh\nexit 1\n' >"$work/bin/sudo"
printf '#!/bin/sh\necho touched >%s/apt\n' "$work" >"$work/bin/apt-get"
chmod +x "$work/bin/dpkg-query" "$work/bin/id" "$work/bin/sudo" "$work/bin/apt-get"

exits 1 'without packages or rights' env PATH="$work/bin" "$work/tree/bootstrap" build
err 'names the packages' 'missing.*: gcc .*libsuitesparse-dev .*libmd-dev'
err 'says what to do' 'as root: apt-get install gcc'
err 'stops' 'autoreconf is missing'
check 'does not try to install' test ! -e "$work/apt"
exits 1 'and for the tests' env PATH="$work/bin" "$work/tree/bootstrap" check
check 'says it once' test "$(grep -c 'as root:' "$work/err")" = 1

rm "$work/bin/dpkg-query"
exits 1 'on another system' env PATH="$work/bin" "$work/tree/bootstrap" build
err 'says so' 'not Debian or Ubuntu'
err 'names what is needed' 'autoreconf is missing; needed are: gcc make'

finish
