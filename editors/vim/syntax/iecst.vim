" SPDX-License-Identifier: MIT
" Structured Text and textual Sequential Function Charts (IEC 61131-3): keywords, types, literals and comments.
if exists('b:current_syntax')
    finish
endif

syntax case ignore
syntax keyword iecstDeclaration PROGRAM END_PROGRAM FUNCTION_BLOCK END_FUNCTION_BLOCK FUNCTION END_FUNCTION TYPE END_TYPE
syntax keyword iecstDeclaration STRUCT END_STRUCT CONFIGURATION END_CONFIGURATION RESOURCE END_RESOURCE TASK ON WITH AT
syntax keyword iecstDeclaration VAR VAR_INPUT VAR_OUTPUT VAR_IN_OUT VAR_TEMP VAR_GLOBAL VAR_EXTERNAL END_VAR
syntax keyword iecstDeclaration CONSTANT RETAIN NON_RETAIN PERSISTENT ARRAY OF
syntax keyword iecstDeclaration INITIAL_STEP STEP END_STEP TRANSITION FROM TO END_TRANSITION ACTION END_ACTION PRIORITY
syntax keyword iecstStatement IF THEN ELSIF ELSE END_IF CASE END_CASE FOR BY DO END_FOR WHILE END_WHILE
syntax keyword iecstStatement REPEAT UNTIL END_REPEAT RETURN EXIT
syntax keyword iecstOperator AND OR XOR NOT MOD AND_THEN OR_ELSE
syntax keyword iecstType BOOL SINT INT DINT USINT UINT UDINT BYTE WORD DWORD TIME REAL STRING
syntax keyword iecstBoolean TRUE FALSE
syntax match iecstNumber '\<\d[0-9_]*\(\.\d[0-9_]*\)\?\>'
syntax match iecstNumber '\<\(T\|TIME\|2\|8\|16\)#[0-9A-Za-z_.]\+'
syntax match iecstAddress '%[IQM][XBWD]\?[0-9.*]\+'
syntax region iecstString start=+'+ end=+'+ oneline
syntax region iecstComment start='(\*' end='\*)'
syntax region iecstComment start='/\*' end='\*/'
syntax match iecstComment '//.*$'

highlight default link iecstDeclaration Keyword
highlight default link iecstStatement Statement
highlight default link iecstOperator Operator
highlight default link iecstType Type
highlight default link iecstBoolean Boolean
highlight default link iecstNumber Number
highlight default link iecstAddress Identifier
highlight default link iecstString String
highlight default link iecstComment Comment

let b:current_syntax = 'iecst'
