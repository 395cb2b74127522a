/* SPDX-License-Identifier: GPL-3.0-or-later
 * The scanner's ordinary C: token texts in, values out; brackets and line ends. */
#include "lang/scanner.h"

#include "lang/prose.h"
#include "lang/syntax.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

void scanner_advance(struct scanner *scanner, struct span *span, size_t length)
{
    *span = (struct span){scanner->parse->source, scanner->at, scanner->at + (unsigned)length};
    scanner->at = span->end;
}

bool scanner_gives_up(struct scanner *scanner, struct span span)
{
    scanner->quiet |= diag_is_full(scanner->parse->diag, span);
    return scanner->parse->diag->full;
}

void scanner_retreat(struct scanner *scanner, struct span *span, size_t length)
{
    span->end -= (unsigned)length;
    scanner->at = span->end;
}

int scanner_token(struct scanner *scanner, int kind)
{
    scanner->comma = false;
    scanner->previous = kind;
    if (kind == TOKEN_NEWLINE || kind == TOKEN_END || (kind == '}' && !scanner->hole)) {
        scanner->star_left = scanner->star;
        scanner->star = scanner->complained = false;
    }
    return kind;
}

void scanner_begin(struct scanner *scanner, int statement)
{
    scanner->statement = statement;
    scanner->stops = false;
    scanner->begun = true;
    scanner->section = false;
}

/* An empty line ends a list of materials. */
void scanner_blank_line(struct scanner *scanner, const char *line_ends)
{
    const char *first = strpbrk(line_ends, "\r\n");

    if (first && strpbrk(first + (first[0] == '\r' && first[1] == '\n') + 1, "\r\n"))
        scanner->section = false;
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

bool scanner_in_row_head(const struct scanner *scanner)
{
    return scanner->statement == TOKEN_ROW || scanner->statement == TOKEN_ALL || scanner->statement == TOKEN_SETUP ||
           scanner->statement == TOKEN_AS_ROW;
}

bool scanner_begins_item(const struct scanner *scanner)
{
    int previous = scanner->previous;

    return scanner->comma || previous == ':' || previous == '(' || previous == '[' || previous == TOKEN_TO_FIT || (previous == TOKEN_STAR && scanner->star);
}

static size_t word_length(const char *text)
{
    size_t n = 0;

    while (isalpha((unsigned char)text[n]) || text[n] == '_')
        n++;
    return n;
}

static bool is_word(const char *text, size_t length, const char *word)
{
    return strlen(word) == length && strncasecmp(text, word, length) == 0;
}

/* What a word behind `rep` was to be, told by what follows it; NULL: nothing is wrong. */
static const char *repeat_expects(const char *word, const char *behind)
{
    if (is_word(word, word_length(word), "until") || is_word(word, word_length(word), "till") || is_word(word, word_length(word), "to"))
        return NULL;
    if (*behind == '*' && !is_word(word, word_length(word), "from"))
        return "'from'";
    if (is_word(word, word_length(word), "from") && *behind != '*' && !prose_repeats_rows(behind))
        return "'*'";
    return isdigit((unsigned char)*behind) && !prose_repeats_rows(word) ? "'rows'" : NULL;
}

int scanner_repeat(struct scanner *scanner)
{
    const char *text = SCANNER_TEXT(scanner), *word = text + strspn(text, " \t"), *behind = word + word_length(word);
    struct span span = {scanner->parse->source, scanner->at + (unsigned)(word - text), scanner->at + (unsigned)(behind - text)};
    const char *expected = behind > word ? repeat_expects(word, behind + strspn(behind, " \t")) : NULL;

    if (!expected || (strcmp(expected, "'rows'") == 0 && !syntax_meant(scanner->parse, span)))
        return scanner_token(scanner, scanner_closes_group(scanner) ? TOKEN_REP : TOKEN_REP_ALL);
    if (strcmp(expected, "'*'") == 0) {
        behind += strspn(behind, " \t");
        span.start = scanner->at + (unsigned)(behind - text);
        span.end = span.start + (unsigned)(word_length(behind) ? word_length(behind) : *behind && !strchr("\r\n", *behind));
    }
    scanner->star = false;
    return syntax_unknown_word(scanner->parse, span, expected);
}

/* ---- values ---- */

int scanner_text(struct scanner *scanner, KNIT_STYPE *value, int kind, struct span span, const char *text,
                 size_t length)
{
    struct parse *parse = scanner->parse;

    if (kind == TOKEN_NAME && length > LIMIT_NAME) {
        span.end = span.start + LIMIT_NAME;
        diag_error(parse->diag, CODE_LIMIT_NAMES, span, "this name is %zu bytes long; a name may have %d",
                   length, LIMIT_NAME);
        return TOKEN_KNIT_error;
    }
    value->text = names_intern(parse->names, text, length);
    return scanner_token(scanner, kind);
}

int scanner_string(struct scanner *scanner, KNIT_STYPE *value, const char *text, size_t length)
{
    value->text = names_intern(scanner->parse->names, text + 1, length - 2);
    return scanner_token(scanner, TOKEN_STRING);
}

void scanner_lower(struct scanner *scanner, KNIT_STYPE *value, const char *text, size_t length)
{
    char lower[LIMIT_NAME];

    for (size_t i = 0; i < length; i++)
        lower[i] = (char)tolower((unsigned char)text[i]);
    value->text = names_intern(scanner->parse->names, lower, length);
}

/* What a unit does to the number before it; lengths are kept in millimetres. */
static const struct unit {
    const char *name;
    double factor;
    int dimension;
} units[] = {{"%", 0.01, 0}, {"mm", 1, 1}, {"cm", 10, 1}, {"m", 1000, 1}, {"in", 25.4, 1}};

int scanner_number(struct scanner *scanner, struct span span, KNIT_STYPE *value, const char *text,
                   size_t length)
{
    char digits[64], *end;
    struct diag *diag = scanner->parse->diag;

    if (length >= sizeof digits) {
        diag_error(diag, CODE_NUMBER, span, "a number of %zu characters is too long", length);
        return TOKEN_KNIT_error;
    }
    memcpy(digits, text, length);
    digits[length] = '\0';
    value->number.value = strtod(digits, &end);
    value->number.dimension = 0;
    end += strspn(end, " \t\f\v\xC2\xA0");
    for (size_t i = 0; i < sizeof units / sizeof *units; i++)
        if (strcasecmp(end, units[i].name) == 0) {
            value->number.value *= units[i].factor;
            value->number.dimension = units[i].dimension;
        }
    if (!isfinite(value->number.value)) {
        diag_error(diag, CODE_NUMBER, span, "this number is too large to be represented");
        return TOKEN_KNIT_error;
    }
    return scanner_token(scanner, TOKEN_NUMBER);
}

int scanner_bad_unit(struct scanner *scanner, struct span span, const char *text)
{
    int digits = (int)strspn(text, "0123456789.");

    span.start += (unsigned)digits;
    diag_error(scanner->parse->diag, CODE_NUMBER, span, "'%s' is no unit", text + digits);
    diag_hint(scanner->parse->diag, "units are %%, mm, cm, m and in; a product is written with '*'");
    return TOKEN_KNIT_error;
}

int scanner_fraction(struct scanner *scanner, struct span span, const char *text)
{
    diag_error(scanner->parse->diag, CODE_WHOLE, span, "a whole number is needed here, not %s", text);
    return TOKEN_KNIT_error;
}

void scanner_number_word(KNIT_STYPE *value, const char *text)
{
    static const struct {
        const char *word;
        int number;
    } words[] = {{"once", 1},  {"one", 1},  {"twice", 2}, {"two", 2},     {"thrice", 3},
                 {"three", 3}, {"four", 4}, {"five", 5},  {"six", 6},     {"seven", 7},
                 {"eight", 8}, {"nine", 9}, {"ten", 10},  {"eleven", 11}, {"twelve", 12},
                 {"first", 1}, {"second", 2}, {"third", 3}, {"fourth", 4},   {"fifth", 5},
                 {"sixth", 6}, {"seventh", 7}, {"eighth", 8}, {"ninth", 9},  {"tenth", 10},
                 {"eleventh", 11}, {"twelfth", 12}};

    value->number.value = 1;
    value->number.dimension = 0;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (strcasecmp(text, words[i].word) == 0)
            value->number.value = words[i].number;
}

/* Whether the last word is `rnd`, `rounds`, `rds`; not `row`, not `r`. */
static bool ends_with_round(const char *text)
{
    const char *word = text + strlen(text);

    while (word > text && (isalpha((unsigned char)word[-1]) || word[-1] == '.'))
        word--;
    return tolower((unsigned char)*word) == 'r' && isalpha((unsigned char)word[1]) &&
           strncasecmp(word, "row", 3) != 0 && strcasecmp(word, "rs") != 0;
}

/* SIDE_RS stands for "in the round". */
void scanner_round(KNIT_STYPE *value, const char *text)
{
    value->side = ends_with_round(text) ? SIDE_RS : SIDE_OPEN;
}

void scanner_side(KNIT_STYPE *value, const char *text)
{
    while (*text && !strchr("rRwW", *text))
        text++;
    value->side = tolower((unsigned char)*text) == 'r' ? SIDE_RS : SIDE_WS;
}

/* "starting with a purl row", "beg on a WS row" */
void scanner_starting(KNIT_STYPE *value, const char *text)
{
    static const struct {
        const char *word;
        enum side side;
    } sides[] = {{"p", SIDE_OF_PURL}, {"purl", SIDE_OF_PURL}, {"k", SIDE_OF_KNIT}, {"knit", SIDE_OF_KNIT},
                 {"ws", SIDE_WS}, {"wrong", SIDE_WS}};

    value->side = SIDE_RS;
    for (; *text; text += strcspn(text, " \t\f\v"), text += strspn(text, " \t\f\v"))
        for (size_t i = 0; i < sizeof sides / sizeof *sides; i++)
            if (is_word(text, word_length(text), sides[i].word))
                value->side = sides[i].side;
}

/* "(set-up row, WS)": whether a side is among the words. */
bool scanner_remark(KNIT_STYPE *value, const char *text)
{
    static const struct {
        const char *word;
        enum side side;
    } sides[] = {{"rs", SIDE_RS}, {"right", SIDE_RS}, {"ws", SIDE_WS}, {"wrong", SIDE_WS}};

    for (; *text; text += word_length(text) ? word_length(text) : 1)
        for (size_t i = 0; i < sizeof sides / sizeof *sides; i++)
            if (is_word(text, word_length(text), sides[i].word)) {
                value->side = sides[i].side;
                return true;
            }
    return false;
}

int scanner_edge(struct scanner *scanner, KNIT_STYPE *value, const char *text)
{
    char name[32];

    scanner_number_word(value, text);
    if (isdigit((unsigned char)*text))
        value->number.value = strtod(text, NULL);
    snprintf(name, sizeof name, "k%.0f", fmin(value->number.value, 999999));
    value->text = names_intern(scanner->parse->names, name, strlen(name));
    return scanner_token(scanner, TOKEN_NAME);
}

/* "4 k": "k4". */
int scanner_turned(struct scanner *scanner, KNIT_STYPE *value, const char *text)
{
    size_t digits = strspn(text, "0123456789"), word = strcspn(text, "kpKP");
    char name[LIMIT_NAME];

    snprintf(name, sizeof name, "%c%.*s", text[word], (int)(digits < 9 ? digits : 9), text);
    value->text = names_intern(scanner->parse->names, name, strlen(name));
    return scanner_token(scanner, TOKEN_NAME);
}

/* "knit the knits and purl the purls": as below; with the two exchanged: the opposite. */
int scanner_below(struct scanner *scanner, KNIT_STYPE *value, struct span span, const char *text)
{
    char letter[4];
    int n = 0;

    for (size_t at = 0, length; text[at] && n < 4; at += length + (length == 0)) {
        length = word_length(text + at);
        if (length && strchr("kKpP", text[at]))
            letter[n++] = (char)tolower((unsigned char)text[at]);
    }
    if (n < 4 || letter[0] == letter[2] || letter[1] == letter[3]) {
        diag_error(scanner->parse->diag, CODE_SYNTAX, span, "which stitches are to be knitted, and which purled, cannot be told from this");
        return TOKEN_KNIT_error;
    }
    value->opposite = letter[0] != letter[1];
    return scanner_token(scanner, TOKEN_AS_BELOW);
}

/* "an even number of", "any number of". */
void scanner_number_of(KNIT_STYPE *value, const char *text)
{
    static const struct {
        const char *word;
        int of, plus;
    } words[] = {{"even", 2, 0}, {"odd", 2, 1}, {"uneven", 2, 1}, {"any", 1, 0}};

    value->parity.of = 1;
    value->parity.plus = 0;
    for (; *text; text += *text ? 1 : 0) {
        size_t length = word_length(text);

        for (size_t i = 0; i < sizeof words / sizeof *words; i++)
            if (is_word(text, length, words[i].word)) {
                value->parity.of = words[i].of;
                value->parity.plus = words[i].plus;
            }
        text += length;
        if (!*text)
            break;
    }
}

/* "k2, p2 rib", "3 x 3 rib", "double rib": the numbers of a rib. */
static struct fabric rib_of(const char *text)
{
    struct fabric rib = {FABRIC_RIB, 1, 1};
    int *number[] = {&rib.knit, &rib.purl};

    if (is_word(text, word_length(text), "double"))
        rib.knit = rib.purl = 2;
    for (int i = 0; i < 2 && *(text += strcspn(text, "0123456789")); i++) {
        size_t length = strspn(text, "0123456789");

        *number[i] = length < 6 ? atoi(text) : 999999;
        text += length;
    }
    return rib;
}

void scanner_fabric(struct scanner *scanner, KNIT_STYPE *value, struct span span, const char *text)
{
    static const struct {
        const char *first;
        enum fabric_kind kind;
    } fabrics[] = {{"garter", FABRIC_GARTER}, {"g ", FABRIC_GARTER}, {"rev", FABRIC_REVERSE}, {"st", FABRIC_STOCKINETTE},
                   {"seed", FABRIC_SEED},     {"moss", FABRIC_SEED}};

    value->fabric = rib_of(text);
    for (size_t i = 0; i < sizeof fabrics / sizeof *fabrics; i++)
        if (strncasecmp(text, fabrics[i].first, strlen(fabrics[i].first)) == 0)
            value->fabric.kind = fabrics[i].kind;
    if (strncasecmp(text, "moss", 4) == 0) {
        diag_warning(scanner->parse->diag, CODE_AMBIGUOUS_NAME, span,
                     "'moss' is two patterns: in Britain what others call seed, in America a pattern of four rows");
        diag_hint(scanner->parse->diag, "taken as 'seed' (British moss); the American one is `use moss_us from std`");
    }
}

/* "every alternate row", "alt rows"; "every following row" is each of them. */
void scanner_following(KNIT_STYPE *value, const char *text)
{
    static const char *const second[] = {"alt", "alternate", "other"};

    value->all.round = ends_with_round(text);
    value->all.kind = ALL_FOLLOWING;
    for (; *text; text += word_length(text) + (word_length(text) == 0))
        for (size_t i = 0; i < sizeof second / sizeof *second; i++)
            if (is_word(text, word_length(text), second[i]))
                value->all.kind = ALL_OTHER;
}

/* "all RS rows", "every following wrong-side row", "all even rows", "every row". */
void scanner_all(KNIT_STYPE *value, const char *text)
{
    static const struct {
        const char *word;
        enum all_kind all;
    } words[] = {{"rs", ALL_RS},    {"right", ALL_RS},  {"ws", ALL_WS},
                 {"wrong", ALL_WS}, {"even", ALL_EVEN}, {"odd", ALL_ODD}};

    value->all.round = ends_with_round(text);
    value->all.kind = ALL_EVERY;
    for (; *text && value->all.kind == ALL_EVERY; text += strspn(text, " \t\f\v-")) {
        size_t length = strcspn(text, " \t\f\v-");

        for (size_t i = 0; i < sizeof words / sizeof *words; i++)
            if (length == strlen(words[i].word) && strncasecmp(text, words[i].word, length) == 0)
                value->all.kind = words[i].all;
        text += length;
    }
}

/* ---- what cannot be read ---- */

int scanner_lettered(struct scanner *scanner, struct span span)
{
    diag_error(scanner->parse->diag, CODE_ROW_NUMBER, span, "a row's number has no letter");
    diag_hint(scanner->parse->diag, "number all rows in the order they are worked: `Row 1`, `Row 2` ..");
    return TOKEN_KNIT_error;
}

int scanner_open_string(struct scanner *scanner, struct span span)
{
    diag_error(scanner->parse->diag, CODE_STRING, span, "this text has no closing quote on its line");
    return TOKEN_KNIT_error;
}

/* One complaint per line: what follows a strange character is often strange too. */
int scanner_character(struct scanner *scanner, struct span span)
{
    struct diag *diag = scanner->parse->diag;
    const struct source *source = span.source;
    unsigned char c = (unsigned char)source->text[span.start];

    if (c >= 0xC0)
        while (span.end < source->size && ((unsigned char)source->text[span.end] & 0xC0) == 0x80)
            span.end++;
    if (scanner->complained)
        return TOKEN_KNIT_error;
    scanner->complained = true;
    if (c < 0x20 || c == 0x7F || (c >= 0x80 && span.end == span.start + 1))
        diag_error(diag, CODE_CHARACTER, span, "the byte 0x%02X is no character of a script", c);
    else
        diag_error(diag, CODE_CHARACTER, span, "the character '%.*s' has no meaning here",
                   (int)(span.end - span.start), source->text + span.start);
    return TOKEN_KNIT_error;
}

int scanner_size_list(struct scanner *scanner, struct span span)
{
    if (scanner->previous == TOKEN_CAST_ON) {
        diag_error(scanner->parse->diag, CODE_RANGE, span, "a cast-on is a positive count of stitches");
        return TOKEN_KNIT_error;
    }
    diag_error(scanner->parse->diag, CODE_MANY_SIZES, span, "the numbers of several sizes: which is to be knitted is open");
    diag_hint(scanner->parse->diag, "keep the number of one size");
    return TOKEN_KNIT_error;
}

bool scanner_sizes(struct scanner *scanner, struct span bracket)
{
    const char *text = scanner->parse->text + bracket.start, *behind;
    unsigned at = bracket.start;
    int n;
    size_t length = strchr("([", *text) ? prose_sizes_length(text, &n) : 0;

    while (at > 0 && scanner->parse->text[at - 1] == ' ')
        at--;
    if (!length || at == 0 || !isdigit((unsigned char)scanner->parse->text[at - 1]))
        return false;

    /* One number alone may be the row's count, which ends it. */
    behind = text + length + strspn(text + length, " \t");
    if (n == 1 && !isalnum((unsigned char)*behind) && *behind != ',')
        return false;
    bracket.end = bracket.start + (unsigned)length;
    diag_error(scanner->parse->diag, CODE_MANY_SIZES, bracket, "the numbers of several sizes: which is to be knitted is open");
    diag_hint(scanner->parse->diag, "keep the number of one size, and leave the brackets out");
    return true;
}

/* ---- brackets ---- */

static bool is_in_line(enum bracket kind)
{
    return kind == BRACKET_ROUND || kind == BRACKET_SQUARE || kind == BRACKET_HOLE;
}

/* What a brace opens follows from the statement it stands in. */
static enum bracket brace_of(const struct scanner *scanner, bool in_expression)
{
    bool number = scanner->previous == TOKEN_MULTIPLE_OF || (!in_expression && scanner->previous == '+');

    switch (scanner->statement) {
    case TOKEN_MOTIF:
        return number ? BRACKET_HOLE : BRACKET_STATEMENTS;
    case TOKEN_FOR:
    case TOKEN_IF:
    case TOKEN_ELSE:
        return BRACKET_STATEMENTS;
    case TOKEN_CHART:
        return BRACKET_CHART;
    case TOKEN_ROW:
    case TOKEN_ALL:
    case TOKEN_SETUP:
    case TOKEN_AS_ROW:
    case TOKEN_PLAIN_ROWS:
    case TOKEN_WORK:
    case TOKEN_WORK_ROWS:
    case TOKEN_CAST_ON:
    case TOKEN_MULTIPLE_OF:
    case TOKEN_REPEAT_ROWS:
    case TOKEN_REPEAT_LAST:
    case TOKEN_REPEAT_THEM:
    case TOKEN_GO_ON_ROWS:
        return BRACKET_HOLE;
    default:
        return BRACKET_SETTINGS;
    }
}

enum bracket scanner_open(struct scanner *scanner, struct span span, char c, int state, bool in_expression)
{
    enum bracket kind = c == '('   ? BRACKET_ROUND
                        : c == '[' ? BRACKET_SQUARE
                                   : brace_of(scanner, in_expression);

    if (scanner->nopen == LIMIT_NESTING) {
        if (!scanner->quiet)
            diag_error(scanner->parse->diag, CODE_LIMIT_NESTING, span,
                       "brackets are nested more than %d deep", LIMIT_NESTING);
        scanner->quiet = true;
        return BRACKET_TOO_DEEP;
    }
    scanner->open[scanner->nopen++] = (struct open){kind, state, span};
    return kind;
}

int scanner_close(struct scanner *scanner, char c)
{
    /* A brace also closes what is still open inside it. */
    if (c == '}')
        while (scanner->nopen && scanner->open[scanner->nopen - 1].kind <= BRACKET_SQUARE)
            scanner->nopen--;
    if (!scanner->nopen || (c != '}' && scanner->open[scanner->nopen - 1].kind > BRACKET_SQUARE))
        return -1;
    scanner->nopen--;
    scanner->hole = scanner->open[scanner->nopen].kind == BRACKET_HOLE;
    return is_in_line(scanner->open[scanner->nopen].kind) ? scanner->open[scanner->nopen].state : 0;
}

int scanner_end(struct scanner *scanner)
{
    if (scanner->nopen && !scanner->quiet) {
        struct span span = scanner->open[scanner->nopen - 1].span;

        diag_error(scanner->parse->diag, CODE_UNCLOSED, span, "this '%c' is never closed",
                   span.source->text[span.start]);
        scanner->quiet = true;
    }
    return scanner_token(scanner, TOKEN_END);
}

/* ---- line ends ---- */

/* Whether a statement begins here: one of its words and behind it what may follow one. */
static bool statement_follows(const struct scanner *scanner, const char *text)
{
    static const char *const rows[] = {"row",    "rows", "rnd",   "rnds", "round",
                                       "rounds", "the",  "these", "this", "last"};
    size_t length = word_length(text);
    const char *behind = text + length + strspn(text + length, " \t");
    size_t next = word_length(behind);

    if (!length)
        return false;
    if (is_word(text, length, "rep") || is_word(text, length, "repeat")) {
        for (size_t i = 0; i < sizeof rows / sizeof *rows; i++)
            if (is_word(behind, next, rows[i]))
                return true;
        return false;
    }
    /* `k2,` and on the next line `knit 2`. */
    if (scanner->comma && is_word(text, length, "knit"))
        return false;
    for (int i = 0; i < nstatement_words; i++)
        if (is_word(text, length, statement_word[i]))
            return isalnum((unsigned char)*behind) || strchr("\"{:(", *behind);
    return false;
}

/* A token after which an expression must go on. */
static bool goes_on(int token)
{
    static const int open_ended[] = {
        '=',
        ',',
        ':',
        '?',
        '+',
        '-',
        '*',
        '/',
        '<',
        '>',
        '!',
        TOKEN_IN,
        TOKEN_BY,
        TOKEN_MOD,
        TOKEN_DOTS,
        TOKEN_LESS_EQUAL,
        TOKEN_GREATER_EQUAL,
        TOKEN_EQUAL,
        TOKEN_UNEQUAL,
        TOKEN_AND_AND,
        TOKEN_OR_OR,
    };

    for (size_t i = 0; i < sizeof open_ended / sizeof *open_ended; i++)
        if (token == open_ended[i])
            return true;
    return false;
}

/* What ends a row, behind `end`: `k1`, `with k1`; not `heart`. */
static bool ends_row(const char *text)
{
    static const char *const words[] = {"with", "in", "last", "after", "on", "knit", "purl", "row", "rnd", "round", "rep", "repeat"};

    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (is_word(text, word_length(text), words[i]))
            return true;
    return syntax_is_row(text);
}

/* In a row: after a comma, an open star or a colon, and before `rep from`. */
static bool row_goes_on(const struct scanner *scanner, const char *text)
{
    static const char *const words[] = {"st", "sts", "stitch", "stitches", "to", "across", "last", "from"};
    size_t length = word_length(text);

    /* `rep from *`, `rep to end`; not `repeat for pattern`, `rep 1st and 2nd rows`. */
    if (is_word(text, length, "rep") || is_word(text, length, "repeat"))
        return !prose_repeats_rows(text + length);
    if (is_word(text, length, "end") || is_word(text, length, "ending"))
        return ends_row(text + length + strspn(text + length, " \t"));
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (is_word(text, length, words[i]))
            return !prose_fabric_follows(text + length + strspn(text + length, " \t"));
    return scanner->comma || ((scanner->star || scanner->stops) && syntax_is_row(text)) || scanner->previous == ':' ||
           (scanner_in_row_head(scanner) && prose_row_line(text)) || scanner->previous == TOKEN_TO_LAST || scanner->previous == TOKEN_UNTIL;
}

bool scanner_ends_line(struct scanner *scanner, bool in_row, bool in_expression)
{
    const char *next = SCANNER_TEXT(scanner);
    bool open = scanner->nopen && is_in_line(scanner->open[scanner->nopen - 1].kind);

    if (!*next || (statement_follows(scanner, next) && !(in_row && scanner_in_row_head(scanner) && prose_row_line(next))))
        return true;
    if (open)
        return false;
    if (in_row)
        return *next == '}' || !row_goes_on(scanner, next);
    if (scanner->previous == '}' && is_word(next, word_length(next), "else"))
        return false;
    if (*next == '{')
        return false;
    if (!scanner->statement)
        return true;
    return !goes_on(scanner->previous) && !(in_expression ? strchr("?:*/+-&|<>=", *next) != NULL : *next == '=');
}

bool scanner_repeat_goes_on(const struct scanner *scanner)
{
    static const char *const words[] = {"until", "till", "for"};
    const char *text = SCANNER_TEXT(scanner);
    bool repeat = scanner->statement == TOKEN_REPEAT_ROWS || scanner->statement == TOKEN_REPEAT_LAST || scanner->statement == TOKEN_REPEAT_THEM;

    if (!repeat || (scanner->previous != TOKEN_NUMBER && scanner->previous != TOKEN_ROW_WORD && scanner->previous != TOKEN_REPEAT_THEM))
        return false;
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (is_word(text, word_length(text), words[i]))
            return true;
    return prose_times_follow(text);
}

bool scanner_end_line(struct scanner *scanner)
{
    bool open = scanner->nopen && is_in_line(scanner->open[scanner->nopen - 1].kind);

    scanner->unclosed = open ? scanner->open[scanner->nopen - 1].span : (struct span){NULL, 0, 0};
    while (scanner->nopen && is_in_line(scanner->open[scanner->nopen - 1].kind))
        scanner->nopen--;
    return scanner->nopen && scanner->open[scanner->nopen - 1].kind == BRACKET_SETTINGS;
}

bool scanner_number_follows(const struct scanner *scanner)
{
    const char *text = SCANNER_TEXT(scanner);

    text += strspn(text, " \t");
    return isdigit((unsigned char)*text) || *text == '{';
}
