/* SPDX-License-Identifier: GPL-3.0-or-later
 * Random scripts: motifs of rows, charts and formulas, blocks, loops and
 * pasted patterns, with comments, blanks and line ends wherever they may stand. */
#include "tests/format/program.h"

#include <stdarg.h>
#include <stdio.h>
#include <string.h>

enum { WIDTH = 12 };        /* stitches of every row */

struct program {
    unsigned long long state;
    char *text;
    size_t length;
    const char *newline;
    int stitch;             /* a stitch T of its own exists */
};

#define COUNT(array) (sizeof(array) / sizeof *(array))
#define ONE_OF(p, ...) ((const char *const[]){__VA_ARGS__})[below(p, COUNT(((const char *const[]){__VA_ARGS__})))]

/* splitmix64 */
static unsigned below(struct program *p, size_t n)
{
    unsigned long long z = p->state += 0x9E3779B97F4A7C15ull;

    z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9ull;
    z = (z ^ (z >> 27)) * 0x94D049BB133111EBull;
    return (unsigned)((z ^ (z >> 31)) % n);
}

static int chance(struct program *p, int percent)
{
    return below(p, 100) < (unsigned)percent;
}

__attribute__((format(printf, 2, 3))) static void put(struct program *p, const char *format, ...)
{
    char piece[512];
    va_list arguments;

    va_start(arguments, format);
    vsnprintf(piece, sizeof piece, format, arguments);
    va_end(arguments);
    for (const char *c = piece; *c && p->length < PROGRAM_MOST - 4; c++)
        if (*c == '\n')
            for (const char *n = p->newline; *n; n++)
                p->text[p->length++] = *n;
        else
            p->text[p->length++] = *c;
    p->text[p->length] = '\0';
}

/* ---- blanks and comments ---- */

static const char *blank(struct program *p)
{
    return ONE_OF(p, " ", " ", "  ", "\t", "    ");
}

static const char *maybe(struct program *p)
{
    return ONE_OF(p, "", "", " ", "  ");
}

static void end_line(struct program *p)
{
    static int comment;

    if (chance(p, 20))
        put(p, "%s#%s comment %d: k2, {p} \"*\"%s", maybe(p), maybe(p), ++comment % 100, maybe(p));
    put(p, "\n");
    if (chance(p, 15))
        put(p, "\n%s", chance(p, 30) ? "\n  \n" : "");
    if (chance(p, 12))
        put(p, "%s# own line; Row 1: k2%s\n", blank(p), maybe(p));
    if (chance(p, 10))
        put(p, "\n");
    put(p, "%s", maybe(p));
}

/* Behind an operator or a comma within brackets a line may end. */
static void soft(struct program *p)
{
    if (chance(p, 6))
        put(p, " # inside\n  ");
    else if (chance(p, 10))
        put(p, "\n%s", blank(p));
    else
        put(p, "%s", maybe(p));
}

/* ---- expressions ---- */

static void expression(struct program *p, const char *const *name, int nnames, int depth)
{
    switch (depth > 0 ? below(p, 8) : 6 + below(p, 2)) {
    case 0:
    case 1:
        put(p, "(");
        expression(p, name, nnames, depth - 1);
        put(p, "%s%s", maybe(p), ONE_OF(p, "+", "-", "*", "+"));
        soft(p);
        expression(p, name, nnames, depth - 1);
        put(p, "%s)", maybe(p));
        return;
    case 2:
        put(p, "%s%s(", ONE_OF(p, "min", "max"), maybe(p));
        expression(p, name, nnames, depth - 1);
        put(p, "%s,", maybe(p));
        soft(p);
        expression(p, name, nnames, depth - 1);
        put(p, ")");
        return;
    case 3:
        put(p, "%s(-", ONE_OF(p, "abs", "floor", "ceil"));
        expression(p, name, nnames, depth - 1);
        put(p, "%s/%s2)", maybe(p), maybe(p));
        return;
    case 4:
        put(p, "(");
        expression(p, name, nnames, depth - 1);
        put(p, "%s%s%s3%s?", maybe(p), ONE_OF(p, "<", ">=", "==", "!="), maybe(p), maybe(p));
        soft(p);
        expression(p, name, nnames, depth - 1);
        put(p, " :");
        soft(p);
        expression(p, name, nnames, depth - 1);
        put(p, ")");
        return;
    case 5:
        put(p, "[%s1,", maybe(p));
        soft(p);
        put(p, "2%s,3 ]%s[1]", maybe(p), maybe(p));
        return;
    case 6:
        if (nnames) {
            put(p, "%s", name[below(p, (size_t)nnames)]);
            return;
        }
        /* fall through */
    default:
        put(p, "%u%s", 1 + below(p, 5), ONE_OF(p, "", "", "", ".5", "e0", "E0"));
    }
}

/* A number of stitches or times, as digits or between braces. */
static void hole(struct program *p, int n)
{
    if (chance(p, 85))
        put(p, "%d", n);
    else
        put(p, "{%s%d%s+%s%d%s}", maybe(p), n - 1, maybe(p), maybe(p), 1, maybe(p));
}

/* ---- rows ---- */

static void between(struct program *p)
{
    put(p, "%s", ONE_OF(p, ", ", ",", ", ", " ,", " ", "; ", ", and ", ",\n     ", " then "));
    if (chance(p, 2))
        put(p, ", # in a row\n   ");
}

static int begins_line(const struct program *p)
{
    size_t at = p->length;

    while (at > 0 && p->text[at - 1] == ' ')
        at--;
    return at > 0 && strchr("\r\n", p->text[at - 1]);
}

static void run(struct program *p, int n)
{
    const char *word = ONE_OF(p, "k", "p", "K", "P", "knit ", "purl ", "Knit ", "k ", "P ");

    /* A line that begins with `knit 2` is a statement. */
    if (begins_line(p))
        word = "k";
    if (p->stitch && chance(p, 15))
        word = ONE_OF(p, "t", "T", "t ");
    if (n == 1 && chance(p, 30)) {
        put(p, "%s1", word);
        return;
    }
    put(p, "%s", word);
    hole(p, n);
    if (chance(p, 10))
        put(p, " sts");
}

/* Items of n stitches in all. */
static void items(struct program *p, int n, int depth)
{
    for (int left = n, part, times; left > 0; left -= part) {
        if (left < n)
            between(p);
        part = 1 + (int)below(p, (size_t)left);
        times = part % 3 == 0 ? 3 : part % 2 == 0 ? 2 : 1;
        if (depth > 0 && times > 1 && chance(p, 35)) {
            int square = chance(p, 50);

            put(p, "%s%s", square ? "[" : "(", maybe(p));
            items(p, part / times, depth - 1);
            put(p, "%s%s", maybe(p), square ? "]" : ")");
            if (times == 2)
                put(p, " %s", ONE_OF(p, "twice", "2 times", "x 2", "two times", "Twice", "{1+1} times", "x2"));
            else
                put(p, " %s", ONE_OF(p, "thrice", "3 times", "x 3", "three times", "x3", "{ 3 } times"));
        } else {
            run(p, part);
        }
    }
}

/* Some items, a repeat over most of the row, some items again. */
static void starred(struct program *p)
{
    int unit = 2 + (int)below(p, 3), before = (int)below(p, 2), behind = (WIDTH - before) % unit;
    int times = (WIDTH - before - behind) / unit;

    if (before) {
        run(p, before);
        between(p);
    }
    put(p, "*%s", maybe(p));
    items(p, unit, 1);
    if (chance(p, 20)) {
        put(p, "%s* %d times", maybe(p), times);
    } else if (behind == 0) {
        put(p, "%s", ONE_OF(p, "; rep from * to end", ", repeat from * across", "; rep from *", "* to end", " Rep from *to* to end of row",
                            "* rep across", "*", "; rep from * to end of the row"));
    } else {
        put(p, "%s", ONE_OF(p, "; rep from *", ", Repeat from *", "; rep from *", "*", "* repeat"));
        put(p, chance(p, 50) ? " to last %d sts" : chance(p, 50) ? " until %d sts rem" : " to within %d sts of end", behind);
    }
    if (behind) {
        put(p, ", ");
        items(p, behind, 0);
    }
}

static void row_body(struct program *p, int number)
{
    switch (below(p, 8)) {
    case 0:
        put(p, "%s", ONE_OF(p, "knit", "Purl", "k", "P", "knit all sts", "purl across", "Knit to end of row", "k all"));
        break;
    case 1:
        if (number > 1) {
            put(p, "%s", ONE_OF(p, "as row 1", "work as for row 1", "as 1st row", "repeat row 1", "Knit the knits and purl the purls",
                                "k the knit sts and p the purl sts"));
            return;
        }
        /* fall through */
    case 2:
    case 3:
        starred(p);
        break;
    case 4:
        put(p, "%s %s, ", ONE_OF(p, "k", "Purl"), ONE_OF(p, "to last 2 sts", "until 2 sts remain", "to the last {2} sts"));
        items(p, 2, 0);
        break;
    default:
        items(p, WIDTH, 2);
    }
    put(p, "%s", ONE_OF(p, "", "", "", ".", " (12 sts)", ". (12 sts)", " (12 sts).", " -- 12 sts", " [12 sts]", "."));
}

static void row(struct program *p, int number)
{
    const char *side = number % 2 ? "RS" : "WS";

    switch (below(p, 8)) {
    case 0:
        put(p, "%s%s%d%s(%s)%s:", ONE_OF(p, "ROW", "row"), blank(p), number, maybe(p), side, maybe(p));
        break;
    case 1:
        put(p, "R%d:", number);
        break;
    case 2:
        put(p, "%d%s row:", number, number == 1 ? "st" : number == 2 ? "nd" : number == 3 ? "rd" : "th");
        break;
    case 3:
        put(p, "Row {%d + %d}%s:", number - 1, 1, maybe(p));
        break;
    case 4:
        put(p, "Row %d %s -", number, side);
        break;
    case 5:
        put(p, "%s:", ONE_OF(p, "Next row", "Row", "next row", "ROW"));
        break;
    default:
        put(p, "Row %d%s:", number, !chance(p, 50) ? "" : number % 2 ? " [right side]" : " (WS facing)");
    }
    put(p, "%s", maybe(p));
    row_body(p, number);
}

static void rows(struct program *p)
{
    int n = 1 + (int)below(p, 5), filled = chance(p, 25);

    for (int i = 1; i <= n; i++) {
        if (filled && i % 2 == 0)
            continue;
        row(p, i);
        end_line(p);
    }
    if (filled) {
        put(p, "%s", ONE_OF(p, "All WS rows: purl", "all wrong side rows : Knit", "WS rows: k12", "Every even row: purl", "each WS row: p"));
        end_line(p);
    }
    if (chance(p, 30) && n % 2 == 0 && !filled) {
        put(p, ONE_OF(p, "Repeat rows 1-%d twice more", "Rep rows 1 to %d 2 times.", "repeat rows 1-%d until piece has 20 rows"), n);
        end_line(p);
    }
}

/* ---- charts ---- */

static void chart(struct program *p)
{
    int n = 1 + (int)below(p, 12), numbers = chance(p, 50), apart = chance(p, 50), bars = chance(p, 20);

    put(p, "chart%s(%sx%s=%sP,%so = K%s)%s{", maybe(p), maybe(p), maybe(p), maybe(p), maybe(p), maybe(p), maybe(p));
    end_line(p);
    for (int y = n; y >= 1; y--) {
        if (numbers && y % 2 == 0)
            put(p, "%d ", y);
        for (int x = 0; x < WIDTH; x++)
            put(p, "%s%s%s", bars && (x == 2 || x == 8) ? apart ? "| " : "|" : "", chance(p, 50) ? "x" : "o", apart ? blank(p) : "");
        if (numbers && y % 2 == 1)
            put(p, "%s%d", blank(p), y);
        end_line(p);
    }
    put(p, "}");
}

/* ---- motifs ---- */

static void loops(struct program *p)
{
    put(p, "for i%sin%s1%s..%s2%s{", blank(p), blank(p), maybe(p), maybe(p), maybe(p));
    if (chance(p, 30)) {
        put(p, " Row: k{i}, p{%d - i} }", WIDTH);
        end_line(p);
        return;
    }
    end_line(p);
    put(p, "Row {2*i -1} (RS): *k{i},p{4-i}; rep from *");
    end_line(p);
    put(p, "if i%s==%s1%s{", maybe(p), maybe(p), maybe(p));
    end_line(p);
    put(p, "Row {2*i}: purl");
    end_line(p);
    put(p, "}%selse%s{%sRow {2*i}: knit }", chance(p, 30) ? "\n" : chance(p, 20) ? " # then\n # or\n" : " ", maybe(p), blank(p));
    end_line(p);
    put(p, "}");
    end_line(p);
}

static void motif(struct program *p, const char *name)
{
    static const char *const xy[] = {"x", "y", "w"};

    switch (below(p, 4)) {
    case 0:
        put(p, "motif %s%s(w%s=%s3)%s=%s\n", name, maybe(p), maybe(p), maybe(p), maybe(p), blank(p));
        put(p, "%seach(x,y)%sin %d%sby%s4 :", blank(p), maybe(p), WIDTH, blank(p), blank(p));
        soft(p);
        expression(p, xy, 3, 3);
        put(p, "%smod 2 < 1 ?%sK%s:%sP", blank(p), maybe(p), chance(p, 30) ? "\n " : " ", blank(p));
        end_line(p);
        return;
    case 1:
        put(p, "motif %s%s{", name, maybe(p));
        end_line(p);
        chart(p);
        break;
    case 2:
        put(p, "motif%s%s%s%s{", blank(p), name, ONE_OF(p, "", " multiple of 12", " Multiple of {3*4}", " multiple of 12 sts", " multiple  of 4 plus 8"), blank(p));
        end_line(p);
        rows(p);
        break;
    default:
        put(p, "motif %s {", name);
        end_line(p);
        loops(p);
    }
    put(p, "}");
    end_line(p);
}

/* ---- the rest ---- */

static void block(struct program *p, int which)
{
    const char *end = chance(p, 30) ? "\n" : ";";

    switch (which) {
    case 0:
        put(p, "%s {%swidth%s=%s1.4%s%sheight = %u%s}", ONE_OF(p, "gauge", "GAUGE"), maybe(p), maybe(p), maybe(p), maybe(p), end, 1 + below(p, 3), maybe(p));
        break;
    case 1:
        put(p, "material%s{ thickness =.%u ;%s poisson = 0.%u }", maybe(p), 1 + below(p, 9), chance(p, 30) ? " # thin\n" : "", 1 + below(p, 4));
        break;
    case 2:
        put(p, "solve {\n steps = %u%s accuracy = %u %%\n }", 1 + below(p, 20), end, 1 + below(p, 5));
        break;
    case 3:
        put(p, "springs {%s%sedges=[left,%stop]%sstiffness = 1E-4;}", chance(p, 30) ? " # soft\n" : "", maybe(p), maybe(p), end);
        break;
    default:
        put(p, "mesh { per_stitch=%s }", ONE_OF(p, "1", "2", "auto"));
    }
    end_line(p);
}

static void swatch(struct program *p)
{
    put(p, "swatch%s%s", blank(p), ONE_OF(p, "tile( a,1 , n )", "above(a,\n  b)", "fill(a, 12, 8)", "beside( a, mirror( a ))",
                                        "border(a, sts=2, rows = n,with = b)", "above(a # low\n , flip(a))", "tile(b, columns = n ,rows=2)"));
    end_line(p);
}

static void declarations(struct program *p)
{
    static const char *const names[] = {"n"};

    put(p, "param%sn=%u%sin 1 ..%s9%s", blank(p), 1 + below(p, 4), blank(p), maybe(p), chance(p, 50) ? " \"how  many\"" : "");
    end_line(p);
    if (chance(p, 50)) {
        put(p, "LET v%s=%s", maybe(p), maybe(p));
        expression(p, names, 1, 3);
        end_line(p);
    }
    if (p->stitch) {
        put(p, "stitch T{ kx = -%u%s;ky=1 mm / 2 mm;%ssymbol=\"t\" }", below(p, 3), maybe(p), maybe(p));
        end_line(p);
    }
    if (chance(p, 30)) {
        put(p, "use%sseed,%srib_2x2 FROM std", blank(p), maybe(p));
        end_line(p);
    }
}

size_t program_write(unsigned seed, char *text)
{
    struct program program = {.state = seed, .text = text}, *p = &program;

    memset(text, 0, 32);
    p->newline = ONE_OF(p, "\n", "\n", "\n", "\r\n");
    p->stitch = chance(p, 30);
    if (chance(p, 10))
        put(p, "\xEF\xBB\xBF");
    if (chance(p, 30))
        end_line(p);
    if (chance(p, 20))
        put(p, "knit 1%s", chance(p, 50) ? "\n" : ";");
    declarations(p);
    if (chance(p, 25)) {
        put(p, "%s", ONE_OF(p, "Cast on 12 sts.", "CAST ON 12", "CO 12 sts", "cast-on {10+2} sts", "Multiple of 4 sts plus 8"));
        end_line(p);
        rows(p);
    } else {
        motif(p, "a");
        motif(p, "b");
        swatch(p);
    }
    for (int which = 0; which < 5; which++)
        if (chance(p, 40))
            block(p, which);
    put(p, "output%s\"x-{n}.obj\"%s", blank(p), chance(p, 30) ? "{ per_stitch=2 }" : "");
    if (chance(p, 80))
        end_line(p);
    if (chance(p, 20))
        put(p, "\noutput chart \"y.txt\";sweep n in%s2..%s3", blank(p), maybe(p));
    return p->length;
}
