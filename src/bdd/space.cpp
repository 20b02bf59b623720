// SPDX-License-Identifier: MIT
// The life of BuDDy: one space at a time, its limits, and the hooks that keep to them.
#include "bdd/space.hpp"

#include <algorithm>
#include <cassert>
#include <mutex>
#include <thread>

#include "grafverif/support/overloaded.hpp"

namespace grafverif {

namespace {

constexpr int out_of_memory = 1, stopped = 2;   // what the hooks jump with

/// BuDDy's node takes 20 bytes; each of its six caches has one entry of 24 bytes per `nodes_per_cache_entry` nodes.
constexpr int nodes_per_cache_entry = 4;
constexpr std::uint64_t bytes_per_node = 20 + 6 * 24 / nodes_per_cache_entry;
constexpr int first_nodes = 10'000;
/// The table grows by no more than this at once, each time after a garbage collection: that is when the hook looks
/// whether to stop.
constexpr int most_new_nodes = 2'000'000;

/// BuDDy's state is the process's; so is this.
struct State {
    std::mutex one_space = {};
    std::thread::id owner = {};
    BddLimits limits = {};
    std::jmp_buf escape = {};
    bool armed = false;
    bool broken = false;      ///< BuDDy lost its footing: nothing but its end is safe
    unsigned operations = 0;
};
State state;

bool asked_to_stop() {
    if (state.limits.stop != nullptr && state.limits.stop->load(std::memory_order_relaxed)) return true;
    return state.limits.deadline && std::chrono::steady_clock::now() >= *state.limits.deadline;
}

[[noreturn]] void leave(int reason) {
    state.armed = false;
    std::longjmp(state.escape, reason);
}

void on_error(int code) {
    if (!state.armed) return;
    if (code == BDD_MEMORY) state.broken = true;   // the node table has its new size, but not its memory
    if (code == BDD_MEMORY || code == BDD_NODENUM) leave(out_of_memory);
    unreachable();                                 // all other errors are ours
}

void on_garbage_collection(int before, bddGbcStat*) {
    if (before != 0 && state.armed && asked_to_stop()) leave(stopped);
}

bool is_prime(int number) {
    for (int divisor = 3; divisor <= number / divisor; divisor += 2)
        if (number % divisor == 0) return false;
    return number % 2 != 0;
}

/// The most nodes for `bytes`: a prime, because BuDDy rounds the size of its table down to one and corrupts its free
/// list where the rounded maximum is no growth.
int most_nodes(std::uint64_t bytes) {
    const auto nodes = std::clamp<std::uint64_t>(bytes / bytes_per_node, 2 * first_nodes, 1'000'000'000);
    int prime = static_cast<int>(nodes);
    while (!is_prime(prime)) --prime;
    return prime;
}

}  // namespace

namespace bdd {

std::jmp_buf& escape() { return state.escape; }

void start_operation() {
    if (state.broken) throw BddExhausted(BddExhausted::Cause::Memory);
    if (++state.operations % 64 == 0 && asked_to_stop()) throw BddExhausted(BddExhausted::Cause::Stopped);
    state.armed = true;
}

void end_operation() { state.armed = false; }

void throw_exhausted(int reason) {
    throw BddExhausted(reason == stopped ? BddExhausted::Cause::Stopped : BddExhausted::Cause::Memory);
}

}  // namespace bdd

const char* BddExhausted::what() const noexcept {
    return cause_ == Cause::Memory ? "the memory allowed for decision diagrams is used up" : "stopped";
}

struct BddSpace::Kernel {
    std::unique_lock<std::mutex> lock = {};
};

BddSpace::BddSpace(const BddLimits& limits) : kernel_(std::make_unique<Kernel>()) {
    assert(state.owner != std::this_thread::get_id());   // it would wait for itself
    kernel_->lock = std::unique_lock(state.one_space);
    state.owner = std::this_thread::get_id();
    state.limits = limits;
    state.armed = state.broken = false;
    ::bdd_init(first_nodes, first_nodes / nodes_per_cache_entry);
    ::bdd_error_hook(on_error);
    ::bdd_gbc_hook(on_garbage_collection);
    ::bdd_setcacheratio(nodes_per_cache_entry);
    ::bdd_setmaxincrease(most_new_nodes);
    ::bdd_setmaxnodenum(most_nodes(limits.memory));
}

BddSpace::~BddSpace() {
    state.limits = {};
    ::bdd_done();
    state.owner = {};
}

std::uint32_t BddSpace::add_variables(std::size_t count) {
    const int first = ::bdd_varnum();
    if (count == 0) return static_cast<std::uint32_t>(first);
    bdd::start_operation();
    const int reason = setjmp(bdd::escape());   // NOLINT: see space.hpp
    if (reason != 0) {
        state.broken = true;   // BuDDy counts variables that have no nodes yet
        bdd::throw_exhausted(reason);
    }
    ::bdd_extvarnum(static_cast<int>(count));
    bdd::end_operation();
    return static_cast<std::uint32_t>(first);
}

std::size_t BddSpace::variables() const { return static_cast<std::size_t>(::bdd_varnum()); }

Bdd BddSpace::variable(std::uint32_t index) const {
    assert(index < variables());
    return cube(std::vector<BddLiteral>{{index, true}});
}

std::uint64_t BddSpace::nodes() const { return static_cast<std::uint64_t>(::bdd_getnodenum()); }

std::uint64_t BddSpace::bytes() const {
    return static_cast<std::uint64_t>(::bdd_getallocnum()) * bytes_per_node;
}

Bdd::Bdd(const Bdd& other) : node_(::bdd_addref(other.node_)) {}

Bdd& Bdd::operator=(const Bdd& other) {
    ::bdd_addref(other.node_);
    ::bdd_delref(node_);
    node_ = other.node_;
    return *this;
}

Bdd::~Bdd() { ::bdd_delref(node_); }

Bdd Bdd::of_node(int node) {
    Bdd handle;
    handle.node_ = ::bdd_addref(node);
    return handle;
}

Bdd Bdd::constant(bool value) { return of_node(value ? 1 : 0); }

std::uint32_t Bdd::top() const {
    assert(!is_constant());
    return static_cast<std::uint32_t>(::bdd_var(node_));
}

Bdd Bdd::low() const {
    assert(!is_constant());
    return of_node(::bdd_low(node_));
}

Bdd Bdd::high() const {
    assert(!is_constant());
    return of_node(::bdd_high(node_));
}

}  // namespace grafverif
