// SPDX-License-Identifier: MIT
// Nearest: finds the name that was probably misspelt. Distance: number of insertions, deletions, replacements and swaps
// of neighbours, at most two; most candidates are excluded by their length alone. Case is compared only for equal
// distances.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace grafverif {

class Nearest {
public:
    explicit Nearest(std::string_view name);

    void offer(std::string_view candidate);
    /// Offers a step variable: `X` and the name of a step.
    void offer(char prefix, std::string_view candidate);
    /// The first of the nearest candidates; empty if none is near enough.
    const std::string& best() const { return best_; }

private:
    std::string name_;
    std::string best_ = {};
    std::string prefixed_ = {};
    std::size_t
        distance_;  ///< only lower ranks are considered: twice the distance ignoring case, plus 1 if the case differs
};

}  // namespace grafverif
