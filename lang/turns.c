/* SPDX-License-Identifier: GPL-3.0-or-later
 * Tables: turns of phrase of pages and of printed books, and what they are plainly (phrases.h says how to read it). */
#include "lang/turns.h"

const struct phrase turns_of_pages[] = {
    /* to the end */
    {"all? the? rest|remainder of the|this? row|round|rnd|sts|stitches|way", "to end"},
    {"@ the rest|remainder", "to end"},
    {"@ all? the? rem|remaining =# sts|stitches", ""},
    {"@ all? the? rem|remaining sts|stitches", "to end"},
    {"all the way across|along|around|round", "to end"},
    {"all the way to the? end", "to end"},
    {"each|every st|stitch across|around|to the? end", "to end"},
    {"across|around the? row|round|rnd? until|till|to =#|there|just|only|you", "until"},

    /* to so many stitches before it */
    {"until|till you get|come to the? =last", "to"},
    {"until|till you get|come to the? end", "to end"},
    {"until|till you reach the? =last", "to"},
    {"until|till you reach the? end", "to end"},
    {"until|till you have just|only? =#", "until"},
    {"until|till there are|is just|only? =#", "until"},
    {"until|till just|only =#", "until"},
    {"st|sts|stitch|stitches are|is left|remaining", "sts rem"},

    /* so many stitches */
    {"@ the? next|first|last|following =# =sts|stitches|st|stitch", ""},
    {"@ the? first|last|next st|stitch", "1"},

    /* a repeat */
    {"rep.|rpt", "rep"},
    {"(|[ =knit|k|purl|p =all? =the =knits|knit|k|purls|purl|p =sts|stitches? =,? =and? =purl|p|knit|k =all? =the? =purls|purl|p|knits|knit|k =sts|stitches? )|]", ""},
    {"(|[ work all? the? sts|stitches as they appear|come|lie|face )|]", "k k st p p st"},
    {"( =# =times )", ""},
    {"repeat|rep to|until|till desired|required|wanted|needed", "rep as desired"},
    {"=repeat|rep between|within|inside? the? parentheses|brackets", ""},
    {"=repeat|rep these|those|the # stitches|sts", ""},

    {"alternately|alternating =to|across|around", ""},
    {"and continue =to|across|around", "rep"},
    {"=# =rows|rounds|rnds total|altogether", ""},

    /* whole rows */
    {"work all? the? sts|stitches as they appear|come|lie", "k k st p p st"},
    {"work all? the? sts|stitches as they face|present you|themselves", "k k st p p st"},
    {"work all? the? sts|stitches as set|established|est", "k k st p p st"},
    {"@ a =row|round|rnd", "1"},
    {"=work a =row|round|rnd", "1"},
    {"=row|rows|round|rounds|rnd|rnds number|no.|no|nr.|nr|~ =#", ""},
    {"=# above|again", ""},
    {"step =# =:|.|)", ""},
    {"< pattern|patt|pat =row|rows|round|rounds|rnd|rnds =#", ""},
    {"=repeat|rep rows|rounds|rnds =until|till|to|as", "them"},
    {"continue|cont|keep|by repeating =rows|rounds|rnds|row|these|this|the|last", "repeat"},
    {"continue|cont to repeat|rep =rows|rounds|rnds|row|these|this|the|last", "repeat"},
    {"rows|rounds|rnds # -|to|and|through # form|make|set|complete|create|establish", "row forms"},
    {"st - st", "st st"},
    {"g - st", "g st"},
    {"=stocking|stockinette|garter|moss|seed|rev|reverse - =st|stitch|stocking|stockinette", ""},
    {"=repeat|rep the? above =row|rows|round|rounds|rnd|rnds", "these"},
    {"like =row|rows|round|rnd|rounds|rnds", "as"},
    {"=work|cont|continue =in rib|ribbing for a? further? =# =rows|rounds|rnds|row", "pat for"},
    {"=in rib|ribbing =for a further =#", ""},
    {"=for a further =#", ""},

    {"=work|cont|continue|knit even|straight =for =# =rows|rounds|rnds", ""},
    {"=# =row|rows|round|rounds|rnd|rnds , and|then? then? =knit|purl|k|p|work =#", "."},
    {"as given? above|before", ""},
    {"and then? =cast|bind =off", "."},
    {"=: cont|continue|keep =in", "work"},
    {"; =co|cast =on? =#", "\n"},

    /* the next rows */
    {"^ for|on|over|the|following the? next|following? =# =rows|rounds|rnds ,|:", "next"},
    {"< =work|knit|purl|k|p the? next =# =rows|rounds|rnds", ""},
    {"< next =# =rows|rounds|rnds :|,? work|cont|continue? in|as the? est|established? pattern|patt|pat|set|established as? set|established?", "work"},
    {"< next row|round|rnd (? rs|ws? )? :|, work|cont|continue? in|as the? est|established? pattern|patt|pat|set|established as? set|established?", "work 1 row"},
    {"< work|knit|make =# garter? =ridge|ridges", "work"},

    /* a row named by its side */
    {"> on the? =next =row|rnd|round", ""},
    {"> on? the? following row", "next row"},
    {"> on? the? next|following rs|right -? side? row", "row (RS)"},
    {"> on? the? next|following ws|wrong -? side? row", "row (WS)"},
    {"> on =all|every|each =rs|ws|right|wrong|even|odd|other|alternate|alt? =-? =side? =row|rows|rnd|rnds|round|rounds", ""},
    {"> on =rs|ws|right|wrong =-? =side? =rows", ""},
    {"^ =# garter =ridge|ridges", ""},

    /* other spellings */
    {"c / o =#", "co"},
    {"b / o", "bo"},
    {"^ b . o .?", "bo"},
    {"^ c . o .? =#", "co"},
    {"( r . s .? =)", "( rs"},
    {"( w . s .? =)", "( ws"},
    {"=sts .? =on|with|using =#|a|the|two|no|size", ""},
    {"=row on the? =rs|ws|wrong|right", ""},
    {"=more|times|time|twice|once , =ending|finishing =with|on|after", ""},
    {"of|from the? stitch|st? pattern|patt|pat =#|twice|once|until", ""},
    {"=times|time ,? for a total of # pattern|patt? repeats", ""},
    {"=then , =row|rows|rnd|rnds|round|rounds", ""},
    {"repeated =to|until|across|from", "rep"},
    {"pearl|perl knitting", "purl"},
    {"pearl|perl =#", "purl"},
    {"plain knitting", "knit"},
    {"( =rep|repeat =from =* =# =times )", ""},
    {"( place marker )", ""},
    {"any number of sts|stitches that can be divided|divisible by", "multiple of"},
    {"con - =#|a|an|multiple|multiples|odd|even|any", "con"},
    {"alternative =row|rows|rnd|rnds|round|rounds", "alternate"},
    {"=row|rows|rnd|rnds|round|rounds =# =&|and row|rnd|round =#", ""},
    {"=repeat|rep pattern|patt|pat|chart stitch|st? =row|rows|rnd|rnds|round|rounds =#", ""},
    {"for pattern|patt|pat =until|till", ""},
    {"repeating =to|across|until|from", "rep"},
    {"=work|continue|cont|knit as established|est", "in patt"},

    /* so many more times */
    {"another|again|further|additional|extra # times|x|time", "# more times"},
    {"a|an|for|yet another|further|additional|extra # times|x|time", "# more times"},
    {"# additional|further|other|extra times", "# more times"},
    {"( =# =x )", ""},
    {"=rep|repeat this|the # -? row|rows|round|rnd -? repeat|pattern|patt|pat|section|sequence", "these # rows"},
    {"=rep|repeat the? above|preceding|previous # =rows|rounds|rnds", "last #"},
    {"=row|rows|rounds|rnds to create|make|get|continue|complete|produce|build", "until"},

    {"=knit|k =# =rows in? garter|g st|stitch?", ""},
    {"=knit|purl|k|p =all? =the? =k|p|knit|purl|knits|purls =sts|stitches|st? as they appear|come|lie|present|face you|themselves|up?", ""},
    {"=# =rows|rounds|rnds for a|the|your? top|bottom? garter|seed|moss? st|stitch? border|edging|edge|hem", ""},
    {"approximately|approx.|approx|about|roughly =#", ""},
    {"from|above|after the|your? cast on|- on? edge|row?", ""},
    {"from|above|after the|your? cast-on|co edge|row|round", ""},
    {"=# ins.|in.|cm.|cms. =(|from|or|and|ending|,", ""},
    {"( # ins.|in.|cm.|cms. )", ""},
    {"unless otherwise|else stated|noted|indicated|specified|instructed|directed", ""},
    {"=# =rows|rounds|rnds - =garter|seed|moss|stockinette", ""},
    {"^ repeats : =#", "notes:"},

    {"( =repeat|rep =to =the? =end )", ""},
    {"< =knit|purl the? # st|nd|rd|th row|round|rnd =.|,", "1 row"},
    {"=all|every|each =ws|even =rows|row are|is purled|purl", ": purl"},
    {"all|every|each wrong side rows|row are|is purled|purl", "WS rows: purl"},
    {"< purl all|every|each ws row|rows", "WS rows: purl"},
    {"< purl all|every|each wrong -? side row|rows", "WS rows: purl"},
    {"< purl all|every|each even row|rows", "even rows: purl"},
    {"< knit row # =.|,", "row #:k"},
    {"< purl row # =.|,", "row #:p"},
    {"< knit rnd|round # =.|,", "rnd #:k"},
    {"< purl rnd|round # =.|,", "rnd #:p"},
    {"uneven =-|rows|rnds|rounds|numbered", "odd"},
    {"^ front side =:", "rs"},
    {"^ back side =:", "ws"},

    /* a repeat that goes on */
    {"continue|cont =from =the? =*", "rep"},
    {"=,|; continue|cont =to|until|till =the? =end|last", "rep"},
    {"=to|until =the? =end of the? needle|needles", ""},
    {"til|'til =the? =end|last", "to"},
    {"=to|until|till =the? bor|eor marker|m?", "end"},
    {"=to|until|till =the? beginning|start|end of the? row|round|rnd marker|m", "end"},
    {"=# ( # ) =times|more|x", ""},

    /* what is cast on, and by whom */
    {"^ ~ of stitches|sts to? cast|co on? :|- =#", "co"},
    {"^ number|no|no. of stitches|sts to? cast|co? on? :|- =#", "co"},
    {"^ stitches|sts to cast|co on? :|- =#", "co"},
    {"=cast -? =on stitches|sts|count|number : =#", ""},
    {"^ i|we|you|i've =cast|casted =on =#", ""},
    {"=cast -? =on ( =# =sts|stitches )", ""},
    {"=cast -? =on =# m|ms|masks|maske|loops", ""},
    {"=co =# m|ms|masks|maske|loops", ""},
    {"# edge|selvedge|selvage m|ms", "k#"},
    {"=last =# m|ms", ""},
    {"=last m", "1"},
    {"=until|till =# m|ms =remain|remains|rem|left", ""},

    /* some stitches of a fabric */
    {"=seed|moss|garter|stockinette|stocking|st|g =st|stitch|sts? over|for|across the? next|first|last|following|center|centre? =# =sts|stitches|st", ""},
    {"work # sts|stitches in moss st|stitch?", "moss #"},
    {"work # sts|stitches in seed st|stitch?", "seed #"},
    {"work # sts|stitches in garter st|stitch?", "garter #"},
    {"work # sts|stitches in stockinette|stocking|st st|stitch?", "stockinette #"},

    /* widths */
    {"any =multiple =of", ""},
    {"multiples of", "multiple of"},
    {"mult. of", "mult of"},
    {"a? number of sts|stitches that|is|are? evenly? divisible by", "multiple of"},

    /* counts */
    {"=# =sts|stitches in? total|altogether", ""},
    {"=# =sts|stitches on the? needle|needles", ""},

    /* the last repeat */
    {"=end|ends|ending|finish|finishing =the? =last =rep|repeat after|at|on", ""},
    {"last rep|repeat ends|ending with|at|after|in?", "end last rep"},

    /* a row's neighbour */
    {"=# =rows|rounds|rnds , bind|cast off", "; bind off"},
    {"=# =rows|rounds|rnds and|then bind|cast off", "; bind off"},
    {"=once|twice|times|square|long|length|end|done and|then =bo", ";"},
    {"=# =rows|rounds|rnds , then bind|cast off", "; bind off"},

    /* line ends within */
    {"=end =of =the|this|each? =row|round|rnd", ""},
    {"=until|till|to =the? =end", ""},
    {"=until|till =the|your? =piece|work|it|scarf|cloth|blanket|square|you|swatch", ""},
    {"=until|till|to =desired|required =length", ""},
    {"=# =more =times", ""},
    {"=# =times|sts|stitches", ""},
    {"=to|until =the? =last =#", ""},
    {"=repeat|rep|work =rows|row|round|rounds =#", ""},
    {"=repeat|rep =from|these|this|the|last", ""},
    {"=cast|bind =on|off", ""},
    {"=same|work =as =row", ""},
};
const int turns_of_pages_number = sizeof turns_of_pages / sizeof *turns_of_pages;

const struct phrase turns_of_books[] = {
    /* plain and purl */
    {"=knit|purl|k|p|k.|p. =# plain|purl =row|rows|round|rounds|rnd|rnds|rd|rds", ""},
    {"=knit|k =# =row|rows|round|rounds|rnd|rnds|rd|rds plain", ""},
    {"work|do # plain =row|rows|round|rounds|rnd|rnds|rd|rds", "knit #"},
    {"work|do # purl =row|rows|round|rounds|rnd|rnds|rd|rds", "purl #"},
    {"work|do =# =row|rows|round|rounds|rnd|rnds|rd|rds plain", "knit"},
    {"^ # plain =row|rows|round|rounds|rnd|rnds|rd|rds", "k #"},
    {"^ # purl =row|rows|round|rounds|rnd|rnds|rd|rds", "p #"},
    {"=knit|k plain? for =# =row|rows|round|rounds|rnd|rnds|rd|rds", ""},
    {"knit|k plain =until|till", "k all rows"},
    {"=knit|k plain", ""},
    {"k. =every|each|all =row|rows|round|rounds|rnd|rnds", "k"},
    {"p. =every|each|all =row|rows|round|rounds|rnd|rnds", "p"},
    {"in plain - knitting|knit", "in garter"},
    {"in plain knitting|knit", "in garter"},
    {"plain =#", "k"},
    {"=# plain", "k"},
    {"seam =# =,|;|.|sts|stitches", "p"},

    {"=knit|purl =every|each|all =row|rows|round|rounds plain", ""},
    {", then|and =knit|purl|k|p|k.|p.|work =# =row|rows|round|rounds|rnd|rnds", "."},
    {", and then =knit|purl|k|p|k.|p.|work =# =row|rows|round|rounds|rnd|rnds", "."},
    {",? and? then? finish|end with # plain =row|rows|round|rounds|rnd|rnds", ". knit #"},
    {"set -? up rows|row|rounds|rnds|round : =knit|k|k.|purl|p|p.|work =# =row|rows|round|rounds|rnd|rnds", ""},

    {"=# =ridges|ridge in|of garter|g -? st.|st|stitch", ""},

    /* cast on */
    {"^ set|put up|on =# =sts|stitches", "co"},
    {"any number of sts|stitches divisible by", "multiple of"},
    {"a? number of sts|stitches divisible by", "multiple of"},
    {"stitches|sts in multiples of", "multiple of"},
    {",? and # over|extra|additional for? the? edge|edges|end|ends|sides?", "+ #"},
    {",? and # sts|stitches over|extra|additional for? the? edge|edges|end|ends|sides?", "+ #"},
    {"=sts . =,", ""},
    {":|,|;|- # on|to each|a|every needle|pin|wire", ""},
    {":|,|;|- # on|to each of # needles|pins|wires", ""},
    {"any number of sts|stitches that may|will|can|must be? divided|divide by", "multiple of"},
    {"=cast =on # sts|stitches for each|every pattern|patt|repeat", "multiple of #"},
    {"=cast =on =# =sts|stitches|sts. , # patterns|patts|repeats|reps", ""},

    {"=sts . =loosely|tightly|firmly|and|fairly|rather", ""},

    /* rows again */
    {"=# incl.|incl|inclusive", ""},
    {"=row|rows|round|rounds|rnd|rnds alternately", ""},
    {"=time|times|twice|once|more|thrice ,? then|and|and then? cast|bind off", "; bind off"},
    {"=time|times|twice|once|more|thrice ,? and cast|bind off", "; bind off"},
    {"=row|rows|round|rounds|rnd|rnds the same", ""},
    {"=row|rows|round|rounds|rnd|rnds in the|this same? way|manner", ""},
    {"=row|rows|round|rounds|rnd|rnds thus|so|likewise", ""},
    {"continue|cont|cont.|work|proceed in|on this|these|the|same? same? way|manner|fashion|lines", "work in patt"},
    {"work|continue|cont|repeat|rep until|till # complete? patterns|patts|pattern|repeats are|have|has been? completed|worked|done|complete|made", "rep them # times in all"},

    /* within a row */
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
    {"as the sts|stitches face|appear|come|present you|themselves?", "k k st p p st"},
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
};
const int turns_of_books_number = sizeof turns_of_books / sizeof *turns_of_books;
