/* SPDX-License-Identifier: GPL-3.0-or-later
 * Instructions for a knitting machine in, the pattern they knit out. */
#include "charts/knitout.h"

#include <stdlib.h>
#include <string.h>

#include "charts/beds.h"
#include "charts/lines.h"
#include "lang/names.h"

#define MAGIC ";!knitout-"
enum { VERSION = 2, WORDS = 16, CARRIERS = 64, EXTENSIONS = 16 };

struct reader {
    struct arena *arena;
    struct diag  *diag;
    struct beds  *beds;
    struct span   carrier[CARRIERS];    /* (ncarriers) as the header names them */
    int           ncarriers;
    bool          in[CARRIERS];         /* in action */
    struct span   yarn;                 /* the one that knits; no source: none yet */
    struct extension {
        struct span name;               /* where it stands first */
        int         lines;
    } extension[EXTENSIONS];            /* (nextensions) `x-..`, for one machine alone */
    int           nextensions;
};

/* An operation: its first words, and how many there are. */
struct line {
    struct span whole, word[WORDS];
    int         nwords;
};

/* ---- words ---- */

static const char *start(struct span span)
{
    return span.source->text + span.start;
}

static int length(struct span span)
{
    return (int)(span.end - span.start);
}

static bool is(struct span word, const char *text)
{
    return (size_t)length(word) == strlen(text) && memcmp(start(word), text, strlen(text)) == 0;
}

static bool same(struct span a, struct span b)
{
    return length(a) == length(b) && memcmp(start(a), start(b), (size_t)length(a)) == 0;
}

static bool next_word(struct span *rest, struct span *word)
{
    const char *text = rest->source->text;
    while (rest->start < rest->end && lines_is_blank(text[rest->start]))
        rest->start++;
    *word = *rest;
    for (word->end = word->start; word->end < rest->end && !lines_is_blank(text[word->end]);)
        word->end++;
    rest->start = word->end;
    return word->end > word->start;
}

/* A copy for messages, cut where it is no word any more. */
static const char *shown(struct reader *r, struct span word)
{
    return raster_mark(r->arena, length(word) > 40 ? (struct span){word.source, word.start, word.start + 40} : word);
}

static void wrong(struct reader *r, struct span span, const char *text)
{
    diag_error(r->diag, CODE_KNITOUT, span, "%s", text);
}

/* A whole number with a sign or not, that the word is no longer than. */
static bool whole_number(struct span word, int *n)
{
    char digits[16] = "", *end;
    if (length(word) < 1 || length(word) >= (int)sizeof digits || strchr(" +", *start(word)))
        return false;
    memcpy(digits, start(word), (size_t)length(word));
    long value = strtol(digits, &end, 10);
    *n = (int)value;
    return !*end && value >= -NEEDLE_MOST && value <= NEEDLE_MOST;
}

/* `f12`, `b-3` */
static bool needle(struct reader *r, struct span word, struct needle *n)
{
    char bed = length(word) ? *start(word) : 0;
    *n = (struct needle){bed == 'b' ? BED_BACK : BED_FRONT, 0, word};
    if (length(word) > 2 && strchr("fb", bed) && start(word)[1] == 's') {
        diag_error(r->diag, CODE_NOT_PLAIN, word, "sliders are not needed for plain knit and purl");
        return false;
    }
    if (bed && strchr("fb", bed) && whole_number((struct span){word.source, word.start + 1, word.end}, &n->number))
        return true;
    diag_error(r->diag, CODE_KNITOUT, word, "a needle is wanted here: f or b and its number, to %d", NEEDLE_MOST);
    return false;
}

static bool direction(struct reader *r, struct span word, int *sign)
{
    *sign = is(word, "+") ? 1 : -1;
    if (is(word, "+") || is(word, "-"))
        return true;
    wrong(r, word, "a direction is wanted here: + (to the right) or - (to the left)");
    return false;
}

/* ---- carriers ---- */

static int find_carrier(struct reader *r, struct span word)
{
    for (int i = 0; i < r->ncarriers; i++)
        if (same(r->carrier[i], word))
            return i;
    diag_error(r->diag, CODE_KNITOUT, word, "the header does not name a carrier %s", shown(r, word));
    return -1;
}

/* The one carrier behind `words` words: 1, or 0 for none; -1 after an error. */
static int yarn(struct reader *r, const struct line *line, int words)
{
    if (line->nwords <= words)
        return 0;
    struct span name = line->word[words];
    if (line->nwords > words + 1) {
        diag_error(r->diag, CODE_NOT_PLAIN, span_join(name, line->whole), "several carriers in one stitch are several colours");
        return -1;
    }
    int carrier = find_carrier(r, name);
    if (carrier < 0)
        return -1;
    if (!r->in[carrier])
        diag_error(r->diag, CODE_KNITOUT, name, "the carrier %s was not brought in", shown(r, name));
    else if (r->yarn.source && !same(r->yarn, name))
        diag_error(r->diag, CODE_NOT_PLAIN, name, "a second carrier, %s: another yarn is another colour", shown(r, name));
    else
        r->yarn = name;
    return same(r->yarn, name) ? 1 : -1;
}

/* ---- operations ---- */

enum carriage { TUCK, KNIT, SPLIT, DROP, TRANSFER, RACK, COME, GO, NOTHING };

static void come_or_go(struct reader *r, const struct line *line, bool come)
{
    for (int i = 1; i < line->nwords; i++) {
        int carrier = i < WORDS ? find_carrier(r, line->word[i]) : -1;
        if (carrier >= 0 && r->in[carrier] == come)
            diag_error(r->diag, CODE_KNITOUT, line->word[i], "the carrier %s is %s already", shown(r, line->word[i]),
                       come ? "in" : "out");
        if (carrier >= 0)
            r->in[carrier] = come;
    }
}

static void rack(struct reader *r, const struct line *line)
{
    char digits[16] = "", *end;
    int n = length(line->word[1]);
    if (n > 0 && n < (int)sizeof digits)
        memcpy(digits, start(line->word[1]), (size_t)n);
    double value = strtod(digits, &end);
    if (end == digits || *end || !(value > -1000 && value < 1000))
        wrong(r, line->word[1], "a racking is a number of needles");
    else
        beds_rack(r->beds, value);
}

/* `tuck - f3 1` and `knit - f3 1`; without a carrier a knit drops and a tuck does nothing. */
static void loop(struct reader *r, const struct line *line, enum carriage carriage)
{
    struct needle n;
    int sign, carriers;
    if (!direction(r, line->word[1], &sign) || !needle(r, line->word[2], &n) || (carriers = yarn(r, line, 3)) < 0)
        return;
    if (carriage == KNIT && carriers)
        beds_knit(r->beds, sign, n, line->whole);
    else if (carriage == KNIT)
        beds_drop(r->beds, n, line->whole);
    else if (carriers)
        beds_tuck(r->beds, n, line->whole);
}

/* `split - f3 b3 1`; without a carrier it transfers. */
static void split(struct reader *r, const struct line *line)
{
    struct needle n, to;
    int sign;
    if (!direction(r, line->word[1], &sign) || !needle(r, line->word[2], &n) || !needle(r, line->word[3], &to))
        return;
    if (line->nwords > 4)
        beds_split(r->beds, n, to, line->whole);
    else
        beds_transfer(r->beds, n, to, line->whole);
}

static void drop(struct reader *r, const struct line *line)
{
    struct needle n;
    if (needle(r, line->word[1], &n))
        beds_drop(r->beds, n, line->whole);
}

static void transfer(struct reader *r, const struct line *line)
{
    struct needle n, to;
    if (needle(r, line->word[1], &n) && needle(r, line->word[2], &to))
        beds_transfer(r->beds, n, to, line->whole);
}

/* What there is, with the fewest and the most words. */
static const struct opcode {
    const char   *name;
    int           least, most;
    enum carriage does;
} opcodes[] = {
    {"knit", 3, 1000, KNIT},      {"tuck", 3, 1000, TUCK},     {"split", 4, 1000, SPLIT}, {"xfer", 3, 3, TRANSFER},
    {"drop", 2, 2, DROP},         {"rack", 2, 2, RACK},        {"in", 2, 1000, COME},     {"inhook", 2, 1000, COME},
    {"out", 2, 1000, GO},         {"outhook", 2, 1000, GO},    {"miss", 3, 1000, NOTHING}, {"amiss", 2, 2, NOTHING},
    {"releasehook", 2, 1000, NOTHING}, {"stitch", 3, 3, NOTHING}, {"pause", 1, 1000, NOTHING},
};
enum { NOPCODES = sizeof opcodes / sizeof *opcodes };

static const struct opcode *find_opcode(struct reader *r, struct span word)
{
    struct nearest nearest = nearest_to(arena_copy(r->arena, start(word), length(word) < 20 ? (size_t)length(word) : 20));
    for (const struct opcode *o = opcodes; o < opcodes + NOPCODES; o++) {
        if (is(word, o->name))
            return o;
        nearest_offer(&nearest, o->name);
    }
    diag_error(r->diag, CODE_KNITOUT, word, "%s is no operation of knitout", shown(r, word));
    diag_did_you_mean(r->diag, nearest.best);
    return NULL;
}

static void work(struct reader *r, const struct line *line, enum carriage does)
{
    switch (does) {
    case TUCK:
    case KNIT:     loop(r, line, does); break;
    case SPLIT:    split(r, line); break;
    case DROP:     drop(r, line); break;
    case TRANSFER: transfer(r, line); break;
    case RACK:     rack(r, line); break;
    case COME:
    case GO:       come_or_go(r, line, does == COME); break;
    case NOTHING:  break;
    }
}

/* ---- lines ---- */

static struct line split_line(struct span span)
{
    struct line line = {.whole = span};
    const char *comment = memchr(start(span), ';', (size_t)length(span));
    if (comment)
        line.whole.end = span.start + (unsigned)(comment - start(span));
    struct span rest = line.whole, word;
    for (line.whole.end = line.whole.start; next_word(&rest, &word); line.whole.end = word.end)
        if (line.nwords++ < WORDS)
            line.word[line.nwords - 1] = word;
    return line;
}

/* `x-speed-number 100`: what it does is between its writer and a machine. */
static void skip_extension(struct reader *r, struct span name)
{
    int i = 0;
    while (i < r->nextensions && !same(r->extension[i].name, name))
        i++;
    if (i < EXTENSIONS && i == r->nextensions)
        r->extension[r->nextensions++] = (struct extension){.name = name};
    if (i < EXTENSIONS)
        r->extension[i].lines++;
}

static void warn_extensions(struct reader *r)
{
    for (const struct extension *e = r->extension; e < r->extension + r->nextensions; e++) {
        diag_warning(r->diag, CODE_KNITOUT_EXTENSION, e->name, "the extension %s is not read", shown(r, e->name));
        if (e->lines > 1)
            diag_note(r->diag, (struct span){0}, "it stands on %d lines", e->lines);
    }
}

static void read_operation(struct reader *r, struct span span)
{
    struct line line = split_line(span);
    if (!line.nwords)
        return;
    if (length(line.word[0]) > 2 && memcmp(start(line.word[0]), "x-", 2) == 0) {
        skip_extension(r, line.word[0]);
        return;
    }
    const struct opcode *opcode = find_opcode(r, line.word[0]);
    if (!opcode)
        return;
    if (line.nwords < opcode->least || line.nwords > opcode->most)
        diag_error(r->diag, CODE_KNITOUT, line.whole, "%s has too %s words behind it", opcode->name,
                   line.nwords < opcode->least ? "few" : "many");
    else if (!r->ncarriers)
        diag_error(r->diag, CODE_CHART_HEADER, line.whole, "the header `;;Carriers: ..` is missing above this");
    else
        work(r, &line, opcode->does);
}

/* `;;Carriers: 1 2 3`; other headers say nothing about the stitches. */
static void read_header(struct reader *r, struct span line)
{
    static const char name[] = ";;Carriers: ";
    int n = (int)strlen(name);
    if (!memchr(start(line), ':', (size_t)length(line)))
        diag_error(r->diag, CODE_CHART_HEADER, line, "a header is a name, a colon and a value: `;;Carriers: 1 2 3`");
    if (length(line) < n || memcmp(start(line), name, (size_t)n) != 0)
        return;
    struct span rest = {line.source, line.start + (unsigned)n, line.end}, word;
    while (r->ncarriers < CARRIERS && next_word(&rest, &word))
        r->carrier[r->ncarriers++] = word;
}

bool knitout_is(const struct source *source)
{
    struct lines lines = lines_of(source);
    return source->size - lines.at >= strlen(MAGIC) && memcmp(source->text + lines.at, MAGIC, strlen(MAGIC)) == 0;
}

static bool read_version(struct reader *r, struct span line)
{
    int version = 0;
    struct span number = {line.source, line.start + (unsigned)strlen(MAGIC), line.end};
    if (!knitout_is(line.source) || !whole_number(number, &version) || version < 1)
        wrong(r, line, "a knitout file begins with the line `;!knitout-2`");
    else if (version > VERSION)
        diag_warning(r->diag, CODE_KNITOUT_NEWER, line, "this weft knows knitout %d, not %d; it is read as %d", VERSION, version,
                     VERSION);
    return !r->diag->nerrors;
}

struct pattern knitout_read(struct arena *arena, struct diag *diag, const struct source *source)
{
    struct pattern pattern = {.across = 1, .up = 1};
    struct reader r = {.arena = arena, .diag = diag, .beds = beds_new(arena, diag)};
    struct lines lines = lines_of(source);
    struct span line = {source, 0, 0};
    bool header = true;
    if (!lines_next(&lines, &line) || !read_version(&r, line)) {
        if (!diag->nerrors)
            wrong(&r, line, "a knitout file begins with the line `;!knitout-2`");
        return pattern;
    }

    /* A wrong line would make the ones behind it wrong, too. */
    while (!diag->nerrors && lines_next(&lines, &line)) {
        bool comment = !length(line) || *start(line) == ';';
        if (header && length(line) > 1 && memcmp(start(line), ";;", 2) == 0)
            read_header(&r, line);
        else if (!comment)
            read_operation(&r, line);
        header &= comment;
    }
    warn_extensions(&r);
    pattern.grid = beds_fabric(r.beds, source, &pattern.remark);
    return pattern;
}
