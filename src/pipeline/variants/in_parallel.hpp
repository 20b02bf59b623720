// SPDX-License-Identifier: MIT
// Calls a function for a range of indices in several threads.
#pragma once

#include <cstddef>
#include <functional>

namespace grafverif {

/// Returns the number of threads to use: `jobs`, or the number of cores if `jobs` is 0.
unsigned thread_count(unsigned jobs);

/// Calls `work` for each index below `count`, until `stopped` returns true. At most `jobs` threads perform the calls,
/// which begin in the order of the indices. If the system provides fewer threads, the available threads perform all
/// calls. After an exception, no further call begins; when all calls have ended, the exception is rethrown.
void in_parallel(std::size_t count, unsigned jobs, const std::function<bool()>& stopped,
                 const std::function<void(std::size_t)>& work);

}  // namespace grafverif
