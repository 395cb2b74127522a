# The page of output "x.html": how it is built, and in a real browser.
page_tests = tests/page/build.sh tests/page/browser.sh
check_SCRIPTS += $(page_tests)
EXTRA_DIST += $(page_tests) tests/page/browser.js

# A weft without the page; not a test itself.
EXTRA_PROGRAMS += tests/page/without
tests_page_without_SOURCES = weft.c tests/page/without.c
tests_page_without_LDADD = $(weft_LDADD)
CLEANFILES += tests/page/without$(EXEEXT)
tests/page/build.sh.log tests/page/browser.sh.log: tests/page/without$(EXEEXT)
