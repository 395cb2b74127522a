/* SPDX-License-Identifier: GPL-3.0-or-later
 * The same for turns of phrase of printed books. */
#include "lang/page/turns.h"

const struct phrase turns_of_books[] = {
    {"=knitting|knit =# =,|and =and? purling =#", "purl"},
    {"=purling|purl =# =,|and =and? knitting =#", "knit"},
    /* plain and purl */
    {"=knit|purl|k|p|k.|p. =# plain|purl =row|rows|round|rounds|rnd|rnds|rd|rds", ""},
    {"=knit|k =# =row|rows|round|rounds|rnd|rnds|rd|rds plain", ""},
    {"work|do # plain =row|rows|round|rounds|rnd|rnds|rd|rds", "knit #"},
    {"work|do # purl =row|rows|round|rounds|rnd|rnds|rd|rds", "purl #"},
    {"work|do =# =row|rows|round|rounds|rnd|rnds|rd|rds plain", "knit"},
    {"^ # plain =row|rows|round|rounds|rnd|rnds|rd|rds", "k #"},
    {"^ # purl =row|rows|round|rounds|rnd|rnds|rd|rds", "p #"},
    {"=knit|k plain? for =# =row|rows|round|rounds|rnd|rnds|rd|rds", ""},
    {"and? knit|k plain =until|till|for", "k all rows"},
    {"=knit|k plain", ""},
    {"k. =every|each|all =row|rows|round|rounds|rnd|rnds", "k"},
    {"p. =every|each|all =row|rows|round|rounds|rnd|rnds", "p"},
    {"in plain -? knitting|knit =for =a? =further|another? =# =more? =rounds|rnds|rds", "in st st"},
    {"in plain - knitting|knit", "in garter"},
    {"in plain knitting|knit", "in garter"},
    {"plain =#", "k"},
    {"=# plain", "k"},
    {"seam =# =,|;|.|sts|stitches", "p"},

    {"=knit|purl =every|each|all =row|rows|round|rounds plain", ""},
    {", then|and =knit|purl|k|p|k.|p.|work =# =row|rows|round|rounds|rnd|rnds", "."},
    {", and then =knit|purl|k|p|k.|p.|work =# =row|rows|round|rounds|rnd|rnds", "."},
    {"set -? up rows|row|rounds|rnds|round : =knit|k|k.|purl|p|p.|work =# =row|rows|round|rounds|rnd|rnds", ""},

    {"=# =ridges|ridge in|of garter|g -? st.|st|stitch", ""},

    /* cast on */
    {"^ e - wrap cast on", "cast on"},
    {"^ set|put up|on =# =sts|stitches", "co"},
    {"any number of sts|stitches divisible by", "multiple of"},
    {"a? number of sts|stitches divisible by", "multiple of"},
    {"stitches|sts in multiples of", "multiple of"},
    {"=and =# over and over again?", ""},
    {"=# =rows|rounds|rnds ( # sts|stitches each|per? row|rnd|round? )", ""},
    {",? and # over|extra|additional for? the? edge|edges|end|ends|sides?", "+ #"},
    {",? and # sts|stitches over|extra|additional for? the? edge|edges|end|ends|sides?", "+ #"},
    {"=sts . =,", ""},
    {":|,|;|- # on|to each|a|every needle|pin|wire", ""},
    {":|,|;|- # on|to each of # needles|pins|wires", ""},
    {"any number of sts|stitches that may|will|can|must be? divided|divide by", "multiple of"},
    {"=cast =on the|a|any|your? required|desired|needed|wanted|necessary|correct? number of sts|stitches -|–|—|,? that|which|this|it? should|must? is|be? a =multiple =of", ""},
    {"=cast =on the|a|any|your? required|desired|needed|wanted|necessary|correct? number of sts|stitches -|–|—|,? that|which|this|it? should|must? is|be? =multiple =of", ""},
    {"=cast =on # sts|stitches for each|every pattern|patt|repeat", "multiple of #"},
    {"=cast =on =# =sts|stitches|sts. , # patterns|patts|repeats|reps", ""},

    {"=sts . =loosely|tightly|firmly|and|fairly|rather", ""},

    /* rows again */
    {"=# incl.|incl|inclusive", ""},
    {"up? to|until|till and including =row|rnd|round =#", "to"},
    {"=row|rows|round|rounds|rnd|rnds alternately", ""},
    {"=time|times|twice|once|more|thrice ,? then|and|and then? cast|bind off", "; bind off"},
    {"=time|times|twice|once|more|thrice ,? and cast|bind off", "; bind off"},
    {"=row|rows|round|rounds|rnd|rnds the same", ""},
    {"=row|rows|round|rounds|rnd|rnds in the|this same? way|manner", ""},
    {"=row|rows|round|rounds|rnd|rnds thus|so|likewise", ""},
    {"continue|cont|cont.|work|proceed in|on this|these|the|same? same? way|manner|fashion|lines", "work in patt"},
    {"work|continue|cont|repeat|rep in? the? pattern|patt|pat? st|stitch? until|till # complete|full? repeats|reps|repetitions of the? pattern|patt are|have|has|is been? completed|worked|done|complete|made", "rep them # times in all"},
    {"work|continue|cont|repeat|rep in? the? pattern|patt|pat? st|stitch? until|till # complete|full|pattern? patterns|patts|pattern|repeats|reps are|have|has|is been? completed|worked|done|complete|made", "rep them # times in all"},

    /* within a row */
    {"purl|p the? row? ,|;|-? but|and? knitting|knit the? first|edge and|& the? last # sts|stitches|st?", "k#, p to last # sts, k#"},
    {"knit|k the? row? ,|;|-? but|and? purling|purl the? first|edge and|& the? last # sts|stitches|st?", "p#, k to last # sts, p#"},
    {"purl|p the? row? ,|;|-? but|and? knitting|knit the? first|edge and|& the? last st|stitch", "k1, p to last st, k1"},
    {"knit|k the? row? ,|;|-? but|and? purling|purl the? first|edge and|& the? last st|stitch", "p1, k to last st, p1"},
    {"purl|p , but|and? knitting|knit # edge|border? sts|stitches|st at|on each|either|both end|ends|side|sides|edge|edges", "k#, p to last # sts, k#"},
    {"knit|k , but|and? purling|purl # edge|border? sts|stitches|st at|on each|either|both end|ends|side|sides|edge|edges", "p#, k to last # sts, p#"},
    {"@ all the? sts|stitches? except|but for? the? =last", "to"},
    {"all the? sts|stitches? except|but for? the? =last", "to"},
    {"@ the middle|centre|center =# =sts|stitches", ""},
    {"( r . s .? facing )", "(rs)"},
    {"( w . s .? facing )", "(ws)"},
    {"=:|. right side facing|out ,|.|;|:|-?", "(rs)"},
    {"=:|. wrong side facing|out ,|.|;|:|-?", "(ws)"},
    {"=repeat|rep the same", ""},
    {"all round|around", "around"},
    {"=last =#? =sts|stitches|st ,? which|these? knit|k", ", k to end"},
    {"which knit|k", "k to end"},
    {"which purl|p|pearl|seam", "p to end"},
    {"knit|k over knit|k|knits and|, p|purl over purl|p|purls", "k k st p p st"},
    {"purl|p over purl|p|purls and|, k|knit over knit|k|knits", "k k st p p st"},
    {"knit|k over purl|p|purls and|, p|purl over knit|k|knits", "k p st p k st"},
    {"purl|p over knit|k|knits and|, k|knit over purl|p|purls", "k p st p k st"},
    {"as the? sts|stitches face|appear|come|present you|themselves?", "k k st p p st"},
    {"as facing", "k ks p ps"},

    /* refused by their names */
    {"w|wl|wool .? fwd|fd|forward .?", "wfwd"},
    {"y|yn|yarn .? fwd|fd|f .?", "yfwd"},
    {"w|y . r . n .?", "yrn"},
    {"p . s . s . o .?", "psso"},
    {"t . b . l .?", "tbl"},
    {"m . #", "m#"},
    {"c . # .? f|l .?", "c#f"},
    {"c . # .? b|r .?", "c#b"},
    {"thread|cotton|silk|worsted|wool forward|fwd|over", "yfwd"},

    /* fabrics */
    {"st. - st.|st", "st st"},
    {"g. - st.|st", "g st"},
    {"=beg|begin|beginning|start|starting|commencing purl|p =,|row|rows", "on p"},
    {"beg|begin|start purl =, =work", "beg on p"},
    {"beginning|starting|commencing purl", "beg with p"},
    {"in rib|ribbing of", "in"},

    /* a fabric changed to, and with which row it begins */
    {"=needles|needle|mm ,|;? and =in =st|stocking|stockinette =st|stitch ,? =work =#", "."},
    {"change|changing|cont|continue|proceed to|in|into|with stocking|stockinette|st st|stitch ,? and? ,? beg|beginning|start|starting|commencing with a? k|knit row ,? and? work # rows", "beg with k, work # rows st st"},
    {"change|changing|cont|continue|proceed to|in|into|with stocking|stockinette|st st|stitch ,? and? ,? beg|beginning|start|starting|commencing with a? p|purl row ,? and? work # rows", "beg with p, work # rows st st"},
    {"=beg|begin|beginning|start|starting|commencing =with =a|an? =k|p|knit|purl =row , =for|until|till", ""},
    {"! now|next|then =,? =beg|begin|beginning|start|starting|commencing =with =a|an? =k|p|knit|purl =row", ""},
    {"=work # rows in|of knit|plain stitch|stitches|st again?", "# rows garter"},

    /* rows told, and how often they are worked */
    {"work them =#|twice|once|thrice =times|time|x? =more|again", "rep them"},
    {"work them =#|once =more =times|time", "rep them"},
    {"=them|pattern|patt|pat until|till # pattern|patt|pat rows|rounds|rnds have|has|are|is been? worked|completed|complete|done|knitted", "for a total of # rows"},

    /* what is said above them */
    {"=row|rnd|round =# : right side :", "(RS):"},
    {"=row|rnd|round =# ( rs ,? and|& all|every|each other|following? rs rows|row )", "(RS) and all RS rows"},
    {"=row|rnd|round =# ( ws ,? and|& all|every|each other|following? ws rows|row )", "(WS) and all WS rows"},
    {"=row|rnd|round =# : wrong side :", "(WS):"},
    {"=# =st|nd|rd|th =row|rnd|round : right side :", "(RS):"},
    {"=# =st|nd|rd|th =row|rnd|round : wrong side :", "(WS):"},
    {"^ =row repeat|multiple =: =# =times|x|more", "rep"},
    {"^ row repeat|multiple : =# =rows?", "note:"},
    {"^ # sts|stitches cast|casted on =.?", "co #"},
};
const int turns_of_books_number = sizeof turns_of_books / sizeof *turns_of_books;
