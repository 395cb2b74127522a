" SPDX-License-Identifier: GPL-3.0-or-later
" Files of the knitting language of weft.
autocmd BufRead,BufNewFile *.knit setfiletype knit
