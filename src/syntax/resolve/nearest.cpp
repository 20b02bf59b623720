// SPDX-License-Identifier: MIT
#include "syntax/resolve/nearest.hpp"

#include <algorithm>
#include <array>

namespace grafverif {

namespace {

constexpr std::size_t longest = 64;

/// Returns the distance of two names (optimal string alignment), or a value of at least `bound` if the distance is not
/// less than `bound`. The function computes only those cells of the distance matrix that are at most `bound` away from
/// the diagonal.
std::size_t distance(std::string_view a, std::string_view b, std::size_t bound) {
    const std::size_t difference = a.size() > b.size() ? a.size() - b.size() : b.size() - a.size();
    if (difference >= bound || a.size() > longest || b.size() > longest) return bound;
    std::array<std::array<std::size_t, longest + 2>, 3> rows;  // each row is initialized before its use
    for (std::size_t j = 0; j <= std::min(b.size(), bound); ++j) rows[0][j] = j;
    for (std::size_t i = 1; i <= a.size(); ++i) {
        const auto& above = rows[(i - 1) % 3];
        auto& row = rows[i % 3];
        const std::size_t first = i > bound ? i - bound : 0, last = std::min(b.size(), i + bound);
        std::size_t least = bound;
        for (std::size_t j = first; j <= last; ++j) {
            std::size_t best = j == 0 ? i : above[j - 1] + (a[i - 1] == b[j - 1] ? 0 : 1);
            if (j < i + bound) best = std::min(best, above[j] + 1);
            if (j > first) best = std::min(best, row[j - 1] + 1);
            if (i > 1 && j > 1 && a[i - 1] == b[j - 2] && a[i - 2] == b[j - 1])
                best = std::min(best, rows[(i - 2) % 3][j - 2] + 1);
            row[j] = best;
            least = std::min(least, best);
        }
        if (least >= bound) return bound;
    }
    return std::min(rows[a.size() % 3][b.size()], bound);
}

}  // namespace

namespace {

std::string folded(std::string_view name) {
    std::string text(name);
    for (char& byte : text)
        if (byte >= 'A' && byte <= 'Z') byte = static_cast<char>(byte - 'A' + 'a');
    return text;
}

/// Returns the maximum distance of a candidate from `name`. For numbers and single letters, only a difference in case
/// is tolerated, because they are similar to too many names.
std::size_t tolerance(std::string_view name) {
    if (name.size() < 2 || name.find_first_not_of("0123456789") == std::string_view::npos) return 0;
    return name.size() < 6 ? 1 : 2;
}

}  // namespace

Nearest::Nearest(std::string_view name) : name_(name.substr(0, longest + 1)), distance_(2 * tolerance(name) + 2) {}

void Nearest::offer(char prefix, std::string_view candidate) {
    if (distance_ == 1) return;
    prefixed_.assign(1, prefix);
    prefixed_ += candidate;
    offer(prefixed_);
}

void Nearest::offer(std::string_view candidate) {
    // At the distance 1, the best candidate differs from the name only in case; this is the minimum distance.
    if (distance_ == 1 || candidate == name_) return;
    const std::size_t bound = (distance_ + 1) / 2;
    if (std::max(name_.size(), candidate.size()) - std::min(name_.size(), candidate.size()) >= bound) return;
    const std::size_t edits = distance(folded(name_), folded(candidate), bound);
    if (edits >= bound) return;
    const std::size_t rank = 2 * edits + (distance(name_, candidate, edits + 1) > edits ? 1 : 0);
    if (rank >= distance_) return;
    distance_ = rank;
    best_ = candidate;
}

}  // namespace grafverif
