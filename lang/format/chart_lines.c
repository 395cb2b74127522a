/* SPDX-License-Identifier: GPL-3.0-or-later
 * A chart's lines in, the same words in columns out: row numbers at the left,
 * words of stitches, row numbers at the right. */
#include "lang/format/chart_lines.h"

#include <ctype.h>
#include <string.h>

struct chart_lines {
    const struct name_at *next;
    const struct symbol *key;
    bool even;              /* all lines have as many words */
    int words;
    int *width;             /* (words) */
    int left, right;        /* digits of the widest row numbers */
    int body;               /* characters of the longest line between them */
};

/* A line taken apart. */
struct parts {
    const char *left, *body, *right;
    size_t nleft, nbody, nright;
};

/* ---- taking a line apart ---- */

static size_t next_word(const char **text, const char *end)
{
    size_t n = 0;

    while (*text < end && (**text == ' ' || **text == '\t'))
        ++*text;
    while (*text + n < end && (*text)[n] != ' ' && (*text)[n] != '\t')
        n++;
    return n;
}

/* Digits that the key does not give a meaning. */
static bool is_row_number(const struct chart_lines *lines, const char *word, size_t length)
{
    for (size_t i = 0; i < length; i++)
        if (!isdigit((unsigned char)word[i]))
            return false;
    for (const struct symbol *s = lines->key; s; s = s->next)
        if (isdigit((unsigned char)s->symbol[0]))
            return false;
    return length > 0;
}

static struct parts take_apart(const struct chart_lines *lines, const char *text)
{
    const char *end = text + strlen(text), *last;
    struct parts parts = {0};
    size_t n = next_word(&text, end);

    if (n < (size_t)(end - text) && is_row_number(lines, text, n)) {
        parts.left = text;
        parts.nleft = n;
        text += n;
        next_word(&text, end);
    }
    while (end > text && (end[-1] == ' ' || end[-1] == '\t'))
        end--;
    for (last = end; last > text && last[-1] != ' ' && last[-1] != '\t';)
        last--;
    if (last > text && is_row_number(lines, last, (size_t)(end - last))) {
        parts.right = last;
        parts.nright = (size_t)(end - last);
        end = last;
        while (end > text && (end[-1] == ' ' || end[-1] == '\t'))
            end--;
    }
    parts.body = text;
    parts.nbody = (size_t)(end - text);
    return parts;
}

static int count_words(struct parts parts)
{
    const char *text = parts.body, *end = text + parts.nbody;
    int words = 0;

    for (size_t n; (n = next_word(&text, end)); text += n)
        words++;
    return words;
}

/* ---- measuring ---- */

static int larger(int a, size_t b)
{
    return a > (int)b ? a : (int)b;
}

static void measure_words(struct chart_lines *lines, struct parts parts)
{
    const char *text = parts.body, *end = text + parts.nbody;
    size_t n;

    for (int i = 0; i < lines->words && (n = next_word(&text, end)); i++, text += n)
        lines->width[i] = larger(lines->width[i], (size_t)layout_characters(text, n));
}

static int body_width(const struct chart_lines *lines, struct parts parts)
{
    const char *text = parts.body, *end = text + parts.nbody;
    int width = 0;
    size_t n;

    for (int i = 0; (n = next_word(&text, end)); i++, text += n)
        width += (i > 0) + (lines->even ? lines->width[i] : layout_characters(text, n));
    return width;
}

struct chart_lines *chart_lines_new(struct arena *arena, const struct stmt *chart)
{
    struct chart_lines *lines = arena_new(arena, struct chart_lines);

    lines->next = chart->chart.line;
    lines->key = chart->chart.symbol;
    lines->even = true;
    for (const struct name_at *l = lines->next; l; l = l->next) {
        struct parts parts = take_apart(lines, l->name);
        int words = count_words(parts);

        lines->even &= l == lines->next || words == lines->words;
        lines->words = words;
        lines->left = larger(lines->left, parts.nleft);
        lines->right = larger(lines->right, parts.nright);
    }
    lines->width = arena_array(arena, int, (size_t)lines->words + 1);
    for (const struct name_at *l = lines->next; l && lines->even; l = l->next)
        measure_words(lines, take_apart(lines, l->name));
    for (const struct name_at *l = lines->next; l; l = l->next)
        lines->body = larger(lines->body, (size_t)body_width(lines, take_apart(lines, l->name)));
    return lines;
}

/* ---- printing ---- */

static void print_body(struct chart_lines *lines, struct layout *out, struct parts parts)
{
    const char *text = parts.body, *end = text + parts.nbody;
    int blanks = 0;
    size_t n;

    for (int i = 0; (n = next_word(&text, end)); i++, text += n) {
        layout_print(out, "%*s", blanks + (i > 0), "");
        layout_add(out, text, n);
        blanks = lines->even ? lines->width[i] - layout_characters(text, n) : 0;
    }
}

void chart_lines_print(struct chart_lines *lines, struct layout *out)
{
    struct parts parts = take_apart(lines, lines->next->name);

    int begin;

    if (lines->left)
        layout_print(out, "%*.*s ", lines->left, (int)parts.nleft, parts.nleft ? parts.left : "");
    begin = layout_width(out);
    print_body(lines, out, parts);
    if (parts.nright)
        layout_print(out, "%*s  %*.*s", lines->body - (layout_width(out) - begin), "", lines->right,
                     (int)parts.nright, parts.right);
    lines->next = lines->next->next;
}
