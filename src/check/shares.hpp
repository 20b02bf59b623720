// SPDX-License-Identifier: MIT
// Shares of a time limit for several searches: a preliminary search may use only a share of the remaining time. If a
// verdict is unknown after all searches, its reason includes the number of states that earlier searches explored.
#pragma once

#include <atomic>
#include <chrono>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>

#include "grafverif/ir/verdict.hpp"

namespace grafverif {

/// Bounds on the number of states of one search in successive rounds of localization and input abstraction.
inline constexpr std::uint64_t search_rounds[] = {1U << 14U, 1U << 17U, 1U << 20U, 1U << 24U};

using Deadline = std::optional<std::chrono::steady_clock::time_point>;

inline bool is_over(const Deadline& deadline) { return deadline && std::chrono::steady_clock::now() >= *deadline; }

/// True after the deadline, or if the caller requests a stop.
inline bool is_over(const Deadline& deadline, const std::atomic<bool>* stop) {
    return (stop != nullptr && stop->load(std::memory_order_relaxed)) || is_over(deadline);
}

/// Returns the end of the first of `shares` equal shares of the remaining time; empty without a deadline.
inline Deadline share_of(const Deadline& deadline, std::size_t shares) {
    const auto now = std::chrono::steady_clock::now();
    if (!deadline || *deadline <= now) return deadline;
    return now + (*deadline - now) / shares;
}

/// Returns the time at which a sixteenth of the remaining time will be left; empty without a deadline.
inline Deadline most_of(const Deadline& deadline) {
    const auto now = std::chrono::steady_clock::now();
    if (!deadline || *deadline <= now) return deadline;
    return *deadline - (*deadline - now) / 16;
}

/// Adds the number of states that `searches` explored to the reason of a verdict that is unknown because of a time or
/// memory limit. Has no effect if these searches did not begin.
inline void report_earlier(Verdict& verdict, std::string_view searches, std::uint64_t states) {
    const bool limited = verdict.obstacle == UnknownReason::Stopped || verdict.obstacle == UnknownReason::Memory;
    if (verdict.outcome != Outcome::Unknown || !limited || states < 2) return;
    verdict.reason += "; " + std::string(searches) + " explored " + std::to_string(states) + " states before";
}

}  // namespace grafverif
