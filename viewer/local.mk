# The page to look at a swatch: bundled with npm, embedded in the binary. A
# release tarball has the bundle, viewer/template.html; a checkout makes it
# here, and where that cannot be done the file is empty and weft says so.
viewer_sources = \
    viewer/build.js \
    viewer/package.json \
    viewer/package-lock.json \
    viewer/.npmrc \
    viewer/src/chart.js \
    viewer/src/colours.js \
    viewer/src/data.js \
    viewer/src/fold.js \
    viewer/src/main.js \
    viewer/src/numbers.js \
    viewer/src/page.css \
    viewer/src/page.html
EXTRA_DIST += $(viewer_sources) viewer/make.sh viewer/embed.awk viewer/template.html
MAINTAINERCLEANFILES += $(srcdir)/viewer/template.html
CLEANFILES += viewer/embedded.c
nodist_liboutput_a_SOURCES = viewer/embedded.c

$(srcdir)/viewer/template.html: $(viewer_sources) viewer/make.sh
	$(AM_V_GEN)$(SHELL) $(srcdir)/viewer/make.sh
viewer/embedded.c: $(srcdir)/viewer/template.html viewer/embed.awk
	$(AM_V_GEN)$(MKDIR_P) viewer && \
	$(AWK) -f $(srcdir)/viewer/embed.awk $(srcdir)/viewer/template.html > $@.tmp && mv $@.tmp $@

# A tarball without the page would be a tarball for those who have npm.
dist-hook: viewer-is-there
viewer-is-there:
	@test -s $(srcdir)/viewer/template.html || \
	    { echo "a release needs the page: rm viewer/template.html, then make with npm at hand" >&2; exit 1; }
.PHONY: viewer-is-there
