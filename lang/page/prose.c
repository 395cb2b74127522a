/* SPDX-License-Identifier: GPL-3.0-or-later
 * A line of a pasted page in, whether it is prose out.  What cannot be told
 * apart from a mistyped statement is none: it stays an error. */
#include "lang/page/prose.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

#include "lang/page/headings.h"
#include "lang/page/page_chart.h"
#include "lang/page/prose_line.h"
#include "lang/refused.h"
#include "lang/scanner.h"
#include "lang/syntax.h"
#include "lang/page/words.h"

enum { TITLE_LINES = 3 };

/* Where one of the words stands on the line; or 0. */
static size_t find_word(const char *text, const char *const *word, int n)
{
    size_t line = words_line_length(text);

    for (size_t at = 1; at < line; at++)
        if (!isalnum((unsigned char)text[at - 1]) && words_find(text + at, word, n) >= 0)
            return at;
    return words_find(text, word, n) >= 0 ? 1 : 0;
}

/* `Slip the first stitch of every row`, `Always knit the first and last stitch of each row`: a note that changes rows. */
static bool is_of_every_row(struct diag *diag, const char *text, struct span line)
{
    static const char *const every[] = {"every", "each", "all"}, *const first[] = {"first", "1st", "edge", "selvedge", "selvage"},
                             *const slip[] = {"slip", "sl", "slipped", "slips", "slipping"}, *const work[] = {"knit", "k", "purl", "p", "work", "knitted"};
    size_t at = find_word(text, every, 3);

    if (!find_word(text, first, 5) || (!(at && words_are_rows(words_next(text + at))) && !words_is(text, "always")))
        return false;
    if (find_word(text, slip, 5))
        return refused_word(diag, "slip", line);
    if (!find_word(text, work, 6))
        return false;
    diag_warning(diag, CODE_PROSE, line, "this note is read as text: rows are worked as they are written");
    diag_hint(diag, "where the rows do not have these stitches, write them there");
    return true;
}

void prose_warn_hidden(struct scanner *scanner, struct span line)
{
    const char *text = scanner->parse->text + line.start;

    if (is_of_every_row(scanner->parse->diag, text, line))
        return;

    for (unsigned i = 1; i < line.end - line.start; i++) {
        struct span span = {line.source, line.start + i, line.end};

        if (isalnum((unsigned char)text[i - 1]) || !isalpha((unsigned char)text[i]) || !prose_pattern_follows(text + i))
            continue;
        diag_warning(scanner->parse->diag, CODE_PROSE, span, "this part of the line is read as text, not as a part of the pattern");
        diag_hint(scanner->parse->diag, "to have it worked, write it on a line of its own");
        return;
    }
}

/* `Border: repeat rows 1 and 2` */
static bool is_labelled_statement(const char *text)
{
    size_t colon = strcspn(text, ":\r\n");

    return text[colon] == ':' && prose_statement_follows(text + colon + 1);
}

/* `Knit 4 rows`, `Row 1: ..`, `Then rep last 2 rows`, `k2, p2 rib 6 rows`: worked, where a sentence ends before. */
static bool is_worked(const char *text)
{
    const char *behind;

    if (words_are(text, WORDS_THEN))
        text = words_next(text);
    if (prose_counts_fabric(text) || (words_is(text, "work") && prose_counts_fabric(words_skip_blanks(text + 4))))
        return true;
    behind = words_next(text);
    if (prose_fabric_follows(words_is(text, "work") && words_is(behind, "in") ? words_skip_blanks(behind + 2) : text) && prose_row_count(text))
        return true;
    if (words_are(text, WORDS_AGAIN))
        return prose_repeats_rows(behind) && words_line_length(text) > 0;
    if (words_is(text, "work") && words_is(behind, "these") && words_are_rows(words_skip_blanks(behind + 5)))
        return true;
    return prose_pattern_follows(text) || (words_are(text, WORDS_PLAIN | WORDS_WORK) && prose_rows_follow(behind));
}

size_t prose_length(const struct scanner *scanner, const char *text)
{
    size_t line = words_line_length(text);

    if (page_chart_line(scanner->parse->chart, (unsigned)(text - scanner->parse->text)).source)
        return line;
    for (size_t i = 0; !scanner->section && i < line; i++) {
        const char *next = words_skip_blanks(text + i + 1);
        size_t heading;

        if (text[i] == '.' && !scanner->begun && headings_find(next, &heading))
            next += heading;
        if (text[i] == '.' && isspace((unsigned char)text[i + 1]) && (scanner->begun ? is_worked(next) : prose_begins_cast_on(next) > 0))
            return i;
    }
    return line;
}

/* `k and 1 row purl`, behind `knit 5 rows`. */
static bool counts_rows_of(const char *text, size_t length)
{
    for (size_t i = 0; i < length; i++) {
        const char *rows = i > 0 && text[i - 1] == ' ' ? words_behind_number(text + i) : NULL;

        if (rows && words_are_rows(rows) && words_are(words_next(rows), WORDS_PLAIN))
            return true;
    }
    return false;
}

/* `If you want it wider, ..`, `Note: you may ..`: said to the reader. */
static bool is_advice(const char *text)
{
    static const char *const word[] = {"if", "when", "to", "for", "you", "the", "this", "these", "it", "we", "my", "your", "some", "there"};
    const char *colon = text + strcspn(text, ":.\r\n");

    return words_find(text, word, sizeof word / sizeof *word) >= 0 ||
           (*colon == ':' && words_find(words_skip_blanks(colon + 1), word, sizeof word / sizeof *word) >= 0);
}

static bool has_either(const char *text, const char *a, const char *b)
{
    return words_line_has(text, a) || words_line_has(text, b);
}

/* What a sentence asks by its first word and another. */
static bool begins_as_work(const char *text, size_t length)
{
    const char *next = words_next(text);

    if (words_are(text, WORDS_PLAIN) || words_is(text, "and"))      /* `and 1 row purl` */
        return counts_rows_of(text, length);
    if (words_is(text, "alternate"))
        return has_either(text, "sections", "rows");
    if (words_is(text, "work") && words_are(next, WORDS_PART))      /* `Work border as before` */
        return has_either(text, "as", "again");
    if (words_is(text, "work"))                                     /* a pattern by a name that no rows above have */
        return has_either(text, "until", "till") && has_either(text, "pattern", "stitch");
    if (words_is(text, "last") || words_is(text, "final"))          /* `Last row K` */
        return words_are_rows(next) && words_are(words_next(next), WORDS_PLAIN);
    return words_is(text, "rib") && *next == '.';                   /* `Rib as before.`, plainly */
}

/* `Now K 3, P 12, K 3 on the wrong side`, `Rib 2 and 2 for 6 rows`, `Change to stocking-stitch`, `Repeat from ** to **`:
 * a sentence that has stitches with their numbers, rows, a fabric, or asks to work again, so many times. */
static bool asks_for_work(const char *text, size_t length)
{
    static const char *const lead[] = {"repeat", "rep", "rib", "change", "continue", "cont", "proceed", "work", "do", "begin", "start", "go", "return"},
                             *const fabric[] = {"garter", "stocking", "stockinette", "moss", "seed"}, *const keep[] = {"keep", "keeping", "maintain", "maintaining"};
    int first = words_find(text, lead, sizeof lead / sizeof *lead), here = first < 0 && words_is(text, "knit") ? 0 : first, stitches = 0;
    bool asks = first >= 0 && first < 2 && (memchr(text, '*', length) || words_line_has(text, "rows")), again = has_either(text, "repeat", "rep");
    bool heading = length > 0 && text[length - 1] == ':' ? prose_heads_rows(text, text + length) : first > 8 && words_row(prose_line_next(text));

    if (is_advice(text))
        return false;
    for (size_t i = 0; i < length; i++) {
        const char *behind = words_next(text + i);

        if (i > 0 && isalnum((unsigned char)text[i - 1]))
            continue;
        if (i > 1 && text[i - 1] == ' ' && text[i - 2] == '.')
            here = words_find(text + i, lead, sizeof lead / sizeof *lead);
        asks |= here >= 0 && (prose_times_follow(text + i) || (words_are(text + i, WORDS_OFTEN) && words_is(behind, "more")));
        if (!isalpha((unsigned char)text[i]))
            continue;
        asks |= words_find(text + i, keep, 4) >= 0 && words_number(behind);
        asks |= again && words_row(text + i);       /* `End with a repeat of rows 2-4` */
        stitches += words_are(text + i, WORDS_PLAIN) && isdigit((unsigned char)*behind) && !isalpha((unsigned char)behind[strspn(behind, "0123456789")]);
        while (words_is(behind, "the") || words_is(behind, "last") || words_is(behind, "final"))    /* `Knit the last 4 rows` */
            behind = words_next(behind);
        asks |= (words_are(text + i, WORDS_PLAIN | WORDS_WORK) || words_is(text + i, "rib")) && prose_rows_follow(behind);
        asks |= first >= 3 && !heading && words_find(text + i, fabric, 5) >= 0 && prose_fabric_follows(text + i);
    }
    asks |= first < 0 && words_line_has(text, "change") && has_either(text, "continue", "until");
    asks |= first > 8 && words_line_has(text, "work");
    return asks || stitches > 1 || begins_as_work(text, length) || prose_works_until(text) ||
           (first == 2 && prose_row_count(text) > 0 && prose_row_count(text) < length);
}

/* `Keep three stitches on either side in garter stitch`. */
static bool keeps_edges(const char *text)
{
    static const char *const side[] = {"side", "sides", "end", "ends", "edge", "edges"};

    if (!words_is(text, "keep") && !words_is(text, "keeping"))
        return false;
    for (int i = 0; i < 6; i++)
        if (words_line_has(text, side[i]))
            return true;
    return false;
}

/* Whether a line states the gauge that lengths are counted by. */
static bool states_gauge(const struct scanner *scanner, const char *text, size_t length)
{
    const struct page_facts *facts = &scanner->parse->facts;
    size_t at = (size_t)(text - scanner->parse->text);

    return facts->gauge > 0 && at <= facts->gauge_to && at + length > facts->gauge_from;
}

/* `Work as before`: it may have been meant, what the lines around it are not. */
static bool begins_work(const char *text)
{
    return words_are(text, WORDS_WORK | WORDS_PLAIN | WORDS_AGAIN | WORDS_GO_ON | WORDS_CAST | WORDS_BIND);
}

/* How many lines from here on read as prose of one kind, the first as far as it goes; `end` is behind the last. */
static int block_length(const struct scanner *scanner, const char *text, size_t length, const char **end)
{
    int n = 1;

    *end = text + length;
    for (bool work = begins_work(text); n <= LIMIT_TEXTS && strchr("\r\n", **end); n++) {
        text = prose_line_next(text);
        if (states_gauge(scanner, text, words_line_length(text)) || begins_work(text) != work ||
            !(*text && !is_worked(text) && !prose_statement_follows(text) && !is_labelled_statement(text) && !prose_line_is_keyword(text) &&
              !prose_is_keyword(text) && prose_reads(text, false)))
            break;
        *end = text + words_line_length(text);
    }
    return n;
}

bool prose_of_multiple(const struct scanner *scanner)
{
    const char *text = SCANNER_TEXT(scanner);

    while (text > scanner->parse->text && !strchr("\r\n", text[-1]))
        text--;
    return words_line_has(text, "multiple") || words_line_has(text, "multiples") || words_line_has(text, "mult");
}

bool prose_sizes(struct scanner *scanner, struct span line)
{
    const char *text = scanner->parse->text;

    for (unsigned at = line.start; at < line.end; at++) {
        size_t close = strchr("([", text[at]) ? 1 + strcspn(text + at + 1, "([)]\r\n") : 0;

        if (close && text[at + close] && strchr(")]", text[at + close]) &&
            (words_are(words_skip_blanks(text + at + close + 1), WORDS_ROW | WORDS_TIMES) || words_is(words_skip_blanks(text + at + close + 1), "more")) &&
            scanner_sizes(scanner, (struct span){line.source, at, at + 1}))
            return true;
    }
    return false;
}

bool scanner_prose(struct scanner *scanner)
{
    struct parse *parse = scanner->parse;
    const char *text = parse->text + scanner->at, *end;
    struct span span = {parse->source, scanner->at, scanner->at + (unsigned)prose_length(scanner, text)};
    bool again = scanner->at < scanner->prose_end;
    int lines;

    scanner_looks_on(scanner);
    if (prose_line_is_copyright(text) || (parse->facts.knitters && prose_line_is_rule(text)) || prose_line_is_explained(text) ||
        (parse->facts.knitters && prose_line_is_abbreviation(text)))
        return true;
    if (again && !prose_reads(text, false))
        return false;
    if (!again && scanner->section && prose_reads(text, true) && !syntax_is_row(text)) {
        prose_warn_hidden(scanner, span);
        return true;
    }
    if (!again && !scanner->begun && scanner->titles < TITLE_LINES && prose_is_title(text)) {
        scanner->titles++;
        return true;
    }
    if (!again && !prose_is_keyword(text) && !prose_reads(text, false) && !prose_line_is_heading(text) && !(parse->facts.knitters && prose_line_is_idle(text)) &&
        (scanner->begun || prose_line_is_mistyped(text) || !prose_is_measure(text)))
        return false;

    if (scanner->begun && prose_sizes(scanner, span))
        return true;

    /* An instruction is none, once there is a pattern. */
    if (scanner->begun && (refused_sentence(parse->diag, span) || is_of_every_row(parse->diag, text, span)))
        return true;

    if (scanner->begun && !scanner->closed && asks_for_work(text, prose_length(scanner, text))) {
        diag_error(parse->diag, CODE_STATEMENT, span, "this asks for stitches, but which rows they are cannot be told");
        diag_hint(parse->diag, keeps_edges(text) ? "write these stitches in each row, at both ends: `K3, .. to last 3 sts, k3`"
                               : prose_works_until(text) ? "`Knit every row until ..`, or for the rows above `Work in pattern until ..`"
                                                       : "a row begins with its name: `Row 1: ...`; so many rows: `Work 6 rows in k2, p2 rib`; '#' before a remark");
        return true;
    }

    /* Nothing says what this is: it is named, once for lines that follow each other. */
    if (again || states_gauge(scanner, text, span.end - span.start))
        return true;
    lines = block_length(scanner, text, prose_length(scanner, text), &end);
    scanner->prose_end = (unsigned)(end - parse->text);
    if (lines == 1)
        diag_warning(parse->diag, CODE_PROSE, span, "this line is read as text, not as a part of the pattern");
    else
        diag_warning(parse->diag, CODE_PROSE, span,
                     "these %d lines are read as text, not as a part of the pattern", lines);
    diag_hint(parse->diag, "a row begins with its name: `Row 1: ...`; '#' before a text keeps it silent");
    return true;
}
