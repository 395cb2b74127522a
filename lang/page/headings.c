/* SPDX-License-Identifier: GPL-3.0-or-later
 * A line of a page in, whether it begins with a heading out. */
#include "lang/page/headings.h"

#include "lang/page/prose.h"
#include "lang/page/words.h"

/* The last word of each may also have an s. */
static const char *const of_pattern[] = {
    "begin", "begin pattern", "begin pattern as follow", "begin the pattern", "begin the pattern as follow", "beginning", "body", "border",
    "bottom border", "direction", "edging", "establish pattern", "establish pattern as follow", "establish the pattern", "how to", "how to knit", "how to knit it", "how to make", "how to make it", "how to work",
    "how to work it", "instruction", "let's knit", "main body", "make", "method", "pattern", "pattern instruction", "pattern repeat",
    "pattern stitch", "proceed", "proceed as follow", "scarf", "set pattern", "set pattern as follow", "set up pattern", "start pattern", "start pattern as follow", "start the pattern",
    "start the pattern as follow", "stitch pattern instruction", "stitch pattern repeat", "stitch pattern stitch", "swatch pattern", "to begin",
    "to knit", "to make", "to start", "top border", "work as follow", "work pattern", "work pattern as follow", "work the pattern",
    "work the pattern as follow", "written pattern",
};
static const char *const of_text[] = {
    "abbrev", "abbreviation", "about", "author", "blocking", "by", "chart", "copyright", "description", "design", "designed by", "designer",
    "difficulty", "difficulty level", "dimension", "equipment", "finished measurement", "finished size", "finishing", "gauge", "key",
    "knitted measurement", "knitting gauge", "knitting tension", "legend", "level", "material", "measurement", "motif", "needle", "note",
    "notion", "pattern note", "published", "row gauge", "shown in", "size", "skill level", "source", "special abbreviation",
    "special stitche", "stitch count", "stitch gauge", "stitch glossary", "stitch guide", "stitch key", "stitch multiple", "stitch pattern",
    "stitche", "supplie", "swatch", "technique", "tension", "term", "tip", "tool", "uses", "what you need", "what you will need", "yarn",
    "abbreviations used", "material list", "materials list", "materials needed", "stitches used", "supplies needed", "supply list", "techniques used",
    "what you'll need", "you'll need", "you need", "you will need", "tension square", "tension swatch", "gauge square", "gauge swatch",
};

/* The bytes of a phrase that a text begins with, blanks of any kind between its words; 0: it does not. */
static size_t phrase_length(const char *text, const char *phrase)
{
    const char *at = text;

    for (; *phrase; phrase++)
        if (*phrase == ' ' ? !strchr(" \t\f\v", *at) || !*at : tolower((unsigned char)*at) != *phrase)
            return 0;
        else
            at = *phrase == ' ' ? words_skip_blanks(at) : at + 1;
    at += tolower((unsigned char)*at) == 's';
    return isalnum((unsigned char)*at) || *at == '_' ? 0 : (size_t)(at - text);
}

static size_t longest(const char *text, const char *const *phrase, int n)
{
    size_t most = 0;

    for (int i = isalpha((unsigned char)*text) ? 0 : n; i < n; i++) {
        size_t length = tolower((unsigned char)*text) == *phrase[i] ? phrase_length(text, phrase[i]) : 0;

        most = length > most ? length : most;
    }
    return most;
}

static size_t bold(const char *text)
{
    return strncmp(text, "**", 2) == 0 || strncmp(text, "__", 2) == 0 ? 2 : 0;
}

/* Behind a colon or, `dash`, a dash with a blank, or a stop and a dash; NULL: there is none. */
static const char *skip_mark(const char *text, bool dash)
{
    static const char *const dashes[] = {"- ", "\xE2\x80\x93 ", "\xE2\x80\x94 ", "\xE2\x80\x92 ", "\xE2\x80\x95 ", "\xE2\x88\x92 ", "\xE2\x80\x94", "\xE2\x80\x95"};
    const char *at = words_skip_blanks(text);

    if (*at == ':')
        return at + 1;
    if (dash && *at == '.' && strncmp(words_skip_blanks(at + 1), "--", 2) == 0)
        return words_skip_blanks(at + 1) + 2;
    at = words_skip_blanks(dash && *at == '.' ? at + 1 : at);
    for (size_t i = 0; dash && i < sizeof dashes / sizeof *dashes; i++)
        if (strncmp(at, dashes[i], strlen(dashes[i])) == 0)
            return at + strlen(dashes[i]);
    return NULL;
}

enum heading headings_find(const char *text, size_t *length)
{
    size_t pattern = longest(text, of_pattern, sizeof of_pattern / sizeof *of_pattern), words = longest(text, of_text, sizeof of_text / sizeof *of_text);
    enum heading kind = words > pattern ? HEADING_TEXT : pattern ? HEADING_PATTERN : HEADING_NONE;
    const char *behind = text + (words > pattern ? words : pattern), *mark;

    if (!kind)
        return HEADING_NONE;
    behind += bold(behind);
    mark = skip_mark(behind, kind == HEADING_TEXT);
    *length = (size_t)((mark ? words_skip_blanks(mark + bold(mark)) : behind) - text);

    /* On a line of its own `gauge`, say, may also open a block. */
    return mark || (prose_line_ends(behind) && behind[strspn(behind, " \t\f\v\r\n.")] != '{') ? kind : HEADING_NONE;
}
