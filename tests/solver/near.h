/* SPDX-License-Identifier: GPL-3.0-or-later
 * Doubles compared as doubles: cmocka's assert_float_equal rounds both to
 * float first.  To be included after <cmocka.h>. */
#ifndef WEFT_TEST_NEAR_H
#define WEFT_TEST_NEAR_H

#include <math.h>

#define assert_near(a, b, within) near_check(a, b, within, __FILE__, __LINE__)

static inline void near_check(double a, double b, double within, const char *file, int line)
{
    if (fabs(a - b) <= within)
        return;
    print_error("%.17g and %.17g are %g apart, not within %g\n", a, b, fabs(a - b), within);
    _fail(file, line);
}

#endif
