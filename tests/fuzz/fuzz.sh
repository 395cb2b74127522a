#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# fuzz.sh FOLDER TARGET..: builds the readers with coverage, fuzzes each target for
# FUZZ_SECONDS and says how many inputs were tried. Called by `make fuzz`.
set -eu
folder=$1
shift
mkdir -p "$folder/objects"
sh "$WEFT_SOURCE/tests/fuzz/seeds.sh" "$folder/seeds"

# A header that changed makes everything anew.
for file in $FUZZ_SOURCES; do
    [ -f "$file" ] || file=$WEFT_SOURCE/$file
    case $file in
    *.h) [ "$folder/objects/built" -nt "$file" ] || rm -f "$folder"/objects/* ;;
    esac
done

objects=
for file in $FUZZ_SOURCES; do
    case $file in
    *.h) continue ;;
    esac
    object=$folder/objects/$(echo "$file" | tr / _).o
    [ -f "$file" ] || file=$WEFT_SOURCE/$file
    objects="$objects $object"
    # shellcheck disable=SC2086
    [ "$object" -nt "$file" ] || $FUZZ_CC -std=gnu11 $FUZZ_FLAGS -fsanitize=fuzzer-no-link $FUZZ_CPPFLAGS -c -o "$object" "$file"
done
touch "$folder/objects/built"

failed=0
for target; do
    # shellcheck disable=SC2086
    $FUZZ_CC -std=gnu11 $FUZZ_FLAGS -fsanitize=fuzzer $FUZZ_CPPFLAGS -DFUZZ_TARGET="\"$target\"" \
        -o "$folder/$target" "$WEFT_SOURCE/tests/fuzz/entry.c" $objects $FUZZ_LIBS
    mkdir -p "$folder/corpus/$target"
    echo "fuzzing $target for $FUZZ_SECONDS s"
    "$folder/$target" -max_total_time="$FUZZ_SECONDS" -max_len=4096 -timeout=5 -rss_limit_mb=2048 \
        -dict="$WEFT_SOURCE/tests/fuzz/words.dict" -artifact_prefix="$folder/$target-" -print_final_stats=1 \
        "$folder/corpus/$target" "$folder/seeds/$target" >"$folder/$target.log" 2>&1 || failed=1
    grep -E 'stat::number_of_executed_units|^SUMMARY|ERROR' "$folder/$target.log" || :
done
[ $failed = 0 ] || echo "what broke a target is in $folder; keep it as tests/fuzz/found/TARGET-what" >&2
exit $failed
