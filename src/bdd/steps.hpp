// SPDX-License-Identifier: MIT
// Recursion without a stack of calls. An operation on diagrams splits its operands at their topmost level, does both
// branches and joins the results; what is known is found in the cache. Here the calls that wait are frames in the
// space: however deep the diagrams, the native stack stays flat; collection finds what is needed; and an operation ends
// anywhere by dropping its frames.
//
// A Rule is one operation:
//   Operation operation             its name in the cache
//   bool settle(Kernel&, Call&, Edge& result, bool& flip)
//                                   the result where it is plain; otherwise the call in normal form, `flip` where its
//                                   result is to be complemented
//   uint32_t level(Kernel&, Call)   where it branches
//   uint32_t third(Call)            the third operand for the cache
//   Call low(Kernel&, Frame), high(Kernel&, Frame)
//   bool enough(Kernel&, Frame, Edge& low)      whether the low branch tells the result, which is put in its place
//   Edge join(Kernel&, Frame, Edge high)        the result; its frame is still there
// `settle` and `join` may run other operations on edges that the frames hold, and hand the last result on to one.
#pragma once

#include "bdd/kernel.hpp"

namespace grafverif::bdd {

struct Call {
    Edge f = 0, g = 0, h = 0;
};

/// The plain parts of a rule for two or three operands that all branch alike.
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
        if (!rule.settle(kernel, call, result, flip)) {
            if (!kernel.cache.find(Rule::operation, call.f, call.g, rule.third(call), result)) {
                kernel.watch.step();
                kernel.frames.push({call.f, call.g, call.h, 0, rule.level(kernel, call), false, flip});
                call = rule.low(kernel, kernel.frames.top());
                continue;
            }
        }
        result ^= static_cast<Edge>(flip);
        for (;;) {  // a result goes up to the first frame that has another branch to do
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
