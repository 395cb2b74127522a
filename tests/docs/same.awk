# SPDX-License-Identifier: GPL-3.0-or-later
# same.awk EXPECTED PRINTED: whether the second file is as the first says.  A
# line of `...` stands for any lines; numbers with a point may differ by 2 %.
function clean(text) {
    sub(/[ \t]+$/, "", text)
    return text
}

function is_number(word) { return word ~ /^-?[0-9]+\.[0-9]+$/ }

function word_fits(want, got,   difference) {
    if (want == got)
        return 1
    if (!is_number(want) || !(got ~ /^-?[0-9]+(\.[0-9]+)?(e[-+]?[0-9]+)?$/))
        return 0
    difference = want - got
    return difference * difference <= (0.02 * want) ^ 2
}

# Blanks count where the line has no number that may differ.
function line_fits(want, got,   a, b, n, i) {
    if (want == got)
        return 1
    n = split(want, a, /[ ,;]+/)
    if (n != split(got, b, /[ ,;]+/) || !(want ~ /[0-9]\.[0-9]/))
        return 0
    for (i = 1; i <= n; i++)
        if (!word_fits(a[i], b[i]))
            return 0
    return 1
}

FNR == NR { want[++nwant] = clean($0); next }
{ got[++ngot] = clean($0) }
END {
    for (i = j = 1; i <= nwant; i++) {
        if (want[i] == "...") {
            if (i == nwant)
                exit 0
            while (j <= ngot && !line_fits(want[i + 1], got[j]))
                j++
            continue
        }
        if (j > ngot || !line_fits(want[i], got[j])) {
            print "expected: " want[i]
            print "printed:  " (j > ngot ? "nothing more" : got[j])
            exit 1
        }
        j++
    }
    if (j <= ngot) {
        print "not expected: " got[j]
        exit 1
    }
}
