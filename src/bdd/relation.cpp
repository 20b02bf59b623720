// SPDX-License-Identifier: MIT
#include "bdd/relation.hpp"

#include <algorithm>
#include <map>
#include <utility>

namespace grafverif::bdd {

namespace {

/// Parts are joined up to this size: larger ones cost more to build than they save in use.
constexpr std::size_t part_size = 600;

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

Relation::Relation(const BddSpace& space, std::vector<NextBit> bits, const Bdd& offered)
    : space_(space), bits_(sorted(std::move(bits))), to_before_(pairs(bits_, true)), to_after_(pairs(bits_, false)) {
    std::vector<std::vector<std::uint32_t>> after;
    if (!offered.is_true()) {
        parts_.push_back({offered});
        after.emplace_back();
    }
    for (const NextBit& bit : bits_) {
        const Bdd one = iff(space.variable(bit.after()), bit.value);
        const Bdd joined = parts_.empty() ? one : parts_.back().relation & one;
        if (parts_.empty() || size(joined) > part_size) {
            parts_.push_back({one});
            after.emplace_back();
        } else {
            parts_.back().relation = joined;
        }
        after.back().push_back(bit.after());
    }
    for (std::size_t part = 0; part < parts_.size(); ++part) parts_[part].after = variable_set(space, after[part]);
}

Relation::Quantified Relation::quantified(std::span<const std::uint32_t> variables) const {
    std::map<std::uint32_t, std::size_t> last;  // per variable: the last part that reads it
    for (std::size_t part = 0; part < parts_.size(); ++part)
        for (const std::uint32_t variable : support(parts_[part].relation)) last[variable] = part;
    std::vector<std::uint32_t> unread;
    std::vector<std::vector<std::uint32_t>> ended(parts_.size());
    for (const std::uint32_t variable : variables) {
        const auto found = last.find(variable);
        (found == last.end() ? unread : ended[found->second]).push_back(variable);
    }
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
    Bdd result = to_after_(to);
    for (std::size_t part = parts_.size(); part-- > 0;)
        result = and_exists(result, parts_[part].relation, parts_[part].after);
    return result;
}

}  // namespace grafverif::bdd
