// SPDX-License-Identifier: MIT
// Nearest: the name that a misspelt one may have meant. Distance: insertions, deletions, replacements and swaps of
// neighbours, at most two of them, so that a comparison costs little more than comparing lengths. The case of letters
// decides between equal distances only.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace grafverif {

class Nearest {
public:
    explicit Nearest(std::string_view name);

    void offer(std::string_view candidate);
    /// `X` and the name of a step: its variable.
    void offer(char prefix, std::string_view candidate);
    /// The first of the nearest candidates; empty when none is near.
    const std::string& best() const { return best_; }

private:
    std::string name_;
    std::string best_ = {};
    std::string prefixed_ = {};
    std::size_t
        distance_;  ///< only a lower rank is of interest: twice the distance without case, plus 1 if case differs
};

}  // namespace grafverif
