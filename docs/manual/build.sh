#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# build.sh WEFT OUT CHAPTER...: the manual as pages, one for each chapter (a .md
# one folder up), into the folder OUT. Pictures of motifs stand in OUT/stitches.
set -eu
weft=$1
out=$2
shift 2
here=$(dirname "$0")/..
version=$("$weft" version | sed -n '1s/^weft //p')

title() { sed -n 's/^# //p' "$here/$1.md" | head -n 1; }

# The list of chapters, the page's own marked.
chapters() {
    echo '<ul>'
    for chapter in "$@"; do
        here_mark=
        [ "$chapter" != "$current" ] || here_mark=' aria-current="page"'
        class=
        [ "$chapter" != index ] || class=' class="name"'
        echo "<li><a$class href=\"$chapter.html\"$here_mark>$(title "$chapter")</a></li>"
    done
    echo '</ul>'
}

mkdir -p "$out"
cp "$here/manual/style.css" "$out"
for current in "$@"; do
    home=
    [ "$current" != index ] || home='--variable home=yes'
    # shellcheck disable=SC2086
    pandoc --from gfm --to html5 --no-highlight --wrap=preserve --lua-filter "$here/manual/filter.lua" \
        --template "$here/manual/template.html" --metadata pagetitle="$(title "$current")" --metadata pictures="$out/stitches" \
        --variable version="$version" --variable chapters="$(chapters "$@")" $home \
        "$here/$current.md" --output "$out/$current.html"
done
[ ! -d "$here/plots" ] || { mkdir -p "$out/plots" && cp "$here"/plots/* "$out/plots/"; }
