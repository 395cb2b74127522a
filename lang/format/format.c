/* SPDX-License-Identifier: GPL-3.0-or-later
 * A script in, the same script evenly laid out.  What a knitter writes is
 * printed from the syntax tree (row_words.c); everything else keeps its tokens,
 * and gets its blanks, indentation and line ends anew.  Comments are tokens. */
#include "lang/format/format.h"

#include <ctype.h>
#include <string.h>
#include <strings.h>

#include "lang/format/chart_lines.h"
#include "lang/limits.h"
#include "lang/format/meaning.h"
#include "lang/format/own_words.h"
#include "lang/format/row_words.h"
#include "lang/scanner.h"
#include "lang/format/spelling.h"

enum { STEP = 2 };      /* columns of indentation */

struct format {
    struct arena *arena;
    const struct source *source;
    struct tokens tokens;
    int at;                     /* the token to print next */
    struct layout *out;
    struct row_style style;
    const struct stmt **row;    /* the knitter's statements and charts not yet printed, in order */
};

static void format_statements(struct format *, int indent);

static const struct token *token(const struct format *f)
{
    return &f->tokens.at[f->at];
}

/* The next token that is no comment, from i on. */
static const struct token *behind_comments(const struct format *f, int i)
{
    while (f->tokens.at[i].kind == TOKEN_COMMENT)
        i++;
    return &f->tokens.at[i];
}

static bool is_end(const struct token *t)
{
    return t->first || t->kind == TOKEN_END || t->kind == '}';
}

/* ---- comments ---- */

static void add_source(struct format *f, struct span span)
{
    layout_add(f->out, f->source->text + span.start, span.end - span.start);
}

/* Comments behind a statement on its line. */
static void format_trailing(struct format *f)
{
    for (; token(f)->kind == TOKEN_COMMENT && token(f)->breaks == 0 && !layout_empty(f->out); f->at++)
        layout_comment(f->out, f->source->text + token(f)->span.start, token(f)->span.end - token(f)->span.start);
}

/* ---- what keeps its tokens ---- */

/* Where the lines of an expression that goes on are indented. */
struct nest {
    int column[LIMIT_NESTING];  /* behind each open bracket */
    int n;
    int base, extra;            /* the statement's indentation; of the lines of a value */
    int choices;                /* question marks without their colon */
    bool opens;                 /* the token before opened a bracket */
};

static int indent_of(const struct nest *nest, const struct token *t)
{
    bool closing = t->kind == ')' || t->kind == ']';

    return nest->n > closing ? nest->column[nest->n - 1] - (closing && nest->n) : nest->base + nest->extra;
}

static void follow(struct nest *nest, const struct token *t, int width)
{
    bool value = t->kind == '=' || (t->kind == ':' && !nest->choices);

    if ((t->kind == '(' || t->kind == '[') && nest->n < LIMIT_NESTING)
        nest->column[nest->n++] = width;
    else if ((t->kind == ')' || t->kind == ']') && nest->n)
        nest->n--;
    else if (t->kind == '?')
        nest->choices++;
    else if (t->kind == ':' && nest->choices)
        nest->choices--;
    if (t[1].breaks && !nest->n && value && t[1].kind != TOKEN_COMMENT)
        nest->extra += STEP;
    else if (t[1].breaks && !nest->extra)
        nest->extra = STEP;
}

static void format_token(struct format *f, const struct nest *nest, bool begun)
{
    const struct token *t = token(f);
    const char *text;

    if (begun && (t->breaks || t[-1].kind == TOKEN_COMMENT))
        layout_line(f->out, indent_of(nest, t), false);
    else if (begun && spelling_blank(&f->tokens, f->at))
        layout_add(f->out, " ", 1);
    text = t->kind == TOKEN_COMMENT ? NULL : spelling_of(f->arena, t);
    if (text)
        layout_add(f->out, text, strlen(text));
    else
        add_source(f, t->span);
}

/* Prints tokens to the end of the statement, or to the brace that opens its block. */
static void format_tokens(struct format *f, int indent)
{
    struct nest nest = {.base = indent};
    int begin = f->at, holes = 0;

    for (;; f->at++) {
        const struct token *t = token(f);
        bool ends = t->kind == TOKEN_END || (t->first && f->at > begin) || (t->kind == '}' && !holes);

        if (t->kind == TOKEN_COMMENT && is_end(behind_comments(f, f->at)) && !holes)
            return;
        if (ends || t->kind == '{')
            return;
        holes += (t->kind == TOKEN_HOLE) - (t->kind == '}');
        if (t->kind == TOKEN_COMMENT && t->breaks == 0) {
            layout_comment(f->out, f->source->text + t->span.start, t->span.end - t->span.start);
            continue;
        }
        if (t->kind == TOKEN_STS)
            continue;
        format_token(f, &nest, f->at > begin);
        follow(&nest, t, layout_width(f->out));
    }
}

static bool is_knitters(int kind)
{
    static const int kinds[] = {TOKEN_ROW, TOKEN_ALL, TOKEN_CAST_ON, TOKEN_MULTIPLE_OF, TOKEN_REPEAT_ROWS, TOKEN_REPEAT_LAST,
                                TOKEN_SETUP, TOKEN_NUMBER_OF, TOKEN_PLAIN_ROWS, TOKEN_PLAIN_EVERY, TOKEN_WORK, TOKEN_WORK_ROWS,
                                TOKEN_GO_ON_ROWS, TOKEN_REPEAT_THEM, TOKEN_REPEAT_ALL, TOKEN_REPEAT_STARRED, TOKEN_STARTING, TOKEN_SIDE, TOKEN_NEXT_ROWS,
                                TOKEN_WORK_THEM, TOKEN_WORK_LAST, TOKEN_BARE_ROW};

    for (size_t i = 0; i < sizeof kinds / sizeof *kinds; i++)
        if (kind == kinds[i])
            return true;
    return false;
}

/* ---- rows ---- */

/* Moves behind a knitter's statement; whether comments stand inside it. */
static bool skip_row(struct format *f)
{
    int begin = f->at, holes = 0;
    bool comments = false;

    for (;; f->at++) {
        const struct token *t = token(f), *next = behind_comments(f, f->at);
        bool ends = next->kind == TOKEN_END || (next->first && f->at > begin) || (next->kind == '}' && !holes);

        if (ends)
            return comments;
        holes += (t->kind == TOKEN_HOLE) - (t->kind == '}');
        comments |= t->kind == TOKEN_COMMENT;
    }
}

static bool stop_follows(const struct format *f, unsigned end)
{
    const char *text = f->source->text;

    for (; text[end] && strchr(" \t\f\v.;,", text[end]); end++)
        if (text[end] == '.')
            return true;
    return false;
}

/* A full stop behind the statement, or before its `(24 sts)`. */
static bool is_stopped(const struct format *f, const struct stmt *stmt, unsigned end)
{
    const char *text = f->source->text;
    unsigned before = stmt->kind == STMT_ROW && stmt->row.check ? stmt->row.check_span.start : end;

    if (stop_follows(f, end))
        return true;
    while (before > 0 && strchr(" \t\f\v\r\n;,", text[before - 1]))
        before--;
    return before > 0 && text[before - 1] == '.';
}

/* Text with comments inside keeps its lines; only their indentation changes. */
static void format_verbatim(struct format *f, struct span span, int indent)
{
    const char *text = f->source->text;

    for (unsigned at = span.start, end; at < span.end; at = end) {
        unsigned last;

        at += (unsigned)strspn(text + at, " \t\f\v\r\n");
        end = at + (unsigned)strcspn(text + at, "\r\n");
        end = end < span.end ? end : span.end;
        for (last = end; last > at && strchr(" \t\f\v", text[last - 1]); last--)
            ;
        if (at > span.start)
            layout_line(f->out, indent + 2 * STEP, false);
        layout_add(f->out, text + at, last - at);
    }
}

/* The statement of the tree whose tokens begin at one and end before a place; NULL: it was read as none. */
static const struct stmt *statement_of(struct format *f, const struct token *first, unsigned end)
{
    while (*f->row && (*f->row)->span.end <= first->span.start)
        f->row++;
    return *f->row && (*f->row)->span.start < end ? *f->row++ : NULL;
}

static bool is_text(int kind)
{
    return kind == TOKEN_PROSE || kind == TOKEN_GO_ON || kind == TOKEN_FORM_PATTERN || kind == TOKEN_KEPT_EDGES;
}

/* Whether what comes next stands on the line of the statement before it. */
static bool is_joined(const struct token *t)
{
    return t->first && !t->breaks && t->kind != '}' && t->kind != TOKEN_END;
}

static void format_row(struct format *f, int indent)
{
    const struct token *first = token(f);
    bool comments = skip_row(f);
    const struct token *last = token(f) - 1;
    const struct stmt *stmt = statement_of(f, first, last->span.end);
    bool verbatim = comments || !stmt || own_words(first, token(f), stmt);
    bool marked = first > f->tokens.at && first[-1].kind == TOKEN_STARS;
    struct span span = {f->source, first->span.start, last->tail.source && verbatim ? last->tail.end : last->span.end};

    while (!marked && span.start > first->label.end && strchr("*_", f->source->text[span.start - 1]))
        span.start--;
    while (span.start > 0 && isalnum((unsigned char)f->source->text[span.start - 1]) && isalnum((unsigned char)f->source->text[span.start]))
        span.start--;   /* `Rows3-4` */
    if (verbatim) {
        span.end = own_words_end(span);
        format_verbatim(f, span, indent);
        layout_add(f->out, ".", !comments && stop_follows(f, span.end));
    } else
        row_words(f->out, &f->style, stmt, first->kind, is_stopped(f, stmt, span.end) || (stmt->kind == STMT_ROW && is_text(token(f)->kind) && is_joined(token(f))));
}

/* ---- text around a pattern ---- */

/* One blank, or the line end that is among them. */
static void break_words(struct format *f, const char *blanks, size_t n, int indent)
{
    if (memchr(blanks, '\n', n) || memchr(blanks, '\r', n))
        layout_line(f->out, indent + 2 * STEP, false);
    else
        layout_add(f->out, " ", 1);
}

/* One blank between words, lines as they are. */
static void format_words(struct format *f, struct span span, int indent)
{
    static const char blank[] = " \t\f\v\r\n";
    const char *text = f->source->text, *end = text + span.end, *word = text + span.start;

    word += strspn(word, blank);
    for (size_t n, blanks; word < end; word += n + blanks) {
        n = strcspn(word, blank);
        n = word + n < end ? n : (size_t)(end - word);
        blanks = strspn(word + n, blank);
        layout_add(f->out, word, n);
        if (word + n + blanks < end)
            break_words(f, word + n, blanks, indent);
    }
}

/* What parts text from the statement before it on its line, which has its full stop; NULL: it gets a line of its own. */
static const char *joint(const struct format *f)
{
    unsigned end = token(f)[-1].span.end, n = token(f)->span.start - end;
    const char *gap = f->source->text + end;

    if (!is_text(token(f)->kind) || !is_joined(token(f)))
        return NULL;
    return memchr(gap, ';', n) ? "; " : memchr(gap, '.', n) ? " " : token(f)->span.source->text[token(f)->span.start] == ',' ? "" : NULL;
}

/* It keeps its words, and what stands behind it on its line stays there: a part of a line may read otherwise alone. */
static void format_text(struct format *f, int indent)
{
    const char *text = f->source->text;
    struct span span = token(f)->span;

    do {
        skip_row(f);
    } while (is_joined(token(f)));
    span.end = token(f)[-1].span.end;
    span.end += (unsigned)strcspn(text + span.end, "\r\n");
    if (!token(f)->breaks && token(f)->kind != TOKEN_END)
        span.end = token(f)->span.start;
    format_words(f, span, indent);
}

/* ---- charts ---- */

static void format_chart(struct format *f, int indent)
{
    struct chart_lines *lines;

    while ((*f->row)->kind != STMT_CHART)
        f->row++;
    lines = chart_lines_new(f->arena, *f->row++);
    layout_add(f->out, " {", 2);
    f->at++;
    format_trailing(f);
    for (; token(f)->kind != '}' && token(f)->kind != TOKEN_END; f->at++) {
        bool gap = token(f)->breaks > 1 && token(f)[-1].kind != '{';

        layout_line(f->out, indent + STEP, gap);
        if (token(f)->kind == TOKEN_COMMENT) {
            add_source(f, token(f)->span);
            continue;
        }
        chart_lines_print(lines, f->out);
        if (token(f)[1].kind == TOKEN_COMMENT && token(f)[1].breaks == 0) {
            f->at++;
            layout_comment(f->out, f->source->text + token(f)->span.start, token(f)->span.end - token(f)->span.start);
        }
    }
    layout_line(f->out, indent, false);
    layout_add(f->out, "}", 1);
    f->at++;
}

/* ---- blocks ---- */

/* The brace that closes the one at i, and whether all between is on its line. */
static bool is_one_line(const struct format *f, int i, int *statements)
{
    int open = 0;

    *statements = 0;
    for (;; i++) {
        const struct token *t = &f->tokens.at[i];

        open += (t->kind == '{' || t->kind == TOKEN_HOLE) - (t->kind == '}');
        if (!open)
            return true;
        if (t->kind == TOKEN_END || t[1].breaks || t[1].kind == TOKEN_COMMENT || t->kind == TOKEN_CHART)
            return false;
        *statements += t->kind == '{' || t[1].first;
    }
}

/* `{ width = 1.4; height = 1.2 }`, or a line for each. */
static void format_settings(struct format *f, int indent)
{
    int n;
    bool one_line = is_one_line(f, f->at, &n);

    f->at++;
    layout_add(f->out, " {", 2);
    format_trailing(f);
    for (const char *before = " "; token(f)->kind != '}' && token(f)->kind != TOKEN_END; before = "; ") {
        bool gap = token(f)->breaks > 1 && token(f)[-1].kind != '{';

        if (one_line)
            layout_print(f->out, "%s", before);
        else
            layout_line(f->out, indent + STEP, gap);
        if (token(f)->kind == TOKEN_COMMENT)
            add_source(f, f->tokens.at[f->at++].span);
        else
            format_tokens(f, indent + STEP);
        format_trailing(f);
    }
    if (!one_line)
        layout_line(f->out, indent, false);
    layout_print(f->out, one_line ? " }" : "}");
    f->at++;
}

static void format_statement(struct format *f, int indent);

/* The statements of a motif, a loop or an `if`: on its line if there is one alone. */
static void format_body(struct format *f, int indent)
{
    int n;
    bool one_line = is_one_line(f, f->at, &n) && n == 1;

    f->at++;
    layout_add(f->out, " {", 2);
    format_trailing(f);
    if (one_line && token(f)->kind != '}') {
        layout_add(f->out, " ", 1);
        format_statement(f, indent);
        layout_add(f->out, " ", 1);
        layout_whole(f->out);
    } else if (!one_line) {
        format_statements(f, indent + STEP);
        layout_line(f->out, indent, false);
    }
    layout_add(f->out, "}", 1);
    f->at++;
}

/* ---- statements ---- */

static bool has_body(int kind)
{
    return kind == TOKEN_MOTIF || kind == TOKEN_FOR || kind == TOKEN_IF || kind == TOKEN_ELSE;
}

/* `else` follows the brace, unless a comment stands between. */
static void format_else(struct format *f, int indent)
{
    while (behind_comments(f, f->at)->kind == TOKEN_ELSE && !behind_comments(f, f->at)->first) {
        bool apart = token(f)->kind == TOKEN_COMMENT;

        format_trailing(f);
        for (; token(f)->kind == TOKEN_COMMENT; f->at++) {
            layout_line(f->out, indent, token(f)->breaks > 1);
            add_source(f, token(f)->span);
        }
        if (apart)
            layout_line(f->out, indent, false);
        else
            layout_add(f->out, " ", 1);
        format_tokens(f, indent);
        format_body(f, indent);
    }
}

static void format_statement(struct format *f, int indent)
{
    int kind = token(f)->kind, begin = f->at, n;

    if (token(f)->label.source) {
        bool comma = f->source->text[token(f)->label.end] == ',';   /* `Using 4mm needles, cast on 20` */

        format_words(f, token(f)->label, indent);
        layout_add(f->out, comma ? ", " : " ", comma ? 2 : 1);
    }
    if (is_knitters(kind)) {
        format_row(f, indent);
        return;
    }
    if (is_text(kind)) {
        format_text(f, indent);
        return;
    }
    format_tokens(f, indent);
    if (token(f)->kind != '{')
        return;
    if (kind == TOKEN_CHART) {
        format_chart(f, indent);
    } else if (has_body(kind)) {
        format_body(f, indent);
        format_else(f, indent);
    } else {
        if ((kind == TOKEN_BLOCK || kind == TOKEN_STITCH) && is_one_line(f, f->at, &n) && f->at <= begin + 2)
            layout_column(f->out, LAYOUT_BLOCK);
        format_settings(f, indent);
    }
}

static void format_statements(struct format *f, int indent)
{
    for (int begin = f->at; token(f)->kind != '}' && token(f)->kind != TOKEN_END;) {
        const char *between = f->at > begin ? joint(f) : NULL;

        if (between)
            layout_print(f->out, "%s", between);
        else
            layout_line(f->out, indent, f->at > begin && token(f)->breaks > 1);
        if (token(f)->kind == TOKEN_COMMENT)
            add_source(f, f->tokens.at[f->at++].span);
        else
            format_statement(f, indent);
        format_trailing(f);
    }
}

/* ---- the whole ---- */

/* The statements that are printed from the tree, in the order of the text. */
static const struct stmt **collect(const struct stmt *stmt, const struct stmt **to, int *n)
{
    for (; stmt; stmt = stmt->next) {
        bool row = stmt->kind == STMT_ROW || stmt->kind == STMT_AGAIN || stmt->kind == STMT_CAST_ON ||
                   stmt->kind == STMT_MULTIPLE || stmt->kind == STMT_CHART;

        if (row && to)
            to[*n] = stmt;
        *n += row;
        if (stmt->kind == STMT_MOTIF)
            collect(stmt->motif.body, to, n);
        else if (stmt->kind == STMT_FOR)
            collect(stmt->loop.body, to, n);
        else if (stmt->kind == STMT_IF) {
            collect(stmt->choice.then, to, n);
            collect(stmt->choice.otherwise, to, n);
        }
    }
    return to;
}

static bool is_plain_word(const char *word)
{
    return strcasecmp(word, "k") == 0 || strcasecmp(word, "p") == 0 || strcasecmp(word, "knit") == 0 ||
           strcasecmp(word, "purl") == 0;
}

/* K and k are the same, unless the script names a stitch of its own so. */
static bool has_own_k(const struct stmt *stmt)
{
    for (; stmt; stmt = stmt->next) {
        const char *name = stmt->kind == STMT_STITCH ? stmt->stitch.name.name : "";

        if (is_plain_word(name) && strcmp(name, "K") != 0 && strcmp(name, "P") != 0)
            return true;
        for (const struct pair *pair = stmt->kind == STMT_STITCH ? stmt->stitch.pair : NULL; pair; pair = pair->next)
            if (strcasecmp(pair->key, "symbol") == 0 && strcmp(name, "K") != 0 && strcmp(name, "P") != 0 &&
                (pair->value->kind != EXPR_STRING || is_plain_word(pair->value->text)))
                return true;
    }
    return false;
}

/* A script, laid out. */
struct laid_out {
    const char         *text;
    size_t              length;
    const struct stmt **row;        /* (n) its knitters' statements and charts */
    int                 n, comments;
    bool                whole;      /* to its end: no brace that nothing opened stands in its way */
};

static struct laid_out lay_out(struct arena *arena, struct diag *diag, const struct source *source)
{
    struct names names = {.arena = arena};
    struct parse parse = parse_read(arena, diag, &names, source);
    struct stmt *file = parse_statements(&parse);
    struct format f = {.arena = arena, .source = source, .out = layout_new(arena)};
    struct laid_out all = {0};

    if (diag->nerrors)
        return all;
    f.tokens = tokens_read(&parse);
    for (int i = 0; i < f.tokens.n; i++)
        all.comments += f.tokens.at[i].kind == TOKEN_COMMENT;
    collect(file, NULL, &all.n);
    f.row = all.row = arena_array(arena, const struct stmt *, (size_t)all.n + 1);
    all.n = 0;
    collect(file, all.row, &all.n);
    all.row[all.n] = NULL;
    f.style = (struct row_style){arena, &f.tokens, !has_own_k(file)};
    format_statements(&f, 0);
    all.whole = token(&f)->kind == TOKEN_END;
    all.text = layout_text(f.out, &all.length);
    return all;
}

/* What one layout is made of gives the same again, statement for statement. */
static bool is_stable(const struct laid_out *once, const struct laid_out *again)
{
    if (!once->whole || !again->text || once->length != again->length || once->n != again->n || once->comments != again->comments)
        return false;
    for (int i = 0; i < once->n; i++)
        if (once->row[i]->kind != again->row[i]->kind)
            return false;
    return memcmp(once->text, again->text, once->length) == 0;
}

const char *format_script(struct arena *arena, struct diag *diag, const struct source *source,
                          const struct compile_options *options, size_t *length)
{
    struct laid_out once = lay_out(arena, diag, source), again;
    const struct source *laid;
    struct diag unheard;

    if (!once.text)
        return NULL;
    diag_init(&unheard, arena);
    laid = source_from_text(arena, source->name, once.text, once.length);
    again = lay_out(arena, &unheard, laid);
    if (!is_stable(&once, &again) || (options && !meaning_same(source, laid, options)))
        once = (struct laid_out){.text = source->text, .length = source->size};
    *length = once.length;
    return once.text;
}
