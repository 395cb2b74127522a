# Tests of what comes with weft: completions, man page, editors' files.
tools_tests = \
    tests/tools/completions.sh \
    tests/tools/editors.sh \
    tests/tools/install.sh \
    tests/tools/manpage.sh
check_SCRIPTS += $(tools_tests)
EXTRA_DIST += $(tools_tests)
