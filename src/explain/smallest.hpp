// SPDX-License-Identifier: MIT
// Finds a smallest set of numbers that has a given effect. Sets are tried in the order of increasing size, and sets of
// equal size in lexicographic order.
#pragma once

#include <cstddef>
#include <functional>
#include <numeric>
#include <optional>
#include <ranges>
#include <vector>

namespace grafverif {

/// The result of trying a set.
enum class Attempt {
    Does,
    DoesNot,
    Spent,  ///< unknown, because the maximum effort was reached
};

struct SmallestSet {
    std::optional<std::vector<std::size_t>> found = {};  ///< elements of the set, increasing; empty if none was found
    std::size_t tried = 0;                               ///< number of sets that were tried

    /// True if the search was stopped, or reached its maximum effort, before all sets were tried.
    bool exhausted = false;
};

/// Optional cancellation callback; called before every set.
using StopRequested = std::function<bool()>;

/// Sets `chosen` to the next combination of the same size of the numbers below `count`, in lexicographic order. Returns
/// false if there is no next combination.
inline bool next_choice(std::vector<std::size_t>& chosen, std::size_t count) {
    for (std::size_t k = chosen.size(); k-- > 0;) {
        if (chosen[k] + chosen.size() - k >= count) continue;
        ++chosen[k];
        for (std::size_t i = k + 1; i < chosen.size(); ++i) chosen[i] = chosen[i - 1] + 1;
        return true;
    }
    return false;
}

/// Returns the chosen elements of `all`, in the order of `all`. `chosen` contains positions counted from the end of
/// `all`, so that the last elements of `all` are tried first.
template <class T>
std::vector<T> chosen_from_the_end(const std::vector<T>& all, const std::vector<std::size_t>& chosen) {
    std::vector<T> elements;
    for (const std::size_t each : std::views::reverse(chosen)) elements.push_back(all[all.size() - 1 - each]);
    return elements;
}

/// Calls `attempt` with the non-empty subsets of {0, ..., count - 1} in order of size, until `attempt` returns Does or
/// Spent, or `stopped` returns true.
template <class Try>
SmallestSet smallest_set(std::size_t count, const StopRequested& stopped, const Try& attempt) {
    SmallestSet result;
    for (std::size_t size = 1; size <= count; ++size) {
        std::vector<std::size_t> chosen(size);
        std::iota(chosen.begin(), chosen.end(), std::size_t{0});
        do {
            const Attempt what = stopped && stopped() ? Attempt::Spent : attempt(chosen);
            result.exhausted = what == Attempt::Spent;
            if (result.exhausted) return result;
            ++result.tried;
            if (what == Attempt::DoesNot) continue;
            result.found = chosen;
            return result;
        } while (next_choice(chosen, count));
    }
    return result;
}

}  // namespace grafverif
