// SPDX-License-Identifier: MIT
// Nearest: finds the declared name that a misspelt name probably denotes. The distance is the number of insertions,
// deletions and replacements of characters and of swaps of adjacent characters; candidates at a distance of more than
// two are ignored. Most candidates are excluded by their length alone. Case is considered only if
// distances are equal.
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
    /// Returns the first of the nearest candidates; empty if all candidates are too different.
    const std::string& best() const { return best_; }

private:
    std::string name_;
    std::string best_ = {};
    std::string prefixed_ = {};
    /// Only candidates whose rank is lower than this number are considered. The rank is twice the
    /// distance without regard to case, plus 1 if the case differs.
    std::size_t distance_;
};

}  // namespace grafverif
