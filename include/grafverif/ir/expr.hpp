// SPDX-License-Identifier: MIT
// Expr: the expressions of every IR. Each IR owns one append-only, hash-consing Exprs table, so that equal terms have
// equal ids. Operands precede the terms that contain them. Therefore evaluation, substitution and the computation of
// support sets need only one loop over the table.
//
// The smart constructors fold constants, drop neutral and repeated operands and cancel double negation. The
// constructors keep the order of operands as written and the grouping of mixed operators, so that a generated model is
// similar to its chart. `conjunction` and `disjunction` are n-ary and flatten operands with the same operator.
//
// A leaf contains an index. The indexed table depends on the operator of the leaf and on the owner of the expressions:
//   Variable   the owner's table of variables (Chart::variables, Equations::variables, Network::variables, ...)
//   Step       Chart::steps: the step variable X of a step (IEC 60848, step variables); only in Chart
//   Timed      Chart::time_conditions; only in Chart
//   Parameter  the parameters of the enclosing Component or Network template
//   At         Network: true if a process is in a location; only in properties and in Network::settled
//   Integer    the value itself instead of an index; Duration: a value in milliseconds (only in Component)
//
// Integers are 64-bit; an operation that would overflow is not folded, and evaluation reports the overflow. Divide
// truncates towards zero and Modulo has the sign of the dividend, as in C. UPPAAL and NuSMV compute the same values for
// the operands that the input language allows.
#pragma once

#include <cstdint>
#include <functional>
#include <optional>
#include <span>
#include <string>
#include <unordered_map>
#include <utility>
#include <vector>

#include "grafverif/support/id.hpp"

namespace grafverif {

enum class Op : std::uint8_t {
    False,
    True,
    Integer,
    Duration,  // False, True, Integer and Duration: constants
    Variable,
    Step,
    Timed,
    Parameter,
    At,  // Variable, Step, Timed, Parameter and At: leaves
    Not,
    And,
    Or,  // Not, And and Or: Boolean operators; And and Or have two or more operands
    Rise,
    Fall,  // Rise and Fall: edges of a Boolean term, which occur only in Chart
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,  // Equal to GreaterEqual: comparisons of two integers; Equal and NotEqual also of two Booleans
    Negate,
    Plus,
    Minus,
    Times,
    Divide,
    Modulo,       // Negate to Modulo: arithmetic operators
    Conditional,  // operands: condition, value if true, value if false
};

struct Expr {
    Op op = Op::False;
    std::int64_t value = 0;   ///< value of an Integer or Duration; index of another leaf; 0 for an operator
    std::uint32_t first = 0;  ///< position of the first operand in the operand list; use Exprs::operands(id)
    std::uint32_t count = 0;
};

class Exprs {
public:
    Id<Expr> constant(bool value);
    Id<Expr> integer(std::int64_t value);
    Id<Expr> duration(std::int64_t milliseconds);
    Id<Expr> leaf(Op op, std::uint32_t index);                   ///< returns a Variable, Step, Timed or Parameter leaf
    Id<Expr> at(std::uint32_t process, std::uint32_t location);  ///< returns an At leaf

    Id<Expr> negation(Id<Expr> operand);                       ///< returns a Not term
    Id<Expr> conjunction(std::span<const Id<Expr>> operands);  ///< returns an And term; the empty conjunction is true
    Id<Expr> conjunction(Id<Expr> left, Id<Expr> right);
    Id<Expr> disjunction(std::span<const Id<Expr>> operands);  ///< returns an Or term; the empty disjunction is false
    Id<Expr> disjunction(Id<Expr> left, Id<Expr> right);
    Id<Expr> conditional(Id<Expr> condition, Id<Expr> then, Id<Expr> otherwise);
    /// Returns a term with any operator. And, Or, Not and Conditional are forwarded to the functions above.
    Id<Expr> apply(Op op, std::span<const Id<Expr>> operands);
    Id<Expr> apply(Op op, Id<Expr> left, Id<Expr> right);

    const Expr& operator[](Id<Expr> id) const { return nodes_[id.index]; }
    std::span<const Id<Expr>> operands(Id<Expr> id) const { return operands(nodes_[id.index]); }
    std::span<const Id<Expr>> operands(const Expr& node) const { return {operands_.data() + node.first, node.count}; }
    std::size_t size() const { return nodes_.size(); }
    bool contains(Id<Expr> id) const { return id.index < nodes_.size(); }

    bool operator==(const Exprs& other) const;

private:
    Id<Expr> intern(Op op, std::int64_t value, std::span<const Id<Expr>> operands);
    void grow();

    std::vector<Expr> nodes_ = {};
    std::vector<Id<Expr>> operands_ = {};
    /// Hash table with open addressing: index into nodes_ plus one; 0 is a free slot.
    std::vector<std::uint32_t> slots_ = {};
};

bool is_constant(Op op);
bool is_leaf(Op op);
bool is_comparison(Op op);
bool is_arithmetic(Op op);
/// True if `id` is the constant `value`.
bool is_true(const Exprs& exprs, Id<Expr> id);
bool is_false(const Exprs& exprs, Id<Expr> id);

/// Return the two indices of an At leaf: process and location.
std::uint32_t at_process(const Expr& node);
std::uint32_t at_location(const Expr& node);

/// Returns the value of `root`, with Booleans as 0 and 1. `leaf` returns the value of a leaf or of an edge (Rise,
/// Fall). The result is nullopt if an operation is undefined: division by zero, or a result outside 64 bits. The depth
/// of the recursion is the depth of the term. The reader of the input language limits this depth (error `too-deep`).
std::optional<std::int64_t> evaluate(const Exprs& exprs, Id<Expr> root,
                                     const std::function<std::int64_t(const Expr&)>& leaf);

/// Returns the value of every term of the table. Each value is computed once, from the values of its operands. Use
/// evaluate_all for tables whose terms share many subterms. `leaf` is called for every leaf in the table.
std::vector<std::optional<std::int64_t>> evaluate_all(const Exprs& exprs,
                                                      const std::function<std::int64_t(const Expr&)>& leaf);

/// Copies terms into another table or into the same table, with a fixed mapping of leaves. Shared subterms are copied
/// once.
class TermCopier {
public:
    using Leaf = std::function<Id<Expr>(const Expr&)>;
    using Edge = std::function<Id<Expr>(Op, Id<Expr>)>;

    /// `leaf` maps a leaf or a duration to a term in `to`. `edge`, if given, maps an edge (Rise, Fall), with its copied
    /// operand, to a term in `to`. Both tables must outlive this object.
    TermCopier(const Exprs& from, Exprs& to, Leaf leaf, Edge edge = {})
        : from_(&from), to_(&to), leaf_(std::move(leaf)), edge_(std::move(edge)) {}

    Id<Expr> operator()(Id<Expr> root);

private:
    const Exprs* from_;
    Exprs* to_;
    Leaf leaf_;
    Edge edge_;
    std::unordered_map<std::uint32_t, Id<Expr>> copies_ = {};
};

/// Returns a copy of the term `root` of `from` in `to`. Each leaf is replaced by the result of `leaf`, an id in `to`.
Id<Expr> translate(const Exprs& from, Id<Expr> root, Exprs& to, const std::function<Id<Expr>(const Expr&)>& leaf);

/// Returns the distinct leaves of `root`, in order of first occurrence.
std::vector<Id<Expr>> leaves(const Exprs& exprs, Id<Expr> root);

}  // namespace grafverif
