" SPDX-License-Identifier: MIT
" Vim detects `.st` as Smalltalk. The file type of Structured Text is named `iecst`.
autocmd BufNewFile,BufRead *.st set filetype=iecst
