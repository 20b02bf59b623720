// SPDX-License-Identifier: MIT
// overloaded: combines one lambda per alternative of a variant, for std::visit.
#pragma once

namespace grafverif {

template <class... Functions>
struct overloaded : Functions... {
    using Functions::operator()...;
};
template <class... Functions>
overloaded(Functions...) -> overloaded<Functions...>;

/// Marks code that is unreachable because of the invariants of the program.
[[noreturn]] void unreachable();

}  // namespace grafverif
