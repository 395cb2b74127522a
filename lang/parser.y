/* SPDX-License-Identifier: GPL-3.0-or-later
 * The grammar of .knit: tokens in, syntax tree out.  Actions only call
 * constructors; what a statement means is found out later. */
%require "3.8"
%define api.pure full
%define api.prefix {knit_}
%define api.location.type {struct span}
%define api.token.prefix {TOKEN_}
%define parse.error custom
%define parse.lac full
%locations
%expect 0
%parse-param {struct parse *parse} {void *scanner}
%lex-param   {void *scanner}

%code requires {
#include "lang/parse.h"

/* Lists under construction. */
struct exprs     { struct expr *first, *last; };
struct arguments { struct argument *first, *last; };
struct items     { struct item *first, *last; };
struct pairs     { struct pair *first, *last; };
struct names_at  { struct name_at *first, *last; };
struct formals   { struct formal *first, *last; };
struct symbols   { struct symbol *first, *last; };
struct axes      { struct axis *first, *last; };
struct stmts     { struct stmt *first, *last; };
struct numbers   { struct row_numbers *first, *last; };
}

%code provides {
int knit_lex(KNIT_STYPE *, KNIT_LTYPE *, void *scanner);
}

%code {
#include "lang/expected.h"
#include "lang/limits.h"
#include "lang/syntax.h"

#undef YYMAXDEPTH
#define YYMAXDEPTH LIMIT_PARSER_STACK

/* The span of a rule: from its first piece to its last. */
#define YYLLOC_DEFAULT(all, piece, n)                                                                     \
    ((all) = (n) ? span_join(YYRHSLOC(piece, 1), YYRHSLOC(piece, n))                                      \
                 : (struct span){YYRHSLOC(piece, 0).source, YYRHSLOC(piece, 0).end, YYRHSLOC(piece, 0).end})

#define APPEND(list, node)                                                                                \
    ((list).last = (list).last ? ((list).last->next = (node)) : ((list).first = (node)))

static void knit_error(const struct span *at, struct parse *parse, void *scanner, const char *text)
{
    (void)scanner;
    (void)text;
    syntax_too_deep(parse, *at);
}

#define UNARY(op, whole, a) expr_operation(parse, EXPR_UNARY, whole, op, a, NULL, NULL)
#define BINARY(op, whole, a, b) expr_operation(parse, EXPR_BINARY, whole, op, a, b, NULL)
}

%union {
    struct { double value; int dimension; } number;
    const char *text;
    enum side side;
    bool opposite;
    struct within within;
    const char *marker;
    enum until_kind to_marker;
    struct all all;
    struct fabric fabric;
    struct { int of, plus; } parity;
    struct measure measure;
    struct told told;
    struct kept_edges edges;
    struct starred starred;
    int stars;
    struct expr *expr;
    struct exprs exprs;
    struct argument *argument;
    struct arguments arguments;
    struct item *item;
    struct items items;
    struct until until;
    struct pair *pair;
    struct pairs pairs;
    struct name_at name;
    struct names_at names;
    struct formal *formal;
    struct formals formals;
    struct symbol *symbol;
    struct symbols symbols;
    struct axis *axis;
    struct axes axes;
    struct stmt *stmt;
    struct stmts stmts;
    struct row_numbers *part;
    struct numbers numbers;
    struct range range;
    struct multiple multiple;
    struct row row;
    struct again again;
}

%token END 0            "the end of the text"
%token NEWLINE          "the end of the line"
%token START_FILE       "a script"
%token START_EXPRESSION "a value"

%token <text> NAME      "a name"
%token <text> STRING    "a text in quotes"
%token <number> NUMBER  "a number"
%token <text> SYMBOL    "a chart symbol"
%token <text> CHART_LINE "a line of a chart"

%token KNIT             "'knit'"
%token USE              "'use'"
%token AS               "'as'"
%token FROM             "'from'"
%token LET              "'let'"
%token PARAM            "'param'"
%token STITCH           "'stitch'"
%token MOTIF            "'motif'"
%token MULTIPLE_OF      "'multiple of'"
%token SWATCH           "'swatch'"
%token <text> BLOCK     "a block"
%token OUTPUT           "'output'"
%token SWEEP            "'sweep'"
%token FOR              "'for'"
%token IF               "'if'"
%token ELSE             "'else'"
%token CHART            "'chart'"
%token EACH             "'each'"
%token IN               "'in'"
%token BY               "'by'"
%token MOD              "'mod'"

%token PROSE            "a line of text"
%token <measure> GO_ON            "'continue in pattern'"
%token <told> FORM_PATTERN   "'these rows form the pattern'"
%token BETWEEN          "'in between'"
%token <edges> KEPT_EDGES   "'keep .. stitches at each edge'"
%token <stars> STARS           "stars that mark rows"
%token GROUP_END               "the end of rows in brackets"
%token <starred> REPEAT_STARRED  "'repeat from' the stars"
%token <starred> THEN_STARRED    "'then from' the stars"
%token GO_ON_ROWS       "'continue in pattern for'"
%token <side> STARTING  "'starting with'"
%token REPEAT_THEM      "'repeat them'"
%token REPEAT_ALL       "'repeat everything'"
%token WORK_THEM        "'work these rows'"
%token THEN_ROWS        "'then rows'"
%token THEN_FIRST       "'then the first'"
%token CAST_ON          "'cast on'"
%token SIZES            "further sizes"
%token EDGES            "a border"
%token FEWER            "'less'"
%token <parity> NUMBER_OF "'an even number of'"
%token <side> SETUP            "'set-up row'"
%token <text> PLAIN_ROWS "'knit' or 'purl' so many rows"
%token <text> PLAIN_EVERY "'knit every row'"
%token WORK             "'work'"
%token WORK_ROWS        "'work rows'"
%token WORK_LAST        "'work these'"
%token <fabric> FABRIC  "a fabric's name"
%token FOR_ROWS         "'for' so many rows"
%token IN_FABRIC        "'in' or 'of'"
%token <side> ROW       "'row'"
%token <side> BARE_ROW  "a row's stitches"
%token <side> ROW_WORD  "'rows'"
%token NEXT_ROWS        "'next' so many rows"
%token RIB              "'rib'"
%token RIDGES           "'ridges'"
%token SETUP_ROW        "'set-up row' behind its number"
%token <all> ALL        "'all rows'"
%token <side> SIDE      "RS or WS"
%token <side> WORKED_ON "RS or WS behind a row"
%token <all> AND_ALL    "'and all rows'"
%token <all> ONLY       "which of the rows"
%token AND              "'and'"
%token RANGE            "'-' between row numbers"
%token REPEAT_ROWS      "'repeat rows'"
%token REPEAT_LAST      "'repeat the last'"
%token FOR_PATTERN      "'for pattern'"
%token UNTIL_ROWS       "'until the piece has'"
%token UNTIL_ROW        "'until row'"
%token <measure> WORK_LENGTH  "'work 2 inches in'"
%token <measure> UNTIL_LENGTH     "'until the piece measures'"
%token <number> ENDING_ROW      "'ending with row'"
%token FOR_TOTAL        "'for a total of'"
%token TOTAL            "'in all'"

%token STAR             "'*' in a row"
%token REP_FROM         "'rep from *'"
%token REP              "'repeat'"
%token REP_ALL          "'repeat' without a star"
%token TO_END           "'to end'"
%token TO_FIT           "'to end, ending'"
%token LAST_REPEAT      "'ending last repeat'"
%token TO_LAST          "'to last'"
%token UNTIL            "'until'"
%token REMAIN           "'remain'"
%token <to_marker> TO_MARKER     "'to marker'"
%token <to_marker> BEFORE_MARKER "'before marker'"
%token <marker> MARKER  "a marker"
%token STS              "'sts'"
%token MORE             "'more'"
%token TIMES            "'times'"
%token <number> TWICE   "'twice'"
%token CROSS            "'x' (times)"
%token <number> TIMES_OF "so many times"
%token AS_ROW           "'as row'"
%token <number> AS_NTH_ROW "'as 3rd row'"
%token BUT_END          "'but end'"
%token <within> OF_PATTERN "'work in pattern to the last stitches'"
%token <opposite> AS_BELOW "'knit the knits and purl the purls'"
%token DASH             "'--'"
%token HOLE             "'{' of a number"

%token DOTS             "'..'"
%token LESS_EQUAL       "'<='"
%token GREATER_EQUAL    "'>='"
%token EQUAL            "'=='"
%token UNEQUAL          "'!='"
%token AND_AND          "'&&'"
%token OR_OR            "'||'"
%token LBRACE '{'       "'{'"
%token RBRACE '}'       "'}'"
%token LPAREN '('       "'('"
%token RPAREN ')'       "')'"
%token LBRACKET '['     "'['"
%token RBRACKET ']'     "']'"
%token IS '='           "'='"
%token COMMA ','        "','"
%token COLON ':'        "':'"
%token QUESTION '?'     "'?'"
%token LESS '<'         "'<'"
%token GREATER '>'      "'>'"
%token PLUS '+'         "'+'"
%token MINUS '-'        "'-'"
%token TIMES_SIGN '*'   "'*'"
%token SLASH '/'        "'/'"
%token NOT '!'          "'!'"
%token DOT '.'          "'.'"

%precedence EACH_TAIL
%right '?' ':'
%left OR_OR
%left AND_AND
%left EQUAL UNEQUAL
%left '<' '>' LESS_EQUAL GREATER_EQUAL
%left '+' '-'
%left '*' '/' MOD
%precedence SIGN

%type <expr>      expr postfix primary count
%type <exprs>     exprs exprs_1
%type <argument>  argument
%type <arguments> arguments arguments_1
%type <stmt>      line statement simple if row_statement repeat_statement more_rows work_statement
%type <stmts>     lines
%type <name>      name string kind
%type <names>     names chart_lines
%type <pair>      setting
%type <pairs>     settings block block_opt
%type <formal>    formal
%type <formals>   formals formals_1
%type <multiple>  multiple multiple_opt
%type <range>     range limits
%type <axis>      axis
%type <axes>      axes
%type <symbol>    symbol
%type <symbols>   chart_key symbols
%type <text>      symbol_text
%type <row>       row_head row_body
%type <part>      part
%type <numbers>   parts
%type <side>      row_sides
%type <item>      item element
%type <items>     items elements
%type <until>     until position times
%type <expr>      check
%type <again>     again again_once again_sum again_counted
%type <side>      starting

%%

start:
  START_FILE lines                      { (void)yynerrs; parse->file = $lines.first; }
| START_EXPRESSION expr NEWLINE         { parse->expression = $expr; }
| START_EXPRESSION expr                 { parse->expression = $expr; }
;

lines:
  line                                  { $$ = (struct stmts){$line, $line}; }
| lines[all] newline line               { $$ = $all; if ($line) APPEND($$, $line); }
;

/* Behind a line with an error the next is read afresh. */
newline: NEWLINE                        { yyerrok; };

line:
  %empty                                { $$ = NULL; }
| statement
| PROSE                                 { $$ = ast_stmt(parse, STMT_PROSE, @$); }
| GO_ON                                 { $$ = syntax_goes_on(parse, @$, $GO_ON); }
| STARS                                 { $$ = ast_stmt(parse, STMT_STARS, @$); $$->stars = $STARS; }
| KEPT_EDGES                            { $$ = ast_stmt(parse, STMT_EDGES, @$); $$->edges = $KEPT_EDGES; }
| FORM_PATTERN                          { $$ = stmt_pattern(parse, @$, $FORM_PATTERN); }
| error                                 { $$ = NULL; }
;

statement:
  simple | if | row_statement | repeat_statement | more_rows | work_statement
| work_statement KEPT_EDGES             { $$ = syntax_keeps($1, @2, $2); }
| repeat_statement KEPT_EDGES           { $$ = syntax_keeps($1, @2, $2); }
;

simple:
  KNIT expr                             { $$ = stmt_expr(parse, STMT_VERSION, @$, $expr); }
| USE string                            { $$ = stmt_use(parse, @$, NULL, (struct name_at){0}, $string, false); }
| USE string AS name                    { $$ = stmt_use(parse, @$, NULL, $name, $string, false); }
| USE names FROM string                 { $$ = stmt_use(parse, @$, $names.first, (struct name_at){0}, $string, false); }
| USE names FROM name                   { $$ = stmt_use(parse, @$, $names.first, (struct name_at){0}, $name, true); }
| LET name '=' expr                     { $$ = stmt_let(parse, @$, $name, $expr); }
| PARAM name '=' expr limits            { $$ = stmt_param(parse, @$, $name, $expr, $limits, NULL); }
| PARAM name '=' expr limits string     { $$ = stmt_param(parse, @$, $name, $expr, $limits, $string.name); }
| STITCH name block                     { $$ = stmt_block(parse, STMT_STITCH, @$, $name, $block.first); }
| BLOCK block                           { $$ = stmt_block(parse, STMT_BLOCK, @$, (struct name_at){$BLOCK, @BLOCK, NULL}, $block.first); }
| MOTIF name formals multiple_opt '{' lines '}'
                                        { $$ = stmt_motif(parse, span_join(@1, @4), $name, $formals.first, $4, $lines.first, NULL); }
| MOTIF name formals multiple_opt '=' expr
                                        { $$ = stmt_motif(parse, span_join(@1, @4), $name, $formals.first, $4, NULL, $expr); }
| SWATCH expr                           { $$ = stmt_expr(parse, STMT_SWATCH, @$, $expr); }
| OUTPUT kind string block_opt          { $$ = stmt_output(parse, span_join(@1, @3), $kind, $string, $4.first); }
| SWEEP axes                            { $$ = stmt_sweep(parse, @$, $axes.first); }
| FOR name IN range '{' lines '}'       { $$ = stmt_for(parse, span_join(@1, @4), $name, $range, $lines.first); }
| CHART chart_key '{' chart_lines '}'   { $$ = stmt_chart(parse, span_join(@1, @2), $2.first, $4.first); }
| CAST_ON count sts                     { $$ = stmt_expr(parse, STMT_CAST_ON, @$, $count); }
| CAST_ON count SIZES sts               { $$ = stmt_expr(parse, STMT_CAST_ON, @$, $count); syntax_first_size(parse, @SIZES); }
| CAST_ON multiple                      { $$ = stmt_multiple(parse, $multiple); }
| multiple                              { $$ = stmt_multiple(parse, $multiple); }
;

if:
  IF expr '{' lines '}'                 { $$ = stmt_if(parse, span_join(@1, @2), $expr, $lines.first, NULL); }
| IF expr '{' lines[then] '}' ELSE '{' lines[other] '}'
                                        { $$ = stmt_if(parse, span_join(@1, @2), $expr, $then.first, $other.first); }
| IF expr '{' lines '}' ELSE if[other]  { $$ = stmt_if(parse, span_join(@1, @2), $expr, $lines.first, $other); }
;

name: NAME                              { $$ = (struct name_at){$1, @1, NULL}; };
string: STRING                          { $$ = (struct name_at){$1, @1, NULL}; };
kind: %empty                            { $$ = (struct name_at){0}; } | name;

names:
  name                                  { struct name_at *n = ast_name(parse, @1, $1.name); $$ = (struct names_at){n, n}; }
| names[all] ',' name                   { $$ = $all; APPEND($$, ast_name(parse, @name, $name.name)); }
;

/* ---- headers of motifs and params ---- */

formals:
  %empty                                { $$ = (struct formals){0}; }
| '(' ')'                               { $$ = (struct formals){0}; }
| '(' formals_1 ')'                     { $$ = $2; }
;
formals_1:
  formal                                { $$ = (struct formals){$1, $1}; }
| formals_1[all] ',' formal             { $$ = $all; APPEND($$, $formal); }
;
formal:
  name                                  { $$ = ast_formal(parse, @$, $1.name, NULL); }
| name '=' expr                         { $$ = ast_formal(parse, @$, $1.name, $expr); }
;

multiple_opt: %empty                    { $$ = (struct multiple){.span = @$}; } | multiple;
multiple:
  MULTIPLE_OF count sts                 { $$ = (struct multiple){$count, NULL, @$}; }
| MULTIPLE_OF count[of] sts '+' count[plus] sts
                                        { $$ = (struct multiple){$of, $plus, @$}; }
| MULTIPLE_OF count[of] sts '+' count[plus] sts '+' count[edge] sts
                                        { $$ = (struct multiple){$of, BINARY(OP_ADD, @$, $plus, $edge), @$}; }
| MULTIPLE_OF count[of] sts FEWER count[less] sts
                                        { $$ = (struct multiple){$of, BINARY(OP_SUBTRACT, @$, $of, $less), @$}; }
| MULTIPLE_OF count sts EDGES           { $$ = syntax_parity(parse, @$, 1, 0); (void)$count; }
| NUMBER_OF                             { $$ = syntax_parity(parse, @$, $1.of, $1.plus); }
;
sts: %empty | STS;

limits:
  %empty                                { $$ = (struct range){.span = @$}; }
| IN expr[low] DOTS expr[high]          { $$ = (struct range){$low, $high, NULL, @$}; }
;

range:
  expr                                  { $$ = (struct range){$1, NULL, NULL, @$}; }
| expr[low] DOTS expr[high]             { $$ = (struct range){$low, $high, NULL, @$}; }
| expr[low] DOTS expr[high] BY expr[step] { $$ = (struct range){$low, $high, $step, @$}; }
;

axes:
  axis                                  { $$ = (struct axes){$1, $1}; }
| axes[all] ',' axis                    { $$ = $all; APPEND($$, $axis); }
;
axis: name IN range                     { $$ = ast_axis(parse, $name, $range); };

/* ---- blocks of settings ---- */

block_opt: %empty                       { $$ = (struct pairs){0}; } | block;
block: '{' settings '}'                 { $$ = $settings; };
settings:
  setting                               { $$ = (struct pairs){$1, $1}; }
| settings[all] newline setting         { $$ = $all; if ($setting) APPEND($$, $setting); }
;
setting:
  %empty                                { $$ = NULL; }
| name '=' expr                         { $$ = ast_pair(parse, @name, $name.name, $expr); }
| name '=' '(' expr[a] ',' expr[b] ')'  { $a->next = $b; $$ = ast_pair(parse, @name, $name.name, expr_list(parse, span_join(@3, @7), $a)); }
| error                                 { $$ = NULL; }
;

/* ---- charts ---- */

chart_key:
  %empty                                { $$ = (struct symbols){0}; }
| '(' symbols ')'                       { $$ = $symbols; }
;
symbols:
  symbol                                { $$ = (struct symbols){$1, $1}; }
| symbols[all] ',' symbol               { $$ = $all; APPEND($$, $symbol); }
;
symbol:
  symbol_text '=' symbol_text[stitch]   { $$ = ast_symbol(parse, @1, $1, (struct name_at){$stitch, @stitch, NULL}); };
symbol_text: SYMBOL | STRING;
chart_lines:
  %empty                                { $$ = (struct names_at){0}; }
| chart_lines[all] CHART_LINE           { $$ = $all; APPEND($$, ast_name(parse, @2, $2)); }
;

/* ---- written rows ---- */

row_statement:
  row_head ':' row_body                 { $$ = stmt_row(parse, @$, syntax_row(parse, $row_head, @1, $row_body, @3)); }
| row_head ':' row_body WORKED_ON       { $$ = stmt_row(parse, @$, syntax_row(parse, syntax_sided(parse, $row_head, @4, $4), @1, $row_body, @3)); }
;

row_head:
  ROW row_sides                         { $$ = syntax_head(parse, $ROW, $2, NULL); }
| ROW row_sides parts                   { $$ = syntax_head(parse, $ROW, $2, $parts.first); }
| BARE_ROW                              { $$ = syntax_bare_head(parse, @$, $BARE_ROW); }
| NEXT_ROWS count more ROW_WORD row_sides
                                        { $$ = syntax_head(parse, $ROW_WORD, SIDE_OPEN, NULL); $$.count = $count; $$.starting = $row_sides; }
| ROW row_sides[side] parts SETUP_ROW row_sides[behind]
                                        { $$ = syntax_head(parse, $ROW, $behind ? $behind : $side, $parts.first); $$.setup = true; }
| SIDE ROW parts                        { $$ = syntax_head(parse, $ROW, $SIDE, $parts.first); }
| ALL row_sides                         { $$ = syntax_head(parse, $ALL.round ? SIDE_RS : SIDE_OPEN, $row_sides, ast_row_numbers(parse, @1, NULL, NULL, $ALL.kind)); }
| ALL RANGE count                       { $$ = syntax_head(parse, $ALL.round ? SIDE_RS : SIDE_OPEN, SIDE_OPEN, ast_row_numbers(parse, @1, NULL, $count, $ALL.kind)); }
| ALL parts                             { $$ = syntax_head_only(parse, @ALL, $ALL, $parts.first); }
| SETUP row_sides                       { $$ = syntax_head(parse, $SETUP, $2, NULL); $$.setup = true; }
| SETUP row_sides parts                 { $$ = syntax_head(parse, $SETUP, $2, $parts.first); $$.setup = true; }
;
row_sides:
  %empty                                { $$ = SIDE_OPEN; }
| row_sides[all] SIDE                   { $$ = $SIDE; (void)$all; }
;

parts:
  part                                  { $$ = (struct numbers){$1, $1}; }
| parts[all] ',' part                   { $$ = $all; APPEND($$, $part); }
| parts[all] AND part                   { $$ = $all; APPEND($$, $part); }
| parts[all] ',' AND part               { $$ = $all; APPEND($$, $part); }
| parts[all] AND_ALL                    { $$ = $all; APPEND($$, ast_row_numbers(parse, @2, NULL, NULL, $AND_ALL.kind)); }
;
part:
  count                                 { $$ = ast_row_numbers(parse, @$, $count, NULL, ALL_NONE); }
| count[first] RANGE count[last]        { $$ = ast_row_numbers(parse, @$, $first, $last, ALL_NONE); }
| ALL                                   { $$ = ast_row_numbers(parse, @$, NULL, NULL, $ALL.kind); $$->round = $ALL.round; }
| ALL RANGE count                       { $$ = ast_row_numbers(parse, @1, NULL, $count, $ALL.kind); $$->round = $ALL.round; }
| part[of] ONLY                         { $$ = $of; $$->only = $ONLY.kind; }
| part[of] SIDE                         { $$ = $of; $$->side = $SIDE; }
| part[of] ROW_WORD                     { $$ = $of; $$->round |= $ROW_WORD == SIDE_RS; }
;

row_body:
  elements                              { $$ = (struct row){.item = $1.first}; }
| STAR items                            { $$ = (struct row){.item = syntax_open_star(parse, @STAR, NULL, $items.first)}; }
| STAR items check                      { $$ = (struct row){.item = syntax_open_star(parse, @STAR, NULL, $items.first), .check = $check, .check_span = @check}; }
| elements STAR items                   { $$ = (struct row){.item = syntax_open_star(parse, @STAR, $elements.first, $items.first)}; }
| elements STAR items check             { $$ = (struct row){.item = syntax_open_star(parse, @STAR, $elements.first, $items.first), .check = $check, .check_span = @check}; }
| elements FABRIC                       { $$ = (struct row){.item = $1.first}; $1.last->next = syntax_fabric_stitches(parse, @2, $FABRIC, NULL, (struct until){UNTIL_END, NULL, @2}); }
| elements check                        { $$ = (struct row){.item = $1.first, .check = $check, .check_span = @check}; }
| elements REP_ALL until                { $$ = (struct row){.item = syntax_whole(parse, @2, $1.first, $until, NULL)}; }
| elements REP_ALL until check          { $$ = (struct row){.item = syntax_whole(parse, @2, $1.first, $until, NULL), .check = $check, .check_span = @check}; }
| elements REP_ALL until elements[tail] { $$ = (struct row){.item = syntax_whole(parse, @2, $1.first, $until, $tail.first)}; }
| elements REP_ALL until elements[tail] check
                                        { $$ = (struct row){.item = syntax_whole(parse, @2, $1.first, $until, $tail.first), .check = $check, .check_span = @check}; }
| AS_ROW parts                          { $$ = (struct row){.body = BODY_AS_ROW, .reference = $parts.first}; }
| AS_ROW parts times                    { $$ = (struct row){.body = BODY_AS_ROW, .reference = $parts.first, .times = $times.n}; }
| AS_ROW parts BUT_END items            { $$ = (struct row){.body = BODY_AS_ROW, .reference = $parts.first, .item = $items.first}; }
| AS_ROW parts BUT_END items check      { $$ = (struct row){.body = BODY_AS_ROW, .reference = $parts.first, .item = $items.first, .check = $check, .check_span = @check}; }
| AS_NTH_ROW                            { $$ = (struct row){.body = BODY_AS_ROW, .reference = ast_row_numbers(parse, @1, expr_number(parse, @1, $1.value, 0), NULL, ALL_NONE)}; }
| FABRIC starting                       { $$ = (struct row){.body = BODY_FABRIC, .fabric = $1, .starting = $starting}; }
| FABRIC check                          { $$ = (struct row){.body = BODY_FABRIC, .fabric = $1, .check = $check, .check_span = @check}; }
;

elements:
  element                               { $$ = (struct items){$1, $1}; }
| elements[all] element                 { $$ = $all; APPEND($$, $element); }
;
element:
  item
| STAR items REP_FROM until             { $$ = item_group(parse, ITEM_REP_FROM, @$, $items.first, $until); }
| STAR items STAR until                 { $$ = item_group(parse, ITEM_STARS, @$, $items.first, $until); }
| STAR items STAR REP_FROM until        { $$ = item_group(parse, ITEM_REP_FROM, @$, $items.first, $until); }
| STAR items STAR REP until             { $$ = item_group(parse, ITEM_REP_FROM, @$, $items.first, $until); }
;

items:
  item                                  { $$ = (struct items){$1, $1}; }
| items[all] item                       { $$ = $all; APPEND($$, $item); }
;
item:
  NAME                                  { $$ = item_stitch(parse, @$, $1, NULL, (struct until){.span = @1}); }
| MARKER                                { $$ = item_marker(parse, @$, $MARKER); }
| OF_PATTERN                            { $$ = item_within(parse, @$, $1); }
| AS_BELOW                              { $$ = item_below(parse, @$, $1, (struct until){UNTIL_FIT, NULL, @1}); }
| AS_BELOW position                     { $$ = item_below(parse, @$, $1, $position); }
| NAME position                         { $$ = item_stitch(parse, @$, $1, NULL, $position); }
| FABRIC count sts                      { $$ = syntax_fabric_stitches(parse, @$, $FABRIC, $count, (struct until){.span = @1}); }
| FABRIC position                       { $$ = syntax_fabric_stitches(parse, @$, $FABRIC, NULL, $position); }
| NAME TWICE                            { $$ = item_stitch(parse, @$, $1, NULL, (struct until){UNTIL_TIMES, expr_number(parse, @2, $2.value, 0), @2}); }
| NAME STS                              { $$ = item_stitch(parse, @$, $1, NULL, (struct until){.span = @1}); }
| NAME NUMBER sts                       { $$ = item_stitches(parse, @$, $1, @2, $2.value); }
| NAME NUMBER position                  { $$ = item_stitch(parse, @$, $1, expr_number(parse, @2, $2.value, 0), $position); }
| NAME HOLE expr '}' sts                { $$ = item_stitch(parse, @$, $1, $expr, (struct until){.span = @1}); }
| NAME count TIMES                      { $$ = item_stitch(parse, @$, $1, NULL, (struct until){UNTIL_TIMES, $count, span_join(@2, @3)}); }
| '(' items ')' until                   { $$ = item_group(parse, ITEM_GROUP, @$, $items.first, $until); }
| '[' items ']' until                   { $$ = item_group(parse, ITEM_GROUP, @$, $items.first, $until); }
| TIMES_OF '(' items ')'                { $$ = item_group(parse, ITEM_GROUP, @$, $items.first, (struct until){UNTIL_TIMES, expr_number(parse, @1, $1.value, 0), @1}); }
| TIMES_OF '[' items ']'                { $$ = item_group(parse, ITEM_GROUP, @$, $items.first, (struct until){UNTIL_TIMES, expr_number(parse, @1, $1.value, 0), @1}); }
| '(' items ')' REP until               { $$ = item_group(parse, ITEM_STARS, @$, $items.first, $until); }
| '[' items ']' REP until               { $$ = item_group(parse, ITEM_STARS, @$, $items.first, $until); }
;

until:
  %empty                                { $$ = (struct until){.span = @$}; }
| position
| times
;
position:
  TO_END                                { $$ = (struct until){UNTIL_END, NULL, @$}; }
| TO_FIT                                { $$ = (struct until){UNTIL_FIT, NULL, @$}; }
| LAST_REPEAT                           { $$ = (struct until){UNTIL_LAST_REPEAT, NULL, @$}; }
| TO_LAST STS                           { $$ = (struct until){UNTIL_LAST, expr_number(parse, @$, 1, 0), @$}; }
| TO_LAST count sts                     { $$ = (struct until){UNTIL_LAST, $count, @$}; }
| UNTIL count sts REMAIN                { $$ = (struct until){UNTIL_LAST, $count, @$}; }
| TO_MARKER                             { $$ = (struct until){$TO_MARKER, NULL, @$}; }
| UNTIL count sts BEFORE_MARKER         { $$ = (struct until){$BEFORE_MARKER, $count, @$}; }
;
times:
  count TIMES                           { $$ = (struct until){UNTIL_TIMES, $count, @$}; }
| count MORE TIMES                      { $$ = (struct until){UNTIL_MORE, $count, @$}; }
| count TIMES MORE                      { $$ = (struct until){UNTIL_MORE, $count, @$}; }
| CROSS count                           { $$ = (struct until){UNTIL_TIMES, $count, @$}; }
| TWICE                                 { $$ = (struct until){UNTIL_TIMES, expr_number(parse, @1, $1.value, 0), @$}; }
| TWICE MORE                            { $$ = (struct until){UNTIL_MORE, expr_number(parse, @1, $1.value, 0), @$}; }
;

check:
  '(' count STS remain ')'              { $$ = $count; }
| '[' count STS remain ']'              { $$ = $count; }
| '(' count ')'                         { $$ = $count; }
| DASH count STS remain                 { $$ = $count; }
;
remain: %empty | REMAIN;

count:
  NUMBER                                { $$ = expr_number(parse, @$, $1.value, $1.dimension); }
| HOLE expr '}'                         { $$ = $expr; }
;

repeat_statement:
  REPEAT_ROWS parts again               { $$ = stmt_again(parse, @$, syntax_again($parts.first, NULL, $again)); $$->again.onwards = syntax_onwards(parse, @$, $parts.first); }
| REPEAT_LAST count ROW_WORD IN_FABRIC FABRIC again
                                        { $$ = stmt_again(parse, @$, syntax_again(NULL, $count, $again)); }
| REPEAT_LAST count ROW_WORD again      { $$ = stmt_again(parse, @$, syntax_again(NULL, $count, $again)); }
| REPEAT_LAST ROW_WORD again            { $$ = stmt_again(parse, @$, syntax_again(NULL, expr_number(parse, @2, 1, 0), $again)); }
| REPEAT_THEM again                     { $$ = stmt_again(parse, @$, $again); $$->again.which = AGAIN_THEM; }
| REPEAT_ALL again                      { $$ = stmt_again(parse, @$, $again); $$->again.which = AGAIN_LAST; }
| GROUP_END again                       { $$ = stmt_again(parse, @$, syntax_group(syntax_work_again(NULL, $again))); }
| REPEAT_STARRED again                  { $$ = stmt_again(parse, @$, syntax_starred($REPEAT_STARRED, $again)); }
| WORK_LAST count ROW_WORD again        { $$ = stmt_again(parse, @$, syntax_work_again(NULL, $again)); $$->again.which = AGAIN_LAST; $$->again.last = $count; }
| WORK_THEM again                       { $$ = stmt_again(parse, @$, syntax_work_again(NULL, $again)); $$->again.which = AGAIN_THEM; }
| GO_ON_ROWS count more ROW_WORD pattern
                                        { $$ = stmt_again(parse, @$, syntax_go_on(@$, $count)); }
| GO_ON_ROWS count more ROW_WORD TOTAL  { $$ = stmt_again(parse, @$, syntax_go_on(@$, $count)); $$->again.kind = AGAIN_UNTIL_ROWS; }
| WORK count more ROW_WORD TOTAL           { $$ = stmt_again(parse, @$, syntax_go_on(@$, $count)); $$->again.kind = AGAIN_UNTIL_ROWS; }
| WORK count more ROW_WORD MORE         { $$ = stmt_again(parse, @$, syntax_go_on(@$, $count)); }
| WORK FOR_ROWS count more ROW_WORD     { $$ = stmt_again(parse, @$, syntax_go_on(@$, $count)); }
| WORK_ROWS parts again                 { $$ = stmt_again(parse, @$, syntax_work_again($parts.first, $again)); }
;
more_rows:
  WORK count more ROW_WORD              { $$ = stmt_again(parse, @$, syntax_go_on(@$, $count)); }
| WORK count more ROW_WORD KEPT_EDGES   { $$ = syntax_keeps(stmt_again(parse, @$, syntax_go_on(@$, $count)), @KEPT_EDGES, $KEPT_EDGES); }
;
pattern: %empty | FOR_PATTERN;
again:
  again_once
| again[all] THEN_ROWS parts again_once[then]
                                        { $$ = $all; syntax_then(parse, &$$, @THEN_ROWS, syntax_again($parts.first, NULL, $then)); }
| again[all] THEN_STARRED again_once[then]
                                        { $$ = $all; syntax_then(parse, &$$, @THEN_STARRED, syntax_starred($THEN_STARRED, $then)); }
| again[all] THEN_FIRST count[n] ROW_WORD again_once[then]
                                        { $$ = $all; syntax_then(parse, &$$, @THEN_FIRST, syntax_again(syntax_first_rows(parse, @n, $n), NULL, $then)); }
;
again_once:
  %empty                                { $$ = (struct again){.kind = AGAIN_PATTERN}; }
| FOR_PATTERN                           { $$ = (struct again){.kind = AGAIN_PATTERN, .pattern = true}; }
| again_sum
| again_sum ENDING_ROW                  { $$ = $again_sum; $$.ending = (int)$ENDING_ROW.value; }
| ',' again_sum                         { $$ = $again_sum; }
| again_sum FOR_PATTERN                 { $$ = $again_sum; }
| FOR_PATTERN again_sum                 { $$ = $again_sum; }
| FOR_PATTERN ',' again_sum             { $$ = $again_sum; }
;
again_sum:
  again_counted
| again_counted IN_FABRIC count ROW_WORD { $$ = $again_counted; $$.sum = $count; }
| again_counted IN_FABRIC count ROW_WORD TOTAL { $$ = $again_counted; $$.sum = $count; $$.sum_of = SUM_PIECE; }
| again_counted IN_FABRIC count TIMES   { $$ = $again_counted; $$.sum = $count; $$.sum_of = SUM_TIMES; }
;
again_counted:
  count TIMES                           { $$ = (struct again){.kind = AGAIN_TIMES, .n = $count}; }
| count MORE TIMES                      { $$ = (struct again){.kind = AGAIN_TIMES, .n = $count, .more = true}; }
| count TIMES MORE                      { $$ = (struct again){.kind = AGAIN_TIMES, .n = $count, .more = true}; }
| TWICE                                 { $$ = (struct again){.kind = AGAIN_TIMES, .n = expr_number(parse, @1, $1.value, 0)}; }
| TWICE MORE                            { $$ = (struct again){.kind = AGAIN_TIMES, .n = expr_number(parse, @1, $1.value, 0), .more = true}; }
| UNTIL_ROWS count ROW_WORD total       { $$ = (struct again){.kind = AGAIN_UNTIL_ROWS, .n = $count}; }
| UNTIL_ROW count                       { $$ = (struct again){.kind = AGAIN_UNTIL_ROWS, .numbered = true, .n = $count}; }
| UNTIL_LENGTH                          { $$ = syntax_again_until(parse, @$, $1); }
| CROSS count                           { $$ = (struct again){.kind = AGAIN_TIMES, .n = $count}; }
| CROSS count MORE                      { $$ = (struct again){.kind = AGAIN_TIMES, .n = $count, .more = true}; }
| FOR_ROWS count more ROW_WORD          { $$ = (struct again){.kind = AGAIN_ROWS, .n = $count, .more = @more.start < @more.end}; }
| FOR_ROWS count more ROW_WORD TOTAL    { $$ = (struct again){.kind = AGAIN_TOTAL_ROWS, .n = $count}; }
| FOR_TOTAL count ROW_WORD              { $$ = (struct again){.kind = AGAIN_TOTAL_ROWS, .n = $count}; }
| FOR_TOTAL count TIMES                 { $$ = (struct again){.kind = AGAIN_TOTAL, .n = $count}; }
| count TIMES TOTAL                     { $$ = (struct again){.kind = AGAIN_TOTAL, .n = $count}; }
| TWICE TOTAL                           { $$ = (struct again){.kind = AGAIN_TOTAL, .n = expr_number(parse, @1, $1.value, 0)}; }
;

work_statement:
  PLAIN_ROWS count more ROW_WORD        { $$ = stmt_row(parse, @$, syntax_plain_rows(parse, @$, @1, $1, $count, $ROW_WORD)); }
| PLAIN_ROWS count more ROW_WORD times  { $$ = stmt_row(parse, @$, syntax_plain_rows(parse, @$, @1, $1, $count, $ROW_WORD)); syntax_rows_times(parse, @times); (void)$times; }
| PLAIN_ROWS count more ROW_WORD SIDE   { $$ = stmt_row(parse, @$, syntax_plain_rows(parse, @$, @1, $1, $count, $ROW_WORD)); $$->row.starting = $SIDE; }
| PLAIN_ROWS count more ROW_WORD IN_FABRIC FABRIC
                                        { $$ = stmt_row(parse, @$, syntax_fabric(@$, $FABRIC, $count, $ROW_WORD, SIDE_OPEN)); }
| PLAIN_EVERY FOR_ROWS count ROW_WORD   { $$ = stmt_row(parse, @$, syntax_plain_rows(parse, @$, @1, $1, $count, $ROW_WORD)); }
| PLAIN_EVERY UNTIL_ROWS count ROW_WORD { $$ = stmt_row(parse, @$, syntax_total(syntax_plain_rows(parse, @$, @1, $1, $count, $ROW_WORD))); }
| PLAIN_EVERY UNTIL_LENGTH              { $$ = stmt_row(parse, @$, syntax_measured(syntax_plain_rows(parse, @$, @1, $1, syntax_rows_of(parse, @$, $2), SIDE_OPEN), $2)); }
| PLAIN_EVERY                           { $$ = stmt_row(parse, @$, syntax_as_others(syntax_plain_rows(parse, @$, @1, $1, NULL, SIDE_OPEN))); }
| WORK in FABRIC starting[first] for count more ROW_WORD starting[last]
                                        { $$ = stmt_row(parse, @$, syntax_fabric(@$, $FABRIC, $count, $ROW_WORD, $last ? $last : $first)); }
| WORK count more ROW_WORD in FABRIC starting
                                        { $$ = stmt_row(parse, @$, syntax_fabric(@$, $FABRIC, $count, $ROW_WORD, $starting)); }
| WORK count more ROW_WORD KEPT_EDGES AND FABRIC BETWEEN
                                        { $$ = syntax_keeps(stmt_row(parse, @$, syntax_fabric(@$, $FABRIC, $count, $ROW_WORD, SIDE_OPEN)), @KEPT_EDGES, $KEPT_EDGES); }
| WORK count[rows] more ROW_WORD[round] in FABRIC STARTING count[sofar] ROW_WORD
                                        { $$ = stmt_row(parse, @$, syntax_fabric(@$, $FABRIC, $rows, $round, $STARTING)); syntax_rows_so_far(parse, @sofar); (void)$sofar; }
| WORK count more RIDGES starting       { $$ = stmt_row(parse, @$, syntax_ridges(parse, @$, $count, $starting)); }
| WORK in FABRIC starting UNTIL_ROWS count ROW_WORD total
                                        { $$ = stmt_row(parse, @$, syntax_total(syntax_fabric(@$, $FABRIC, $count, $ROW_WORD, $starting))); }
| WORK in FABRIC starting UNTIL_LENGTH  { $$ = stmt_row(parse, @$, syntax_measured(syntax_fabric(@$, $FABRIC, syntax_rows_of(parse, @$, $5), SIDE_OPEN, $starting), $5)); }
| WORK in FABRIC starting FOR_PATTERN   { $$ = stmt_row(parse, @$, syntax_as_others(syntax_fabric(@$, $FABRIC, syntax_two_rows(parse, @$), SIDE_OPEN, $starting))); }
| WORK in FABRIC starting               { $$ = stmt_row(parse, @$, syntax_as_others(syntax_fabric(@$, $FABRIC, syntax_two_rows(parse, @$), SIDE_OPEN, $starting))); }
| WORK in RIB for count more ROW_WORD   { $$ = stmt_again(parse, @$, syntax_rib(syntax_go_on(@$, $count))); }
| WORK count more ROW_WORD in RIB       { $$ = stmt_again(parse, @$, syntax_rib(syntax_go_on(@$, $count))); }
| WORK in RIB UNTIL_LENGTH              { $$ = syntax_goes_on(parse, @$, $4); $$->again.rib = true; }
| WORK in RIB                           { $$ = syntax_goes_on(parse, @$, (struct measure){0}); $$->again.rib = true; }
| WORK in RIB UNTIL_ROWS count ROW_WORD { $$ = stmt_again(parse, @$, syntax_rib(syntax_go_on(@$, $count))); }
| WORK_LENGTH RIB                       { $$ = syntax_goes_on(parse, @$, $1); $$->again.rib = true; }
| WORK_LENGTH FABRIC starting           { $$ = stmt_row(parse, @$, syntax_measured(syntax_fabric(@$, $FABRIC, syntax_rows_of(parse, @$, $1), SIDE_OPEN, $starting), $1)); }
| STARTING work_statement[work]         { $$ = $work; $$->row.starting = $STARTING; }
;
starting: %empty                        { $$ = SIDE_OPEN; } | STARTING;
more: %empty | MORE;
total: %empty | TOTAL;
in: %empty | IN_FABRIC;
for: %empty | FOR_ROWS | ',' | ':' | RANGE;

/* ---- expressions ---- */

expr:
  postfix
| '-' expr[a]  %prec SIGN               { $$ = UNARY(OP_NEGATE, @$, $a); }
| '!' expr[a]  %prec SIGN               { $$ = UNARY(OP_NOT, @$, $a); }
| expr[a] '+' expr[b]                   { $$ = BINARY(OP_ADD, @$, $a, $b); }
| expr[a] '-' expr[b]                   { $$ = BINARY(OP_SUBTRACT, @$, $a, $b); }
| expr[a] '*' expr[b]                   { $$ = BINARY(OP_MULTIPLY, @$, $a, $b); }
| expr[a] '/' expr[b]                   { $$ = BINARY(OP_DIVIDE, @$, $a, $b); }
| expr[a] MOD expr[b]                   { $$ = BINARY(OP_MOD, @$, $a, $b); }
| expr[a] '<' expr[b]                   { $$ = BINARY(OP_LESS, @$, $a, $b); }
| expr[a] '>' expr[b]                   { $$ = BINARY(OP_GREATER, @$, $a, $b); }
| expr[a] LESS_EQUAL expr[b]            { $$ = BINARY(OP_AT_MOST, @$, $a, $b); }
| expr[a] GREATER_EQUAL expr[b]         { $$ = BINARY(OP_AT_LEAST, @$, $a, $b); }
| expr[a] EQUAL expr[b]                 { $$ = BINARY(OP_EQUAL, @$, $a, $b); }
| expr[a] UNEQUAL expr[b]               { $$ = BINARY(OP_UNEQUAL, @$, $a, $b); }
| expr[a] AND_AND expr[b]               { $$ = BINARY(OP_AND, @$, $a, $b); }
| expr[a] OR_OR expr[b]                 { $$ = BINARY(OP_OR, @$, $a, $b); }
| expr[a] '?' expr[b] ':' expr[c]       { $$ = expr_operation(parse, EXPR_CHOICE, @$, OP_OR, $a, $b, $c); }
| EACH '(' name[x] ',' name[y] ')' IN expr[columns] BY expr[rows] ':' expr[cell]  %prec EACH_TAIL
                                        { $$ = expr_each(parse, @$, $x, $y, $columns, $rows, $cell); }
;

postfix:
  primary
| postfix[a] '[' expr[b] ']'            { $$ = expr_operation(parse, EXPR_INDEX, @$, OP_OR, $a, $b, NULL); }
| postfix[a] '(' arguments ')'          { $$ = expr_call(parse, @$, $a, $arguments.first); }
;

primary:
  NUMBER                                { $$ = expr_number(parse, @$, $1.value, $1.dimension); }
| STRING                                { $$ = expr_text(parse, EXPR_STRING, @$, $1); }
| NAME                                  { $$ = expr_text(parse, EXPR_NAME, @$, $1); }
| NAME[space] '.' NAME[member]          { $$ = expr_member(parse, @$, $space, $member); }
| '(' expr ')'                          { $$ = $2; $$->span = @$; }
| '[' exprs ']'                         { $$ = expr_list(parse, @$, $exprs.first); }
;

exprs: %empty                           { $$ = (struct exprs){0}; } | exprs_1;
exprs_1:
  expr                                  { $$ = (struct exprs){$1, $1}; }
| exprs_1[all] ',' expr                 { $$ = $all; APPEND($$, $expr); }
;

arguments: %empty                       { $$ = (struct arguments){0}; } | arguments_1;
arguments_1:
  argument                              { $$ = (struct arguments){$1, $1}; }
| arguments_1[all] ',' argument         { $$ = $all; APPEND($$, $argument); }
;
argument:
  expr                                  { $$ = ast_argument(parse, @$, NULL, $1); }
| name '=' expr                         { $$ = ast_argument(parse, @$, $1.name, $expr); }
;

%%

static int yyreport_syntax_error(const yypcontext_t *context, struct parse *parse, void *scanner)
{
    yysymbol_kind_t symbol[EXPECTED_TOKENS];
    const char *expected[EXPECTED_TOKENS];
    yysymbol_kind_t found = yypcontext_token(context);

    /* What could stand here takes its time to find, and is told in a few messages only. */
    int n = diag_takes_more(parse->diag) ? yypcontext_expected_tokens(context, symbol, EXPECTED_TOKENS) : 0;

    (void)scanner;
    if (n < 0)
        return n;
    for (int i = 0; i < n; i++)
        expected[i] = yysymbol_name(symbol[i]);
    syntax_error(parse, *yypcontext_location(context), found == YYSYMBOL_YYEMPTY ? NULL : yysymbol_name(found),
                 expected, n);
    return 0;
}
