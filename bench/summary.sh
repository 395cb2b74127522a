#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# Each bar, what the tables say of it, and whether it is met.
. "${srcdir:-.}/bench/lib.sh"

# Seconds to one percent on the way from one mesh to the next (log-log), or the last run's where none got there.
awk -F, '
    NR == 1 || ($9 == "" && $18 != "time limit") { next }
    { key = $1 " " $2 " " $4 " " $5 }
    key in done { next }
    $18 == "time limit" { if (key in seconds) { most[key] = seconds[key]; bound[key] = $14 }; done[key]; next }
    $9 <= 0.01 {
        if (key in error && error[key] > 0.01) {
            part = (log(error[key]) - log(0.01)) / (log(error[key]) - log($9))
            to[key] = exp(log(seconds[key]) + part * (log($14) - log(seconds[key])))
        } else
            to[key] = $14
        done[key]
        next
    }
    { error[key] = $9; seconds[key] = $14 }
    END {
        n = split("miura 100 miura_2x2 300", bar, " ")
        for (i = 1; i < n; i += 2) {
            mine = to[bar[i] " patch auto 10"]
            base = bar[i] " triangle lbfgs 10"
            if (base in to)
                printf "1 %% on %s: default %.2f s, baseline %.1f s: %.0f times (bar %d): %s\n", bar[i], mine, to[base], to[base] / mine,
                    bar[i + 1], (to[base] >= bar[i + 1] * mine ? "met" : "missed")
            else if (base in seconds)
                printf "1 %% on %s: default %.2f s, baseline %.1f s at an error of %.2f %%%s: at least %.0f times (bar %d): %s\n", bar[i], mine,
                    seconds[base], 100 * error[base], (base in bound ? ", the next mesh cut off at " bound[base] " s" : ""),
                    seconds[base] / mine, bar[i + 1], (seconds[base] >= bar[i + 1] * mine ? "met" : "not shown")
        }
    }' "$results/accuracy.csv" 2>/dev/null || :

awk -F, '
    NR > 1 && $6 <= 1e-6 { key = $1 ":" $2 ":" $3; if (!((key, $4) in t)) { t[key, $4] = $11; keys[key] = 1 } }
    END {
        for (key in keys) {
            least = t[key, "plbfgs"] < t[key, "newton"] ? t[key, "plbfgs"] : t[key, "newton"]
            if (least > 0 && t[key, "lbfgs"] > 0)
                printf "to a gradient of 1e-6 on %s: plain %.2f s, preconditioned %.2f s, Newton %.2f s: %.1f times (bar 10): %s\n", key,
                    t[key, "lbfgs"], t[key, "plbfgs"], t[key, "newton"], t[key, "lbfgs"] / least,
                    (t[key, "lbfgs"] >= 10 * least ? "met" : "missed")
        }
    }' "$results/gradient.csv" 2>/dev/null | sort || :

# Exponents by least squares in the logarithms, from a thousand stitches on.
awk -F, '
    NR > 1 && $4 >= 1000 && $8 > 0 {
        x = log($4); n[$1]++; sx[$1] += x; sxx[$1] += x * x
        st[$1] += log($8); sxt[$1] += x * log($8); sm[$1] += log($10); sxm[$1] += x * log($10)
        si[$1] += log($8 / $6); sxi[$1] += x * log($8 / $6)
    }
    END {
        for (s in n) {
            d = n[s] * sxx[s] - sx[s] ^ 2
            if (n[s] > 1) {
                e = (n[s] * sxt[s] - sx[s] * st[s]) / d
                printf "scaling of %s: time n^%.2f (bar 1.5: %s), an iteration n^%.2f, memory n^%.2f (n log n: about 1.1)\n", s, e,
                    (e <= 1.5 ? "met" : "missed"), (n[s] * sxi[s] - sx[s] * si[s]) / d, (n[s] * sxm[s] - sx[s] * sm[s]) / d
            }
        }
    }' "$results/scaling.csv" 2>/dev/null | sort || :

awk -F, 'NR > 1 { n += 2; c += ($8 >= 1) + ($11 >= 1); f += ($8 <= 5 && $8 >= 0.2) + ($11 <= 5 && $11 >= 0.2) }
    END { if (n) printf "stated errors: %d of %d at or above the true one, %d within a factor of five\n", c, n, f }' \
    "$results/estimate.csv" 2>/dev/null || :

awk -F, '
    /two threads/ { printf "two threads: %.2f times (bar 1.6): %s\n", $2 / $3, ($2 >= 1.6 * $3 ? "met" : "missed") }
    /same bits/ { print "the same bits on one thread and two: " ($3 == 1 ? "yes" : "NO") }
    /weft check/ { printf "%s: %.1f ms: %s\n", $1, $3, ($3 < $2 ? "met" : "missed") }' "$results/skip.csv" 2>/dev/null || :
