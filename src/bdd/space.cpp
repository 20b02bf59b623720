// SPDX-License-Identifier: MIT
// Implements BddSpace and the handles Bdd.
#include <algorithm>
#include <cassert>

#include "bdd/kernel.hpp"

namespace grafverif {

const char* BddExhausted::what() const noexcept {
    return cause_ == Cause::Memory ? "memory limit of decision diagrams reached" : "stopped";
}

BddSpace::BddSpace(const BddLimits& limits) : kernel_(std::make_unique<bdd::Kernel>(limits)) {}

BddSpace::~BddSpace() { assert(kernel_->handles == 0); }

std::uint32_t BddSpace::add_variables(std::size_t count) {
    const std::uint32_t first = kernel_->order.size();
    if (count >= bdd::constant_level || !kernel_->order.add(static_cast<std::uint32_t>(count)))
        throw BddExhausted(BddExhausted::Cause::Memory);
    return first;
}

std::size_t BddSpace::variables() const { return kernel_->order.size(); }

Bdd BddSpace::variable(std::uint32_t index) const {
    assert(index < variables());
    const bdd::Session session(*kernel_);
    return {*kernel_, bdd::make(*kernel_, kernel_->order.level_of[index], bdd::false_edge, bdd::true_edge)};
}

std::uint64_t BddSpace::nodes() const { return kernel_->table.in_use; }
std::uint64_t BddSpace::bytes() const { return kernel_->budget.used; }
std::uint64_t BddSpace::work() const { return kernel_->watch.work(); }

void BddSpace::collect_garbage() {
    const bdd::Session session(*kernel_);
    bdd::collect(*kernel_, {});
}

std::vector<std::uint32_t> BddSpace::order() const {
    std::vector<std::uint32_t> variables;
    for (std::uint32_t level = 0; level < kernel_->order.size(); ++level)
        variables.push_back(kernel_->order.variable_at[level]);
    return variables;
}

void BddSpace::keep_together(std::uint32_t first, std::size_t count) {
    assert(first + count <= variables());
    for (std::uint32_t i = 0; i < count; ++i) kernel_->order.group_of[first + i] = first;
}

void BddSpace::reorder() {
    const bdd::Session session(*kernel_);
    bdd::reorder(*kernel_);
}

void BddSpace::reorder_above(std::uint64_t nodes) { kernel_->reorder_above = nodes; }

Bdd::Bdd(bdd::Kernel& kernel, std::uint32_t edge) : kernel_(bdd::is_constant(edge) ? nullptr : &kernel), edge_(edge) {
    hold();
}

void Bdd::hold() const {
    if (kernel_ == nullptr) return;
    ++kernel_->table.refs[bdd::index_of(edge_)];
    ++kernel_->handles;
}

void Bdd::release() const {
    if (kernel_ == nullptr) return;
    --kernel_->table.refs[bdd::index_of(edge_)];
    --kernel_->handles;
}

std::uint32_t Bdd::top() const {
    assert(!is_constant());
    return kernel_->order.variable_at[kernel_->level(edge_)];
}

Bdd Bdd::low() const {
    assert(!is_constant());
    return {*kernel_, kernel_->low(edge_)};
}

Bdd Bdd::high() const {
    assert(!is_constant());
    return {*kernel_, kernel_->high(edge_)};
}

}  // namespace grafverif
