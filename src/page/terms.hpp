// SPDX-License-Identifier: MIT
// Terms as the page evaluates them: a list of nodes, operands before what they stand in.
//
// A node is `{"op", "text", "boolean", "args"?, ...}`; `text` is the term as the file would write it, shortened. Leaves say
// what they stand for: in a chart `input`, `output`, `internal`, `step`, `timed` with their `place` among those of the
// controller; in a loop the same with `controller`, or `signal` (of the plant, by its name in `text`), or `location` with
// `instance` and `location`. `unknown` is what a run does not tell.
#pragma once

#include <functional>
#include <map>
#include <nlohmann/json.hpp>
#include <string>

#include "grafverif/ir/chart.hpp"
#include "grafverif/ir/closed_loop.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

class TermList {
public:
    /// The node of a leaf, without its text. `exprs` outlives the list.
    using Leaf = std::function<nlohmann::ordered_json(const Expr&)>;
    TermList(const Exprs& exprs, LeafPrinter print, Leaf leaf)
        : exprs_(&exprs), print_(std::move(print)), leaf_(std::move(leaf)) {}

    /// The place of the term in the list. Recurses over the term, whose depth the reader bounds.
    std::size_t add(Id<Expr> term);
    const nlohmann::ordered_json& nodes() const { return nodes_; }

private:
    const Exprs* exprs_;
    LeafPrinter print_;
    Leaf leaf_;
    std::map<Id<Expr>, std::size_t> places_ = {};
    nlohmann::ordered_json nodes_ = nlohmann::ordered_json::array();
};

/// `{"name", "steps", "transitions", "timed", "terms", "ownerOfAction", "ownerOfForcing"}`: what the page needs to know of
/// a chart to say why a transition is cleared. `from` of a transition are the steps that enable it, exit steps included.
nlohmann::ordered_json chart_json(const Chart& chart);

/// `{"name", "pattern", "at_stable", "operands", "terms"}`; of a sentence with a duration, a count or a scope also
/// `headings`: what it says of each operand.
nlohmann::ordered_json property_json(const Model& model, const ClosedLoop& loop, const Property& property);

/// Terms as the file would write them: a condition of the loop, what a property claims.
std::string term_text(const Model& model, const ClosedLoop& loop, Id<Expr> term);
std::string claim_text(const Model& model, const ClosedLoop& loop, const Property& property);
/// Of the property of that name, or of the one that it is a part of (`S.X7`); empty: there is none.
std::string claim_text(const Model& model, Id<ClosedLoop> loop, const std::string& name);

}  // namespace grafverif
