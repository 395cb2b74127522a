# Tests of `weft fmt`.
format_tests = tests/format/files.sh tests/format/layout.sh
check_SCRIPTS += $(format_tests)

if HAVE_CMOCKA
check_PROGRAMS += tests/format/test_meaning tests/format/test_random
tests_format_test_meaning_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_format_test_meaning_LDADD = liblang.a $(CMOCKA_LIBS)
tests_format_test_random_SOURCES = tests/format/test_random.c tests/format/program.c tests/format/program.h
tests_format_test_random_CPPFLAGS = $(AM_CPPFLAGS) $(CMOCKA_CFLAGS)
tests_format_test_random_LDADD = liblang.a $(CMOCKA_LIBS)
endif

EXTRA_DIST += $(format_tests) \
    tests/format/labels.knit tests/format/labels.expected tests/format/markers.knit tests/format/markers.expected \
    tests/format/own_k.knit tests/format/own_k.expected \
    tests/format/pasted.knit tests/format/pasted.expected \
    tests/format/script.knit tests/format/script.expected
