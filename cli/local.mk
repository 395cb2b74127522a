# Options and subcommands.
noinst_LIBRARIES += libcli.a
libcli_a_SOURCES = \
    cli/build.c cli/build.h \
    cli/cached.c cli/cached.h \
    cli/chart.c \
    cli/check.c \
    cli/checkpoint.c cli/checkpoint.h \
    cli/command.c cli/command.h \
    cli/deliver.c cli/deliver.h \
    cli/fmt.c \
    cli/help.c \
    cli/import.c cli/import.h \
    cli/interrupt.c cli/interrupt.h \
    cli/list.c \
    cli/manifest.c cli/manifest.h \
    cli/options.c cli/options.h \
    cli/outputs.c cli/outputs.h \
    cli/params.c \
    cli/progress.c cli/progress.h \
    cli/recorded.c cli/recorded.h \
    cli/repeat.c cli/repeat.h \
    cli/run.c cli/run.h \
    cli/script.c cli/script.h \
    cli/seeds.c cli/seeds.h \
    cli/state.c cli/state.h \
    cli/streams.c cli/streams.h \
    cli/sweep.c \
    cli/sweep_point.c cli/sweep_point.h \
    cli/sweep_plan.c cli/sweep_plan.h \
    cli/sweep_plot.c cli/sweep_plot.h \
    cli/sweep_table.c cli/sweep_table.h \
    cli/version.c \
    cli/waiting.c cli/waiting.h \
    cli/write.c
