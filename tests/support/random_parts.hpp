// SPDX-License-Identifier: MIT
// Random networks of several parts that share nothing but time, each of one or two small automata: some lock time, go
// on for ever within one instant, come to a dead end, race, or leave a range. For laws on what is judged by parts.
#pragma once

#include <string>

#include "grafverif/ir/network.hpp"
#include "support/random_chart.hpp"

namespace grafverif {

/// A network of `parts` parts, with `settled` and, now and then, `race`; without properties.
Network random_parts(Random& random, int parts);

/// The same, but parts read each other's flags, assign what they read, and set flags that are nobody's: `cells` cells
/// or more of a network without controllers.
Network random_cells(Random& random, int cells);

/// Adds properties of every kind: of single parts, of two of them, of all moves and of settled states.
void ask_of_parts(Network& network, Random& random);

/// The text of a loop of several PLCs, each with a lamp and a button of its own: cycles with delays, edges, a counter that
/// may leave its range, stored actions that may race.
std::string loop_of_plcs(Random& random, int plcs);

}  // namespace grafverif
