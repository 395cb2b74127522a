#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# The pictures of the README: the paper's seven swatches, chart beside fold, in
# docs/figures.  `make figures` calls it from the source folder with weft's path.
set -eu
weft=$1

for name in miura chains columns peaks squiggles bars weave; do
    {
        grep -v '^output' "examples/$name.knit"
        echo "output picture \"docs/figures/$name.png\" { chart = on; width = 700 }"
    } | "$weft" -q --no-manifest --steps 1 --accuracy 5% -
done
