// SPDX-License-Identifier: MIT
// The terms of the equations in one location: what the chart remembers is a constant there, so a term is a number or a
// function of the inputs.
#pragma once

#include <cstdint>
#include <optional>
#include <unordered_map>
#include <utility>
#include <vector>

#include "conform/input_space.hpp"
#include "bdd/terms.hpp"
#include "grafverif/ir/equations.hpp"

namespace grafverif::conform {

/// A term in a location: `number`, or a function of the inputs where `function` is set.
struct LocationValue {
    std::int64_t number = 0;
    bool none = false;                        ///< the constant has no value: division by zero, or too large
    std::optional<BddTerm> function = {};

    bool is(bool value) const { return !function && !none && (number != 0) == value; }
};

class LocationTerms {
public:
    /// `inputs`: per variable of the equations the input it is, or nothing. All arguments outlive this.
    LocationTerms(const Equations& equations, const std::vector<std::optional<std::size_t>>& inputs, const InputSpace& space);

    /// The constants of the location: per variable of the equations; what is said of inputs does not matter.
    std::vector<std::int64_t>& values() { return values_; }
    const std::vector<std::int64_t>& values() const { return values_; }

    LocationValue value(Id<Expr> term);
    /// Where a Boolean term holds; `undefined` gains where it has no value.
    Bdd condition(Id<Expr> term, Bdd& undefined);

private:
    enum class Kind : std::uint8_t { Fixed, OfInputs, Mixed };
    /// A Mixed And or Or whose terms of inputs alone always have a value: those taken together, and the others.
    struct Split {
        Bdd inputs = {};
        std::vector<Id<Expr>> others = {};
    };

    bool is_input(const Expr& leaf) const { return inputs_[static_cast<std::size_t>(leaf.value)].has_value(); }
    std::optional<Bdd> plain_condition(Id<Expr> term);
    LocationValue fixed(Id<Expr> term) const;
    LocationValue joined(Id<Expr> term);
    LocationValue anyhow(Id<Expr> term);
    const Split* split(Id<Expr> term);

    const Equations& equations_;
    const std::vector<std::optional<std::size_t>>& inputs_;
    const InputSpace& space_;
    std::vector<Kind> kinds_ = {};            ///< per term
    std::vector<std::int64_t> values_ = {};
    BddTerms of_inputs_;
    std::unordered_map<std::uint32_t, std::optional<Split>> splits_ = {};
};

}  // namespace grafverif::conform
