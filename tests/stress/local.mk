# Stability: a short form in `make check`, all of it by `make stress`.
if HAVE_CMOCKA
check_PROGRAMS += tests/stress/sweep
tests_stress_sweep_SOURCES = tests/stress/sweep.c tests/stress/trial.c tests/stress/trial.h
tests_stress_sweep_LDADD = libscenes.a libsolver.a $(LIBRARIES_OF_OTHERS)
endif

stress: tests/stress/sweep$(EXEEXT)
	tests/stress/sweep full
.PHONY: stress
