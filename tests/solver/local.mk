# Units of the solver, with cmocka.
if HAVE_CMOCKA
check_LIBRARIES = libscenes.a
libscenes_a_SOURCES = tests/solver/scenes.c tests/solver/scenes.h

check_PROGRAMS += tests/solver/test_patch
tests_solver_test_patch_SOURCES = tests/solver/test_patch.c
tests_solver_test_patch_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_solver_test_patch_LDADD = libscenes.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)
endif
