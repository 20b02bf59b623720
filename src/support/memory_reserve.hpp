// SPDX-License-Identifier: MIT
// Selects what happens if the system refuses memory. By default, the allocation fails. Allocations that must not fail
// use the reserved memory (app/system/watchdog): the allocations for an error report, and allocations in the
// destructors of nlohmann::json and the constructors of Bison's parsers, which are noexcept.
#pragma once

#include <exception>
#include <utility>

namespace grafverif {

inline thread_local bool uses_reserve = false;

/// While an object of this class exists, its argument determines if refused allocations of this thread use the reserved
/// memory.
class ReserveUse {
public:
    explicit ReserveUse(bool use) : before_(std::exchange(uses_reserve, use)) {}
    ~ReserveUse() { uses_reserve = before_; }
    ReserveUse(const ReserveUse&) = delete;
    ReserveUse& operator=(const ReserveUse&) = delete;

private:
    bool before_;
};

/// Returns the result of `make()`, whose allocations may use the reserved memory.
template <class Make>
auto made_with_reserve(const Make& make) {
    const ReserveUse use(true);
    return make();
}

/// True if a refused allocation of this thread must be repeated with the reserved memory.
inline bool must_not_fail() { return uses_reserve || std::uncaught_exceptions() > 0; }

}  // namespace grafverif
