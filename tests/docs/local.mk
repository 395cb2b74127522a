# The manual: its code runs, its error index is complete, its links lead somewhere.
docs_tests = tests/docs/blocks.sh tests/docs/errors.sh tests/docs/links.sh tests/docs/reference.sh tests/docs/stitches.sh
check_SCRIPTS += $(docs_tests)
EXTRA_DIST += $(docs_tests) tests/docs/blocks.awk tests/docs/same.awk
