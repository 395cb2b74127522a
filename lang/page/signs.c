/* SPDX-License-Identifier: GPL-3.0-or-later
 * A place of a text in, what stands for it plainly out: `(left border)` is
 * nothing, `fifteen times` is 15 times, `Row 1 ~ k2` has a dash. */
#include "lang/page/signs.h"

#include <ctype.h>
#include <stdbool.h>
#include <stdio.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "lang/page/clauses.h"
#include "lang/page/edges.h"
#include "lang/page/fabrics.h"
#include "lang/page/framing.h"
#include "lang/page/kinds.h"
#include "lang/page/lengths.h"
#include "lang/page/prose.h"
#include "lang/page/prose_line.h"
#include "lang/page/remarks.h"
#include "lang/page/row_phrases.h"
#include "lang/page/rows_go_on.h"
#include "lang/page/rows_told.h"
#include "lang/page/sided_rows.h"
#include "lang/page/sums.h"
#include "lang/page/words.h"

/* ---- numbers in letters ---- */

/* `thirteen`, `forty`, `twenty-four`: its bytes, and the number; below thirteen the scanner knows them. */
static size_t number_length(const char *text, int *number)
{
    static const char *const teens[] = {"thirteen", "fourteen", "fifteen", "sixteen", "seventeen", "eighteen", "nineteen"},
                             *const tens[] = {"twenty", "thirty", "forty", "fifty", "sixty", "seventy", "eighty", "ninety"},
                             *const ones[] = {"one", "two", "three", "four", "five", "six", "seven", "eight", "nine"};
    size_t n = words_length(text), behind = n + (text[n] == '-' || text[n] == ' ');
    int teen = words_find(text, teens, 7), ten = words_find(text, tens, 8), one = words_find(text + behind, ones, 9);

    *number = teen >= 0 ? 13 + teen : 20 + 10 * ten;
    if (teen < 0 && ten < 0)
        return 0;
    if (ten < 0 || one < 0 || behind == n)
        return n;
    *number += one + 1;
    return behind + words_length(text + behind);
}

/* Whether what is counted stands behind, or `cast on`, `knit` before: elsewhere it may be a name. */
static bool is_count(const char *text, size_t at, size_t length)
{
    static const char *const before[] = {"on", "k", "p", "knit", "purl", "row", "rows", "of", "last"};
    const char *behind = text + at + length;
    size_t end;

    if (words_are(words_skip_blanks(behind), WORDS_STITCH | WORDS_ROW | WORDS_TIMES) || words_is(words_skip_blanks(behind), "more"))
        return true;
    while (at > 0 && strchr(" \t", text[at - 1]))
        at--;
    for (end = at; at > 0 && isalpha((unsigned char)text[at - 1]);)
        at--;
    return end > at && words_find(text + at, before, sizeof before / sizeof *before) >= 0;
}

/* ---- other words for stitches and rows ---- */

/* The number of the row whose text begins here, `Row 6: `; 0: none begins, or one of several rows. */
static int row_begun(const char *text, size_t at)
{
    size_t digits, colon;

    while (at > 0 && text[at - 1] == ' ')
        at--;
    if (at == 0 || text[at - 1] != ':')
        return 0;
    at--;
    if (at > 4 && text[at - 1] == ')' && text[at - 4] == '(')
        at -= 4 + (text[at - 5] == ' ');
    for (digits = colon = at; digits > 0 && isdigit((unsigned char)text[digits - 1]);)
        digits--;
    return digits == colon || colon - digits > 6 || (digits > 0 && !strchr(" rR", text[digits - 1])) ? 0 : atoi(text + digits);
}

/* The stitch that `2 right`, `2 wrong`, `2 plain` of a translation mean: its letter; or 0. */
static char translated_stitch(const char *text, size_t at)
{
    static const char *const words[] = {"right", "rights", "plain", "wrong", "wrongs"}, *const others[] = {"side", "sides", "row", "rows", "rnd", "rnds", "round", "rounds"};
    int word = words_find(text + at, words, 5);
    const char *behind = words_next(text + at);

    if (word < 0 || at < 2 || text[at - 1] != ' ' || !isdigit((unsigned char)text[at - 2]) || words_find(behind, others, 8) >= 0 || !remarks_in_row(text, at))
        return 0;
    return word < 3 ? 'k' : 'p';
}

/* `plain` behind `Row 3:`, alone: a row of knit stitches. */
static bool is_plain_row(const char *text, size_t at)
{
    return words_is(text + at, "plain") && row_begun(text, at) && prose_line_ends(text + at + 5);
}

/* `(RS)`, `- right side row` at a row's end: which side it is worked on, without the brackets. */
static size_t side_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    const char *side = words_skip_blanks(text + at + 1), *end = words_skip_any(side, text[at] == '-' ? "rs|ws|right side|wrong side|row" : "rs|ws|right side|wrong side");

    if (end == side || (text[at] != '-' && *end != (text[at] == '(' ? ')' : ']')))
        return 0;
    end += text[at] != '-';
    if (!prose_line_ends(end) || !remarks_in_row(text, at) || at == 0 || row_begun(text, at + 1))
        return 0;
    snprintf(plain, SIGNS_PLAIN, " %cs", tolower((unsigned char)*side));
    return (size_t)(end - text) - at;
}

/* `(RS)` of `All odd-numbered (RS) rows: knit`, which is one side's rows by their number already. */
static bool is_side_between(const char *text, size_t at)
{
    static const char *const which[] = {"even", "odd", "numbered"};
    const char *behind = words_skip_blanks(text + at + 4);
    size_t before = at;

    if (!words_are(text + at + 1, WORDS_SIDE) || text[at + 3] != ')' || !words_are_rows(behind))
        return false;
    behind = words_next(behind);
    behind = *behind == ':' ? words_skip_blanks(behind + 1) : "";
    if (!words_are(behind, WORDS_PLAIN) || !prose_line_ends(behind + words_length(behind)))
        return false;
    while (before > 0 && text[before - 1] == ' ')
        before--;
    while (before > 0 && isalpha((unsigned char)text[before - 1]))
        before--;
    return words_find(text + before, which, 3) >= 0;
}

/* `// fixed`, `<- odd one`: words to the reader up to the line's end. */
static size_t aside_length(const char *text, size_t at)
{
    size_t n = strncmp(text + at, "//", 2) == 0 || strncmp(text + at, "<-", 2) == 0 ? 2 : 0;

    if (!n || at == 0 || text[at - 1] != ' ' || words_line_has_sign(text + at, "0123456789*()[]") || !remarks_in_row(text, at))
        return 0;
    return words_line_has(text + at, "rep") || words_line_has(text + at, "repeat") ? 0 : words_line_length(text + at);
}

/* The dots of `K2, P2 ... end K2`. */
static bool is_dots(const char *text, size_t at)
{
    bool dots = strncmp(text + at, "...", 3) == 0 || strncmp(text + at, "\xE2\x80\xA6", 3) == 0;
    const char *behind = dots ? words_skip_blanks(text + at + 3) : "";

    return (words_is(behind, "end") || words_is(behind, "ending")) && remarks_in_row(text, at);
}

/* The blank before `CO 20`, the comma before `R2:`: where a sentence ends and a part of the pattern begins. */
static bool is_end_of_sentence(const char *text, size_t at)
{
    const char *behind = words_skip_blanks(text + at + 1);

    if (text[at] == ',')
        return tolower((unsigned char)*behind) == 'r' && isdigit((unsigned char)behind[1]) && behind[1 + strspn(behind + 1, "0123456789")] == ':';
    return at > 1 && text[at - 1] == '.' && isalpha((unsigned char)text[at - 2]) && words_is(behind, "co") && isdigit((unsigned char)*words_skip_blanks(behind + 2));
}

/* ---- marks ---- */

/* `(27, 33)` of `k2 - 21 (27, 33) sts` at a row's end: how many stitches other sizes then have. */
static size_t other_counts_length(const char *text, size_t at)
{
    size_t close = at + 1 + strspn(text + at + 1, "0123456789, "), end = close + 1 + strspn(text + close + 1, " "), digits = at;

    if (text[close] != ')' || close == at + 1 || !words_are_stitches(text + end))
        return 0;
    end += words_length(text + end);
    end += strspn(text + end, " .)]");
    while (digits > 0 && text[digits - 1] == ' ')
        digits--;
    close += 1 - at;
    at = digits;
    while (digits > 0 && isdigit((unsigned char)text[digits - 1]))
        digits--;
    if (digits == at || (text[end] && !strchr("\r\n", text[end])))
        return 0;
    while (digits > 0 && text[digits - 1] == ' ')
        digits--;
    return digits > 0 && strchr(".;,-([\x93\x94", text[digits - 1]) ? close : 0;
}

/* A bar of `| 1 | RS | k2, p2`: only numbers and sides stand before it on the line. */
static bool is_table_bar(const char *text, size_t at)
{
    size_t line = words_line_start(text, at);

    while (strchr(" \t", text[line]) && text[line])
        line++;
    if (!isdigit((unsigned char)text[line + strspn(text + line, "| \t")]))
        return false;
    for (; line < at; line++)
        if (!isdigit((unsigned char)text[line]) && !strchr("| \tRSWrsw()", text[line]))
            return false;
    return true;
}

/* Whether the line is one of expressions up to here, where `[2]` is a list or a place in one. */
static bool in_expression(const char *text, size_t at)
{
    static const char *const words[] = {"let", "param", "sweep", "for", "if", "swatch", "motif", "output"};
    size_t line = words_line_start(text, at);

    return memchr(text + line, '=', at - line) || words_find(text + line + strspn(text + line, " \t"), words, sizeof words / sizeof *words) >= 0;
}

/* `[18]` that ends a line: its bytes. */
static size_t count_length(const char *text)
{
    size_t digits = strspn(text + 1, "0123456789"), behind = 2 + digits;

    if (!digits || digits > 5 || text[1 + digits] != ']')
        return 0;
    behind += strspn(text + behind, ". \t");
    return text[behind] && !strchr("\r\n", text[behind]) ? 0 : 2 + digits;
}

/* Whether the line's beginning is `Knit 15 rows of garter stitch`. */
static bool counts_rows(const char *line, size_t length)
{
    return length > 0 && words_are(line, WORDS_PLAIN | WORDS_WORK) && prose_rows_follow(words_next(line));
}

/* The dash of `k5 - border`, `Knit 8 rows - top border`, with its remark up to a mark; of `purl - reverse stockinette`, up to the line's end. */
static size_t dash_remark_length(const char *text, size_t at)
{
    static const char *const dashes[] = {"- ", "-- ", "\xE2\x80\x93 ", "\xE2\x80\x94 "};
    size_t dash = 0, length, before = at, line;

    for (int i = 0; i < 4; i++)
        dash = strncmp(text + at, dashes[i], strlen(dashes[i])) == 0 ? strlen(dashes[i]) - 1 : dash;
    if (at == 0 || text[at - 1] != ' ' || !dash)
        return 0;
    length = dash + 1 + strcspn(text + at + dash + 1, ",;:.()[]*\r\n");
    while (before > 0 && text[before - 1] == ' ')
        before--;
    if (before > 0 && isdigit((unsigned char)text[before - 1]))
        return remarks_are(text + at + dash + 1, length - dash - 1) ? length : 0;
    line = words_line_start(text, at);
    if (counts_rows(text + line, before - line) && (remarks_are(text + at + dash + 1, length - dash - 1) || remarks_talk(text + at + dash + 1, length - dash - 1)))
        return length;
    return memchr(text + line, ':', before - line) && remarks_on_fabric(text + at + dash) ? words_line_length(text + at) : 0;
}

/* The sign between stitches of `p2/k6/p2`, `k2-p2`. */
static bool is_between_stitches(const char *text, size_t at)
{
    size_t before = at;

    while (before > 0 && isdigit((unsigned char)text[before - 1]))
        before--;
    return before < at && before > 0 && strchr("kKpP", text[before - 1]) && (before == 1 || !isalnum((unsigned char)text[before - 2])) &&
           strchr("kKpP", text[at + 1]) && text[at + 1] && isdigit((unsigned char)text[at + 2]);
}

/* The sign between the numbers of `Rows 1/3:`, `Rows 5/7/9:`. */
static bool is_between_rows(const char *text, size_t at)
{
    size_t word = at, margin = at > WORDS_MARGIN ? at - WORDS_MARGIN : 0, end;

    while (word > margin && isdigit((unsigned char)text[at + 1]) && (isdigit((unsigned char)text[word - 1]) || strchr("/, ", text[word - 1])))
        word--;
    if (word == at)
        return false;
    for (end = word; word > 0 && isalpha((unsigned char)text[word - 1]);)
        word--;
    if (end == word || !words_are_rows(text + word))
        return false;
    word = words_before(text, word);
    return !words_are(text + word, WORDS_AGAIN | WORDS_WORK) && !words_is(text + word, "as");
}

/* The sign of `R1/RS:`. */
static bool is_before_side(const char *text, size_t at)
{
    return at > 1 && isdigit((unsigned char)text[at - 1]) && (words_is(text + at + 1, "rs") || words_is(text + at + 1, "ws")) && text[at + 3] == ':' && remarks_in_row(text, at);
}

/* `Row1`, `Rnds1` without a blank before the number: the word's bytes, and `R`, `Rd ` as short a name of a row or round. */
static size_t glued_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    size_t n = words_length(text + at);
    bool round = words_are_rows(text + at) && tolower((unsigned char)text[at + 1]) != 'o', rows = words_are_rows(text + at);

    round |= rows && tolower((unsigned char)text[at + 2]) == 'u';
    if (!rows || n < 3 || !isdigit((unsigned char)text[at + n]))
        return 0;
    snprintf(plain, SIGNS_PLAIN, round ? "Rd%*s" : "%*s", (int)n - (round ? 2 : 0), round ? "" : "R");
    return n;
}

/* A bracket of `Odd-numbered rows (1, 3, 5):`: its byte; or 0. */
static size_t listed_length(const char *text, size_t at)
{
    static const char list[] = "0123456789,&-\xe2\x80\x93 and";
    size_t open = at, end = at;

    if (text[at] == ')') {      /* the other is blank by now */
        while (open > 0 && strchr(list, text[open - 1]))
            open--;
    } else {
        end = text[at] == '(' ? at + 1 + strspn(text + at + 1, list) : at;
        open -= open > 0;
    }
    if (text[end] != ')' || end < open + 4 || text[end + 1] != ':')
        return 0;
    while (open > 0 && isalpha((unsigned char)text[open - 1]))
        open--;
    return words_are_rows(text + open);
}

/* `then` of `K2, then K1, P1 to last 2 sts, K2`, behind which the repeat begins that has no star. */
static bool begins_repeat(const char *text, size_t at)
{
    static const char *const ends[] = {"until", "till", "repeat", "rep"};
    size_t end;
    const char *behind = words_skip_blanks(text + at + 4);
    bool ended = false;

    if (!words_is(text + at, "then") || !remarks_in_row(text, at) || !prose_stitches_follow(behind) || !isdigit((unsigned char)behind[1]))
        return false;
    end = words_line_length(text + at);
    for (size_t i = 0; i < end; i += words_length(text + at + i) + 1)
        ended |= words_find(text + at + i, ends, 4) >= 0 || (words_is(text + at + i, "to") && words_line_has(text + at + i, "last"));
    return ended && !words_line_has_sign(text + words_line_start(text, at), "*([{");
}

/* `[RS]`, `RS -` at the beginning of a line, before stitches: its bytes, and `RS:`. */
static size_t side_head_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    bool bracket = text[at] == '[' || text[at] == '(';
    size_t side = at + bracket, end = side + 2, line = at;

    while (line > 0 && strchr(" \t-*+>", text[line - 1]))
        line--;
    if ((line > 0 && !strchr("\r\n", text[line - 1])) || (!words_is(text + side, "rs") && !words_is(text + side, "ws")))
        return 0;
    end += bracket && strchr(")]", text[end]) ? 1 : 0;
    if (!bracket && strncmp(text + end, " - ", 3) == 0)
        end += 2;
    else if (!bracket && (strncmp(text + end, " \xE2\x80\x93 ", 5) == 0 || strncmp(text + end, " \xE2\x80\x94 ", 5) == 0))
        end += 4;
    snprintf(plain, SIGNS_PLAIN, "%.2s:", text + side);
    return end > side + 2 && prose_stitches_follow(words_skip_blanks(text + end)) ? end - at : 0;
}

/* The second letter of `R7-R8`. */
static bool is_second_row(const char *text, size_t at)
{
    size_t before = at;

    while (before > 0 && strchr(" -\xE2\x80\x93\x94", text[before - 1]))
        before--;
    if (before == at || !isdigit((unsigned char)text[at + 1]) || before == 0 || !isdigit((unsigned char)text[before - 1]))
        return false;
    while (before > 0 && isdigit((unsigned char)text[before - 1]))
        before--;
    return before > 0 && strchr("rR", text[before - 1]) && (before == 1 || !isalnum((unsigned char)text[before - 2]));
}

/* `3rd and 4th rows` behind `work`, `then`: its bytes, and `rows 3 and 4`. */
static size_t ordinals_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    static const char *const joins[] = {"and", "to"};
    size_t here = at, before = at, n;
    int number[2] = {0}, join = -1;

    while (before > 0 && text[before - 1] == ' ')
        before--;
    while (before > 0 && isalpha((unsigned char)text[before - 1]))
        before--;
    if (before == at || !words_are(text + before, WORDS_WORK | WORDS_AGAIN | WORDS_THEN))
        return 0;
    for (int i = 0; i < 2; i++) {
        n = strspn(text + here, "0123456789");
        if (!n || n > 4 || !words_ordinal_length(text + here))
            return 0;
        number[i] = atoi(text + here);
        here += n + 2 + strspn(text + here + n + 2, " ");
        join = i == 0 ? words_find(text + here, joins, 2) : join;
        if (join < 0)
            break;
        here += i == 0 ? words_length(text + here) + 1 : 0;
    }
    if (!words_are_rows(text + here))
        return 0;
    if (join < 0)
        snprintf(plain, SIGNS_PLAIN, "row %d", number[0]);
    else
        snprintf(plain, SIGNS_PLAIN, "rows %d %s %d", number[0], joins[join], number[1]);
    here += words_length(text + here) - at;
    return strlen(plain) <= here ? here : 0;
}

/* The dash of `k-3, p-2`: its letter goes for both. */
static size_t dashed_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    size_t digits = text[at + 1] == '-' ? strspn(text + at + 2, "0123456789") : 0;

    if (!digits || isalnum((unsigned char)text[at + 2 + digits]) || (at > 0 && text[at - 1] == '{') || !remarks_in_row(text, at))
        return 0;
    *plain = text[at];
    plain[1] = '\0';
    return 2;
}

/* ---- all of them ---- */

static size_t caption_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    return remarks_caption(text + at, plain);
}

static size_t translated_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    *plain = translated_stitch(text, at);
    plain[1] = '\0';
    return *plain ? words_length(text + at) : 0;
}

static size_t counted_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    size_t length = count_length(text + at);

    if (!length || in_expression(text, at))
        return 0;
    snprintf(plain, SIGNS_PLAIN, "(%d)", atoi(text + at + 1));
    return length;
}

static size_t spelled_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    int number;
    size_t length = number_length(text + at, &number);

    if (!length || !is_count(text, at, length))
        return 0;
    snprintf(plain, SIGNS_PLAIN, "%d", number);
    return length;
}

static size_t chatter_length(const char *text, size_t at)
{
    return remarks_chatter(text + at);
}

/* `instead of k2`, behind what is worked. */
static size_t instead_length(const char *text, size_t at)
{
    const char *stitch = text + at + 11;

    if (strncasecmp(text + at, "instead of ", 11) != 0 || !strchr("kKpP", *stitch) || !isdigit((unsigned char)stitch[1 + strspn(stitch + 1, " ")]))
        return 0;
    return 12 + strspn(stitch + 1, " 0123456789");
}

static bool is_ellipsis(const char *text, size_t at)
{
    return strncmp(text + at, "\xE2\x80\xA6", 3) == 0 && at > 0 && (isalnum((unsigned char)text[at - 1]) || strchr(".,;)", text[at - 1]));
}

static bool is_tilde(const char *text, size_t at)
{
    return at > 0 && text[at - 1] == ' ' && text[at + 1] == ' ';
}

static bool is_between(const char *text, size_t at)
{
    return at > 0 && (is_between_stitches(text, at) || is_between_rows(text, at));
}

/* Edges that are kept, in a sentence without a verb of keeping. */
static size_t kept_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    return edges_said(text, at, plain, SIGNS_PLAIN);
}

/* Each sign or remark: what it may begin with, whether at a word's begin alone, and either what tells its bytes and its
 * plain text, or its bytes, for blanks, or that it is one, of so many bytes for a plain text. The first that fits counts. */
static const struct sign {
    const char *first;
    bool word;
    size_t (*says)(const char *text, size_t at, char plain[static SIGNS_PLAIN]);
    size_t (*skips)(const char *text, size_t at);
    bool (*is)(const char *text, size_t at);
    size_t length;
    const char *plain;
} signs[] = {
    {",;.(-", false, .says = sums_length},
    {"fFtTkKwWaArRnN", true, .says = kept_length},
    {",([", false, .says = lengths_count},
    {"([", false, .says = caption_length},
    {"tTyYnNsS", true, .says = remarks_said},
    {"<{=|([/:-~\xE2", false, .says = remarks_said},
    {":;<^", false, .skips = remarks_face},
    {"rRpPwW", true, .says = translated_length},
    {"sSaAlLrRwWdDiItTeE", true, .says = row_phrases_previous},
    {"kKpP", true, .says = dashed_length},
    {"kKpPwWbBsSoO1aAtTnNfF", true, .says = sided_rows_length},
    {"(", false, .is = is_side_between, 4, ""},
    {"(", false, .says = row_phrases_star},
    {"aAkKpP", true, .says = row_phrases_alternate},
    {"kKpP", true, .says = row_phrases_sided},
    {":)-.", false, .says = rows_go_on_length},
    {"sSgG", true, .says = fabrics_short},
    {"rR", true, .says = fabrics_rib},
    {"wWkK0123456789", true, .says = fabrics_rows},
    {"kKpPaA1oO", true, .says = fabrics_alternate},
    {"[(*", false, .says = fabrics_alternate},
    {"cCsSbBpP", true, .says = fabrics_changed},
    {"wWfF0123456789", true, .says = fabrics_of_rows},
    {"sSbBcC", true, .says = fabrics_begun},
    {"kKpPaAeEoOuUwWrRtT", true, .says = kinds_length},
    {"(", false, .says = kinds_length},
    {"(", false, .says = kinds_added},
    {"oOtTaArRwWeE", true, .says = kinds_given_before},
    {"rRtTyYfFsS0123456789aA", true, .says = rows_told_length},
    {"eEfFcCbBsStTaA", true, .says = framing_length},
    {",", false, .says = framing_length},
    {",)!", false, .says = clauses_length},
    {"wWoOaAtTfFmMnN", true, .says = clauses_length},
    {"wWcC", true, .says = row_phrases_repeats},
    {"tTfF", true, .says = row_phrases_form},
    {"iI", true, .says = row_phrases_formed},
    {"wWiI", true, .says = row_phrases_rib},
    {"rR", true, .says = row_phrases_passive},
    {"uUtT", true, .says = row_phrases_told},
    {"rR", true, .says = row_phrases_named},
    {"tTlLpPaA", true, .says = row_phrases_last},
    {"wWkKfFlLnNoOrRgGsSmMtT0123456789", true, .says = row_phrases_fabric},
    {"\t", false, .skips = remarks_column},
    {"p", true, .is = is_plain_row, 5, "knit"},
    {"([rRwW", true, .says = side_head_length},
    {"([-", false, .says = side_length},
    {"/<", false, .skips = aside_length},
    {".\xE2", false, .is = is_dots, 3, "rep"},
    {" ,", false, .is = is_end_of_sentence, 1, "\n"},
    {"/", false, .is = is_before_side, 1, ""},
    {"(oOeEuU", true, .skips = listed_length},
    {")", false, .skips = listed_length},
    {"(", false, .skips = chatter_length},
    {"(", false, .skips = remarks_version},
    {"(", false, .skips = other_counts_length},
    {"(", true, .skips = remarks_length},
    {"\xE2", false, .is = is_ellipsis, 3, ""},
    {"~", false, .is = is_tilde, 1, "-"},
    {"[", false, .says = counted_length},
    {"/", false, .is = is_between, 1, ","},
    {"-", false, .is = is_between_stitches, 1, ","},
    {"-\xE2", false, .skips = dash_remark_length},
    {"rR", true, .says = glued_length},
    {"rR", false, .is = is_second_row, 1, ""},
    {"tT", true, .is = begins_repeat, 4, "*"},
    {"0123456789", true, .says = ordinals_length},
    {"|", false, .is = is_table_bar, 1, ""},
    {"|", false, .skips = remarks_bar},
    {"iI", true, .skips = instead_length},
    {"tfsenTFSEN", true, .says = spelled_length},
};

size_t signs_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    bool begins = at == 0 || !isalnum((unsigned char)text[at - 1]);

    for (size_t i = 0, length; text[at] && i < sizeof signs / sizeof *signs; i++) {
        const struct sign *sign = &signs[i];

        if ((sign->word && !begins) || !strchr(sign->first, text[at]))
            continue;
        *plain = '\0';
        if (sign->is)
            length = sign->is(text, at) ? sign->length : 0;
        else
            length = sign->says ? sign->says(text, at, plain) : sign->skips(text, at);
        if (length && sign->is)
            strcpy(plain, sign->plain);
        if (length)
            return length;
    }
    *plain = '\0';
    return 0;
}
