# Charts and written rows, in and out, from outside.
chart_tests = \
    tests/charts/csv.sh \
    tests/charts/import.sh \
    tests/charts/png.sh \
    tests/charts/write.sh
check_SCRIPTS += $(chart_tests)
EXTRA_DIST += $(chart_tests) tests/charts/grids.sh

# A painter of pictures for the scripts; not a test itself.
EXTRA_PROGRAMS += tests/charts/paint
tests_charts_paint_SOURCES = tests/charts/paint.c
tests_charts_paint_LDADD = $(PNG_LIBS)
CLEANFILES += tests/charts/paint$(EXEEXT)
tests/charts/png.sh.log tests/charts/csv.sh.log: tests/charts/paint$(EXEEXT)
