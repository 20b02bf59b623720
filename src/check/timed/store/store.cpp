// SPDX-License-Identifier: MIT
#include "check/timed/store/store.hpp"

#include <algorithm>
#include <utility>

namespace grafverif::timed {

namespace {

constexpr unsigned shard_bits = 6;  // the root table has 2^shard_bits shards

}  // namespace

Store::Store(const Layout& layout)
    : words_(static_cast<std::uint32_t>(layout.words)),
      stored_(static_cast<std::uint32_t>(layout.stored)),
      halves_(static_cast<std::uint32_t>(layout.halves)),
      root_(shard_bits) {
    grow(layout.seams, 0, std::max(halves_, 2U));
    for (std::size_t i = 0; i + 1 < nodes_.size(); ++i) tables_.emplace_back(0);
}

/// Builds the subtree of the 32-bit halves [first, end) of a state. Returns the index of the root of the subtree in
/// Unfolded::numbers. The range is split at the subsystem boundary that is nearest to its middle, or in the middle if
/// the range contains no boundary. Each subsystem gets a separate subtree, because the numbers of states of subsystems
/// that share only time multiply.
std::uint32_t Store::grow(const std::vector<std::size_t>& seams, std::uint32_t first, std::uint32_t end) {
    if (end - first == 1) return first;
    const std::uint32_t middle = (first + end + 1) / 2;
    std::uint32_t fork = middle;
    std::uint32_t far = end;
    for (const std::size_t seam : seams) {
        const auto at = static_cast<std::uint32_t>(seam);
        const std::uint32_t distance = at < middle ? middle - at : at - middle;
        if (at <= first || at >= end || distance >= far) continue;
        fork = at;
        far = distance;
    }
    const std::uint32_t low = grow(seams, first, fork);
    const std::uint32_t high = grow(seams, fork, end);
    nodes_.push_back({low, high});
    return 2 * stored_ + static_cast<std::uint32_t>(nodes_.size()) - 1;
}

void Store::take(const Word* words, Unfolded& now) const {
    now.numbers.resize(2 * stored_ + nodes_.size());
    for (std::uint32_t word = 0; word < stored_; ++word) {
        now.numbers[2 * word] = Pairs::low(words[word]);
        now.numbers[2 * word + 1] = Pairs::high(words[word]);
    }
}

/// Assigns numbers to the inner nodes of a state except the root, children before parents, and returns the root pair.
/// The function `number(node, pair)` determines the number of a node. If a node has the same children as in `before`,
/// its number is copied from `before`. The result is nullopt if `number` returns `none` for some pair.
template <class Number>
std::optional<Word> Store::numbered(const Word* words, const Unfolded& before, Unfolded& now, Number number) const {
    take(words, now);
    std::uint32_t* const numbers = now.numbers.data();
    const std::uint32_t* const same = before.numbers.data();
    for (std::size_t i = 0; i < tables_.size(); ++i) {
        const auto [low, high] = nodes_[i];
        const bool known = !before.numbers.empty() && numbers[low] == same[low] && numbers[high] == same[high];
        const std::size_t at = 2 * stored_ + i;
        numbers[at] = known ? same[at] : number(i, Pairs::pair(numbers[low], numbers[high]));
        if (numbers[at] == none) return {};
    }
    return Pairs::pair(numbers[nodes_.back().low], numbers[nodes_.back().high]);
}

Word Store::fold(const Word* words, const Unfolded& before, Unfolded& now) {
    return *numbered(words, before, now, [this](std::size_t i, Word pair) { return tables_[i].intern(pair).number; });
}

std::optional<Word> Store::root_of(const Word* words, const Unfolded& before, Unfolded& now) const {
    return numbered(words, before, now, [this](std::size_t i, Word pair) { return tables_[i].find(pair); });
}

void Store::unfold(std::size_t node, Word pair, std::uint32_t* numbers) const {
    const auto put = [&](std::uint32_t at, std::uint32_t number) {
        if (std::exchange(numbers[at], number) == number || at < 2 * stored_) return;
        unfold(at - 2 * stored_, tables_[at - 2 * stored_][number], numbers);
    };
    put(nodes_[node].low, Pairs::low(pair));
    put(nodes_[node].high, Pairs::high(pair));
}

void Store::load(std::uint32_t state, Unfolded& unfolded) const {
    unfolded.words.resize(words_);
    if (unfolded.numbers.empty()) {
        unfolded.numbers.resize(2 * stored_, 0);
        unfolded.numbers.resize(2 * stored_ + nodes_.size(), none);
    }
    const std::uint32_t* const numbers = unfolded.numbers.data();
    unfold(tables_.size(), root_[state], unfolded.numbers.data());
    for (std::uint32_t word = 0; word < stored_; ++word)
        unfolded.words[word] = Pairs::pair(numbers[2 * word], numbers[2 * word + 1]);
}

std::size_t Store::bytes() const {
    std::size_t bytes = root_.bytes();
    for (const Pairs& table : tables_) bytes += table.bytes();
    return bytes;
}

}  // namespace grafverif::timed
