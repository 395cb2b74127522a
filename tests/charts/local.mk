# Charts and written rows, in and out, from outside.
chart_tests = \
    tests/charts/csv.sh \
    tests/charts/import.sh \
    tests/charts/write.sh
check_SCRIPTS += $(chart_tests)
EXTRA_DIST += $(chart_tests) tests/charts/grids.sh
