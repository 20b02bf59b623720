" SPDX-License-Identifier: MIT
" Comments, the canonical layout, and `:make`, which runs `grafverif check` and collects the positions of its errors.
if exists('b:did_ftplugin')
    finish
endif
let b:did_ftplugin = 1

setlocal comments=s1:/*,mb:*,ex:*/,:// commentstring=//\ %s formatoptions-=t formatoptions+=croql
setlocal expandtab shiftwidth=4 softtabstop=4 smartindent textwidth=120
setlocal include=^\\s*include\\s*\" suffixesadd=.grafcet
setlocal makeprg=grafverif\ check\ --quiet\ --color\ never\ $*\ --\ %:S
setlocal errorformat=%f:%l:%c:\ %trror:\ %m,%f:%l:%c:\ %tarning:\ %m,%-G%.%#
let b:undo_ftplugin = 'setlocal comments< commentstring< formatoptions< expandtab< shiftwidth< softtabstop< smartindent< textwidth<'
            \ . ' include< suffixesadd< makeprg< errorformat<'
