# Tests of the language: scripts and what they must say, to the letter.
golden_tests = \
    tests/golden/golden.sh \
    tests/golden/test_grammar.sh \
    tests/golden/test_examples.sh \
    tests/golden/test_library.sh \
    tests/golden/test_limits.sh \
    tests/golden/test_motifs.sh \
    tests/golden/test_pasted.sh \
    tests/golden/test_rows.sh \
    tests/golden/test_stitches.sh
check_SCRIPTS += $(golden_tests)

noinst_PROGRAMS = tests/golden/knit_dump
tests_golden_knit_dump_LDADD = liblang.a

# Writes what the scripts print now over the expected texts.
update-golden: tests/golden/knit_dump$(EXEEXT)
	WEFT='$(abs_top_builddir)/weft' WEFT_SOURCE='$(abs_top_srcdir)' \
	    $(SHELL) $(srcdir)/tests/golden/golden.sh --update
.PHONY: update-golden

if HAVE_CMOCKA
check_PROGRAMS += tests/golden/test_grid tests/golden/test_diag tests/golden/test_compile
tests_golden_test_grid_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_golden_test_grid_LDADD = liblang.a $(CMOCKA_LIBS)
tests_golden_test_diag_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_golden_test_diag_LDADD = liblang.a $(CMOCKA_LIBS)
tests_golden_test_compile_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_golden_test_compile_LDADD = liblang.a $(CMOCKA_LIBS)
endif

EXTRA_DIST += $(golden_tests) tests/golden/dump.sh tests/golden/pasted \
    tests/golden/grammar.txt \
    tests/golden/cases.awk tests/golden/books.txt \
    tests/golden/web.txt tests/golden/ways.txt \
    tests/golden/stitches.txt \
    tests/golden/all_given.knit tests/golden/all_given.expected tests/golden/binary_file.knit \
    tests/golden/blocks.knit \
    tests/golden/characters.knit \
    tests/golden/circle.knit \
    tests/golden/circle.txt \
    tests/golden/command_line.knit \
    tests/golden/command_line_outputs.knit \
    tests/golden/defaults.knit \
    tests/golden/edges.knit tests/golden/edges.expected tests/golden/edges_too_wide.knit \
    tests/golden/edges_too_wide.expected \
    tests/golden/empty.knit tests/golden/ending.knit tests/golden/ending.expected \
    tests/golden/grid_file.knit \
    tests/golden/grid_file_plain.knit \
    tests/golden/html_file.knit \
    tests/golden/json.knit \
    tests/golden/json_file.knit \
    tests/golden/length.knit tests/golden/length.expected \
    tests/golden/length_open.knit tests/golden/length_open.expected \
    tests/golden/long_line.knit \
    tests/golden/many.knit \
    tests/golden/motif_frames.knit \
    tests/golden/names.knit \
    tests/golden/outputs.knit \
    tests/golden/picture_keys.knit \
    tests/golden/plot_keys.knit \
    tests/golden/plot_keys_sweep.knit \
    tests/golden/pictures.knit \
    tests/golden/place_of_statements.knit \
    tests/golden/statements.knit \
    tests/golden/charts.knit \
    tests/golden/chart_keys.knit \
    tests/golden/prose.knit \
    tests/golden/prose_width.knit \
    tests/golden/in_pattern.knit \
    tests/golden/rows_above.knit \
    tests/golden/repeat_no_count.knit \
    tests/golden/last_repeat.knit \
    tests/golden/refused.knit \
    tests/golden/second_part.knit \
    tests/golden/rows.knit \
    tests/golden/settings.knit \
    tests/golden/swach.knit \
    tests/golden/sweep.knit \
    tests/golden/sweep_range.knit \
    tests/golden/sweep_twice.knit \
    tests/golden/syntax.knit \
    tests/golden/typos.knit \
    tests/golden/typos_in_rows.knit \
    tests/golden/unclosed.knit \
    tests/golden/used.knit \
    tests/golden/used_motifs.txt \
    tests/golden/values.knit \
    tests/golden/version.knit \
    tests/golden/sizes.knit \
    tests/golden/warnings.knit \
    tests/golden/warnings_as_errors.knit \
    tests/golden/windows.knit \
    tests/golden/binary_file.expected \
    tests/golden/blocks.expected \
    tests/golden/characters.expected \
    tests/golden/circle.expected \
    tests/golden/command_line.expected \
    tests/golden/command_line_outputs.expected \
    tests/golden/defaults.expected \
    tests/golden/empty.expected \
    tests/golden/grid_file.expected \
    tests/golden/grid_file_plain.expected \
    tests/golden/html_file.expected \
    tests/golden/json.expected \
    tests/golden/json_file.expected \
    tests/golden/long_line.expected \
    tests/golden/many.expected \
    tests/golden/motif_frames.expected \
    tests/golden/names.expected \
    tests/golden/outputs.expected \
    tests/golden/picture_keys.expected \
    tests/golden/plot_keys.expected \
    tests/golden/plot_keys_sweep.expected \
    tests/golden/pictures.expected \
    tests/golden/place_of_statements.expected \
    tests/golden/statements.expected \
    tests/golden/charts.expected \
    tests/golden/chart_keys.expected \
    tests/golden/prose.expected \
    tests/golden/prose_width.expected \
    tests/golden/in_pattern.expected \
    tests/golden/rows_above.expected \
    tests/golden/repeat_no_count.expected \
    tests/golden/last_repeat.expected \
    tests/golden/refused.expected \
    tests/golden/second_part.expected \
    tests/golden/rows.expected \
    tests/golden/settings.expected \
    tests/golden/swach.expected \
    tests/golden/sweep.expected \
    tests/golden/sweep_range.expected \
    tests/golden/sweep_twice.expected \
    tests/golden/syntax.expected \
    tests/golden/typos.expected \
    tests/golden/typos_in_rows.expected \
    tests/golden/unclosed.expected \
    tests/golden/used.expected \
    tests/golden/values.expected \
    tests/golden/version.expected \
    tests/golden/sizes.expected \
    tests/golden/warnings.expected \
    tests/golden/warnings_as_errors.expected \
    tests/golden/windows.expected
