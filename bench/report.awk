# SPDX-License-Identifier: GPL-3.0-or-later
# weft's JSON report in, one "energy.total 2.68" a line out; of a list, its last entry.
{ gsub(/^[ \t]+|,$/, "") }
/^"[^"]*":[ \t]*[\[{]+$/ { match($0, /^"[^"]*"/); path[depth++] = substr($0, 2, RLENGTH - 2); next }
/^}, {/                  { next }
/^[]}]/                  { depth--; next }
/^"/ {
    match($0, /^"[^"]*"/)
    name = substr($0, 2, RLENGTH - 2)
    value = substr($0, RLENGTH + 2)
    gsub(/^[ \t]+|"/, "", value)
    where = ""
    for (i = 0; i < depth; i++)
        where = where path[i] "."
    print where name, value
}
