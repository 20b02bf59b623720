// SPDX-License-Identifier: MIT
// PlcopenValues: computes the values at the connections of an LD or FBD network as expressions. The class supports
// variables, contacts, and blocks for Boolean and arithmetic functions. A derived class can support elements with a
// state.
#pragma once

#include <cstddef>
#include <string>

#include "read/plcopen/network.hpp"

namespace grafverif {

class PlcopenValues {
public:
    PlcopenValues(PlcopenReader& reader, const PlcopenNetwork& network) : reader_(reader), network_(network) {}
    PlcopenValues(PlcopenValues&&) = delete;
    virtual ~PlcopenValues() = default;

    /// Returns the value at a connection point: the disjunction of its incoming lines. The result is invalid if the
    /// point is not connected.
    Id<st::Expr> at(pugi::xml_node point, std::size_t depth = 0);
    Id<st::Expr> from(pugi::xml_node source) { return of({source, {}}, 0); }
    /// Returns the value assigned to the coil or variable at the end of the network.
    Id<st::Expr> into(pugi::xml_node end) { return passes_on(end) ? negated(end, at(end)) : Id<st::Expr>{}; }

protected:
    static constexpr std::size_t deepest = 200;  // maximum number of levels in a network

    /// Returns the value of an output of a block that does not correspond to an operator of Structured Text.
    virtual Id<st::Expr> other_block(pugi::xml_node block, const std::string& output, std::size_t depth);
    /// Returns the value of a contact or coil with an edge or storage, or of a coil in the middle of a rung.
    virtual Id<st::Expr> other_element(pugi::xml_node element, std::size_t depth);
    /// A hook that is called for each term that reads variables.
    virtual void is_read(Id<st::Expr>) {}

    Id<st::Expr> negated(pugi::xml_node node, Id<st::Expr> term, std::string_view mark = "negated");
    /// True if a variable, contact, coil or pin only passes or negates a value. Reports an element that detects an
    /// edge, sets or resets.
    bool passes_on(pugi::xml_node node);
    /// Same as `at`, but reports an unconnected point. `what` names the element in the message.
    Id<st::Expr> wired(pugi::xml_node point, std::size_t depth, std::string_view what);
    /// Returns the value of an input pin of a block.
    Id<st::Expr> pin(pugi::xml_node pin, std::size_t depth);
    /// Returns the variable of a contact or coil.
    Id<st::Expr> operand(pugi::xml_node node);
    Id<st::Expr> unsupported(pugi::xml_node block, std::string_view what);

    PlcopenReader& reader_;
    const PlcopenNetwork& network_;

private:
    Id<st::Expr> of(const PlcopenLine& line, std::size_t depth);
    Id<st::Expr> variable(pugi::xml_node node, std::string_view mark);
    Id<st::Expr> contact(pugi::xml_node node, std::size_t depth);
    Id<st::Expr> block(pugi::xml_node node, const std::string& output, std::size_t depth);

    std::size_t values_ = 0;
};

/// True if the attribute (`edge` or `storage`) is present with a value other than `none`.
bool is_marked(pugi::xml_node node, std::string_view attribute);

}  // namespace grafverif
