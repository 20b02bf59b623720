// SPDX-License-Identifier: MIT
// Generates random walks, which are runs through a network with every possible kind of event, for randomized tests of
// traces and replay.
#pragma once

#include <algorithm>

#include "run/network_walk.hpp"
#include "support/random_chart.hpp"

namespace grafverif {

/// Returns a run of `moves` moves. The run ends earlier if no move is possible, if a model error
/// occurs, or if two stored actions race.
inline Run random_walk(const Network& network, Random& random, int moves) {
    Run run;
    NetworkState state = initial_state(network);
    for (int i = 0; i < moves; ++i) {
        const std::vector<Fire> choices = enabled(network, state);
        const Leeway delay = leeway(network, state);
        const auto count = static_cast<std::int64_t>(choices.size()) + (delay.may_pass ? 1 : 0);
        if (count == 0) return run;
        const std::int64_t drawn = random_number(random, 0, count - 1);
        Move move = Delay{1};
        if (drawn < static_cast<std::int64_t>(choices.size())) move = choices[static_cast<std::size_t>(drawn)];
        else
            move = Delay{random_number(
                random, 1, std::min(delay.limit.value_or(6), std::max<std::int64_t>(1, delay.change.value_or(6))))};
        if (perform(network, state, move).result != Step::Result::Done) return run;
        run.moves.push_back(move);
        if (network.race.valid() && state.variables[network.race.index] != 0) return run;
    }
    return run;
}

}  // namespace grafverif
