// SPDX-License-Identifier: MIT
// Lists the reserved words of the target languages, and changes names that a target language reserves.
//
// UPPAAL reserves the keywords of its declarations and queries, its mathematical functions, and its built-in constants
// and types. UPPAAL permits the declaration of a variable with the name of a query keyword, but not its use in queries.
// NuSMV: the list contains the keywords of NuSMV 2.6 and of nuXmv, which reads the same files. Single capital letters
// in the list are operators of temporal logic. Structured Text: the list contains the keywords, elementary types,
// standard functions and function blocks of IEC 61131-3. C: the list contains the keywords of C and C++ up to 2023,
// names of <stdbool.h> and <stdint.h>, and some macros of other headers and of compilers.
#include "syntax/print/legal_names.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <unordered_map>

#include "support/overloaded.hpp"
#include "support/text/identifier.hpp"

namespace grafverif {
namespace {

// Each line of the following lists contains several words.
// clang-format off
constexpr auto uppaal_keywords = std::to_array<std::string_view>({
    "DBL_MAX", "DBL_MIN", "FLT_MAX", "FLT_MIN", "INT16_MAX", "INT16_MIN", "INT32_MAX", "INT32_MIN", "INT8_MAX",
    "INT8_MIN", "IO", "M_1_PI", "M_2_PI", "M_2_SQRTPI", "M_E", "M_LN10", "M_LN2", "M_LOG10E", "M_LOG2E", "M_PI",
    "M_PI_2", "M_PI_4", "M_SQRT1_2", "M_SQRT2", "UINT16_MAX", "UINT8_MAX", "abs", "acos", "acosh", "after_update",
    "and", "asin", "asinh", "assert", "assign", "atan", "atan2", "atanh", "before_update", "bool", "branchpoint",
    "break", "broadcast", "case", "cbrt", "ceil", "chan", "clock", "commit", "const", "continue", "copysign", "cos",
    "cosh", "deadlock", "default", "do", "double", "dynamic", "else", "enum", "erf", "erfc", "exists", "exit",
    "exp", "exp2", "expm1", "fabs", "false", "fdim", "fint", "floor", "fma", "fmax", "fmin", "fmod", "for",
    "forall", "fpclassify", "gantt", "guard", "hybrid", "hypot", "if", "ilogb", "imply", "import", "init", "int",
    "int16_t", "int32_t", "int8_t", "isfinite", "isinf", "isnan", "isnormal", "isunordered", "ldexp", "lgamma",
    "ln", "location", "log", "log10", "log1p", "log2", "logb", "meta", "nextafter", "not", "or", "pow", "priority",
    "probability", "process", "progress", "query", "random", "random_arcsine", "random_beta", "random_gamma",
    "random_normal", "random_poisson", "random_tri", "random_weibull", "rate", "return", "round", "scalar",
    "select", "signbit", "sin", "sinh", "spawn", "sqrt", "state", "string", "struct", "sum", "switch", "sync",
    "system", "tan", "tanh", "tgamma", "trans", "true", "trunc", "typedef", "uint16_t", "uint8_t", "urgent", "void",
    "while", "xor",
});

constexpr auto uppaal_query_words = std::to_array<std::string_view>({
    "Pmax", "Pr", "X", "bounds", "control", "control_t", "foreach", "imitate", "inf", "loadStrategy", "maxE",
    "maxPr", "minE", "minPr", "numOf", "sat", "saveStrategy", "simulate", "simulation", "strategy", "sup", "under",
});

constexpr auto nusmv_keywords = std::to_array<std::string_view>({
    "A", "ABF", "ABG", "AF", "AG", "ASSIGN", "AX", "BU", "COMPASSION", "COMPID", "COMPUTE", "COMPWFF", "CONSTANTS",
    "CONSTARRAY", "CONSTRAINT", "CTLSPEC", "CTLWFF", "DEFINE", "E", "EBF", "EBG", "EF", "EG", "EX", "F", "FAIRNESS",
    "FALSE", "FROZENVAR", "FUN", "G", "H", "IN", "INIT", "INVAR", "INVARSPEC", "ISA", "ITYPE", "IVAR", "JUSTICE",
    "LTLSPEC", "LTLWFF", "MAX", "MDEFINE", "MIN", "MIRROR", "MODULE", "NAME", "O", "PARSYNTH", "PRED", "PREDICATES",
    "PSLSPEC", "PSLWFF", "READ", "S", "SIMPWFF", "SPEC", "T", "TRANS", "TRUE", "U", "URGENT", "V", "VAR", "WRITE", "X",
    "Y", "Z",
    "abs", "array", "asin", "atan", "acos", "bool", "boolean", "case", "clock", "cos", "count", "esac", "exp", "extend",
    "floor", "in", "init", "integer", "ln", "max", "min", "mod", "next", "noncontinuous", "of", "pi", "pow", "process",
    "real", "resize", "self", "signed", "sin", "sizeof", "swconst", "tan", "time", "toint", "typeof", "union",
    "unsigned", "uwconst", "word", "word1", "xnor", "xor",
});

constexpr auto structured_text_keywords = std::to_array<std::string_view>({
    "ABS", "ABSTRACT", "ACOS", "ACTION", "ADD", "AND", "ANY", "ARRAY", "ASIN", "AT", "ATAN", "ATAN2", "BOOL", "BY",
    "BYTE", "CAL", "CASE", "CHAR", "CLASS", "CONCAT", "CONFIGURATION", "CONSTANT", "CONTINUE", "COS", "CTD", "CTU",
    "CTUD", "DATE", "DATE_AND_TIME", "DELETE", "DINT", "DIV", "DO", "DT", "DWORD", "ELSE", "ELSIF", "END_ACTION",
    "END_CASE", "END_CLASS", "END_CONFIGURATION", "END_FOR", "END_FUNCTION", "END_FUNCTION_BLOCK", "END_IF",
    "END_INTERFACE", "END_METHOD", "END_NAMESPACE", "END_PROGRAM", "END_REPEAT", "END_RESOURCE", "END_STEP",
    "END_STRUCT", "END_TRANSITION", "END_TYPE", "END_VAR", "END_WHILE", "ENO", "EN", "EQ", "EXIT", "EXP", "EXPT",
    "EXTENDS", "FALSE", "FINAL", "FIND", "FOR", "FROM", "FUNCTION", "FUNCTION_BLOCK", "F_EDGE", "F_TRIG", "GE", "GT",
    "IF", "IMPLEMENTS", "INITIAL_STEP", "INSERT", "INT", "INTERFACE", "INTERNAL", "INTERVAL", "JMP", "LD", "LDATE", "LDT",
    "LE", "LEFT", "LEN", "LIMIT", "LINT", "LN", "LOG", "LREAL", "LT", "LTIME", "LTOD", "LWORD", "MAX", "METHOD", "MID",
    "MIN", "MOD", "MOVE", "MUL", "MUX", "NAMESPACE", "NE", "NON_RETAIN", "NOT", "NULL", "OF", "ON", "OR", "OVERLAP",
    "OVERRIDE", "PRIORITY", "PRIVATE", "PROGRAM", "PROTECTED", "PUBLIC", "READ_ONLY", "READ_WRITE", "REAL", "REF",
    "REF_TO", "REPEAT", "REPLACE", "RESOURCE", "RET", "RETAIN", "RETURN", "RIGHT", "ROL", "ROR", "RS", "RTC", "R_EDGE",
    "R_TRIG", "SEL", "SEMA", "SHL", "SHR", "SIN", "SINGLE", "SINT", "SQRT", "SR", "ST", "STEP", "STRING", "STRUCT", "SUB",
    "SUPER", "TAN", "TASK", "THEN", "THIS", "TIME", "TIME_OF_DAY", "TO", "TOD", "TOF", "TON", "TP", "TRANSITION", "TRUE",
    "TRUNC", "TYPE", "UDINT", "UINT", "ULINT", "UNTIL", "USING", "USINT", "VAR", "VAR_ACCESS", "VAR_CONFIG",
    "VAR_EXTERNAL", "VAR_GLOBAL", "VAR_INPUT", "VAR_IN_OUT", "VAR_OUTPUT", "VAR_TEMP", "WCHAR", "WHILE", "WITH", "WORD",
    "WSTRING", "XOR",
});

constexpr auto c_keywords = std::to_array<std::string_view>({
    "EOF", "I", "NULL", "PTRDIFF_MAX", "PTRDIFF_MIN", "SIG_ATOMIC_MAX", "SIG_ATOMIC_MIN", "SIZE_MAX", "WCHAR_MAX",
    "WCHAR_MIN", "WINT_MAX", "WINT_MIN", "alignas", "alignof", "and", "and_eq", "asm", "assert", "auto", "bitand",
    "bitor", "bool", "break", "case", "catch", "char", "char16_t", "char32_t", "char8_t", "class", "co_await",
    "co_return", "co_yield", "compl", "complex", "concept", "const", "const_cast", "consteval", "constexpr",
    "constinit", "continue", "decltype", "default", "delete", "do", "double", "dynamic_cast", "else", "enum", "errno",
    "explicit", "export", "extern", "false", "far", "float", "for", "fortran", "friend", "goto", "huge", "i386", "if",
    "imaginary", "inline", "int", "interrupt", "linux", "long", "mutable", "namespace", "near", "new", "noexcept",
    "noreturn", "not", "not_eq", "nullptr", "offsetof", "operator", "or", "or_eq", "private", "protected", "public",
    "register", "reinterpret_cast", "requires", "restrict", "return", "short", "signed", "sizeof", "static",
    "static_assert", "static_cast", "stderr", "stdin", "stdout", "struct", "switch", "template", "this", "thread_local",
    "throw", "true", "try", "typedef", "typeid", "typename", "typeof", "typeof_unqual", "union", "unix", "unsigned",
    "using", "virtual", "void", "volatile", "wchar_t", "while", "xor", "xor_eq",
});

/// A set of words. For most names that are not in the set, the lookup only compares the first letter and the length.
class Words {
public:
    explicit Words(std::span<const std::string_view> list) : set_(list.begin(), list.end()) {
        for (const std::string_view word : list) lengths_[static_cast<unsigned char>(word.front())] |= length_bit(word);
    }

    bool contains(std::string_view name) const {
        if (name.empty() || (lengths_[static_cast<unsigned char>(name.front())] & length_bit(name)) == 0) return false;
        return set_.contains(name);
    }

private:
    static std::uint32_t length_bit(std::string_view word) { return 1U << std::min<std::size_t>(word.size(), 31); }

    std::unordered_set<std::string_view> set_;
    std::array<std::uint32_t, 256> lengths_ = {};
};
// clang-format on

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// Returns a key for `name`. Two names have the same key if and only if the target language does not distinguish them.
std::string key_of(Target target, std::string_view name) {
    std::string key(name);
    if (target == Target::StructuredText)
        for (char& c : key) c = c >= 'a' && c <= 'z' ? static_cast<char>(c - 'a' + 'A') : c;
    return key;
}

/// True if each `_` in `name` is followed by a letter or digit, as IEC 61131-3 requires.
bool has_single_underscores(std::string_view name) {
    return !name.ends_with('_') && name.find("__") == std::string_view::npos;
}

/// True if a name in the target language must not contain `__` or end with `_`. C++ reserves names with `__`, and
/// IEC 61131-3 forbids `__` and a trailing `_`.
bool has_plain_underscores(Target target) { return target == Target::StructuredText || target == Target::C; }

/// True if <stdint.h> defines the name, or if a future version of <stdint.h> may define the name (C99, 7.26.8).
bool is_of_stdint(std::string_view name) {
    const bool type = (name.starts_with("int") || name.starts_with("uint")) && name.ends_with("_t");
    const bool macro = (name.starts_with("INT") || name.starts_with("UINT")) &&
                       (name.ends_with("_MAX") || name.ends_with("_MIN") || name.ends_with("_C"));
    return type || macro;
}

/// True if the name begins with `_` and a capital letter; C reserves such names.
bool has_reserved_beginning(std::string_view name) {
    return name.size() > 1 && name[0] == '_' && name[1] >= 'A' && name[1] <= 'Z';
}

/// Returns `name` with all characters replaced that are not allowed in identifiers of the target language.
std::string spelled(Target target, std::string_view name) {
    const std::string ascii = in_ascii(name);
    std::string text;
    if (ascii.empty() || is_digit(ascii.front())) text += '_';
    for (const char c : ascii)
        if (c != ']') text += is_letter(c) || is_digit(c) ? c : '_';  // `FULL[1]` becomes `FULL_1`
    if (!has_plain_underscores(target)) return text;
    if (target == Target::C && has_reserved_beginning(text)) text.insert(0, "v");
    std::string single;
    for (const char c : text)
        if (c != '_' || !single.ends_with('_')) single += c;
    return single.ends_with('_') ? single + "0" : single;
}

/// Returns the first of the names `base`, `base_`, `base_2`, `base_3`, ... that `free` accepts. `next` stores, for each
/// base, the next suffix to try, so that the total cost is linear in the number of names.
template <class Free>
std::string first_free(const std::string& base, std::unordered_map<std::string, std::size_t>& next, const Free& free) {
    for (std::size_t& tried = next[base];; ++tried) {
        std::string name = base;
        if (tried == 1) name += '_';  // for Structured Text and C, `free` rejects the suffix `_`
        if (tried >= 2) name += '_' + std::to_string(tried);
        if (free(name)) return name;
    }
}

}  // namespace

bool is_reserved(Target target, std::string_view name) {
    static const Words uppaal(uppaal_keywords), queries(uppaal_query_words), nusmv(nusmv_keywords),
        structured_text(structured_text_keywords), c(c_keywords);
    switch (target) {
    case Target::Uppaal: return uppaal.contains(name) || queries.contains(name);
    case Target::UppaalLocal: return uppaal.contains(name);
    case Target::Nusmv: return nusmv.contains(name);
    case Target::StructuredText: return structured_text.contains(key_of(target, name));
    case Target::C: return c.contains(name) || is_of_stdint(name);
    }
    unreachable();
}

bool is_legal(Target target, std::string_view name) {
    if (name.empty() || !is_letter(name.front())) return false;
    if (has_plain_underscores(target) && !has_single_underscores(name)) return false;
    if (target == Target::C && has_reserved_beginning(name)) return false;
    return std::ranges::all_of(name, [](char c) { return is_letter(c) || is_digit(c); }) && !is_reserved(target, name);
}

std::vector<std::string> legal_names(Target target, std::span<const std::string> names,
                                     const std::unordered_set<std::string>& taken) {
    std::vector<std::string> legal(names.size());
    std::unordered_set<std::string> used;
    used.reserve(names.size() + taken.size());
    for (const std::string& name : taken) used.insert(key_of(target, name));
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!is_legal(target, names[i]) || !used.insert(key_of(target, names[i])).second) continue;
        legal[i] = names[i];
    }
    std::unordered_map<std::string, std::size_t> next;
    const auto free = [&](const std::string& name) {
        return (!has_plain_underscores(target) || has_single_underscores(name)) && !is_reserved(target, name) &&
               !used.contains(key_of(target, name));
    };
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!legal[i].empty()) continue;
        legal[i] = first_free(spelled(target, names[i]), next, free);
        used.insert(key_of(target, legal[i]));
    }
    return legal;
}

std::vector<Renaming> renamings(std::span<const std::string> names, std::span<const std::string> legal) {
    assert(names.size() == legal.size());
    std::vector<Renaming> changed;
    for (std::size_t i = 0; i < names.size(); ++i)
        if (names[i] != legal[i]) changed.push_back({names[i], legal[i]});
    return changed;
}

}  // namespace grafverif
