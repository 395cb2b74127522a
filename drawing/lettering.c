/* SPDX-License-Identifier: GPL-3.0-or-later
 * Text without a font: a line of UTF-8 in, strokes of a round pen out. */
#include "drawing/lettering.h"

#include <stddef.h>
#include <string.h>

/* ---- the alphabet ---- */

/* A glyph's strokes, with blanks between them.  A point is two digits: x from
 * the glyph's left end, y upwards, where 2 is the baseline, 6 the height of
 * small letters, 8 that of capitals.  One point alone is a dot.  Behind `~`
 * every corner is rounded off: the line runs from the middle of one side to the
 * middle of the next; a stroke that ends where it began is closed. */
struct glyph {
    int         width;
    const char *strokes;
};

enum { FIRST = 32, LAST = 126, BASELINE = 2, CAPITAL = 6, GAP = 2 };

static const struct glyph ascii[LAST - FIRST + 1] = {
    {2, ""},                                        /*   */
    {0, "0804 02"},                                 /* ! */
    {2, "0806 2826"},                               /* " */
    {5, "1218 4248 0656 0454"},                     /* # */
    {4, "~4748080545420203 2921"},                  /* $ */
    {6, "0268 ~0828260608 ~4464624244"},            /* % */
    {6, "6217 ~1718383704 ~0402425255"},            /* & */
    {0, "0806"},                                    /* ' */
    {2, "~29070321"},                               /* ( */
    {2, "~09272301"},                               /* ) */
    {4, "2824 0745 0547"},                          /* * */
    {4, "0545 2723"},                               /* + */
    {1, "1201"},                                    /* , */
    {3, "0535"},                                    /* - */
    {0, "02"},                                      /* . */
    {4, "0149"},                                    /* / */
    {4, "~0848420208"},                             /* 0 */
    {4, "062822 0242"},                             /* 1 */
    {4, "~07084845 450242"},                        /* 2 */
    {4, "~0708484515 ~1545420203"},                 /* 3 */
    {4, "32380444"},                                /* 4 */
    {4, "480805 ~0546420203"},                      /* 5 */
    {4, "~47480804 ~0646420206"},                   /* 6 */
    {4, "084812"},                                  /* 7 */
    {4, "~0848450508 ~0545420205"},                 /* 8 */
    {4, "~03024246 ~0848440408"},                   /* 9 */
    {0, "02 06"},                                   /* : */
    {1, "1201 16"},                                 /* ; */
    {4, "470543"},                                  /* < */
    {4, "0646 0444"},                               /* = */
    {4, "074503"},                                  /* > */
    {4, "~070848452524 22"},                        /* ? */
    {7, "~2656532326 ~56537379090161"},             /* @ */
    {6, "023862 1454"},                             /* A */
    {5, "0802 ~082848452505 ~053555523202"},        /* B */
    {5, "~575808025253"},                           /* C */
    {5, "0208 ~082858522202"},                      /* D */
    {4, "48080242 0535"},                           /* E */
    {4, "480802 0535"},                             /* F */
    {5, "~575808025255 3555"},                      /* G */
    {5, "0208 5258 0555"},                          /* H */
    {0, "0208"},                                    /* I */
    {4, "~4844420204"},                             /* J */
    {5, "0802 5803 2552"},                          /* K */
    {4, "080242"},                                  /* L */
    {6, "0208346862"},                              /* M */
    {5, "02085258"},                                /* N */
    {6, "~0868620208"},                             /* O */
    {5, "0208 ~082858552505"},                      /* P */
    {6, "~0868620208 4462"},                        /* Q */
    {5, "0208 ~082858552505 2552"},                 /* R */
    {5, "~5758080555520203"},                       /* S */
    {4, "0848 2822"},                               /* T */
    {5, "~080402525458"},                           /* U */
    {6, "083268"},                                  /* V */
    {8, "0822486288"},                              /* W */
    {5, "0852 0258"},                               /* X */
    {4, "082548 2522"},                             /* Y */
    {5, "08580252"},                                /* Z */
    {2, "29090121"},                                /* [ */
    {4, "0941"},                                    /* \ */
    {2, "09292101"},                                /* ] */
    {4, "062846"},                                  /* ^ */
    {4, "0141"},                                    /* _ */
    {1, "0817"},                                    /* ` */
    {4, "~0646420206 4642"},                        /* a */
    {4, "0802 ~0646420206"},                        /* b */
    {4, "~454606024243"},                           /* c */
    {4, "~0646420206 4842"},                        /* d */
    {4, "0444 ~444606024243"},                      /* e */
    {3, "~38181612 0636"},                          /* f */
    {4, "~0646420206 ~46424001"},                   /* g */
    {4, "0802 ~0406464442"},                        /* h */
    {0, "0602 08"},                                 /* i */
    {1, "~16121000 18"},                            /* j */
    {4, "0802 4603 1442"},                          /* k */
    {1, "~08040212"},                               /* l */
    {6, "0602 ~0406363432 ~3436666462"},            /* m */
    {4, "0602 ~0406464442"},                        /* n */
    {4, "~0646420206"},                             /* o */
    {4, "0600 ~0646420206"},                        /* p */
    {4, "~0646420206 4640"},                        /* q */
    {3, "0602 ~040636"},                            /* r */
    {3, "~3536060434320203"},                       /* s */
    {3, "~17141232 0636"},                          /* t */
    {4, "~0604024244 4642"},                        /* u */
    {4, "062246"},                                  /* v */
    {6, "0612355266"},                              /* w */
    {4, "0642 0246"},                               /* x */
    {4, "0622 4610"},                               /* y */
    {4, "06460242"},                                /* z */
    {3, "~39191505 ~05151131"},                     /* { */
    {0, "0901"},                                    /* | */
    {3, "~09192535 ~35252101"},                     /* } */
    {4, "~04163446"},                               /* ~ */
};

/* What there is besides ASCII: letters of their own, and small raised ones. */
static const struct {
    const char  *utf8;
    struct glyph glyph;
} others[] = {
    {"°", {2, "~0828260608"}}, {"·", {0, "05"}},   {"×", {4, "0347 0743"}},
    {"–", {4, "0545"}},        {"−", {4, "0545"}}, {"µ", {4, "0600 ~0604024244 4642"}},
    {"—", {6, "0565"}},        {"…", {4, "02 22 42"}}, {"ß", {4, "~020718384715 ~1545423222"}},
    {"ø", {4, "~0646420206 0147"}}, {"Ø", {6, "~0868620208 0169"}}, {"æ", {7, "~0636320206 3632 3474 ~747636327273"}},
};
static const struct {
    const char *utf8;
    char        as;
} raised[] = {
    {"⁰", '0'}, {"¹", '1'}, {"²", '2'}, {"³", '3'}, {"⁴", '4'}, {"⁵", '5'},
    {"⁶", '6'}, {"⁷", '7'}, {"⁸", '8'}, {"⁹", '9'}, {"⁻", '-'},
}, quotes[] = {{"“", '"'}, {"”", '"'}, {"„", '"'}, {"‘", '\''}, {"’", '\''}, {"«", '<'}, {"»", '>'}};

/* Accents of small letters, over them or below, and the letters that have them: each, and behind it its own letter. */
static const struct {
    struct glyph glyph;
    const char  *letters;
    bool         below;
} accents[] = {
    {{1, "0718"}, "áaéeíióoúuýyÁAÉEÍIÓOÚUÝY", false},
    {{1, "0817"}, "àaèeìiòoùuÀAÈEÌIÒOÙU", false},
    {{2, "071827"}, "âaêeîiôoûuÂAÊEÎIÔOÛU", false},
    {{2, "08 28"}, "äaëeïiöoüuÿyÄAËEÏIÖOÜU", false},
    {{3, "~07183738"}, "ãañnõoÃAÑNÕO", false},
    {{2, "~0828270708"}, "åaůuÅAŮU", false},
    {{2, "081728"}, "šsčcžzřrěeŠSČCŽZŘRĚE", false},
    {{1, "121000"}, "çcÇC", true},
};
static const struct glyph dotless = {0, "0602"}, box = {4, "0848420208"};

/* ---- finding glyphs ---- */

/* A glyph as it stands in a line: its scale, and its height above the baseline in units of the grid. */
struct mark {
    const struct glyph *glyph;
    double              scale, raise;
    const struct glyph *accent;     /* or NULL; over its middle */
    double              lift;       /* the accent's */
};

/* Bytes of the UTF-8 character that begins here, at least 1. */
static size_t character_length(const char *text)
{
    size_t n = 1;
    while (((unsigned char)text[n] & 0xC0) == 0x80)
        n++;
    return n;
}

static bool is_character(const char *text, size_t length, const char *utf8)
{
    return strlen(utf8) == length && memcmp(text, utf8, length) == 0;
}

/* A letter with an accent, its dot gone; a box for a character that is none. */
static struct mark accented(const char *text, size_t length)
{
    for (size_t i = 0; i < sizeof accents / sizeof *accents; i++)
        for (const char *at = accents[i].letters; *at; at += character_length(at) + 1) {
            char under = at[character_length(at)];
            bool lifted = under < 'a' && !accents[i].below;

            if (character_length(at) == length && memcmp(text, at, length) == 0)
                return (struct mark){under == 'i' ? &dotless : &ascii[under - FIRST], 1, 0, &accents[i].glyph, lifted ? 2 : 0};
        }
    return (struct mark){&box, 1, 0, NULL, 0};
}

/* The mark of the text's first character, which moves behind it. */
static struct mark next_mark(const char **text)
{
    const char *at = *text;
    size_t length = character_length(at);
    *text += length;
    if (length == 1 && *at >= FIRST && *at <= LAST)
        return (struct mark){&ascii[*at - FIRST], 1, 0, NULL, 0};
    for (size_t i = 0; i < sizeof others / sizeof *others; i++)
        if (is_character(at, length, others[i].utf8))
            return (struct mark){&others[i].glyph, 1, 0, NULL, 0};
    for (size_t i = 0; i < sizeof raised / sizeof *raised; i++)
        if (is_character(at, length, raised[i].utf8))
            return (struct mark){&ascii[raised[i].as - FIRST], 2 / 3., CAPITAL / 2., NULL, 0};
    for (size_t i = 0; i < sizeof quotes / sizeof *quotes; i++)
        if (is_character(at, length, quotes[i].utf8))
            return (struct mark){&ascii[quotes[i].as - FIRST], 1, 0, NULL, 0};
    return accented(at, length);
}

bool lettering_knows(const char *text)
{
    while (*text)
        if (next_mark(&text).glyph == &box)
            return false;
    return true;
}

/* ---- drawing ---- */

struct point { double x, y; };

enum { POINTS_MAX = 16 };

/* One unit of the grid in a text of size 1, the pen's width and a dot's radius in such units. */
static const double unit = LETTERING_CAPITAL / CAPITAL, pen = 0.75, dot = 0.15;

static struct point middle(struct point a, struct point b)
{
    return (struct point){(a.x + b.x) / 2, (a.y + b.y) / 2};
}

/* A parabola from cairo's present point, as the cubic it is. */
static void round_corner(cairo_t *cairo, struct point corner, struct point end)
{
    double x, y;
    cairo_get_current_point(cairo, &x, &y);
    cairo_curve_to(cairo, x + (corner.x - x) * 2 / 3, y + (corner.y - y) * 2 / 3, end.x + (corner.x - end.x) * 2 / 3,
                   end.y + (corner.y - end.y) * 2 / 3, end.x, end.y);
}

static void trace_round(cairo_t *cairo, const struct point *p, int n)
{
    bool closed = p[0].x == p[n - 1].x && p[0].y == p[n - 1].y;
    struct point start = closed ? middle(p[0], p[1]) : p[0];
    cairo_move_to(cairo, start.x, start.y);
    for (int i = 1; i < n - 1; i++)
        round_corner(cairo, p[i], !closed && i == n - 2 ? p[n - 1] : middle(p[i], p[i + 1]));
    if (closed) {
        round_corner(cairo, p[0], start);
        cairo_close_path(cairo);
    }
}

static void trace_straight(cairo_t *cairo, const struct point *p, int n)
{
    if (n == 1) {
        cairo_new_sub_path(cairo);
        cairo_arc(cairo, p->x, p->y, dot, 0, 6.3);
        cairo_close_path(cairo);
        return;
    }
    cairo_move_to(cairo, p->x, p->y);
    for (int i = 1; i < n; i++)
        cairo_line_to(cairo, p[i].x, p[i].y);
}

/* Adds a glyph's strokes to cairo's path, in units of the grid. */
static void trace_glyph(cairo_t *cairo, const struct glyph *glyph)
{
    for (const char *at = glyph->strokes; *at; at += *at == ' ') {
        struct point point[POINTS_MAX];
        int n = 0;
        bool round = *at == '~';
        for (at += round; *at && *at != ' ' && n < POINTS_MAX; at += 2)
            point[n++] = (struct point){at[0] - '0', at[1] - '0' - BASELINE};
        (round ? trace_round : trace_straight)(cairo, point, n);
    }
}

double lettering_width(const char *text, double size)
{
    double width = 0;
    for (const char *at = text; *at;) {
        struct mark mark = next_mark(&at);
        width += (mark.glyph->width + GAP) * mark.scale;
    }
    return (*text ? width - GAP : 0) * unit * size;
}

void lettering_draw(cairo_t *cairo, double x, double y, double size, enum lettering_align align, const char *text)
{
    double width = align == LETTERING_LEFT ? 0 : lettering_width(text, size);
    cairo_save(cairo);
    cairo_new_path(cairo);
    cairo_translate(cairo, x - width * align / 2, y);
    cairo_scale(cairo, unit * size, -unit * size);
    while (*text) {
        struct mark mark = next_mark(&text);
        cairo_save(cairo);
        cairo_translate(cairo, 0, mark.raise);
        cairo_scale(cairo, mark.scale, mark.scale);
        trace_glyph(cairo, mark.glyph);
        if (mark.accent) {
            cairo_translate(cairo, (mark.glyph->width - mark.accent->width) / 2., mark.lift);
            trace_glyph(cairo, mark.accent);
        }
        cairo_restore(cairo);
        cairo_translate(cairo, (mark.glyph->width + GAP) * mark.scale, 0);
    }
    cairo_set_line_width(cairo, pen);
    cairo_stroke(cairo);
    cairo_restore(cairo);
}
