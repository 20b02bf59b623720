// SPDX-License-Identifier: MIT
// Divides a time limit between several searches. A preliminary search uses only a share of the remaining time, so that
// later searches also have time. If a verdict is unknown after all searches, its reason includes the number of states
// that earlier searches explored.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// Maximum number of states of each search in the first, second, third and fourth round of localization and input
/// abstraction.
inline constexpr std::uint64_t search_rounds[] = {1U << 14U, 1U << 17U, 1U << 20U, 1U << 24U};

using Deadline = std::optional<std::chrono::steady_clock::time_point>;

inline bool is_over(const Deadline& deadline) { return deadline && std::chrono::steady_clock::now() >= *deadline; }

/// True if the deadline has passed or the flag `stop` is set.
inline bool is_over(const Deadline& deadline, const std::atomic<bool>* stop) {
    return (stop != nullptr && stop->load(std::memory_order_relaxed)) || is_over(deadline);
}

/// Divides the remaining time into `shares` equal shares and returns the end of the first share. Returns nullopt if
/// there is no deadline.
inline Deadline share_of(const Deadline& deadline, std::size_t shares) {
    const auto now = std::chrono::steady_clock::now();
    if (!deadline || *deadline <= now) return deadline;
    return now + (*deadline - now) / shares;
}

/// Returns the time at which 15/16 of the remaining time will have passed, or nullopt if there is no deadline.
inline Deadline most_of(const Deadline& deadline) {
    const auto now = std::chrono::steady_clock::now();
    if (!deadline || *deadline <= now) return deadline;
    return *deadline - (*deadline - now) / 16;
}

/// Adds the number of states that `searches` explored to the reason of a verdict that is unknown because of a time or
/// memory limit. Has no effect if `states` is less than 2, because such a number means that these searches did not
/// begin.
inline void report_earlier(Verdict& verdict, std::string_view searches, std::uint64_t states) {
    const bool limited = verdict.obstacle == UnknownReason::Stopped || verdict.obstacle == UnknownReason::Memory;
    if (verdict.outcome != Outcome::Unknown || !limited || states < 2) return;
    verdict.reason +=
        "; " + std::string(searches) + " explored " + std::to_string(states) + " states before this search";
}

}  // namespace grafverif
