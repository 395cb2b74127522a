# Units of drawing, with cmocka.
if HAVE_CMOCKA
check_PROGRAMS += tests/drawing/test_drawing
tests_drawing_test_drawing_SOURCES = tests/drawing/test_drawing.c
tests_drawing_test_drawing_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_drawing_test_drawing_LDADD = libdrawing.a $(LIBRARIES_OF_OTHERS) $(CMOCKA_LIBS)
endif
