// SPDX-License-Identifier: MIT
// Routes: how far down everything stands, and the lines between. Lines go across only between two rows, in tracks: those
// that leave the row above in the upper ones, those that enter the row below in the lower ones, so that a line never
// turns back. A long flow is folded: cut between two rows where few lines pass, the pieces put side by side, each line
// that is cut named by a number at both ends.
#pragma once

#include <string>
#include <vector>

#include "draw/columns.hpp"
#include "draw/flow.hpp"
#include "grafverif/ir/drawing.hpp"

namespace grafverif::draw {

struct Routes {
    /// The double line of a bar, and the line from the bar to it.
    struct Meeting {
        std::size_t node = 0;
        std::vector<Drawing::Line> lines = {};
    };
    /// A line that is cut here.
    struct Reference {
        Drawing::Point at = {};  ///< the end of the line
        bool below = false;      ///< the name stands below it
        std::size_t number = 0;
        std::size_t arc = 0;  ///< one of those that it carries
    };
    std::vector<Drawing::Point> nodes = {};  ///< centres
    std::vector<std::vector<Drawing::Line>> arcs = {};
    std::vector<Meeting> meetings = {};
    std::vector<Reference> references = {};
    Drawing::Size size = {};
};

inline constexpr int reference_height = 12;

/// `pieces`: into which the flow is folded; 0: as many as make a page of it.
Routes routes_of(const Flow& flow, const Order& order, const Columns& columns, int pieces);

}  // namespace grafverif::draw
