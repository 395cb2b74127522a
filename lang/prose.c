/* SPDX-License-Identifier: GPL-3.0-or-later
 * A line of a pasted page in, whether it is prose out.  What cannot be told
 * apart from a mistyped statement is none: it stays an error. */
#include "lang/prose.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

#include "lang/refused.h"
#include "lang/scanner.h"
#include "lang/settings.h"
#include "lang/syntax.h"
#include "lang/typos.h"

enum { TITLE_LINES = 3, TITLE_WORDS = 10, SENTENCE = 6, LONG_SENTENCE = 8, SHORT_SENTENCE = 2, LONGEST = 4000 };

static size_t line_length(const char *text)
{
    return strcspn(text, "\r\n");
}

static size_t word_length(const char *text)
{
    size_t n = 0;

    while (isalpha((unsigned char)text[n]))
        n++;
    return n;
}

static const char *skip_blanks(const char *text)
{
    return text + strspn(text, " \t\f\v");
}

/* The next line that is not empty. */
static const char *next_line(const char *text)
{
    text += line_length(text);
    return text + strspn(text, " \t\f\v\r\n");
}

static bool is_one_of(const char *text, const char *const *word, int n)
{
    size_t length = word_length(text);

    for (int i = 0; i < n; i++)
        if (strncasecmp(text, word[i], length) == 0 && !word[i][length])
            return true;
    return false;
}

static bool is_word(const char *text, const char *word)
{
    return is_one_of(text, &word, 1);
}

/* Whether one of the characters stands on the line. */
static bool line_has(const char *text, const char *characters)
{
    size_t n = line_length(text);

    /* `**` makes letters bold. */
    for (size_t i = 0; i < n; i++)
        if (text[i] == '*' && text[i + 1] == '*')
            i++;
        else if (strchr(characters, text[i]))
            return true;
    return false;
}

static bool line_has_word(const char *text, const char *word)
{
    size_t n = line_length(text);

    for (size_t i = 0; i < n; i += word_length(text + i) + 1)
        if (is_word(text + i, word))
            return true;
    return false;
}

static bool is_rows_word(const char *text);
static const char *behind_number(const char *text);

/* ---- parts of a line ---- */

bool prose_line_ends(const char *text)
{
    text = skip_blanks(text);
    text += *text == '.';
    return !*skip_blanks(text) || strchr("\r\n#", *skip_blanks(text));
}

bool prose_names_row(const char *text)
{
    static const char *const word[] = {"row", "rows", "round", "rounds", "rnd", "rnds", "rd", "rds"};
    size_t n = strcspn(text, ":\r\n");

    for (size_t i = 0; i < n; i += word_length(text + i) + 1)
        if (is_one_of(text + i, word, sizeof word / sizeof *word))
            return true;
    return false;
}

bool prose_statement_follows(const char *text)
{
    static const char *const word[] = {"row",  "rows", "round", "rounds", "rnd",    "rnds", "cast", "co",   "bind",
                                       "knit", "purl", "work",  "rep",    "repeat", "with", "using", "weave", "bo"};

    text += strspn(text, "*_ \t");
    if (behind_number(text))
        return is_rows_word(behind_number(text));
    return is_one_of(text, word, sizeof word / sizeof *word);
}

static bool is_rows_word(const char *text)
{
    static const char *const word[] = {"row", "rows", "round", "rounds", "rnd", "rnds", "rd", "rds"};

    return is_one_of(text, word, sizeof word / sizeof *word);
}

static bool is_stitches_word(const char *text)
{
    static const char *const word[] = {"st", "sts", "stitch", "stitches"};

    return is_one_of(text, word, sizeof word / sizeof *word);
}

/* Behind a number in figures or in letters; or NULL. */
static const char *behind_number(const char *text)
{
    static const char *const word[] = {"one", "two", "three", "four", "five", "six", "seven", "eight", "nine", "ten", "eleven", "twelve"};
    size_t digits = strspn(text, "0123456789");

    if (digits)
        return skip_blanks(text + digits);
    return is_one_of(text, word, sizeof word / sizeof *word) ? skip_blanks(text + word_length(text)) : NULL;
}

bool prose_has_cast_on(const char *text)
{
    static const char *const multiple[] = {"multiple", "mult", "odd", "even", "any", "number"};
    const char *behind = behind_number(text = skip_blanks(text));

    if (!behind)
        return is_one_of(skip_blanks(text + word_length(text)), multiple, sizeof multiple / sizeof *multiple);
    behind += strcspn(behind, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ.\r\n");
    return is_stitches_word(behind);
}

bool prose_repeats_rows(const char *text)
{
    static const char *const word[] = {"for",  "these", "this",    "those", "last", "them", "all", "pattern",
                                       "previous", "preceding", "in", "as"};

    text = skip_blanks(text);
    if (is_word(text, "from") || is_word(text, "the"))
        text = skip_blanks(text + word_length(text));
    return is_one_of(text, word, sizeof word / sizeof *word) || is_rows_word(text) || (is_word(text, "r") && isdigit((unsigned char)text[1])) ||
           (isdigit((unsigned char)*text) && isalpha((unsigned char)text[strspn(text, "0123456789")]));
}

bool prose_fabric_follows(const char *text)
{
    static const char *const word[] = {"garter", "g",    "rev",   "reverse", "stockinette", "stocking", "stockinet",
                                       "st",     "seed", "moss",  "single",  "double"};
    const char *by = skip_blanks(text + strspn(text, "0123456789"));

    return is_one_of(text, word, sizeof word / sizeof *word) ||
           (isdigit((unsigned char)*text) && ((*by && strchr("xX/\xC3", *by)) || is_word(by, "by"))) ||
           (strchr("kK", *text) && isdigit((unsigned char)*skip_blanks(text + 1)));
}

bool prose_casts_some(const char *text)
{
    static const char *const word[] = {"beg", "beginning", "each", "next"};
    const char *off = text;

    while (*off && !is_word(off, "off"))
        off += word_length(off) ? word_length(off) : 1;
    if (!*off || !isdigit((unsigned char)*skip_blanks(off + 3)))
        return false;
    for (size_t i = 0; i < sizeof word / sizeof *word; i++)
        if (line_has_word(text, word[i]))
            return true;
    return line_has_word(text, "to") && line_has_word(text, "end");
}

size_t prose_begins_cast_on(const char *text)
{
    const char *on = skip_blanks(text + word_length(text));

    if (is_word(text, "co"))
        return behind_number(on) ? 2 : 0;
    return is_word(text, "cast") && is_word(on, "on") && behind_number(skip_blanks(on + 2)) ? (size_t)(on + 2 - text) : 0;
}

size_t prose_rows_within(const char *text)
{
    static const char *const work[] = {"knit", "purl", "k", "p", "work"}, *const every[] = {"every", "each", "all"};

    for (size_t i = 1; text[i]; i++) {
        const char *behind = skip_blanks(text + i + word_length(text + i)), *rows = behind_number(behind);

        if (isalnum((unsigned char)text[i - 1]) || !is_one_of(text + i, work, sizeof work / sizeof *work))
            continue;
        if ((rows && is_rows_word(rows)) || (is_word(text + i, "work") && prose_row_follows(behind)) || (is_one_of(behind, every, 3) && is_rows_word(skip_blanks(behind + word_length(behind)))) ||
            (is_word(text + i, "work") && is_word(behind, "in") && prose_fabric_follows(skip_blanks(behind + 2))))
            return i;
    }
    return 0;
}

size_t prose_row_count(const char *sentence)
{
    for (size_t i = 1; sentence[i]; i++) {
        const char *behind = isspace((unsigned char)sentence[i - 1]) ? behind_number(sentence + i) : NULL;

        if (behind && is_word(behind, "more"))
            behind = skip_blanks(behind + 4);
        if (behind && is_rows_word(behind))
            return i;
    }
    return 0;
}

static bool says_how_often(const char *text)
{
    static const char *const word[] = {"once", "twice", "times", "time", "more", "until", "for"};

    for (size_t i = 0; i < sizeof word / sizeof *word; i++)
        if (line_has_word(text, word[i]))
            return true;
    return false;
}

/* `k2, p2`, `*p1`, `knit`, `knit to end`, `rep row 1`. */
bool prose_stitches_follow(const char *text)
{
    static const char *const stitch[] = {"k", "knit", "p", "purl"}, *const behind[] = {"to", "across", "all"},
                     *const same[] = {"as", "rep", "repeat"};
    const char *next;

    text += strspn(text, " \t|");
    if ((*text == '*' && text[1] != '*') || (*text == '(' && syntax_is_row(text + 1)) || (*text == '[' && syntax_is_row(text + 1)))
        return true;
    next = skip_blanks(text + word_length(text));
    if (is_one_of(text, same, 3))
        return (is_rows_word(next) && !says_how_often(next)) || (isdigit((unsigned char)*next) && prose_line_ends(next + strspn(next, "0123456789")));
    if (!is_one_of(text, stitch, 4) && !(strchr("kKpP", *text) && isdigit((unsigned char)text[1])))
        return false;
    return isdigit((unsigned char)text[1]) || !*next || strchr(".,|\r\n", *next) || is_one_of(next, behind, 3) ||
           (isdigit((unsigned char)*next) && !is_rows_word(skip_blanks(next + strspn(next, "0123456789"))));
}

bool prose_row_line(const char *text)
{
    static const char *const stitch[] = {"k", "knit", "p", "purl"};
    const char *first = text + (*text == '*'), *number = skip_blanks(first + word_length(first));

    return is_one_of(first, stitch, 4) && isdigit((unsigned char)*number) && !is_rows_word(skip_blanks(number + strspn(number, "0123456789"))) &&
           !line_has_word(text, "rib") && !line_has_word(text, "ribbing") && !line_has_word(text, "rows") && !line_has_word(text, "more");
}

bool prose_repeat_follows(const char *text)
{
    static const char *const word[] = {"rep", "repeat"};

    return is_one_of(skip_blanks(text), word, 2);
}

bool prose_count_follows(const char *text)
{
    const char *sts;

    text = skip_blanks(text);
    sts = skip_blanks(text + strspn(text, "0123456789"));
    return sts > text && is_stitches_word(sts) && prose_line_ends(sts + word_length(sts));
}

bool prose_times_follow(const char *text)
{
    const char *behind = behind_number(skip_blanks(text));

    return behind && (is_word(behind, "times") || is_word(behind, "time") || is_word(behind, "more"));
}

bool prose_comma_is_idle(const char *text)
{
    return prose_times_follow(text) || *skip_blanks(text) == '.' || is_word(skip_blanks(text), "or");
}

bool prose_row_is_named(const char *text)
{
    text = skip_blanks(text);
    return is_rows_word(text) && *skip_blanks(text + word_length(text)) == ':';
}

bool prose_is_meaning(const char *text)
{
    text += strncasecmp(text, "(s)", 3) == 0 ? 3 : 0;
    return *skip_blanks(text) == '=';
}

bool prose_row_word(const char *text)
{
    return is_one_of(text, statement_word, nstatement_words) || is_rows_word(text);
}

bool prose_rows_follow(const char *text)
{
    const char *behind = *text == '{' ? text + strcspn(text, "}\r\n") : behind_number(text);

    if (behind && *behind == '}')
        behind = skip_blanks(behind + 1);
    if (behind && is_word(behind, "more"))
        behind = skip_blanks(behind + 4);
    return behind && is_rows_word(behind);
}

bool prose_row_follows(const char *text)
{
    return is_rows_word(text) && isdigit((unsigned char)*skip_blanks(text + word_length(text)));
}

bool prose_is_remark(const char *text)
{
    size_t n = 1, longest = 0;

    for (; isalpha((unsigned char)text[n]) || strchr(" ,-!'", text[n] ? text[n] : '.'); n += word_length(text + n) ? word_length(text + n) : 1)
        longest = word_length(text + n) > longest ? word_length(text + n) : longest;
    return *text == '(' && longest > 2 && text[n] == ')' && *skip_blanks(text + n + 1) == ':';
}

/* Behind the numbers and the side of a row's head; or NULL. */
static const char *behind_head(const char *text)
{
    if (!is_rows_word(text))
        return NULL;
    text = skip_blanks(text + word_length(text));
    if (!isdigit((unsigned char)*text))
        return NULL;
    while (isdigit((unsigned char)*text) || strchr(" \t-,&()", *text ? *text : '.') || is_word(text, "and") || is_word(text, "to") ||
           is_word(text, "rs") || is_word(text, "ws"))
        text += word_length(text) ? word_length(text) : 1;
    return text;
}

bool prose_pattern_follows(const char *text)
{
    static const char *const multiple[] = {"multiple", "mult"};
    const char *head = behind_head(text), *number = skip_blanks(text + word_length(text));

    if (head)
        return *head == ':' || prose_stitches_follow(head);
    if (is_word(text, "co"))
        return prose_has_cast_on(number);
    if (is_word(text, "cast"))
        return is_word(number, "on") && prose_has_cast_on(number + 2);
    return is_one_of(text, multiple, 2) && is_word(number, "of");
}

/* ---- a statement's word that begins a sentence ---- */

static bool opens_block(const char *text)
{
    return line_has(text, "{") || *next_line(text) == '{';
}

static bool no_version(const char *text)
{
    return !isdigit((unsigned char)*text) && !strchr("-.(", *text);
}

/* `width = 3`, `(width = 3`: a brace is missing. */
static bool is_setting(const char *text)
{
    static const char *const stitch[] = {"kx", "ky", "twist", "symbol", "ws"};
    const char *name = skip_blanks(text + (*text == '('));
    size_t length = strcspn(name, "= \t\r\n");

    return *skip_blanks(name + length) == '=' && (settings_is_key(name, length) || is_one_of(name, stitch, sizeof stitch / sizeof *stitch));
}

static bool no_block(const char *text)
{
    return *text != '{' && *next_line(text) != '{' && !is_setting(text);
}

static bool no_body(const char *text)
{
    return !opens_block(text) && !is_setting(skip_blanks(text + word_length(text)));
}

static bool no_loop(const char *text)
{
    return !opens_block(text) && !line_has(text, "[]=") && !strstr(text, "..");
}

static bool no_file(const char *text)
{
    return *text != '"' && *text != '\xE2' && !line_has_word(text, "from") && !line_has_word(text, "std");
}

static bool is_labelled(const char *text)
{
    return *text == ':';
}

bool prose_is_keyword(const char *text)
{
    static const struct {
        const char *word;
        bool (*none)(const char *behind);
    } words[] = {{"knit", no_version}, {"gauge", no_block}, {"material", no_block},  {"springs", no_block},
                 {"mesh", no_block},   {"solve", no_block}, {"stitch", no_body},     {"chart", no_body},
                 {"if", no_body},      {"for", no_loop},    {"swatch", is_labelled}, {"motif", is_labelled},
                 {"use", no_file}};
    const char *behind = skip_blanks(text + word_length(text));

    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (is_word(text, words[i].word))
            return *behind && !strchr("\r\n", *behind) && words[i].none(behind) && prose_reads(text, true);
    return false;
}

/* ---- sentences ---- */

static int count_words(const char *text)
{
    size_t n = line_length(text);
    int words = 0;

    for (size_t i = 0; i < n; i++)
        words += isalnum((unsigned char)text[i]) && (i == 0 || isspace((unsigned char)text[i - 1]));
    return words;
}

/* Words that begin a sentence, though some are nearly a statement's. */
static const char *const sentence_word[] = {"the", "this", "you", "it", "we", "my", "how", "when", "now", "our", "your", "there", "these", "that", "then", "set"};
enum { nsentence_words = sizeof sentence_word / sizeof *sentence_word };

/* `Casst`, `swach`: the first word is nearly a statement's. */
static bool is_nearly_statement(const char *text)
{
    char word[32] = "";
    size_t n = word_length(text);
    struct nearest nearest;

    if (n < 3 || n >= sizeof word || text[n] == '-' || is_one_of(text, sentence_word, nsentence_words))
        return false;
    memcpy(word, text, n);
    nearest = nearest_to(word);
    for (int i = 0; i < nstatement_words; i++) {
        if (strcasecmp(word, statement_word[i]) == 0)
            return false;
        nearest_offer(&nearest, statement_word[i]);
    }
    return nearest.best && nearest.distance <= 1 && strlen(nearest.best) + 1 >= n && strlen(nearest.best) <= n + 1;
}

/* `Casst on 22`, `swach tile(..)`: the first word is nearly a statement's, and what
 * follows is no mere text. */
static bool is_mistyped(const char *text)
{
    size_t length;

    return typos_beginning(text, &length) || (line_has(text, "0123456789:\"=({") && is_nearly_statement(text));
}

/* `k2`, `P10`: a stitch with its number. */
static bool has_stitches(const char *text)
{
    size_t n = line_length(text);

    for (size_t i = 0; i + 1 < n; i++) {
        bool begins = i == 0 || !isalnum((unsigned char)text[i - 1]);
        size_t digits = strspn(text + i + 1, "0123456789");

        if (begins && strchr("kKpP", text[i]) && digits && !isalpha((unsigned char)text[i + 1 + digits]))
            return true;
    }
    return false;
}

/* `tile(`, but not `st(s)`. */
static bool has_call(const char *text)
{
    size_t n = line_length(text);

    for (size_t i = 1; i < n; i++)
        if (text[i] == '(' && (isalnum((unsigned char)text[i - 1]) || text[i - 1] == '_') &&
            strncasecmp(text + i, "(s)", 3) != 0 && strncasecmp(text + i, "(es)", 4) != 0)
            return true;
    return false;
}

/* Whether so many plain words stand on the line that signs and stitches among them do not matter. */
static bool is_long_sentence(const char *text)
{
    static const char *const work[] = {"knit", "purl", "repeat", "rep", "from", "end", "row", "rows", "last", "sts", "times", "stitches",
                                       "twice", "stitch", "until", "remaining", "again", "more", "across", "then", "and", "the", "once"};
    size_t n = line_length(text);
    int words = 0;

    for (size_t at = 0, length; at < n; at += length ? length : 1) {
        length = word_length(text + at);
        words += length > 2 && !is_one_of(text + at, work, sizeof work / sizeof *work);
    }
    return words >= (is_one_of(text, sentence_word, nsentence_words) ? SHORT_SENTENCE : LONG_SENTENCE) && text[word_length(text)] == ' ';
}

bool prose_is_named_row(const char *text)
{
    static const char *const row[] = {"row", "rnd", "round"};
    const char *behind = text;

    for (int words = 0; words < 2 && !is_one_of(behind, row, sizeof row / sizeof *row); words++)
        behind = skip_blanks(behind + word_length(behind));
    if (behind == text || is_mistyped(text) || !is_one_of(behind, row, sizeof row / sizeof *row))
        return false;
    behind = skip_blanks(behind + word_length(behind));
    if (*behind == '(')
        behind = skip_blanks(behind + strcspn(behind, ":\r\n"));
    return *behind == ':' && prose_stitches_follow(skip_blanks(behind + 1));
}

/* `Repeat rows 1-4 until the piece measures ...` */
static bool is_repeat_until(const char *text)
{
    const char *behind = is_word(text, "repeat") || is_word(text, "rep") ? skip_blanks(text + word_length(text)) : NULL;

    return behind && is_rows_word(behind) && (line_has_word(behind, "until") || line_has_word(behind, "till"));
}

bool prose_reads(const char *text, bool loose)
{
    text += *text == '(' && isupper((unsigned char)text[1]) && count_words(text) >= SENTENCE;
    if (line_length(text) > LONGEST || line_has(text, "{}") || is_mistyped(text) || is_repeat_until(text))
        return false;
    if (loose || is_long_sentence(text))
        return true;
    return !line_has(text, "[]\"=<>*|") && !has_stitches(text) && !has_call(text) &&
           (word_length(text) > 0 || (isdigit((unsigned char)*text) && count_words(text) >= SENTENCE)) && (count_words(text) > 1 || line_has(text, ":!"));
}

/* `Set 1:`, `Section B` on a line. */
static bool is_numbered_heading(const char *text)
{
    size_t n = word_length(text), digits = strspn(text + n + 1, "0123456789"), end;

    if (n < 3 || text[n] != ' ' || is_rows_word(text) || !isupper((unsigned char)*text))
        return false;
    end = n + 1 + (digits ? digits : isupper((unsigned char)text[n + 1]) != 0);
    return end > n + 1 && (text[end] == ':' ? prose_line_ends(text + end + 1) : text[end] && prose_line_ends(text + end) && !digits);
}

/* `Ribbing` alone above a row. */
static bool is_heading(const char *text)
{
    static const char *const rows[] = {"set", "setup", "foundation", "next", "all", "every"};
    size_t n = word_length(text);

    if (is_numbered_heading(text))
        return true;
    return n > 2 && isupper((unsigned char)*text) && prose_line_ends(text + n) && !is_nearly_statement(text) && !is_rows_word(text) &&
           (prose_statement_follows(next_line(text)) || is_one_of(next_line(text), rows, sizeof rows / sizeof *rows));
}

/* "22 sts", "4 rows": more than a title says. */
static bool has_count(const char *text)
{
    static const char *const word[] = {"st", "sts", "stitch", "stitches", "row", "rows", "round", "rounds", "times"};
    size_t n = line_length(text);

    for (size_t i = 0; i < n; i++)
        if (isdigit((unsigned char)text[i]) && is_one_of(skip_blanks(text + i + 1), word, sizeof word / sizeof *word))
            return true;
    return false;
}

/* Quotes that do not stand in brackets: `SQUARE No. 7 ("Windows")` is a name. */
static bool has_bare_quote(const char *text)
{
    size_t n = line_length(text);

    for (size_t i = 1; i < n; i++)
        if (text[i] == '"' && text[i - 1] != '(' && text[i + 1] != ')')
            return true;
    return *text == '"';
}

bool prose_is_title(const char *text)
{
    text += *text == '(' && word_length(text + 1) > 4;
    return !line_has(text, "{}[]=<>*|") && !has_bare_quote(text) && !is_mistyped(text) && !syntax_is_row(text) && !has_stitches(text) &&
           !has_call(text) && !has_count(text) && count_words(text) > 0 && count_words(text) <= TITLE_WORDS &&
           (word_length(text) > 0 || count_words(text) > 1);
}

/* ---- in the scanner ---- */

void prose_warn_hidden(struct scanner *scanner, struct span line)
{
    const char *text = scanner->parse->text + line.start;

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

/* `let`, `swatch`, `gauge`, .. and no sentence that begins so. */
static bool is_keyword(const char *text)
{
    static const char *const word[] = {"let", "param", "output", "sweep", "swatch", "motif", "use", "stitch", "gauge", "material", "springs", "mesh", "solve"};

    return is_one_of(text, word, sizeof word / sizeof *word) && !prose_is_keyword(text);
}

/* How many lines from here on read as prose; `end` is behind the last. */
static int block_length(const char *text, const char **end)
{
    int n = 0;

    do {
        n++;
        *end = text + line_length(text);
        text = next_line(text);
    } while (*text && !prose_statement_follows(text) && !is_labelled_statement(text) && !is_keyword(text) &&
             !prose_is_keyword(text) && prose_reads(text, false));
    return n;
}

bool prose_of_multiple(const struct scanner *scanner)
{
    const char *text = SCANNER_TEXT(scanner);

    while (text > scanner->parse->text && !strchr("\r\n", text[-1]))
        text--;
    return line_has_word(text, "multiple") || line_has_word(text, "multiples") || line_has_word(text, "mult");
}

size_t prose_sizes_length(const char *text, int *n)
{
    const char *at = text + 1, *close;

    for (*n = 0; isdigit((unsigned char)*(at += strspn(at, " \t"))); ++*n) {
        at += strspn(at, "0123456789");
        at += strspn(at, " \t");
        if (!strchr(",:/-", *at) || !*at) {
            ++*n;
            break;
        }
        at++;
    }
    close = at + strspn(at, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ \t.");
    if (*close != (*text == '(' ? ')' : ']') || (*n == 1 && close > at))
        return 0;
    return *n ? (size_t)(close + 1 - text) : 0;
}

bool prose_sizes(struct scanner *scanner, struct span line)
{
    static const char *const word[] = {"row", "rows", "rnd", "rnds", "round", "rounds", "times", "more"};
    const char *text = scanner->parse->text;

    for (unsigned at = line.start; at < line.end; at++) {
        size_t close = strcspn(text + at, ")]\r\n");

        if (strchr("([", text[at]) && strchr(")]", text[at + close]) && text[at + close] &&
            is_one_of(skip_blanks(text + at + close + 1), word, sizeof word / sizeof *word) &&
            scanner_sizes(scanner, (struct span){line.source, at, at + 1}))
            return true;
    }
    return false;
}

bool scanner_prose(struct scanner *scanner)
{
    struct parse *parse = scanner->parse;
    const char *text = parse->text + scanner->at, *end;
    struct span span = {parse->source, scanner->at, scanner->at + (unsigned)line_length(text)};
    int lines;

    if (scanner->at < scanner->prose_end)
        return prose_reads(text, false);
    if (scanner->section && prose_reads(text, true) && !syntax_is_row(text)) {
        prose_warn_hidden(scanner, span);
        return true;
    }
    if (!scanner->begun && scanner->titles < TITLE_LINES && prose_is_title(text)) {
        scanner->titles++;
        return true;
    }
    if (!prose_is_keyword(text) && !prose_reads(text, false) && !is_heading(text))
        return false;

    if (scanner->begun && prose_sizes(scanner, span))
        return true;

    /* An instruction is none, once there is a pattern. */
    if (scanner->begun && refused_sentence(parse->diag, span))
        return true;

    /* Nothing says what this is: it is named, once for lines that follow each other. */
    lines = block_length(text, &end);
    scanner->prose_end = (unsigned)(end - parse->text);
    if (lines == 1)
        diag_warning(parse->diag, CODE_PROSE, span, "this line is read as text, not as a part of the pattern");
    else
        diag_warning(parse->diag, CODE_PROSE, span,
                     "these %d lines are read as text, not as a part of the pattern", lines);
    diag_hint(parse->diag, "a row begins with its name: `Row 1: ...`; '#' before a text keeps it silent");
    return true;
}
