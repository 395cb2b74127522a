#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# All points of a sweep by GNU parallel, then its table.
#
#     sh parallel.sh FILE [OPTION of weft sweep]...
#
# PARALLEL holds options for parallel, like --jobs 8, or --sshloginfile hosts
# --workdir . where the folder is shared.  Again, it runs what is not done.
set -eu
weft=${WEFT:-weft}

# A point that fails is in the table; what counts is whether all of them are good.
"$weft" sweep "$@" --print | parallel || true
"$weft" sweep "$@" --collect
