# Units of the solver, with cmocka.
if HAVE_CMOCKA
check_LIBRARIES = libscenes.a
libscenes_a_SOURCES = tests/solver/scenes.c tests/solver/scenes.h tests/solver/near.h

check_PROGRAMS += tests/solver/test_patch
tests_solver_test_patch_SOURCES = tests/solver/test_patch.c
tests_solver_test_patch_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_solver_test_patch_LDADD = libscenes.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)

check_PROGRAMS += tests/solver/test_descent
tests_solver_test_descent_SOURCES = tests/solver/test_descent.c
tests_solver_test_descent_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_solver_test_descent_LDADD = libscenes.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)

check_PROGRAMS += tests/solver/test_retract
tests_solver_test_retract_SOURCES = tests/solver/test_retract.c
tests_solver_test_retract_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_solver_test_retract_LDADD = libscenes.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)

check_PROGRAMS += tests/solver/test_fold
tests_solver_test_fold_SOURCES = tests/solver/test_fold.c
tests_solver_test_fold_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_solver_test_fold_LDADD = libscenes.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)

check_PROGRAMS += tests/solver/test_triangle
tests_solver_test_triangle_SOURCES = tests/solver/test_triangle.c tests/solver/differences.c tests/solver/differences.h
tests_solver_test_triangle_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_solver_test_triangle_LDADD = libscenes.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)

check_PROGRAMS += tests/solver/test_triangle_known
tests_solver_test_triangle_known_SOURCES = tests/solver/test_triangle_known.c tests/solver/differences.c tests/solver/differences.h
tests_solver_test_triangle_known_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_solver_test_triangle_known_LDADD = libscenes.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)

check_PROGRAMS += tests/solver/test_triangle_transfer
tests_solver_test_triangle_transfer_SOURCES = tests/solver/test_triangle_transfer.c tests/solver/differences.c tests/solver/differences.h
tests_solver_test_triangle_transfer_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_solver_test_triangle_transfer_LDADD = libscenes.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)

check_PROGRAMS += tests/solver/test_triangle_reference
tests_solver_test_triangle_reference_SOURCES = tests/solver/test_triangle_reference.c \
	tests/solver/reference.c tests/solver/reference.h
tests_solver_test_triangle_reference_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_solver_test_triangle_reference_LDADD = libscenes.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)

check_PROGRAMS += tests/solver/test_triangle_states
tests_solver_test_triangle_states_SOURCES = tests/solver/test_triangle_states.c tests/solver/reference.c tests/solver/reference.h
tests_solver_test_triangle_states_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_solver_test_triangle_states_LDADD = libscenes.a libsolver.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)
endif
EXTRA_DIST += tests/solver/states/chains_6x8.txt
