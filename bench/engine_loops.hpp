// SPDX-License-Identifier: MIT
// Closed loops for measurements of the engines, read from the samples or generated as text, and composed.
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

/// The parts of the first loop of `text`. Throws std::invalid_argument with the first errors if it is invalid.
LoopParts parts(const std::string& text);

/// The first loop of `text`, composed. Throws std::invalid_argument if it is invalid.
Network loop(const std::string& text, Grain grain = Grain::Phased);

/// Two testing stations in one network, which share only time.
Network two_stations(Grain grain = Grain::Phased);

/// `count` testing stations in one loop, each with a separate controller, which share only time: the text of the sample
/// once per station, its names numbered (`P15_2`).
std::string stations(int count);

/// A transfer line of `cells` drilling cells between buffers, controlled by one PLC; the sample with three cells is
/// this text.
std::string transfer_line(int cells);

/// One chart that drives `cylinders` cylinders, each out and in again with its three sensors, all started together.
std::string cylinders(int cylinders);

}  // namespace grafverif::bench
