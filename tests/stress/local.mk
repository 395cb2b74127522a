# Stability: a short form in `make check`, all of it by `make stress`.
if HAVE_CMOCKA
check_PROGRAMS += tests/stress/sweep
tests_stress_sweep_SOURCES = tests/stress/sweep.c tests/stress/trial.c tests/stress/trial.h
tests_stress_sweep_LDADD = libscenes.a libsolver.a $(LIBRARIES_OF_OTHERS)

check_PROGRAMS += tests/stress/test_rows
tests_stress_test_rows_SOURCES = tests/stress/test_rows.c tests/stress/trial.c tests/stress/trial.h
tests_stress_test_rows_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_stress_test_rows_LDADD = libscenes.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)

check_PROGRAMS += tests/stress/test_known
tests_stress_test_known_SOURCES = tests/stress/test_known.c tests/stress/trial.h
tests_stress_test_known_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_stress_test_known_LDADD = libscenes.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)
endif

check_SCRIPTS += tests/stress/hostile.sh tests/stress/lines.sh tests/stress/refused.sh
EXTRA_DIST += tests/stress/hostile.sh tests/stress/lines.sh tests/stress/refused.sh tests/stress/motifs.sh docs/stability.md

# Everything: the scenes, then the tables of docs/stability.md on standard output.
stress: weft$(EXEEXT) tests/stress/sweep$(EXEEXT) tests/stress/test_rows$(EXEEXT) tests/stress/test_known$(EXEEXT)
	OMP_WAIT_POLICY=passive tests/stress/test_rows$(EXEEXT)
	OMP_WAIT_POLICY=passive tests/stress/test_known$(EXEEXT)
	OMP_WAIT_POLICY=passive tests/stress/sweep$(EXEEXT) full
	WEFT='$(abs_top_builddir)/weft' $(srcdir)/tests/stress/motifs.sh
.PHONY: stress
