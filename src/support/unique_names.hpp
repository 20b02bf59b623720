// SPDX-License-Identifier: MIT
// UniqueNames: generates unique names in one namespace from preferred names, such as `pulse`, `pulse_2`, `pulse_3`.
#pragma once

#include <cstddef>
#include <string>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace grafverif {

class UniqueNames {
public:
    void reserve(std::size_t names) { taken_.reserve(names); }

    /// Marks `name` as used, so that `fresh` does not return it.
    void take(std::string name) { taken_.insert(std::move(name)); }

    /// Returns `preferred` if it is unused, otherwise `preferred_2`, `preferred_3`, and so on.
    std::string fresh(const std::string& preferred) {
        if (taken_.insert(preferred).second) return preferred;
        for (std::size_t& count = counts_.try_emplace(preferred, 1).first->second;;) {
            std::string name = preferred + "_" + std::to_string(++count);
            if (taken_.insert(name).second) return name;
        }
    }

private:
    std::unordered_set<std::string> taken_ = {};
    std::unordered_map<std::string, std::size_t> counts_ = {};
};

}  // namespace grafverif
