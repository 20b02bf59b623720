// SPDX-License-Identifier: MIT
// read_charts: structure of the Sequential Function Charts of a file, and an ACTION_CONTROL for each of their actions.
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
    st::Name name = {};  ///< invalid if the statements are in the step
    std::string label = {};
    bool variable = false;                                        ///< `name` is a Boolean variable
    st::Block body = {};                                          ///< otherwise
    std::map<std::string, std::vector<Id<st::Word>>> steps = {};  ///< per qualifier
    Id<st::Expr> time = {};                                       ///< invalid: none, or a constant within `control`
    std::size_t control = 0;                                      ///< its ACTION_CONTROL, a unit of the file
    std::uint32_t cell = 0;                                       ///< of the instance; set by the Reader
    Span where = {};
};

struct Chart {
    bool valid = false;                       ///< no error was reported
    std::vector<std::size_t> order = {};      ///< the transitions by priority, then position
    std::vector<ChartAction> actions = {};    ///< in the order of their first action blocks
    std::uint32_t started = 0;                ///< cell: the body was executed before
    std::vector<std::uint32_t> cleared = {};  ///< cell per transition
};

/// A chart for each unit of the file, not valid for other units. The units of action controls are added to the file.
std::vector<Chart> read_charts(st::File& file, Sources& sources, Diagnostics& diagnostics);

}  // namespace grafverif::program
