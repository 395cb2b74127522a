# The language: .knit text -> scene.
noinst_LIBRARIES += liblang.a
liblang_a_SOURCES = lang/grid.h lang/scene.h lang/arena.h lang/arena.c lang/codes.h lang/compile.h \
    lang/diag.h lang/diag.c lang/diag_print.c lang/grid.c lang/limits.h lang/source.c
