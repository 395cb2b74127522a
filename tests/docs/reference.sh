#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The language reference names every statement, function, key and limit there
# is, and states the defaults and ranges that the program has.
. "${WEFT_SOURCE:-.}/tests/tap.sh"
reference=$WEFT_SOURCE/docs/language.md

# names NAME PATTERN: a row of a table or a heading has it.
names() { check "$1" grep -Eq -e "$2" "$reference"; }

sed -n '/^static const struct builtin builtins/,/^};/s/^ *{"\([a-z]*\)".*/\1/p' "$WEFT_SOURCE/lang/builtin.c" >"$work/functions"
check 'functions were found' test "$(wc -l <"$work/functions")" -gt 20
while read -r function; do
    names "function $function" "^\| .*\`$function\("
done <"$work/functions"

# {"gauge", "width", "length", KEY_NUMBER, 1, 1e-6, 1e6, false, 1.4, NULL, ...
sed -n 's/^ *{"\([a-z]*\)", "\([a-z_]*\)", "[^"]*", KEY_\([A-Z_]*\), [01], \([^,]*\), \([^,]*\), [a-z]*, \([^,]*\), \([^,]*\),.*/\1 \2 \3 \4 \5 \6 \7/p' \
    "$WEFT_SOURCE/lang/settings.c" >"$work/keys"
check 'keys were found' test "$(wc -l <"$work/keys")" = "$(grep -c '^    {"' "$WEFT_SOURCE/lang/settings.c")"
while read -r block key kind low high number word; do
    row=$(grep -E "^\| \`$block\` *\| \`$key\` " "$reference" || :)
    check "$block.$key" test -n "$row"
    case $word in
        NULL) default=$number ;;
        *) default=$(echo "$word" | tr -d '"') ;;
    esac
    case $kind in SEED) continue ;; esac
    [ "$default" != 0.01 ] || default='(0.01|1%)'
    check "$block.$key: default $default" sh -c 'printf "%s" "$1" | grep -Eq "\| $2 +\|"' - "$row" "$default"
    case $kind in
        NUMBER | WHOLE)
            check "$block.$key: range" sh -c 'printf "%s" "$1" | grep -qF -e "$2" && printf "%s" "$1" | grep -qF -e "$3"' - "$row" "$low" "$high"
            ;;
    esac
done <"$work/keys"

sed -n '/output_keys\[\] = {/,/^};/s/.*\.name = "\([a-z_]*\)".*/\1/p' "$WEFT_SOURCE/lang/outputs.c" | sort -u >"$work/output_keys"
check 'keys of outputs were found' test "$(wc -l <"$work/output_keys")" -gt 5
while read -r key; do
    check "output key $key" grep -Eq -e "^\| .*\`$key\`" "$WEFT_SOURCE/docs/formats.md"
done <"$work/output_keys"

sed -n '/^const char \*const statement_word/,/^};/p' "$WEFT_SOURCE/lang/syntax_errors.c" | grep -o '"[a-z]*"' | tr -d '"' >"$work/words"
check 'words of statements were found' test "$(wc -l <"$work/words")" -gt 20
while read -r word; do
    names "statement $word" "^(#|\|).*\`([a-z ]* )?$word[ .\`]"
done <"$work/words"
finish
