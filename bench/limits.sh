#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The machine's peaks and what each stage reaches of them, on a sheet the size of the full Miura.
. "${srcdir:-.}/bench/lib.sh"
./bench/limits >"$results/limits.csv"
cat "$results/limits.csv" >&2
