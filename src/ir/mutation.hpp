// SPDX-License-Identifier: MIT
// Mutation: plausible mistakes in a chart, one at a time, and what becomes of each.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/support/source.hpp"

namespace grafverif {

struct Mutant {
    std::string kind = {};                ///< `wrong-successor`; all of them: compare/mutants.hpp
    std::string subject = {};             ///< `transition t3`, `step 2`
    std::string before = {}, after = {};  ///< the declaration in one line
    Span where = {};                      ///< in the original
    std::string text = {};                ///< of the whole file
};

struct MutantFate {
    enum class Kind {
        Refused,     ///< its text, or what it means, is none that is taken
        Equivalent,  ///< proved by compare
        Noticed,     ///< a property fails that does not of the original
        Unnoticed,   ///< told apart from the original, and every property is as of that
        Unknown,     ///< not decided
    };
    Kind kind = Kind::Unknown;
    std::string reason = {};                   ///< Refused: the code of the error; Unknown: why
    std::vector<std::string> noticed_by = {};  ///< properties
    std::vector<std::string> undecided = {};   ///< properties that were not decided of it
    std::vector<std::string> vacuous = {};     ///< properties that hold vacuously of it, and not of the original
    std::optional<bool> caught = {};           ///< by the test sequence; empty: there is none, or nobody looked
    std::size_t scans = 0;                     ///< that tell it from the original; 0: none were found
    std::vector<std::string> failures = {};    ///< ours
};

struct Mutation {
    std::string chart = {};
    std::size_t possible = 0;                           ///< mutants there are
    std::vector<Mutant> mutants = {};                   ///< those that were asked for
    std::vector<std::optional<MutantFate>> fates = {};  ///< per mutant; empty: the run was stopped before
    std::vector<std::string> properties = {};           ///< as expected of the original
    std::vector<std::string> vacuous = {};              ///< those of them that hold vacuously
    std::optional<std::size_t> test_steps = {};         ///< of the test sequence
    std::string no_test = {};                           ///< the code of the error, where there is none
};

/// `refused`, `equivalent`, `noticed`, `unnoticed`, `unknown`.
constexpr std::string_view word(MutantFate::Kind kind) {
    switch (kind) {
    case MutantFate::Kind::Refused: return "refused";
    case MutantFate::Kind::Equivalent: return "equivalent";
    case MutantFate::Kind::Noticed: return "noticed";
    case MutantFate::Kind::Unnoticed: return "unnoticed";
    case MutantFate::Kind::Unknown: return "unknown";
    }
    return {};
}

}  // namespace grafverif
