# Options and subcommands.
noinst_LIBRARIES += libcli.a
libcli_a_SOURCES = lang/scene.h
