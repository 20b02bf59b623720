// SPDX-License-Identifier: MIT
// Computes batches of successors. The lookup of a state costs one or two cache misses. Therefore the successors of a
// slice are looked up in three passes. First, the root pair of each successor (see Store) is computed, and its slot in
// the index is prefetched. Then the pairs to which these slots refer are prefetched. Finally, the successors are looked
// up.
#include "check/timed/successor_batch.hpp"

#include <algorithm>
#include <bit>

namespace grafverif::timed {

namespace {

constexpr std::size_t slice_text = 1U << 17U;  // a slice ends when its successors have this number of words
constexpr std::size_t fetched_ahead = 16;      // the slot of the entry that is this number of entries ahead is
                                               // prefetched

}  // namespace

std::size_t SuccessorBatch::bytes() const {
    return states.capacity() * sizeof(State) + targets.capacity() * sizeof(std::uint32_t) +
           new_states.capacity() * sizeof(NewState) + words.capacity() * sizeof(Word) + links.bytes.capacity() +
           (kept.capacity() + links.begins.capacity()) * sizeof(std::uint32_t);
}

std::size_t Slicer::fill(SuccessorBatch& slice, std::uint32_t begin, std::uint32_t end) {
    slice_ = &slice;
    slice.states.clear();
    slice.targets.clear();
    slice.new_states.clear();
    slice.kept.clear();
    slice.words.clear();
    slice.links.bytes.clear();
    slice.links.begins.clear();
    words_.clear();
    slice.stuck_bound.reset();
    slice.locked_bound.reset();
    slice.faults.clear();
    slice.cut = false;
    slice.begin = slice.end = begin;
    while (slice.end != end && words_.size() < slice_text) look_at(slice.end++);
    const std::size_t computed = words_.size();
    look_up();
    if (graph_.linked) {
        slice.links.bytes.reserve(Links::Chunk::most * slice.targets.size());
        slice.links.begins.reserve(slice.states.size());
    }
    if (words_.size() > 2 * slice_text) words_ = {};
    return computed;
}

void Slicer::look_at(std::uint32_t state) {
    SuccessorBatch& slice = *slice_;
    graph_.store.load(state, now_);
    SuccessorBatch::State& at = slice.states.emplace_back();
    at.first = static_cast<std::uint32_t>(slice.targets.size());
    at.race = std::ranges::any_of(races_, [&](const Field& race) { return race.raw(now_.words.data()) != 0; });
    if (at.race) return;
    const Machine& machine = graph_.machine;
    at.computed = static_cast<std::uint32_t>(graph_.expand(now_.words.data(), moves_, buffers_));
    at.edges = static_cast<std::uint32_t>(moves_.edges.size());
    at.urgent = moves_.urgent;
    at.fault = moves_.fault.has_value();
    slice.cut = slice.cut || moves_.cut;
    for (std::size_t i = 0; i < moves_.edges.size(); ++i)
        add(moves_.words.data() + i * machine.layout().words,
            machine.urgent(moves_.edges[i]) ? SuccessorBatch::urgent : 0);
    if (moves_.stuck_bound && !slice.stuck_bound) slice.stuck_bound = UncoveredAt{state, *moves_.stuck_bound};
    if (moves_.locked_bound && !slice.locked_bound) slice.locked_bound = UncoveredAt{state, *moves_.locked_bound};
    if (moves_.fault) slice.faults.push_back({state, *moves_.fault});
    if (moves_.words.size() > slice_text) moves_.words = {};
    if (at.urgent || graph_.kind(state) != StateKind::Unknown) return;
    later_ = now_.words;
    at.timed = true;
    at.passes = machine.delay(later_.data());
    if (at.passes) add(later_.data(), 0);
}

void Slicer::add(const Word* words, std::uint32_t flags) {
    SuccessorBatch& slice = *slice_;
    const std::optional<Word> root = graph_.store.root_of(words, now_, next_);
    if (root) graph_.store.roots().prefetch(*root);
    slice.new_states.push_back({.root = root.value_or(0), .folded = root.has_value()});
    slice.targets.push_back(flags);
    words_.insert(words_.end(), words, words + graph_.machine.layout().words);
}

/// Removes from `new_states` the successors that the store already contains, and sets all targets.
void Slicer::look_up() {
    SuccessorBatch& slice = *slice_;
    const Pairs& roots = graph_.store.roots();
    for (const SuccessorBatch::NewState& new_state : slice.new_states)
        if (new_state.folded) roots.prefetch_met(new_state.root);
    const std::size_t words = graph_.machine.layout().words;
    std::uint32_t kept = 0;
    for (std::size_t i = 0; i < slice.targets.size(); ++i) {
        SuccessorBatch::NewState new_state = slice.new_states[i];
        const std::uint32_t known = new_state.folded ? roots.find(new_state.root) : Store::none;
        slice.targets[i] |= known != Store::none ? known : SuccessorBatch::new_state | kept;
        if (known != Store::none) continue;
        const Word* const at = words_.data() + i * words;
        new_state.needed = monitor_.needs(graph_.machine, at, moves_.registers);
        if (new_state.folded) new_state.shard = roots.shard_of(new_state.root);
        if (new_state.needed || !new_state.folded || graph_.covering) {
            slice.kept.push_back(kept);
            slice.words.insert(slice.words.end(), at, at + words);
        }
        slice.new_states[kept++] = new_state;
    }
    slice.new_states.resize(kept);
}

void NewStates::begin(unsigned parts, std::size_t new_states) {
    parts_.resize(parts);
    for (Shard& part : parts_) {
        part.entries.clear();
        const std::size_t slots = std::bit_ceil(2 * new_states / parts + 16);
        if (part.slots.size() < slots || part.slots.size() > 8 * slots) part.slots.resize(slots);
        std::ranges::fill(part.slots, 0);
    }
}

NewStates::Lookup NewStates::meet(unsigned index, Word root) {
    const std::uint64_t hash = Pairs::hash(root);
    Shard& part = parts_[index];
    if (2 * (part.entries.size() + 1) > part.slots.size()) widen(part, 2 * part.slots.size());
    std::size_t place = hash >> 24U & (part.slots.size() - 1);
    while (part.slots[place] != 0 && part.entries[part.slots[place] - 1].root != root)
        place = (place + 1) & (part.slots.size() - 1);
    const bool fresh = part.slots[place] == 0;
    if (fresh) {
        part.entries.push_back({root});
        part.slots[place] = static_cast<std::uint32_t>(part.entries.size());
    }
    return {(part.slots[place] - 1) * parts() + index, fresh};
}

void NewStates::index(unsigned part, Pairs& roots) const {
    const std::vector<Entry>& entries = parts_[part].entries;
    for (std::size_t i = 0; i < entries.size(); ++i) {
        if (i + fetched_ahead < entries.size()) roots.prefetch(entries[i + fetched_ahead].root);
        if (entries[i].number != Store::none) roots.index(entries[i].root, entries[i].number);
    }
}

void NewStates::widen(Shard& part, std::size_t slots) {
    part.slots.assign(slots, 0);
    for (std::uint32_t entry = 0; entry < part.entries.size(); ++entry) {
        std::size_t place = Pairs::hash(part.entries[entry].root) >> 24U & (slots - 1);
        while (part.slots[place] != 0) place = (place + 1) & (slots - 1);
        part.slots[place] = entry + 1;
    }
}

std::size_t NewStates::bytes() const {
    std::size_t bytes = 0;
    for (const Shard& part : parts_)
        bytes += part.slots.capacity() * sizeof(std::uint32_t) + part.entries.capacity() * sizeof(Entry);
    return bytes;
}

}  // namespace grafverif::timed
