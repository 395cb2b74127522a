/* SPDX-License-Identifier: GPL-3.0-or-later
 * Texts of tokens in, their values out: numbers with units, sides, fabrics, kinds of rows. */
#include "lang/token_values.h"

#include <ctype.h>
#include <math.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "lang/page/edges.h"
#include "lang/page/lengths.h"
#include "lang/page/within.h"
#include "lang/page/words.h"
#include "lang/refused.h"

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

void scanner_number_word(KNIT_STYPE *value, const char *text)
{
    value->number.value = words_value(text) ? words_value(text) : 1;
    value->number.dimension = 0;
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
            if (words_is(text, sides[i].word))
                value->side = sides[i].side;
}

/* "(set-up row, WS)": whether a side is among the words. */
bool scanner_remark(KNIT_STYPE *value, const char *text)
{
    static const struct {
        const char *word;
        enum side side;
    } sides[] = {{"rs", SIDE_RS}, {"right", SIDE_RS}, {"ws", SIDE_WS}, {"wrong", SIDE_WS}};

    /* "(odd rows RS, even rows WS)" is of neither. */
    value->side = SIDE_OPEN;
    for (; *text; text += words_length(text) ? words_length(text) : 1)
        for (size_t i = 0; i < sizeof sides / sizeof *sides; i++)
            if (words_is(text, sides[i].word)) {
                if (value->side && value->side != sides[i].side)
                    return false;
                value->side = sides[i].side;
            }
    return value->side != SIDE_OPEN;
}

bool scanner_counts_again(const struct scanner *scanner, size_t length)
{
    const char *text = scanner->parse->text, *again = text + scanner->at - length;
    size_t at = scanner->at - length, first = strcspn(again, "0123456789"), last = length;

    while (at > 0 && !isdigit((unsigned char)text[at - 1]) && !words_ends_line(text[at - 1]))
        at--;
    while (at > 0 && isdigit((unsigned char)text[at - 1]))
        at--;
    while (!isdigit((unsigned char)again[last - 1]))
        last--;
    return isdigit((unsigned char)text[at]) && strspn(again + first, "0123456789") == last - first &&
           strtol(text + at, NULL, 10) == strtol(again + first, NULL, 10);
}

/* `edge st`, worked as the page says; not, where it slips them, or says it of one side alone. */
int scanner_edge(struct scanner *scanner, KNIT_STYPE *value, struct span span, const char *text)
{
    static const char *const stitch[] = {[EDGE_GARTER] = "garter", [EDGE_STOCKINETTE] = "stockinette", [EDGE_REVERSE] = "reverse", [EDGE_PURLED] = "p", [EDGE_SLIPPED] = "k",
                                         [EDGE_UNCLEAR] = "k"};
    const struct page_facts *facts = &scanner->parse->facts;
    char name[32];

    if (facts->edge == EDGE_SLIPPED)
        refused_word(scanner->parse->diag, "slip", span);
    if (facts->edge == EDGE_UNCLEAR) {
        diag_error(scanner->parse->diag, CODE_ELSEWHERE, span, "what is said of these edge stitches is not understood");
        diag_hint(scanner->parse->diag, "`Edge sts: knit on RS rows, purl on WS rows`, or write their stitches here: `k1`");
    }
    scanner_number_word(value, text);
    if (isdigit((unsigned char)*text))
        value->number.value = strtod(text, NULL);
    snprintf(name, sizeof name, "%s%.0f", facts->rounds ? "k" : stitch[facts->edge], fmin(value->number.value, 999999));
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
    scanner->turned = scanner->at;
    return scanner_token(scanner, TOKEN_NAME);
}

bool scanner_behind_turned(const struct scanner *scanner, struct span next)
{
    return scanner->turned && scanner->turned + strspn(scanner->parse->text + scanner->turned, " \t") == next.start;
}

/* `pm`, `slip the marker`, `remove m` */
int scanner_marker(struct scanner *scanner, KNIT_STYPE *value, const char *text)
{
    value->marker = words_one_of("place|add|pm", text) ? item_placed : words_one_of("remove|rm", text) ? item_removed : item_slipped;
    return scanner_token(scanner, TOKEN_MARKER);
}

/* `to the second marker`, `before m` */
int scanner_to_marker(struct scanner *scanner, KNIT_STYPE *value, const char *text)
{
    bool before = words_one_of("before|from", text) > 0;

    value->to_marker = strstr(text, "second") ? UNTIL_SECOND_MARKER : strstr(text, "last") ? UNTIL_LAST_MARKER : UNTIL_MARKER;
    return scanner_token(scanner, before ? TOKEN_BEFORE_MARKER : TOKEN_TO_MARKER);
}

/* "knit the knits and purl the purls": as below; with the two exchanged: the opposite. */
int scanner_below(struct scanner *scanner, KNIT_STYPE *value, struct span span, const char *text)
{
    char letter[4];
    int n = 0;

    for (size_t at = 0, length; text[at] && n < 4; at += length + (length == 0)) {
        length = words_length(text + at);
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
        for (size_t i = 0; i < sizeof words / sizeof *words; i++)
            if (words_is(text, words[i].word)) {
                value->parity.of = words[i].of;
                value->parity.plus = words[i].plus;
            }
        text += words_length(text);
        if (!*text)
            break;
    }
}

/* "k2, p2 rib", "3 x 3 rib", "double rib": the numbers of a rib. */
static struct fabric rib_of(const char *text)
{
    struct fabric rib = {FABRIC_RIB, 1, 1};
    int *number[] = {&rib.knit, &rib.purl};

    if (words_is(text, "double"))
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

size_t scanner_within(const struct scanner *scanner, KNIT_STYPE *value, const char *text)
{
    size_t n = within_length(text, &value->within);

    return scanner->previous != ':' || value->within.row || value->within.last ? n : 0;
}

bool scanner_edges(struct scanner *scanner, KNIT_STYPE *value, struct span span, const char *text)
{
    struct kept_edges edges;
    const char *fabric;
    size_t length = scanner->section || !scanner->parse->facts.page ? 0 : edges_length(text, &edges, &fabric);

    if (!length)
        return false;
    span.start += (unsigned)(fabric - text);
    span.end = span.start + (unsigned)words_length(fabric);
    if (words_is(fabric, "moss"))
        scanner_fabric(scanner, value, span, fabric);
    edges.length = (unsigned)length;
    value->edges = edges;
    return true;
}

/* Warns of the second number of `Knit 3 or 4 rows`, which is no part of the plain text. */
void scanner_choice(struct scanner *scanner, struct span span)
{
    const char *text = scanner->parse->source->text;

    for (unsigned at = span.start; at < span.end; at++)
        if (!isalnum((unsigned char)text[at - (at > 0)]) && words_is(text + at, "or") && !words_is(scanner->parse->text + at, "or")) {
            diag_warning(scanner->parse->diag, CODE_FIRST_SIZE, span, "so many rows or others: the first number is taken");
            diag_hint(scanner->parse->diag, "for the other, write it alone");
            return;
        }
}

int scanner_section(struct scanner *scanner, struct span span)
{
    diag_error(scanner->parse->diag, CODE_ROW_REFERENCE, span, "which rows these parts of the pattern are is not known: rows are repeated by their numbers");
    diag_hint(scanner->parse->diag, "`Repeat rows 1-8 once`; rows of several parts, numbered on from one to the next");
    return scanner_token(scanner, TOKEN_PROSE);
}

int scanner_rib(struct scanner *scanner, KNIT_STYPE *value, struct span span)
{
    struct ribs *ribs = &scanner->parse->ribs;

    ribs_read(ribs, scanner->parse->text, span.start);
    if (ribs->n > 1) {
        diag_error(scanner->parse->diag, CODE_ELSEWHERE, span, "which rib this is is not said: there are several");
        diag_hint(scanner->parse->diag, "`Work 4 rows in k%d, p%d rib`", ribs->knit, ribs->purl);
        return TOKEN_KNIT_error;
    }
    value->fabric = (struct fabric){FABRIC_RIB, ribs->knit, ribs->purl};
    return scanner_token(scanner, ribs->n ? TOKEN_FABRIC : TOKEN_RIB);
}

/* "every alternate row", "alt rows"; "every following row" is each of them. */
void scanner_following(KNIT_STYPE *value, const char *text)
{
    static const char *const second[] = {"alt", "alternate", "other"};

    value->all.round = ends_with_round(text);
    value->all.kind = ALL_FOLLOWING;
    for (; *text; text += words_length(text) + (words_length(text) == 0))
        for (size_t i = 0; i < sizeof second / sizeof *second; i++)
            if (words_is(text, second[i]))
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
    for (; *text && value->all.kind == ALL_EVERY; text += strspn(text, " \t\f\v-)")) {
        size_t length = strcspn(text, " \t\f\v-)");

        for (size_t i = 0; i < sizeof words / sizeof *words; i++)
            if (length == strlen(words[i].word) && strncasecmp(text, words[i].word, length) == 0)
                value->all.kind = words[i].all;
        text += length;
    }
}

/* "RS:", "wrong side row:". */
void scanner_side_row(KNIT_STYPE *value, const char *text)
{
    value->all.round = false;
    value->all.kind = tolower((unsigned char)*text) == 'r' ? ALL_RS_ROW : ALL_WS_ROW;
}

void scanner_measure(struct scanner *scanner, KNIT_STYPE *value, struct span span, const char *phrase)
{
    double length = lengths_wanted(phrase, &value->measure.part), rows;

    rows = floor(length * scanner->parse->facts.gauge + 0.5);
    value->measure.rows = rows > 0 && rows <= LIMIT_ROWS ? (int)rows : 0;
    value->measure.ending = lengths_ending(phrase, &value->measure.other);
    value->measure.counted = value->measure.rows == 0 && lengths_counted(phrase);
    if (value->measure.counted)
        value->measure.rows = lengths_counted(phrase);
    if (value->measure.rows == 0 || value->measure.counted)
        return;
    diag_warning(scanner->parse->diag, CODE_LENGTH, span, "by the gauge this text states, this length is %d row%s", value->measure.rows,
                 value->measure.rows == 1 ? "" : "s");
    diag_hint(scanner->parse->diag, "the nearest number of whole repeats is worked; `until piece has %d rows` says it", value->measure.rows);
}

/* The bytes of the word or the number that a text begins with, or of one mark. */
static size_t piece_length(const char *text)
{
    size_t n = words_length(text);

    n = n ? n : strspn(text, "0123456789");
    return n ? n : 1;
}

/* `repeat them twice more` behind `Rows 3 and 4 form the moss`: they alone, whatever they form. */
static bool them_again(const char *text)
{
    text += strspn(text, ".;, ");
    return words_are(text, WORDS_AGAIN) && words_is(words_next(text), "them");
}

bool scanner_told(KNIT_STYPE *value, const char *sentence, const char *behind)
{
    static const char *const between[] = {"to", "and", "through"}, *const pattern[] = {"pat", "patt", "pattern", "rep", "repeat", "motif", "design", "stitch", "st", "rib", "fabric"};
    struct told told = {0};
    bool rows = false, verb = false;

    for (const char *at = sentence; *at; at += piece_length(at)) {
        int n = words_number(at);

        if (verb && words_find(at, pattern, sizeof pattern / sizeof *pattern) >= 0) {
            value->told = told;
            return told.n || (told.first && told.first <= told.last);
        }
        if (!rows && words_are_rows(at) && !told.n)
            told.n = tolower((unsigned char)at[words_length(at) - 1]) != 's';
        if (n && !rows)
            told.n = n;
        else if (n && !verb)
            told = (struct told){0, told.first ? told.first : n, n};
        verb |= rows && words_length(at) && !n && words_find(at, between, 3) < 0;
        rows |= words_are_rows(at);
    }
    value->told = told;
    return verb && them_again(behind) && (told.n || (told.first && told.first <= told.last));
}
