// SPDX-License-Identifier: MIT
#include "lsp/scan.hpp"

#include <algorithm>
#include <array>
#include <cctype>
#include <optional>

#include "support/text/identifier.hpp"

namespace grafverif::lsp {

namespace {

constexpr std::array<std::string_view, 22> reserved = {
    "grafcet", "component",  "closed_loop", "include",   "input",      "output",  "internal", "step",
    "when",    "transition", "do",          "force",     "and",        "or",      "not",      "true",
    "false",   "always",     "never",       "reachable", "inevitable", "possible"};
constexpr std::array<std::string_view, 72> contextual = {
    "constraint",   "initial",     "linked",    "entry",    "exit",       "macro",    "expands",  "enclosing",
    "encloses",     "partial",     "expansion", "if",       "after",      "for",      "on",       "activation",
    "deactivation", "event",       "bool",      "int",      "duration",   "variable", "clock",    "location",
    "invariant",    "with",        "urgent",    "timed",    "controller", "grain",    "time",     "unit",
    "plant",        "environment", "initially", "property", "expected",   "violated", "at",       "stable",
    "leads",        "to",          "no",        "deadlock", "timelock",   "all",      "steps",    "exactly",
    "one",          "of",          "uppaal",    "ctl",      "ltl",        "observer", "schedule", "implies",
    "in",           "within",      "holds",     "most",     "least",      "every",    "since",    "before",
    "between",      "until",       "precedes",  "constant", "times",      "fault",    "program",  "any"};

/// True if a name may begin with the character that contains `byte`. All characters beyond ASCII are accepted, because
/// the lexer checks them later.
bool begins_name(char byte) {
    return (byte >= 'a' && byte <= 'z') || (byte >= 'A' && byte <= 'Z') || byte == '_' ||
           static_cast<unsigned char>(byte) >= 0x80;
}
bool is_digit(char byte) { return byte >= '0' && byte <= '9'; }

/// Returns the end of the longest sequence of bytes, starting at `at`, for which `continues` returns true.
template <class Continues>
std::size_t end_of_run(std::string_view text, std::size_t at, Continues continues) {
    while (at < text.size() && continues(text[at])) ++at;
    return at;
}

/// The keywords of Structured Text, separated by spaces.
constexpr std::array<std::string_view, 6> program_words = {
    "ACTION AND AND_THEN ARRAY AT BOOL BY BYTE CASE CONFIGURATION CONSTANT DINT DO DWORD ELSE ELSIF END_ACTION",
    "END_CASE END_CONFIGURATION END_FOR END_FUNCTION END_FUNCTION_BLOCK END_IF END_PROGRAM END_REPEAT",
    "END_RESOURCE END_STEP END_STRUCT END_TRANSITION END_TYPE END_VAR END_WHILE EXIT FALSE FOR FROM FUNCTION",
    "FUNCTION_BLOCK IF INITIAL_STEP INT MOD NON_RETAIN NOT OF ON OR OR_ELSE PERSISTENT POINTER PRIORITY PROGRAM",
    "REAL REPEAT RESOURCE RETAIN RETURN SINT STEP STRING STRUCT TASK THEN TIME TO TRANSITION TRUE TYPE UDINT UINT",
    "UNTIL USINT VAR VAR_EXTERNAL VAR_GLOBAL VAR_INPUT VAR_IN_OUT VAR_OUTPUT VAR_TEMP WHILE WITH WORD XOR"};

/// Returns the comment or string of Structured Text that begins at `at`, or nothing if there is none.
std::optional<Word> structured_text_word(std::string_view text, std::size_t at) {
    const auto to = [&](Word::Kind kind, std::string_view end, std::size_t after) {
        const std::size_t found = text.find(end, at + after);
        const std::size_t stop = found == std::string_view::npos ? text.size() : found + end.size();
        return Word{kind, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(stop)};
    };
    if (text.substr(at).starts_with("(*")) return to(Word::Kind::Comment, "*)", 2);
    if (text[at] == '{') return to(Word::Kind::Comment, "}", 1);
    if (text[at] != '\'') return {};
    std::size_t end = at + 1;  // a string ends at the end of the line at the latest; `$` is the escape character
    while (end < text.size() && text[end] != '\'' && text[end] != '\n') {
        if (text[end] == '$' && end + 1 < text.size() && text[end + 1] != '\n') ++end;
        ++end;
    }
    if (end < text.size() && text[end] == '\'') ++end;
    return Word{Word::Kind::String, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(end)};
}

Word word_at(std::string_view text, std::size_t at, TextLanguage language) {
    if (language == TextLanguage::StructuredText)
        if (const auto word = structured_text_word(text, at)) return *word;
    const auto word = [&](Word::Kind kind, std::size_t end) {
        return Word{kind, static_cast<std::uint32_t>(at), static_cast<std::uint32_t>(std::min(end, text.size()))};
    };
    const auto in_name = [](char byte) { return begins_name(byte) || is_digit(byte); };
    for (const std::string_view arrow : {"↑", "↓"})
        if (text.substr(at).starts_with(arrow)) return word(Word::Kind::Sign, at + arrow.size());
    if (begins_name(text[at])) return word(Word::Kind::Name, end_of_run(text, at, in_name));
    if (is_digit(text[at])) {
        std::size_t end = end_of_run(text, at, in_name);
        if (end + 1 < text.size() && text[end] == '.' && is_digit(text[end + 1]))
            end = end_of_run(text, end + 1, in_name);
        return word(Word::Kind::Number, end);
    }
    const std::string_view two = text.substr(at, 2);
    if (text[at] == '"') {
        const std::size_t end = std::min(text.find_first_of("\"\n", at + 1), text.size());
        return word(Word::Kind::String, end < text.size() && text[end] == '"' ? end + 1 : end);
    }
    if (two == "//") return word(Word::Kind::Comment, text.find('\n', at));
    if (two == "/*") {
        const std::size_t end = text.find("*/", at + 2);
        return word(Word::Kind::Comment, end == std::string_view::npos ? end : end + 2);
    }
    for (const std::string_view sign : {":=", "->", "..", "==", "!=", "<=", ">=", "=>", "&&", "||"})
        if (two == sign) return word(Word::Kind::Sign, at + 2);
    return word(Word::Kind::Sign, at + 1);
}

bool begins_line(std::string_view text, std::size_t at) {
    while (at > 0 && (text[at - 1] == ' ' || text[at - 1] == '\t')) --at;
    return at == 0 || text[at - 1] == '\n' || text[at - 1] == '\r';
}

bool has(const std::vector<std::string>& words, std::string_view word) {
    return std::ranges::find(words, word) != words.end();
}

}  // namespace

std::vector<Word> words_of(std::string_view text, TextLanguage language) {
    std::vector<Word> words;
    for (std::size_t at = 0; at < text.size();) {
        if (static_cast<unsigned char>(text[at]) <= ' ') {
            ++at;
            continue;
        }
        words.push_back(word_at(text, at, language));
        at = words.back().end;
    }
    return words;
}

bool is_reserved(std::string_view word) { return std::ranges::find(reserved, word) != reserved.end(); }

std::span<const std::string_view> structured_text_keywords() {
    static const std::vector<std::string_view> words = [] {
        std::vector<std::string_view> list;
        for (const std::string_view line : program_words)
            for (std::size_t at = 0; at < line.size();) {
                const std::size_t end = std::min(line.find(' ', at), line.size());
                list.push_back(line.substr(at, end - at));
                at = end + 1;
            }
        return list;
    }();
    return words;
}

bool is_keyword(std::string_view word, TextLanguage language) {
    if (language == TextLanguage::StructuredText) {
        std::string capitals(word);
        for (char& letter : capitals) letter = static_cast<char>(std::toupper(static_cast<unsigned char>(letter)));
        const auto keywords = structured_text_keywords();
        return std::ranges::find(keywords, capitals) != keywords.end();
    }
    return is_reserved(word) || word == "rise" || word == "fall" || word == "accept" ||
           std::ranges::find(contextual, word) != contextual.end();
}

bool is_name(std::string_view word, bool numbers) {
    if (word.empty() || word.size() > 200 || is_reserved(word)) return false;
    if (numbers && std::ranges::all_of(word, is_digit)) return true;
    return identifier_length(word) == word.size();
}

/// Returns the incomplete declaration at the cursor. A missing `;` or `}` affects only one declaration, because a
/// keyword that begins both a declaration and a line starts a new declaration.
IncompleteDeclaration half_at(std::string_view text, std::size_t cursor) {
    IncompleteDeclaration half;
    int brackets = 0;
    for (const Word& word : words_of(text.substr(0, cursor))) {
        const std::string_view seen = text.substr(word.begin, word.end - word.begin);
        half.in_text = false;
        if (word.kind == Word::Kind::Comment || word.kind == Word::Kind::String) {
            const bool closed =
                word.kind == Word::Kind::String ? seen.size() > 1 && seen.ends_with('"') : seen.ends_with("*/");
            half.in_text = word.end == cursor && !closed;
            if (word.kind == Word::Kind::String) half.words.emplace_back("\"");
            continue;
        }
        const bool at_cursor = word.end == cursor && word.kind != Word::Kind::Sign;
        if (at_cursor) break;
        if (begins_line(text, word.begin)) {
            if (seen == "grafcet" || seen == "component" || seen == "closed_loop" || seen == "include" ||
                (seen == "program" && half.blocks.empty()))
                half.blocks.clear(), half.words.clear(), brackets = 0;
            const bool in_chart = seen == "input" || seen == "output" || seen == "internal" || seen == "transition" ||
                                  (seen == "step" && !half.words.empty() && !is_keyword(half.words.back()));
            if (in_chart && brackets == 0) {
                half.words.clear();
                if (half.blocks.size() > 1 && has(half.blocks.back(), "step")) half.blocks.pop_back();
            }
        }
        if (seen == "(") ++brackets;
        if (seen == ")" && brackets > 0) --brackets;
        if (seen == "]") {  // removes an index, because it does not affect the proposals
            const auto index = std::ranges::find(half.words.rbegin(), half.words.rend(), "[");
            if (index != half.words.rend()) half.words.erase(std::prev(index.base()), half.words.end());
        } else if (seen == "{" && !half.blocks.empty() && !half.words.empty() && half.words.front() == "for") {
            // A replication permits the same declarations as the block that contains it.
            half.blocks.push_back(half.blocks.back());
            half.words.clear();
            brackets = 0;
        } else if (seen == "{") {
            half.blocks.push_back(std::move(half.words));
            half.words.clear();
            brackets = 0;
        } else if (seen == "}") {
            const bool set =
                !half.blocks.empty() && (has(half.blocks.back(), "force") || has(half.blocks.back(), "of"));
            half.words.clear();
            if (set) half.words = half.blocks.back();
            if (!half.blocks.empty()) half.blocks.pop_back();
            brackets = 0;
        } else if (seen == ";" && (brackets == 0 || !has(half.words, "component"))) {
            half.words.clear();
            brackets = 0;
        } else {
            half.words.emplace_back(seen);
        }
    }
    return half;
}

}  // namespace grafverif::lsp
