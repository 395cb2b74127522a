/* SPDX-License-Identifier: GPL-3.0-or-later
 * A statement's tokens in, whether its words stand for themselves: what the
 * syntax tree does not know of them would be lost. */
#include "lang/format/own_words.h"

#include <ctype.h>
#include <string.h>

/* Words that are read over: before and behind a cast-on (`using 4 mm needles`), in a row's head (`(decrease row)`). */
static bool has_skipped_words(const struct token *first, const struct token *end, const struct stmt *stmt)
{
    const char *text = first->span.source->text;
    bool row = stmt->kind == STMT_ROW;

    if (first->kind == TOKEN_CAST_ON && !strchr("cC", text[first->span.start]))
        return true;
    for (const struct token *t = first; t < end; t++) {
        bool remark = t->kind == TOKEN_SIDE && text[t->span.start] == '(' && memchr(text + t->span.start, ',', t->span.end - t->span.start);

        if ((t > first && t->skipped) || remark)
            return true;
        if (row && t->kind == ':')
            return false;
    }
    return !row && end[-1].tail.source;
}

/* `k1, p1 to end` is a whole row, whose last time may stop short. */
static bool is_unmarked(const struct row *row)
{
    const struct item *item = row->item;

    return item->kind == ITEM_REP_FROM && !item->next && item->more->until.kind == UNTIL_END && isalpha((unsigned char)row->head.source->text[item->start]);
}

/* What pages write in words of their own. */
static bool has_own_words(const struct token *first, const struct token *end, const struct stmt *stmt)
{
    static const int words[] = {
        TOKEN_NUMBER_OF, TOKEN_PLAIN_ROWS, TOKEN_PLAIN_EVERY, TOKEN_WORK, TOKEN_WORK_ROWS,
        TOKEN_WORK_THEM, TOKEN_WORK_LAST, TOKEN_FABRIC, TOKEN_TO_FIT, TOKEN_LAST_REPEAT,
        TOKEN_SIZES, TOKEN_AND_ALL, TOKEN_TOTAL, TOKEN_FOR_TOTAL, TOKEN_UNTIL_LENGTH,
        TOKEN_WORK_LENGTH, TOKEN_GO_ON_ROWS, TOKEN_STARTING, TOKEN_REPEAT_THEM, TOKEN_REPEAT_ALL, TOKEN_REPEAT_STARRED, TOKEN_THEN_ROWS, TOKEN_THEN_FIRST,
        TOKEN_FOR_ROWS, TOKEN_EDGES, TOKEN_FEWER, TOKEN_NEXT_ROWS, TOKEN_BARE_ROW, TOKEN_RIDGES, TOKEN_BUT_END,
        TOKEN_OF_PATTERN
    };
    const struct row *row = stmt->kind == STMT_ROW ? &stmt->row : NULL;

    for (const struct token *t = first; t < end; t++)
        for (size_t i = 0; i < sizeof words / sizeof *words; i++)
            if (t->kind == words[i])
                return true;
    for (const struct row_numbers *part = row ? row->numbers : NULL; part; part = part->next)
        if (part->all == ALL_EVERY || (part->all && part->last))
            return true;
    if (row && row->item && is_unmarked(row))
        return true;
    if ((row && (row->setup || (row->numbers && row->starting))) || (stmt->kind == STMT_AGAIN && (stmt->again.from || stmt->again.onwards || stmt->again.numbered || stmt->again.ending)))
        return true;
    return row && row->reference && (row->times || row->reference->next || row->reference->last || row->reference->all);
}

/* `Rice Stitch: *k1, p1; ..`: the row's head is put into the name's words. */
static bool has_name(const struct token *first)
{
    const char *text = first->span.source->text + first->span.start;

    return first->kind == TOKEN_ROW && first->span.end - first->span.start == 1 && first->span.start > 0 && isalpha((unsigned char)text[-1]);
}

bool own_words(const struct token *first, const struct token *end, const struct stmt *stmt)
{
    return has_name(first) || has_own_words(first, end, stmt) || has_skipped_words(first, end, stmt);
}

unsigned own_words_end(struct span span)
{
    const char *text = span.source->text;
    unsigned at = span.end, close = span.end + (unsigned)strcspn(text + span.end, ")]\r\n#");
    int open = 0;
    bool wide = false;

    for (unsigned i = span.start; i < span.end; i++)
        open += strchr("([", text[i]) ? 1 : strchr(")]", text[i]) ? -1 : 0;
    if (open > 0 && strchr(")]", text[close]) && text[close])
        return close + 1;
    while (at > span.start && !strchr(" \t\r\n", text[at - 1]))
        wide |= (unsigned char)text[--at] >= 0x80;
    return wide ? span.end + (unsigned)strcspn(text + span.end, " \t\r\n") : span.end;
}
