/* SPDX-License-Identifier: GPL-3.0-or-later
 * Collects messages about a script and finds where a span of bytes stands. */
#include "lang/diag.h"

#include <stdarg.h>
#include <string.h>

#include "lang/limits.h"

const struct diag_code_info diag_codes[] = {
#define X(name, number, about) {name, about},
    DIAG_CODES(X)
#undef X
};
const int diag_ncodes = sizeof diag_codes / sizeof *diag_codes;

static const int first_warning = 900;

const char *diag_code_name(enum diag_code code, char name[static 6])
{
    snprintf(name, 6, "%c%04u", (int)code < first_warning ? 'E' : 'W', (unsigned)code % 10000);
    return name;
}

void diag_init(struct diag *diag, struct arena *arena)
{
    *diag = (struct diag){.arena = arena};
}

static bool said_before(const struct diag *diag, enum diag_code code, struct span span)
{
    for (const struct message *m = diag->first; m; m = m->next)
        if (m->code == code && m->span.source == span.source && m->span.start == span.start &&
            m->span.end == span.end)
            return true;
    return false;
}

enum { CONTEXTS = 4 }; /* are shown, the innermost */

/* Where the context stands now, as notes. */
static const struct note *context_notes(struct diag *diag)
{
    struct note *first = NULL, **last = &first;
    int n = 0;

    for (const struct context *c = diag->context; c && n < CONTEXTS; c = c->up, n++) {
        *last = arena_new(diag->arena, struct note);
        **last = (struct note){.span = c->span, .text = c->what};
        last = (struct note **)&(*last)->next;
    }
    return first;
}

static struct message *message_new(struct diag *diag, enum severity severity, enum diag_code code,
                                   struct span span)
{
    struct message *m = arena_new(diag->arena, struct message);

    *m = (struct message){.severity = severity, .code = code, .span = span, .context = context_notes(diag)};
    if (diag->first)
        diag->last->next = m;
    else
        diag->first = m;
    diag->open = diag->last = m;
    return m;
}

static void record(struct diag *diag, enum severity severity, enum diag_code code, struct span span,
                   const char *format, va_list arguments)
{
    int *count = severity == SEVERITY_ERROR ? &diag->nerrors : &diag->nwarnings;

    /* One mistake in a loop is one message, and past the limit only the number matters; an error is never behind warnings. */
    diag->open = NULL;
    if (said_before(diag, code, span))
        return;
    if (!(severity == SEVERITY_WARNING && diag->errors_only) &&
        (diag_takes_more(diag) || code == CODE_LIMIT_ERRORS || (severity == SEVERITY_ERROR && diag->nerrors == 0)))
        message_new(diag, severity, code, span)->text = arena_vprintf(diag->arena, format, arguments);
    ++*count;
}

void diag_error(struct diag *diag, enum diag_code code, struct span span, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    record(diag, SEVERITY_ERROR, code, span, format, arguments);
    va_end(arguments);
}

void diag_warning(struct diag *diag, enum diag_code code, struct span span, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    record(diag, diag->warnings_are_errors ? SEVERITY_ERROR : SEVERITY_WARNING, code, span, format,
           arguments);
    va_end(arguments);
}

bool diag_is_full(struct diag *diag, struct span span)
{
    bool errors = diag->nerrors >= LIMIT_ERRORS;

    if (!errors && diag->nwarnings < LIMIT_WARNINGS)
        return false;
    if (!diag->full)
        diag_error(diag, CODE_LIMIT_ERRORS, span, "after %d %s this file is read no further",
                   errors ? diag->nerrors : diag->nwarnings, errors ? "errors" : "warnings");
    diag->full = true;
    return true;
}

/* Appends a line to the message recorded last, unless that one was dropped. */
static void __attribute__((format(printf, 4, 0)))
add_note(struct diag *diag, struct span span, bool hint, const char *format, va_list arguments)
{
    struct note *note;

    if (!diag->open)
        return;
    note = arena_new(diag->arena, struct note);
    *note = (struct note){.span = span, .text = arena_vprintf(diag->arena, format, arguments), .hint = hint};
    if (diag->open->last)
        diag->open->last->next = note;
    else
        diag->open->note = note;
    diag->open->last = note;
}

void diag_note(struct diag *diag, struct span span, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    add_note(diag, span, false, format, arguments);
    va_end(arguments);
}

void diag_hint(struct diag *diag, const char *format, ...)
{
    va_list arguments;

    va_start(arguments, format);
    add_note(diag, (struct span){0}, true, format, arguments);
    va_end(arguments);
}

void diag_did_you_mean(struct diag *diag, const char *nearest)
{
    if (nearest)
        diag_hint(diag, "did you mean '%s'?", nearest);
}

/* A line ends with LF, CR LF or a lone CR. */
static bool ends_line(const struct source *source, size_t i)
{
    const char *text = source->text;

    return text[i] == '\n' || (text[i] == '\r' && text[i + 1] != '\n');
}

struct span diag_line_around(struct span span)
{
    const struct source *source = span.source;
    size_t start = span.start < source->size ? span.start : source->size;
    size_t end = start;

    while (start > 0 && !ends_line(source, start - 1))
        start--;
    while (end < source->size && source->text[end] != '\n' && source->text[end] != '\r')
        end++;
    return (struct span){source, (unsigned)start, (unsigned)end};
}

/* Characters of UTF-8 text: its bytes without the continuation bytes. */
static int characters(const char *text, size_t n)
{
    int count = 0;

    for (size_t i = 0; i < n; i++)
        count += ((unsigned char)text[i] & 0xC0) != 0x80;
    return count;
}

struct place diag_place(struct span span)
{
    struct place place = {0};
    struct span line;
    unsigned start, end;

    if (!span.source)
        return place;
    line = diag_line_around(span);
    place.line = 1;
    for (size_t i = 0; i < line.start; i++)
        place.line += ends_line(span.source, i);

    /* A span over several lines is shown to the end of its first. */
    start = span.start < line.end ? span.start : line.end;
    end = span.end < line.end ? span.end : line.end;
    if (end < start)
        end = start;
    place.column = 1 + characters(span.source->text + line.start, start - line.start);
    place.end = place.column + characters(span.source->text + start, end - start);

    /* A byte order mark is no character of the first line. */
    if (place.line == 1 && span.source->size >= 3 && memcmp(span.source->text, "\xEF\xBB\xBF", 3) == 0 &&
        start >= 3) {
        place.column--;
        place.end--;
    }
    return place;
}
