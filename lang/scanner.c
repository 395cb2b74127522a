/* SPDX-License-Identifier: GPL-3.0-or-later
 * The scanner's place in a statement: what was read last in, what that may be followed by out. */
#include "lang/scanner.h"

#include <ctype.h>
#include <string.h>

#include "lang/page/explained.h"
#include "lang/page/kinds.h"
#include "lang/page/page_chart.h"
#include "lang/page/page_sides.h"
#include "lang/page/prose.h"
#include "lang/page/prose_line.h"
#include "lang/page/repeats.h"
#include "lang/syntax.h"
#include "lang/token_values.h"
#include "lang/page/words.h"

void scanner_advance(struct scanner *scanner, struct span *span, size_t length)
{
    *span = (struct span){scanner->parse->source, scanner->at, scanner->at + (unsigned)length};
    scanner->at = span->end;
    scanner->behind += scanner->parse->diag->nerrors > 0;
}

/* What there are too many of, lines of text for one, or NULL; and how many there may be. */
static const char *has_too_many(const struct scanner *scanner, int *most)
{
    const struct { int n, most; const char *of; } counted[] = {
        {scanner->texts, LIMIT_TEXTS, "lines of text"}, {scanner->statements, LIMIT_STATEMENTS, "statements"}, {scanner->lines, LIMIT_LINES, "lines"},
        {scanner->behind, LIMIT_BEHIND, "words behind the first error"}};

    for (size_t i = 0; i < sizeof counted / sizeof *counted; i++)
        if (counted[i].n > (*most = counted[i].most))
            return counted[i].of;
    return NULL;
}

bool scanner_gives_up(struct scanner *scanner, struct span span)
{
    size_t size = scanner->parse->source->size, most = LIMIT_AGAIN * size, many = LIMIT_AGAIN_ALL + 4 * size;
    int enough;
    const char *read = has_too_many(scanner, &enough);

    scanner->quiet |= diag_is_full(scanner->parse->diag, span);
    if ((scanner->again <= (most < many ? most : many) + LIMIT_LINE && !read) || scanner->parse->diag->full)
        return scanner->parse->diag->full;
    if (!scanner->quiet && read)
        diag_error(scanner->parse->diag, CODE_LIMIT_ERRORS, span, "after %d %s this file is read no further", enough, read);
    else if (!scanner->quiet)
        diag_error(scanner->parse->diag, CODE_LIMIT_LINE, span, "too many sentences or rows stand on lines such as this one: it is read no further");
    scanner->quiet = true;
    return true;
}

void scanner_retreat(struct scanner *scanner, struct span *span, int length)
{
    span->end -= (unsigned)length;
    scanner->at = span->end;
    scanner->again += length > 0 ? (size_t)length : 0;
}

void scanner_looks(struct scanner *scanner, size_t length)
{
    scanner->again += length;
}

void scanner_looks_on(struct scanner *scanner)
{
    words_line_is_long(&scanner->line, scanner->parse->text, scanner->at);
    scanner_looks(scanner, scanner->line.end > scanner->at ? scanner->line.end - scanner->at : 0);
}

int scanner_token(struct scanner *scanner, int kind)
{
    scanner->comma = false;
    scanner->previous = kind;
    scanner->counted |= kind == TOKEN_FOR_ROWS || kind == TOKEN_FOR_TOTAL;
    scanner->texts += kind == TOKEN_PROSE ? 1 + (int)(scanner->at - scanner->token_end) / LIMIT_TEXT : 0;
    scanner->token_end = scanner->at;
    scanner->lines += kind == TOKEN_NEWLINE;
    scanner->multiple = kind == TOKEN_MULTIPLE_OF || kind == TOKEN_NUMBER_OF || (scanner->multiple && kind != TOKEN_ROW && kind != TOKEN_BARE_ROW);
    if (kind == TOKEN_NEWLINE || kind == TOKEN_END || (kind == '}' && !scanner->hole)) {
        scanner->star_left = scanner->star;
        scanner->star = scanner->complained = false;
    }
    return kind;
}

/* Whether behind such a statement rows have names. */
static bool names_rows(int statement)
{
    return statement == TOKEN_ROW || statement == TOKEN_ALL || statement == TOKEN_SETUP || statement == TOKEN_MOTIF || statement == TOKEN_SWATCH;
}

void scanner_begin(struct scanner *scanner, int statement)
{
    scanner->statement = statement;
    scanner->statements++;
    scanner->counted = false;
    scanner->stops = false;
    scanner->begun = true;
    scanner->bare = statement == TOKEN_CAST_ON ? 1 : names_rows(statement) ? 0 : scanner->bare;
    scanner->section = false;
}

/* An empty line ends a list of materials. */
void scanner_blank_line(struct scanner *scanner, const char *line_ends)
{
    const char *first = strpbrk(line_ends, "\r\n");

    if (first && strpbrk(first + (first[0] == '\r' && first[1] == '\n') + 1, "\r\n"))
        scanner->section = false;
}

bool scanner_is_behind_times(const struct scanner *scanner)
{
    return scanner->previous == TOKEN_TWICE || scanner->previous == TOKEN_TIMES || scanner->previous == TOKEN_MORE;
}

bool scanner_closes_group(const struct scanner *scanner)
{
    return scanner->previous == ')' || scanner->previous == ']' || scanner->previous == TOKEN_STAR;
}

bool scanner_closes_repeat(const struct scanner *scanner)
{
    int previous = scanner->previous;

    return previous == TOKEN_REP_FROM || previous == TOKEN_REP || (previous == TOKEN_STAR && !scanner->star);
}

bool scanner_closes_unopened(const struct scanner *scanner)
{
    const char *behind = words_skip_blanks(SCANNER_TEXT(scanner));

    return !scanner->star && !scanner->comma && scanner->previous != ':' && (*behind == ',' || *behind == ';');
}

bool scanner_bare_row(const struct scanner *scanner)
{
    const char *text = SCANNER_TEXT(scanner);
    size_t at = scanner->at;

    while (scanner->bare && at > 0 && strchr(" \t", scanner->parse->text[at - 1]))
        at--;
    return scanner->bare && at > 0 && words_ends_line(scanner->parse->text[at - 1]) && prose_is_bare_row(words_skip_blanks(text), scanner->bare > 1);
}

int scanner_begin_bare(struct scanner *scanner, KNIT_STYPE *value, struct span *span)
{
    int number = scanner->bare;

    scanner_advance(scanner, span, 0);
    scanner_begin(scanner, TOKEN_ROW);
    scanner_round(value, scanner->parse->facts.rounds ? "rnd" : "row");
    scanner->bare = number + 1;
    return scanner_token(scanner, TOKEN_BARE_ROW);
}

bool scanner_is_text(struct scanner *scanner)
{
    struct parse *parse = scanner->parse;
    size_t at = (size_t)(words_skip_blanks(SCANNER_TEXT(scanner)) - parse->text);

    return page_chart_line(parse->chart, scanner->at).source || named_is_heading(&parse->named, at) || ribs_describes(&parse->ribs, parse->text, at) || page_sides_line(parse->text + at) ||
           kinds_given(parse->text + at) ||
           (parse->facts.knitters && prose_line_is_abbreviation(parse->text + at));
}

bool scanner_explains(struct scanner *scanner)
{
    const char *text = words_skip_blanks(SCANNER_TEXT(scanner));
    unsigned start = (unsigned)(text - scanner->parse->text);

    if (!explained_fabric(text, scanner->begun))
        return false;
    if (scanner->begun && !scanner->section) {
        diag_warning(scanner->parse->diag, CODE_PROSE, (struct span){scanner->parse->source, start, start + (unsigned)words_line_length(text)},
                     "this is read as what a name means, not as rows to work");
        diag_hint(scanner->parse->diag, "`Work 6 rows in garter st` is worked");
    }
    return true;
}

bool scanner_in_row_head(const struct scanner *scanner)
{
    return scanner->statement == TOKEN_ROW || scanner->statement == TOKEN_ALL || scanner->statement == TOKEN_SETUP ||
           scanner->statement == TOKEN_AS_ROW;
}

bool scanner_works_rows(const struct scanner *scanner)
{
    static const int works[] = {TOKEN_WORK, TOKEN_GO_ON_ROWS, TOKEN_WORK_ROWS, TOKEN_WORK_THEM, TOKEN_WORK_LAST, TOKEN_REPEAT_ROWS, TOKEN_REPEAT_LAST, TOKEN_REPEAT_THEM, TOKEN_REPEAT_ALL};

    for (size_t i = 0; i < sizeof works / sizeof *works; i++)
        if (scanner->statement == works[i])
            return true;
    return false;
}

bool scanner_takes_colon(const struct scanner *scanner)
{
    return scanner->statement == TOKEN_ROW || scanner->statement == TOKEN_ALL || scanner->statement == TOKEN_SETUP;
}

/* Behind the first statement such a sentence begins with its needles: `With 4 mm needles cast on ..`. */
size_t scanner_cast_on(const struct scanner *scanner, const char *text, size_t length)
{
    bool first = !scanner->begun || scanner->multiple || words_is(text, "with") || words_is(text, "using");
    static const char *const maybe[] = {"could", "can", "may", "might", "would"};
    size_t cast_on = prose_begins_cast_on(text);

    /* `You could cast on 15 sts, or 23`, behind the one that is. */
    if (scanner->begun && words_find(words_next(text), maybe, sizeof maybe / sizeof *maybe) >= 0)
        return 0;
    return cast_on ? cast_on : first && prose_has_cast_on(SCANNER_TEXT(scanner)) ? length : 0;
}

bool scanner_row_is_full(const struct scanner *scanner)
{
    size_t margin = scanner->at < WORDS_MARGIN ? scanner->at : WORDS_MARGIN;
    bool letters = isalpha((unsigned char)words_sign_before(SCANNER_TEXT(scanner) - margin, margin, ". \t\r\n"));

    return !scanner->star && !scanner_in_bracket(scanner) &&
           (scanner->previous == TOKEN_TO_END || scanner->previous == TOKEN_REP_FROM || (scanner->previous == TOKEN_NAME && letters));
}

bool scanner_stops(const struct scanner *scanner, char mark)
{
    const char *text = SCANNER_TEXT(scanner), *next = words_skip_blanks(text), *number = words_next(next);
    bool alone = !scanner->star && !scanner_in_bracket(scanner);

    if (words_are_rows(next) && (isdigit((unsigned char)*number) || *number == '{'))
        return true;
    if (mark != ',' && next > text && prose_sentence_begins(next))
        return true;
    if (mark == '.' && words_are(next, WORDS_AGAIN) && scanner_row_is_full(scanner) && repeats_so_often(number))
        return true;
    return mark == '.' && (prose_is_aside(text) || (alone && prose_remark_follows(text)));
}

bool scanner_behind_multiple(const struct scanner *scanner)
{
    return scanner->previous == TOKEN_NUMBER_OF || (scanner->previous == TOKEN_STS && prose_of_multiple(scanner));
}

bool scanner_begins_item(const struct scanner *scanner)
{
    int previous = scanner->previous;

    return scanner->comma || previous == ':' || previous == '(' || previous == '[' || previous == TOKEN_TO_FIT || (previous == TOKEN_STAR && scanner->star);
}

/* The last two stay apart: they may be a fabric's name, `k2, p2 rib`, or what is worked so many times. Where the text
 * is not what was written its places are not those of single stitches. */
size_t scanner_stitches(const struct scanner *scanner, size_t back)
{
    const char *text = SCANNER_TEXT(scanner) - back, *written = scanner->parse->source->text + scanner->at - back;
    size_t third = 0, second = 0, last = 0, at = 0, gap = 1;

    if (scanner->previous != TOKEN_NAME)
        return 0;
    for (size_t n; gap && (n = words_stitch_length(text + at)) > 0; at += n + gap) {
        gap = words_gap_length(text + at + n);
        if (memcmp(text + at, written + at, n + gap) != 0)
            break;
        third = second;
        second = last;
        last = at + n;
    }
    return third > back ? third : 0;
}

/* What a word behind `rep` was to be, told by what follows it; NULL: nothing is wrong. */
static const char *repeat_expects(const char *word, const char *behind)
{
    if (words_is_name(word, "until") || words_is_name(word, "till") || words_is_name(word, "to"))
        return NULL;
    if (*behind == '*' && !words_is_name(word, "from"))
        return "'from'";
    if (words_is_name(word, "from") && *behind != '*' && !prose_repeats_rows(behind))
        return "'*'";
    return isdigit((unsigned char)*behind) && !prose_repeats_rows(word) ? "'rows'" : NULL;
}

int scanner_repeat(struct scanner *scanner)
{
    const char *text = SCANNER_TEXT(scanner), *word = text + strspn(text, " \t"), *behind = word + words_name_length(word);
    bool star = scanner->star && !scanner_closes_group(scanner);
    struct span span = {scanner->parse->source, scanner->at + (unsigned)(word - text), scanner->at + (unsigned)(behind - text)};
    const char *expected = behind > word ? repeat_expects(word, behind + strspn(behind, " \t")) : NULL;

    if (!expected || (strcmp(expected, "'rows'") == 0 && !syntax_meant(scanner->parse, span))) {
        /* `*k2, p2; rep to end`. */
        scanner->star &= !star;
        return scanner_token(scanner, star ? TOKEN_REP_FROM : scanner_closes_group(scanner) ? TOKEN_REP : TOKEN_REP_ALL);
    }
    if (strcmp(expected, "'*'") == 0) {
        behind += strspn(behind, " \t");
        span.start = scanner->at + (unsigned)(behind - text);
        span.end = span.start + (unsigned)(words_name_length(behind) ? words_name_length(behind) : *behind && !strchr("\r\n", *behind));
    }
    syntax_unknown_word(scanner->parse, span, expected);
    if (strcmp(expected, "'*'") == 0 && !scanner->star)
        diag_hint(scanner->parse->diag, "the stars of the row are lost: `*k2, p2; rep from * to last 2 sts, k2`");
    scanner->star = false;
    return TOKEN_KNIT_error;
}

bool scanner_number_follows(const struct scanner *scanner)
{
    const char *text = SCANNER_TEXT(scanner);

    text += strspn(text, " \t");
    return isdigit((unsigned char)*text) || *text == '{';
}
