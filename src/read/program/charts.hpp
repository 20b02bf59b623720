// SPDX-License-Identifier: MIT
// read_charts: determines the structure of the Sequential Function Charts of a file, and generates the ACTION_CONTROL
// blocks of their actions.
#pragma once

#include <cstdint>
#include <map>
#include <string>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif::program {

/// All action blocks of one action or Boolean variable in a chart.
struct ChartAction {
    st::Name name = {};      ///< invalid if the action block contains the statements
    Id<st::Expr> path = {};  ///< in CODESYS: path of the action or variable
    std::string label = {};
    bool variable = false;                                        ///< true if `name` is a Boolean variable
    st::Block body = {};                                          ///< the statements of an action
    std::map<std::string, std::vector<Id<st::Word>>> steps = {};  ///< for each qualifier: steps with an action block
    Id<st::Expr> time = {};                                       ///< duration; invalid if the action has none, or if
                                                                  ///< `control` contains the durations
    /// If the action has several constant durations: for each duration, the steps that select it through the inputs
    /// `TIME_1`, `TIME_2`, ... of `control`.
    std::vector<std::vector<Id<st::Word>>> durations = {};
    std::size_t control = 0;  ///< index in the units of the file: ACTION_CONTROL block of the action
    bool controlled = true;   ///< true if `control` is valid; false if the action has only the qualifiers N, R and S
    std::uint32_t cell = 0;   ///< first memory cell of the instance of `control`; set by the Reader
    /// In CODESYS: the memory cells of Q, of the previous value of Q, of the value that S stores, and of the condition
    /// of R.
    std::uint32_t value = 0, before = 0, stored = 0, resets = 0;
    Span where = {};
};

struct Chart {
    bool valid = false;                       ///< true if no error was reported
    std::vector<std::size_t> order = {};      ///< indices of transitions by priority, then position
    std::vector<ChartAction> actions = {};    ///< in the order of their first action blocks
    std::uint32_t started = 0;                ///< cell that is true after the first execution of the body
    std::vector<std::uint32_t> cleared = {};  ///< for each transition: cell that is true if it is cleared
    /// For each transition and each action: true if the structure of the chart does not exclude a fault (an activation
    /// of an active step, or two simultaneous durations). The statements then check for the fault in each scan.
    std::vector<bool> checked = {}, checked_actions = {};
    std::vector<std::uint32_t> steps = {};      ///< in CODESYS: for each step, its first cell
    std::vector<std::uint32_t> before = {};     ///< in CODESYS: for each step, cell for its previous activity
    std::vector<std::uint32_t> variables = {};  ///< in CODESYS: for each step, index in the variables of the unit
};

struct UnitCharts {
    Chart body = {};
    std::vector<Chart> actions = {};  ///< for each action of the unit
};

/// Returns the charts of each unit of the file; an entry is not `valid` if the unit has no chart. Adds the generated
/// ACTION_CONTROL blocks to the units of the file.
std::vector<UnitCharts> read_charts(st::File& file, Sources& sources, Diagnostics& diagnostics);

/// Returns the text of a path of names in capital letters, such as `A.B.C`; empty for other expressions.
std::string path_text(const st::File& file, Id<st::Expr> path);

}  // namespace grafverif::program
