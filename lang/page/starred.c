/* SPDX-License-Identifier: GPL-3.0-or-later
 * A page's text in, the same with marks for its stars, and its brackets around rows, that say from where and to where
 * something is worked again out.
 * A star is a bullet, a bold word's or a row's own until a `Repeat from *` names it. */
#include "lang/page/starred.h"

#include <ctype.h>
#include <string.h>

#include "lang/page/groups.h"
#include "lang/page/prose.h"
#include "lang/page/words.h"

enum { MOST_STARS = 3, MOST_MARKS = 40 };

/* So many stars in the text. */
struct stars {
    size_t at;
    int    n;
};

/* The stars above a repeat that may be marks. */
struct marks {
    struct stars stars[MOST_MARKS];
    int          n;
    size_t       single;    /* where the last star stands that is alone, a mark or a row's */
};

static int count_stars(const char *text)
{
    size_t n = strspn(text, "*");

    return n <= MOST_STARS ? (int)n : 0;
}

/* Whether nothing but blanks stands before on the line, or a sentence ends there. */
static bool begins(const char *text, size_t at)
{
    bool blank = at > 0 && strchr(" \t", text[at - 1]);

    return strchr(blank ? "\n.:;)" : "\n", words_sign_before(text, at, " \t"));
}

static bool ends_line(const char *text)
{
    text += strspn(text, " \t.;");
    return !*text || words_ends_line(*text);
}

/* Whether something is worked behind, a row with its name or a sentence. */
static bool work_follows(const char *text)
{
    const char *behind = words_behind_number(words_next(text));

    if (words_are(text, WORDS_PLAIN))
        return behind && words_are_rows(behind);
    if (words_is(text, "next"))
        return words_are_rows(words_next(text));
    return words_row(text) || (prose_statement_follows(text) && !words_stitch_length(text));
}

/* Whether the other stars of a line make two letters bold: `**Row 1:** k2`, `**Border**`. */
static bool is_bold(const char *text, size_t at, int n)
{
    size_t line = words_line_start(text, at), end = line + words_line_length(text + line);

    for (size_t i = line, first, last; i < end; i += strspn(text + i, "*") + 1) {
        if (text[i] != '*' || i == at || count_stars(text + i) != n)
            continue;
        first = i < at ? i : at;
        last = i < at ? at : i;
        if (!work_follows(words_skip_blanks(text + first + n)) || text[last - 1] == ':' || !(begins(text, last) || ends_line(text + last + n)))
            return true;
    }
    return false;
}

/* Whether stars may be a mark: before what is worked, or behind it. A single one before a row stands right at it: a
 * bullet does not. `open`: one is above that another may close. */
static bool may_be_mark(const char *text, size_t at, int n, bool open)
{
    const char *next = text + at + n;
    size_t line = words_line_start(text, at);
    bool first = line + strspn(text + line, " \t") == at;

    if (n == 1 && begins(text, at))
        return first ? ends_line(next) || (*next != ' ' && work_follows(next)) : work_follows(words_skip_blanks(next));
    if (n == 1)
        return open && (ends_line(next) || words_are(next + strspn(next, " .,;"), WORDS_AGAIN));
    if (text[at - (at > 0)] == '*' || (!begins(text, at) && !ends_line(next)))
        return false;
    return !is_bold(text, at, n);
}

static int count_marks(const struct marks *marks, int stars)
{
    int n = 0;

    for (int i = 0; i < marks->n; i++)
        n += marks->stars[i].n == stars;
    return n;
}

/* Whether one star alone is a mark, and none of a row is behind it. */
static bool is_open(const struct marks *marks)
{
    int n = marks->n;

    while (n > 0 && marks->stars[n - 1].n != 1)
        n--;
    return n && marks->stars[n - 1].at == marks->single && count_marks(marks, 1) == 1;
}

/* What follows `rep from *` where it is a part of a row: `to end`, `across`, `until 2 sts remain`. */
static bool is_of_row(const char *text)
{
    static const char *const of_a_row[] = {"to", "across", "around", "all"};

    text = words_skip_blanks(text);
    if (words_is(text, "until") || words_is(text, "till"))
        return words_number(words_next(text)) > 0 || words_is(words_next(text), "last");
    return words_find(text, of_a_row, 4) >= 0 || words_are(text, WORDS_END) || (*text == ',' && prose_stitches_follow(words_skip_blanks(text + 1)));
}

/* `from **`, `between ** and **`: where its stars stand; from.n 0: it is none. */
struct named_stars {
    struct stars from, to;
};

static struct named_stars stars_named(const char *text, size_t at)
{
    const char *first = words_next(text + at), *behind;
    struct named_stars named = {0};
    int n;

    if (!words_is(text + at, "from") && !words_is(text + at, "between"))
        return named;
    first = words_is(first, "the") ? words_next(first) : first;
    n = count_stars(first);
    behind = words_skip_blanks(first + n);
    named.from = (struct stars){(size_t)(first - text), n};
    if (n && (words_is(behind, "to") || words_is(behind, "and") || words_is(behind, "through")) && count_stars(words_next(behind))) {
        behind = words_next(behind);
        named.to = (struct stars){(size_t)(behind - text), count_stars(behind)};
        behind += named.to.n;
    }
    return is_of_row(behind) ? (struct named_stars){0} : named;
}

/* `from **` behind `Repeat`, `Work` at a sentence's beginning, or behind `then`: its place, or 0. */
static size_t from_place(const char *text, size_t at)
{
    const char *word = text + at, *next = words_next(word + (strncasecmp(word, "rep.", 4) == 0));

    if (words_is(word, "then"))
        next = words_are(next, WORDS_AGAIN) ? words_next(next) : next;
    else if (!(words_are(word, WORDS_AGAIN) || words_is(word, "work")) || !(begins(text, at) || '*' == words_sign_before(text, at, " \t,;")))
        return 0;
    return words_is(next, "from") || words_is(next, "between") ? (size_t)(next - text) : 0;
}

/* Whether the marks named are above and cannot be taken for others. */
static bool are_above(const struct marks *marks, const struct named_stars *named)
{
    int from = count_marks(marks, named->from.n), to = count_marks(marks, named->to.n);

    if (named->to.n == named->from.n || named->from.n > 1)
        return named->to.n == named->from.n ? from == 2 : from > 0 && (!named->to.n || to > 0);
    return named->from.n == 1 && is_open(marks) && (!named->to.n || to == 1);
}

/* The last star of a repeat's is its mark. */
static void put_stars(char *text, struct stars stars)
{
    memset(text + stars.at, ' ', (size_t)stars.n);
    text[stars.at + (size_t)stars.n - 1] = (char)stars.n;
}

/* A mark, and where there is room the ends of lines around it. */
static void put_mark(char *text, struct stars mark)
{
    size_t last = mark.at + (size_t)mark.n - (mark.n > 1);

    memset(text + mark.at, ' ', (size_t)mark.n);
    text[mark.at] = (char)mark.n;
    if (mark.at > 0 && strchr(" \t", text[mark.at - 1]))
        text[mark.at - 1] = '\n';
    if (strchr(" \t", text[last]))
        text[last] = '\n';
}

/* Puts the stars that a repeat names, and the marks above. */
static void put_named(char *text, const struct marks *marks, const struct named_stars *named)
{
    for (int i = 0; i < marks->n; i++)
        if ((marks->stars[i].n == named->from.n || marks->stars[i].n == named->to.n) && text[marks->stars[i].at] == '*')
            put_mark(text, marks->stars[i]);
    put_stars(text, named->from);
    if (named->to.n)
        put_stars(text, named->to);
}

/* A single star names what is behind it once: the next is another. */
static void forget_single(struct marks *marks)
{
    int n = 0;

    for (int i = 0; i < marks->n; i++)
        if (marks->stars[i].n > 1)
            marks->stars[n++] = marks->stars[i];
    marks->n = n;
}

/* `2 times`, `(twice)`, `x 3` */
static bool is_so_often(const char *text)
{
    const char *times = words_skip_blanks(text);

    times = words_skip_blanks(times + (*times == '(' || *times == ','));
    return prose_times_follow(times) || words_are(times, WORDS_OFTEN) || (words_is(times, "x") && isdigit((unsigned char)*words_next(times))) ||
           (strncmp(times, "\xC3\x97", 2) == 0 && isdigit((unsigned char)*words_skip_blanks(times + 2)));
}

/* Whether rows are worked, not again. */
static bool rows_follow(const char *text)
{
    const char *behind = words_behind_number(text);

    return behind ? words_are_rows(behind) : work_follows(text) && !words_are(text, WORDS_AGAIN | WORDS_CAST) && !(words_is(text, "work") && words_row(words_next(text)));
}

/* Where `[Work 2 rows in st st, knit 4 rows] twice` is closed, which groups rows; 0: it groups stitches, or is a remark.
 * *verb: where `Work [2 rows in st st, ..` begins, or the bracket. */
static size_t close_of_rows(const char *text, size_t at, size_t *verb)
{
    size_t close, work = words_before(text, at);

    *verb = work < at && words_is(text + work, "work") ? work : at;
    close = begins(text, *verb) || words_sign_before(text, *verb, " \t") == ',' ? groups_close_below(text + at) : 0;
    if (!close || !is_so_often(text + at + close + 1) || !rows_follow(text + at + 1 + strspn(text + at + 1, " \t\r\n")))
        return 0;
    return at + close;
}

/* Puts a semicolon for a comma before rows. */
static void put_stop(char *text, size_t at)
{
    if (text[at] == ',' && rows_follow(words_skip_blanks(text + at + 1)))
        text[at] = ';';
}

/* Puts its marks: the rows behind the first are worked so often in all. */
static void put_group(char *text, size_t verb, size_t at, size_t close)
{
    for (size_t i = at; i < close; i++)
        put_stop(text, i);
    put_stop(text, close + strcspn(text + close, ",.;\r\n"));
    memset(text + verb, ' ', at - verb);
    while (verb > 0 && strchr(" \t", text[verb - 1]))
        verb--;
    if (verb > 0 && text[verb - 1] == ',')
        text[verb - 1] = ';';
    text[at] = STARRED_GROUP;
    text[close] = STARRED_GROUP_END;
    while (strchr(" .;,", text[--close]))
        text[close] = ' ';
}

const char *starred_plain(struct arena *arena, const char *text, size_t size)
{
    struct marks marks = {0};
    struct words_line line = {0};
    char *own = NULL;

    if (!strpbrk(text, "*[("))
        return text;
    for (size_t at = 0, n; at < size; at += n ? n : 1) {
        struct named_stars named = {0};
        size_t from = 0, close, verb;

        n = text[at] == '*' ? strspn(text + at, "*") : words_length(text + at);
        if (words_line_is_long(&line, text, at))
            continue;
        close = text[at] == '[' || text[at] == '(' ? close_of_rows(text, at, &verb) : 0;
        if (close) {
            own = own ? own : arena_copy(arena, text, size);
            put_group(own, verb, at, close);
        }
        if (text[at] == '*' && count_stars(text + at) && marks.n < MOST_MARKS && may_be_mark(text, at, (int)n, is_open(&marks)))
            marks.stars[marks.n++] = (struct stars){at, (int)n};
        if (text[at] == '*')
            marks.single = n == 1 ? at : marks.single;
        else
            from = from_place(text, at);
        if (from)
            named = stars_named(text, from);
        if (!named.from.n)
            continue;
        if (are_above(&marks, &named)) {
            own = own ? own : arena_copy(arena, text, size);
            put_named(own, &marks, &named);
            if (words_is(own + at, "work"))     /* `Work from ** to **` */
                memcpy(own + at, "rep ", strlen("rep "));
            if (named.from.n == 1)
                forget_single(&marks);
        }
        n = (named.to.n ? named.to.at + (size_t)named.to.n : named.from.at + (size_t)named.from.n) - at;
    }
    return own ? own : text;
}

/* The stars that a mark's byte stands for; 0: another byte. */
static int mark_at(const char *text)
{
    return *text >= 1 && *text <= STARRED_GROUP_END ? *text : 0;
}

int starred_mark(const char *plain, const char *source, size_t at)
{
    return plain[at] != source[at] ? mark_at(plain + at) : 0;
}

size_t starred_length(const char *plain, struct starred *starred)
{
    const char *first = words_next(plain), *behind, *to;

    if (!words_is(plain, "from") && !words_is(plain, "between"))
        return 0;
    first = words_is(first, "the") ? words_next(first) : first;
    *starred = (struct starred){mark_at(first), 0};
    if (!starred->from)
        return 0;
    behind = first + 1;
    to = words_next(words_skip_blanks(behind));
    if (to > words_skip_blanks(behind) && mark_at(to)) {
        starred->to = mark_at(to);
        behind = to + 1;
    }
    return (size_t)(behind - plain);
}
