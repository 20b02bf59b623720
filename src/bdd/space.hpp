// SPDX-License-Identifier: MIT
// Calls into BuDDy that may end early. BuDDy reports errors to a hook and goes on with a wrong result, which would
// enter its caches; so the hook jumps out of the operation instead, as BuDDy's own reordering does, and `guarded`
// turns that into BddExhausted. Only BuDDy's C frames are jumped over.
#pragma once

#include <bdd.h>
#undef bdd_init       // BuDDy's header puts its C++ handles in the places of these C functions
#undef bdd_ithvar
#undef bdd_nithvar

#include <csetjmp>
#include <cstdint>

#include "grafverif/bdd/bdd.hpp"

namespace grafverif::bdd {

/// Where the hooks jump to, armed while BuDDy works.
std::jmp_buf& escape();
/// Before an operation: ends with BddExhausted where somebody asked to stop.
void start_operation();
/// After one: the hooks have nowhere to jump to.
void end_operation();
[[noreturn]] void throw_exhausted(int reason);

/// The result of `operation`, a call of BuDDy that creates nodes, as a handle.
template <class Operation>
Bdd guarded(const Operation& operation) {
    start_operation();
    const int reason = setjmp(escape());   // NOLINT: the only way out of BuDDy
    if (reason != 0) throw_exhausted(reason);
    const int node = operation();
    end_operation();
    return Bdd::of_node(node);
}

inline bddPair* pairs_of(void* pairs) { return static_cast<bddPair*>(pairs); }

}  // namespace grafverif::bdd
