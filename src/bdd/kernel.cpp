// SPDX-License-Identifier: MIT
// Allocates nodes. A small table that is full is doubled, because a garbage collection would only delay the growth. In
// a larger table, garbage is collected first, and the table is doubled if fewer than half of its nodes are free. If the
// table cannot grow and the collection frees less than a sixteenth of the nodes, the operation
// fails with an error; otherwise, it would repeat collections with little progress.
#include "bdd/kernel.hpp"

#include <algorithm>
#include <bit>

namespace grafverif::bdd {

namespace {

constexpr std::uint32_t first_capacity = 1U << 12U, never_collected_below = 1U << 15U;
constexpr std::uint32_t marks_per_word = 64;

[[noreturn]] void out_of_memory() { throw BddExhausted(BddExhausted::Cause::Memory); }

/// Enlarges the blocks so that they can store `capacity` nodes. Initializes the new entries of those blocks whose
/// entries need an initial value. Returns false if the memory is not available.
bool has_blocks(Kernel& kernel, std::uint32_t capacity) {
    NodeTable& table = kernel.table;
    const auto at_least = [](auto& block, std::size_t size) { return block.size() >= size || block.resize(size); };
    const std::size_t words = (capacity + marks_per_word - 1) / marks_per_word;
    if (!at_least(table.nodes, capacity) || !at_least(table.refs, capacity) || !at_least(table.marks, words))
        return false;
    for (std::size_t n = table.capacity; n < capacity; ++n) {
        kernel.watch.step();
        table.refs[n] = 0;
    }
    for (std::size_t word = (table.capacity + marks_per_word - 1) / marks_per_word; word < words; ++word)
        table.marks[word] = 0;
    return true;
}

/// Grows the bucket table to the number of nodes if memory allows.
void add_buckets(Kernel& kernel) {
    NodeTable& table = kernel.table;
    const std::size_t wanted = std::bit_floor(table.capacity);
    if (wanted <= table.buckets.size() || !table.buckets.resize(wanted)) return;
    table.shift = static_cast<unsigned>(64 - std::countr_zero(wanted));
    table.stale = true;
}

}  // namespace

void Frames::enlarge() {
    if (!frames_.resize(std::max<std::size_t>(256, 2 * frames_.size()))) out_of_memory();
}

bool Order::add(std::uint32_t count) {
    const std::size_t wanted = std::size_t{size_} + count;
    if (wanted >= constant_level) return false;
    if (wanted > level_of.size()) {
        const std::size_t new_size = std::max(wanted, 2 * level_of.size());
        if (!level_of.resize(new_size) || !variable_at.resize(new_size) || !group_of.resize(new_size)) return false;
    }
    for (; size_ < wanted; ++size_) level_of[size_] = variable_at[size_] = group_of[size_] = size_;
    ++version;
    return true;
}

bool grow(Kernel& kernel) {
    NodeTable& table = kernel.table;
    const std::uint64_t now = table.capacity, least = now + now / 16 + 1;
    for (std::uint64_t wanted = std::clamp<std::uint64_t>(2 * now, first_capacity, most_nodes); wanted >= least;
         wanted = now + (wanted - now) / 2) {
        if (!has_blocks(kernel, static_cast<std::uint32_t>(wanted))) continue;
        table.capacity = static_cast<std::uint32_t>(wanted);
        break;
    }
    if (table.capacity == now) return false;
    if (table.used == 0) {
        table.nodes[0] = {constant_level, false_edge, false_edge, 0};
        table.used = 1;
    }
    add_buckets(kernel);
    if (table.buckets.size() == 0) return false;
    if (table.stale) relink(kernel);
    // The size is limited, because a larger cache would have only slightly more hits, and would not fit into the
    // processor cache.
    while (kernel.cache.size() < table.capacity / 2 && kernel.cache.grow(kernel.watch)) {
    }
    return kernel.cache.size() != 0;
}

void free_memory(Kernel& kernel, Edge low, Edge high) {
    NodeTable& table = kernel.table;
    const bool small = table.capacity < never_collected_below;
    if (small && grow(kernel)) return;
    if (table.buckets.size() == 0 || kernel.cache.size() == 0) out_of_memory();
    collect(kernel, {low, high});
    if (table.free_nodes() >= table.capacity / 2) return;
    if (!small && grow(kernel)) return;
    if (table.free_nodes() < table.capacity / 16 + 1) out_of_memory();
}

Session::Session(Kernel& kernel) : kernel_(kernel) {
    kernel.watch.step(16);
    if (kernel.table.buckets.size() == 0 || kernel.cache.size() == 0)
        if (!grow(kernel)) out_of_memory();
    if (kernel.table.stale) relink(kernel);
    if (kernel.reorder_above != 0 && kernel.table.in_use > kernel.reorder_above) {
        reorder(kernel);
        kernel.reorder_above = std::max<std::uint64_t>(kernel.reorder_above, 2 * std::uint64_t{kernel.table.in_use});
    }
}

}  // namespace grafverif::bdd
