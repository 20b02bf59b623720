// SPDX-License-Identifier: MIT
// The reserved words of the targets, and names that avoid them.
//
// UPPAAL: the keywords of its declarations and of its queries (a variable called as a query keyword can be declared but
// not asked about), its mathematical functions, its built-in constants and types. NuSMV: the keywords of NuSMV 2.6 and
// of nuXmv, which reads the same files; single capital letters are operators of its temporal logics.
#include "grafverif/syntax/legal_names.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <cstdint>
#include <unordered_map>

#include "grafverif/support/overloaded.hpp"

namespace grafverif {
namespace {

constexpr auto uppaal_words = std::to_array<std::string_view>({
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

constexpr auto nusmv_words = std::to_array<std::string_view>({
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


/// A set of words that tells most other names by their first letter and length.
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

bool is_letter(char c) { return (c >= 'a' && c <= 'z') || (c >= 'A' && c <= 'Z') || c == '_'; }
bool is_digit(char c) { return c >= '0' && c <= '9'; }

/// `name` with nothing left in it that no identifier may hold.
std::string spelled(std::string_view name) {
    std::string text;
    if (name.empty() || is_digit(name.front())) text += '_';
    for (const char c : name) text += is_letter(c) || is_digit(c) ? c : '_';
    return text;
}

/// The first of `base`, `base_`, `base_2`, `base_3`, ... that `free` accepts; `next` remembers where the search for
/// each base stopped, so that many entities of one name cost no more than their number.
template <class Free>
std::string first_free(const std::string& base, std::unordered_map<std::string, std::size_t>& next, const Free& free) {
    for (std::size_t& tried = next[base];; ++tried) {
        std::string name = base;
        if (tried == 1) name += '_';
        if (tried >= 2) name += '_' + std::to_string(tried);
        if (free(name)) return name;
    }
}

}  // namespace

bool is_reserved(Target target, std::string_view name) {
    static const Words uppaal(uppaal_words), queries(uppaal_query_words), nusmv(nusmv_words);
    switch (target) {
    case Target::Uppaal:      return uppaal.contains(name) || queries.contains(name);
    case Target::UppaalLocal: return uppaal.contains(name);
    case Target::Nusmv:       return nusmv.contains(name);
    }
    unreachable();
}

bool is_legal(Target target, std::string_view name) {
    if (name.empty() || !is_letter(name.front())) return false;
    return std::ranges::all_of(name, [](char c) { return is_letter(c) || is_digit(c); }) && !is_reserved(target, name);
}

std::vector<std::string> legal_names(Target target, std::span<const std::string> names,
                                     const std::unordered_set<std::string>& taken) {
    std::vector<std::string> legal(names.size());
    std::unordered_set<std::string_view> used;
    used.reserve(names.size());
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!is_legal(target, names[i]) || taken.contains(names[i]) || !used.insert(names[i]).second) continue;
        legal[i] = names[i];
    }
    std::unordered_map<std::string, std::size_t> next;
    const auto free = [&](const std::string& name) {
        return !is_reserved(target, name) && !taken.contains(name) && !used.contains(name);
    };
    for (std::size_t i = 0; i < names.size(); ++i) {
        if (!legal[i].empty()) continue;
        legal[i] = first_free(spelled(names[i]), next, free);
        used.insert(legal[i]);
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
