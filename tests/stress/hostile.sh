#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Files that are no pattern, as every kind that is read: an error with its place,
# soon (measured: 0.6 s of processor at most), in little memory, and no crash.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

mkdir "$work/files"
cd "$work/files" || exit 1
ten_million() { head -c 10000000 /dev/zero | tr '\000' "$1"; }

# ---- broken ----

: >empty
printf '\357\273\277' >mark
printf '\377\376k\0p\0' >of_two_bytes
printf '\0\0\0\0' >nothing_but_nul
printf 'kkpp\0kkpp\nkkpp\n' >nul_inside
head -c 65536 /bin/sh >program
printf 'x' >letter
printf ';\n' >semicolon
printf '\n\r\n\r\n' >empty_lines
printf '# -1 -1\nkp\n' >negative

# ---- numbers ----

printf 'Cast on 99999999999999999999 sts\nRow 1: knit\n' >cast_on
printf 'Cast on 4 sts\nRow 2147483648: k4\n' >row_number
printf 'Cast on 4 sts\nRow 1: k99999999999999999999\n' >count
printf 'Cast on {1e999} sts\nRow 1: k{1e999}\n' >endless
printf 'Cast on 4 sts\nRows 1-999999999: knit\n' >rows
printf 'Cast on 4 sts\nRow 1: knit\nRepeat row 1 999999999 times\n' >again
{ printf 'Row 1: '; for i in 1 2 3 4 5 6 7 8; do printf '('; done; printf 'k2'
  for i in 1 2 3 4 5 6 7 8; do printf ') 99 times'; done; printf '\n'; } >grows
printf '# 99999999999 99999999999\nKP\n' >header
knitout() { printf ';!knitout-2\n;;Carriers: 1\nin 1\n%s\n' "$1"; }
knitout 'knit + f99999999999999999999 1' >needle
knitout 'knit + f-2147483648 1' >negative_needle
printf ';!knitout-99999999999\n' >knitout_version
picture() { printf '\211PNG\r\n\032\n\0\0\0\rIHDR'"$1"; }
picture '\177\377\377\377\177\377\377\377\10\2\0\0\0\233\253\234\061' >picture_of_limits
picture '\0\17\102\100\0\0\0\5\10\2\0\0\0\206\056\102\011' >picture_too_wide
picture '\0\0\0\0\0\0\0\0\10\2\0\0\0\264\351\353\105' >picture_of_nothing
picture '\0\0\7\320\0\0\7\320\10\2\0\0\0\025\132\123\056' >picture_cut
picture '\0\0\7\320\0\0\7\320\10\2\0\0\0\0\0\0\0' >picture_damaged

# ---- much ----

{ printf 'Row 1: '; ten_million k; } >long_line
{ printf 'Row 1: '; ten_million '('; } >open_line
ten_million '\n' >line_ends
yes 'k,p;' | head -c 10000000 >wrong_lines

# ---- as every kind ----

# Runs weft with so much memory and processor time at most, on a busy machine
# so long; the address sanitizer needs more than any limit, and ten times as long.
memory=1500000 seconds=10
{ (ulimit -v "$memory"; "$WEFT" version) || memory=unlimited seconds=100; } >/dev/null 2>&1
limited() { (ulimit -v "$memory"; ulimit -t "$seconds"; exec timeout $((20 * seconds)) "$WEFT" "$@"); }

now() { date +%s%3N; }

# refused FILE STATUS WORDS...: weft ends with one of these and says where the error is.
refused() {
    file=$1
    wanted=$2
    shift 2
    begun=$(now)
    status=0
    limited "$@" >"$work/out" 2>"$work/err" </dev/null || status=$?
    took=$(($(now) - begun))
    [ "$took" -le "$longest" ] || longest=$took
    case $wanted:$status in
        *0*:0 | *1*:1) return ;;
        *:3) head -n 1 "$work/err" | grep -q '^[^ ]*:[0-9]*:[0-9]*: error: ' && return ;;
    esac
    echo "$file: weft $*: exit status $status: $(head -c 200 "$work/err")" >>"$work/wrong"
}

mkdir "$work/as"
for file in *; do
    longest=0
    for kind in png k csv ks txt; do
        ln "$file" "$work/as/x.$kind"
        refused "$file" 3 import "$work/as/x.$kind" -o "$work/as/made.knit"
    done
    printf 'use "x.csv" as x\nswatch x\n' >"$work/as/use.knit"
    refused "$file" 3 check "$work/as/use.knit"
    ln "$file" "$work/as/x.knit"
    refused "$file" 013 fmt --check "$work/as/x.knit"      # the language may be right
    refused "$file" 3 run "$work/as/x.knit" -o "$work/as/made.stl"
    [ ! -e "$work/as/made.knit" ] && [ ! -e "$work/as/made.stl" ] || echo "$file: something is written" >>"$work/wrong"
    touch "$work/wrong"
    empty "$file ($longest ms)" "$work/wrong"
    rm -r "$work/as" "$work/wrong"
    mkdir "$work/as"
done

finish
