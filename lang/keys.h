/* SPDX-License-Identifier: GPL-3.0-or-later
 * Keys of blocks: one row of a table says what a key may be; its expression
 * in, a checked value out, stored where the row says. */
#ifndef WEFT_KEYS_H
#define WEFT_KEYS_H

#include "lang/eval.h"

enum key_type {
    KEY_NUMBER,
    KEY_WHOLE,
    KEY_SEED,       /* a whole number kept in 64 bits */
    KEY_WORD,
    KEY_SWITCH,     /* one of two words: false or true */
    KEY_EDGES,      /* all, none or a list of sides */
    KEY_PER_STITCH, /* auto or a power of two */
    KEY_TEXT,       /* anything in quotes */
    KEY_ANGLES      /* a word, or two angles in degrees */
};

struct key {
    const char        *block, *name, *unit;
    enum key_type      type;
    int                dimension;   /* numbers: 1 for a length */
    double             low, high;   /* numbers: allowed values, both included, */
    bool               above_low;   /* unless low itself is not */
    double             number;      /* the default */
    const char        *word;        /* words: the default, */
    const char *const *words;       /* and all of them, in the order of their enum */
    size_t             offset;      /* in what key_store fills: int, double, bool, uint64_t, unsigned or const char * by type */
    const double     (*angles)[2];  /* what each word stands for: double[2] at offset */
};

struct key_value {
    double      number[2];          /* words: the index of the one chosen; else one number, or two angles */
    const char *text;               /* words: the one chosen; texts; else NULL */
};

extern const char *const key_edges[];

struct key_value key_default(const struct key *);

/* The value an expression gives a key; false: the error is in diag. */
bool key_read(struct eval *, struct where, const struct key *, const struct expr *, struct key_value *);

/* Puts a value into its place in a structure. */
void key_store(const struct key *, const struct key_value *, void *structure);

/* Bytes of it there. */
size_t key_size(const struct key *);

#endif
