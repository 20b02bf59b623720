// SPDX-License-Identifier: MIT
#include "check/supervise/observation_map.hpp"

#include <algorithm>
#include <iterator>

namespace grafverif::supervise {

ObservationMap::ObservationMap(const symbolic::StateSpace& model, BddSpace& space, const std::vector<Bdd>& seen) {
    std::vector<std::uint32_t> direct, own;
    for (const Bdd& each : seen) {
        const bool bit = !each.is_constant() && size(each) == 1;
        if (bit) {
            literals_.push_back({each.top(), each.high().is_true()});
            direct.push_back(each.top());
            continue;
        }
        const std::uint32_t variable = space.add_variables(1);
        literals_.push_back({variable, true});
        own.push_back(variable);
        link_ &= iff(space.variable(variable), each);
    }
    std::ranges::sort(direct);
    std::vector<std::uint32_t> unseen;
    std::ranges::set_difference(model.state_bits(), direct, std::back_inserter(unseen));
    unseen_ = variable_set(space, unseen);
    own_ = variable_set(space, own);
}

}  // namespace grafverif::supervise
