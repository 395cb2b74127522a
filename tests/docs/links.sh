#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Links between the documents lead to a file and a heading that are there; so
# do those of the HTML, where pandoc made it.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

# Headings as anchors: small letters, blanks as dashes, other signs dropped.
anchors() {
    awk '/^```/ { inside = !inside } /^#+ / && !inside {
        sub(/^#+ /, "")
        text = tolower($0)
        gsub(/[^a-z0-9 _-]/, "", text)
        gsub(/ /, "-", text)
        print text
    }' "$1"
}

# What is between `](` and `)` outside of code.
links() {
    awk '/^```/ { inside = !inside; next } !inside { gsub(/`[^`]*`/, ""); print }' "$1" |
        grep -o '\]([^)]*)' | sed 's/^](//; s/)$//'
}

leads_somewhere() {
    link=$1
    path=${link%%#*}
    [ -n "$path" ] && target=$(dirname "$document")/$path || target=$document
    [ -e "$target" ] || return 1
    case $link in
        *'#'*) anchors "$target" | grep -qxF -e "${link#*#}" ;;
    esac
}

for document in "$WEFT_SOURCE"/README.md "$WEFT_SOURCE"/CONTRIBUTING.md "$WEFT_SOURCE"/docs/*.md; do
    links "$document" >"$work/links"
    while read -r link; do
        case $link in
            http://* | https://*) continue ;;
        esac
        check "${document#"$WEFT_SOURCE/"}: $link" leads_somewhere "$link"
    done <"$work/links"
done

# The chapters are all in the table of contents.
for document in "$WEFT_SOURCE"/docs/*.md; do
    name=$(basename "$document")
    [ "$name" = index.md ] || check "index.md links to $name" grep -qF "]($name)" "$WEFT_SOURCE/docs/index.md"
done

html=${WEFT%/*}/docs/html
if [ -f "$html/index.html" ]; then
    for page in "$html"/*.html; do
        grep -Eo '(href|src)="[^"#]*' "$page" | sed 's/^[a-z]*="//; /^$/d; /^https*:/d; /^mailto:/d' | sort -u >"$work/links"
        while read -r link; do
            check "html/$(basename "$page"): $link" test -e "$html/$link"
        done <"$work/links"
    done
else
    skip 'links of the HTML' 'not built (make docs)'
fi
finish
