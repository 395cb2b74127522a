/* SPDX-License-Identifier: GPL-3.0-or-later
 * A line's words in, what they can be out: a sentence, a title, a heading, or nearly a statement. */
#include "lang/page/prose_line.h"

#include <ctype.h>
#include <limits.h>
#include <string.h>
#include <strings.h>

#include "lang/page/prose.h"
#include "lang/settings.h"
#include "lang/syntax.h"
#include "lang/typos.h"
#include "lang/page/words.h"

enum { TITLE_WORDS = 10, SENTENCE = 6, LONG_SENTENCE = 8, SHORT_SENTENCE = 2, NAME_WORDS = 3 };

/* The next line that is not empty. */
const char *prose_line_next(const char *text)
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
    return line_has(text, "{") || *prose_line_next(text) == '{';
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
    return *text != '{' && *prose_line_next(text) != '{' && !is_setting(text);
}

static bool no_body(const char *text)
{
    return !opens_block(text) && !is_setting(words_next(text));
}

static bool no_loop(const char *text)
{
    const char *dots = strpbrk(text, "\r\n.");

    while (dots && *dots == '.' && (dots[1] != '.' || dots[2] == '.'))
        dots = strpbrk(dots + 1 + strspn(dots + 1, "."), "\r\n.");
    return !opens_block(text) && !line_has(text, "[]=") && !(dots && *dots == '.');
}

static bool no_file(const char *text)
{
    return *text != '"' && *text != '\xE2' && !words_line_has(text, "from") && !words_line_has(text, "std");
}

/* "Output may vary": no file's name. */
static bool no_output(const char *text)
{
    return words_length(words_next(text)) > 0 && !line_has(text, "\"{=.");
}

/* "Let me know how it goes", "Let dry (overnight)", "Let's begin": more words, and no value. */
static bool no_value(const char *text)
{
    const char *next = words_next(text);

    return *text == '\'' || (!line_has(text, "=0123456789") && (words_length(next) > 0 || *next == '('));
}

static bool is_labelled(const char *text)
{
    return *text == ':';
}

/* `swatch: ..`, `Swatch, no, dishcloth`, `swatch we are going to knit` */
static bool no_fabric(const char *text)
{
    const char *behind = text + words_length(text);

    /* Two words that follow each other are no value. */
    return is_labelled(text) || *text == ',' || (behind > text && *behind == ' ' && words_length(words_skip_blanks(behind)) > 0 && !words_is(text, "each"));
}

bool prose_is_keyword(const char *text)
{
    static const struct {
        const char *word;
        bool (*none)(const char *behind);
    } words[] = {{"knit", no_version}, {"gauge", no_block}, {"material", no_block},  {"springs", no_block},
                 {"mesh", no_block},   {"solve", no_block}, {"stitch", no_body},     {"chart", no_body},
                 {"if", no_body},      {"for", no_loop},    {"swatch", no_fabric}, {"motif", is_labelled},
                 {"use", no_file},      {"let", no_value}, {"output", no_output}};
    const char *behind = words_next(text);

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
    const char *next = words_next(text);

    return words_length(text) < 4 && words_length(next) > 0 && !words_are_rows(next) && words_find(next, behind, sizeof behind / sizeof *behind) < 0 && !line_has(text, ":\"={");
}

/* `Casst`, `swach`: the first word is nearly a statement's. */
static bool is_nearly_statement(const char *text)
{
    char word[32] = "";
    size_t n = words_length(text);
    struct nearest nearest;

    if (n < 3 || n >= sizeof word || text[n] == '-' || words_is(text, "left") || (words_is(text, "materials") && !line_has(text, "{")) || is_short_word(text) || words_find(text, sentence_word, nsentence_words) >= 0)
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
bool prose_line_is_mistyped(const char *text)
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

/* `K2, P2 Rib Scarf`: what is made of them. */
static bool names_piece(const char *text)
{
    static const char *const piece[] = {"scarf", "hat", "cowl", "blanket", "afghan", "throw", "shawl", "wrap", "cloth", "dishcloth", "washcloth", "facecloth", "square",
                                        "block", "headband", "cushion", "pillow", "bag", "towel", "mat", "coaster", "mitts", "snood", "swatch", "warmer", "warmers", "socks"};

    for (size_t i = 0; i < sizeof piece / sizeof *piece; i++)
        if (words_line_has(text, piece[i]))
            return !line_has(text, ":;") && !prose_row_word(text);
    return false;
}

bool prose_is_named_row(const char *text)
{
    static const char *const row[] = {"row", "rnd", "round"};
    const char *behind = text;

    for (int words = 0; words < 2 && words_find(behind, row, sizeof row / sizeof *row) < 0; words++)
        behind = words_next(behind);
    if (behind == text || prose_line_is_mistyped(text) || words_find(behind, row, sizeof row / sizeof *row) < 0)
        return false;
    behind = words_next(behind);
    if (*behind == '(')
        behind = words_skip_blanks(behind + strcspn(behind, ":\r\n"));
    return *behind == ':' && prose_stitches_follow(words_skip_blanks(behind + 1));
}

/* `Repeat rows 1-4 until the piece measures ...` */
static bool is_repeat_until(const char *text)
{
    const char *behind = words_is(text, "repeat") || words_is(text, "rep") ? words_next(text) : NULL;

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

/* `[Editor's note: I might knit it wider.]`: a line in square brackets that tells its reader something, and asks for nothing. */
static bool is_bracketed_note(const char *text)
{
    static const char *const teller[] = {"note", "notes", "editor", "ed", "nb", "tip", "i", "we", "you", "my", "our", "your", "the", "this", "these", "it", "if", "when", "there"};
    size_t close = strcspn(text, "]*{}\r\n"), colon = strcspn(text, ":]\r\n");

    if (*text != '[' || text[close] != ']' || !prose_line_ends(text + close + 1) || words_find(text + 1, teller, sizeof teller / sizeof *teller) < 0)
        return false;
    for (size_t at = 1; at < close; at += words_length(text + at) + (words_length(text + at) == 0))
        if (words_are(text + at, WORDS_AGAIN | WORDS_TIMES | WORDS_OFTEN))
            return false;
    return !has_stitches(text) && !(text[colon] == ':' && prose_statement_follows(text + colon + 1));
}

bool prose_reads(const char *text, bool loose)
{
    if (is_bracketed_note(text))
        return true;
    text += *text == '(' && isupper((unsigned char)text[1]) && count_words(text) >= SENTENCE;
    if (words_line_within(text, WORDS_LINE + 1) > WORDS_LINE || line_has(text, "{}") || prose_line_is_mistyped(text) || is_repeat_until(text))
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
bool prose_line_is_heading(const char *text)
{
    static const char *const rows[] = {"set", "setup", "foundation", "next", "all", "every"};
    size_t n = words_length(text);

    if (is_numbered_heading(text) || (is_shouted(text, n) && prose_line_ends(text + n)))
        return true;
    return n > 2 && isupper((unsigned char)*text) && prose_line_ends(text + n) && !is_nearly_statement(text) && !words_are_rows(text) &&
           (!prose_fabric_follows(text) || prose_statement_follows(prose_line_next(text)) || words_find(prose_line_next(text), rows, sizeof rows / sizeof *rows) >= 0);
}

/* `8 row scarf`, the row in the singular before a name. */
static bool is_adjective(const char *digit)
{
    static const char *const one[] = {"row", "round", "stitch"};
    const char *word = words_skip_blanks(digit + 1);

    return words_find(word, one, 3) >= 0 && words_length(words_next(word)) > 2;
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
    if (!names_piece(text) && (syntax_is_row(text) || (has_stitches(text) && !names_stitches(text)) || has_call(text) || has_count(text)))
        return false;
    return !prose_line_is_mistyped(text) && count_words(text) > 0 &&
           count_words(text) <= TITLE_WORDS && (words_length(text) > 0 || count_words(text) > 1);
}

/* `(c) 2011 Jane`, `Copyright 2011. For personal use only.` */
bool prose_line_is_copyright(const char *text)
{
    size_t sign = strncasecmp(text, "(c)", 3) == 0 ? 3 : words_is(text, "copyright") ? strlen("copyright") : 0;
    const char *behind = words_skip_blanks(text + sign);

    return sign && (words_length(behind) > 1 || strspn(behind, "0123456789") == 4 || strncasecmp(behind, "(c)", 3) == 0);
}

/* `YF = yarn forward`: two words behind an abbreviation, which are no value. */
bool prose_line_is_explained(const char *text)
{
    static const char *const value[] = {"in", "mod", "by", "each"};
    size_t sign = strspn(text, "abcdefghijklmnopqrstuvwxyzABCDEFGHIJKLMNOPQRSTUVWXYZ0123456789/&-");
    const char *meaning = words_skip_blanks(text + sign), *second;

    if (!sign || *meaning != '=' || meaning[1] == '=' || line_has(text, "{}"))
        return false;
    meaning = words_skip_blanks(meaning + 1);
    second = words_next(meaning);
    return words_length(meaning) > 0 && second > meaning + words_length(meaning) && isalnum((unsigned char)*second) && words_find(meaning, value, 4) < 0 && words_find(second, value, 4) < 0;
}

/* `CO  cast on`, `K - knit. P - purl`, `R = row`: an abbreviation before the word it stands for. */
bool prose_line_is_abbreviation(const char *text)
{
    static const struct {
        const char *brief, *word;
    } table[] = {{"k", "knit|knits"}, {"p", "purl|purls"}, {"co", "cast"}, {"bo", "bind"}, {"st|sts", "stitch|stitches"}, {"rep|r", "repeat|repeats|row|round"}, {"rs", "right"},
                 {"ws", "wrong"}, {"rnd|rnds", "round|rounds"}, {"patt|pat|patts", "pattern|patterns"}, {"beg", "beginning|begin"}, {"cont", "continue|continuing"}, {"rem", "remaining|remain"},
                 {"foll", "following|follows|follow"}, {"alt", "alternate"}, {"pm", "place"}, {"sm", "slip"}, {"m|mk", "marker"}, {"tog", "together"}, {"inc", "increase|increasing"}, {"dec", "decrease|decreasing"}};
    const char *behind = text + words_length(text), *meaning;

    behind += strncmp(behind, "(s)", 3) == 0 ? 3 : *behind == '.';
    meaning = behind + strspn(behind, " \t=:-");
    if (meaning == behind || memchr(text, '{', words_line_length(text)) || strcspn(text, "0123456789") < words_line_length(text))
        return false;
    for (size_t i = 0; i < sizeof table / sizeof *table; i++)
        if (words_one_of(table[i].brief, text) && words_one_of(table[i].word, meaning))
            return true;
    return false;
}

/* ---- pages ---- */

/* `let`, `swatch`, `gauge`, .. and no sentence that begins so. */
bool prose_line_is_keyword(const char *text)
{
    static const char *const word[] = {"let", "param", "output", "sweep", "swatch", "motif", "use", "stitch", "gauge", "material", "springs", "mesh", "solve"};

    return words_find(text, word, sizeof word / sizeof *word) >= 0 && !prose_is_keyword(text);
}

/* `- * -`: no letter and no figure. */
bool prose_line_is_rule(const char *text)
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
bool prose_line_is_idle(const char *text)
{
    const unsigned work = WORDS_PLAIN | WORDS_WORK | WORDS_AGAIN | WORDS_CAST | WORDS_TIMES | WORDS_OFTEN | WORDS_GO_ON | WORDS_END | WORDS_ROW;
    size_t n = words_line_within(text, WORDS_LINE + 1);

    if (n > WORDS_LINE || *text == '}' || is_value(text) || prose_line_is_mistyped(text) || has_stitches(text) || has_file_name(text) || memchr(text, '*', n))
        return false;
    for (size_t at = 0, length; at < n; at += length ? length : 1) {
        length = words_length(text + at);
        if (words_are(text + at, work) || words_is(text + at, "more") || words_is(text + at, "garter"))
            return false;
    }
    return true;
}
