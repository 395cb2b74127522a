/* SPDX-License-Identifier: GPL-3.0-or-later
 * A clause about a piece's first or last rows in, their statement out. */
#include "lang/page/framing.h"

#include <stdbool.h>
#include <stdio.h>
#include <string.h>

#include "lang/page/prose.h"
#include "lang/page/words.h"

/* Behind `Finish the scarf with`, `To end,`; NULL: another text. */
static const char *behind_verb(const char *text, bool begins)
{
    const char *verb = words_skip_any(text, "to"), *with;
    size_t n = words_one_of("end|ending|ends|finish|finishing|complete|completing|conclude", verb);

    n = n || !begins ? n : words_one_of("begin|beginning|start|starting|commence", verb);
    if (!n)
        return NULL;
    with = words_skip_any(verb + n, "off|out|up|end|top|the|your|this|it|piece|work|cloth|dishcloth|washcloth|scarf|blanket|square|border|edge|edging");
    if (words_one_of("with|by|on", with))
        return words_skip_any(with, "with|by|on|doing|making|a|another|final|last|the|border|edge|band|of");
    return (verb > text && *with == ',') || (begins && with == verb + n && *with == ':') ? words_skip_blanks(with + 1) : NULL;
}

static bool ends(const char *text)
{
    const char *next = words_skip_blanks(text);

    return prose_line_ends(text) || strchr(".,;:(", *next) || words_one_of("and|then", next);
}

/* Behind the rows, `rows of knit stitch`, and whether they are purled or named otherwise. */
static const char *behind_rows(const char *rows, const char **verb)
{
    const char *behind = words_skip_any(rows + words_length(rows), "of|in|plain|all"), *end;
    size_t n = words_one_of("knitting|knit|k|purl|p", behind);

    if (!n)
        return rows + words_length(rows);
    end = behind + n;
    n = words_one_of("stitches|stitch|sts|st", words_skip_blanks(end));
    end = n ? words_skip_blanks(end) + n : end;
    if (!ends(end))
        return NULL;
    *verb = (*behind | 0x20) == 'p' ? "purl" : "knit";
    return end;
}

/* Behind rows, `two more knit rows`, which are knitted where nothing else is said; and their statement, as wide as the
 * clause from `text` on, so that it ends where they do. NULL: no such rows. */
static const char *behind_statement(const char *text, const char *which, char plain[static SIGNS_PLAIN], const char *before)
{
    const char *number = words_skip_any(which, "knitting|knit|purling|purl|working|work"), *behind = words_behind_number(number), *kind, *rows, *verb = NULL, *end;
    char counted[SIGNS_PLAIN];
    int n = words_number(number), used;

    if (!behind || n < 1 || n > 999)
        return NULL;
    if (number > which)
        verb = (*which | 0x20) == 'p' ? "purl" : (*which | 0x20) == 'k' ? "knit" : "work";
    kind = words_skip_any(behind, "more|additional|further|extra|full|complete|edge|border");
    rows = words_skip_any(kind, "knitted|knit|plain|garter|purl|purled|st|stitch");
    if (rows > kind)
        verb = (*kind | 0x20) == 'p' && !words_is(kind, "plain") ? "purl" : "knit";
    if (words_one_of("ridge|ridges", rows)) {
        verb = "work";
        end = rows + words_length(rows);
    } else {
        end = words_are_rows(rows) ? behind_rows(rows, &verb) : NULL;
    }
    if (!end || !(prose_fabric_follows(words_skip_any(end, "of|in")) || (verb && ends(end))))
        return NULL;
    snprintf(counted, sizeof counted, " %d %.*s", n, (int)words_length(rows), rows);
    used = snprintf(plain, SIGNS_PLAIN, "%s%s", before, verb ? verb : "work");
    snprintf(plain + used, SIGNS_PLAIN - (size_t)used, "%*s", (int)(end - text) - used, counted);
    return end - text < SIGNS_PLAIN && strlen(plain) <= (size_t)(end - text) ? end : NULL;
}

size_t framing_length(const char *text, size_t at, char plain[static SIGNS_PLAIN])
{
    char before = words_sign_before(text, at, " \t");
    bool begins = strchr("\r\n.;:!", before) != NULL, joined = text[at] == ',' || words_one_of("and|then", text + at);
    const char *verb = words_skip_any(text + at, ",|and|then|to finish"), *rows, *end;

    if (!begins && !joined && before != ',')
        return 0;
    rows = behind_verb(joined ? verb : text + at, begins || joined);
    end = rows ? behind_statement(text + at, rows, plain, joined && !begins ? ". " : "") : NULL;
    return end ? (size_t)(end - text) - at : 0;
}
