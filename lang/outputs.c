/* SPDX-License-Identifier: GPL-3.0-or-later
 * `output` statements and -o options in, the scene's list of files out. */
#include "lang/outputs.h"

#include <stddef.h>
#include <stdlib.h>
#include <string.h>
#include <strings.h>

#include "lang/keys.h"
#include "lang/limits.h"

/* What each kind is called, and the extensions it may have. */
static const struct kind {
    const char *name;
    const char *extension[6];
} kinds[OUTPUT_KINDS] = {
    [OUTPUT_REPORT] = {"report", {"json"}},
    [OUTPUT_CHART] = {"chart", {"txt", "svg", "pdf", "png", "csv", "k"}},
    [OUTPUT_PIXELS] = {"pixels", {"png"}},
    [OUTPUT_PICTURE] = {"picture", {"png", "svg", "pdf"}},
    [OUTPUT_PLOT] = {"plot", {"svg", "pdf", "png"}},
    [OUTPUT_TABLE] = {"table", {"csv"}},
    [OUTPUT_PVD] = {"pvd", {"pvd"}},
    [OUTPUT_VTP] = {"vtp", {"vtp"}},
    [OUTPUT_OBJ] = {"obj", {"obj"}},
    [OUTPUT_PLY] = {"ply", {"ply"}},
    [OUTPUT_STL] = {"stl", {"stl"}},
    [OUTPUT_GLB] = {"glb", {"glb"}},
    [OUTPUT_HTML] = {"html", {"html"}},
    [OUTPUT_STATE] = {"state", {"state"}},
};

/* The kind of an extension that says nothing else. */
static const struct {
    const char *extension;
    enum output_kind kind;
} by_extension[] = {
    {"json", OUTPUT_REPORT}, {"txt", OUTPUT_CHART},   {"k", OUTPUT_CHART},     {"csv", OUTPUT_TABLE},
    {"svg", OUTPUT_PICTURE}, {"png", OUTPUT_PICTURE}, {"pdf", OUTPUT_PICTURE}, {"pvd", OUTPUT_PVD},
    {"vtp", OUTPUT_VTP},     {"obj", OUTPUT_OBJ},     {"ply", OUTPUT_PLY},     {"stl", OUTPUT_STL},
    {"glb", OUTPUT_GLB},     {"html", OUTPUT_HTML},   {"state", OUTPUT_STATE},
};

const char *output_kind_name(enum output_kind kind)
{
    return kinds[kind].name;
}

static const char *extension_of(const char *path)
{
    const char *slash = strrchr(path, '/'), *dot = strrchr(slash ? slash : path, '.');

    return dot && dot[1] && dot != (slash ? slash + 1 : path) ? dot + 1 : "";
}

static bool kind_of_name(const char *name, enum output_kind *kind)
{
    for (int i = 0; i < OUTPUT_KINDS; i++)
        if (strcmp(kinds[i].name, name) == 0) {
            *kind = (enum output_kind)i;
            return true;
        }
    return false;
}

static bool kind_of_extension(struct eval *eval, struct span span, const char *path, enum output_kind *kind)
{
    const char *extension = extension_of(path);
    struct nearest nearest = nearest_to(extension);

    for (size_t i = 0; i < sizeof by_extension / sizeof *by_extension; i++) {
        nearest_offer(&nearest, by_extension[i].extension);
        if (strcasecmp(by_extension[i].extension, extension) == 0) {
            *kind = by_extension[i].kind;
            return true;
        }
    }
    if (*extension)
        diag_error(eval->diag, CODE_OUTPUT, span, "'.%s' is no kind of output", extension);
    else
        diag_error(eval->diag, CODE_OUTPUT, span, "'%s' has no extension that says what it is", path);
    if (*extension && nearest.best)
        diag_hint(eval->diag, "did you mean '.%s'?", nearest.best);
    diag_hint(eval->diag,
              "surfaces: .pvd .vtp .obj .ply .stl .glb; others: .json .csv .txt .svg .png .pdf .html .state");
    return false;
}

static void unknown_kind(struct eval *eval, struct span span, const char *name)
{
    struct nearest nearest = nearest_to(name);

    for (int i = 0; i < OUTPUT_KINDS; i++)
        nearest_offer(&nearest, kinds[i].name);
    diag_error(eval->diag, CODE_OUTPUT, span, "'%s' is no kind of output", name);
    diag_did_you_mean(eval->diag, nearest.best);
}

/* A named kind and the extension must go together. */
static bool fits_extension(struct eval *eval, enum output_kind kind, struct span span, const char *path)
{
    const char *extension = extension_of(path), *list = "";

    for (size_t i = 0; i < sizeof kinds->extension / sizeof *kinds->extension && kinds[kind].extension[i];
         i++) {
        if (strcasecmp(kinds[kind].extension[i], extension) == 0)
            return true;
        list = arena_printf(eval->arena, "%s%s.%s", list, i ? ", " : "", kinds[kind].extension[i]);
    }
    diag_error(eval->diag, CODE_OUTPUT, span, "a %s cannot be written as '%s'", kinds[kind].name, path);
    diag_hint(eval->diag, "its extension is one of: %s", list);
    return false;
}

/* ---- paths ---- */

/* A param's value as part of a file's name. */
static const char *value_text(struct eval *eval, struct value value)
{
    return value.kind == VALUE_STRING ? value.text : arena_number(eval->arena, value.number);
}

static const char *param_text(struct eval *eval, const char *name, size_t length, struct span span)
{
    struct nearest nearest;
    struct binding *binding = module_find(eval->main, names_intern(eval->names, name, length));
    const char *word = arena_copy(eval->arena, name, length);

    if (binding && binding->kind == BINDING_PARAM) {
        struct value value = eval_binding(eval, binding, span);

        return value.kind == VALUE_BAD ? NULL : value_text(eval, value);
    }
    nearest = nearest_to(word);
    for (const struct binding *b = eval->main->first; b; b = b->after)
        if (b->kind == BINDING_PARAM)
            nearest_offer(&nearest, b->name);
    diag_error(eval->diag, CODE_UNKNOWN_NAME, span, "there is no param '%s' for {%s}", word, word);
    diag_did_you_mean(eval->diag, nearest.best);
    return NULL;
}

/* "{n}" becomes the value of param n. */
static const char *fill_in(struct eval *eval, const char *path, struct span span)
{
    const char *done = "", *open, *close;

    for (; (open = strchr(path, '{')) != NULL; path = close + 1) {
        const char *text;

        close = strchr(open, '}');
        if (!close) {
            diag_error(eval->diag, CODE_OUTPUT, span, "a '{' in a path is closed by '}': {name of a param}");
            return NULL;
        }
        text = param_text(eval, open + 1, (size_t)(close - open - 1), span);
        if (!text)
            return NULL;
        done = arena_printf(eval->arena, "%s%.*s%s", done, (int)(open - path), path, text);
    }
    return arena_printf(eval->arena, "%s%s", done, path);
}

/* ---- the list ---- */

static void add(struct eval *eval, struct outputs *outputs, struct span span, struct output output)
{
    if (!*output.path || output.path[strlen(output.path) - 1] == '/') {
        diag_error(eval->diag, CODE_OUTPUT, span, "an output needs a file name");
        return;
    }
    for (int i = 0; i < outputs->n; i++) {
        if (strcmp(outputs->output[i].path, output.path) != 0)
            continue;
        if (span.source->command_line && outputs->output[i].kind == output.kind)
            return;
        diag_error(eval->diag, CODE_TWICE, span, "'%s' is written twice", output.path);
        return;
    }
    if (outputs->n == LIMIT_OUTPUTS) {
        diag_error(eval->diag, CODE_LIMIT_OUTPUTS, span, "a run writes %d files at most", LIMIT_OUTPUTS);
        return;
    }
    if (!outputs->output)
        outputs->output = arena_array(eval->arena, struct output, LIMIT_OUTPUTS);
    outputs->output[outputs->n++] = output;
}

/* ---- keys ---- */

#define OF(kind) (1u << OUTPUT_##kind)
#define DRAWN_CHART (1u << OUTPUT_KINDS)     /* a chart as a drawing, not as text */
#define SWEEP_PLOT (2u << OUTPUT_KINDS)      /* a plot in a script with a sweep */
#define SURFACES (OF(PVD) | OF(VTP) | OF(OBJ) | OF(PLY) | OF(STL) | OF(GLB))
#define AT(field) offsetof(struct output, field)
#define WORDS(kind, first, all) .type = kind, .word = first, .words = all

static const char *const formats[] = {"binary", "ascii", NULL};
static const char *const views[] = {"iso", "top", "front", "side", NULL};
static const double view_angles[][2] = {{30, 40}, {0, 90}, {0, 0}, {90, 0}};
static const char *const lights[] = {"left", "right", "eye", NULL};
static const double light_angles[][2] = {{-40, 40}, {40, 40}, {0, 0}};
static const char *const colors[] = {"stitch", "height", "mean", "gauss", "bending", "stretching", NULL};
static const char *const palettes[] = {"paper", "safe", NULL};
static const char *const purls[] = {"dot", "dash", NULL};
static const char *const switches[] = {"off", "on", NULL};
static const char *const shows[] = {"energy", "convergence", NULL};
static const char *const forms[] = {"auto", "curves", "map", NULL};
static const char *const scales[] = {"auto", "linear", "log", NULL};
static const char *const backgrounds[] = {"white", "transparent", NULL};

/* What the block of an output may hold, and the kinds that take it. */
static const struct output_key {
    unsigned kinds;
    struct key key;
} output_keys[] = {
    {SURFACES | OF(PICTURE) | OF(HTML), {.name = "per_stitch", .type = KEY_WHOLE, .low = 1, .high = 64, .offset = AT(per_stitch)}},
    {OF(PVD) | OF(VTP), {.name = "format", WORDS(KEY_WORD, "binary", formats), .offset = AT(format)}},
    {OF(PICTURE), {.name = "view", WORDS(KEY_ANGLES, "iso", views), .angles = view_angles, .offset = AT(picture.view)}},
    {OF(PICTURE), {.name = "light", WORDS(KEY_ANGLES, "left", lights), .angles = light_angles, .offset = AT(picture.light)}},
    {OF(PICTURE), {.name = "width", .type = KEY_WHOLE, .low = 16, .high = 10000, .number = 800, .offset = AT(picture.width)}},
    {OF(PICTURE), {.name = "color", WORDS(KEY_WORD, "stitch", colors), .offset = AT(picture.color)}},
    {OF(PICTURE), {.name = "palette", WORDS(KEY_WORD, "paper", palettes), .offset = AT(picture.palette)}},
    {OF(PICTURE), {.name = "edges", WORDS(KEY_SWITCH, "off", switches), .offset = AT(picture.edges)}},
    {OF(PICTURE), {.name = "background", WORDS(KEY_SWITCH, "white", backgrounds), .offset = AT(picture.transparent)}},
    {OF(PICTURE), {.name = "chart", WORDS(KEY_SWITCH, "off", switches), .offset = AT(picture.chart)}},
    {OF(PLOT), {.name = "show", WORDS(KEY_WORD, "energy", shows), .offset = AT(graph.show)}},
    {SWEEP_PLOT, {.name = "field", .type = KEY_TEXT, .word = "energy.total", .offset = AT(graph.field)}},
    {SWEEP_PLOT, {.name = "kind", WORDS(KEY_WORD, "auto", forms), .offset = AT(graph.form)}},
    {OF(PLOT) | SWEEP_PLOT, {.name = "scale", WORDS(KEY_WORD, "auto", scales), .offset = AT(graph.scale)}},
    {OF(PLOT) | SWEEP_PLOT, {.name = "width", .type = KEY_WHOLE, .low = 100, .high = 10000, .number = 640, .offset = AT(graph.width)}},
    {DRAWN_CHART, {.name = "symbols", WORDS(KEY_WORD, "dot", purls), .offset = AT(chart.symbols)}},
    {DRAWN_CHART, {.name = "color", WORDS(KEY_SWITCH, "off", switches), .offset = AT(chart.color)}},
    {DRAWN_CHART, {.name = "palette", WORDS(KEY_WORD, "paper", palettes), .offset = AT(chart.palette)}},
};
enum { KEYS = sizeof output_keys / sizeof *output_keys };

/* The bit an output has in `kinds`. */
static unsigned bit_of(const struct output *output, bool sweep)
{
    static const char *const drawn[] = {"svg", "pdf", "png"};

    for (int i = 0; output->kind == OUTPUT_CHART && i < 3; i++)
        if (strcasecmp(extension_of(output->path), drawn[i]) == 0)
            return DRAWN_CHART;
    return sweep && output->kind == OUTPUT_PLOT ? SWEEP_PLOT : 1u << output->kind;
}

static const struct output_key *find_key(const char *name, unsigned bit)
{
    for (const struct output_key *k = output_keys; k < output_keys + KEYS; k++)
        if ((k->kinds & bit) && strcmp(k->key.name, name) == 0)
            return k;
    return NULL;
}

static void set_defaults(struct output *output)
{
    for (const struct output_key *k = output_keys; k < output_keys + KEYS; k++) {
        struct key_value value = key_default(&k->key);

        key_store(&k->key, &value, output);
    }
}

void output_values(const struct output *output, void (*see)(void *self, const void *value, size_t size), void *self)
{
    unsigned bits = bit_of(output, false) | bit_of(output, true);

    for (const struct output_key *k = output_keys; k < output_keys + KEYS; k++)
        if (k->kinds & bits) {
            const void *at = (const char *)output + k->key.offset;
            const char *text = k->key.type == KEY_TEXT ? *(const char *const *)at : NULL;

            see(self, text ? text : at, text ? strlen(text) + 1 : key_size(&k->key));
        }
}

/* The kind of output that has a key; NULL: none. */
static const char *kind_with(const char *key)
{
    const struct output_key *k = find_key(key, ~0u);
    int kind = 0;

    if (!k || k->kinds & (DRAWN_CHART | SWEEP_PLOT))
        return !k ? NULL : kinds[k->kinds & DRAWN_CHART ? OUTPUT_CHART : OUTPUT_PLOT].name;
    while (!(k->kinds & 1u << kind))
        kind++;
    return kinds[kind].name;
}

/* A key that no output has, or not this kind. */
static void wrong_key(struct eval *eval, const struct pair *pair, const struct output *output, unsigned bit)
{
    const char *name = kinds[output->kind].name, *list = "";
    const char *of = bit == SWEEP_PLOT ? " of a sweep" : bit == OF(PLOT) ? " of a run" : "";
    const char *other = kind_with(pair->key);
    bool elsewhere = *of && find_key(pair->key, OF(PLOT) | SWEEP_PLOT);
    struct nearest nearest = nearest_to(pair->key);

    for (const struct output_key *k = output_keys; k < output_keys + KEYS; k++)
        if (k->kinds & bit) {
            nearest_offer(&nearest, k->key.name);
            list = arena_printf(eval->arena, "%s%s%s", list, *list ? ", " : "", k->key.name);
        }
    diag_error(eval->diag, CODE_UNKNOWN_KEY, pair->key_span, "output %s%s has no key '%s'", name, of,
               pair->key);
    if (elsewhere)
        diag_hint(eval->diag, "it is a key where the script has %s sweep", bit == SWEEP_PLOT ? "no" : "a");
    else
        diag_did_you_mean(eval->diag, nearest.best);
    if (!elsewhere && !nearest.best && other && strcmp(other, name) != 0)
        diag_hint(eval->diag, "'%s' is a key of %s: `output %s \"..\"`", pair->key, other, other);
    if ((elsewhere || !nearest.best) && *list)
        diag_hint(eval->diag, "its keys are %s", list);
    if (!*list && output->kind == OUTPUT_CHART)
        diag_hint(eval->diag, "only a chart that is drawn has keys: .svg, .pdf, .png");
}

static bool read_pairs(struct eval *eval, const struct pair *first, struct output *output, bool sweep)
{
    unsigned bit = bit_of(output, sweep);

    for (const struct pair *pair = first; pair; pair = pair->next) {
        const struct output_key *k = find_key(pair->key, bit);
        struct key_value value;

        if (!k) {
            wrong_key(eval, pair, output, bit);
            return false;
        }
        for (const struct pair *earlier = first; earlier != pair; earlier = earlier->next)
            if (strcmp(earlier->key, pair->key) == 0) {
                diag_error(eval->diag, CODE_TWICE, pair->key_span, "'%s' is given twice", pair->key);
                return false;
            }
        if (!key_read(eval, (struct where){eval->main, NULL}, &k->key, pair->value, &value))
            return false;
        key_store(&k->key, &value, output);
    }
    return true;
}

void outputs_statement(struct eval *eval, struct outputs *outputs, const struct stmt *stmt)
{
    struct span span = stmt->output.path_span;
    const char *kind = stmt->output.kind.name;
    struct output output = {.path = fill_in(eval, stmt->output.path, span)};
    int before = outputs->n;

    set_defaults(&output);
    if (!output.path)
        return;
    if (kind && !kind_of_name(kind, &output.kind)) {
        unknown_kind(eval, stmt->output.kind.span, kind);
        return;
    }
    if (kind ? !fits_extension(eval, output.kind, span, output.path)
             : !kind_of_extension(eval, span, output.path, &output.kind))
        return;
    if (read_pairs(eval, stmt->output.pair, &output, outputs->sweep))
        add(eval, outputs, span, output);
    if (outputs->n > before)
        outputs->output[before].line = diag_place(stmt->span).line;
}

/* PATH or KIND:PATH; a colon behind something that is no word is part of the path. */
void outputs_option(struct eval *eval, struct outputs *outputs, const struct source *source)
{
    const char *text = source->text, *colon = strchr(text, ':');
    size_t length = strspn(text, "abcdefghijklmnopqrstuvwxyz");
    struct output output = {.path = text};
    struct span span = {source, 0, (unsigned)source->size};

    set_defaults(&output);
    if (colon && length && colon == text + length) {
        output.path = colon + 1;
        if (!kind_of_name(arena_copy(eval->arena, text, length), &output.kind)) {
            unknown_kind(eval, (struct span){source, 0, (unsigned)length},
                         arena_copy(eval->arena, text, length));
            return;
        }
        if (!fits_extension(eval, output.kind, span, output.path))
            return;
    } else if (!kind_of_extension(eval, span, text, &output.kind)) {
        return;
    }
    output.path = fill_in(eval, output.path, span);
    if (output.path)
        add(eval, outputs, span, output);
}
