// SPDX-License-Identifier: MIT
#include "syntax/nearest.hpp"

#include <algorithm>
#include <array>

namespace grafverif {

namespace {

constexpr std::size_t longest = 64;

/// The distance of both (optimal string alignment); at least `bound` where it is not below.
std::size_t distance(std::string_view a, std::string_view b, std::size_t bound) {
    const std::size_t difference = a.size() > b.size() ? a.size() - b.size() : b.size() - a.size();
    if (difference >= bound || a.size() > longest || b.size() > longest) return bound;
    std::array<std::array<std::size_t, longest + 1>, 3> rows = {};
    for (std::size_t j = 0; j <= b.size(); ++j) rows[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        const auto& above = rows[(i - 1) % 3];
        auto& row = rows[i % 3];
        row[0] = i;
        std::size_t least = i;
        for (std::size_t j = 1; j <= b.size(); ++j) {
            const std::size_t replaced = above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            row[j] = std::min({above[j] + 1, row[j - 1] + 1, replaced});
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                row[j] = std::min(row[j], rows[(i - 2) % 3][j - 2] + 1);
            least = std::min(least, row[j]);
        }
        if (least >= bound) return bound;
    }
    return std::min(rows[a.size() % 3][b.size()], bound);
}

}  // namespace

namespace {

/// How far a candidate may be: numbers and single letters are near to everything, and tell nothing.
std::size_t tolerance(std::string_view name) {
    if (name.size() < 2 || name.find_first_not_of("0123456789") == std::string_view::npos) return 0;
    return name.size() < 6 ? 1 : 2;
}

}  // namespace

Nearest::Nearest(std::string_view name) : name_(name.substr(0, longest + 1)), distance_(tolerance(name) + 1) {}

void Nearest::offer(std::string_view candidate) {
    const std::size_t found = distance(name_, candidate, distance_);
    if (found >= distance_) return;
    distance_ = found;
    best_ = candidate;
}

}  // namespace grafverif
