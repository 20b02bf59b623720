" SPDX-License-Identifier: MIT
" vim -es -u NONE -i NONE --cmd 'let g:files = [...]' --cmd 'let g:output = FILE' -S tokens.vim: writes to FILE the
" highlighting of each file by the syntax for Vim, in the format of tokens.js.
set nocompatible encoding=utf-8 nomodeline synmaxcol=0 noswapfile fileformats=unix
let &runtimepath = expand('<sfile>:p:h:h:h') . '/editors/vim,' . &runtimepath
syntax on
filetype plugin on

" Groups of one category have different names if different groups may follow them.
let s:category = {'AllSteps': 'Pattern', 'AcceptWord': 'Declaration', 'BlockName': 'TypeName', 'PropertyName': 'Label', 'FaultName': 'Label', 'FaultOf': 'Pattern',
            \ 'Name': '', 'Accept': '', 'Todo': 'Comment'}

function! s:CategoryAt(line, column) abort
    let name = substitute(synIDattr(synID(a:line, a:column, 1), 'name'), '^grafcet', '', '')
    return get(s:category, name, name)
endfunction

function! s:Runs(number, text) abort
    let [found, column, byte, last] = [[], 0, 1, '']
    for character in split(a:text, '\zs')
        let column += 1
        let category = s:CategoryAt(a:number, byte)
        let byte += len(character)
        if character =~# '\s' && category !=# 'Comment' && category !=# 'String'
            let category = ''
        endif
        if category !=# '' && category ==# last
            let found[-1] .= character
        elseif category !=# ''
            call add(found, a:number . ':' . column . ' ' . category . ' ' . character)
        endif
        let last = category
    endfor
    return found
endfunction

let s:lines = []
for s:file in g:files
    execute 'edit' fnameescape(s:file)
    if &filetype !=# 'grafcet'
        setfiletype grafcet
    endif
    call add(s:lines, '== ' . s:file)
    for s:number in range(1, line('$'))
        call extend(s:lines, s:Runs(s:number, getline(s:number)))
    endfor
    bwipeout!
endfor
call writefile(s:lines, g:output)
qall!
