// SPDX-License-Identifier: MIT
// Garbage collection: marks the nodes that are reachable from handles, frames and the edges in `spared`, removes cache
// entries of unmarked nodes, and frees unmarked nodes. The nodes to mark are linked in a list by their members `next`,
// so that marking needs neither a stack nor additional memory. The sweep rebuilds the hash chains.
//
// A collection can be interrupted at any time. Before the sweep, an interruption has no effect, because garbage nodes
// are valid nodes. If the sweep is interrupted, the marks are kept, and the next operation completes the sweep.
#include <algorithm>

#include "bdd/kernel.hpp"

namespace grafverif::bdd {

namespace {

void mark_from_roots(Kernel& kernel, std::initializer_list<Edge> spared) {
    NodeTable& table = kernel.table;
    std::uint32_t open = 0;
    const auto meet = [&](Edge edge) {
        const std::uint32_t n = index_of(edge);
        if (n == 0 || table.marked(n)) return;
        table.mark(n);
        table.nodes[n].next = open;
        open = n;
    };
    const auto mark_open = [&] {
        while (open != 0) {
            kernel.watch.step();
            const Node& node = table.nodes[open];
            open = node.next;
            meet(node.low);
            meet(node.high);
        }
    };
    for (const Edge edge : spared) meet(edge);
    for (std::size_t i = 0; i < kernel.frames.size(); ++i)
        for (const Frame& frame = kernel.frames[i]; const Edge edge : {frame.f, frame.g, frame.h, frame.low})
            meet(edge);
    mark_open();
    for (std::uint32_t n = 1; n < table.used; ++n) {
        kernel.watch.step();
        if (table.refs[n] == 0) continue;
        meet(n << 1U);
        mark_open();
    }
}

void unmark_all(NodeTable& table) { std::fill_n(table.marks.data(), (std::size_t{table.used} + 63) / 64, 0); }

}  // namespace

void relink(Kernel& kernel) {
    NodeTable& table = kernel.table;
    table.stale = true;
    for (std::size_t bucket = 0; bucket < table.buckets.size(); ++bucket) {
        kernel.watch.step();
        table.buckets[bucket] = 0;
    }
    table.free = 0;
    std::uint32_t in_use = 1;  // the constant is always in use

    // The loop is descending, so that free nodes with small indices are reused first.
    for (std::uint32_t n = table.used; n-- > 1;) {
        kernel.watch.step();
        Node& node = table.nodes[n];
        if (node.level == free_level || (table.sweeping && !table.marked(n))) {
            node = {free_level, 0, 0, table.free};
            table.free = n;
        } else {
            table.link(n);
            ++in_use;
        }
    }
    table.in_use = in_use;
    table.stale = false;
    if (table.sweeping) unmark_all(table);
    table.sweeping = false;
}

void collect(Kernel& kernel, std::initializer_list<Edge> spared) {
    kernel.table.stale = true;
    try {
        mark_from_roots(kernel, spared);
        kernel.cache.keep_marked(kernel.table, kernel.watch);
    } catch (...) {
        unmark_all(kernel.table);
        throw;
    }
    kernel.table.sweeping = true;
    relink(kernel);
}

}  // namespace grafverif::bdd
