#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# manpage.sh WEFT TEMPLATE: the man page on standard output, its commands and
# options as `weft help` explains them.
set -eu
LC_ALL=C
export LC_ALL
weft=$1
template=$2

commands() {
    "$weft" help | sed -n '/^Commands:/,/^$/p' | sed '1d; /^$/d; s/^ *\([a-z]*\).*/\1/'
}

# Between the usage line and the options: what a command does.  Indented lines
# are kept as they are.
about() {
    "$weft" help "$1" | awk '
        function plain(text) {
            gsub(/\\/, "\\e", text)
            gsub(/-/, "\\-", text)
            return text ~ /^[.\047]/ ? "\\&" text : text
        }
        NR == 1 { sub(/^Usage: weft /, ""); sub(/ *\[OPTION\]\.\.\.$/, ""); print ".TP\n.B " plain($0); next }
        /^Options:/ { exit }
        /^  / && !kept { print ".sp\n.in 0\n.nf"; kept = 1 }
        !/^  / && kept { print ".fi\n.in"; kept = 0 }
        /^  / { print plain(substr($0, 3)); next }
        NF { print plain($0) }
        END { if (kept) print ".fi\n.in" }'
}

# Each option once, in the order of the table.
options() {
    for command in $(commands); do
        "$weft" help "$command" | sed -n '/^Options:/,$p' | sed 1d
    done | awk '
        function plain(text) {
            gsub(/-/, "\\-", text)
            return text
        }
        seen[$0]++ { next }
        {
            words = substr($0, 1, 29)
            sub(/^ +/, "", words)
            sub(/ +$/, "", words)
            text = substr($0, 31)
            print ".TP\n.B " plain(words) "\n" (text ~ /^\047/ ? "\\&" : "") plain(text)
        }'
}

version=$("$weft" version | sed -n '1s/^weft //p')
while IFS= read -r line; do
    case $line in
        @COMMANDS@) for command in $(commands); do about "$command"; done ;;
        @OPTIONS@) options ;;
        *) printf '%s\n' "$line" | sed "s/@VERSION@/$version/" ;;
    esac
done <"$template"
