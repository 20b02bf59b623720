/* SPDX-License-Identifier: MIT */
/* Tokens of the .grafcet language. This file defines the syntax of the tokens; syntax/language/lexer computes their
   values. The lexer reports a lexical error immediately, and the parser then resumes at the next declaration. */
%option reentrant noyywrap nodefault batch never-interactive 8bit nounput noinput nounistd
%option prefix="grafcet_"

%{
#include <new>

#include "syntax/language/lexer.hpp"

using Kind = grafverif::tree::Parser::token;

// NOLINTBEGIN
#define YY_DECL grafverif::tree::Parser::symbol_type grafcet_scan(grafverif::tree::Lexer& lexer, yyscan_t yyscanner)
#define YY_USER_ACTION lexer.advance({yytext, static_cast<std::size_t>(yyleng)});
#define YY_FATAL_ERROR(message) throw std::bad_alloc()   /* only a failed memory allocation causes it */
// NOLINTEND
%}

DIGITS      [0-9]+
WIDE        [\xC2-\xDF][\x80-\xBF]|[\xE0\xE1\xE3-\xEF][\x80-\xBF]{2}|\xE2[\x80-\x85\x87-\xBF][\x80-\xBF]|\xE2\x86[\x80-\x90\x92\x94-\xBF]|[\xF0-\xF4][\x80-\xBF]{3}
NAME        [A-Za-z_][A-Za-z0-9_]*
WIDE_NAME   ([A-Za-z_]|{WIDE})([A-Za-z0-9_]|{WIDE})*
COMMENT     "/*"([^*]|\*+[^*/])*

%%

[ \t\r\f\v]+   { }
\n+             { lexer.lines(); }
"//"[^\n]*      { lexer.comment(); }
{COMMENT}\*+"/" { lexer.comment(); }
{COMMENT}\**    { return lexer.unterminated_comment(); }

"grafcet"       return lexer.word(Kind::GRAFCET);
"component"     return lexer.word(Kind::COMPONENT);
"closed_loop"   return lexer.word(Kind::CLOSED_LOOP);
"include"       return lexer.word(Kind::INCLUDE);
"input"         return lexer.word(Kind::INPUT);
"output"        return lexer.word(Kind::OUTPUT);
"internal"      return lexer.word(Kind::INTERNAL);
"step"          return lexer.word(Kind::STEP);
"transition"    return lexer.word(Kind::TRANSITION);
"when"          return lexer.word(Kind::WHEN);
"do"            return lexer.word(Kind::DO);
"force"         return lexer.word(Kind::FORCE);
"and"           return lexer.word(Kind::AND_WORD);
"or"            return lexer.word(Kind::OR_WORD);
"not"           return lexer.word(Kind::NOT_WORD);
"implies"       return lexer.word(Kind::IMPLIES_WORD);
"in"            return lexer.word(Kind::IN);
"any"           return lexer.word(Kind::ANY);
"true"          return lexer.word(Kind::TRUE);
"false"         return lexer.word(Kind::FALSE);
"always"        return lexer.word(Kind::ALWAYS);
"never"         return lexer.word(Kind::NEVER);
"reachable"     return lexer.word(Kind::REACHABLE);
"inevitable"    return lexer.word(Kind::INEVITABLE);
"possible"      return lexer.word(Kind::POSSIBLE);
"constraint"    return lexer.word(Kind::CONSTRAINT);
"constant"      return lexer.word(Kind::CONSTANT);
"initial"       return lexer.word(Kind::INITIAL_WORD);
"linked"        return lexer.word(Kind::LINKED);
"entry"         return lexer.word(Kind::ENTRY);
"exit"          return lexer.word(Kind::EXIT);
"macro"         return lexer.word(Kind::MACRO);
"expands"       return lexer.word(Kind::EXPANDS);
"enclosing"     return lexer.word(Kind::ENCLOSING);
"encloses"      return lexer.word(Kind::ENCLOSES);
"partial"       return lexer.word(Kind::PARTIAL);
"expansion"     return lexer.word(Kind::EXPANSION);
"if"            return lexer.word(Kind::IF);
"after"         return lexer.word(Kind::AFTER);
"for"           return lexer.word(Kind::FOR);
"on"            return lexer.word(Kind::ON);
"activation"    return lexer.word(Kind::ACTIVATION);
"deactivation"  return lexer.word(Kind::DEACTIVATION);
"event"         return lexer.word(Kind::EVENT);
"bool"          return lexer.word(Kind::BOOL);
"int"           return lexer.word(Kind::INT);
"duration"      return lexer.word(Kind::DURATION_WORD);
"variable"      return lexer.word(Kind::VARIABLE);
"clock"         return lexer.word(Kind::CLOCK);
"location"      return lexer.word(Kind::LOCATION);
"invariant"     return lexer.word(Kind::INVARIANT);
"with"          return lexer.word(Kind::WITH);
"urgent"        return lexer.word(Kind::URGENT);
"timed"         return lexer.word(Kind::TIMED);
"controller"    return lexer.word(Kind::CONTROLLER);
"grain"         return lexer.word(Kind::GRAIN);
"time"          return lexer.word(Kind::TIME);
"unit"          return lexer.word(Kind::UNIT);
"plant"         return lexer.word(Kind::PLANT);
"environment"   return lexer.word(Kind::ENVIRONMENT);
"initially"     return lexer.word(Kind::INITIALLY);
"property"      return lexer.word(Kind::PROPERTY);
"expected"      return lexer.word(Kind::EXPECTED);
"violated"      return lexer.word(Kind::VIOLATED);
"at"            return lexer.word(Kind::AT);
"stable"        return lexer.word(Kind::STABLE);
"leads"         return lexer.word(Kind::LEADS);
"to"            return lexer.word(Kind::TO);
"no"            return lexer.word(Kind::NO);
"deadlock"      return lexer.word(Kind::DEADLOCK);
"timelock"      return lexer.word(Kind::TIMELOCK);
"all"           return lexer.word(Kind::ALL);
"steps"         return lexer.word(Kind::STEPS);
"exactly"       return lexer.word(Kind::EXACTLY);
"one"           return lexer.word(Kind::ONE);
"of"            return lexer.word(Kind::OF);
"uppaal"        return lexer.word(Kind::UPPAAL);
"ctl"           return lexer.word(Kind::CTL);
"ltl"           return lexer.word(Kind::LTL);
"observer"      return lexer.word(Kind::OBSERVER);
"schedule"      return lexer.word(Kind::SCHEDULE);
"fault"         return lexer.word(Kind::FAULT);
"accept"        return lexer.word(Kind::ACCEPT);
"within"        return lexer.word(Kind::WITHIN);
"holds"         return lexer.word(Kind::HOLDS);
"most"          return lexer.word(Kind::MOST);
"least"         return lexer.word(Kind::LEAST);
"every"         return lexer.word(Kind::EVERY);
"since"         return lexer.word(Kind::SINCE);
"before"        return lexer.word(Kind::BEFORE);
"between"       return lexer.word(Kind::BETWEEN);
"until"         return lexer.word(Kind::UNTIL);
"precedes"      return lexer.word(Kind::PRECEDES);
"program"       return lexer.word(Kind::PROGRAM);
"times"         return lexer.word(Kind::TIMES_WORD);
"rise"          return lexer.word(Kind::RISE);
"fall"          return lexer.word(Kind::FALL);

{NAME}          return lexer.word(Kind::IDENTIFIER);
{WIDE_NAME}     return lexer.wide_name();
{DIGITS}        return lexer.word(Kind::NUMBER);
{DIGITS}(\.{DIGITS})?{NAME}   return lexer.duration();
{DIGITS}\.{DIGITS}           return lexer.decimal_without_unit();
\"[^"\n]*\"     return lexer.string();
\"[^"\n]*      return lexer.unterminated_string();

"&&"            return lexer.sign(Kind::AND);
"||"            return lexer.sign(Kind::OR);
"!"             return lexer.sign(Kind::NOT);
"=="            return lexer.sign(Kind::EQUAL);
"!="            return lexer.sign(Kind::NOT_EQUAL);
"=>"            return lexer.sign(Kind::IMPLIES);
"<"             return lexer.sign(Kind::LESS);
"<="            return lexer.sign(Kind::LESS_EQUAL);
">"             return lexer.sign(Kind::GREATER);
">="            return lexer.sign(Kind::GREATER_EQUAL);
"+"             return lexer.sign(Kind::PLUS);
"-"             return lexer.sign(Kind::MINUS);
"*"             return lexer.sign(Kind::TIMES);
"/"             return lexer.sign(Kind::DIVIDE);
"%"             return lexer.sign(Kind::MODULO);
"↑"             return lexer.sign(Kind::UP);
"↓"             return lexer.sign(Kind::DOWN);
":="            return lexer.sign(Kind::ASSIGN);
"="             return lexer.sign(Kind::IS);
"->"            return lexer.sign(Kind::ARROW);
".."            return lexer.sign(Kind::RANGE);
"."             return lexer.sign(Kind::DOT);
","             return lexer.sign(Kind::COMMA);
";"             return lexer.sign(Kind::SEMICOLON);
":"             return lexer.sign(Kind::COLON);
"{"             return lexer.sign(Kind::OPEN);
"}"             return lexer.sign(Kind::CLOSE);
"("             return lexer.sign(Kind::LEFT);
")"             return lexer.sign(Kind::RIGHT);
"["             return lexer.index();
"]"             return lexer.sign(Kind::INDEX_END);

"<>"            return lexer.other_spelling(Kind::NOT_EQUAL, "!=");
"&"             return lexer.other_spelling(Kind::AND, "&&");
"|"             return lexer.other_spelling(Kind::OR, "||");

[\xC0-\xFF][\x80-\xBF]*     return lexer.unexpected_character();
.               return lexer.unexpected_character();
<<EOF>>         return lexer.sign(Kind::END);

%%

namespace grafverif::tree {

Scanner::Scanner(std::string_view text) {
    if (grafcet_lex_init(&state_) != 0) throw std::bad_alloc();
    grafcet__scan_bytes(text.data(), static_cast<int>(text.size()), state_);
}

Scanner::~Scanner() { grafcet_lex_destroy(state_); }

Parser::symbol_type Scanner::next(Lexer& lexer) { return grafcet_scan(lexer, state_); }

}  // namespace grafverif::tree
