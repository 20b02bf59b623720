" SPDX-License-Identifier: MIT
autocmd BufNewFile,BufRead *.grafcet setfiletype grafcet
