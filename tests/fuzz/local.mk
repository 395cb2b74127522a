# Coverage-guided fuzzing of what reads files, with clang's libFuzzer.
FUZZ_TARGETS = script format kp csv knitout png
FUZZ_SECONDS = 60
FUZZ_FLAGS   = -g -O1 -fno-omit-frame-pointer -fsanitize=address,undefined -fno-sanitize-recover=all
FUZZ_FILES   = $(liblang_a_SOURCES) $(libcharts_a_SOURCES) $(libdrawing_a_SOURCES)
fuzz_folder  = tests/fuzz/build

# Inputs once found, without the fuzzer.
check_PROGRAMS += tests/fuzz/replay
tests_fuzz_replay_SOURCES = tests/fuzz/replay.c tests/fuzz/target.c tests/fuzz/target.h
tests_fuzz_replay_LDADD = libcharts.a liblang.a $(PNG_LIBS)
EXTRA_DIST += tests/fuzz/entry.c tests/fuzz/seeds.sh tests/fuzz/fuzz.sh tests/fuzz/words.dict tests/fuzz/found

# Every target for FUZZ_SECONDS; what breaks one is left in tests/fuzz/build.
fuzz: weft$(EXEEXT) stdlib/embedded.c lang/parser.h
	@if test -z '$(FUZZ_CC)'; then echo 'make fuzz needs clang with libFuzzer; configure found none' >&2; exit 1; fi
	@WEFT='$(abs_top_builddir)/weft' WEFT_SOURCE='$(abs_top_srcdir)' FUZZ_CC='$(FUZZ_CC)' FUZZ_FLAGS='$(FUZZ_FLAGS)' \
	FUZZ_CPPFLAGS='-I. -I$(srcdir) $(PNG_CFLAGS) $(CAIRO_CFLAGS)' FUZZ_LIBS='$(PNG_LIBS) $(CAIRO_LIBS) -lm' \
	FUZZ_SOURCES='$(FUZZ_FILES) stdlib/embedded.c tests/fuzz/target.h tests/fuzz/target.c' FUZZ_SECONDS='$(FUZZ_SECONDS)' \
	    $(SHELL) $(srcdir)/tests/fuzz/fuzz.sh $(fuzz_folder) $(FUZZ_TARGETS)
clean-local-fuzz:
	rm -rf $(fuzz_folder)
clean-local: clean-local-fuzz
.PHONY: fuzz clean-local-fuzz
