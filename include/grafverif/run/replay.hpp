// SPDX-License-Identifier: MIT
// Replay of a run of a closed loop on the rules of IEC 60848: what each controller did, evolution by evolution, is done
// again by the interpreter on the chart itself, with the inputs and the values of time conditions sampled there. A run
// that does not replay was not one of the chart: a fault of ours, between derive and the engine.
//
//   start()    the first evolution                    stored variables agree
//   fire()     inputs and time conditions are sampled; the age of a step agrees with its timers
//   evolve()   one evolution                          transitions cleared, situation, stored variables, stable agree
//   write()    outputs agree
#pragma once

#include <cstddef>
#include <optional>
#include <span>
#include <string>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

struct Disagreement {
    std::size_t move = 0;    ///< index in the run
    std::string where = {};  ///< `controller press, evolution 12`
    std::string what = {};   ///< what the network has and what the rules give

    bool operator==(const Disagreement&) const = default;
};

/// The first disagreement, if any. `charts`: those of the network's controllers, in order. Requires charts that derive
/// accepts.
std::optional<Disagreement> disagreement(const Network& network, std::span<const Chart* const> charts, const Run& run);

/// What cannot be done together in one evolution.
struct Clash {
    std::string controller = {};
    std::string variable = {};   ///< two stored actions give it different values; empty: forcing orders contradict each other
};
/// Of a run that ends in a race; nothing where by the rules none is.
std::optional<Clash> clash(const Network& network, std::span<const Chart* const> charts, const Run& run);

}  // namespace grafverif
