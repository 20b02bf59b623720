// SPDX-License-Identifier: MIT
// read_charts: determines the structure of the Sequential Function Charts of a file, and an ACTION_CONTROL for each of
// their actions.
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
    st::Name name = {};  ///< invalid if the statements are in the action block of the step
    std::string label = {};
    bool variable = false;                                        ///< true if `name` is a Boolean variable
    st::Block body = {};                                          ///< statements, if it is not a variable
    std::map<std::string, std::vector<Id<st::Word>>> steps = {};  ///< steps, per qualifier
    Id<st::Expr> time = {};   ///< duration; invalid if there is none, or if it is a constant in `control`
    std::size_t control = 0;  ///< index of its ACTION_CONTROL in the units of the file
    std::uint32_t cell = 0;   ///< cell of the instance; set by the Reader
    Span where = {};
};

struct Chart {
    bool valid = false;                       ///< true if no error was reported
    std::vector<std::size_t> order = {};      ///< transitions, ordered by priority and then by position
    std::vector<ChartAction> actions = {};    ///< actions in the order of their first action blocks
    std::uint32_t started = 0;                ///< cell that is true if the body has been executed before
    std::vector<std::uint32_t> cleared = {};  ///< cell of each transition
};

/// Returns a chart for each unit of the file, which is not valid for units that are not charts. The units of action
/// controls are added to the file.
std::vector<Chart> read_charts(st::File& file, Sources& sources, Diagnostics& diagnostics);

}  // namespace grafverif::program
