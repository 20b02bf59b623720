// SPDX-License-Identifier: MIT
// Interface to verifyta, the model checker of UPPAAL, which runs on the exported project. The caller provides functions
// that run the program on the model.
//
// Each formula is checked by a separate call, so that each result belongs to its query regardless of other output. Only
// the documented lines `-- Formula is satisfied.`, `-- Formula is NOT satisfied.` and `-- Formula MAY [NOT] be
// satisfied.` are read; exit codes and traces are not documented and are ignored. Without such a line, or with two
// different ones, there is no verdict.
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

/// A formula for the program and the property that it represents.
struct ExternalQuery {
    Id<Property> property = {};
    std::string name = {};     ///< name of the verdict: that of the property, or `S.X7` for one that expands
    std::string formula = {};  ///< formula; empty if the language of the program cannot express the property
    std::string reason = {};   ///< reason for an empty formula
};

struct ExternalOptions {
    std::vector<std::string> properties = {};  ///< names of the properties to check; all if empty
    /// Runs the program on the model and the given formula.
    std::function<ProgramResult(const std::string& formula)> run = {};
};

/// The result that verifyta printed for one formula.
struct ExternalResult {
    Outcome outcome = Outcome::Unknown;  ///< Holds: the formula is satisfied
    UnknownReason obstacle = UnknownReason::None;
    std::string reason = {};
    bool operator==(const ExternalResult&) const = default;
};
ExternalResult read_verifyta(const ProgramResult& result);

/// Returns one verdict per query, in order, without runs. No UPPAAL formula expresses `no timelock`; it is added as
/// unknown if the model does not declare it. If stored actions may race, proofs by verifyta are accepted only if it
/// also proves `no_race`.
std::vector<Verdict> check_verifyta(const Network& network, std::span<const ExternalQuery> questions,
                                    const ExternalOptions& options);

}  // namespace grafverif
