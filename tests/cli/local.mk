# The command line, from outside: TAP scripts that run the binary.
cli_tests = \
    tests/cli/bootstrap.sh \
    tests/cli/cached.sh \
    tests/cli/chart.sh \
    tests/cli/check.sh \
    tests/cli/diagnostics.sh \
    tests/cli/full.sh \
    tests/cli/interrupt.sh \
    tests/cli/layers.sh \
    tests/cli/list.sh \
    tests/cli/many.sh \
    tests/cli/manifest.sh \
    tests/cli/options.sh \
    tests/cli/params.sh \
    tests/cli/picture.sh \
    tests/cli/plot.sh \
    tests/cli/progress.sh \
    tests/cli/resume.sh \
    tests/cli/run.sh \
    tests/cli/seeds.sh \
    tests/cli/start.sh \
    tests/cli/sweep.sh \
    tests/cli/sweep_stop.sh \
    tests/cli/sweep_warm.sh
check_SCRIPTS += $(cli_tests)
EXTRA_DIST += $(cli_tests) tests/tap.sh

# A reader of JSON for the scripts; not a test itself.
EXTRA_PROGRAMS += tests/cli/json
tests_cli_json_SOURCES = tests/cli/json.c
tests_cli_json_LDADD = $(CJSON_LIBS)
CLEANFILES += tests/cli/json$(EXEEXT)
tests/tools/editors.sh.log tests/cli/check.sh.log tests/cli/diagnostics.sh.log tests/cli/manifest.sh.log tests/cli/options.sh.log tests/cli/params.sh.log tests/cli/run.sh.log tests/cli/seeds.sh.log tests/cli/start.sh.log tests/cli/sweep.sh.log tests/cli/sweep_warm.sh.log: tests/cli/json$(EXEEXT)
