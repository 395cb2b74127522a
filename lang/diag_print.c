/* SPDX-License-Identifier: GPL-3.0-or-later
 * Messages in, text out: lines with carets for people, one JSON object per
 * message for editors. */
#include <string.h>

#include "lang/compile.h"
#include "lang/diag.h"
#include "lang/limits.h"

enum { EXCERPT = 120, LEAD = 40 }; /* characters of a long line that are shown, and before the span */

static const char *const style_of[] = {"\033[1;31m", "\033[1;35m"};
static const char *const word_of[] = {"error", "warning"};
#define BOLD "\033[1m"
#define CYAN "\033[1;36m"
#define GREEN "\033[1;32m"
#define RESET "\033[0m"

static const char *if_color(bool color, const char *code)
{
    return color ? code : "";
}

static void print_place(FILE *out, struct span span)
{
    struct place place;

    if (!span.source)
        return;
    if (span.source->command_line) {
        fputs("command line: ", out);
        return;
    }
    place = diag_place(span);
    fprintf(out, "%s:%d:%d: ", source_called(span.source->name), place.line, place.column);
}

/* Steps over one character; a byte that is no UTF-8 counts as one. */
static size_t next_character(const char *text, size_t at, size_t end)
{
    at++;
    while (at < end && ((unsigned char)text[at] & 0xC0) == 0x80)
        at++;
    return at;
}

/* True for text a terminal may be given as it is. */
static bool is_printable(const char *text, size_t length)
{
    unsigned char c = (unsigned char)text[0];

    if (length == 1)
        return c >= 0x20 && c < 0x7F;
    return length == (c >= 0xF0   ? 4u
                      : c >= 0xE0 ? 3u
                                  : 2u) &&
           c >= 0xC2 && c < 0xF5 && !(c == 0xC2 && (unsigned char)text[1] < 0xA0);
}

/* The line and below it the span underlined; a long line is cut to a window. */
static void print_excerpt(FILE *out, struct span span, bool color, const char *style)
{
    struct span line;
    const char *text;
    size_t from, to, start, end, shown = 0;

    if (!span.source || !span.source->size)
        return;
    text = span.source->text;
    line = diag_line_around(span);
    from = line.start;
    if (from == 0 && span.source->size >= 3 && memcmp(text, "\xEF\xBB\xBF", 3) == 0)
        from = 3;
    start = span.start < line.end ? span.start : line.end;
    start = start < from ? from : start;
    end = span.end < line.end ? span.end : line.end;
    if (line.end - from > EXCERPT && start - from > LEAD)
        from = start - LEAD;
    while (from > line.start && from < line.end && ((unsigned char)text[from] & 0xC0) == 0x80)
        from++;

    /* The text itself, what cannot be shown as one mark each. */
    if (span.source->command_line)
        fputs("     | ", out);
    else
        fprintf(out, "%4d | ", diag_place(span).line);
    fputs(from > line.start + 3 ? "..." : "", out);
    for (to = from; to < line.end && shown < EXCERPT; shown++) {
        size_t next = next_character(text, to, line.end);

        if (text[to] == '\t')
            fputc(' ', out);
        else if (is_printable(text + to, next - to))
            fwrite(text + to, 1, next - to, out);
        else
            fputc('?', out);
        to = next;
    }
    fputs(to < line.end ? "...\n" : "\n", out);

    /* The underline: a caret, and tildes to the end of the span. */
    fprintf(out, "     | %s%s", from > line.start + 3 ? "   " : "", if_color(color, style));
    for (size_t at = from; at < start; at = next_character(text, at, line.end))
        fputc(' ', out);
    fputc('^', out);
    for (size_t at = start < end ? next_character(text, start, line.end) : end; at < end && at < to;
         at = next_character(text, at, line.end))
        fputc('~', out);
    fprintf(out, "%s\n", if_color(color, RESET));
}

static void print_note(FILE *out, const struct note *note, bool color)
{
    fputs(if_color(color, BOLD), out);
    print_place(out, note->span);
    fprintf(out, "%s%s%s: %s\n", if_color(color, note->hint ? GREEN : CYAN), note->hint ? "hint" : "note",
            if_color(color, RESET), note->text);
    print_excerpt(out, note->span, color, CYAN);
}

static void print_message(FILE *out, const struct message *m, bool color)
{
    char code[6];

    fputs(if_color(color, BOLD), out);
    print_place(out, m->span);
    fprintf(out, "%s%s%s: %s [%s]\n", if_color(color, style_of[m->severity]), word_of[m->severity],
            if_color(color, RESET), m->text, diag_code_name(m->code, code));
    print_excerpt(out, m->span, color, style_of[m->severity]);
    for (const struct note *note = m->note; note; note = note->next)
        print_note(out, note, color);
    for (const struct note *note = m->context; note; note = note->next)
        print_note(out, note, color);
}

/* A JSON string; bytes that are no UTF-8 become the replacement character. */
static void json_text(FILE *out, const char *text)
{
    size_t length = strlen(text);

    fputc('"', out);
    for (size_t at = 0; at < length;) {
        size_t next = next_character(text, at, length);
        unsigned char c = (unsigned char)text[at];

        if (c == '"' || c == '\\')
            fprintf(out, "\\%c", c);
        else if (c < 0x20 || c == 0x7F)
            fprintf(out, "\\u%04x", c);
        else if (is_printable(text + at, next - at))
            fwrite(text + at, 1, next - at, out);
        else
            fputs("\\ufffd", out);
        at = next;
    }
    fputc('"', out);
}

static void json_place(FILE *out, struct span span)
{
    struct place place = {0};

    fputs("\"file\": ", out);
    if (span.source && span.source->command_line)
        json_text(out, "command line");
    else if (span.source)
        json_text(out, span.source->name);
    else
        fputs("null", out);
    if (span.source && !span.source->command_line)
        place = diag_place(span);
    fprintf(out, ", \"line\": %d, \"column\": %d, \"end\": %d", place.line, place.column, place.end);
}

/* Those that stand somewhere. */
static void json_notes(FILE *out, const struct note *note, const char **between)
{
    for (; note; note = note->next) {
        if (!note->span.source)
            continue;
        fprintf(out, "%s{", *between);
        json_place(out, note->span);
        fputs(", \"text\": ", out);
        json_text(out, note->text);
        fputs("}", out);
        *between = ", ";
    }
}

static void json_message(FILE *out, const struct message *m)
{
    const char *between = "";
    char code[6];

    fputs("{", out);
    json_place(out, m->span);
    fprintf(out, ", \"severity\": \"%s\", \"code\": \"%s\", \"text\": ", word_of[m->severity],
            diag_code_name(m->code, code));
    json_text(out, m->text);

    /* Notes that stand somewhere else, then those without a place and the hints. */
    fputs(", \"notes\": [", out);
    json_notes(out, m->note, &between);
    json_notes(out, m->context, &between);
    fputs("], \"hints\": [", out);
    between = "";
    for (const struct note *note = m->note; note; note = note->next)
        if (!note->span.source) {
            fputs(between, out);
            json_text(out, note->text);
            between = ", ";
        }
    fputs("]}\n", out);
}

/* Those kept, and that there are too many. */
enum { MESSAGES = LIMIT_MESSAGES + 1 };

/* Messages about one text stand in its order, texts in the order they came up. */
static bool comes_before(const struct message *a, const struct message *b)
{
    return a->span.source == b->span.source && a->span.start < b->span.start;
}

static int in_order(const struct diag *diag, const struct message *order[MESSAGES])
{
    int n = 0;

    for (const struct message *m = diag->first; m; m = m->next) {
        int at = n++;

        for (int i = at - 1; i >= 0; i--)
            if (comes_before(m, order[i]))
                at = i;
        memmove(order + at + 1, order + at, (size_t)(n - 1 - at) * sizeof *order);
        order[at] = m;
    }
    return n;
}

void diag_print(const struct diag *diag, FILE *out, enum diag_style style, bool color)
{
    const struct message *order[MESSAGES];
    int shown = in_order(diag, order);

    for (int i = 0; i < shown; i++)
        if (style == DIAG_JSON)
            json_message(out, order[i]);
        else
            print_message(out, order[i], color);
    if (style == DIAG_HUMAN && diag_number(diag) > shown)
        fprintf(out, "%d more not shown\n", diag_number(diag) - shown);
}
