# The man page: made where weft is built from a checkout, ready in a release.
dist_man_MANS = docs/weft.1
EXTRA_DIST += docs/experiments.md docs/weft.1.in docs/manpage.sh
MAINTAINERCLEANFILES += docs/weft.1
docs/weft.1: docs/weft.1.in docs/manpage.sh cli/command.c cli/options.c | weft$(EXEEXT)
	$(AM_V_GEN)$(MKDIR_P) docs && \
	$(SHELL) $(srcdir)/docs/manpage.sh ./weft$(EXEEXT) $(srcdir)/docs/weft.1.in > $@.tmp && mv $@.tmp $@
