// SPDX-License-Identifier: MIT
// Minimises a machine by partition refinement (Moore 1956). Two states remain in one class as long as, for equal
// inputs, they have equal outputs and their successors are in the same class.
#include <algorithm>
#include <map>
#include <string>
#include <tuple>

#include "conform/input_space.hpp"
#include "conform/mealy.hpp"

namespace grafverif {

namespace {

using namespace conform;

class Minimiser {
public:
    Minimiser(const MealyMachine& machine, const BddLimits& limits)
        : machine_(machine),
          space_(named(machine.inputs), limits),
          sets_(machine.exprs, space_),
          class_of_(machine.states.size()) {
        space_.assume(sets_(machine.assumed));
    }

    MealyMachine minimised() {
        std::size_t classes = 1;
        while (refine() != classes) classes = classes_;
        return merged();
    }

private:
    /// A response: class of the successor, output word and waiting time. The class is `no_class` if the machine never
    /// becomes stable for these inputs.
    using Response = std::tuple<std::uint32_t, std::uint32_t, std::int64_t>;
    /// The signature of a state: the set of inputs for each response. States with different signatures are in different
    /// classes.
    using Signature = std::map<Response, Bdd>;
    static constexpr std::uint32_t no_class = 0xFFFFFFFFU;

    Bdd set_of(Id<Expr> condition) { return sets_(condition) & space_.assumed(); }

    std::vector<Signature> signatures() {
        std::vector<Signature> all(machine_.states.size());
        for (const MealyMachine::Transition& one : machine_.transitions)
            all[one.from.index][{class_of_[one.to.index], one.answer.index, one.wait_ms}] |= set_of(one.condition);
        for (const MealyMachine::Unstable& one : machine_.unstable)
            all[one.from.index][{no_class, no_class, 0}] |= set_of(one.condition);
        return all;
    }

    /// Performs one round of refinement and returns the number of classes. Classes are numbered by their first states.
    std::size_t refine() {
        struct Less {
            bool operator()(const Signature& a, const Signature& b) const {
                return std::lexicographical_compare(
                    a.begin(), a.end(), b.begin(), b.end(), [](const auto& x, const auto& y) {
                        return x.first != y.first ? x.first < y.first : x.second.edge() < y.second.edge();
                    });
            }
        };
        const std::vector<Signature> all = signatures();
        std::map<Signature, std::uint32_t, Less> known;
        for (std::size_t state = 0; state < all.size(); ++state)
            class_of_[state] = known.emplace(all[state], static_cast<std::uint32_t>(known.size())).first->second;
        return classes_ = known.size();
    }

    MealyMachine merged() {
        MealyMachine result = machine_;
        result.states = {};
        result.transitions.clear();
        result.unstable.clear();
        result.initial = {class_of_[machine_.initial.index]};
        result.unstable_pairs = machine_.unstable_pairs ? std::optional<std::uint64_t>(0) : std::nullopt;
        Conditions conditions(space_, result.exprs);
        const std::vector<Signature> all = signatures();
        for (std::uint32_t state = 0; state < all.size(); ++state) {
            if (class_of_[state] != result.states.size()) continue;
            const Id<MealyMachine::State> from =
                result.states.add({situations(state), machine_.states[{state}].detail});
            for (const auto& [response, set] : all[state]) {
                const auto& [to, answer, wait] = response;
                if (to != no_class) {
                    result.transitions.push_back({from, {to}, conditions.term(set), {answer}, wait});
                    continue;
                }
                result.unstable.push_back({from, conditions.term(set)});
                const auto pairs = small_count(set, space_.bits());
                if (result.unstable_pairs && pairs) *result.unstable_pairs += *pairs;
            }
        }
        return result;
    }

    /// Returns the situations of the class that begins with `first`.
    std::string situations(std::uint32_t first) const {
        std::vector<std::string> all;
        for (std::uint32_t state = first; state < class_of_.size(); ++state)
            if (const std::string& one = machine_.states[{state}].situation;
                class_of_[state] == class_of_[first] && std::ranges::find(all, one) == all.end())
                all.push_back(one);
        std::string text;
        for (const std::string& one : all) text += (text.empty() ? "" : " or ") + one;
        return text;
    }

    const MealyMachine& machine_;
    InputSpace space_;
    InputSets sets_;
    std::vector<std::uint32_t> class_of_ = {};
    std::size_t classes_ = 1;
};

}  // namespace

std::optional<MealyMachine> minimised(const MealyMachine& machine, const MealyOptions& options, Span origin,
                                      Diagnostics& diagnostics) {
    try {
        return Minimiser(machine, {options.max_memory, options.deadline, options.stop}).minimised();
    } catch (const BddExhausted& exhausted) {
        diagnostics.add(limit_reached(exhausted, origin, options.stop));
        return {};
    }
}

}  // namespace grafverif
