#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The command line itself: what is not understood is said, with the nearest that is.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

printf 'Cast on 4 sts\nRow 1: *k2, p2; rep from * to end\n' >"$work/rib.knit"

# wrong NAME PATTERN ARGUMENT...: exit status 2, nothing on stdout, a reason.
wrong() {
    what=$1
    pattern=$2
    shift 2
    exits 2 "$what" "$WEFT" "$@"
    err "$what: says why" "$pattern"
    empty "$what: prints no result" "$work/out"
}

wrong 'no argument at all' 'FILE or a COMMAND is wanted'
wrong 'an unknown command' "no command or file 'chrat'; did you mean chart?" chrat x.knit
wrong 'a command that is like no other' "no command or file 'wxyz'" wxyz
wrong 'an unknown option' "unknown option '--stepps'; did you mean --steps?" run "$work/rib.knit" --stepps 3
wrong 'an unknown option with a value' "unknown option '--acuracy'; did you mean --accuracy?" "$work/rib.knit" --acuracy=1%
wrong 'an unknown letter' "unknown option '-z'" check -z "$work/rib.knit"
wrong 'an option of another command' 'check has no option --steps (it belongs to: run sweep)' check --steps 3 "$work/rib.knit"
wrong 'an option without its value' '--seed wants a value' "$work/rib.knit" --seed
wrong 'a value for an option that takes none' '--quiet takes no value' "$work/rib.knit" --quiet=yes
wrong 'run without a file' 'run wants a FILE' run
wrong 'run with two files' 'run takes no further operand' run "$work/rib.knit" "$work/rib.knit"
wrong 'a definition without a value' "-D takes name=value, not 'half'" "$work/rib.knit" -D half
wrong 'a definition without a name' "-D takes name=value, not '=3'" "$work/rib.knit" -D =3
wrong 'a number of threads that is none' "-j takes a number of threads from 1 to 1024, not 'two'" "$work/rib.knit" -j two
wrong 'no threads' 'from 1 to 1024' "$work/rib.knit" -j0
wrong 'a word that is not a choice' '--color takes one of: auto always never' "$work/rib.knit" --color sometimes
wrong 'part of a choice' '--diagnostics takes one of: human json' check --diagnostics js "$work/rib.knit"
wrong 'a warning level that is not there' '-W takes one of: error' check -W none "$work/rib.knit"
wrong 'help on a command that is not there' "no command 'knit'" help knit
wrong 'help on one that is misspelt' 'did you mean chart?' help chrat
wrong 'a chart in a format that is not there' 'a chart is written as .svg' chart "$work/rib.knit" -o "$work/x.gif"

exits 0 'letters in one word' "$WEFT" check -qWerror "$work/rib.knit"
exits 0 'options after the file' "$WEFT" check "$work/rib.knit" -q
exits 0 'options before the command' "$WEFT" -q check "$work/rib.knit"
exits 0 'operands after --' "$WEFT" check -q -- "$work/rib.knit"

exits 0 'help' "$WEFT" help
out 'help names the commands' '^  chart  *FILE'
for command in '' run check chart params list version help; do
    # shellcheck disable=SC2086
    exits 0 "help $command" "$WEFT" help $command
    check "help $command fits 80 columns" awk 'length > 79 { print; bad = 1 } END { exit bad }' "$work/out"
done
cp "$work/out" "$work/help"
exits 0 'help by option' "$WEFT" help --help
exits 0 'run --help' "$WEFT" run --help
out 'run --help explains options' '--per-stitch N'
exits 0 '--help without a command' "$WEFT" --help
out '--help is the overview' '^Commands:'

exits 0 'version' "$WEFT" version
out 'version is one line' '^weft [0-9.]*$'
exits 0 '--version' "$WEFT" --version
exits 0 'version as JSON' "$WEFT" version --json
cp "$work/out" "$work/version.json"
check 'version as JSON: schema' test "$(tests/cli/json "$work/version.json" schema)" = 1

finish
