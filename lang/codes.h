/* SPDX-License-Identifier: GPL-3.0-or-later
 * The one table of message codes.  A code never changes its meaning and is
 * never used again; the manual has a paragraph for each.  Codes from 900 are
 * warnings and print as W0901, the others as E0101. */
#ifndef WEFT_CODES_H
#define WEFT_CODES_H

#define DIAG_CODES(X)                                                                                         \
    /* reading a file */                                                                                      \
    X(CODE_SYNTAX,          101, "the text is not what the language expects at this place")                   \
    X(CODE_CHARACTER,       102, "a character that has no meaning here")                                      \
    X(CODE_STRING,          103, "a string without its closing quote")                                        \
    X(CODE_NUMBER,          104, "a number that cannot be represented, or with an unknown unit")              \
    X(CODE_NOT_A_SCRIPT,    105, "the file is empty, binary, or of another format")                           \
    X(CODE_VERSION,         106, "a language version this weft does not know, or not at the top")             \
    X(CODE_STATEMENT,       107, "a line that begins like no statement")                                      \
    X(CODE_UNCLOSED,        108, "a bracket that is never closed, or closed without being open")              \
    X(CODE_PLACE,           109, "a statement where it cannot stand")                                         \
    /* names and values */                                                                                    \
    X(CODE_UNKNOWN_NAME,    201, "a name nothing was given")                                                  \
    X(CODE_TWICE,           202, "a name or key given twice")                                                 \
    X(CODE_TYPE,            203, "a value of the wrong type")                                                 \
    X(CODE_RANGE,           204, "a value outside the allowed range")                                         \
    X(CODE_NOT_FINITE,      205, "a calculation without a finite result")                                     \
    X(CODE_UNIT,            206, "units that do not go together")                                             \
    X(CODE_ARGUMENTS,       207, "too few, too many or wrongly named arguments")                              \
    X(CODE_CYCLE,           208, "a definition that needs itself")                                            \
    X(CODE_WHOLE,           209, "a whole number is needed")                                                  \
    /* written rows */                                                                                        \
    X(CODE_STITCH,          301, "a word that is no stitch")                                                  \
    X(CODE_SHAPING,         302, "a stitch that changes the stitch count or the topology")                    \
    X(CODE_ROW_COUNT,       303, "a row that works more or fewer stitches than there are")                    \
    X(CODE_ROW_FIT,         304, "a row whose repeat does not come out even")                                 \
    X(CODE_ROW_ASSERT,      305, "a count in brackets that is not the row's")                                 \
    X(CODE_ROW_NUMBER,      306, "row numbers that leave a gap, repeat or go back")                           \
    X(CODE_ROW_SIDE,        307, "a row marked RS or WS that falls on the other side")                        \
    X(CODE_ROW_ROUND,       308, "rows and rounds in one fabric")                                             \
    X(CODE_ROW_REPEAT,      309, "a repeat that cannot stand there, or that can be read in two ways")         \
    X(CODE_ROW_WIDTH,       310, "rows whose width is open or contradictory")                                 \
    X(CODE_CAST_ON,         311, "a cast-on in the wrong place, or twice")                                    \
    X(CODE_ROW_REFERENCE,   312, "a row that is not there")                                                   \
    X(CODE_ELSEWHERE,       313, "a part of a row that is said elsewhere")                                    \
    X(CODE_MANY_SIZES,      314, "numbers for several sizes in a row")                                        \
    /* motifs, charts and fabrics */                                                                          \
    X(CODE_FIT,             401, "a width that is not a multiple of the motif")                               \
    X(CODE_SIZES,           402, "fabrics of different width or height put together")                         \
    X(CODE_CHART,           403, "a chart with ragged lines, wrong numbers or an unknown symbol")             \
    X(CODE_EMPTY_MOTIF,     404, "a motif without a stitch")                                                  \
    X(CODE_MIXED_MOTIF,     405, "a chart and rows, or two charts, in one motif")                             \
    X(CODE_NO_SWATCH,       406, "no fabric to fold")                                                         \
    X(CODE_TWO_SWATCHES,    407, "more than one fabric to fold")                                              \
    X(CODE_MULTIPLE,        408, "a motif that does not agree with its multiple")                             \
    X(CODE_OUTSIDE,         409, "a part that does not lie inside the whole")                                 \
    /* blocks */                                                                                              \
    X(CODE_UNKNOWN_KEY,     501, "a key the block does not have")                                             \
    X(CODE_WORD,            502, "a word the key does not know")                                              \
    /* files, outputs, command line */                                                                        \
    X(CODE_USE,             601, "a file or motif to use that is not found")                                  \
    X(CODE_USE_CYCLE,       602, "files that use each other in a circle")                                     \
    X(CODE_OUTPUT,          603, "an output whose kind is unknown or does not fit its name")                  \
    X(CODE_DEFINE,          604, "an override of something the script does not have")                         \
    X(CODE_SWEEP,           605, "a sweep that cannot be run")                                                \
    /* limits */                                                                                              \
    X(CODE_LIMIT_FILE,      701, "the file is too long")                                                      \
    X(CODE_LIMIT_LINE,      702, "a line is too long")                                                        \
    X(CODE_LIMIT_NESTING,   703, "brackets or blocks nested too deep")                                        \
    X(CODE_LIMIT_DEPTH,     704, "an expression nested too deep")                                             \
    X(CODE_LIMIT_CALLS,     705, "definitions that use each other too deep")                                  \
    X(CODE_LIMIT_INCLUDES,  706, "files that use files too deep")                                             \
    X(CODE_LIMIT_STITCHES,  707, "a fabric of too many stitches")                                             \
    X(CODE_LIMIT_ROWS,      708, "a fabric of too many rows")                                                 \
    X(CODE_LIMIT_STEPS,     709, "a script that takes too long to evaluate")                                  \
    X(CODE_LIMIT_NAMES,     710, "too many names, or too long a name")                                        \
    X(CODE_LIMIT_LIST,      711, "too long a list, range or sweep")                                           \
    X(CODE_LIMIT_STITCHDEF, 712, "too many kinds of stitches")                                                \
    X(CODE_LIMIT_OUTPUTS,   713, "too many outputs")                                                          \
    X(CODE_LIMIT_ERRORS,    714, "too many errors, warnings, statements or lines of text: a file is read no further") \
    /* charts from elsewhere */                                                                               \
    X(CODE_RAGGED,          801, "a row of a chart file that is longer or shorter than the first")            \
    X(CODE_BLANK_ROW,       802, "an empty line among the rows of a chart file")                              \
    X(CODE_CHART_MARK,      803, "a mark in a chart file that stands for no stitch")                          \
    X(CODE_LOWER_CASE,      804, "a small letter where a chart file has capitals")                            \
    X(CODE_CHART_HEADER,    805, "a header of a chart file that is no two numbers, or in the wrong place")    \
    X(CODE_NO_STITCH,       806, "a chart file without a stitch")                                             \
    X(CODE_COLOUR,          807, "a pixel of a colour the key does not have")                                 \
    X(CODE_PICTURE,         808, "a picture that cannot be read")                                             \
    X(CODE_KNITOUT,         809, "a line of a knitout file that is no operation, or that no machine can do")  \
    X(CODE_NOT_PLAIN,       810, "a knitout operation that makes something else than plain knit and purl")    \
    /* warnings */                                                                                            \
    X(CODE_AMBIGUOUS_NAME,  901, "a name that means different things in different countries")                 \
    X(CODE_REPEAT_NO_COUNT, 902, "a repeat of rows without a number")                                         \
    X(CODE_KNITOUT_NEWER,   903, "a knitout file of a later version than this weft knows")                   \
    X(CODE_PROSE,           904, "lines that are read as text, not as a part of the pattern")                 \
    X(CODE_FIRST_SIZE,      905, "several sizes, of which the first is taken")                                \
    X(CODE_ASSUMED_WIDTH,   906, "rows without a cast-on, over some repeats of their multiple")               \
    X(CODE_ASSUMED_REPEAT,  907, "a repeat in a row whose beginning is not marked")                           \
    X(CODE_ASSUMED_TOTAL,   908, "rows worked so often, by which the first time may be meant or not")   \
    X(CODE_SECOND_PART,     909, "rows that begin again at 1: a second part")                              \
    X(CODE_KNITOUT_EXTENSION, 910, "an extension of knitout that is not read")                             \
    X(CODE_LAST_REPEAT,     911, "a repeat whose last time is taken to stop short")                        \
    X(CODE_IN_PATTERN,      912, "a row worked 'in pattern', by the rows above") \
    X(CODE_LENGTH,          913, "a length, of so many rows by the stated gauge") \
    X(CODE_ROWS_ABOVE,      914, "more rows that are said to be the pattern than are above") \
    X(CODE_WRONG_SIDE,      915, "a row 1 that falls on the wrong side, with no side said of it") \
    X(CODE_EDGES,           916, "edges that are kept beside the rows below") \
    X(CODE_ALL_GIVEN,       917, "a text for all rows of a kind, each of which is given") \
    X(CODE_END_SIDE,        918, "rows that are said to end on the other side")

enum diag_code {
#define X(name, number, about) name = number,
    DIAG_CODES(X)
#undef X
};

#endif
