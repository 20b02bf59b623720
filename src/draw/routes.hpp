// SPDX-License-Identifier: MIT
// Routes: computes vertical positions and connecting lines. Horizontal lines run only between two rows, on tracks.
// Lines from the row above use the upper tracks, and lines to the row below use the lower tracks, so that a line never
// runs upwards between two rows. A long flow is folded: it is cut between rows that few lines connect, and the pieces
// are placed next to each other. Each line that is cut has the same number as a label at both ends.
#pragma once

#include <string>
#include <vector>

#include "draw/columns.hpp"
#include "draw/flow.hpp"
#include "grafverif/ir/drawing.hpp"

namespace grafverif::draw {

struct Routes {
    /// The double line of a transition at which several links join, and the line that connects it to the bar of the
    /// transition.
    struct Meeting {
        std::size_t node = 0;
        std::vector<Drawing::Line> lines = {};
    };
    /// The label at the end of a cut line.
    struct Reference {
        Drawing::Point at = {};  ///< end point of the line
        bool below = false;      ///< true if the label is below the end of the line
        std::size_t number = 0;
        std::size_t arc = 0;  ///< index of an arc that is drawn with this line
    };
    std::vector<Drawing::Point> nodes = {};  ///< centres of the nodes
    std::vector<std::vector<Drawing::Line>> arcs = {};
    std::vector<Meeting> meetings = {};
    std::vector<Reference> references = {};
    Drawing::Size size = {};
};

inline constexpr int reference_height = 12;

/// Computes the routes. `pieces` is the number of pieces into which the flow is folded; 0 selects a number for which
/// the drawing has the shape of a page.
Routes routes_of(const Flow& flow, const Order& order, const Columns& columns, int pieces);

}  // namespace grafverif::draw
