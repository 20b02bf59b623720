// SPDX-License-Identifier: MIT
#include "check/pdr/solver.hpp"

#include <malloc.h>

#include <algorithm>
#include <array>
#include <new>

#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__)
// Sanitizers replace the memory allocator. Therefore a function of the sanitizer measures the allocated memory.
#define SANITIZED
extern "C" std::size_t __sanitizer_get_current_allocated_bytes();  // NOLINT: the sanitizer defines this name
#endif

namespace grafverif::pdr {

namespace {

std::uint64_t allocated() {
#ifdef SANITIZED
    return __sanitizer_get_current_allocated_bytes();
#else
    const struct mallinfo2 info = ::mallinfo2();
    return info.uordblks + info.hblkhd;
#endif
}

}  // namespace

LimitMonitor::LimitMonitor(const SolverLimits& bounds)
    : bounds_(bounds), share_(bounds.deadline), before_(allocated()) {}

void LimitMonitor::share(std::size_t parts) {
    met_.reset();
    calls_ = 0;
    share_ = bounds_.deadline;  // discards the time limit of earlier work
    if (!bounds_.deadline || parts == 0) return;
    const auto now = std::chrono::steady_clock::now();
    if (now < *bounds_.deadline) share_ = now + (*bounds_.deadline - now) / static_cast<std::int64_t>(parts);
}

void LimitMonitor::limit(std::chrono::steady_clock::duration time) {
    met_.reset();
    calls_ = 0;
    share_ = std::chrono::steady_clock::now() + time;
    if (bounds_.deadline) share_ = std::min(*share_, *bounds_.deadline);
}

bool LimitMonitor::over() const {
    return (bounds_.stop != nullptr && bounds_.stop->load()) ||
           (bounds_.deadline && std::chrono::steady_clock::now() >= *bounds_.deadline);
}

std::uint64_t LimitMonitor::bytes() const {
    const std::uint64_t now = allocated();
    return now > before_ ? now - before_ : 0;
}

bool LimitMonitor::terminate() {
    if (met_) return true;
    for (const std::atomic<bool>* each : {bounds_.stop, decided_elsewhere_})
        if (each != nullptr && each->load(std::memory_order_relaxed)) met_ = Exhausted::Cause::Stopped;
    constexpr std::uint32_t seldom = 64;  // number of calls between two tests of time and memory
    if (calls_++ % seldom != 0 || met_) return met_.has_value();
    const auto now = std::chrono::steady_clock::now();
    if (share_ && now >= *share_) met_ = Exhausted::Cause::Stopped;
    if (now < weighed_ + std::chrono::milliseconds(20)) return met_.has_value();
    weighed_ = now;
    if (bytes() > bounds_.memory) met_ = Exhausted::Cause::Memory;
    return met_.has_value();
}

void LimitMonitor::look() {
    if (terminate()) throw Exhausted{*met_};
}

SatSolver::SatSolver(LimitMonitor& watch) : watch_(watch), solver_(std::make_unique<CaDiCaL::Solver>()) {
    solver_->set("quiet", 1);
    solver_->set("profile", 0);  // disables profiling, which would query the clock in every call of CaDiCaL
    solver_->connect_terminator(&watch);
}

SatSolver::~SatSolver() {
    if (broken_) static_cast<void>(solver_.release());
    else solver_->disconnect_terminator();
}

template <class Work>
auto SatSolver::guarded(const Work& work) const {
    if (broken_) throw std::bad_alloc();
    try {
        return work();
    } catch (...) {
        broken_ = true;
        throw;
    }
}

void SatSolver::expect_small_queries() {
    guarded([this] { solver_->configure("plain"); });
}

void SatSolver::write_proof(FILE* file) {
    guarded([&] {
        solver_->set("binary", 0);
        solver_->trace_proof(file, "proof");
    });
}

void SatSolver::end_proof() {
    guarded([this] { solver_->close_proof_trace(); });
}

void SatSolver::add(std::span<const int> clause) {
    guarded([&] {
        for (const int each : clause) solver_->add(each);
        solver_->add(0);
    });
}

bool SatSolver::solve(std::span<const int> assumptions, std::span<const int> one_of) {
    watch_.look();
    const int answer = guarded([&] {
        for (const int each : assumptions) solver_->assume(each);
        for (const int each : one_of) solver_->constrain(each);
        if (!one_of.empty()) solver_->constrain(0);
        return solver_->solve();
    });
    if (answer == 0) {
        watch_.look();
        throw Exhausted{Exhausted::Cause::Stopped};
    }
    return answer == 10;
}

bool SatSolver::is_true(int literal) const {
    return guarded([&] { return solver_->val(literal) > 0; });
}

bool SatSolver::failed(int assumption) {
    return guarded([&] { return solver_->failed(assumption); });
}

Solver::Solver(const Circuit& circuit, LimitMonitor& watch)
    : circuit_(circuit), solver_(watch), variable_(circuit.gates.size()), is_latch_(circuit.gates.size()) {
    solver_.expect_small_queries();
    for (const Circuit::Latch& latch : circuit.latches) is_latch_[latch.node] = true;
    variable_[0] = fresh();
    add(std::array{-variable_[0]});
}

int Solver::variable(std::uint32_t node) {
    const int made = variable_[node] = fresh();
    if (is_latch_[node]) {
        latches_.push_back(made);
        if (initial_ != 0) add(std::array{-initial_, -made});
    }
    return made;
}

int Solver::literal(Literal literal) const {
    const int known = variable_[node_of(literal)];
    return is_inverted(literal) ? -known : known;
}

int Solver::of(Literal wanted) {
    variable_.resize(circuit_.gates.size());
    is_latch_.resize(circuit_.gates.size());
    std::vector<std::uint32_t> open;  // gates that already have a variable but no clauses
    const auto name = [&](std::uint32_t node) {
        if (variable_[node] != 0) return;
        variable(node);
        if (circuit_.gates.is_gate(node)) open.push_back(node);
    };
    name(node_of(wanted));
    while (!open.empty()) {
        const std::uint32_t node = open.back();
        open.pop_back();
        const Gates::Node gate = circuit_.gates[node];
        name(node_of(gate.left));
        name(node_of(gate.right));
        const int out = variable_[node], left = literal(gate.left), right = literal(gate.right);
        add(std::array{-out, left});
        add(std::array{-out, right});
        add(std::array{out, -left, -right});
    }
    return literal(wanted);
}

void Solver::all_false_under(int condition) {
    initial_ = condition;
    for (const int latch : latches_) add(std::array{-condition, -latch});
}

void Solver::add(std::span<const int> clause) {
    solver_.add(clause);
    ++clauses_;
}

bool Solver::value(Literal literal) const {
    return solver_.is_true(variable_[node_of(literal)]) != is_inverted(literal);
}

}  // namespace grafverif::pdr
