/* SPDX-License-Identifier: GPL-3.0-or-later
 * An axis: the range of some numbers in; round ends, ticks with their texts, and
 * the place of each number along it out. */
#include "output/axis.h"

#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

/* Magnitudes an axis can show; nearer to zero is zero. */
static const double greatest = 1e290, least = 1e-290;
/* Numbers as near to each other as this, relatively, are one; a place this near to a tick is on it. */
static const double same = 1e-9;
/* Powers of ten up to this many digits are written out. */
enum { PLAIN_BELOW = -4, PLAIN_UP_TO = 5 };
/* A log axis shorter than this has texts at 2 and 5, too. */
enum { DECADES_SHORT = 2 };

void axis_see(struct axis_range *range, const double *value, int n)
{
    for (int i = 0; i < n; i++) {
        if (!(fabs(value[i]) <= greatest))
            continue;
        range->low = fmin(range->low, value[i]);
        range->high = fmax(range->high, value[i]);
        if (value[i] >= least)
            range->positive = fmin(range->positive, value[i]);
    }
}

/* ---- texts ---- */

/* m * 10^e, rounded once. */
static double times_ten(double m, int e)
{
    return e < 0 ? m / pow(10, -e) : m * pow(10, e);
}

/* The power of ten a number begins with. */
static int decade_of(double value)
{
    int e = (int)floor(log10(value));
    return e + (value >= times_ten(1, e + 1)) - (value < times_ten(1, e));
}

static void add_raised(char text[AXIS_TEXT], int number)
{
    static const char *const digit[] = {"⁰", "¹", "²", "³", "⁴", "⁵", "⁶", "⁷", "⁸", "⁹"};
    char plain[16];
    snprintf(plain, sizeof plain, "%d", number);
    for (const char *p = plain; *p; p++)
        strcat(text, *p == '-' ? "⁻" : digit[*p - '0']);
}

static bool is_plain(int decade)
{
    return decade >= PLAIN_BELOW && decade <= PLAIN_UP_TO;
}

/* With so many decimals, of the number itself or of what stands before a power of ten. */
static void print_decimals(char text[AXIS_TEXT], double value, int decade, int decimals, bool power)
{
    power = power && value != 0;
    double shown = fabs(power ? times_ten(value, -decade) : value);
    char number[AXIS_TEXT];
    snprintf(number, sizeof number, "%.*f", value == 0 ? 0 : decimals, shown);
    bool alone = power && strcmp(number, "1") == 0;
    snprintf(text, AXIS_TEXT, "%s%.16s%s", value < 0 ? "−" : "", alone ? "" : number,
             !power ? "" : alone ? "10" : "×10");
    if (power)
        add_raised(text, decade);
}

void axis_print(char text[AXIS_TEXT], double value, int digits)
{
    char number[AXIS_TEXT];
    if (!isfinite(value) || value == 0) {
        snprintf(text, AXIS_TEXT, "%s", value == 0 ? "0" : "–");
        return;
    }
    snprintf(number, sizeof number, "%.*e", digits - 1, fabs(value));
    int decade = atoi(strchr(number, 'e') + 1), last = digits - 1;
    while (last > 0 && number[last + 1] == '0')     /* number[1] is the point */
        last--;
    int decimals = is_plain(decade) ? last - decade : last;
    print_decimals(text, value, decade, decimals > 0 ? decimals : 0, !is_plain(decade));
}

/* ---- linear ---- */

/* A step of 1, 2 or 5 times a power of ten. */
struct step { int mantissa, decade; };

static struct step step_for(double wanted, bool whole)
{
    static const int mantissa[] = {1, 2, 5};
    int e = decade_of(wanted);
    if (whole && e < 0)
        return (struct step){1, 0};
    for (int i = 0; i < 3; i++)
        if (wanted <= times_ten(mantissa[i], e) * (1 + same))
            return (struct step){mantissa[i], e};
    return (struct step){1, e + 1};
}

static void make_linear(struct axis *axis, double low, double high, const struct axis_wish *wish)
{
    double magnitude = fmax(fabs(low), fabs(high));
    if (high - low <= same * magnitude || magnitude < least) {
        double around = magnitude < least ? 1 : magnitude / 10;
        low -= around, high += around;
    }
    struct step step = step_for((high - low) / wish->texts, wish->whole);
    double size = times_ten(step.mantissa, step.decade);
    double first = floor(low / size + same), last = ceil(high / size - same);
    int decade = decade_of(fmax(fabs(first), fabs(last)) * size);
    int decimals = (is_plain(decade) ? 0 : decade) - step.decade;
    for (double i = first; i <= last && axis->nticks < AXIS_TICKS; i++) {
        struct axis_tick *tick = &axis->tick[axis->nticks++];
        tick->value = times_ten(i * step.mantissa, step.decade);
        print_decimals(tick->text, tick->value, decade, decimals > 0 ? decimals : 0, !is_plain(decade));
    }
    axis->low = axis->tick[0].value;
    axis->high = axis->tick[axis->nticks - 1].value;
}

/* ---- logarithmic ---- */

/* The greatest of 1, 2, 5 (or 1) times a power of ten that is not above a number, or the least not below. */
static double round_end(double value, bool up, bool fine)
{
    static const int mantissa[] = {1, 2, 5, 10};
    int e = decade_of(value);
    double end = times_ten(up ? 10 : 1, e);
    for (int i = 0; i < 4; i += fine ? 1 : 3) {
        double m = times_ten(mantissa[i], e);
        if (up && m >= value * (1 - same))
            return m;
        if (!up && m <= value * (1 + same))
            end = m;
    }
    return end;
}

/* The ticks of one decade: each whole multiple of it, or itself alone. */
static void add_decade(struct axis *axis, int e, bool small, bool text, bool fine, bool power)
{
    for (int m = 1; m <= (small ? 9 : 1) && axis->nticks < AXIS_TICKS; m++) {
        struct axis_tick *tick = &axis->tick[axis->nticks];
        *tick = (struct axis_tick){.value = times_ten(m, e)};
        if (tick->value < axis->low * (1 - same) || tick->value > axis->high * (1 + same))
            continue;
        axis->nticks++;
        if (m == 1 ? text : fine && (m == 2 || m == 5))
            print_decimals(tick->text, tick->value, e, power || e >= 0 ? 0 : -e, power);
    }
}

/* Texts in one form: all as powers of ten if some must be. */
static void make_log(struct axis *axis, double low, double high, const struct axis_wish *wish)
{
    bool fine = log10(high) - log10(low) < DECADES_SHORT;
    axis->log = true;
    axis->low = round_end(low, false, fine);
    axis->high = round_end(high, true, fine);
    if (!(axis->high > axis->low))
        axis->high = round_end(axis->low * 1.5, true, true);
    int first = decade_of(axis->low), last = decade_of(axis->high), every = 1 + (last - first) / (wish->texts + 1);
    for (int e = first; e <= last; e++)
        if (every <= DECADES_SHORT || e % every == 0)
            add_decade(axis, e, every == 1, e % every == 0, fine, !is_plain(first) || !is_plain(last));
}

/* ---- both ---- */

struct axis axis_make(const struct axis_range *range, const struct axis_wish *wish)
{
    struct axis axis = {0};
    bool none = !(range->low <= range->high), positive = range->positive <= range->high;
    bool wide = range->low >= least && range->high >= 1000 * range->low;
    if (wish->scale == AXIS_LOG || (wish->scale == AXIS_AUTO && wide))
        make_log(&axis, positive ? range->positive : 1, positive ? range->high : 10, wish);
    else
        make_linear(&axis, none ? 0 : wish->zero ? fmin(range->low, 0) : range->low,
                    none ? 1 : wish->zero ? fmax(range->high, 0) : range->high, wish);
    return axis;
}

double axis_place(const struct axis *axis, double value)
{
    if (!(fabs(value) <= greatest) || (axis->log && value < least))
        return NAN;
    if (axis->log)
        return log10(value / axis->low) / log10(axis->high / axis->low);
    return (value - axis->low) / (axis->high - axis->low);
}
