// SPDX-License-Identifier: MIT
// Draft: the tree of a chart that another format describes, under construction. Everything in it keeps its place in the
// file it comes from, so that name resolution and type checks of the language report faults there. Names are made legal
// once; comments are hung on places of that file, and find their lines when the tree is laid out as text.
#pragma once

#include <initializer_list>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "support/unique_names.hpp"
#include "syntax/language/tree.hpp"

namespace grafverif {

class Draft {
public:
    Draft(Id<Source> source, bool lossy, Diagnostics& diagnostics);
    Draft(const Draft&) = delete;
    Draft& operator=(const Draft&) = delete;

    tree::Name name(std::string_view text, Span where) { return {words_.intern(text), where}; }
    std::string_view text(tree::Name name) const { return file_.text(name); }

    Id<tree::Expr> constant(bool value, Span where);
    Id<tree::Expr> number(std::int64_t value, Span where);
    Id<tree::Expr> duration(std::int64_t milliseconds, Span where);
    Id<tree::Expr> variable(std::string_view name, Span where);
    Id<tree::Expr> member(std::string_view owner, std::string_view name, Span where);
    /// Not valid, after an error, where it would be deeper than any expression may be. `And` and `Or` take any number of
    /// operands, and those of an operand of their own kind.
    Id<tree::Expr> node(tree::Op op, const std::vector<Id<tree::Expr>>& operands, Span where);
    /// A second copy of a term: operands belong to one node.
    Id<tree::Expr> copy(Id<tree::Expr> term);
    const tree::Expr& operator[](Id<tree::Expr> id) const { return file_.exprs[id]; }
    std::vector<Id<tree::Expr>> operands(Id<tree::Expr> id) const;

    /// Lines (`// ...`) before what was written at `where`; `behind`: at the end of its line.
    void comment(Span where, std::string line, bool behind = false);

    /// What cannot be taken over: an error, or a warning and a line in the text where losses are allowed. `hint`: what
    /// to do about it.
    void refuse(Span where, std::string_view what, std::string_view hint);
    bool lossy() const { return lossy_; }
    Diagnostics& diagnostics() { return *diagnostics_; }

    const tree::File& file() const { return file_; }
    /// Inputs first, then outputs, then internal variables; Booleans without a comment of their own share a line.
    void group_variables(tree::Chart& chart) const;
    void declare(tree::Chart chart) { file_.declarations.emplace_back(std::move(chart)); }
    tree::File take();

private:
    Id<tree::Expr> leaf(tree::Op op, Span where);

    tree::File file_ = {};
    tree::Words words_;
    Diagnostics* diagnostics_;
    bool lossy_ = false;
    std::size_t errors_ = 0;  ///< said before this draft
};

/// Names of one scope, legal in the language and different from each other. A name that has to change is warned of.
class LegalNames {
public:
    enum class Kind { Variable, Label, Chart };

    LegalNames(Kind kind, Draft& draft) : kind_(kind), draft_(&draft) {}

    /// A legal name for what is called `wish`, none that was given out before.
    std::string make(std::string_view wish, Span where);
    /// The same for a name that nobody wrote, of which there is nothing to warn.
    std::string invent(std::string_view wish);
    /// Keeps a name free that is legal as it stands.
    void reserve(std::string_view name) { taken_.take(std::string(name)); }

private:
    Kind kind_;
    Draft* draft_;
    UniqueNames taken_ = {};
};

}  // namespace grafverif
