// SPDX-License-Identifier: MIT
// Nearest: finds the name that was probably misspelt. The distance is the number of insertions, deletions, replacements
// and swaps of neighbours; it is at most two. Most candidates are excluded by their length alone. Case is considered
// only if distances are equal.
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
    /// Returns the first of the nearest candidates; empty if none is near enough.
    const std::string& best() const { return best_; }

private:
    std::string name_;
    std::string best_ = {};
    std::string prefixed_ = {};
    std::size_t
        /// Only lower ranks are considered; the rank is twice the distance without regard to case, plus 1 if the case
        /// differs.
        distance_;
};

}  // namespace grafverif
