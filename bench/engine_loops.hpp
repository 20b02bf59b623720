// SPDX-License-Identifier: MIT
// Closed loops for the measurements of the engines, read from the samples or made as text, and composed.
#pragma once

#include <string>
#include <vector>

#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/network.hpp"

namespace grafverif::bench {

/// The text of `samples/PATH`.
std::string sample(const std::string& path);

/// The first loop of a model: its controllers' equations, in order, and its plant alone.
struct LoopParts {
    Model model = {};
    std::vector<Equations> equations = {};
    Network plant = {};
};

/// Those of `text`. Throws std::invalid_argument with the first errors where it does not read.
LoopParts parts(const std::string& text);

/// The first loop of `text`, composed. Throws likewise.
Network loop(const std::string& text, Grain grain = Grain::Phased);

/// Two testing stations side by side in one network, which share nothing but time.
Network two_stations(Grain grain = Grain::Phased);

/// `count` testing stations in one loop, each with a controller of its own, which share nothing but time: the text of the
/// sample once per station, its names numbered (`P15_2`).
std::string stations(int count);

/// A transfer line of `cells` drilling cells between buffers, run by one PLC: the sample of three cells is this text.
std::string transfer_line(int cells);

/// One chart that drives `cylinders` cylinders, each out and in again with its three sensors, all started together.
std::string cylinders(int cylinders);

}  // namespace grafverif::bench
