// SPDX-License-Identifier: MIT
// verifyta, the model checker of UPPAAL, run on the project that we write for it, its answers read into verdicts. Programs,
// files and the text of the model belong to the caller, who hands in functions.
//
// verifyta, the model checker of UPPAAL, is asked one formula at a time, so that each answer belongs to its question
// whatever the program prints around it. What is read are the documented lines `-- Formula is satisfied.`,
// `-- Formula is NOT satisfied.` and `-- Formula MAY [NOT] be satisfied.`; its exit codes and its traces are not
// documented and are not read. No such line, or two that differ, is no verdict.
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

/// A formula for the program, and whose it is.
struct ExternalQuestion {
    Id<Property> property = {};
    std::string name = {};     ///< of the verdict: the property's, or `S.X7` of one that expands
    std::string formula = {};  ///< empty: the language of the program cannot say it
    std::string reason = {};   ///< why it cannot
};

struct ExternalOptions {
    std::vector<std::string> properties = {};  ///< names; empty: all
    /// Runs the program on the model and this formula.
    std::function<ProgramResult(const std::string& formula)> run = {};
};

/// The answer in what verifyta printed about one formula.
struct ExternalAnswer {
    Outcome outcome = Outcome::Unknown;  ///< Holds: satisfied
    Obstacle obstacle = Obstacle::None;
    std::string reason = {};
    bool operator==(const ExternalAnswer&) const = default;
};
ExternalAnswer read_verifyta(const ProgramResult& result);

/// A verdict per question, in order, without runs; `no timelock`, which no formula of UPPAAL says, as an unknown one at
/// the end where the model does not declare it. Where stored actions may race, nothing that verifyta proves is taken
/// for proven unless it proves `no_race` too.
std::vector<Verdict> check_verifyta(const Network& network, std::span<const ExternalQuestion> questions,
                                    const ExternalOptions& options);

}  // namespace grafverif
