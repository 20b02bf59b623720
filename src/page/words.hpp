// SPDX-License-Identifier: MIT
// Returns numbers and lists as text for sentences of a page.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>
#include <vector>

namespace grafverif {

/// Returns text such as `1 run` or `3 runs`.
inline std::string counted(std::size_t number, std::string_view one, std::string_view many) {
    return std::to_string(number) + " " + std::string(number == 1 ? one : many);
}

inline std::string listed(const std::vector<std::string>& words) {
    std::string list;
    for (const std::string& word : words) list += (list.empty() ? "" : ", ") + word;
    return list;
}

}  // namespace grafverif
