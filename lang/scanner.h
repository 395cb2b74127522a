/* SPDX-License-Identifier: GPL-3.0-or-later
 * What the scanner remembers between characters, and the parts of its work
 * that are ordinary C. */
#ifndef WEFT_SCANNER_H
#define WEFT_SCANNER_H

#include "lang/limits.h"
#include "lang/parse.h"
#include "lang/parser.h"
#include "lang/page/starred.h"
#include "lang/page/words.h"

enum bracket {
    BRACKET_ROUND,
    BRACKET_SQUARE,
    BRACKET_STATEMENTS,     /* { of a motif, a loop, an if */
    BRACKET_SETTINGS,       /* { of a block of keys */
    BRACKET_HOLE,           /* { of a number in a row */
    BRACKET_CHART,
    BRACKET_TOO_DEEP
};

struct open {
    enum bracket kind;
    int          state;     /* the register it was opened in */
    struct span  span;
};

struct scanner {
    struct parse *parse;
    unsigned      at;               /* bytes read */
    size_t        again;            /* and bytes read again, as they were given back or looked through */
    int           texts, statements, lines;     /* of the file so far: prose, what is none, and what ended either; */
    int           behind;           /* words and signs behind the first error */
    struct words_line line;         /* that is read */
    int           start;            /* the token that comes before all others */
    int           statement;        /* the token that began this statement */
    int           previous;         /* the token before this one, */
    unsigned      token_end;        /* and where it ended */
    bool          comma;            /* a row's text ended with one */
    bool          star;             /* a row's star is open */
    bool          star_left;        /* and was when the row ended */
    bool          complained;       /* about a character of this line */
    bool          bold;             /* `**` was opened before this head */
    bool          begun;            /* a statement came before */
    bool          counted;          /* this one has said for how many rows */
    bool          multiple;         /* of what the stitches are a multiple, and no row yet */
    int           bare;             /* the number of the next row, where rows without their names may stand; or 0 */
    bool          closed;           /* the stitches were cast off */
    bool          section;          /* of materials, notes or abbreviations, up to an empty line */
    bool          hole;             /* the bracket closed last was a number's */
    bool          stops;            /* a full stop stood between stitches of this row */
    int           titles;           /* lines of prose before the first statement */
    unsigned      turned;           /* where `4 k` ends that was read last; 0: none was */
    unsigned      tight;            /* where stitches without a blank between them end */
    unsigned      prose_end;        /* lines before this were called prose */
    bool          quiet;            /* an unclosed bracket was reported: no more about it */
    struct span   unclosed;         /* the bracket that was open within the line where it ended */
    int           nopen;
    struct open   open[LIMIT_NESTING];
};

#define SCANNER_TEXT(scanner) ((scanner)->parse->text + (scanner)->at)

/* Runs flex and bison over the text from byte `at` on (lexer.l). */
struct stmt *scanner_parse(struct scanner *);

/* Runs flex alone: each token up to TOKEN_END goes to `take`. */
void scanner_tokens(struct scanner *, void (*take)(void *context, int kind, struct span), void *context);

/* The stars of a mark that begins a text; 0: none does. */
static inline int scanner_stars(const struct scanner *scanner, const char *text)
{
    return starred_mark(scanner->parse->text, scanner->parse->source->text, (size_t)(text - scanner->parse->text));
}

/* Whether there are too many errors to go on. */
bool scanner_gives_up(struct scanner *, struct span);

void scanner_advance(struct scanner *, struct span *, size_t length);
void scanner_retreat(struct scanner *, struct span *, int length);

/* So many bytes are looked through for what begins here; the rest of the line is. */
void scanner_looks(struct scanner *, size_t length);
void scanner_looks_on(struct scanner *);

/* Each returns the token. */
int scanner_token(struct scanner *, int kind);
int scanner_bad_unit(struct scanner *, struct span, const char *text);
int scanner_fraction(struct scanner *, struct span, const char *text);
bool scanner_is_lettered(const struct scanner *, const char *word);
bool scanner_is_scanned(const struct scanner *, const char *word);
int scanner_lettered(struct scanner *, struct span); /* the letter of "Row 1a" */
int scanner_scanned(struct scanner *, struct span);  /* of "Row l", "CO 2O sts" */
int scanner_needle(struct scanner *, struct span); /* "1st needle: k2" */
int scanner_no_stitches(struct scanner *, struct span, const char *word); /* "cast on 40 needles" */
int scanner_open_string(struct scanner *, struct span);
int scanner_character(struct scanner *, struct span);
/* The bytes of a character without meaning: once its line has had a message, of all up to the next ASCII word. */
size_t scanner_strange_length(const struct scanner *, const char *text);
int scanner_end(struct scanner *);

/* A statement's first word; an empty line. */
void scanner_begin(struct scanner *, int statement);
void scanner_blank_line(struct scanner *, const char *line_ends);

/* Whether what was read last is a group that can be repeated. */
bool scanner_is_behind_times(const struct scanner *);    /* "once", "3 times" */
bool scanner_closes_group(const struct scanner *);

/* Whether a line behind the cast-on that comes next is a row without its name, `k2, p2 to end`. */
bool scanner_bare_row(const struct scanner *);

/* The head of such a row: of no bytes, a token. */
int scanner_begin_bare(struct scanner *, KNIT_STYPE *, struct span *);

/* Whether what comes next is a line of the page's chart, the name of the rows below it, or describes a rib. */
bool scanner_is_text(struct scanner *);

/* Whether a sentence is read that works rows of a fabric, or rows again. */
bool scanner_works_rows(const struct scanner *);

/* Whether a text keeps edges in a fabric of their own. */
bool scanner_edges(struct scanner *, KNIT_STYPE *, struct span, const char *text);

/* The bytes of `work row 1 of pattern to last 4 sts`; alone in a row only where it says how far, or which row. */
size_t scanner_within(const struct scanner *, KNIT_STYPE *, const char *text);

/* Whether it explains a fabric's name; warns where it may be work. */
bool scanner_explains(struct scanner *);

/* Whether the statement is a row; whether a row's text may begin without a colon. */
bool scanner_in_row_head(const struct scanner *);
bool scanner_takes_colon(const struct scanner *);

/* How much of `text`, `With .. cast on`, is read as `cast on`; 0: it is no such sentence. */
size_t scanner_cast_on(const struct scanner *, const char *text, size_t length);

/* In a row, whether what was read of it is all of its stitches: `purl`, `k2, p2 to end`; by its last word. */
bool scanner_row_is_full(const struct scanner *);

/* Whether a row's text ends with its mark . ; or , that was read last: another sentence follows. */
bool scanner_stops(const struct scanner *, char mark);

/* Whether a bracket here holds examples of a multiple. */
bool scanner_behind_multiple(const struct scanner *);

/* Whether a comma, a bracket or a star that opens stands before. */
bool scanner_begins_item(const struct scanner *);

/* How long `k2, p2, k2` is that begins `back` bytes before, behind other stitches: to be read as one but for its
 * last two; or 0. */
size_t scanner_stitches(const struct scanner *, size_t back);

/* `rep` in a row without `from *`: what is repeated is the group before, or the row so far. */
int scanner_repeat(struct scanner *);

/* Whether a bracket here holds the numbers of further sizes, `4 (5, 6) times`: reports it. */
bool scanner_sizes(struct scanner *, struct span bracket);

/* `40-44-48`, of which this is all but the first: reports it; the parser's error token. */
int scanner_size_list(struct scanner *, struct span);

/* Whether what was read last ends a repeat: its second star, or `rep from *`. */
bool scanner_closes_repeat(const struct scanner *);

/* Whether the star read last closes a repeat whose first star is lost: `K2, P2 *, K1`. */
bool scanner_closes_unopened(const struct scanner *);

/* Brackets: what kind was opened; the register to go back to, 0 behind a block,
 * -1 where nothing was open. */
enum bracket scanner_open(struct scanner *, struct span, char, int state, bool in_expression);
int scanner_close(struct scanner *, char);

/* Whether a line end here ends the statement. */
bool scanner_ends_line(struct scanner *, bool in_row, bool in_expression);

/* Whether this statement works rows again. */
bool scanner_is_repeat(const struct scanner *);

/* Whether it has said which rows, more than one: `these 2 rows`, `rows 1 and 2`; what follows says how far. */
bool scanner_repeats_several(const struct scanner *);

/* Whether the next line says how often the rows named on this one are repeated. */
bool scanner_repeat_goes_on(const struct scanner *);

/* Whether a statement that is no row has said how often, or how many rows: a comma may end it. */
bool scanner_said_how_often(const struct scanner *);

/* Whether one that ends with the line is open. */
bool scanner_in_bracket(const struct scanner *);

/* Ends it: forgets open brackets within the line; true inside a block of keys. */
bool scanner_end_line(struct scanner *);

bool scanner_number_follows(const struct scanner *);

#endif
