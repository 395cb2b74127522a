# Charts and written rows, in and out, from outside.
chart_tests = \
    tests/charts/csv.sh \
    tests/charts/import.sh \
    tests/charts/knitout.sh \
    tests/charts/legend.sh \
    tests/charts/png.sh \
    tests/charts/use.sh \
    tests/charts/words.sh \
    tests/charts/write.sh
check_SCRIPTS += $(chart_tests)
EXTRA_DIST += $(chart_tests) tests/charts/grids.sh

# A painter of pictures and a knitting machine for the scripts; no tests themselves.
EXTRA_PROGRAMS += tests/charts/machine tests/charts/paint
tests_charts_machine_SOURCES = tests/charts/machine.c
tests_charts_machine_LDADD =
tests_charts_paint_SOURCES = tests/charts/paint.c
tests_charts_paint_LDADD = $(PNG_LIBS)
CLEANFILES += tests/charts/machine$(EXEEXT) tests/charts/paint$(EXEEXT)
tests/charts/png.sh.log tests/charts/knitout.sh.log: tests/charts/machine$(EXEEXT) tests/charts/paint$(EXEEXT)

if HAVE_CMOCKA
check_PROGRAMS += tests/charts/test_drawn tests/charts/test_exchange
tests_charts_test_drawn_SOURCES = tests/charts/test_drawn.c
tests_charts_test_drawn_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_charts_test_drawn_LDADD = libcharts.a libdrawing.a liblang.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)
tests_charts_test_exchange_SOURCES = tests/charts/test_exchange.c
tests_charts_test_exchange_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_charts_test_exchange_LDADD = libcharts.a liblang.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)
endif
