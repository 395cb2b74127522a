# The man page: made where weft is built from a checkout, ready in a release.
dist_man_MANS = docs/weft.1
EXTRA_DIST += docs/weft.1.in docs/manpage.sh
MAINTAINERCLEANFILES += docs/weft.1
docs/weft.1: docs/weft.1.in docs/manpage.sh cli/command.c cli/options.c | weft$(EXEEXT)
	$(AM_V_GEN)$(MKDIR_P) docs && \
	$(SHELL) $(srcdir)/docs/manpage.sh ./weft$(EXEEXT) $(srcdir)/docs/weft.1.in > $@.tmp && mv $@.tmp $@

# The manual. Its Markdown is read as it is; `make docs` makes pages of it with pandoc.
MANUAL = index first-swatch knitters researchers experiments language stitches formats numerics stability errors
manual_files = docs/index.md docs/first-swatch.md docs/knitters.md docs/researchers.md docs/experiments.md docs/language.md \
    docs/stitches.md docs/formats.md docs/numerics.md docs/stability.md docs/errors.md
dist_doc_DATA = README.md NEWS.md
manualdir = $(docdir)/manual
dist_manual_DATA = $(manual_files)
EXTRA_DIST += docs/manual/build.sh docs/manual/filter.lua docs/manual/stitches.sh docs/manual/style.css \
    docs/manual/template.html

docs: weft$(EXEEXT)
	@test '$(PANDOC)' != no || { echo 'make docs needs pandoc; the manual is readable as it is, in docs/*.md' >&2; exit 1; }
	$(srcdir)/docs/manual/stitches.sh ./weft$(EXEEXT) docs/html/stitches
	$(srcdir)/docs/manual/build.sh ./weft$(EXEEXT) docs/html $(MANUAL)
stitches: weft$(EXEEXT)
	$(srcdir)/docs/manual/stitches.sh ./weft$(EXEEXT) >$(srcdir)/docs/stitches.md
clean-docs:
	rm -rf docs/html
install-docs:
	test ! -d docs/html || { $(MKDIR_P) '$(DESTDIR)$(docdir)' && cp -R docs/html '$(DESTDIR)$(docdir)'; }
uninstall-docs:
	rm -rf '$(DESTDIR)$(docdir)/html'
clean-local: clean-docs
install-data-local: install-docs
uninstall-local: uninstall-docs
.PHONY: docs stitches clean-docs install-docs uninstall-docs
