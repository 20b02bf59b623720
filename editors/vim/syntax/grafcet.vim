" SPDX-License-Identifier: MIT
" The .grafcet language of grafverif: GRAFCET charts (IEC 60848), plant components, closed loops.
" A keyword that may also be a name is coloured only if the text after it cannot follow a name. The keywords are those of
" editors/words.json; the colours are those of editors/vscode/syntaxes/grafcet.tmLanguage.json.
scriptencoding utf-8
if exists('b:current_syntax')
    finish
endif
let s:save_cpo = &cpo
set cpo&vim

syn case match
syn sync minlines=200
syn iskeyword @,48-57,_,192-255

" Reserved words.
syn keyword grafcetDeclaration grafcet component closed_loop nextgroup=grafcetTypeName skipwhite
syn keyword grafcetDeclaration input output internal
syn keyword grafcetDeclaration step nextgroup=grafcetStepName skipwhite
syn keyword grafcetDeclaration transition nextgroup=grafcetLabel skipwhite
syn keyword grafcetControl include when do force
syn keyword grafcetLogic and or not
syn keyword grafcetConstant true false
syn keyword grafcetPattern always never inevitable possible
syn keyword grafcetPattern reachable nextgroup=grafcetAllSteps skipwhite

" Any other name, with letters of any script (`\K\k*`). Later items have priority over this one.
syn match grafcetName /\<\K\k*/

" Keywords before a term, a label or a string; a name is never followed by a term, a label or a string.
let s:free = '\.\@1<!\<\%('
let s:operand = '\%(\%(and\|or\|when\|do\)\>\)\@!'
let s:follows = '\%(\%(implies\|in\|leads\s\+to\|at\s\+\%(stable\|most\|least\)\|on\s\+\%(activation\|deactivation\|event\)\|holds\s\+\%(for\|at\)\|precedes\|within\|before\|after\|between\|until\|since\)\>\)\@!'
let s:named = '\)\>\%(\s*\%($\|\/\/\|\/\*\|(\)\|\s\+' . s:operand . '\%(\k\|[↑↓]\|!=\@!\|-[>[:space:]]\@!\)\)\@='
let s:term = '\)\>\%(\s*\%($\|\/\/\|\/\*\|(\)\|\s\+' . s:operand . s:follows . '\%(\k\|[↑↓]\|!=\@!\|-[>[:space:]]\@!\)\)\@='
exe 'syn match grafcetDeclaration /' . s:free . 'variable\|clock\|constraint\|constant\|accept\|grain\|schedule\|plant\|environment' . s:term . '/'
exe 'syn match grafcetDeclaration /' . s:free . 'partial\|expansion\|observer' . s:term . '/ nextgroup=grafcetBlockName skipwhite'
exe 'syn match grafcetDeclaration /' . s:free . 'controller' . s:term . '/ nextgroup=grafcetTypeName skipwhite'
exe 'syn match grafcetDeclaration /' . s:free . 'program\)\>\%(\s\+\K\k*\s*\%(=\s*"\|$\)\)\@=/ nextgroup=grafcetTypeName skipwhite'
exe 'syn match grafcetDeclaration /' . s:free . 'location' . s:named . '/ nextgroup=grafcetStepName skipwhite'
exe 'syn match grafcetDeclaration /' . s:free . 'property' . s:term . '/ nextgroup=grafcetPropertyName skipwhite'
exe 'syn match grafcetDeclaration /' . s:free . 'fault' . s:term . '/'
exe 'syn match grafcetDeclaration /' . s:free . 'fault\)\>\%(\s\+\K\k*\s\+of\>\)\@=/ nextgroup=grafcetFaultName skipwhite'
exe 'syn match grafcetControl /' . s:free . 'if\|after\|for\|with\|invariant\|initially\|expands\|encloses' . s:term . '/'
exe 'syn match grafcetLogic /' . s:free . 'implies\|in' . s:term . '/'
exe 'syn match grafcetPattern /' . s:free . 'precedes\|within\|before\|between\|until\|since' . s:term . '/'
exe 'syn match grafcetModifier /' . s:free . 'urgent\|timed\)\>\%(\s*$\|\s\+' . s:operand . '\k\)\@=/'
exe 'syn match grafcetModifier /' . s:free . 'initial\|linked\|entry\|exit\|macro\|enclosing\)\>' .
            \ '\%(\s*$\|\s\+\%(initial\|linked\|entry\|exit\|macro\|enclosing\|step\|location\)\>\)\@=/'
exe 'syn match grafcetPattern /' . s:free . 'uppaal\|ctl\|ltl\)\>\%(\s*\%($\|"\)\)\@=/'
exe 'syn match grafcetPattern /' . s:free . 'all\|any\)\>\%(\s*(\)\@=/'
exe 'syn match grafcetEdge /' . s:free . 'rise\|fall\)\>\%(\s*(\)\@=/'
syn match grafcetEdge /[↑↓]/

" Keywords of two words.
exe 'syn match grafcetDeclaration /' . s:free . 'time\)\s\+unit\>/'
exe 'syn match grafcetControl /' . s:free . 'on\)\s\+\%(activation\|deactivation\|event\)\>/'
exe 'syn match grafcetControl /' . s:free . 'expected\)\s\+violated\>/'
exe 'syn match grafcetControl /' . s:free . 'at\)\s\+stable\>/'
exe 'syn match grafcetPattern /' . s:free . 'leads\)\s\+to\>/'
exe 'syn match grafcetPattern /' . s:free . 'holds\)\%(\s\+\%(for\|at\)\>\)\@=/'
exe 'syn match grafcetControl /' . s:free . 'at\)\%(\s\+\%(most\|least\s\+every\)\>\)\@=/'
exe 'syn match grafcetControl /\%(\<holds\s\+\)\@<=for\>/'
exe 'syn match grafcetPattern /\%(\<at\s\+\)\@<=\%(most\|least\%(\s\+every\>\)\@=\)\>/'
exe 'syn match grafcetPattern /\%(\<at\s\+least\s\+\)\@<=every\>/'
exe 'syn match grafcetPattern /\%(\<at\s\+most\s\+\%([0-9]\+\|\K\k*\)\s\+\)\@<=times\?\>/'
exe 'syn match grafcetPattern /' . s:free . 'no\)\s\+\%(deadlock\|timelock\)\>/'
exe 'syn match grafcetPattern /' . s:free . 'exactly\)\s\+one\s\+of\>/'
syn match grafcetAllSteps /\<all\s\+steps\>/ contained
syn match grafcetType /\%(:\s*\)\@<=\%(bool\|int\|duration\)\>\%(\s*\%(->\|\%(leads\|implies\|in\|precedes\|holds\|at\)\>\)\)\@!/

" Names at their declaration.
syn match grafcetTypeName /\<\%(\%(and\|or\|when\|do\)\>\)\@!\K\k*/ contained
syn match grafcetTypeName /\%([:=!<>]\@1<!=\s*\)\@<=\%(\%(not\|rise\|fall\|all\|any\)\>\)\@!\<\K\k*\%(\s*(\)\@=/
syn match grafcetBlockName /\<\K\k*\%(\s*\%({\|=\|\[\|$\)\)\@=/ contained
syn match grafcetStepName /\<\%(\%(and\|or\|when\|do\|step\|transition\|input\|output\|internal\)\>\)\@!\k\+/ contained
syn match grafcetLabel /\<\k\+\%(\s*:\)\@=/ contained
syn match grafcetPropertyName /\<\K\k*/ contained
syn match grafcetFaultName /\<\K\k*/ contained nextgroup=grafcetFaultOf skipwhite
syn match grafcetFaultOf /\<of\>/ contained

" Values, operators, strings and comments.
syn match grafcetStepVariable /\<X[0-9]\k*\>/
syn match grafcetNumber /\<[0-9]\+\>/
syn match grafcetInvalid /\<[0-9]\+\%(\.[0-9]\+\k*\|\K\k*\)/
syn match grafcetDuration /\<[0-9]\+\%(\.[0-9]\+\)\?\%(ms\|s\|min\)\>/
syn match grafcetOperator /[-!<>+*\/%=]/
syn match grafcetInvalid /<>\|&\||/
syn match grafcetOperator /:=\|->\|=>\|&&\|||\|==\|!=\|<=\|>=\|\.\./
syn match grafcetAccept /\.\@1<!\<accept\s\+\%(\%(when\|do\)\>\)\@!\K\k*\%(-\K\k*\)*/ contains=grafcetAcceptWord
syn match grafcetAcceptWord /\<accept\%(\s\)\@=/ contained nextgroup=grafcetFinding skipwhite
syn match grafcetFinding /[A-Za-z0-9_-]\+/ contained
syn match grafcetInvalid /"[^"]*$/
syn match grafcetString /"[^"]*"/ contains=@Spell
syn keyword grafcetTodo TODO FIXME XXX contained
syn match grafcetComment "//.*$" contains=grafcetTodo,@Spell
syn region grafcetComment start="/\*" end="\*/" contains=grafcetTodo,@Spell

hi def link grafcetDeclaration Type
hi def link grafcetModifier StorageClass
hi def link grafcetControl Keyword
hi def link grafcetLogic Operator
hi def link grafcetEdge Function
hi def link grafcetConstant Boolean
hi def link grafcetType Type
hi def link grafcetPattern Statement
hi def link grafcetAllSteps grafcetPattern
hi def link grafcetTypeName Identifier
hi def link grafcetBlockName grafcetTypeName
hi def link grafcetStepName Identifier
hi def link grafcetLabel Function
hi def link grafcetPropertyName grafcetLabel
hi def link grafcetFaultName grafcetLabel
hi def link grafcetFaultOf grafcetPattern
hi def link grafcetStepVariable Special
hi def link grafcetNumber Number
hi def link grafcetDuration Float
hi def link grafcetOperator Operator
hi def link grafcetAcceptWord grafcetDeclaration
hi def link grafcetFinding Constant
hi def link grafcetInvalid Error
hi def link grafcetString String
hi def link grafcetTodo Todo
hi def link grafcetComment Comment

let b:current_syntax = 'grafcet'
let &cpo = s:save_cpo
unlet s:save_cpo s:free s:operand s:follows s:term
