# The language: .knit text -> scene.
noinst_LIBRARIES += liblang.a
liblang_a_SOURCES = lang/grid.h lang/scene.h lang/arena.h lang/arena.c lang/codes.h lang/compile.h \
    lang/diag.h lang/diag.c lang/diag_print.c lang/grid.c lang/limits.h lang/source.c \
    lang/names.h lang/names.c lang/ast.h lang/ast.c lang/parse.h lang/parse.c \
    lang/scanner.h lang/scanner.c lang/token_values.h lang/token_values.c lang/unreadable.c lang/brackets.c lang/line_ends.c \
    lang/syntax.h lang/syntax.c lang/syntax_errors.c lang/expected.h lang/expected.c lang/words.h lang/words.c lang/lengths.h lang/lengths.c lang/headings.h lang/headings.c lang/named.h lang/named.c lang/ribs.h lang/ribs.c lang/repeats.h lang/repeats.c lang/prose.h lang/prose.c lang/prose_line.h lang/prose_line.c lang/prose_parts.c lang/wording.h lang/wording.c \
    lang/phrases.h lang/phrases.c \
    lang/signs.h lang/signs.c lang/remarks.h lang/row_phrases.h lang/remarks.c lang/row_phrases.c lang/printed.h lang/printed_parts.h lang/printed.c lang/printed_heads.c lang/printed_words.c lang/turns.h lang/turns.c \
    lang/marks.h lang/marks.c lang/joined.h lang/joined.c lang/heads.h lang/heads.c \
    lang/typos.h lang/typos.c \
    lang/eval.h lang/eval.c lang/module.c lang/stitches.c lang/motif.c lang/builtin.c lang/body.c lang/body_again.c lang/row_labels.h lang/row_labels.c lang/lower.h lang/lower.c \
    lang/refused.h lang/refused.c lang/vocabulary.h lang/vocabulary.c lang/chart.h lang/chart.c lang/page_chart.h lang/page_chart.c lang/page_key.h lang/page_key.c lang/page_fabric.c lang/lettered.h lang/lettered.c lang/listed.h lang/listed.c lang/starred.h lang/starred.c lang/run_on.h lang/run_on.c lang/page_facts.h lang/page_facts.c lang/page_sides.h lang/page_sides.c lang/rows.h lang/rows.c lang/row_list.h lang/row_order.c lang/row_again.c lang/row_grid.c \
    lang/row_fit.h lang/row_fit.c lang/row_misfit.h lang/row_misfit.c lang/row_draw.h lang/row_draw.c lang/keys.h lang/keys.c lang/settings.h lang/settings.c lang/outputs.h lang/outputs.c lang/own_words.h lang/own_words.c \
    lang/chart_lines.h lang/chart_lines.c lang/format.h lang/format.c lang/layout.h lang/layout.c \
    lang/row_words.h lang/row_words.c lang/spelling.h lang/spelling.c lang/tokens.h lang/tokens.c \
    lang/params.h lang/params.c lang/compile.c lang/library.h lang/library.c \
    lang/parser.c lang/parser.h lang/lexer.c
EXTRA_DIST += lang/parser.y lang/lexer.l
MAINTAINERCLEANFILES += lang/parser.c lang/parser.h lang/lexer.c

# A release holds the generated files; from a checkout they are made here.
lang/parser.c: lang/parser.y
	$(AM_V_GEN)$(MKDIR_P) lang && $(BISON) -Wall -Werror --header=lang/parser.h -o $@ $(srcdir)/lang/parser.y
lang/parser.h: lang/parser.c ;
# A rule whose trailing context has no fixed length gives flex a stack that long words overrun.
lang/lexer.c: lang/lexer.l
	$(AM_V_GEN)$(MKDIR_P) lang && $(FLEX) -o $@ $(srcdir)/lang/lexer.l && \
	    if grep -q yy_state_buf $@; then echo "lang/lexer.l: trailing context of any length" >&2; rm -f $@; exit 1; fi
lang/lexer.$(OBJEXT) lang/parser.$(OBJEXT) lang/scanner.$(OBJEXT) lang/token_values.$(OBJEXT) \
    lang/unreadable.$(OBJEXT) lang/brackets.$(OBJEXT) lang/line_ends.$(OBJEXT) lang/syntax.$(OBJEXT) lang/syntax_errors.$(OBJEXT) lang/expected.$(OBJEXT) lang/parse.$(OBJEXT) \
    lang/ast.$(OBJEXT) lang/prose.$(OBJEXT) lang/prose_parts.$(OBJEXT) lang/repeats.$(OBJEXT) lang/format.$(OBJEXT) lang/row_words.$(OBJEXT) lang/spelling.$(OBJEXT) \
    lang/tokens.$(OBJEXT): lang/parser.h
