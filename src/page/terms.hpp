// SPDX-License-Identifier: MIT
// Terms for evaluation on the page: a list of nodes, operands first.
//
// A node is `{"op", "text", "boolean", "args"?, ...}`; `text` is the term as the file would write it, shortened. The
// `op` of a leaf names its element. In a chart it is `input`, `output`, `internal`, `step` or `timed`, with its `place`
// among those of the controller. In a loop it is one of these with `controller`, or `signal` (of the plant, by its name
// in `text`), or `location` with `instance` and `location`. `unknown` is an element that runs do not contain.
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
    /// The node of a leaf, without its text. `exprs` must outlive the list.
    using Leaf = std::function<nlohmann::ordered_json(const Expr&)>;
    TermList(const Exprs& exprs, LeafPrinter print, Leaf leaf)
        : exprs_(&exprs), print_(std::move(print)), leaf_(std::move(leaf)) {}

    /// The index of the term in the list. Recurses over the term, whose depth the reader bounds.
    std::size_t add(Id<Expr> term);
    const nlohmann::ordered_json& nodes() const { return nodes_; }

private:
    const Exprs* exprs_;
    LeafPrinter print_;
    Leaf leaf_;
    std::map<Id<Expr>, std::size_t> places_ = {};
    nlohmann::ordered_json nodes_ = nlohmann::ordered_json::array();
};

/// `{"name", "steps", "transitions", "timed", "terms", "ownerOfAction", "ownerOfForcing"}`: the data with which the
/// page explains why a transition is cleared. `from` of a transition lists the steps that enable it, including exit
/// steps.
nlohmann::ordered_json chart_json(const Chart& chart);

/// `{"name", "pattern", "at_stable", "operands", "terms"}`; of a sentence with a duration, a count or a scope also
/// `headings`: the role of each operand.
nlohmann::ordered_json property_json(const Model& model, const ClosedLoop& loop, const Property& property);

/// Terms as the file would write them: a condition of the loop, the formula of a property.
std::string term_text(const Model& model, const ClosedLoop& loop, Id<Expr> term);
std::string expectation_text(const Model& model, const ClosedLoop& loop, const Property& property);
/// The formula of the property of that name, or of the one that it is a part of (`S.X7`), as written in `sources`;
/// empty if there is none.
std::string expectation_text(const Model& model, Id<ClosedLoop> loop, const std::string& name, const Sources& sources);

}  // namespace grafverif
