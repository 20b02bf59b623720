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

/// The action blocks of one action or Boolean variable.
struct ChartAction {
    st::Name name = {};      ///< invalid if the step contains the statements
    Id<st::Expr> path = {};  ///< in CODESYS: the action or variable
    std::string label = {};
    bool variable = false;                                        ///< true if `name` is a Boolean variable
    st::Block body = {};                                          ///< the statements of an action
    std::map<std::string, std::vector<Id<st::Word>>> steps = {};  ///< steps with an action block, per qualifier
    Id<st::Expr> time = {};                                       ///< duration; invalid if there is none, or if
                                                                  ///< `control` contains the durations
    /// If there are several constant durations: the steps that define each duration, for the inputs `TIME_1`, `TIME_2`,
    /// ... of `control`.
    std::vector<std::vector<Id<st::Word>>> durations = {};
    std::size_t control = 0;  ///< index of the ACTION_CONTROL of the action in the units of the file
    bool controlled = true;   ///< true if `control` is valid; false if the action has only the qualifiers N, R and S
    std::uint32_t cell = 0;   ///< first cell of the instance of `control`; set by the Reader
    /// In CODESYS: the cells of Q, of the last value of Q, of the memory of S, and of the condition of R.
    std::uint32_t value = 0, before = 0, stored = 0, resets = 0;
    Span where = {};
};

struct Chart {
    bool valid = false;                       ///< true if no error was reported
    std::vector<std::size_t> order = {};      ///< the transitions by priority, then position
    std::vector<ChartAction> actions = {};    ///< in the order of their first action blocks
    std::uint32_t started = 0;                ///< cell that is true if the body was executed in an earlier scan
    std::vector<std::uint32_t> cleared = {};  ///< cell per transition: true if the transition is cleared
    /// Per transition and per action: true if the structure of the chart does not exclude a fault of this element. Each
    /// execution then tests for the fault.
    std::vector<bool> checked = {}, checked_actions = {};
    std::vector<std::uint32_t> steps = {};      ///< in CODESYS: cell per step
    std::vector<std::uint32_t> before = {};     ///< in CODESYS: cell per step, true if active in the last execution
    std::vector<std::uint32_t> variables = {};  ///< in CODESYS: index in the variables of the unit, per step
};

struct UnitCharts {
    Chart body = {};
    std::vector<Chart> actions = {};  ///< per action
};

/// Returns the charts of each unit of the file; an entry is not valid if the unit has no chart. The units of action
/// controls are added to the file.
std::vector<UnitCharts> read_charts(st::File& file, Sources& sources, Diagnostics& diagnostics);

/// Returns a path of names in capitals, such as `A.B.C`; empty for other expressions.
std::string path_text(const st::File& file, Id<st::Expr> path);

}  // namespace grafverif::program
