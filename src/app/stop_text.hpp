// SPDX-License-Identifier: MIT
// Engines report that they were stopped; the caller that stopped them adds the cause.
#pragma once

#include <string>

#include "app/options.hpp"
#include "grafverif/ir/chart_run.hpp"

namespace grafverif::app {

/// Returns `reason` with the cause inserted after its word `stopped`: the user if `by_user`, otherwise the time limit.
inline std::string with_who_stopped(std::string reason, bool by_user, const Options& options) {
    constexpr std::string_view word = "stopped", limit = " at the time limit";
    const std::size_t at = reason.find(word);
    if (at == std::string::npos) return reason;
    const std::size_t insert_at = at + word.size();
    if (by_user) return reason.insert(insert_at, " by Ctrl-C or another signal");
    if (!options.timeout_ms) return reason;
    if (reason.compare(insert_at, limit.size(), limit) != 0) reason.insert(insert_at, limit);
    return reason.insert(insert_at + limit.size(),
                         " of " + seconds_text(static_cast<std::int64_t>(*options.timeout_ms)));
}

/// Returns `reason` with the option that increases the limit that was reached.
inline std::string with_remedy(std::string reason, const Options& options) {
    if (options.timeout_ms && reason.find(" at the time limit") != std::string::npos) reason += "; raise `--timeout`";
    else if (reason.find("memory limit") != std::string::npos) reason += "; raise `--max-memory`";
    return reason;
}

}  // namespace grafverif::app
