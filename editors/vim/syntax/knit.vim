" SPDX-License-Identifier: GPL-3.0-or-later
" The knitting language of weft: statements, rows, charts.

if exists('b:current_syntax')
  finish
endif

syntax case ignore
syntax sync fromstart

" The words that begin a statement; knitters' words mean something there alone.
syntax keyword knitStatement knit use let param stitch motif swatch gauge material springs mesh solve output sweep
syntax keyword knitStatement for if else chart
syntax keyword knitRow       contained cast co row rows round rounds rnd rnds all repeat rep every next multiple
syntax keyword knitWord      as from each in by mod
syntax keyword knitFunction  tile fill beside above mirror flip invert turn rotate shift crop inset border width height
syntax keyword knitFunction  count at min max abs floor ceil round sqrt sin cos tan exp log pow gcd

syntax match knitNumber  '\v<\d+%(\.\d+)?%(e[-+]?\d+)?%(\s*\%|\s*[cm]?m>|in>)?'
syntax keyword knitNumber pi
syntax match knitOperator '\v\.\.|[-+*/<>=!?]|\&\&|\|\|'

" Rows: a head up to its colon, then stitches to the end of the line.
syntax match knitHead '\v^\s*%(%(next|rs|ws|set-?up|foundation)\s+)?%(rows?|rounds?|rnds?)>[^:{}#"]*%(\{[^}]*\}[^:{}#"]*)*:' contains=knitRow,knitSide,knitHole,knitNumber nextgroup=knitText
syntax match knitHead '\v^\s*r\d+\s*:' nextgroup=knitText
syntax match knitHead '\v^\s*\d+(st|nd|rd|th)\s+%(row|round|rnd)>[^:#]*:' contains=knitRow,knitSide nextgroup=knitText
syntax match knitHead '\v^\s*%(all|every|each)\s[^:#"]*:' contains=knitRow,knitSide nextgroup=knitText
syntax match knitHead '\v^\s*%(cast|co|rep|repeat|multiple)>[^#]*' contains=knitRow,knitHole,knitNumber
syntax match knitText '\v[^#}{]*%(\{[^}#]*\}[^#}{]*)*' contained contains=knitStitch,knitRepeat,knitHole,knitNumber
syntax match knitSide   '\v<%(rs|ws)>|%(right|wrong)[- ]side' contained
syntax match knitStitch '\v<%(k|p|knit|purl)\d*>' contained
syntax match knitRepeat '\v\*|<rep%(eat)?>%(\s+from)?\s*\*?|<to\s+%(end|last)>|<%(times|twice|once|more|across)>|<as\s+row>' contained
syntax region knitHole matchgroup=knitBrace start='{' end='}' contained contains=knitNumber,knitOperator,knitFunction,knitWord

" Charts: their lines are stitches.
syntax region knitChart matchgroup=knitKey start='\v%(<chart\s*)@<=%(\([^)]*\))?\s*\{' end='}' contains=knitComment,knitRowNumber
syntax match  knitRowNumber '\v%(^\s*\d+>|<\d+\s*$)' contained

syntax region knitString start='"' end='"' oneline contains=knitParam
syntax match  knitParam '{[^}"]*}' contained
syntax match  knitComment '#.*$' contains=knitTodo,@Spell
syntax keyword knitTodo contained todo fixme

highlight default link knitStatement Statement
highlight default link knitRow       Statement
highlight default link knitWord      Keyword
highlight default link knitFunction  Function
highlight default link knitNumber    Number
highlight default link knitOperator  Operator
highlight default link knitSide      Type
highlight default link knitStitch    Identifier
highlight default link knitRepeat    Repeat
highlight default link knitBrace     Special
highlight default link knitKey       Special
highlight default link knitRowNumber Comment
highlight default link knitString    String
highlight default link knitParam     Special
highlight default link knitComment   Comment
highlight default link knitTodo      Todo

let b:current_syntax = 'knit'
