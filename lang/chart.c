/* SPDX-License-Identifier: GPL-3.0-or-later
 * A chart's lines in, a grid out.  The chart shows the right side and its
 * bottom line is row 1; numbers at the ends of lines must agree with that. */
#include "lang/chart.h"

#include <ctype.h>
#include <stdlib.h>
#include <string.h>

#include "lang/limits.h"

struct key {
    const char *symbol;
    stitch_id stitch;
};

struct reader {
    struct eval *eval;
    struct key *key;
    int nkeys;
    int width; /* of the lines read so far; 0: none */
    int box, box_width;
    struct span first; /* the line that fixed the width */
};

static void add_key(struct reader *reader, const char *symbol, stitch_id stitch)
{
    reader->key[reader->nkeys++] = (struct key){symbol, stitch};
}

/* The stitch a key names: K, P or an own one. */
static bool named_stitch(struct eval *eval, struct module *module, const struct name_at *name, stitch_id *id)
{
    struct binding *binding = binding_target(module_find(module, name->name));

    if (binding && binding->kind == BINDING_STITCH && binding->value.kind == VALUE_STITCH)
        *id = binding->value.stitch;
    else if (strcasecmp(name->name, "k") == 0 || strcasecmp(name->name, "knit") == 0)
        *id = STITCH_K;
    else if (strcasecmp(name->name, "p") == 0 || strcasecmp(name->name, "purl") == 0)
        *id = STITCH_P;
    else {
        diag_error(eval->diag, CODE_STITCH, name->span, "'%s' is no stitch", name->name);
        diag_hint(eval->diag, "stitches are K, P, and your own: `stitch T { kx = .. }`");
        return false;
    }
    return true;
}

static bool given_key(struct reader *reader, struct module *module, const struct symbol *symbol)
{
    for (; symbol; symbol = symbol->next) {
        stitch_id id;

        for (int i = 0; i < reader->nkeys; i++)
            if (strcmp(reader->key[i].symbol, symbol->symbol) == 0) {
                diag_error(reader->eval->diag, CODE_TWICE, symbol->span, "'%s' has a meaning already",
                           symbol->symbol);
                return false;
            }
        if (!named_stitch(reader->eval, module, &symbol->stitch, &id))
            return false;
        add_key(reader, symbol->symbol, id);
    }
    return true;
}

/* Without a key: K and P, and own stitches by their symbols and names. */
static void default_key(struct reader *reader, struct module *module)
{
    static const struct key plain[] = {{"K", STITCH_K}, {"k", STITCH_K}, {"P", STITCH_P}, {"p", STITCH_P}};

    for (struct binding *b = module->first; b; b = b->after) {
        struct binding *stitch = binding_target(b);

        if (!stitch || stitch->kind != BINDING_STITCH || stitch->value.kind != VALUE_STITCH ||
            stitch->value.stitch < 2)
            continue;
        add_key(reader, reader->eval->stitch[stitch->value.stitch].symbol, stitch->value.stitch);
        add_key(reader, b->name, stitch->value.stitch);
    }
    for (size_t i = 0; i < sizeof plain / sizeof *plain; i++)
        add_key(reader, plain[i].symbol, plain[i].stitch);
}

static const struct key *find_key(const struct reader *reader, const char *text, size_t length)
{
    for (int i = 0; i < reader->nkeys; i++)
        if (strlen(reader->key[i].symbol) == length && memcmp(reader->key[i].symbol, text, length) == 0)
            return &reader->key[i];
    return NULL;
}

static size_t character_length(const char *text)
{
    size_t n = 1;

    while (((unsigned char)text[n] & 0xC0) == 0x80)
        n++;
    return n;
}

static struct span part_of(struct span line, const char *text, const char *from, size_t length)
{
    line.start += (unsigned)(from - text);
    line.end = line.start + (unsigned)length;
    return line;
}

static bool unknown_symbol(struct reader *reader, struct span span, const char *symbol, size_t length)
{
    struct arena *arena = reader->eval->arena;
    const char *list = "";

    for (int i = 0; i < reader->nkeys && i < 8; i++)
        list = arena_printf(arena, "%s%s%s", list, i ? " " : "", reader->key[i].symbol);
    diag_error(reader->eval->diag, CODE_CHART, span, "the chart's key does not know '%.*s'", (int)length,
               symbol);
    diag_hint(reader->eval->diag, "it knows %s", list);
    return false;
}

/* A number of digits that are not symbols themselves. */
static bool is_row_number(const struct reader *reader, const char *word, size_t length)
{
    for (size_t i = 0; i < length; i++)
        if (!isdigit((unsigned char)word[i]) || find_key(reader, word + i, 1))
            return false;
    return length > 0;
}

static bool check_row_number(struct reader *reader, struct span span, const char *word, size_t length,
                             int row)
{
    long number = length > 9 ? -1 : strtol(word, NULL, 10);

    if (number == row)
        return true;
    diag_error(reader->eval->diag, CODE_CHART, span, "this is row %d of the chart, not %.*s", row,
               (int)length, word);
    diag_hint(reader->eval->diag, "a chart's bottom line is row 1");
    return false;
}

/* The cells of one word: a symbol of several characters, or one each. */
static int read_word(struct reader *reader, struct span line, const char *text, const char *word,
                     size_t length, stitch_id *cell)
{
    const struct key *key = find_key(reader, word, length);
    int n = 0;

    if (key) {
        *cell = key->stitch;
        return 1;
    }
    for (size_t at = 0; at < length;) {
        size_t size = character_length(word + at);

        key = find_key(reader, word + at, size);
        if (!key) {
            unknown_symbol(reader, part_of(line, text, word + at, size), word + at, size);
            return -1;
        }
        cell[n++] = key->stitch;
        at += size;
    }
    return n;
}

/* A bar opens or closes the box around the repeat. */
static bool read_bar(struct reader *reader, struct span span, int column, int nbars, int box[2])
{
    if (nbars < 2) {
        box[nbars] = column;
        return true;
    }
    diag_error(reader->eval->diag, CODE_CHART, span, "a chart marks one repeat: two bars in a line");
    return false;
}

/* One line's cells; their number, or -1. */
static int read_line(struct reader *reader, const struct name_at *line, int row, stitch_id *cell)
{
    const char *text = line->name, *word = text;
    int n = 0, nbars = 0, box[2] = {0, 0};

    for (word += strspn(word, " \t"); *word; word += strspn(word, " \t")) {
        size_t length = strcspn(word, " \t|");
        struct span span = part_of(line->span, text, word, length ? length : 1);
        bool at_end = n == 0 || !word[length + strspn(word + length, " \t")];
        int got;

        if (!length) {
            if (!read_bar(reader, span, n, nbars++, box))
                return -1;
            word++;
            continue;
        }
        if (at_end && is_row_number(reader, word, length)) {
            if (!check_row_number(reader, span, word, length, row))
                return -1;
            word += length;
            continue;
        }
        got = read_word(reader, line->span, text, word, length, cell + n);
        if (got < 0)
            return -1;
        n += got;
        word += length;
    }

    /* All lines mark the same repeat. */
    if (nbars && (nbars != 2 || box[1] <= box[0] ||
                  (reader->width && (box[0] != reader->box || box[1] - box[0] != reader->box_width)))) {
        diag_error(reader->eval->diag, CODE_CHART, line->span,
                   "the bars of this line do not mark the chart's repeat");
        return -1;
    }
    if (!nbars && reader->box_width) {
        diag_error(reader->eval->diag, CODE_CHART, line->span, "this line lacks the bars around the repeat");
        return -1;
    }
    reader->box = box[0];
    reader->box_width = box[1] - box[0];
    return n;
}

static bool check_width(struct reader *reader, const struct name_at *line, int n)
{
    struct diag *diag = reader->eval->diag;

    if (!reader->width) {
        reader->width = n;
        reader->first = line->span;
    }
    if (n == reader->width && n)
        return true;
    if (n)
        diag_error(diag, CODE_CHART, line->span, "this line has %d stitches, the one below it %d", n,
                   reader->width);
    else
        diag_error(diag, CODE_CHART, line->span, "this line has no stitch");
    return false;
}

static int count_lines(const struct name_at *line, size_t *longest)
{
    int n = 0;

    for (*longest = 0; line; line = line->next, n++)
        if (strlen(line->name) > *longest)
            *longest = strlen(line->name);
    return n;
}

const struct grid *chart_read(struct eval *eval, struct module *module, const struct stmt *stmt, int *box,
                              int *box_width)
{
    struct reader reader = {.eval = eval};
    size_t longest;
    int nlines = count_lines(stmt->chart.line, &longest), row = nlines;
    const struct name_at **lines = arena_array(eval->arena, const struct name_at *, (size_t)nlines + 1);
    stitch_id *cell = arena_array(eval->arena, stitch_id, longest + 1), *all = NULL;
    struct grid *grid = NULL;
    int nsymbols = 0;

    for (const struct symbol *s = stmt->chart.symbol; s; s = s->next)
        nsymbols++;
    reader.key = arena_array(eval->arena, struct key, (size_t)nsymbols + 2 * (size_t)eval->nstitches + 8);
    if (!nlines) {
        diag_error(eval->diag, CODE_EMPTY_MOTIF, stmt->span, "the chart has no line");
        return NULL;
    }
    if (!given_key(&reader, module, stmt->chart.symbol))
        return NULL;
    if (!reader.nkeys)
        default_key(&reader, module);

    /* From the bottom up. */
    for (const struct name_at *line = stmt->chart.line; line; line = line->next)
        lines[--row] = line;
    for (row = 0; row < nlines; row++) {
        int n = read_line(&reader, lines[row], row + 1, cell);

        if (n < 0 || !check_width(&reader, lines[row], n))
            return NULL;
        if (!grid) {
            if (!fabric_size(eval, stmt->span, n, nlines))
                return NULL;
            grid = grid_new(eval->arena, n, nlines, &all);
        }
        memcpy(all + (size_t)row * (size_t)n, cell, (size_t)n);
    }
    *box = reader.box;
    *box_width = reader.box_width;
    return grid;
}
