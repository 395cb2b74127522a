# Completions of the shells, where bash-completion and zsh look for them.
bashcompletiondir = $(datadir)/bash-completion/completions
zshcompletiondir  = $(datadir)/zsh/site-functions
dist_zshcompletion_DATA = completions/_weft
EXTRA_DIST += completions/weft.bash

# bash-completion finds a file by the command's name alone.
install-data-local:
	$(MKDIR_P) '$(DESTDIR)$(bashcompletiondir)'
	$(INSTALL_DATA) $(srcdir)/completions/weft.bash '$(DESTDIR)$(bashcompletiondir)/weft'
uninstall-local:
	rm -f '$(DESTDIR)$(bashcompletiondir)/weft'
