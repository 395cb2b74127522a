/* SPDX-License-Identifier: GPL-3.0-or-later
 * Tokens in, the text a formatted script has for them out. */
#include "lang/format/spelling.h"

#include <ctype.h>
#include <string.h>

#include "lang/scanner.h"

/* Words that may be written in several ways. */
static const struct word {
    int kind;
    const char *text;
} words[] = {
    {TOKEN_KNIT, "knit"},     {TOKEN_USE, "use"},       {TOKEN_AS, "as"},         {TOKEN_FROM, "from"},
    {TOKEN_LET, "let"},       {TOKEN_PARAM, "param"},   {TOKEN_STITCH, "stitch"}, {TOKEN_MOTIF, "motif"},
    {TOKEN_SWATCH, "swatch"}, {TOKEN_OUTPUT, "output"}, {TOKEN_SWEEP, "sweep"},   {TOKEN_FOR, "for"},
    {TOKEN_IF, "if"},         {TOKEN_ELSE, "else"},     {TOKEN_CHART, "chart"},   {TOKEN_EACH, "each"},
    {TOKEN_IN, "in"},         {TOKEN_BY, "by"},         {TOKEN_MOD, "mod"},       {TOKEN_MULTIPLE_OF, "multiple of"},
    {'+', "+"},        {'*', "*"},
};

static size_t length_of(const struct token *token)
{
    return token->span.end - token->span.start;
}

static const char *first_of(const struct token *token)
{
    return token->span.source->text + token->span.start;
}

/* `1E-4` and `5 MM` as `1e-4` and `5mm`. */
static const char *number(struct arena *arena, const struct token *token)
{
    char *text = arena_copy(arena, first_of(token), length_of(token)), *to = text;

    for (const char *from = text; *from; from++)
        if (!strchr(" \t\f\v\xC2\xA0", *from))
            *to++ = (char)tolower((unsigned char)*from);
    *to = '\0';
    return text;
}

static const char *lower(struct arena *arena, const struct token *token)
{
    char *text = arena_copy(arena, first_of(token), length_of(token));

    for (char *c = text; *c; c++)
        *c = (char)tolower((unsigned char)*c);
    return text;
}

const char *spelling_of(struct arena *arena, const struct token *token)
{
    for (size_t i = 0; i < sizeof words / sizeof *words; i++)
        if (words[i].kind == token->kind)
            return words[i].text;
    if (token->kind == TOKEN_NUMBER)
        return number(arena, token);
    if (token->kind == TOKEN_BLOCK)
        return lower(arena, token);
    return arena_copy(arena, first_of(token), length_of(token));
}

/* ---- blanks ---- */

static bool is_one_of(int kind, const int *set)
{
    for (; *set; set++)
        if (kind == *set)
            return true;
    return false;
}

/* Behind these a minus is between two values, and a bracket belongs to them. */
static const int ends_value[] = {TOKEN_NUMBER, TOKEN_STRING, TOKEN_NAME, ')', ']', '}', 0};
static const int opens[] = {'(', '[', TOKEN_HOLE, TOKEN_DOTS, '.', '!', 0};
static const int closes[] = {')', ']', '}', ',', TOKEN_DOTS, '.', 0};
static const int brackets[] = {'(', '[', 0};
static const int has_bracket[] = {TOKEN_NAME, ')', ']', 0};

/* The kind of the token before i, comments aside; TOKEN_END before the first. */
static int kind_before(const struct tokens *tokens, int i)
{
    while (--i >= 0 && tokens->at[i].kind == TOKEN_COMMENT)
        ;
    return i >= 0 ? tokens->at[i].kind : TOKEN_END;
}

bool spelling_blank(const struct tokens *tokens, int i)
{
    int kind = tokens->at[i].kind, before = kind_before(tokens, i);
    bool sign = before == '-' && !is_one_of(kind_before(tokens, i - 1), ends_value);

    if (is_one_of(kind, closes) || is_one_of(before, opens) || sign)
        return false;
    return !(is_one_of(kind, brackets) && is_one_of(before, has_bracket));
}

const char *spelling_of_span(struct arena *arena, const struct tokens *tokens, struct span span)
{
    int first = tokens_find(tokens, span.start);
    const char *text = "";

    for (int i = first; i < tokens->n && tokens->at[i].span.end <= span.end; i++)
        text = arena_printf(arena, "%s%s%s", text, i > first && spelling_blank(tokens, i) ? " " : "",
                            spelling_of(arena, &tokens->at[i]));
    return text;
}
