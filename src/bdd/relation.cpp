// SPDX-License-Identifier: MIT
#include "bdd/relation.hpp"

#include <algorithm>
#include <iterator>
#include <map>
#include <unordered_map>
#include <unordered_set>
#include <utility>

namespace grafverif::bdd {

namespace {

/// Maximum size of a conjunction of parts, in nodes. Larger conjunctions cost more time than they save.
constexpr std::size_t part_size = 600;
/// Maximum number of parts for which an order is computed. More parts remain in the order of their bits, because the
/// time of the computation is quadratic in their number.
constexpr std::size_t most_arranged = 2000;

std::vector<NextBit> sorted(std::vector<NextBit> bits) {
    std::ranges::sort(bits, {}, &NextBit::before);
    return bits;
}

std::vector<std::pair<std::uint32_t, std::uint32_t>> pairs(const std::vector<NextBit>& bits, bool to_before) {
    std::vector<std::pair<std::uint32_t, std::uint32_t>> all;
    for (const NextBit& bit : bits)
        all.emplace_back(to_before ? bit.after() : bit.before, to_before ? bit.before : bit.after());
    return all;
}

}  // namespace

Relation::Relation(const BddSpace& space, std::vector<NextBit> bits, std::vector<Bdd> conditions,
                   std::vector<std::uint32_t> choices)
    : space_(space),
      bits_(sorted(std::move(bits))),
      choices_(std::move(choices)),
      to_before_(pairs(bits_, true)),
      to_after_(pairs(bits_, false)) {
    for (const Bdd& condition : conditions)
        if (!condition.is_true()) parts_.push_back(part(condition));
    for (const NextBit& bit : bits_) parts_.push_back(part(iff(space.variable(bit.after()), bit.value)));
    free_of_choices();
    arrange();
    join();
    arrange();
    end_after();
}

/// For each choice: conjoins all parts that read the choice and quantifies the choice, if the results have at most
/// `part_size` nodes.
void Relation::free_of_choices() {
    std::vector<std::uint32_t> left;
    for (const std::uint32_t choice : choices_) {
        const auto reads = [choice](const Conjunct& part) { return std::ranges::binary_search(part.reads, choice); };
        Bdd joined = Bdd::constant(true);
        for (const Conjunct& each : parts_)
            if (reads(each) && size(joined &= each.relation) > part_size) break;
        const Bdd freed = size(joined) > part_size ? joined : exists(joined, space_.variable(choice));
        if (size(joined) > part_size || size(freed) > part_size) {
            left.push_back(choice);
            continue;
        }
        std::erase_if(parts_, reads);
        if (!freed.is_true()) parts_.push_back(part(freed));
    }
    choices_ = std::move(left);
}

/// Orders the parts greedily. Prefers parts with many variables that no later part reads, because these variables can
/// be quantified immediately, and parts with few variables after a step.
void Relation::arrange() {
    if (parts_.size() > most_arranged) return;
    std::unordered_set<std::uint32_t> after;
    for (const NextBit& bit : bits_) after.insert(bit.after());
    std::unordered_map<std::uint32_t, std::size_t> readers;
    for (const Conjunct& each : parts_)
        for (const std::uint32_t variable : each.reads) ++readers[variable];
    const auto worth = [&](const Conjunct& each) {
        double ends = 0, begins = 0, read = 0;
        for (const std::uint32_t variable : each.reads) {
            if (after.contains(variable)) {
                ++begins;
                continue;
            }
            ++read;
            if (readers[variable] == 1) ++ends;
        }
        return 2 * ends / std::max(read, 1.0) + (ends - begins) / 8;
    };
    std::vector<Conjunct> arranged;
    while (!parts_.empty()) {
        const auto best = std::ranges::max_element(parts_, {}, worth);
        for (const std::uint32_t variable : best->reads) --readers[variable];
        arranged.push_back(std::move(*best));
        parts_.erase(best);
    }
    parts_ = std::move(arranged);
}

/// Conjoins adjacent parts while the result has at most `part_size` nodes.
void Relation::join() {
    std::vector<Conjunct> joined;
    for (Conjunct& each : parts_) {
        const Bdd both = joined.empty() ? Bdd{} : joined.back().relation & each.relation;
        if (joined.empty() || size(both) > part_size) joined.push_back(std::move(each));
        else joined.back() = part(both);
    }
    parts_ = std::move(joined);
}

/// Assigns each variable after a step, and each choice, to the first part that reads it, because preimages process the
/// parts from last to first.
void Relation::end_after() {
    std::vector<std::uint32_t> remaining = choices_;
    for (const NextBit& bit : bits_) remaining.push_back(bit.after());
    std::ranges::sort(remaining);
    for (Conjunct& each : parts_) {
        std::vector<std::uint32_t> here, rest;
        std::ranges::set_intersection(remaining, each.reads, std::back_inserter(here));
        std::ranges::set_difference(remaining, each.reads, std::back_inserter(rest));
        each.after = variable_set(space_, here);
        remaining = std::move(rest);
    }
    unread_after_ = variable_set(space_, remaining);
}

Relation::Quantified Relation::quantified(std::span<const std::uint32_t> variables) const {
    std::map<std::uint32_t, std::size_t> last;  // for each variable: the last part that reads the variable
    for (std::size_t part = 0; part < parts_.size(); ++part)
        for (const std::uint32_t variable : parts_[part].reads) last[variable] = part;
    std::vector<std::uint32_t> unread;
    std::vector<std::vector<std::uint32_t>> ended(parts_.size());
    const auto end = [&](std::uint32_t variable) {
        const auto found = last.find(variable);
        (found == last.end() ? unread : ended[found->second]).push_back(variable);
    };
    std::ranges::for_each(variables, end);
    std::ranges::for_each(choices_, end);
    Quantified result{variable_set(space_, unread), {}};
    for (const std::vector<std::uint32_t>& some : ended) result.ended.push_back(variable_set(space_, some));
    return result;
}

Bdd Relation::image(const Bdd& from, const Quantified& variables) const {
    Bdd result = exists(from, variables.unread);
    for (std::size_t part = 0; part < parts_.size(); ++part)
        result = and_exists(result, parts_[part].relation, variables.ended[part]);
    return to_before_(result);
}

Bdd Relation::preimage(const Bdd& to) const {
    Bdd result = exists(to_after_(to), unread_after_);
    for (std::size_t part = parts_.size(); part-- > 0;)
        result = and_exists(result, parts_[part].relation, parts_[part].after);
    return result;
}

std::vector<std::uint32_t> Relation::variables() const {
    std::vector<std::uint32_t> all;
    for (const Conjunct& each : parts_) all.insert(all.end(), each.reads.begin(), each.reads.end());
    for (const NextBit& bit : bits_) all.push_back(bit.before);
    std::ranges::sort(all);
    all.erase(std::ranges::unique(all).begin(), all.end());
    return all;
}

}  // namespace grafverif::bdd
