" SPDX-License-Identifier: MIT
" Comments and indentation of Structured Text (IEC 61131-3).
if exists('b:did_ftplugin')
    finish
endif
let b:did_ftplugin = 1

setlocal comments=s1:(*,mb:*,ex:*),:// commentstring=(*\ %s\ *) formatoptions-=t formatoptions+=croql
setlocal expandtab shiftwidth=4 softtabstop=4 autoindent
let b:undo_ftplugin = 'setlocal comments< commentstring< formatoptions< expandtab< shiftwidth< softtabstop< autoindent<'
