/* SPDX-License-Identifier: GPL-3.0-or-later
 * The numbers of rows as a statement writes them in, each of them out. */
#include "lang/rows/row_labels.h"

#include "lang/limits.h"

static bool add_label(struct eval *eval, struct row_labels *labels, long long label, struct span span)
{
    if (labels->n >= LIMIT_WRITTEN_ROWS) {
        diag_error(eval->diag, CODE_LIMIT_ROWS, span, "a pattern may have %d written rows",
                   LIMIT_WRITTEN_ROWS);
        return false;
    }
    if (labels->n == labels->room)
        labels->label = arena_larger(eval->arena, labels->label, &labels->room, sizeof *labels->label);
    labels->label[labels->n++] = (int)label;
    return true;
}

bool row_labels_go_on(struct eval *eval, struct row_labels *labels, int last, struct span span)
{
    for (int label = labels->label[0] + 1; label <= last; label++)
        if (!add_label(eval, labels, label, span))
            return false;
    return true;
}

/* The first of rows of one kind, of which every second is. */
static long long first_only(enum all_kind only, long long first, long long last)
{
    bool odd = only == ALL_ODD || only == ALL_RS, by_number = only == ALL_EVEN || only == ALL_ODD;

    return only != ALL_OTHER && (by_number || (last - first) % 2) && first % 2 != odd ? first + 1 : first;
}

bool row_labels_evaluate(struct eval *eval, struct where where, const struct row_numbers *part,
                            struct row_labels *labels)
{
    for (; part; part = part->next) {
        long long first, last;

        if (part->all)
            continue;
        if (!eval_whole(eval, where, part->first, 1, LIMIT_WRITTEN_ROWS, "a row number", &first)) {
            if (part->first->kind == EXPR_NUMBER && part->first->number.value == 0)
                diag_hint(eval->diag, "the cast-on is row 0; what is worked before row 1 is a `Set-up row`");
            return false;
        }
        last = first;
        if (part->last && !eval_whole(eval, where, part->last, 1, LIMIT_WRITTEN_ROWS, "a row number", &last))
            return false;
        if (last < first) {
            diag_error(eval->diag, CODE_ROW_NUMBER, part->span, "rows %lld-%lld go backwards", first, last);
            return false;
        }
        if (part->only && first_only(part->only, first, last) > last) {
            diag_error(eval->diag, CODE_ROW_NUMBER, part->span, "row %lld is not %s", first, part->only == ALL_ODD ? "odd" : "even");
            return false;
        }
        for (long long label = part->only ? first_only(part->only, first, last) : first; label <= last; label += part->only ? 2 : 1)
            if (!add_label(eval, labels, label, part->span))
                return false;
    }
    return true;
}
