// SPDX-License-Identifier: MIT
// Mutation testing: mutants of a chart, and the result for each mutant. A mutant is a copy of the chart with one
// plausible mistake.
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

    /// Text of the mutated declaration before and after the mutation, on one line.
    std::string before = {}, after = {};
    Span where = {};        ///< position of the mutation in the original file
    std::string text = {};  ///< complete text of the mutated file
};

struct MutantResult {
    enum class Kind {
        Refused,     ///< the mutated file is rejected
        Equivalent,  ///< `compare` proved that the mutant is equivalent to the original

        /// Killed: a property with the expected verdict for the original has an unexpected verdict for the mutant, or
        /// the mutant has a new model error.
        Noticed,
        Unnoticed,  ///< survived: the mutant is not equivalent, but all properties have the expected verdicts
        Unknown,    ///< the check was inconclusive; `reason` states the cause
    };
    Kind kind = Kind::Unknown;
    std::string reason = {};  ///< for Refused: the error code; for Unknown: the reason; otherwise empty

    /// Properties that kill the mutant, and the code of a model error that kills it.
    std::vector<std::string> noticed_by = {};
    std::vector<std::string> undecided = {};  ///< properties with unknown verdict for the mutant
    std::vector<std::string> vacuous = {};    ///< properties that hold vacuously for the mutant, but not for the
                                              ///< original
    std::optional<bool> caught = {};          ///< true if the test sequence kills the mutant; empty if no test was run

    /// Length of a sequence of scans that distinguishes the mutant from the original; 0 if none was found.
    std::size_t scans = 0;
    std::vector<std::string> failures = {};  ///< internal errors of the check of this mutant
};

struct Mutation {
    std::string chart = {};
    /// The included file that declares the chart; empty if the chart is declared in the main file.
    std::string file = {};
    std::size_t possible = 0;          ///< number of all possible mutants
    std::vector<Mutant> mutants = {};  ///< the selected mutants

    /// Result of each mutant; empty if the run was stopped before the mutant was checked.
    std::vector<std::optional<MutantResult>> results = {};
    /// Properties with the expected verdict for the original; these properties are checked for the mutants.
    std::vector<std::string> properties = {};
    std::vector<std::string> vacuous = {};  ///< properties that hold vacuously for the original

    /// Properties whose verdict for the original is unknown; these properties are not checked for the mutants.
    std::vector<std::string> undecided = {};
    std::optional<std::size_t> test_steps = {};  ///< length of the test sequence, if one was generated
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
