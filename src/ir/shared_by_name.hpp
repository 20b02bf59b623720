// SPDX-License-Identifier: MIT
#pragma once

#include <string_view>
#include <unordered_map>

#include "grafverif/ir/closed_loop.hpp"

namespace grafverif {

/// The shared variables of a loop, which inputs and outputs of its charts are by name.
class SharedByName {
public:
    explicit SharedByName(const ClosedLoop& loop) {
        for (const Id<ClosedLoop::Shared> id : loop.shared.ids()) known_.emplace(loop.shared[id].name, id);
    }
    /// Not valid: the loop shares none of that name.
    Id<ClosedLoop::Shared> operator()(std::string_view name) const {
        const auto found = known_.find(name);
        return found == known_.end() ? Id<ClosedLoop::Shared>{} : found->second;
    }

private:
    std::unordered_map<std::string_view, Id<ClosedLoop::Shared>> known_ = {};
};

}  // namespace grafverif
