// SPDX-License-Identifier: MIT
// Splits the steps of the transition relation by the values of choices. The steps are split by a choice if, on average
// over the values of the choice, enough bits of the state stay unchanged. If a value of the choice implies values of
// other choices, the other choices are replaced by these values before the unchanged bits are counted. For example, a
// process that is not selected does not take an edge, so its bits stay unchanged.
#include "check/symbolic/event_clusters.hpp"

#include <algorithm>
#include <optional>
#include <utility>

namespace grafverif::symbolic {

namespace {

/// Steps are split by a choice only if, on average over its values, at most this fraction of the bits can change.
constexpr double worth_splitting = 0.6;
/// Maximum size, in nodes, of a condition that is used to show that a bit is unchanged.
constexpr std::size_t most_joined_nodes = 100;

/// A function with its support (the variables on which it depends). The support is stored because it is needed
/// repeatedly.
struct Read {
    Bdd function = {};
    std::vector<std::uint32_t> variables = {};

    explicit Read(Bdd f) : function(std::move(f)), variables(support(function)) {}

    bool reads_any(const std::vector<std::uint32_t>& some) const {
        return std::ranges::any_of(some,
                                   [&](std::uint32_t each) { return std::ranges::binary_search(variables, each); });
    }
    Read under(const Bdd& literals) const {
        return reads_any(support(literals)) ? Read(cofactor(function, literals)) : *this;
    }
};

struct Rules {
    std::vector<Read> conditions = {};
    /// Each state bit that a step may change, with the function that is its value after the step.
    std::vector<std::pair<std::uint32_t, Read>> bits = {};
};

bool is_cube(const Bdd& f) {
    Bdd rest = f;
    while (!rest.is_constant()) {
        const Bdd low = rest.low(), high = rest.high();
        if (!low.is_false() && !high.is_false()) return false;
        rest = low.is_false() ? high : low;
    }
    return rest.is_true();
}

class Splitter {
public:
    Splitter(const BddSpace& space, std::span<const BddWord> choices) : space_(space), choices_(choices) {
        for (const BddWord& word : choices) bits_.insert(bits_.end(), word.bits.begin(), word.bits.end());
        std::ranges::sort(bits_);
    }

    void split(const Rules& rules, std::vector<EventCluster>& found) const {
        std::vector<Rules> best;
        double least = worth_splitting * static_cast<double>(rules.bits.size());
        for (const BddWord& word : choices_) {
            std::vector<Rules> parts = by_value(rules, word);
            double changed = 0;
            for (const Rules& part : parts) changed += static_cast<double>(part.bits.size());
            changed /= static_cast<double>(std::max<std::size_t>(parts.size(), 1));
            if (parts.size() < 2 || rules.bits.empty() || changed > least) continue;
            least = changed;
            best = std::move(parts);
        }
        for (const Rules& part : best) split(part, found);
        if (!best.empty()) return;
        EventCluster kind;
        for (const Read& condition : rules.conditions) kind.conditions.push_back(condition.function);
        for (const auto& [bit, value] : rules.bits) kind.bits.push_back({bit, value.function});
        found.push_back(std::move(kind));
    }

private:
    /// Returns the rules under each value of the choice `word`; values for which no step is possible are omitted. The
    /// result is empty if no condition reads `word`.
    std::vector<Rules> by_value(const Rules& rules, const BddWord& word) const {
        const auto read = [&](const Read& each) { return each.reads_any(word.bits); };
        std::vector<Rules> parts;
        if (std::ranges::none_of(rules.conditions, read)) return parts;
        for (std::int64_t value = word.type.boolean ? 0 : word.type.low;
             value <= (word.type.boolean ? 1 : word.type.high); ++value)
            if (auto part = under(rules, equals(space_, word, value))) parts.push_back(std::move(*part));
        return parts;
    }

    /// Returns the rules for the steps that satisfy `literals`, which is a conjunction of literals of choices. Literals
    /// of other choices that follow from the conditions are also substituted. Bits that these steps leave unchanged are
    /// omitted. The result is nullopt if no step satisfies `literals`.
    std::optional<Rules> under(const Rules& rules, Bdd literals) const {
        Rules left = rules;
        while (!literals.is_true()) {
            Bdd implied = Bdd::constant(true);
            std::vector<Read> conditions;
            for (const Read& each : left.conditions) {
                Read now = each.under(literals);
                if (now.function.is_false()) return {};
                if (now.function.is_true()) continue;
                if (std::ranges::includes(bits_, now.variables) && is_cube(now.function)) implied &= now.function;
                else conditions.push_back(std::move(now));
            }
            if (implied.is_false()) return {};
            left.conditions = std::move(conditions);
            for (auto& [bit, value] : left.bits) value = value.under(literals);
            literals = implied;
        }
        std::erase_if(left.bits, [&](const auto& bit) { return stays(bit.first, bit.second, left.conditions); });
        return left;
    }

    /// True if no step changes the bit, according to a limited test. The test uses only simple conditions: conditions
    /// without choices and with at most `most_joined_nodes` nodes.
    bool stays(std::uint32_t bit, const Read& value, const std::vector<Read>& conditions) const {
        Bdd changes = value.function ^ space_.variable(bit);
        for (const Read& each : conditions)
            if (!changes.is_false() && !each.reads_any(bits_) && size(each.function) <= most_joined_nodes)
                changes &= each.function;
        return changes.is_false();
    }

    const BddSpace& space_;
    const std::span<const BddWord> choices_;
    std::vector<std::uint32_t> bits_ = {};  ///< bits of all choices, in increasing order
};

}  // namespace

std::vector<EventCluster> kinds(const BddSpace& space, EventCluster all, std::span<const BddWord> choices) {
    Rules rules;
    for (Bdd& condition : all.conditions) rules.conditions.emplace_back(std::move(condition));
    for (bdd::NextBit& bit : all.bits) rules.bits.emplace_back(bit.before, Read(std::move(bit.value)));
    std::vector<EventCluster> found;
    Splitter(space, choices).split(rules, found);
    return found;
}

}  // namespace grafverif::symbolic
