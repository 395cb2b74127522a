/* SPDX-License-Identifier: GPL-3.0-or-later
 * Syntax errors: an unexpected token in, a sentence a knitter understands out. */
#include "lang/syntax.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

#include "lang/expected.h"
#include "lang/limits.h"
#include "lang/refused.h"
#include "lang/scanner.h"
#include "lang/page/prose.h"
#include "lang/typos.h"
#include "lang/page/words.h"

enum { LIMIT_REFUSED = 1000 };      /* bytes of a row that are looked at for it */

const char *const statement_word[] = {
    "knit",     "use",     "let",    "param", "stitch", "motif", "swatch",   "gauge",
    "material", "springs", "mesh",   "solve", "output", "sweep", "for",      "if",
    "chart",    "cast",    "co",     "row",   "rows",   "round", "rounds",   "rnd",
    "rnds",     "all",     "repeat", "rep",   "every",  "next",  "multiple",
};
const int nstatement_words = sizeof statement_word / sizeof *statement_word;

void syntax_too_deep(struct parse *parse, struct span at)
{
    diag_error(parse->diag, CODE_LIMIT_NESTING, at, "this is nested too deep");
    diag_hint(parse->diag, "give parts of it names with 'let' or 'motif'");
}

/* Whether nothing but blanks stands before the span on its line, or since a ';' or '{'. */
static bool begins_statement(struct span span)
{
    const char *text = span.source->text;
    size_t at = span.start;

    while (at > 0 && text[at - 1] && strchr(" \t*-_", text[at - 1]))
        at--;
    return at == 0 || strchr("\n\r;{}", text[at - 1]) || (unsigned char)text[at - 1] == 0xBF;
}

bool syntax_is_row(const char *text)
{
    char c = (char)tolower((unsigned char)text[0]);

    if (c == '*' || c == '(' || c == '[' || strncasecmp(text, "repeat", 6) == 0 ||
        (strncasecmp(text, "rep", 3) == 0 && !isalpha((unsigned char)text[3])))
        return true;
    return (c == 'k' || c == 'p') && (isdigit((unsigned char)text[1]) || strchr(", \r\n", text[1]));
}

/* A line that begins with no statement's word. */
static void no_statement(struct parse *parse, struct span span)
{
    const char *text = span.source->text + span.start;
    size_t length = strcspn(text, " \t\r\n,;:(){}[]*=\"#"), behind;
    const char *beginning = typos_beginning(text, &behind);
    char *word;

    if (beginning)
        length = behind;
    if (length == 0)
        length = *text != '\0';
    if (length > LIMIT_NAME)
        length = LIMIT_NAME;
    span.end = span.start + (unsigned)length;
    word = arena_copy(parse->arena, text, length);
    behind = length + strspn(text + length, " \t");
    if (*text == '}') {
        diag_error(parse->diag, CODE_UNCLOSED, span, "this '}' closes nothing");
        return;
    }
    diag_error(parse->diag, CODE_STATEMENT, span, "no statement begins with '%s'", word);
    if (beginning)
        diag_did_you_mean(parse->diag, beginning);
    else if (strchr("([{*", *text) && prose_row_count(text))
        diag_hint(parse->diag, "so many rows of the same stitches: `Next %d rows: ...`", words_number(text + prose_row_count(text)));
    else if (syntax_is_row(text + (*text == '{')))
        diag_hint(parse->diag, "a row begins with its name: `Row 1: ...`");
    else if (text[behind] == '=' && text[behind + 1] != '=')
        diag_hint(parse->diag, "to give a name to a value: `let %s = ...`", word);
    else if (strcmp(word, "else") == 0)
        diag_hint(parse->diag, "an `else` stands behind the '}' of its `if`");
    else if (text[length] == '(' || strcmp(word, "each") == 0)
        diag_hint(parse->diag, "to fold it: `swatch %s%s`", word, text[length] == '(' ? "(..)" : " ..");
    else
        diag_did_you_mean(parse->diag, nearest_in(word, statement_word, nstatement_words));
}

/* What was found, as the script has it. */
static const char *found_text(struct parse *parse, struct span span, const char *found)
{
    size_t length = span.end - span.start;

    if (length && strchr(";.", span.source->text[span.start]))
        length = 1;
    else if (!found || strncmp(found, "the end", 7) == 0 || length == 0)
        return found ? found : "nothing";
    if (length > 30 || memchr(span.source->text + span.start, '\n', length))
        return found;
    return arena_printf(parse->arena, "'%.*s'", (int)length, span.source->text + span.start);
}

const char *syntax_meant(struct parse *parse, struct span span)
{
    size_t length = span.end - span.start;

    return length < LIMIT_NAME ? typos_meant(arena_copy(parse->arena, span.source->text + span.start, length)) : NULL;
}

/* What cannot be read in a row is often a part of what cannot be knitted there. */
static bool refused_row(struct parse *parse, struct span span)
{
    int statement = parse->scanner->statement;
    struct span line = {span.source, 0, 0};

    words_line_is_long(&parse->line, span.source->text, span.start);
    line.start = (unsigned)parse->line.start;
    line.end = (unsigned)parse->line.end;

    /* `Knit 3 rows, increasing 2 sts`: what stands behind. */
    if ((statement == TOKEN_PLAIN_ROWS || statement == TOKEN_WORK || statement == TOKEN_GO_ON_ROWS) && span.source->text[span.start] == ',')
        line.start = span.start;
    else if (statement != TOKEN_ROW && statement != TOKEN_ALL && statement != TOKEN_SETUP && statement != TOKEN_AS_ROW)
        return false;
    if (prose_begins_cast_on(span.source->text + line.start))
        line.start += (unsigned)strcspn(span.source->text + line.start, ".\r\n");
    line.end = line.end > line.start + LIMIT_REFUSED ? line.start + LIMIT_REFUSED : line.end;
    if (line.start >= parse->knitted.start && line.start < parse->knitted.end)
        line.start = parse->knitted.end;
    if (line.start >= line.end)
        return false;
    if (refused_text(parse->diag, line))
        return true;
    parse->knitted = line;
    return false;
}

void syntax_star_is_left(struct parse *parse, struct span span)
{
    diag_error(parse->diag, CODE_SYNTAX, span, "the row's '*' is left without its `rep from *`");
    diag_hint(parse->diag, "`*k2, p2; rep from * to end`, or to the last stitches: `rep from * to last 2 sts, k2`");
}

/* `k2, p2; rep from *`: where the repeat begins is not marked. */
static bool star_is_missing(struct parse *parse, struct span span)
{
    unsigned at = span.start;

    while (at > 0 && !strchr("*:\r\n", span.source->text[at - 1]))
        at--;
    if (at > 0 && span.source->text[at - 1] == '*')
        return false;
    diag_error(parse->diag, CODE_SYNTAX, span, "no '*' before this says where the repeat begins");
    diag_hint(parse->diag, "`*k2, p2; rep from * to end`: put the '*' before the first stitch that is repeated; whole rows: `Repeat rows 1-4 once`");
    return true;
}

/* `k2, p2* to end`: a star that stands alone behind what is repeated. */
static bool star_closes_nothing(struct parse *parse, struct span span)
{
    const char *text = span.source->text;
    unsigned at = span.start;

    while (at > 0 && strchr(" \t", text[at - 1]))
        at--;
    if (at < 2 || text[at - 1] != '*' || !isalnum((unsigned char)text[at - 2]))
        return false;
    return star_is_missing(parse, (struct span){span.source, at - 1, at});
}

/* `in rib`, without its numbers. */
static bool names_rib(struct span span)
{
    size_t length = span.end - span.start;
    const char *text = span.source->text + span.start;

    return (length == 3 || length == 7) && strncasecmp(text, "ribbing", length) == 0;
}

/* The token that closes a bracket. */
static const char *closing_of(struct span open)
{
    char c = open.source->text[open.start];

    return c == '(' ? "')'" : c == '[' ? "']'" : "'}'";
}

/* A bracket that is open where only its end could stand, or closed without being open. */
static bool bracket_is_alone(struct parse *parse, struct span span, bool at_end, const char *const *expected, int n)
{
    struct span open = parse->scanner->unclosed;
    char c = span.source->text[span.start];

    if (at_end && open.source && expected_has(expected, n, closing_of(open))) {
        diag_error(parse->diag, CODE_UNCLOSED, open, "this '%c' is not closed on its line", open.source->text[open.start]);
        return true;
    }
    if (at_end || !strchr(")]}", c) || expected_has(expected, n, "')'") || expected_has(expected, n, "']'") || expected_has(expected, n, "'}'"))
        return false;
    diag_error(parse->diag, CODE_UNCLOSED, span, "this '%c' closes nothing", c);
    return true;
}

/* A word that was meant, or the way the statement is written. */
static void hint_form(struct parse *parse, struct span span, const char *list)
{
    const char *meant = syntax_meant(parse, span), *form = expected_form(parse->scanner->statement);
    bool again = parse->scanner->statement == TOKEN_REPEAT_ROWS, knits = again || parse->scanner->statement == TOKEN_WORK;

    if (words_one_of("for a total of", span.source->text + span.start))
        diag_hint(parse->diag, "how often, or how many rows in all: `Repeat row 1 12 times`, or `Repeat row 1 for a total of 12 rows`");
    else if (names_rib(span))
        diag_hint(parse->diag, "which rib this is: `Work 4 rows in k2, p2 rib`");
    else if (meant && (!form || knits || (list && strstr(list, meant))))
        diag_did_you_mean(parse->diag, meant);
    else if (form && (list ? !strstr(list, "a value") : again))
        diag_hint(parse->diag, "%s", form);
}

void syntax_error(struct parse *parse, struct span span, const char *found, const char *const *expected,
                  int n)
{
    bool at_end = found && strncmp(found, "the end", 7) == 0;
    const char *list;

    if (parse->scanner->quiet || refused_row(parse, span))
        return;
    list = expected_list(parse->arena, expected, n);
    if (!at_end && begins_statement(span) && !list) {
        no_statement(parse, span);
        return;
    }
    if (at_end && span.end > span.start + 1)
        span.end = span.start + 1;
    if (parse->scanner->star_left) {
        syntax_star_is_left(parse, span);
        return;
    }
    if (bracket_is_alone(parse, span, at_end, expected, n))
        return;
    if (found && strcmp(found, "'rep from *'") == 0 ? star_is_missing(parse, span) : star_closes_nothing(parse, span))
        return;
    if (list)
        diag_error(parse->diag, CODE_SYNTAX, span, "expected %s, found %s", list, found_text(parse, span, found));
    else if (at_end)
        diag_error(parse->diag, CODE_SYNTAX, span, "the line ends too early");
    else
        diag_error(parse->diag, CODE_SYNTAX, span, "did not expect %s here", found_text(parse, span, found));
    hint_form(parse, span, list);
}

int syntax_unknown_word(struct parse *parse, struct span span, const char *expected)
{
    const char *found = span.end > span.start ? "a word" : "the end of the line";

    diag_error(parse->diag, CODE_SYNTAX, span, "expected %s, found %s", expected, found_text(parse, span, found));
    diag_did_you_mean(parse->diag, syntax_meant(parse, span));
    return TOKEN_KNIT_error;
}
