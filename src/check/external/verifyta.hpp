// SPDX-License-Identifier: MIT
// Interface to verifyta, the model checker of UPPAAL. verifyta checks the UPPAAL project that grafverif exports. The
// caller provides functions that run the program on the model.
//
// Each formula is checked by a separate call, so that a result cannot be assigned to the wrong query. Only the
// documented lines `-- Formula is satisfied.`, `-- Formula is NOT satisfied.` and `-- Formula MAY [NOT] be satisfied.`
// are read; exit codes and traces are not documented and are ignored. If the output does not contain exactly one of
// these lines, the verdict is unknown.
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <string>
#include <vector>

#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"
#include "support/program.hpp"

namespace grafverif {

/// A formula for verifyta, and the property that the formula represents.
struct ExternalQuery {
    Id<Property> property = {};
    /// Name of the verdict: the name of the property; for a property `S` of the form `reachable all steps`, `S.X7` for
    /// step 7.
    std::string name = {};
    std::string formula = {};  ///< empty if the language of verifyta cannot express the property
    std::string reason = {};   ///< reason for an empty formula
};

struct ExternalOptions {
    std::vector<std::string> properties = {};  ///< names of the properties to check; an empty list selects all

    /// Runs the program on the model and the given formula.
    std::function<ProgramResult(const std::string& formula)> run = {};
};

/// The result that verifyta printed for one formula.
struct ExternalResult {
    Outcome outcome = Outcome::Unknown;  ///< Holds means that the formula is satisfied
    UnknownReason obstacle = UnknownReason::None;
    std::string reason = {};
    bool operator==(const ExternalResult&) const = default;
};
ExternalResult read_verifyta(const ProgramResult& result);

/// Returns one verdict per selected query, in order, without runs. No UPPAAL formula expresses `no timelock`; if the
/// model does not declare the property `no timelock`, a verdict Unknown for `no timelock` is added. If stored actions
/// of the model may race, verdicts of verifyta are accepted only if verifyta also proves the property `no_race`.
std::vector<Verdict> check_verifyta(const Network& network, std::span<const ExternalQuery> questions,
                                    const ExternalOptions& options);

}  // namespace grafverif
