# The solver: scene -> folded surface.
noinst_LIBRARIES += libsolver.a
libsolver_a_SOURCES = \
    solver/discretisation.h solver/lanes.h solver/memory.c solver/memory.h \
    solver/sheet.c solver/sheet.h solver/fold.h solver/surface.c solver/surface.h \
    solver/patch.c solver/patch.h solver/patch_basis.c solver/patch_basis.h \
    solver/patch_grid.c solver/patch_grid.h solver/patch_kernel.h solver/patch_transfer.c \
    solver/patch_batch.h solver/patch_poisson.c solver/patch_poisson.h solver/patch_retract.c solver/turn_kernel.h \
    solver/dissection.c solver/dissection.h solver/springs.c solver/springs.h solver/stripes.c solver/stripes.h \
    solver/factor.c solver/factor.h solver/problem.c solver/problem.h solver/lbfgs.c \
    solver/newton.c solver/stopwatch.h solver/vector.h solver/descent.c solver/descent.h \
    solver/estimate.c solver/cross_check.c solver/cross_check.h solver/estimate.h solver/two_level.c solver/two_level.h solver/fold.c solver/fold_state.h solver/levels.c solver/levels.h solver/noise.h solver/shape.c solver/shape.h

libsolver_a_SOURCES += \
    solver/triangle.c solver/triangle.h solver/triangle_mesh.c solver/triangle_mesh.h \
    solver/triangle_model.h solver/triangle_kernel.h solver/triangle_layout.c \
    solver/triangle_evaluate.c solver/triangle_transfer.c

libsolver_a_SOURCES += solver/forecast.c solver/forecast.h
