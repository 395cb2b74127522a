# The language: .knit text -> scene.
noinst_LIBRARIES += liblang.a
liblang_a_SOURCES = \
    lang/arena.h lang/arena.c lang/ast.h lang/ast.c lang/body.c lang/body_again.c lang/body_pattern.c lang/brackets.c lang/builtin.c \
    lang/chart.h lang/chart.c lang/codes.h lang/compile.h lang/compile.c lang/diag.h lang/diag.c \
    lang/diag_print.c lang/eval.h lang/eval.c lang/expected.h lang/expected.c lang/grid.h lang/grid.c \
    lang/keys.h lang/keys.c lang/lexer.c lang/library.h lang/library.c lang/limits.h lang/line_ends.c \
    lang/lower.h lang/lower.c lang/module.c lang/motif.c lang/names.h lang/names.c lang/outputs.h lang/outputs.c \
    lang/params.h lang/params.c lang/parse.h lang/parse.c lang/parser.h lang/parser.c lang/refused.h \
    lang/refused.c lang/scanner.h lang/scanner.c lang/scene.h lang/settings.h lang/settings.c lang/source.c \
    lang/stitches.c lang/syntax.h lang/syntax.c lang/syntax_errors.c lang/token_values.h lang/token_values.c \
    lang/typos.h lang/typos.c lang/unreadable.c lang/vocabulary.h lang/vocabulary.c \
    lang/page/casts.h lang/page/casts.c lang/page/clauses.h lang/page/clauses.c lang/page/definitions.h \
    lang/page/definitions.c lang/page/edge_stitches.h lang/page/edge_stitches.c lang/page/edges.h \
    lang/page/edges.c lang/page/explained.h lang/page/explained.c lang/page/fabrics.h lang/page/fabrics.c \
    lang/page/framing.h lang/page/framing.c lang/page/groups.h lang/page/groups.c lang/page/headings.h \
    lang/page/headings.c lang/page/heads.h lang/page/heads.c lang/page/joined.h lang/page/joined.c \
    lang/page/kinds.h lang/page/kinds.c lang/page/lengths.h lang/page/lengths.c lang/page/lettered.h \
    lang/page/lettered.c lang/page/listed.h lang/page/listed.c lang/page/marks.h lang/page/marks.c \
    lang/page/named.h lang/page/named.c lang/page/page_chart.h lang/page/page_chart.c lang/page/page_facts.h \
    lang/page/page_facts.c lang/page/page_key.h lang/page/page_key.c lang/page/page_sides.h \
    lang/page/page_sides.c lang/page/phrases.h lang/page/phrases.c lang/page/printed.h lang/page/printed.c \
    lang/page/printed_heads.c lang/page/printed_parts.h lang/page/printed_words.c lang/page/prose.h \
    lang/page/prose.c lang/page/prose_asides.c lang/page/prose_line.h lang/page/prose_line.c \
    lang/page/prose_parts.c lang/page/prose_rows.c lang/page/remarks.h lang/page/remarks.c lang/page/repeats.h \
    lang/page/repeats.c lang/page/ribs.h lang/page/ribs.c lang/page/row_phrases.h lang/page/row_phrases.c \
    lang/page/rows_go_on.h lang/page/rows_go_on.c lang/page/rows_told.h lang/page/rows_told.c lang/page/run_on.h \
    lang/page/run_on.c lang/page/sided_rows.h lang/page/sided_rows.c lang/page/signs.h lang/page/signs.c lang/page/starred.h lang/page/starred.c \
    lang/page/sums.h lang/page/sums.c lang/page/turns.h lang/page/turns.c lang/page/turns_books.c \
    lang/page/within.h lang/page/within.c lang/page/wording.h lang/page/wording.c lang/page/words.h lang/page/words.c lang/page/yarns.h \
    lang/page/yarns.c \
    lang/rows/page_fabric.c lang/rows/row_again.c lang/rows/row_draw.h lang/rows/row_draw.c \
    lang/rows/row_edges.c lang/rows/row_fit.h lang/rows/row_fit.c lang/rows/row_grid.c lang/rows/row_labels.h \
    lang/rows/row_labels.c lang/rows/row_list.h lang/rows/row_markers.h lang/rows/row_markers.c \
    lang/rows/row_misfit.h lang/rows/row_misfit.c lang/rows/row_order.c lang/rows/rows.h lang/rows/rows.c \
    lang/format/chart_lines.h lang/format/chart_lines.c lang/format/format.h lang/format/format.c \
    lang/format/layout.h lang/format/layout.c lang/format/meaning.h lang/format/meaning.c \
    lang/format/own_words.h lang/format/own_words.c lang/format/row_words.h lang/format/row_words.c \
    lang/format/spelling.h lang/format/spelling.c lang/format/tokens.h lang/format/tokens.c
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
    lang/ast.$(OBJEXT) lang/page/prose.$(OBJEXT) lang/page/prose_asides.$(OBJEXT) lang/page/prose_parts.$(OBJEXT) lang/page/repeats.$(OBJEXT) lang/format/format.$(OBJEXT) lang/format/row_words.$(OBJEXT) lang/format/spelling.$(OBJEXT) \
    lang/format/tokens.$(OBJEXT): lang/parser.h
