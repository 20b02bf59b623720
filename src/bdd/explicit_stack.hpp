// SPDX-License-Identifier: MIT
// Executes the recursion of BDD operations with an explicit stack. An operation splits its operands at their topmost
// level, processes both cofactors and combines the results. Known results are read from the cache. Pending calls are
// stored as frames in the kernel of the BDD space. Therefore, the depth of the native stack is constant, garbage
// collection finds all operands that are in use, and an operation is cancelled by removing its frames.
//
// A Rule defines one operation:
//   Operation operation             cache key
//   bool terminal_case(Kernel&, Call&, Edge& result, bool& flip)
//                                   in a terminal case, stores the result and returns true; otherwise normalizes the
//                                   call and returns false. Sets `flip` if the result must be complemented
//   uint32_t level(Kernel&, Call)   branching level
//   uint32_t third(Call)            third operand of the cache key
//   Call low(Kernel&, Frame), high(Kernel&, Frame)
//   bool enough(Kernel&, Frame, Edge& low)      true if the low branch determines the result, which it stores in `low`
//   Edge join(Kernel&, Frame, Edge high)        combines the results of both branches; the frame is still on the stack
// `terminal_case` and `join` may run other operations on edges that frames contain. `terminal_case`
// and `join` must pass each result of another operation directly to the next operation, because no
// frame protects this result from a garbage collection.
#pragma once

#include "bdd/kernel.hpp"

namespace grafverif::bdd {

struct Call {
    Edge f = 0, g = 0, h = 0;
};

/// Default functions of a Rule whose two or three operands all branch at the same level.
struct Branching {
    static Call low(const Kernel& kernel, const Frame& at) {
        return {kernel.low(at.f, at.level), kernel.low(at.g, at.level), kernel.low(at.h, at.level)};
    }
    static Call high(const Kernel& kernel, const Frame& at) {
        return {kernel.high(at.f, at.level), kernel.high(at.g, at.level), kernel.high(at.h, at.level)};
    }
    static std::uint32_t third(const Call& call) { return call.h; }
    static bool enough(const Kernel&, const Frame&, Edge&) { return false; }
    static Edge join(Kernel& kernel, Frame at, Edge high) { return make(kernel, at.level, at.low, high); }
};

template <class Rule>
Edge run(Kernel& kernel, const Rule& rule, Call call) {
    const std::size_t base = kernel.frames.size();
    for (;;) {
        Edge result = 0;
        bool flip = false;
        if (!rule.terminal_case(kernel, call, result, flip)) {
            if (!kernel.cache.find(Rule::operation, call.f, call.g, rule.third(call), result)) {
                kernel.watch.step();
                kernel.frames.push({call.f, call.g, call.h, 0, rule.level(kernel, call), false, flip});
                call = rule.low(kernel, kernel.frames.top());
                continue;
            }
        }
        result ^= static_cast<Edge>(flip);
        for (;;) {  // each iteration continues the topmost frame that has a pending branch
            if (kernel.frames.size() == base) return result;
            Frame& waiting = kernel.frames.top();
            if (!waiting.has_low && !rule.enough(kernel, waiting, result)) {
                waiting.low = result;
                waiting.has_low = true;
                call = rule.high(kernel, waiting);
                break;
            }
            if (waiting.has_low) result = rule.join(kernel, kernel.frames.top(), result);
            const Frame& done = kernel.frames.top();
            kernel.cache.insert(Rule::operation, done.f, done.g, rule.third(Call{done.f, done.g, done.h}), result);
            result ^= static_cast<Edge>(done.flip);
            kernel.frames.pop();
        }
    }
}

}  // namespace grafverif::bdd
