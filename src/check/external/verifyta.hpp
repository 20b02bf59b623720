// SPDX-License-Identifier: MIT
// Interface to verifyta, the model checker of UPPAAL, which runs on the exported project. The caller provides programs,
// files and the text of the model as functions.
//
// Each formula is checked by a separate call, so that each result belongs to its query regardless of other output. Only
// the documented lines `-- Formula is satisfied.`, `-- Formula is NOT satisfied.` and `-- Formula MAY [NOT] be
// satisfied.` are read; exit codes and traces are not documented and are ignored. Without such a line, or with two that
// differ, there is no verdict.
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

/// A formula for the program, and its property.
struct ExternalQuery {
    Id<Property> property = {};
    std::string name = {};     ///< of the verdict: the property's, or `S.X7` of an expanded one
    std::string formula = {};  ///< empty: the program's language cannot express it
    std::string reason = {};   ///< the reason why it cannot
};

struct ExternalOptions {
    std::vector<std::string> properties = {};  ///< names; empty: all
    /// Runs the program on the model and this formula.
    std::function<ProgramResult(const std::string& formula)> run = {};
};

/// The result that verifyta printed about one formula.
struct ExternalResult {
    Outcome outcome = Outcome::Unknown;  ///< Holds: satisfied
    UnknownReason obstacle = UnknownReason::None;
    std::string reason = {};
    bool operator==(const ExternalResult&) const = default;
};
ExternalResult read_verifyta(const ProgramResult& result);

/// One verdict per query, in order, without runs. `no timelock`, which no UPPAAL formula expresses, is added as unknown
/// if the model does not declare it. If stored actions may race, proofs of verifyta are accepted only if it also proves
/// `no_race`.
std::vector<Verdict> check_verifyta(const Network& network, std::span<const ExternalQuery> questions,
                                    const ExternalOptions& options);

}  // namespace grafverif
