// SPDX-License-Identifier: MIT
#include "bdd/terms.hpp"

namespace grafverif {

template class BitTerms<Bdd>;

BddTerm term_of(const BddSpace& space, const BddWord& word) {
    if (word.type.boolean) return bdd_boolean(space.variable(word.bits.front()));
    bits::Integer<Bdd> offset;
    for (const std::uint32_t bit : word.bits) offset.push_back(space.variable(bit));
    offset.emplace_back();  // the sign bit is false, because the offset from type.low is not negative
    return {false, bits::sum(offset, bits::constant<Bdd>(word.type.low)), {}};
}

Bdd in_range(const BddSpace& space, const BddWord& word) {
    return within(term_of(space, word), word.type.low, word.type.high);
}

Bdd equals(const BddSpace& space, const BddWord& word, std::int64_t value) {
    const auto offset =
        static_cast<std::uint64_t>(value) - static_cast<std::uint64_t>(word.type.boolean ? 0 : word.type.low);
    std::vector<BddLiteral> literals;
    for (std::size_t place = 0; place < word.bits.size(); ++place)
        literals.push_back({word.bits[place], ((offset >> place) & 1U) != 0});
    return cube(space, literals);
}

std::int64_t value_of(const BddWord& word, const std::vector<bool>& assignment) {
    std::uint64_t offset = 0;
    for (std::size_t place = 0; place < word.bits.size(); ++place)
        if (assignment[word.bits[place]]) offset |= std::uint64_t{1} << place;
    return static_cast<std::int64_t>(static_cast<std::uint64_t>(word.type.boolean ? 0 : word.type.low) + offset);
}

std::vector<Bdd> word_bits(const BddTerm& term, Type type) {
    if (type.boolean) return term.bits;
    bits::Integer<Bdd> offset = bits::difference(term.bits, bits::constant<Bdd>(type.low));
    offset.resize(bit_count(type), offset.back());
    return offset;
}

std::int64_t value_of(const BddTerm& term, const std::vector<bool>& assignment) {
    std::int64_t value = 0;
    for (std::size_t bit = term.bits.size(); bit-- > 0;) {
        const bool sign = !term.boolean && bit + 1 == term.bits.size();
        const bool on = evaluate(term.bits[bit], assignment);
        value = 2 * value + (on ? (sign ? -1 : 1) : 0);
    }
    return value;
}

}  // namespace grafverif
