// SPDX-License-Identifier: MIT
#include "check/timed/property_monitor.hpp"

#include <algorithm>

namespace grafverif::timed {

std::size_t PropertyMonitor::add(std::uint32_t predicate) {
    predicates_.push_back({predicate, results_.size()});
    results_.emplace_back();
    return results_.size() - 1;
}

std::size_t PropertyMonitor::add_bit(const Field& bit, std::uint32_t quiescent) {
    const auto same = [&](const Bits& bits) { return bits.word == bit.word && bits.quiescent == quiescent; };
    auto bits = std::ranges::find_if(bits_, same);
    if (bits == bits_.end()) bits = bits_.insert(bits, Bits{.word = bit.word, .quiescent = quiescent});
    bits->missing |= bit.mask();
    bits->each.push_back({bit.mask(), results_.size()});
    results_.emplace_back();
    return results_.size() - 1;
}

bool PropertyMonitor::needs(const Machine& machine, const Word* words, Registers& registers) const {
    const auto holds = [&](std::uint32_t code) { return machine.holds(code, words, registers); };
    const auto wanted = [&](const Predicate& predicate) { return holds(predicate.code) != End::No; };
    const auto missing = [&](const Bits& bits) {
        return (words[bits.word] & bits.missing) != 0 &&
               (bits.quiescent == Program::yes || holds(bits.quiescent) == End::Yes);
    };
    return std::ranges::any_of(predicates_, wanted) || std::ranges::any_of(bits_, missing);
}

bool PropertyMonitor::mark(const Machine& machine, const Word* words, Registers& registers,
                           std::vector<Word>& marks) const {
    marks.assign((results_.size() + 63) / 64, 0);
    const auto set = [&](std::size_t search) { marks[search / 64] |= Word{1} << search % 64; };
    for (const Predicate& predicate : predicates_) {
        const End end = machine.holds(predicate.code, words, registers);
        if (end != End::Yes && end != End::No) return false;
        if (end == End::Yes) set(predicate.search);
    }
    for (const Bits& bits : bits_) {
        const Word met = words[bits.word] & bits.missing;
        if (met == 0) continue;
        if (bits.quiescent != Program::yes && machine.holds(bits.quiescent, words, registers) != End::Yes) continue;
        for (const Bit& bit : bits.each)
            if ((met & bit.mask) != 0) set(bit.search);
    }
    return true;
}

void PropertyMonitor::look(const Machine& machine, std::uint32_t state, const Word* words, Registers& registers) {
    for (std::size_t i = 0; i < predicates_.size();) {
        const End end = machine.holds(predicates_[i].code, words, registers);
        if (end == End::No) {
            ++i;
            continue;
        }
        Result& result = results_[predicates_[i].search];
        if (end == End::Yes) result.state = state;
        else result.broken = true;
        predicates_[i] = predicates_.back();
        predicates_.pop_back();
    }
    for (Bits& bits : bits_) {
        const Word met = words[bits.word] & bits.missing;
        if (met == 0) continue;
        if (bits.quiescent != Program::yes && machine.holds(bits.quiescent, words, registers) != End::Yes) continue;
        for (const Bit& bit : bits.each)
            if ((met & bit.mask) != 0) results_[bit.search].state = state;
        bits.missing &= ~met;
    }
    std::erase_if(bits_, [](const Bits& bits) { return bits.missing == 0; });
}

}  // namespace grafverif::timed
