// SPDX-License-Identifier: MIT
// Textual parts of a UPPAAL project: terms, constraints and assignments with the names of one template, and the three
// programs of a project (global declarations, declarations of a template, system definition).
#pragma once

#include <iosfwd>
#include <string>
#include <vector>

#include "emit/uppaal/names.hpp"
#include "grafverif/ir/network.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif::uppaal {

/// Terms in UPPAAL syntax. Parameters are those of `automaton`; without one (queries) a term may contain location
/// tests.
class Terms {
public:
    Terms(const Network& network, const Names& names, Id<Network::Template> automaton = {});

    void write(std::ostream& out, Id<Expr> root) const;
    std::string text(Id<Expr> root) const;
    /// The same in brackets, unless it binds as tightly as a name.
    std::string bracketed(Id<Expr> root) const;
    /// `t <= STEP && u <= 3`
    std::string text(const std::vector<Network::ClockConstraint>& constraints) const;
    /// `x = a || b`
    std::string text(const Network::Assignment& assignment) const;
    /// As a statement, with a condition written as `if`.
    void write_statement(std::ostream& out, const Network::Assignment& assignment) const;

private:
    const Network* network_;
    const Names* names_;
    Id<Network::Template> automaton_;
    LeafPrinter leaf_;
};

/// A data guard that is too long for a label, as a function of its template.
struct GuardFunction {
    std::string name = {};
    std::string body = {};
};

void write_global_declarations(std::ostream& out, const Network& network, const Names& names);
void write_template_declarations(std::ostream& out, const Network& network, const Names& names,
                                 Id<Network::Template> automaton, const std::vector<GuardFunction>& guards);
/// `bool &G_IN, int[0,20] &X, const int D`
std::string parameter_list(const Network::Template& automaton, const LocalNames& names);
void write_system(std::ostream& out, const Network& network, const Names& names);

/// `text` in lines of at most `width` columns, broken after a comma or a Boolean operator.
std::vector<std::string> lines_of(std::string_view text, std::size_t width);

}  // namespace grafverif::uppaal
