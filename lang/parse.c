/* SPDX-License-Identifier: GPL-3.0-or-later
 * Parses one text; first looks whether it is a script at all. */
#include "lang/parse.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

#include "lang/compile.h"
#include "lang/page/joined.h"
#include "lang/page/lettered.h"
#include "lang/page/listed.h"
#include "lang/limits.h"
#include "lang/page/marks.h"
#include "lang/page/page_chart.h"
#include "lang/page/prose.h"
#include "lang/page/run_on.h"
#include "lang/scanner.h"
#include "lang/page/starred.h"
#include "lang/page/wording.h"
#include "lang/page/words.h"

/* The first bytes of files that are something else, and what they are. */
static const struct format {
    const char *first;
    const char *what;
    const char *advice;
} formats[] = {
    {"{", "a JSON file", NULL},
    {"[", "a JSON file", NULL},
    {"<", "an XML or HTML file", "save the pattern's text alone and try again"},
    {"%PDF", "a PDF file", "copy the pattern's text out of it into a file of its own"},
    {"\x89PNG", "a picture", "`weft import` reads charts from pictures"},
    {"\xFF\xD8\xFF", "a JPEG picture", "save it as PNG, with a pixel for each stitch: `weft import` reads that"},
    {"GIF8", "a GIF picture", "save it as PNG, with a pixel for each stitch: `weft import` reads that"},
    {"PK\x03\x04", "a spreadsheet or another packed file", "save the chart in it as CSV: `weft import` reads that"},
    {";!knitout", "a knitout file", "`weft import` makes a script of it"},
    {"\xFF\xFE", "a text in UTF-16", "save it as UTF-8 and try again"},
    {"\xFE\xFF", "a text in UTF-16", "save it as UTF-8 and try again"},
};

static struct span whole_line(const struct source *source, size_t at)
{
    return diag_line_around((struct span){source, (unsigned)at, (unsigned)at});
}

static const struct format *find_format(const char *text)
{
    if (marks_are_tag(text) || (*text == '[' && isupper((unsigned char)text[1])))    /* a piece of a page; a remark of a printed book */
        return NULL;
    for (size_t i = 0; i < sizeof formats / sizeof *formats; i++)
        if (strncmp(text, formats[i].first, strlen(formats[i].first)) == 0)
            return &formats[i];
    return NULL;
}

const char *source_other_format(const struct source *source, const char **advice)
{
    const struct format *format = find_format(source->text + strspn(source->text, " \t\r\n\f\v"));

    *advice = format ? format->advice : NULL;
    return format ? format->what : NULL;
}

static bool is_other_format(struct diag *diag, const struct source *source, const char *text)
{
    const struct format *format = find_format(text);

    if (!format)
        return false;
    diag_error(diag, CODE_NOT_A_SCRIPT, whole_line(source, (size_t)(text - source->text)), "this is %s, not a script", format->what);
    if (format->advice)
        diag_hint(diag, "%s", format->advice);
    return true;
}

/* Bytes that text does not have. */
static bool is_binary(struct diag *diag, const struct source *source)
{
    static const char control[] = "\x01\x02\x03\x04\x05\x06\x07\x08\x0E\x0F\x10\x11\x12\x13\x14\x15\x16\x17\x18\x19\x1A\x1B\x1C\x1D\x1E\x1F";
    size_t at = strcspn(source->text, control);

    if (at == source->size)
        return false;
    diag_error(diag, CODE_NOT_A_SCRIPT, (struct span){source, 0, 0},
               "this is a binary file, not a script (its byte %zu is 0x%02X)", at + 1, (unsigned char)source->text[at]);
    return true;
}

/* Nothing but K and P, perhaps under a line `# 4 4`: a stitch grid. */
static bool is_stitch_grid(struct diag *diag, const struct source *source, const char *text)
{
    size_t header = 0, stitches;

    if (*text == '#') {
        header = 1 + strspn(text + 1, " \t0123456789");
        if (text[header] != '\n' && text[header] != '\r')
            return false;
    }
    stitches = strspn(text + header, "KPkp \t\r\n");
    if (text[header + stitches] || stitches < 4 || !strpbrk(text + header, "KPkp"))
        return false;
    diag_error(diag, CODE_NOT_A_SCRIPT, whole_line(source, (size_t)(text - source->text)),
               "this is a grid of K and P, not a script");
    diag_hint(diag, "`weft import %s -o pattern.knit` makes a script of it", source->name);
    return true;
}

/* The last byte of the sign that a line of a key explains, `. = purl`; 0: it explains none. */
static char explained_sign(const char *line)
{
    size_t n = words_line_length(line);

    for (size_t i = n > 0; (i += strcspn(line + i, "=:\r\n")) < n; i++) {
        char sign = line[i - 1 - (line[i - 1] == ' ' && i > 1)];
        const char *meaning = words_skip_blanks(line + i + 1);

        if (!isalnum((unsigned char)sign) && !strchr(" )]\"'*", sign) && (words_is(meaning, "knit") || words_is(meaning, "purl")))
            return sign;
    }
    return 0;
}

/* Whether a line has a sign twice at least, and no letter but those of crosses and rings. */
static bool is_drawn(const char *line, char sign)
{
    size_t n = words_line_length(line), signs = 0;

    for (size_t i = 0; i < n; i++) {
        if (isalpha((unsigned char)line[i]) && !strchr("xXoO", line[i]))
            return false;
        signs += line[i] == sign;
    }
    return signs > 1;
}

/* A key and lines of its signs, and no row in words. */
static bool is_drawn_chart(struct diag *diag, const struct source *source, const char *text)
{
    const char *key = NULL;
    int rows = 0;

    for (const char *line = text; *line; line += words_line_length(line), line += strspn(line, "\r\n")) {
        const char *first = line + strspn(line, " \t-*>");

        if (words_are_rows(first) || words_is(first, "cast") || words_is(first, "co") || memchr(first, '{', words_line_length(first)))
            return false;
        key = key || !explained_sign(line) ? key : line;
        rows += key && is_drawn(line, explained_sign(key));
    }
    if (rows < 2)
        return false;
    diag_error(diag, CODE_NOT_A_SCRIPT, whole_line(source, (size_t)(key - source->text)), "this is a chart with its key, not a script");
    diag_hint(diag, "`weft import %s -o pattern.knit` makes a script of it", source->name);
    return true;
}

static bool is_too_long(struct diag *diag, const struct source *source)
{
    if (source->size <= LIMIT_FILE)
        return false;
    diag_error(diag, CODE_LIMIT_FILE, (struct span){source, 0, 0}, "the file is longer than %d bytes", LIMIT_FILE);
    return true;
}

static bool has_long_line(struct diag *diag, const struct source *source)
{
    int lines = 0;

    for (size_t at = 0, length; at < source->size; at += length + 1) {
        struct span span = {source, (unsigned)at, (unsigned)at};

        length = words_line_length(source->text + at);
        lines += length > 0 || source->text[at] != '\n' || at == 0 || source->text[at - 1] != '\r';
        if (length > LIMIT_LINE)
            diag_error(diag, CODE_LIMIT_LINE, span, "this line is %zu bytes long; a line may have %d", length, LIMIT_LINE);
        else if (lines > LIMIT_LINES)
            diag_error(diag, CODE_LIMIT_FILE, span, "the file is longer than %d lines", LIMIT_LINES);
        else
            continue;
        return true;
    }
    return false;
}

static bool is_script(struct diag *diag, const struct source *source, const char *text)
{
    const char *first = text + strspn(text, " \t\r\n\f\v");

    if (is_too_long(diag, source) || is_other_format(diag, source, first) || is_binary(diag, source) ||
        has_long_line(diag, source))
        return false;
    if (!*first) {
        diag_error(diag, CODE_NOT_A_SCRIPT, (struct span){source, 0, 0}, "the file is empty");
        diag_hint(diag, "a pattern of two lines: `Cast on 20 sts` and `Row 1: *k2, p2; rep from *`");
        return false;
    }
    return !is_stitch_grid(diag, source, first) && !is_drawn_chart(diag, source, first);
}

unsigned source_start(const struct source *source)
{
    return source->size >= 3 && memcmp(source->text, "\xEF\xBB\xBF", 3) == 0 ? 3 : 0;
}

/* What stands in a page for a plain character: blanks of other kinds, HTML's names,
 * Markdown's backslashes.  Blanks come first, then the plain one, so that places stay the same. */
static const struct spelling {
    const char *text;
    char plain;
} spellings[] = {
    {"\xC2\xA0", ' '},     {"\xE2\x80\xAF", ' '}, {"\xE2\x80\x82", ' '}, {"\xE2\x80\x83", ' '}, {"\xE2\x80\x89", ' '},
    {"\xE2\x80\x8A", ' '}, {"\xE2\x80\x8B", ' '}, {"\xE2\x80\x87", ' '}, {"\xE2\x81\xA0", ' '}, {"\xE3\x80\x80", ' '},
    {"\xE2\x80\xA0", '*'}, {"\xE2\x80\xA1", '*'}, {"\xEF\xBB\xBF", ' '}, {"&nbsp;", ' '},       {"&amp;", '&'},        {"&ndash;", '-'},      {"&mdash;", '-'},
    {"&#8211;", '-'},      {"&#8212;", '-'},      {"&times;", 'x'},      {"&#160;", ' '},       {"&#215;", 'x'},
    {"&lt;", '<'},         {"&gt;", '>'},         {"\\*", '*'},          {"\\[", '['},          {"\\]", ']'},
    {"\\(", '('},          {"\\)", ')'},          {"\\-", '-'},          {"\\#", ' '},
};

/* The bytes they begin with. */
static const char spelling_first[] = "\xC2\xE2\xE3\xEF&\\";

/* The spelling a text begins with; or NULL. */
static const struct spelling *spelling_at(const char *text)
{
    if (!strchr(spelling_first, *text))
        return NULL;
    for (size_t i = 0; i < sizeof spellings / sizeof *spellings; i++)
        if (text[1] == spellings[i].text[1] && (!spellings[i].text[2] || text[2] == spellings[i].text[2]) && strncmp(text, spellings[i].text, strlen(spellings[i].text)) == 0)
            return &spellings[i];
    return NULL;
}

size_t source_blank(const char *text)
{
    const struct spelling *spelling = spelling_at(text);

    if (spelling)
        return spelling->plain == ' ' ? strlen(spelling->text) : 0;
    return *text && strchr(" \t\f\v", *text) ? 1 : 0;
}

/* The text with every kind of blank as a plain one, byte for byte at its place. */
static const char *plain_characters(struct arena *arena, const struct source *source)
{
    char *text = NULL;

    for (size_t at = 0; (at += strcspn(source->text + at, spelling_first)) < source->size; at++) {
        const struct spelling *spelling = spelling_at(source->text + at);

        if (!spelling)
            continue;
        text = text ? text : arena_copy(arena, source->text, source->size);
        memset(text + at, ' ', strlen(spelling->text));
        at += strlen(spelling->text) - 1;
        text[at] = spelling->plain;
    }
    return text ? text : source->text;
}

/* The same with its words put plainly, too, and what it says of all its rows. */
static const char *plain_text(struct parse *parse)
{
    struct arena *arena = parse->arena;
    size_t size = parse->source->size;
    const char *text = plain_characters(arena, parse->source);
    bool page = words_are_page(text, size);

    text = page ? marks_plain(arena, text, size) : text;
    parse->facts = page_facts_read(text, size);
    if (!page)
        return text;
    text = run_on_plain(arena, joined_plain(arena, text, size), size);
    text = starred_plain(arena, text, size);
    text = listed_plain(arena, lettered_plain(arena, text, size), size);
    text = named_plain(arena, text, size, &parse->named);
    return wording_plain(arena, text, size, &parse->facts);
}

/* The same where a page's chart is, whose lines stay. */
static const char *read_as(struct parse *parse)
{
    const struct source *source = parse->source;
    const struct page_chart *chart = parse->chart;
    const char *plain = plain_text(parse);
    char *text = chart ? arena_copy(parse->arena, plain, source->size) : NULL;

    for (int i = 0; chart && i < chart->lines; i++) {
        unsigned start = chart->line[i].start - (chart->line[i].start > 0), end = chart->line[i].end + (chart->line[i].end < source->size);

        memcpy(text + start, source->text + start, end - start);
    }
    return text ? text : plain;
}

/* Puts the page's chart behind the statements. */
static void append_chart(struct parse *parse)
{
    struct stmt **last = &parse->file, *stmt;

    if (!parse->chart)
        return;
    stmt = ast_stmt(parse, STMT_PAGE_CHART, parse->chart->row[0].line);
    stmt->page_chart = parse->chart;
    while (*last)
        last = &(*last)->next;
    *last = stmt;
}

/* Says how rows are read of which a page says, or may mean, that they are a loom's. */
static void warn_of_loom(struct parse *parse)
{
    unsigned behind = (unsigned)parse->facts.loom;
    struct span word = {parse->source, behind, behind};

    while (word.start > 0 && isalpha((unsigned char)parse->source->text[word.start - 1]))
        word.start--;
    if (parse->facts.pegs) {
        diag_warning(parse->diag, CODE_PROSE, word, "rows are read as on a loom: all are worked from the front");
        diag_hint(parse->diag, "where the work is turned, call what holds the stitches needles, not pegs");
    } else if (behind) {
        diag_warning(parse->diag, CODE_PROSE, word, "rows are read as on needles, where the work is turned; on a loom all are worked from the front");
        diag_hint(parse->diag, "`Loom with 32 pegs`, and they are read so");
    }
}

/* Says so where rows are read as turned that may be rounds. */
static void warn_of_circle(struct parse *parse)
{
    unsigned behind = (unsigned)parse->facts.circle;
    struct span word = {parse->source, behind, behind};

    while (word.start > 0 && isalpha((unsigned char)parse->source->text[word.start - 1]))
        word.start--;
    if (!behind)
        return;
    diag_warning(parse->diag, CODE_PROSE, word, "whether the stitches are joined to a round is not said: rows are read as turned at their ends");
    diag_hint(parse->diag, "`Join` behind the cast-on, and they are rounds; `Do not join`, and this is silent");
}

/* Says that rows are not read as a machine's. */
static void warn_of_machine(struct parse *parse)
{
    unsigned behind = (unsigned)parse->facts.machine;

    if (!behind)
        return;
    diag_warning(parse->diag, CODE_PROSE, (struct span){parse->source, behind - (unsigned)strlen("machine"), behind},
                 "rows are read as by hand, where the work is turned; a machine knits all from one side");
    diag_hint(parse->diag, "what `knit 20 rows` makes on a machine is `Work 20 rows in st st`");
}

struct parse parse_read(struct arena *arena, struct diag *diag, struct names *names, const struct source *source)
{
    struct parse parse = {.arena = arena, .diag = diag, .names = names, .source = source};

    if (!is_script(diag, source, source->text + source_start(source)))
        return parse;
    parse.chart = page_chart_find(arena, source);
    parse.text = read_as(&parse);
    return parse;
}

struct stmt *parse_statements(struct parse *parse)
{
    struct scanner scanner = {.parse = parse, .at = source_start(parse->source), .start = TOKEN_START_FILE};

    if (!parse->text)
        return NULL;
    warn_of_loom(parse);
    warn_of_machine(parse);
    warn_of_circle(parse);
    parse->scanner = &scanner;
    scanner_parse(&scanner);
    append_chart(parse);
    return parse->file;
}

struct expr *parse_expression(struct arena *arena, struct diag *diag, struct names *names,
                              const struct source *source, unsigned start)
{
    struct parse parse = {.arena = arena, .diag = diag, .names = names, .source = source, .text = source->text};
    struct scanner scanner = {.parse = &parse, .at = start, .start = TOKEN_START_EXPRESSION};

    parse.scanner = &scanner;
    scanner_parse(&scanner);
    if (!parse.expression)
        parse.expression = expr_bad(&parse, (struct span){source, start, (unsigned)source->size});
    return parse.expression;
}
