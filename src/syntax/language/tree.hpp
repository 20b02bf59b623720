// SPDX-License-Identifier: MIT
// tree: a file as it is written, before any name is looked up. It lives between the parser and name resolution, and is
// what `fmt` prints; nothing after `read` knows of it.
//
// Names are interned: two names of one file are equal iff their words are. Expressions lie in one flat table, operands
// chained as siblings, so that a term of any width costs no allocation of its own. Every node and every declaration
// knows its span; comments and blank lines are kept beside the tree, ordered by position, and are put back by it.
#pragma once

#include <cstddef>
#include <cstdint>
#include <optional>
#include <string>
#include <string_view>
#include <variant>
#include <vector>

#include "grafverif/ir/property.hpp"
#include "grafverif/support/source.hpp"
#include "grafverif/support/table.hpp"

namespace grafverif::tree {

struct Word {
    std::string text = {};
};

/// A name where it is used; not valid where an optional name is missing.
struct Name {
    Id<Word> word = {};
    Span where = {};
    bool valid() const { return word.valid(); }
};

enum class Op : std::uint8_t {
    False,
    True,
    Number,
    Duration,
    Name,
    Member,  // Member: operand `.` word
    In,      // operand `in` word
    Not,
    Rise,
    Fall,
    Negate,
    And,
    Or,  // two or more operands
    Implies,
    Equal,
    NotEqual,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Plus,
    Minus,
    Times,
    Divide,
    Modulo,
};

struct Expr {
    Op op = Op::False;
    bool bracketed = false;  ///< the author put it in brackets
    std::uint16_t depth = 1;
    Id<Word> word = {};                         ///< Name, Member, In
    std::int64_t value = 0;                     ///< Number; Duration: milliseconds
    Id<Expr> first = {}, last = {}, next = {};  ///< first and last operand, next sibling
    Span where = {};
};

/// `// ...` or `/* ... */`, both ends included, the line end not.
struct Comment {
    std::string text = {};
    Span where = {};
    bool own_line = false;  ///< nothing but blanks before it on its line
};

struct Range {
    Id<Expr> low = {}, high = {};
};

enum class TypeWord { None, Bool, Int, Duration };

/// A declared variable, parameter or constant: `NAME: TYPE RANGE = VALUE`.
struct Variable {
    Name name = {};
    TypeWord type = TypeWord::None;
    std::optional<Range> range = {};
    Id<Expr> value = {};
    Span where = {};
};

enum class VariableKind { Input, Output, Internal, Own, Constant };  ///< Own: `variable` of a component
struct Variables {
    VariableKind kind = VariableKind::Input;
    std::vector<Variable> variables = {};
    Span where = {};
};

struct Constraint {
    Id<Expr> condition = {};
    Span where = {};
};

/// `target := value`.
struct Assignment {
    Name target = {};
    Id<Expr> value = {};
    Span where = {};
};

// -- charts ----------------------------------------------------------------------------------------------------------

struct ContinuousAction {
    Name output = {};
    Id<Expr> condition = {};  ///< `if`
    Id<Expr> delay = {};      ///< `after`
    Id<Expr> limit = {};      ///< `for`
    Span where = {};
};
enum class StoredWhen { Missing, Activation, Deactivation, Event };
struct StoredAction {
    Assignment assignment = {};
    StoredWhen when = StoredWhen::Missing;
    Id<Expr> event = {};
    Span where = {};
};
enum class ForcedTo { Empty, Current, Initial, Steps };
struct ForcingOrder {
    Name chart = {};
    ForcedTo to = ForcedTo::Empty;
    std::vector<Name> steps = {};
    Span where = {};
};
using Action = std::variant<ContinuousAction, StoredAction, ForcingOrder>;

enum class StepKind { Ordinary, Macro, Enclosing };
struct Step {
    bool initial = false, linked = false, entry = false, exit = false;
    StepKind kind = StepKind::Ordinary;
    Name name = {};
    std::vector<Name> contents = {};  ///< the expansion of a macro-step, the charts that an enclosing step encloses
    std::vector<Action> actions = {};
    Span where = {};
};

struct Transition {
    Name name = {};  ///< not valid: none written
    std::vector<Name> from = {}, to = {};
    Id<Expr> condition = {};  ///< not valid: none written
    std::vector<Assignment> assignments = {};
    Span where = {};
};

/// `accept CODE SUBJECT "reason";`
struct Accept {
    std::string code = {};
    std::string subject = {};  ///< empty: none is written
    std::string reason = {};
    Span where = {};
};

struct Partial;
using ChartItem = std::variant<Variables, Constraint, Accept, Step, Transition, Partial>;

enum class PartialKind { Partial, Expansion };
struct Partial {
    PartialKind kind = PartialKind::Partial;
    Name name = {};
    std::vector<ChartItem> items = {};
    Span where = {};
};

struct Chart {
    Name name = {};
    std::vector<ChartItem> items = {};
    Span where = {};
    bool broken = false;  ///< a syntax error lies within
};

// -- components -------------------------------------------------------------------------------------------------------

struct Clocks {
    std::vector<Name> names = {};
    Span where = {};
};
struct Location {
    bool initial = false;
    Name name = {};
    Id<Expr> invariant = {};
    std::vector<Assignment> values = {};
    Span where = {};
};
struct Edge {
    bool urgent = false;
    Name from = {}, to = {};
    Id<Expr> condition = {};
    std::vector<Assignment> assignments = {};
    Span where = {};
};
using ComponentItem = std::variant<Variables, Constraint, Clocks, Location, Edge>;

struct Component {
    Name name = {};
    std::vector<Variables> parameters = {};
    std::vector<ComponentItem> items = {};
    Span where = {};
    bool broken = false;
};

// -- closed loops -----------------------------------------------------------------------------------------------------

struct Controller {
    Name chart = {};
    std::vector<Name> options = {};
    Span where = {};
};
struct Grain {
    Name name = {};
    Span where = {};
};
struct TimeUnit {
    Id<Expr> duration = {};
    Span where = {};
};
/// `NAME = VALUE` in an instance.
struct Argument {
    Name parameter = {};
    Id<Expr> value = {};
    Span where = {};
};
struct Instance {
    bool environment = false;
    Name name = {};
    Name component = {};
    std::vector<Argument> arguments = {};
    Name initial = {};
    Span where = {};
};
struct Property {
    Name name = {};
    std::string text = {};
    bool expected_violated = false;
    Pattern pattern = Pattern::Always;
    std::vector<Id<Expr>> operands = {};
    Sentence watch = {};  ///< of Pattern::Watched; its duration or count is `bound`
    Id<Expr> bound = {};  ///< not valid: it has none
    std::string raw = {};
    Span raw_where = {};  ///< with its quotes
    bool at_stable = false;
    Span where = {};
};
struct Schedule {
    Name name = {};
    Span where = {};
};
struct ObserverEdge {
    Name from = {}, to = {};
    Id<Expr> condition = {};
    std::vector<Assignment> assignments = {};  ///< refused by the reader
    Span where = {};
};
using ObserverItem = std::variant<Location, ObserverEdge>;
struct Observer {
    Name name = {};
    std::vector<ObserverItem> items = {};
    Span where = {};
};

using LoopItem =
    std::variant<Controller, Variables, Grain, TimeUnit, Schedule, Instance, Property, Constraint, Observer, Accept>;

struct ClosedLoop {
    Name name = {};
    std::vector<LoopItem> items = {};
    Span where = {};
    bool broken = false;
};

// -- files ------------------------------------------------------------------------------------------------------------

struct Include {
    std::string path = {};
    Span where = {};
};
using Declaration = std::variant<Include, Chart, Component, ClosedLoop>;

struct File {
    Id<Source> source = {};
    Table<Word> words = {};
    Table<Expr> exprs = {};
    std::vector<Declaration> declarations = {};
    std::vector<Comment> comments = {};    ///< in order of position
    std::vector<std::uint32_t> gaps = {};  ///< where the first thing after a blank line begins; in order
    bool broken = false;                   ///< a syntax error lies within some declaration, or between them
    bool lost = false;                     ///< a declaration is missing altogether, for an error in its head

    std::string_view text(Name name) const { return words[name.word].text; }
    std::string_view text(Id<Word> word) const { return words[word].text; }
};

Span where(const Declaration& declaration);

/// Interns words into the table of a file that has none yet: the parser's, and that of printers, which build trees.
class Words {
public:
    explicit Words(Table<Word>& words) : words_(&words) {}
    Id<Word> intern(std::string_view text);

private:
    void grow();

    Table<Word>* words_;
    std::vector<std::size_t> hashes_ = {};   ///< of each word
    std::vector<std::uint32_t> slots_ = {};  ///< open addressing: index into words_ plus one, 0 is free
};

/// Appends `operand` to the operands of `node`.
void append(Table<Expr>& exprs, Id<Expr> node, Id<Expr> operand);

}  // namespace grafverif::tree
