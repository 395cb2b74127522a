# The language: .knit text -> scene.
noinst_LIBRARIES += liblang.a
liblang_a_SOURCES = lang/grid.h lang/scene.h
