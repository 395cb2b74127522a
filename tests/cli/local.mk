# The command line, from outside: TAP scripts that run the binary.
cli_tests = tests/cli/layers.sh
check_SCRIPTS += $(cli_tests)
EXTRA_DIST += $(cli_tests) tests/tap.sh
