# Motifs in .knit, embedded in the binary.
STDLIB = stdlib/miura.knit
EXTRA_DIST += $(STDLIB) stdlib/embed.awk
CLEANFILES += stdlib/embedded.c
nodist_liblang_a_SOURCES = stdlib/embedded.c
stdlib/embedded.c: $(STDLIB) stdlib/embed.awk
	$(AM_V_GEN)$(MKDIR_P) stdlib && \
	(cd $(srcdir) && $(AWK) -f stdlib/embed.awk $(STDLIB)) > $@.tmp && mv $@.tmp $@
