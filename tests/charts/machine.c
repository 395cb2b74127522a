/* SPDX-License-Identifier: GPL-3.0-or-later
 * A knitting machine of two beds: knitout 2 on standard input, the fabric its
 * front shows on standard output as a grid of K and P.  It follows each loop and
 * stops, with exit status 1 and the line, at whatever a machine could not do or
 * would do for nothing.  Written for the tests, from the format's specification;
 * it shares nothing with the program. */
#include <stdarg.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>

enum { NEEDLES = 4096, ROWS = 4096, WORDS = 8 };

static struct {
    int  loops[2][NEEDLES];         /* front, back */
    int  moved[2][NEEDLES];         /* a loop that was transferred and not knitted since */
    char stitch[NEEDLES][ROWS];     /* K, P, from the cast-on upwards */
    int  rows[NEEDLES];
    int  line, transfers;
    int  header, in, hooked, made;  /* the carriers named; the one carrier: in action, on the hook, stitches made */
    char carriers[1 << 17], carrier[32];
    int  at;                        /* twice the needle the carrier stands at, one more or less: on which side */
} m;

static void wrong(const char *format, ...)
{
    va_list arguments;
    va_start(arguments, format);
    fprintf(stderr, "line %d: ", m.line);
    vfprintf(stderr, format, arguments);
    fprintf(stderr, "\n");
    exit(1);
}

static int bed_of(const char *needle, int *number)
{
    char *end, bed = needle ? needle[0] : 0;
    if (bed != 'f' && bed != 'b')
        wrong("a needle wanted, not %s", needle ? needle : "nothing");
    *number = (int)strtol(needle + 1, &end, 10);
    if (end == needle + 1 || *end || *number < 0 || *number >= NEEDLES)
        wrong("no needle %s", needle);
    return bed == 'b';
}

static void need_carrier(const char *name)
{
    if (!name || !m.in || strcmp(name, m.carrier) != 0)
        wrong("the carrier %s is not in action", name ? name : "(none)");
}

/* The carrier moves past a needle in the direction; it must stand before it. */
static void move_carrier(const char *direction, int n)
{
    int sign = strcmp(direction, "+") == 0 ? 1 : strcmp(direction, "-") == 0 ? -1 : 0;
    if (!sign)
        wrong("no direction %s", direction);
    if (m.made && sign * (2 * n - m.at) <= 0)
        wrong("the carrier stands behind needle %d already", n);
    m.at = 2 * n + sign;
    m.made++;
}

static void tuck(char **word)
{
    int n, bed = bed_of(word[2], &n);
    need_carrier(word[3]);
    move_carrier(word[1], n);
    m.loops[bed][n]++;
}

static void miss(char **word)
{
    int n;
    bed_of(word[2], &n);
    need_carrier(word[3]);
    move_carrier(word[1], n);
}

static void knit(char **word)
{
    int n, bed = bed_of(word[2], &n);
    need_carrier(word[3]);
    move_carrier(word[1], n);
    if (m.loops[bed][n] != 1)
        wrong("%s holds %d loops", word[2], m.loops[bed][n]);
    if (m.rows[n] == ROWS)
        wrong("too many rows");
    m.moved[bed][n] = 0;
    m.stitch[n][m.rows[n]++] = bed ? 'P' : 'K';
}

static void xfer(char **word)
{
    int n, to, bed = bed_of(word[1], &n), other = bed_of(word[2], &to);
    if (bed == other || n != to)
        wrong("%s and %s do not face each other", word[1], word[2]);
    if (m.loops[bed][n] != 1 || m.loops[other][n] != 0)
        wrong("%s holds %d loops and %s %d", word[1], m.loops[bed][n], word[2], m.loops[other][n]);
    if (m.moved[bed][n])
        wrong("%s was only just moved here", word[1]);
    for (int i = 0; i < NEEDLES; i++)
        if ((m.loops[0][i] || m.loops[1][i]) && abs(m.at - 2 * i) < 1)
            wrong("the carrier is in the way");
    m.loops[bed][n]--;
    m.loops[other][n]++;
    m.moved[other][n] = 1;
    m.transfers++;
}

static void drop(char **word)
{
    int n, bed = bed_of(word[1], &n);
    if (!m.loops[bed][n])
        wrong("%s holds no loop", word[1]);
    m.loops[bed][n] = 0;
}

static void inhook(char **word)
{
    const char *list = m.carriers;
    size_t length = word[1] ? strlen(word[1]) : 0;
    if (!length || m.in)
        wrong("one carrier comes in once");
    while ((list = strstr(list, word[1])) && !(list[-1] == ' ' && strchr(" \n", list[length])))
        list++;
    if (!list)
        wrong("the header does not name the carrier %s", word[1]);
    snprintf(m.carrier, sizeof m.carrier, "%s", word[1]);
    m.in = m.hooked = 1;
}

static void releasehook(char **word)
{
    need_carrier(word[1]);
    if (!m.hooked || !m.made)
        wrong("nothing to release");
    m.hooked = 0;
}

static void outhook(char **word)
{
    need_carrier(word[1]);
    if (m.hooked)
        wrong("the hook holds a yarn already");
    m.in = 0;
}

static const struct {
    const char *name;
    int         words;
    void      (*work)(char **word);
} operations[] = {{"tuck", 4, tuck},           {"knit", 4, knit}, {"miss", 4, miss}, {"xfer", 3, xfer}, {"drop", 2, drop},
                  {"inhook", 2, inhook}, {"releasehook", 2, releasehook}, {"outhook", 2, outhook}};

static void work(char *line)
{
    char *word[WORDS] = {0};
    int n = 0;
    line[strcspn(line, ";\n")] = 0;
    for (char *w = strtok(line, " \t"); w && n < WORDS; w = strtok(NULL, " \t"))
        word[n++] = w;
    if (!n)
        return;
    if (!*m.carriers)
        wrong("an operation before the header ;;Carriers");
    for (size_t i = 0; i < sizeof operations / sizeof *operations; i++)
        if (strcmp(word[0], operations[i].name) == 0) {
            if (n != operations[i].words)
                wrong("%s has %d words", word[0], n);
            operations[i].work(word);
            m.header = 0;
            return;
        }
    wrong("%s is no operation of a plain fabric", word[0]);
}

/* Nothing is left on the machine, and every stitch column is equally high. */
static void show(void)
{
    int first = 0, last = NEEDLES - 1;
    while (first < NEEDLES && !m.rows[first])
        first++;
    while (last > first && !m.rows[last])
        last--;
    if (first == NEEDLES || m.in)
        wrong(m.in ? "the yarn is left in" : "no stitch");
    for (int i = 0; i < NEEDLES; i++)
        if (m.loops[0][i] || m.loops[1][i] || (m.rows[i] && m.rows[i] != m.rows[first]))
            wrong("needle %d holds a loop, or its column is not as high as the others", i);
    printf("# 1 1\n");
    for (int row = 0; row < m.rows[first]; row++)
        for (int i = first; i <= last; i++) {
            if (!m.rows[i])
                wrong("needle %d is left out", i);
            printf("%c%c", m.stitch[i][row], i < last ? ' ' : '\n');
        }
    fprintf(stderr, "transfers %d\n", m.transfers);
}

int main(void)
{
    static char line[1 << 16];
    m.header = 1;
    while (fgets(line, sizeof line, stdin)) {
        m.line++;
        if (m.line == 1 && strcmp(line, ";!knitout-2\n") != 0)
            wrong("not the first line of knitout 2");
        if (m.line > 1 && strncmp(line, ";;", 2) == 0) {
            if (!m.header)
                wrong("a header among the operations");
            if (strncmp(line, ";;Carriers: ", 12) == 0)
                snprintf(m.carriers, sizeof m.carriers, " %s", line + 12);
        } else if (m.line > 1) {
            if (line[strspn(line, " \t\n")])
                m.header = 0;
            work(line);
        }
    }
    show();
    return 0;
}
