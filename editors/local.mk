# For editors: a TextMate grammar (Visual Studio Code, Sublime Text, ...) and vim.
editorsdir     = $(pkgdatadir)/editors
vimsyntaxdir   = $(datadir)/vim/vimfiles/syntax
vimftdetectdir = $(datadir)/vim/vimfiles/ftdetect
dist_editors_DATA     = editors/knit.tmLanguage.json
dist_vimsyntax_DATA   = editors/vim/syntax/knit.vim
dist_vimftdetect_DATA = editors/vim/ftdetect/knit.vim
