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

    /// Marks `name` as used.
    void take(std::string name) { taken_.insert(std::move(name)); }

    /// Returns `wish` if it is unused, otherwise `wish_2`, `wish_3`, and so on.
    std::string fresh(const std::string& wish) {
        if (taken_.insert(wish).second) return wish;
        for (std::size_t& count = counts_.try_emplace(wish, 1).first->second;;) {
            std::string name = wish + "_" + std::to_string(++count);
            if (taken_.insert(name).second) return name;
        }
    }

private:
    std::unordered_set<std::string> taken_ = {};
    std::unordered_map<std::string, std::size_t> counts_ = {};
};

}  // namespace grafverif
