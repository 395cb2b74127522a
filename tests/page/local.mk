# The page of output "x.html": how it is built, and in a real browser.
page_tests = tests/page/build.sh tests/page/browser.sh
check_SCRIPTS += $(page_tests)
EXTRA_DIST += $(page_tests) tests/page/browser.js
