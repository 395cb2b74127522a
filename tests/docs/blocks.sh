#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The code blocks of the manual and the README do what the text says.
#
#   ```knit [NAME]   `weft check` finds no fault with it; it stays as NAME for the blocks behind it
#   ```knit bad.knit has the message whose code is in the heading above (docs/errors.md)
#   ```sh            runs, with weft on the PATH, in one folder for each document
#   ```sh bad        runs into the message whose code is in the heading above
#   ```text          what the block before it prints; a line of `...` stands for any lines,
#                    and numbers with a point may differ by 2 %
#   ```              and other words: to read only
. "${WEFT_SOURCE:-.}/tests/tap.sh"
PATH=$(dirname "$WEFT"):$PATH
tests=$WEFT_SOURCE/tests/docs

# A heading's code says what a bad block runs into.
bad() {
    if grep -q "\[$code\]" "$work/out"; then
        pass "$where: $code"
    else
        fail "$where: $code"
        sed 's/^/# /' "$work/out"
    fi
}

# What was printed against the text behind the block.
printed() {
    if awk -f "$tests/same.awk" "$blocks/$number.expected" "$work/out" >"$work/differs"; then
        pass "$where"
    else
        fail "$where"
        sed 's/^/# /' "$work/differs"
    fi
}

# A block without an expected text ends well; a script is silent, too.
ends_well() {
    if [ "$status" = 0 ] && { [ "$language" = sh ] || [ ! -s "$work/err" ]; }; then
        pass "$where"
    else
        fail "$where (exit status $status)"
        sed 's/^/# /' "$work/out"
    fi
}

run() {
    status=0
    if [ "$language" = knit ]; then
        [ "$name" != - ] || name=block.knit
        cp "$blocks/$number" "$folder/$name"
        (cd "$folder" && weft check "$name" >"$work/checked" 2>"$work/err") || status=$?
        cat "$work/err" "$work/checked" >"$work/out"
    else
        (cd "$folder" && sh -e "$blocks/$number" >"$work/out" 2>&1 </dev/null) || status=$?
    fi
    case $name in
        bad*) bad ;;
        *) if [ -f "$blocks/$number.expected" ]; then printed; else ends_well; fi ;;
    esac
}

for document in "$WEFT_SOURCE"/README.md "$WEFT_SOURCE"/docs/*.md; do
    title=${document#"$WEFT_SOURCE/"}
    blocks=$work/blocks.$(basename "$document")
    folder=$work/folder.$(basename "$document")
    mkdir -p "$blocks" "$folder"
    ln -s "$(cd "$WEFT_SOURCE" && pwd)/examples" "$folder/examples"
    awk -v folder="$blocks" -f "$tests/blocks.awk" "$document" >"$blocks/list" || fail "$title: its blocks"
    while read -r number language name line code; do
        where=$title:$line
        run
    done <"$blocks/list"
done
finish
