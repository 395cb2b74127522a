#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# make install puts all in its place below DESTDIR; make uninstall takes it away.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

build=$(dirname "$WEFT")
unset MAKEFLAGS MAKELEVEL DESTDIR
exits 0 'make install' make -C "$build" install DESTDIR="$work/root" prefix=/usr
exits 0 'and once more' make -C "$build" install DESTDIR="$work/root" prefix=/usr
for file in bin/weft share/man/man1/weft.1 share/bash-completion/completions/weft share/zsh/site-functions/_weft \
    share/weft/editors/knit.tmLanguage.json share/vim/vimfiles/syntax/knit.vim share/vim/vimfiles/ftdetect/knit.vim \
    share/weft/stdlib/ribs.knit share/weft/examples/rib.knit; do
    check "$file is there" test -f "$work/root/usr/$file"
done
exits 0 'the installed weft runs' "$work/root/usr/bin/weft" list rib
check 'nothing is written elsewhere' test "$(ls "$work/root")" = usr
exits 0 'make uninstall' make -C "$build" uninstall DESTDIR="$work/root" prefix=/usr
check 'leaves nothing' test -z "$(find "$work/root" ! -type d)"

finish
