// SPDX-License-Identifier: MIT
// Computes the values of terms of the equations in a location. Variables of the chart are constant in a location, so
// that the value of a term is a number or a function of the inputs. Terms that read only inputs are evaluated once for
// all locations.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "bdd/terms.hpp"
#include "conform/input_space.hpp"
#include "grafverif/ir/equations.hpp"

namespace grafverif::conform {

/// The value of each variable of the equations in one location; the entries of inputs are unused.
using Values = std::vector<std::int64_t>;
/// For each variable of the equations: the input that it represents; nullopt if the variable is not an input.
using InputOf = std::vector<std::optional<std::size_t>>;

/// The value of a term in a location: `number`, or a function of the inputs if `function` is set.
struct LocationValue {
    std::int64_t number = 0;
    /// True if the value is undefined for all inputs: division by zero, or a value that does not fit into 64 bits.
    bool none = false;
    std::optional<BddTerm> function = {};
};

/// The value of a Boolean term in a location.
struct LocationCondition {
    Bdd holds = {};
    Bdd undefined = {};  ///< input combinations for which the term is undefined
};

class LocationTerms {
public:
    /// All arguments must outlive this object.
    LocationTerms(const Equations& equations, const InputOf& inputs, const InputSpace& space);

    LocationValue value(Id<Expr> term, const Values& at);
    LocationCondition condition(Id<Expr> term, const Values& at);

private:
    enum class Kind : std::uint8_t { Fixed, OfInputs, Mixed };
    /// The operands of an And or Or of the kind Mixed, which reads both inputs and variables. Operands that read only
    /// inputs and are always defined are combined in `inputs`.
    struct Split {
        Bdd inputs = {};
        std::vector<Id<Expr>> others = {};
    };

    bool is_input(const Expr& leaf) const { return inputs_[static_cast<std::size_t>(leaf.value)].has_value(); }
    std::optional<Bdd> plain_condition(Id<Expr> term, const Values& at);
    LocationValue fixed(Id<Expr> term, const Values& at) const;
    LocationValue joined(Id<Expr> term, const Values& at);
    LocationValue anyhow(Id<Expr> term, const Values& at) const;
    const Split* split(Id<Expr> term);

    const Equations& equations_;
    const InputOf& inputs_;
    const InputSpace& space_;
    std::vector<Kind> kinds_ = {};  ///< type of each term
    BddTerms of_inputs_;
    std::unordered_map<std::uint32_t, std::optional<Split>> splits_ = {};
};

}  // namespace grafverif::conform
