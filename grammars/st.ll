/* SPDX-License-Identifier: MIT */
/* Tokens of Structured Text and of textual Sequential Function Charts. This file defines the syntax of the tokens;
   syntax/st/st_lexer computes their values. */
%option reentrant noyywrap nodefault batch never-interactive 8bit nounput noinput nounistd case-insensitive
%option prefix="st_"

%{
#include <new>

#include "syntax/st/st_lexer.hpp"

using Kind = grafverif::st::Parser::token;
using Section = grafverif::st::Section;

// NOLINTBEGIN
#define YY_DECL grafverif::st::Parser::symbol_type st_scan(grafverif::st::Lexer& lexer, yyscan_t yyscanner)
#define YY_USER_ACTION lexer.advance(static_cast<std::size_t>(yyleng));
#define YY_FATAL_ERROR(message) throw std::bad_alloc()   /* only a failed memory allocation causes it */
// NOLINTEND
#define MATCH std::string_view(yytext, static_cast<std::size_t>(yyleng))
%}

DIGITS      [0-9](_?[0-9])*
NAME        [A-Z_][A-Z0-9_]*

%%

[ \t\r\n\f\v]+ { }
"//"[^\n]*      { lexer.comment(MATCH); }
"(*"([^*]|\*+[^*)])*\*+")"   { lexer.comment(MATCH); }
"/*"([^*]|\*+[^*/])*\*+"/"   { lexer.comment(MATCH); }
"(*"([^*]|\*+[^*)])*\**      { return lexer.unterminated("comment", "*)"); }
"/*"([^*]|\*+[^*/])*\**      { return lexer.unterminated("comment", "*/"); }
"{"[^}]*"}"     { }

"IF"            return lexer.sign(Kind::IF);
"THEN"          return lexer.sign(Kind::THEN);
"ELSIF"         return lexer.sign(Kind::ELSIF);
"ELSE"          return lexer.sign(Kind::ELSE);
"ELSEIF"        return lexer.extension(Kind::ELSIF, MATCH, "`ELSIF`");
"END_IF"        return lexer.sign(Kind::END_IF);
"CASE"          return lexer.sign(Kind::CASE);
"OF"            return lexer.sign(Kind::OF);
"END_CASE"      return lexer.sign(Kind::END_CASE);
"FOR"           return lexer.sign(Kind::FOR);
"TO"            return lexer.sign(Kind::TO);
"BY"            return lexer.sign(Kind::BY);
"DO"            return lexer.sign(Kind::DO);
"END_FOR"       return lexer.sign(Kind::END_FOR);
"WHILE"         return lexer.sign(Kind::WHILE);
"END_WHILE"     return lexer.sign(Kind::END_WHILE);
"REPEAT"        return lexer.sign(Kind::REPEAT);
"UNTIL"         return lexer.sign(Kind::UNTIL);
"END_REPEAT"    return lexer.sign(Kind::END_REPEAT);
"RETURN"        return lexer.sign(Kind::RETURN);
"EXIT"          return lexer.sign(Kind::EXIT);
"AND"|"&"       return lexer.sign(Kind::AND);
"OR"            return lexer.sign(Kind::OR);
"AND_THEN"      return lexer.sign(Kind::AND_THEN);
"OR_ELSE"       return lexer.sign(Kind::OR_ELSE);
"XOR"           return lexer.sign(Kind::XOR);
"NOT"           return lexer.sign(Kind::NOT);
"MOD"           return lexer.sign(Kind::MOD);
("BOOL#")?"TRUE"   return lexer.sign(Kind::TRUE);
("BOOL#")?"FALSE"  return lexer.sign(Kind::FALSE);
"BOOL#1"        return lexer.sign(Kind::TRUE);
"BOOL#0"        return lexer.sign(Kind::FALSE);

"PROGRAM"       return lexer.unit_word(Kind::PROGRAM, MATCH);
"END_PROGRAM"   return lexer.unit_word(Kind::END_PROGRAM, MATCH);
"FUNCTION_BLOCK"      return lexer.unit_word(Kind::FUNCTION_BLOCK, MATCH);
"END_FUNCTION_BLOCK"  return lexer.unit_word(Kind::END_FUNCTION_BLOCK, MATCH);
"FUNCTION"      return lexer.unit_word(Kind::FUNCTION, MATCH);
"END_FUNCTION"  return lexer.unit_word(Kind::END_FUNCTION, MATCH);
"VAR_INPUT"     return lexer.section(Section::Input);
"VAR_OUTPUT"    return lexer.section(Section::Output);
"VAR_IN_OUT"    return lexer.section(Section::InOut);
"VAR_EXTERNAL"  return lexer.section(Section::External);
"VAR_GLOBAL"    return lexer.section(Section::Global);
"VAR_TEMP"      return lexer.section(Section::Temporary);
"VAR"|"VAR_STAT"      return lexer.section(Section::Local);
"END_VAR"       return lexer.unit_word(Kind::END_VAR, MATCH);
"AT"            return lexer.unit_word(Kind::AT, MATCH);
"CONSTANT"      return lexer.unit_word(Kind::CONSTANT, MATCH);
"RETAIN"|"PERSISTENT" return lexer.unit_word(Kind::RETAIN, MATCH);
"NON_RETAIN"    return lexer.unit_word(Kind::NON_RETAIN, MATCH);
"ARRAY"         return lexer.unit_word(Kind::ARRAY, MATCH);
"POINTER"|"REFERENCE" return lexer.unit_word(Kind::REFERENCE, MATCH);
"TYPE"          return lexer.unit_word(Kind::TYPE, MATCH);
"END_TYPE"      return lexer.unit_word(Kind::END_TYPE, MATCH);
"CONFIGURATION" return lexer.unit_word(Kind::CONFIGURATION, MATCH);
"END_CONFIGURATION"   return lexer.unit_word(Kind::END_CONFIGURATION, MATCH);
"INITIAL_STEP"  return lexer.unit_word(Kind::INITIAL_STEP, MATCH);
"STEP"          return lexer.unit_word(Kind::STEP, MATCH);
"END_STEP"      return lexer.unit_word(Kind::END_STEP, MATCH);
"TRANSITION"    return lexer.unit_word(Kind::TRANSITION, MATCH);
"FROM"          return lexer.unit_word(Kind::FROM, MATCH);
"END_TRANSITION"      return lexer.unit_word(Kind::END_TRANSITION, MATCH);
"ACTION"        return lexer.unit_word(Kind::ACTION, MATCH);
"END_ACTION"    return lexer.unit_word(Kind::END_ACTION, MATCH);
"STRUCT"        return lexer.type_word(Kind::STRUCT, MATCH);
"END_STRUCT"    return lexer.type_word(Kind::END_STRUCT, MATCH);
"RESOURCE"      return lexer.configuration_word(Kind::RESOURCE, MATCH);
"END_RESOURCE"  return lexer.configuration_word(Kind::END_RESOURCE, MATCH);
"ON"            return lexer.configuration_word(Kind::ON, MATCH);
"TASK"          return lexer.configuration_word(Kind::TASK, MATCH);
"WITH"          return lexer.configuration_word(Kind::WITH, MATCH);
"PRIORITY"      return lexer.word(Kind::PRIORITY, MATCH);

{NAME}          return lexer.word(Kind::IDENTIFIER, MATCH);
{DIGITS}        return lexer.integer(MATCH, 10);
"2#"[01](_?[01])*           return lexer.integer(MATCH.substr(2), 2);
"8#"[0-7](_?[0-7])*         return lexer.integer(MATCH.substr(2), 8);
"16#"[0-9A-F](_?[0-9A-F])*  return lexer.integer(MATCH.substr(3), 16);
[A-Z]+"#"[+-]?{DIGITS}      return lexer.typed_integer(MATCH);
(L?"T"|L?"TIME")"#"[0-9A-Z_.+-]+    return lexer.time(MATCH);
{DIGITS}"."{DIGITS}(E[+-]?{DIGITS})?      return lexer.word(Kind::LITERAL, MATCH);
("TOD"|"TIME_OF_DAY"|"DT"|"DATE_AND_TIME")"#"[0-9.:+-]+     return lexer.word(Kind::LITERAL, MATCH);
{NAME}"#"[A-Z0-9_.+-]+      return lexer.word(Kind::LITERAL, MATCH);
"'"([^'$\n]|"$".)*"'"       return lexer.word(Kind::LITERAL, MATCH);
"\""([^"$\n]|"$".)*"\""     return lexer.word(Kind::LITERAL, MATCH);
"%"[IQM][A-Z0-9.*]+         return lexer.word(Kind::ADDRESS, MATCH);

":="            return lexer.sign(Kind::ASSIGN);
"=>"            return lexer.sign(Kind::RESULT);
".."            return lexer.sign(Kind::RANGE);
"("             return lexer.sign(Kind::LEFT);
")"             return lexer.sign(Kind::RIGHT);
"["             return lexer.sign(Kind::OPEN);
"]"             return lexer.sign(Kind::CLOSE);
","             return lexer.sign(Kind::COMMA);
";"             return lexer.sign(Kind::SEMICOLON);
":"             return lexer.sign(Kind::COLON);
"."             return lexer.sign(Kind::DOT);
"<"             return lexer.sign(Kind::LESS);
"<="            return lexer.sign(Kind::LESS_EQUAL);
">"             return lexer.sign(Kind::GREATER);
">="            return lexer.sign(Kind::GREATER_EQUAL);
"="             return lexer.sign(Kind::EQUAL);
"<>"            return lexer.sign(Kind::NOT_EQUAL);
"+"             return lexer.sign(Kind::PLUS);
"-"             return lexer.sign(Kind::MINUS);
"*"             return lexer.sign(Kind::TIMES);
"/"             return lexer.sign(Kind::DIVIDE);
"**"            return lexer.sign(Kind::POWER);
"^"             return lexer.sign(Kind::CARET);
"!"             return lexer.c_sign(Kind::NOT, MATCH);
"&&"            return lexer.c_sign(Kind::AND, MATCH);
"||"            return lexer.c_sign(Kind::OR, MATCH);
"=="            return lexer.c_sign(Kind::EQUAL, MATCH);
"!="            return lexer.c_sign(Kind::NOT_EQUAL, MATCH);

[\xC0-\xFF][\x80-\xBF]*     return lexer.unexpected_character(MATCH);
.               return lexer.unexpected_character(MATCH);
<<EOF>>         return lexer.end_of_piece();

%%

namespace grafverif::st {

Scanner::Scanner(std::string_view text) {
    if (st_lex_init(&state_) != 0) throw std::bad_alloc();
    st__scan_bytes(text.data(), static_cast<int>(text.size()), state_);
}

Scanner::~Scanner() { st_lex_destroy(state_); }

Parser::symbol_type Scanner::next(Lexer& lexer) { return st_scan(lexer, state_); }

}  // namespace grafverif::st
