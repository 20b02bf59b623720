// SPDX-License-Identifier: MIT
// Selects what happens if memory is refused. By default the allocation fails. Allocations that must not fail use the
// memory that is kept back (app/system/watchdog): those of an error report, of destructors of nlohmann::json, and of
// the constructors of Bison's parsers. The latter two are noexcept.
#pragma once

#include <exception>
#include <utility>

namespace grafverif {

inline thread_local bool uses_reserve = false;

/// While one exists, refused allocations of this thread use the memory that is kept back, or do not.
class ReserveUse {
public:
    explicit ReserveUse(bool use) : before_(std::exchange(uses_reserve, use)) {}
    ~ReserveUse() { uses_reserve = before_; }
    ReserveUse(const ReserveUse&) = delete;
    ReserveUse& operator=(const ReserveUse&) = delete;

private:
    bool before_;
};

/// `make()`, which uses the memory that is kept back.
template <class Make>
auto made_with_reserve(const Make& make) {
    const ReserveUse use(true);
    return make();
}

/// True if a refused allocation of this thread is to be repeated with the memory that is kept back.
inline bool must_not_fail() { return uses_reserve || std::uncaught_exceptions() > 0; }

}  // namespace grafverif
