// SPDX-License-Identifier: MIT
// Writes terms that the script of the page evaluates: a list of nodes, in which operands precede the term that contains
// them.
//
// A node is `{"op", "text", "boolean", "args"?, ...}`; `text` is the term in the notation of the file, possibly
// shortened. The `op` of a leaf names its element. In a chart, `op` is `input`, `output`, `internal`, `step` or
// `timed`; `place` is the index in the list of these elements of the controller. In a loop, nodes with one of the five
// values of `op` above also have the member `controller`. Further values of `op` in a loop are `signal` (a signal of
// the plant, with its name in `text`) and `location` (with `instance` and `location`). `unknown` is an element that
// runs do not contain.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/support/source.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

class TermList {
public:
    /// Returns the node of a leaf, without its text. `exprs` must outlive the list.
    using Leaf = std::function<nlohmann::ordered_json(const Expr&)>;
    TermList(const Exprs& exprs, LeafPrinter print, Leaf leaf)
        : exprs_(&exprs), print_(std::move(print)), leaf_(std::move(leaf)) {}

    /// Adds a term and returns its index in the list. The function is recursive; the reader of input files limits the
    /// depth of terms.
    std::size_t add(Id<Expr> term);
    const nlohmann::ordered_json& nodes() const { return nodes_; }

private:
    const Exprs* exprs_;
    LeafPrinter print_;
    Leaf leaf_;
    std::map<Id<Expr>, std::size_t> places_ = {};
    nlohmann::ordered_json nodes_ = nlohmann::ordered_json::array();
};

/// Returns `{"name", "steps", "transitions", "timed", "terms", "ownerOfAction", "ownerOfForcing"}`. From the returned
/// data, the page explains why a transition is cleared. `from` of a transition contains the steps that enable it,
/// including exit steps.
nlohmann::ordered_json chart_json(const Chart& chart);

/// Returns `{"name", "pattern", "at_stable", "operands", "terms"}`. For a property with a duration, a count or a scope,
/// the object also has `headings`, the role of each operand.
nlohmann::ordered_json property_json(const Model& model, const ClosedLoop& loop, const Property& property);

/// `term_text` returns a term, and `expectation_text` returns the formula of a property, in the notation of the file.
std::string term_text(const Model& model, const ClosedLoop& loop, Id<Expr> term);
std::string expectation_text(const Model& model, const ClosedLoop& loop, const Property& property);
/// Returns the formula, as in `sources`, of the property with the name `name`. For a step of a property (`S.X7`),
/// returns the formula of the property `S`. The result is empty if there is no such property.
std::string expectation_text(const Model& model, Id<ClosedLoop> loop, const std::string& name, const Sources& sources);

}  // namespace grafverif
