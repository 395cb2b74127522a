#!/bin/sh
# SPDX-License-Identifier: GPL-3.0-or-later
# What editors colour: the grammars can be read, and the words they know are
# those of the language, neither fewer nor more.
. "${WEFT_SOURCE:-.}/tests/tap.sh"

# ---- the words of the language, from its sources ----

cd "$WEFT_SOURCE" || exit 1
lines() { tr ' |,' '\n\n\n' | sed '/^$/d' | sort -u; }

# Statements begin with these; `else` goes on with one.
{
    sed -n '/^const char \*const statement_word/,/^};/p' lang/syntax_errors.c | grep -o '"[a-z]*"' | tr -d '"'
    echo else
} | lines >"$work/statements"
sed -n '/^<\(USE_\|EXPR\)>{/,/^}/p' lang/lexer.l | sed -n 's/^    \([a-z]*\)  *{ TOKEN(.*/\1/p' | lines >"$work/words"
sed -n 's/^    {"\([a-z]*\)", run_.*/\1/p' lang/builtin.c | lines >"$work/functions"
check 'statements are found in the sources' test "$(wc -l <"$work/statements")" -ge 30
check 'words are found in the sources' test "$(wc -l <"$work/words")" -ge 6
check 'functions are found in the sources' test "$(wc -l <"$work/functions")" -ge 30
sed -n '/^<INITIAL>{/,/^}/p' lang/lexer.l | sed -n 's/^    \([a-z|]*\)  *{ *\(STATEMENT.*\)*$/\1/p' | lines >"$work/scanned"
check 'the scanner has no further statement' sh -c '! comm -13 "$1" "$2" | grep .' sh "$work/statements" "$work/scanned"

# ---- TextMate ----

grammar=editors/knit.tmLanguage.json
json=$(dirname "$WEFT")/tests/cli/json
check 'the TextMate grammar is JSON' "$json" "$grammar"
words_of() { "$json" "$grammar" "repository.$1.match" | sed 's/.*b(\([a-z|]*\)).*/\1/' | lines; }
{ words_of statement; words_of rows; } | sort >"$work/textmate"
check 'TextMate: statements' diff "$work/statements" "$work/textmate"
words_of words >"$work/textmate"
check 'TextMate: words' diff "$work/words" "$work/textmate"
words_of functions >"$work/textmate"
check 'TextMate: functions' diff "$work/functions" "$work/textmate"
if perl -MJSON::PP -e 1 2>/dev/null; then
    cat >"$work/grammar.pl" <<'PERL'
use strict; use warnings; use JSON::PP;
local $/; open my $file, '<', shift or die; my $grammar = decode_json(<$file>);
my $rules = $grammar->{repository}; my @known = keys %$rules; my $bad = 0;
sub walk {
    my ($rule) = @_;
    for my $key ('match', 'begin', 'end') {
        next unless defined $rule->{$key};
        eval { qr/$rule->{$key}/ } or do { print "$key: $@"; $bad = 1 };
    }
    if (defined $rule->{include}) {
        my ($name) = $rule->{include} =~ /^#(.*)/;
        unless (defined $name && exists $rules->{$name}) { print "no rule $rule->{include}\n"; $bad = 1 }
    }
    walk($_) for @{ $rule->{patterns} // [] };
}
walk($grammar); walk($_) for values %$rules;
my %like = (
    row => ['Row 1 (RS): k2', '  Rows 1 and 3: p2', 'R3: k1', '2nd row: p1', 'All WS rows: purl', 'Row {2 * i} (WS): k1', 'Next row: p1', 'Set-up row (WS): p1', 'Foundation row: k1', 'RS rows: knit'],
    again => ['Cast on 20 sts', 'Repeat rows 1-2 3 times', 'multiple of 4 + 2'],
    chart => ['chart {', '  chart (x = P, o = K) {'],
    number => ['1.4', '1e-4', '1%', '5 mm', '.5', 'pi'], stitch => ['k2', 'purl', 'P'],
    repeat => ['rep from *', '*', 'to last', 'twice', 'as row']);
my %unlike = (row => ['let rows = 3', 'param row = 3', 'swatch tile(K, 2, 2)'], again => ['swatch repeat', 'output "x"'],
    chart => ['output chart "x.txt"'], number => ['k', 'x_y', 'pile'], stitch => ['kfb', 'moss']);
for my $name (keys %like) {
    my $pattern = $rules->{$name}{begin} // $rules->{$name}{match};
    for (@{ $like{$name} }) { print "$name is not: $_\n" and $bad = 1 unless /$pattern/ }
    for (@{ $unlike{$name} // [] }) { print "$name is: $_\n" and $bad = 1 if /$pattern/ }
}
exit $bad;
PERL
    check 'TextMate: every pattern can be read and means what it should' perl "$work/grammar.pl" "$grammar"
else
    skip 'TextMate: every pattern can be read' 'perl has no JSON here'
fi

# ---- vim ----

vim=editors/vim/syntax/knit.vim
vim_words() { sed -n "s/^syntax keyword $1  *\(contained\)*//p" $vim | lines; }
{ vim_words knitStatement; vim_words knitRow; } | sort >"$work/vim"
check 'vim: statements' diff "$work/statements" "$work/vim"
vim_words knitWord >"$work/vim"
check 'vim: words' diff "$work/words" "$work/vim"
vim_words knitFunction >"$work/vim"
check 'vim: functions' diff "$work/functions" "$work/vim"

# seen LINE COLUMN GROUP: what vim calls the character there.
seen() {
    echo "call writefile([synIDattr(synID($1, $2, 1), 'name')], '$work/seen', 'a')" >>"$work/ask.vim"
    echo "$3" >>"$work/wanted"
}
if vim --version 2>/dev/null | grep -q '+syntax'; then
    cat >"$work/a.knit" <<'KNIT'
# a comment: Row 1
param n = 1.4 in 1..2 "how {n} many"
Row 1 (RS): *k2, p{2 * n}; rep from * to end  # behind
motif m {
  chart (x = P, o = K) {
    x o x  1
  }
}
swatch tile(m, 2, 2)
Repeat rows 1-2 3 times
Set-up row (WS): k1
KNIT
    cat >"$work/ask.vim" <<VIM
set runtimepath^=$WEFT_SOURCE/editors/vim
filetype on
syntax on
edit $work/a.knit
call writefile([&filetype], '$work/seen')
VIM
    echo knit >"$work/wanted"
    seen 1 3 knitComment
    seen 2 1 knitStatement
    seen 2 11 knitNumber
    seen 2 15 knitWord
    seen 2 25 knitString
    seen 2 28 knitParam
    seen 3 1 knitRow
    seen 3 8 knitSide
    seen 3 13 knitRepeat
    seen 3 14 knitStitch
    seen 3 22 knitOperator
    seen 3 28 knitRepeat
    seen 3 47 knitComment
    seen 4 1 knitStatement
    seen 5 3 knitStatement
    seen 5 9 knitKey
    seen 6 5 knitChart
    seen 6 12 knitRowNumber
    seen 9 1 knitStatement
    seen 9 8 knitFunction
    seen 10 1 knitRow
    seen 11 1 knitHead
    seen 11 8 knitRow
    seen 11 13 knitSide
    seen 11 18 knitStitch
    echo 'quitall!' >>"$work/ask.vim"
    vim -u NONE -i NONE -n -N -es -S "$work/ask.vim" </dev/null >"$work/.vim" 2>&1
    check 'vim: colours where they belong' diff "$work/wanted" "$work/seen"
else
    skip 'vim: colours where they belong' 'vim with syntax is not here'
fi

finish
