// SPDX-License-Identifier: MIT
// tree: abstract syntax of a .grafcet file before name resolution. The parser passes the tree to name resolution, and
// the command `fmt` prints it; later stages do not use the tree.
//
// Names are interned: two names in one file are equal if and only if their word ids are equal. Expressions are stored
// in one flat table. The operands of a node form a linked list, so that a node with any number of operands needs no
// separate allocation. Every node and declaration has a span. Comments and blank lines are stored outside the tree,
// ordered by position.
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

struct Expr;

/// An occurrence of a name; invalid if an optional name is missing.
struct Name {
    Id<Word> word = {};
    Span where = {};         ///< span of the name without its indices
    Id<Expr> index = {};     ///< first index of a name such as `FULL[i]`; invalid if there is none
    std::uint32_t copy = 0;  ///< copy of a replicated declaration: index in `File::copies` plus one
    bool valid() const { return word.valid(); }
};

enum class Op : std::uint8_t {
    False,
    True,
    Number,
    Duration,
    Name,    // a name, `word`; the operands are its indices
    Member,  // `OWNER.word`; the first operand is the owner, the others are indices
    In,      // `OWNER in word`; the operands are those of a Member
    All,     // operands of All, Any, Each: index variable (a Name), lowest and greatest value, term
    Any,
    Each,  // in a list: one element for each value of the index variable
    Not,
    Rise,
    Fall,
    Negate,
    And,
    Or,  // And, Or: two or more operands
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
    bool bracketed = false;  ///< true if the source has brackets around the expression
    std::uint16_t depth = 1;
    Id<Word> word = {};                         ///< word of Name, Member, In
    std::int64_t value = 0;                     ///< value of Number; of Duration in milliseconds
    std::uint16_t unit_ms = 0;                  ///< unit of a Duration in the source text; 0 if there is no source text
    Id<Expr> first = {}, last = {}, next = {};  ///< first and last operand, next sibling
    Span where = {};
};

/// A comment `// ...` or `/* ... */`, including the delimiters but without the line end.
struct Comment {
    std::string text = {};
    Span where = {};
    bool own_line = false;  ///< true if only white space precedes the comment on its line
};

struct Range {
    Id<Expr> low = {}, high = {};
};

/// The range of an index variable: `i in 1..4`.
struct Replication {
    Name index = {};
    Range range = {};
    Span where = {};
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

enum class VariableKind { Input, Output, Internal, Own, Constant };  ///< Own: a `variable` of a component
struct Variables {
    VariableKind kind = VariableKind::Input;
    std::vector<Variable> variables = {};
    Span where = {};
};

struct Constraint {
    Id<Expr> condition = {};
    Span where = {};
    std::uint32_t copy = 0;  ///< see Name::copy
};

/// An assignment `target := value`.
struct Assignment {
    Name target = {};
    Id<Expr> value = {};
    Span where = {};
};

/// An argument `NAME = VALUE` of an instance of a chart or component.
struct Argument {
    Name parameter = {};
    Id<Expr> value = {};
    Span where = {};
};

// -- charts ----------------------------------------------------------------------------------------------------------

struct ContinuousAction {
    Name output = {};
    Id<Expr> condition = {};  ///< term after `if`
    Id<Expr> delay = {};      ///< duration after `after`
    Id<Expr> limit = {};      ///< duration after `for`
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
    /// For a macro-step, the name of its expansion; for an enclosing step, the names of the partial charts that it
    /// encloses.
    std::vector<Name> contents = {};
    std::vector<Action> actions = {};
    Span where = {};
};

struct Transition {
    Name name = {};  ///< invalid if omitted
    std::vector<Name> from = {}, to = {};
    Id<Expr> condition = {};  ///< invalid if omitted
    std::vector<Assignment> assignments = {};
    Span where = {};
};

/// The declaration `accept CODE SUBJECT "reason";`.
struct Accept {
    std::string code = {};
    std::string subject = {};  ///< empty if omitted
    std::string reason = {};
    Span where = {};
    Span subject_where = {};
};

struct Partial;
struct ReplicatedChartItems;
using ChartItem = std::variant<Variables, Constraint, Accept, Step, Transition, Partial, ReplicatedChartItems>;

enum class PartialKind { Partial, Expansion };
/// A partial chart. An instance `partial NAME = CHART(...);` has a chart and arguments instead of items.
struct Partial {
    PartialKind kind = PartialKind::Partial;
    Name name = {};
    std::vector<ChartItem> items;  // without an initializer, because ReplicatedChartItems is incomplete here
    Span where = {};
    Name chart = {};  ///< the chart of an instance; otherwise invalid
    std::vector<Argument> arguments = {};
    std::vector<Variables> ports = {};  ///< set by name resolution: inputs and outputs of `chart` with their variables
};

/// Declarations that are repeated for each value of an index variable: `for i in 1..4 { ... }`.
struct ReplicatedChartItems {
    Replication replication = {};
    std::vector<ChartItem> items = {};
    Span where = {};
};

struct Chart {
    Name name = {};
    std::vector<ChartItem> items = {};
    Span where = {};
    bool broken = false;      ///< true if the declaration contains a syntax error
    bool replicated = false;  ///< true if the declaration contains replications, which syntax/resolve/expand replaces
    std::vector<Variables> parameters = {};
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
struct ReplicatedComponentItems;
using ComponentItem = std::variant<Variables, Constraint, Clocks, Location, Edge, ReplicatedComponentItems>;
struct ReplicatedComponentItems {
    Replication replication = {};
    std::vector<ComponentItem> items = {};
    Span where = {};
};

struct Component {
    Name name = {};
    std::vector<Variables> parameters = {};
    std::vector<ComponentItem> items = {};
    Span where = {};
    bool broken = false;
    bool replicated = false;
};

// -- closed loops -----------------------------------------------------------------------------------------------------

/// Task cycle of a controller: the time between two scans, from `least` to `most`. `most` is invalid if the time is
/// fixed; both ids are invalid if the controller has no task cycle.
struct TaskCycle {
    Id<Expr> least = {}, most = {};
    Span where = {};
};
/// A controller: `controller CHART;` or `controller NAME = CHART(...);`.
struct Controller {
    Name chart = {};
    TaskCycle cycle = {};
    std::vector<Name> options = {};
    Span where = {};
    Name instance = {};  ///< name of the instance; invalid in `controller CHART;`
    std::vector<Argument> arguments = {};
    Name name() const { return instance.valid() ? instance : chart; }
};
struct Grain {
    Name name = {};
    Span where = {};
};
struct TimeUnit {
    Id<Expr> duration = {};
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
/// A declaration `fault NAME of INSTANCE: COMPONENT(...)`. `behaviour` contains NAME, COMPONENT and the arguments.
struct Fault {
    Name of = {};
    Instance behaviour = {};
    Span where = {};
};
struct Property {
    Name name = {};
    std::string text = {};
    bool expected_violated = false;
    Pattern pattern = Pattern::Always;
    std::vector<Id<Expr>> operands = {};
    Sentence watch = {};  ///< only for Pattern::Watched
    Id<Expr> bound = {};  ///< duration or count in the property; invalid if it has neither
    std::string raw = {};
    Span raw_where = {};  ///< position including the quotes
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
    std::vector<Assignment> assignments = {};  ///< invalid; name resolution reports the assignments
    Span where = {};
};
using ObserverItem = std::variant<Location, ObserverEdge>;
struct Observer {
    Name name = {};
    std::vector<ObserverItem> items = {};
    Span where = {};
};

struct ReplicatedLoopItems;
using LoopItem = std::variant<Controller, Variables, Grain, TimeUnit, Schedule, Instance, Fault, Property, Constraint,
                              Observer, Accept, ReplicatedLoopItems>;
struct ReplicatedLoopItems {
    Replication replication = {};
    std::vector<LoopItem> items = {};
    Span where = {};
};

struct ClosedLoop {
    Name name = {};
    std::vector<LoopItem> items = {};
    Span where = {};
    bool broken = false;
    bool replicated = false;
};

// -- files ------------------------------------------------------------------------------------------------------------

struct Include {
    std::string path = {};
    Span where = {};
};
/// `program NAME = "FILE";` declares a PLC program.
struct PlcProgram {
    Name name = {};
    std::string path = {};
    Span path_where = {};  ///< position including the quotes
    Span where = {};
};
using Declaration = std::variant<Include, Chart, Component, ClosedLoop, PlcProgram>;

/// A copy of the declarations in a replication, or of the declarations of a chart in an instance.
struct Copy {
    Id<Word> index = {};  ///< name of the index variable or of the instance
    std::int64_t value = 0;
    Span where = {};           ///< position of the replication or of the instance
    std::uint32_t outer = 0;   ///< the enclosing copy: index plus one; 0 if there is none
    bool is_instance = false;  ///< true for an instance of a chart; `value` then has no meaning
    bool in_instance = false;  ///< true for an instance and for the copies in the instance
};

struct File {
    Id<Source> source = {};
    Table<Word> words = {};
    Table<Expr> exprs = {};
    std::vector<Declaration> declarations = {};
    std::vector<Comment> comments = {};    ///< comments in order of position
    std::vector<std::uint32_t> gaps = {};  ///< offset of the first element after each blank line, increasing
    bool broken = false;                   ///< true if the file contains a syntax error
    bool incomplete = false;               ///< true if a declaration is missing because of an error in its head
    std::vector<Copy> copies = {};         ///< added by name resolution (syntax/resolve/expand)

    std::string_view text(Name name) const { return words[name.word].text; }
    std::string_view text(Id<Word> word) const { return words[word].text; }
};

Span where(const Declaration& declaration);

/// Calls `visit` for each declaration of a closed loop, including declarations in replications. A declaration in a
/// replication is visited only once.
template <class Visit>
void each_item(const std::vector<LoopItem>& items, const Visit& visit) {
    for (const LoopItem& item : items)
        if (const auto* replicated = std::get_if<ReplicatedLoopItems>(&item)) each_item(replicated->items, visit);
        else visit(item);
}

/// Interns words into the table of words of a file. Requires that the table is empty. The parser and functions that
/// build trees use this class.
class Words {
public:
    explicit Words(Table<Word>& words) : words_(&words) {}
    Id<Word> intern(std::string_view text);

private:
    void grow();

    Table<Word>* words_;
    std::vector<std::size_t> hashes_ = {};   ///< hash of each word
    std::vector<std::uint32_t> slots_ = {};  ///< open addressing: index into words_ plus one; 0 is free
};

/// Returns the index variable and range of an All, Any or Each node.
Replication replication(const File& file, const Expr& node);

/// Appends `operand` to the operands of `node`.
void append(Table<Expr>& exprs, Id<Expr> node, Id<Expr> operand);

}  // namespace grafverif::tree
