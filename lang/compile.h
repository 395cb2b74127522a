/* SPDX-License-Identifier: GPL-3.0-or-later
 * The front end's face: a script and the command line's wishes in, a scene out.
 *
 * What a caller does:
 *
 *     struct arena arena = {0};
 *     struct diag diag;
 *     const char *why;
 *     diag_init(&diag, &arena);
 *     const struct source *source = source_read(&arena, path, &why);
 *     if (!source) { say path and why; exit 4; }
 *     const struct scene *scene = scene_compile(&arena, &diag, source, &options);
 *     diag_print(&diag, stderr, DIAG_HUMAN, color);       // errors and warnings alike
 *     if (!scene) exit 3;
 *     ...
 *     arena_free(&arena);                                 // scene, source and messages go with it
 */
#ifndef WEFT_COMPILE_H
#define WEFT_COMPILE_H

#include <stdbool.h>

#include "lang/arena.h"
#include "lang/diag.h"
#include "lang/scene.h"

/* What the command line sets: -D name=value for a param; for a key of a block
 * its dotted name, "solve.accuracy" = "1%", "mesh.per_stitch" = "2",
 * "K.kx" = "-0.8".  The value is an expression of the language. */
struct compile_override {
    const char *name, *value;
};

/* Reads a chart file that a script uses.  False: it is no chart, but a script.
 * Else *grid is all that it shows, NULL after an error, which is in diag. */
typedef bool compile_chart(struct arena *, struct diag *, const struct source *, const struct grid **grid);

struct compile_options {
    const struct compile_override *define;      /* (ndefines) params */
    int                            ndefines;
    const struct compile_override *set;         /* (nsets) keys of blocks */
    int                            nsets;
    const char *const             *include;     /* (nincludes) folders of -I, before those of WEFT_PATH */
    int                            nincludes;
    const char *const             *output;      /* (noutputs) -o: PATH or KIND:PATH, after the file's own */
    int                            noutputs;
    bool                           warnings_are_errors;
    compile_chart                 *chart;       /* reads `use "x.csv"`; NULL: every file is a script */
    bool                           least_width;     /* rows at the top that say no width are one repeat wide */
    long long                      work;        /* steps and stitches at most; 0: as limits.h has them */
};

/* What a file's name is in messages: "-" is standard input. */
const char *source_called(const char *name);

/* A whole file, or standard input for "-".  NULL when it could not be read;
 * *why then says so ("No such file or directory").  Never a message in diag:
 * this is an input failure, not an error of the script. */
const struct source *source_read(struct arena *, const char *path, const char **why);

/* "a PDF file": what its first bytes say it is, where that is neither a script nor a chart, and what to do then, NULL
 * where nothing helps; or NULL. */
const char *source_other_format(const struct source *, const char **advice);

/* The path of a file that is there and spelt nearly like this one, which is not; or NULL. */
const char *source_nearest(struct arena *, const char *path);

/* A text that is already in memory. */
const struct source *source_from_text(struct arena *, const char *name, const char *text, size_t size);

/* Compiles; NULL when there were errors (also when options say that warnings
 * are errors and there were some).  options may be NULL.  An unknown -D name,
 * a value out of its range, an -o of unknown kind are errors placed at
 * "command line".  What `use` names is looked for in the folder of the file
 * that uses it, the -I folders, those of WEFT_PATH, and the built-in library. */
const struct scene *scene_compile(struct arena *, struct diag *, const struct source *,
                                  const struct compile_options *);

/* The folders of an environment value like WEFT_PATH are read by scene_compile
 * itself; kinds of output by name, for messages and completion. */
const char *output_kind_name(enum output_kind);

/* Shows see the values of an output's block one by one, as they are stored. */
void output_values(const struct output *, void (*see)(void *self, const void *value, size_t size), void *self);

/* The built-in motifs, for `weft list`. */
struct library_motif {
    const char        *name;
    const char        *arguments;   /* "(half = 6)", or "" */
    const char        *about;       /* a line on what it is, then others, '\n' between */
    const char        *file;        /* "std/miura.knit" */
    int                multiple;    /* stitches: a width is multiple * n + plus */
    int                plus;
    int                rows;        /* rows of one repeat */
    const struct grid *grid;        /* one repeat with its edge stitches */
};

/* All of them, in the order of their names; *count says how many. */
const struct library_motif *library_list(struct arena *, int *count);

/* The motifs that a comment in the library gives this name: "moss_us or seed_2x1"; NULL: none. */
const char *library_other_name(struct arena *, const char *name);

#endif
