// SPDX-License-Identifier: MIT
// Mutation testing: mutants of a chart, each with one plausible mistake, and the result of each mutant.
#pragma once

#include <cstddef>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/support/source.hpp"

namespace grafverif {

struct Mutant {
    std::string kind = {};     ///< mutation operator, such as `wrong-successor`; all operators: compare/mutants.hpp
    std::string subject = {};  ///< mutated element, such as `transition t3` or `step 2`
    std::string before = {}, after = {};  ///< text of the declaration, on one line
    Span where = {};                      ///< position in the original file
    std::string text = {};                ///< complete text of the mutated file
};

struct MutantResult {
    enum class Kind {
        Refused,     ///< the mutated file is rejected
        Equivalent,  ///< equivalence proved by `compare`
        Noticed,     ///< killed: a property of the original fails
        Unnoticed,   ///< survived: the mutant is not equivalent, but no property that holds for the original fails
        Unknown,     ///< inconclusive; `reason` states the cause
    };
    Kind kind = Kind::Unknown;
    std::string reason = {};                   ///< error code for Refused, reason for Unknown
    std::vector<std::string> noticed_by = {};  ///< properties that kill the mutant
    std::vector<std::string> undecided = {};   ///< properties with unknown verdict for the mutant
    std::vector<std::string> vacuous = {};     ///< properties that hold vacuously for the mutant, but not for the
                                               ///< original
    std::optional<bool> caught = {};           ///< true if the test sequence kills the mutant; empty if no test was run
    /// Length of a sequence of scans that distinguishes the mutant from the original; 0 if none was found.
    std::size_t scans = 0;
    std::vector<std::string> failures = {};  ///< internal errors
};

struct Mutation {
    std::string chart = {};
    std::string file = {};             ///< file that declares the chart, if it is an included file
    std::size_t possible = 0;          ///< number of all possible mutants
    std::vector<Mutant> mutants = {};  ///< the selected mutants
    /// Result per mutant; empty if the run was stopped before its check.
    std::vector<std::optional<MutantResult>> results = {};
    std::vector<std::string> properties = {};    ///< properties with the expected verdict for the original
    std::vector<std::string> vacuous = {};       ///< properties that hold vacuously for the original
    std::vector<std::string> undecided = {};     ///< properties that are unknown for the original, and not considered
    std::optional<std::size_t> test_steps = {};  ///< length of the test sequence
    std::string no_test = {};                    ///< error code if no test sequence was generated
};

/// Returns `refused`, `equivalent`, `noticed`, `unnoticed` or `unknown`.
constexpr std::string_view word(MutantResult::Kind kind) {
    switch (kind) {
    case MutantResult::Kind::Refused: return "refused";
    case MutantResult::Kind::Equivalent: return "equivalent";
    case MutantResult::Kind::Noticed: return "noticed";
    case MutantResult::Kind::Unnoticed: return "unnoticed";
    case MutantResult::Kind::Unknown: return "unknown";
    }
    return {};
}

}  // namespace grafverif
