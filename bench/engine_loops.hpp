// SPDX-License-Identifier: MIT
// Closed loops for measurements of the engines. The loops are read from samples or generated as
// text, and then composed.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/network.hpp"

namespace grafverif::bench {

/// Returns the text of `samples/PATH`.
std::string sample(const std::string& path);

/// The first loop of a model: the equations of its controllers, in order, and its plant.
struct LoopParts {
    Model model = {};
    std::vector<Equations> equations = {};
    Network plant = {};
};

/// Returns the parts of the first loop of `text`. Throws std::invalid_argument with the first errors if the text is
/// invalid.
LoopParts parts(const std::string& text);

/// Composes the first loop of `text` into a network. Throws std::invalid_argument if the text is invalid.
Network loop(const std::string& text, Grain grain = Grain::Phased);

/// Returns a network of two testing stations that share only time.
Network two_stations(Grain grain = Grain::Phased);

/// Returns the text of a loop with `count` testing stations, each with a separate controller. The stations share only
/// time. The text of the sample is repeated for each station with numbered names (`P15_2`).
std::string stations(int count);

/// Returns the text of a transfer line, controlled by one PLC, with `cells` drilling cells between
/// buffers. With three cells, the text is that of `samples/transfer_line`.
std::string transfer_line(int cells);

/// Returns one chart that drives `cylinders` cylinders. All cylinders start together; each cylinder
/// moves out and in again, and has three sensors.
std::string cylinders(int cylinders);

}  // namespace grafverif::bench
