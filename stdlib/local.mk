# Motifs in .knit, embedded in the binary.
STDLIB = stdlib/bars.knit \
    stdlib/baskets.knit \
    stdlib/brocades.knit \
    stdlib/chains.knit \
    stdlib/checks.knit \
    stdlib/columns.knit \
    stdlib/diagonals.knit \
    stdlib/miura.knit \
    stdlib/peaks.knit \
    stdlib/plain.knit \
    stdlib/pleats.knit \
    stdlib/ribs.knit \
    stdlib/seed.knit \
    stdlib/squiggles.knit \
    stdlib/textures.knit \
    stdlib/weave.knit
stdlibdir = $(pkgdatadir)/stdlib
dist_stdlib_DATA = $(STDLIB)
EXTRA_DIST += stdlib/embed.awk
CLEANFILES += stdlib/embedded.c
nodist_liblang_a_SOURCES = stdlib/embedded.c
stdlib/embedded.c: $(STDLIB) stdlib/embed.awk
	$(AM_V_GEN)$(MKDIR_P) stdlib && \
	(cd $(srcdir) && $(AWK) -f stdlib/embed.awk $(STDLIB)) > $@.tmp && mv $@.tmp $@
