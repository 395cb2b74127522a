/* SPDX-License-Identifier: GPL-3.0-or-later
 * A line of a pasted page in, whether it is prose out.  What cannot be told
 * apart from a mistyped statement is none: it stays an error. */
#include "lang/prose.h"

#include <ctype.h>
#include <limits.h>
#include <string.h>
#include <strings.h>

#include "lang/headings.h"
#include "lang/page_chart.h"
#include "lang/refused.h"
#include "lang/scanner.h"
#include "lang/settings.h"
#include "lang/syntax.h"
#include "lang/typos.h"
#include "lang/words.h"

enum { TITLE_LINES = 3, TITLE_WORDS = 10, SENTENCE = 6, LONG_SENTENCE = 8, SHORT_SENTENCE = 2, NAME_WORDS = 3 };

/* The next line that is not empty. */
static const char *next_line(const char *text)
{
    text += words_line_within(text, WORDS_LINE);
    return text + strspn(text, " \t\f\v\r\n");
}

/* Whether one of the characters stands on the line. */
static bool line_has(const char *text, const char *characters)
{
    size_t n = words_line_within(text, WORDS_LINE);
    bool wanted[UCHAR_MAX + 1] = {false};

    for (; *characters; characters++)
        wanted[(unsigned char)*characters] = true;

    /* `**` makes letters bold. */
    for (size_t i = 0; i < n; i++)
        if (text[i] == '*' && text[i + 1] == '*')
            i++;
        else if (wanted[(unsigned char)text[i]])
            return true;
    return false;
}

static int count_words(const char *text)
{
    size_t n = words_line_length(text);
    int words = 0;

    for (size_t i = 0; i < n; i++)
        words += isalnum((unsigned char)text[i]) && (i == 0 || isspace((unsigned char)text[i - 1]));
    return words;
}

/* ---- a statement's word that begins a sentence ---- */

static bool opens_block(const char *text)
{
    return line_has(text, "{") || *next_line(text) == '{';
}

/* `knit (K), purl (P)` */
static bool no_version(const char *text)
{
    text += *text == '(';
    return !isdigit((unsigned char)*text) && (!strchr("-.(", *text) || isalpha((unsigned char)text[1]));
}

/* `width = 3`, `(width = 3`: a brace is missing. */
static bool is_setting(const char *text)
{
    static const char *const stitch[] = {"kx", "ky", "twist", "symbol", "ws"};
    const char *name = words_skip_blanks(text + (*text == '('));
    size_t length = strcspn(name, "= \t\r\n");

    return *words_skip_blanks(name + length) == '=' && (settings_is_key(name, length) || words_find(name, stitch, sizeof stitch / sizeof *stitch) >= 0);
}

static bool no_block(const char *text)
{
    return *text != '{' && *next_line(text) != '{' && !is_setting(text);
}

static bool no_body(const char *text)
{
    return !opens_block(text) && !is_setting(words_skip_blanks(text + words_length(text)));
}

static bool no_loop(const char *text)
{
    const char *dots = strpbrk(text, "\r\n.");

    while (dots && *dots == '.' && dots[1] != '.')
        dots = strpbrk(dots + 1, "\r\n.");
    return !opens_block(text) && !line_has(text, "[]=") && !(dots && *dots == '.');
}

static bool no_file(const char *text)
{
    return *text != '"' && *text != '\xE2' && !words_line_has(text, "from") && !words_line_has(text, "std");
}

/* "Let me know how it goes": more words, and no value. */
static bool no_value(const char *text)
{
    return !line_has(text, "=0123456789") && words_length(words_skip_blanks(text + words_length(text))) > 0;
}

static bool is_labelled(const char *text)
{
    return *text == ':';
}

/* `swatch: ..`, `swatch we are going to knit` */
static bool no_fabric(const char *text)
{
    const char *behind = text + words_length(text);

    /* Two words that follow each other are no value. */
    return is_labelled(text) || (behind > text && *behind == ' ' && words_length(words_skip_blanks(behind)) > 0 && !words_is(text, "each"));
}

bool prose_is_keyword(const char *text)
{
    static const struct {
        const char *word;
        bool (*none)(const char *behind);
    } words[] = {{"knit", no_version}, {"gauge", no_block}, {"material", no_block},  {"springs", no_block},
                 {"mesh", no_block},   {"solve", no_block}, {"stitch", no_body},     {"chart", no_body},
                 {"if", no_body},      {"for", no_loop},    {"swatch", no_fabric}, {"motif", is_labelled},
                 {"use", no_file},      {"let", no_value}};
    const char *behind = words_skip_blanks(text + words_length(text));

    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (words_is(text, words[i].word))
            return *behind && !strchr("\r\n", *behind) && words[i].none(behind) && prose_reads(text, true);
    return false;
}

/* ---- sentences ---- */

/* Words that begin a sentence, though some are nearly a statement's. */
static const char *const sentence_word[] = {"the", "this", "you", "it", "we", "my", "how", "when", "now", "our", "your", "there", "these", "that", "then", "set", "and", "but", "here", "good"};
enum { nsentence_words = sizeof sentence_word / sizeof *sentence_word };

/* `COT BLANKET`, `Red Scarf`: what follows the short word follows none of a statement. */
static bool is_short_word(const char *text)
{
    static const char *const behind[] = {"on", "from", "the", "these", "last", "this", "a"};
    const char *next = words_skip_blanks(text + words_length(text));

    return words_length(text) < 4 && words_length(next) > 0 && !words_are_rows(next) && words_find(next, behind, sizeof behind / sizeof *behind) < 0 && !line_has(text, ":\"={");
}

/* `Casst`, `swach`: the first word is nearly a statement's. */
static bool is_nearly_statement(const char *text)
{
    char word[32] = "";
    size_t n = words_length(text);
    struct nearest nearest;

    if (n < 3 || n >= sizeof word || text[n] == '-' || is_short_word(text) || words_find(text, sentence_word, nsentence_words) >= 0)
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
    size_t n = words_line_length(text);

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
    size_t n = words_line_length(text);

    for (size_t i = 1; i < n; i++)
        if (text[i] == '(' && (isalnum((unsigned char)text[i - 1]) || text[i - 1] == '_') &&
            strncasecmp(text + i, "(s)", 3) != 0 && strncasecmp(text + i, "(es)", 4) != 0)
            return true;
    return false;
}

/* Words of a line that are none of work. */
static int count_plain(const char *text)
{
    const unsigned work = WORDS_PLAIN | WORDS_AGAIN | WORDS_ROW | WORDS_STITCH | WORDS_TIMES | WORDS_OFTEN | WORDS_THEN | WORDS_END;
    static const char *const idle[] = {"from", "last", "until", "remaining", "again", "more", "across", "and", "the"};
    size_t n = words_line_length(text);
    int words = 0;

    for (size_t at = 0, length; at < n; at += length ? length : 1) {
        length = words_length(text + at);
        words += length > 2 && !words_are(text + at, work) && words_find(text + at, idle, sizeof idle / sizeof *idle) < 0;
    }
    return words;
}

/* Whether so many plain words stand on the line that signs and stitches among them do not matter. */
bool prose_is_long(const char *text)
{
    return count_plain(text) >= (words_find(text, sentence_word, nsentence_words) >= 0 ? SHORT_SENTENCE : LONG_SENTENCE) && text[words_length(text)] == ' ';
}

/* `Modified K3 - P3 Prayer Shawl`: stitches that are a part of a name. */
static bool names_stitches(const char *text)
{
    return isupper((unsigned char)*text) && words_length(text) > 3 && !prose_row_word(text) && !line_has(text, ":,;") && count_plain(text) >= NAME_WORDS;
}

bool prose_is_named_row(const char *text)
{
    static const char *const row[] = {"row", "rnd", "round"};
    const char *behind = text;

    for (int words = 0; words < 2 && words_find(behind, row, sizeof row / sizeof *row) < 0; words++)
        behind = words_skip_blanks(behind + words_length(behind));
    if (behind == text || is_mistyped(text) || words_find(behind, row, sizeof row / sizeof *row) < 0)
        return false;
    behind = words_skip_blanks(behind + words_length(behind));
    if (*behind == '(')
        behind = words_skip_blanks(behind + strcspn(behind, ":\r\n"));
    return *behind == ':' && prose_stitches_follow(words_skip_blanks(behind + 1));
}

/* `Repeat rows 1-4 until the piece measures ...` */
static bool is_repeat_until(const char *text)
{
    const char *behind = words_is(text, "repeat") || words_is(text, "rep") ? words_skip_blanks(text + words_length(text)) : NULL;

    return behind && words_are_rows(behind) && (words_line_has(behind, "until") || words_line_has(behind, "till"));
}

/* `x.json`, `out/`: not `bumps.` at a sentence's end. */
static bool names_file(const char *text, size_t length)
{
    for (size_t i = 0; i < length; i++)
        if (text[i] == '/' || (text[i] == '.' && i + 1 < length && isalnum((unsigned char)text[i + 1])))
            return true;
    return false;
}

/* Quotes of a statement, `report "x.json"`: not those of `SQUARE No. 7 ("Windows")`, of a "Waffle" cloth, of 8" x 8". */
static bool has_file_name(const char *text)
{
    for (size_t n = words_line_length(text), i = 0; i < n; i++) {
        size_t length = text[i] == '"' ? strcspn(text + i + 1, "\"\r\n") : 0;

        if (text[i] != '"' || (i > 0 && isdigit((unsigned char)text[i - 1])))
            continue;
        if (text[i + 1 + length] != '"' || names_file(text + i + 1, length))
            return true;
        i += length + 1;
    }
    return false;
}

bool prose_reads(const char *text, bool loose)
{
    text += *text == '(' && isupper((unsigned char)text[1]) && count_words(text) >= SENTENCE;
    if (words_line_within(text, WORDS_LINE + 1) > WORDS_LINE || line_has(text, "{}") || is_mistyped(text) || is_repeat_until(text))
        return false;
    if (loose || prose_is_long(text))
        return true;
    return !line_has(text, "[]=<>*|") && !has_file_name(text) && !has_stitches(text) && !has_call(text) &&
           (words_length(text) > 0 || (isdigit((unsigned char)*text) && count_words(text) >= SENTENCE)) && (count_words(text) > 1 || line_has(text, ":!"));
}

/* `Set 1:`, `Section B` on a line. */
static bool is_numbered_heading(const char *text)
{
    size_t n = words_length(text), digits = strspn(text + n + 1, "0123456789"), end;

    if (n < 3 || text[n] != ' ' || words_are_rows(text) || !isupper((unsigned char)*text))
        return false;
    end = n + 1 + (digits ? digits : isupper((unsigned char)text[n + 1]) != 0);
    return end > n + 1 && (text[end] == ':' ? prose_line_ends(text + end + 1) : text[end] && prose_line_ends(text + end) && !digits);
}

/* `FAQ`: letters no stitch has. */
static bool is_shouted(const char *text, size_t n)
{
    for (size_t i = 0; i < n; i++)
        if (!isupper((unsigned char)text[i]))
            return false;
    return n > 2 && !words_are(text, WORDS_PLAIN | WORDS_AGAIN | WORDS_FABRIC | WORDS_ROW) && !is_nearly_statement(text);
}

/* `Ribbing`, alone on a line. */
static bool is_heading(const char *text)
{
    static const char *const rows[] = {"set", "setup", "foundation", "next", "all", "every"};
    size_t n = words_length(text);

    if (is_numbered_heading(text) || (is_shouted(text, n) && prose_line_ends(text + n)))
        return true;
    return n > 2 && isupper((unsigned char)*text) && prose_line_ends(text + n) && !is_nearly_statement(text) && !words_are_rows(text) &&
           (!prose_fabric_follows(text) || prose_statement_follows(next_line(text)) || words_find(next_line(text), rows, sizeof rows / sizeof *rows) >= 0);
}

/* `8 row scarf`, the row in the singular before a name. */
static bool is_adjective(const char *digit)
{
    static const char *const one[] = {"row", "round", "stitch"};
    const char *word = words_skip_blanks(digit + 1);

    return words_find(word, one, 3) >= 0 && words_length(words_skip_blanks(word + words_length(word))) > 2;
}

/* "22 sts", "4 rows": more than a title says. */
static bool has_count(const char *text)
{
    size_t n = words_line_length(text);

    for (size_t i = 0; i < n; i++)
        if (isdigit((unsigned char)text[i]) && words_are(words_skip_blanks(text + i + 1), WORDS_STITCH | WORDS_ROW | WORDS_TIMES) && !is_adjective(text + i))
            return true;
    return false;
}

bool prose_is_title(const char *text)
{
    text += *text == '(' && (words_length(text + 1) > 4 || (isupper((unsigned char)text[1]) && words_length(text + 1) > 1));
    if (line_has(text, "{}[]=<>*|") || has_file_name(text))
        return false;
    text += strspn(text, "\"'");
    return !is_mistyped(text) && !syntax_is_row(text) && (!has_stitches(text) || names_stitches(text)) && !has_call(text) && !has_count(text) && count_words(text) > 0 &&
           count_words(text) <= TITLE_WORDS && (words_length(text) > 0 || count_words(text) > 1);
}

/* `(c) 2011 Jane`, `Copyright 2011. For personal use only.` */
static bool is_copyright(const char *text)
{
    size_t sign = strncasecmp(text, "(c)", 3) == 0 ? 3 : words_is(text, "copyright") ? strlen("copyright") : 0;
    const char *behind = words_skip_blanks(text + sign);

    return sign && (words_length(behind) > 1 || strspn(behind, "0123456789") == 4 || strncasecmp(behind, "(c)", 3) == 0);
}

/* `YF = yarn forward`: two words behind an abbreviation, which are no value. */
static bool is_explained(const char *text)
{
    static const char *const value[] = {"in", "mod", "by", "each"};
    size_t sign = strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/&-");
    const char *meaning = words_skip_blanks(text + sign), *second;

    if (!sign || *meaning != '=' || meaning[1] == '=' || line_has(text, "{}"))
        return false;
    meaning = words_skip_blanks(meaning + 1);
    second = words_skip_blanks(meaning + words_length(meaning));
    return words_length(meaning) > 0 && second > meaning + words_length(meaning) && isalnum((unsigned char)*second) && words_find(meaning, value, 4) < 0 && words_find(second, value, 4) < 0;
}

/* ---- in the scanner ---- */

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

    if (!at || !words_are_rows(words_skip_blanks(text + at + words_length(text + at))) || !find_word(text, first, 5))
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

/* `let`, `swatch`, `gauge`, .. and no sentence that begins so. */
static bool is_keyword(const char *text)
{
    static const char *const word[] = {"let", "param", "output", "sweep", "swatch", "motif", "use", "stitch", "gauge", "material", "springs", "mesh", "solve"};

    return words_find(text, word, sizeof word / sizeof *word) >= 0 && !prose_is_keyword(text);
}

/* `motif flag {`, `for i in 1..4 {`: a block of the language's own. */
static bool begins_block(const char *text)
{
    size_t n = words_line_length(text);

    while (n > 0 && strchr(" \t", text[n - 1]))
        n--;
    return (n > 0 && text[n - 1] == '{') || (memchr(text, '{', n) && !prose_reads(text, true) && words_is(text, "chart"));
}

bool prose_is_page(const char *text, size_t size)
{
    bool rows = false;

    if (!words_are_page(text, size))
        return false;
    for (size_t at = 0, line; at < size; at += line + 1) {
        const char *first = text + at + strspn(text + at, " \t*-");

        line = words_line_length(text + at);
        if ((is_keyword(first) && !prose_line_ends(first + words_length(first))) || begins_block(first))
            return false;
        rows |= prose_row_follows(first) || prose_begins_cast_on(first);
    }
    return rows;
}

/* `- * -`: no letter and no figure. */
static bool is_rule(const char *text)
{
    size_t n = words_line_length(text);

    for (size_t i = 0; i < n; i++)
        if (isalnum((unsigned char)text[i]) || strchr("}{\"", text[i]))
            return false;
    return true;
}

/* `width = 3` */
static bool is_value(const char *text)
{
    const char *sign = words_skip_blanks(text + words_name_length(text));

    return words_name_length(text) > 0 && *sign == '=' && isdigit((unsigned char)*words_skip_blanks(sign + 1));
}

/* `(16 + 4 = 20)`, `YF = Yarn Forward`, `Stem`: a line without a word of work. */
static bool is_idle(const char *text)
{
    const unsigned work = WORDS_PLAIN | WORDS_WORK | WORDS_AGAIN | WORDS_CAST | WORDS_TIMES | WORDS_OFTEN | WORDS_GO_ON | WORDS_END | WORDS_ROW;
    size_t n = words_line_within(text, WORDS_LINE + 1);

    if (n > WORDS_LINE || *text == '}' || is_value(text) || is_mistyped(text) || has_stitches(text) || has_file_name(text) || memchr(text, '*', n))
        return false;
    for (size_t at = 0, length; at < n; at += length ? length : 1) {
        length = words_length(text + at);
        if (words_are(text + at, work) || words_is(text + at, "more") || words_is(text + at, "garter"))
            return false;
    }
    return true;
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

/* `Row 1`, `Row one` */
static bool is_row_head(const char *text)
{
    return words_are_rows(text) && words_number(words_next(text)) > 0;
}

/* `Now K 3, P 12, K 3 on the wrong side`, `Rib 2 and 2 for 6 rows`, `Change to stocking-stitch`, `Repeat from ** to **`:
 * a sentence that has stitches with their numbers, rows, a fabric, or asks to work again, so many times. */
static bool asks_for_work(const char *text, size_t length)
{
    static const char *const lead[] = {"repeat", "rep", "rib", "change", "continue", "cont", "proceed", "work", "do", "begin", "start", "go", "return"},
                             *const fabric[] = {"garter", "stocking", "stockinette", "moss", "seed"}, *const keep[] = {"keep", "keeping", "maintain", "maintaining"},
                             *const advice[] = {"if", "when", "to", "for", "you", "the", "this", "these", "it", "we", "my", "your", "some", "there"};
    size_t colon = strcspn(text, ":.\r\n");
    int first = words_find(text, lead, sizeof lead / sizeof *lead), here = first, stitches = 0;
    bool asks = first >= 0 && first < 2 && (memchr(text, '*', length) || words_line_has(text, "rows")), until = prose_works_until(text);
    bool heading = length > 0 && text[length - 1] == ':' ? prose_heads_rows(text, text + length) : first > 8 && is_row_head(next_line(text));

    if (words_find(text, advice, sizeof advice / sizeof *advice) >= 0 ||
        (text[colon] == ':' && words_find(words_skip_blanks(text + colon + 1), advice, sizeof advice / sizeof *advice) >= 0))
        return false;
    for (size_t i = 0; i < length; i++) {
        const char *behind = words_skip_blanks(text + i + words_length(text + i));

        if (i > 0 && isalnum((unsigned char)text[i - 1]))
            continue;
        if (i > 1 && text[i - 1] == ' ' && text[i - 2] == '.')
            here = words_find(text + i, lead, sizeof lead / sizeof *lead);
        asks |= here >= 0 && prose_times_follow(text + i);
        if (!isalpha((unsigned char)text[i]))
            continue;
        asks |= words_find(text + i, keep, 4) >= 0 && words_number(behind);
        stitches += words_are(text + i, WORDS_PLAIN) && isdigit((unsigned char)*behind) && !isalpha((unsigned char)behind[strspn(behind, "0123456789")]);
        asks |= (words_are(text + i, WORDS_PLAIN | WORDS_WORK) || words_is(text + i, "rib")) && prose_rows_follow(behind);
        asks |= first >= 3 && !heading && words_find(text + i, fabric, 5) >= 0 && prose_fabric_follows(text + i);
    }
    asks |= first > 8 && words_line_has(text, "work");
    return asks || until || stitches > 1 || (first == 2 && prose_row_count(text) > 0 && prose_row_count(text) < length);
}

/* How many lines from here on read as prose, the first as far as it goes; `end` is behind the last. */
static int block_length(const char *text, size_t length, const char **end)
{
    int n = 1;

    for (*end = text + length; n <= LIMIT_TEXTS && strchr("\r\n", **end); n++) {
        text = next_line(text);
        if (!(*text && !is_worked(text) && !prose_statement_follows(text) && !is_labelled_statement(text) && !is_keyword(text) &&
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
    if (is_copyright(text) || (parse->page && is_rule(text)) || is_explained(text))
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
    if (!again && !prose_is_keyword(text) && !prose_reads(text, false) && !is_heading(text) && !(parse->page && is_idle(text)) &&
        (scanner->begun || is_mistyped(text) || !prose_is_measure(text)))
        return false;

    if (scanner->begun && prose_sizes(scanner, span))
        return true;

    /* An instruction is none, once there is a pattern. */
    if (scanner->begun && (refused_sentence(parse->diag, span) || is_of_every_row(parse->diag, text, span)))
        return true;

    if (scanner->begun && !scanner->closed && asks_for_work(text, prose_length(scanner, text))) {
        diag_error(parse->diag, CODE_STATEMENT, span, "this asks for stitches, but which rows they are cannot be told");
        diag_hint(parse->diag, prose_works_until(text) ? "`Knit every row until ..`, or for the rows above `Work in pattern until ..`"
                                                       : "a row begins with its name: `Row 1: ...`; so many rows: `Work 6 rows in k2, p2 rib`");
        return true;
    }

    /* Nothing says what this is: it is named, once for lines that follow each other. */
    if (again)
        return true;
    lines = block_length(text, prose_length(scanner, text), &end);
    scanner->prose_end = (unsigned)(end - parse->text);
    if (lines == 1)
        diag_warning(parse->diag, CODE_PROSE, span, "this line is read as text, not as a part of the pattern");
    else
        diag_warning(parse->diag, CODE_PROSE, span,
                     "these %d lines are read as text, not as a part of the pattern", lines);
    diag_hint(parse->diag, "a row begins with its name: `Row 1: ...`; '#' before a text keeps it silent");
    return true;
}
