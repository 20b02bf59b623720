// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <unordered_map>

#include "grafverif/ir/closed_loop.hpp"

namespace grafverif {

/// Finds shared variables of a loop by name. Inputs and outputs of charts refer to shared variables by name.
class SharedByName {
public:
    explicit SharedByName(const ClosedLoop& loop) {
        for (const Id<ClosedLoop::Shared> id : loop.shared.ids()) known_.emplace(loop.shared[id].name, id);
    }
    /// Returns an invalid id if the loop has no shared variable of this name.
    Id<ClosedLoop::Shared> operator()(std::string_view name) const {
        const auto found = known_.find(name);
        return found == known_.end() ? Id<ClosedLoop::Shared>{} : found->second;
    }

private:
    std::unordered_map<std::string_view, Id<ClosedLoop::Shared>> known_ = {};
};

}  // namespace grafverif
