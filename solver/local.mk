# The solver: scene -> folded surface.
noinst_LIBRARIES += libsolver.a
libsolver_a_SOURCES = solver/sheet.h solver/fold.h solver/surface.h
