// SPDX-License-Identifier: MIT
// st_tree: abstract syntax of Structured Text and of textual Sequential Function Charts (IEC 61131-3), before name
// resolution. The importers use this tree. Tests also use it to parse exported text.
//
// Names are case-insensitive. Two names in one file are equal if and only if their word ids are equal. A word is
// displayed as spelt at its first occurrence. Expressions and statements are stored in flat tables. The operands of an
// expression form a linked list.
#pragma once

#include <array>
#include <cstdint>
#include <string>
#include <string_view>
#include <unordered_map>
#include <vector>

#include "grafverif/support/source.hpp"
#include "grafverif/support/table.hpp"

namespace grafverif::st {

struct Word {
    std::string text = {};
};

struct Name {
    Id<Word> word = {};
    Span where = {};
    bool valid() const { return word.valid(); }
};

enum class Op : std::uint8_t {
    False,
    True,
    Integer,
    Time,   // literals with an integer `value`: Integer, and Time in milliseconds
    Other,  // literal of any other type, with its text in `word`
    Name,
    Member,
    Address,  // Member: operand `.` word; Address: `%IX0.0`
    Index,
    Dereference,  // operands: the indexed operand and its indices; the dereferenced operand
    Call,
    Argument,
    Result,  // Call: callee, then arguments, which may be `formal := value` or `formal => variable`
    Range,   // range `1..4` in a label of CASE
    Not,
    Negate,
    Power,
    Times,
    Divide,
    Modulo,
    Plus,
    Minus,
    Less,
    LessEqual,
    Greater,
    GreaterEqual,
    Equal,
    NotEqual,
    And,
    Xor,
    Or,
    AndThen,
    OrElse,
};

struct Expr {
    Op op = Op::False;
    std::uint16_t depth = 1;
    Id<Word> word = {};  ///< word of Name, Member, Address, Other, Argument, Result
    std::int64_t value = 0;
    Id<Expr> first = {}, last = {}, next = {};  ///< first and last operand, next sibling
    Span where = {};
    Span name = {};  ///< position of `word`
};

struct Statement;
using Block = std::vector<Id<Statement>>;

/// A branch of a statement: `IF`, `ELSIF`, `ELSE` or a label of `CASE`, with its statements. `ELSE` has no conditions.
struct Branch {
    std::vector<Id<Expr>> conditions = {};
    Block body = {};
    Span where = {};
};

enum class StatementKind : std::uint8_t { Assign, Call, If, Case, For, While, Repeat, Return, Exit };

struct Statement {
    StatementKind kind = StatementKind::Return;
    Id<Expr> target = {};               ///< target of Assign
    Id<Expr> value = {};                ///< Assign: value; Call: call; Case: selector; While, Repeat: condition
    std::vector<Branch> branches = {};  ///< branches of If and Case, or the body of a loop
    Span where = {};
    /// For a statement For, whose variable is `target`: first value, last value, step (may be invalid).
    std::array<Id<Expr>, 3> range = {};
};

struct Comment {
    std::string text = {};  ///< text of the comment, including its delimiters
    Span where = {};
};

enum class Section : std::uint8_t { Input, Output, InOut, Local, External, Global, Temporary };

/// A type such as `INT`, `INT (0..10)` or `(RED, GREEN)`. `composite` is true for an array, a pointer, a structure or
/// an enumeration.
struct Type {
    Name name = {};
    Id<Expr> low = {}, high = {};
    bool composite = false;
    std::vector<Name> values = {};  ///< values of an enumeration; `name` is the name of the first value

    /// For an array: first and last index of each dimension. The elements have the type `name`.
    std::vector<std::array<Id<Expr>, 2>> dimensions = {};
};

/// The qualifiers of a VAR section. PERSISTENT has the same meaning as RETAIN.
struct Qualifiers {
    bool constant = false, retain = false;
    friend Qualifiers operator|(Qualifiers a, Qualifiers b) { return {a.constant || b.constant, a.retain || b.retain}; }
};

struct Variable {
    Section section = Section::Local;
    bool constant = false, retain = false;
    Name name = {};
    Type type = {};
    Id<Expr> initial = {};
    std::string address = {};  ///< `%IX0.0`, or empty
    std::string comment = {};  ///< text without delimiters
    Span where = {};
};

/// One declaration in a TYPE section.
struct TypeDeclaration {
    Name name = {};
    Type type = {};
    Id<Expr> initial = {};
    bool structure = false;
    Span where = {};
    std::vector<Variable> members = {};  ///< members of a structure; empty for other types
};

struct Task {
    Name name = {};
    std::vector<Id<Expr>> arguments = {};
    Span where = {};
};

/// A program instance `PROGRAM NAME WITH TASK : TYPE (ARGUMENTS);`.
struct Instance {
    Name name = {}, task = {}, type = {};
    std::vector<Id<Expr>> arguments = {};
    Span where = {};
};

// -- Sequential Function Charts ---------------------------------------------------------------------------------------

/// An action block: `NAME (QUALIFIER, TIME);` in a step.
struct Association {
    Name action = {};             ///< an action or a Boolean variable; invalid if `body` contains the statements
    Id<Expr> path = {};           ///< in CODESYS: the action as an expression, which may name an instance
    std::string qualifier = "N";  ///< in capitals
    Id<Expr> time = {};
    Block body = {};
    Span where = {};
    bool unread = false;  ///< true if the file has further arguments, which are ignored
};

struct Step {
    bool initial = false;
    Name name = {};
    std::vector<Association> actions = {};
    std::string comment = {};
    Span where = {};  ///< from the keyword to the name
    Span whole = {};  ///< from the keyword to END_STEP; without source in a drawing

    /// In CODESYS: the actions on activation (`entry`), while the step is active (`active`), and on deactivation
    /// (`exit`). Each of these actions can be an action of an instance.
    Id<Expr> entry = {}, active = {}, exit = {};
};

/// A transition. If several transitions leave one step, the controller evaluates them in the order of `priority`;
/// transitions with equal priority are evaluated in the order of their positions.
struct Transition {
    Name name = {};             ///< invalid if omitted
    std::int64_t priority = 0;  ///< 0 if omitted
    std::vector<Name> from = {}, to = {};
    Id<Expr> condition = {};  ///< invalid if omitted or unreadable
    std::string comment = {};
    Span where = {};
};

/// Settings of a chart in CODESYS: the implicit variables that control the chart. `init`, `reset` and `pause` are true
/// if the chart uses SFCInit, SFCReset and SFCPause.
struct ChartFlags {
    bool stated = false;  ///< true if the file contains settings
    bool init = false, reset = false, pause = false;
    std::string others = {};  ///< name of another implicit variable in use, or empty
};

/// The steps and transitions of a chart, or of the expansion of a macro-step.
struct Network {
    Name macro_step = {};  ///< macro-step of which this network is the expansion; invalid for the chart itself
    std::vector<Step> steps = {};
    std::vector<Transition> transitions = {};
    Span where = {};
    ChartFlags flags = {};
};

struct Action {
    Name name = {};
    Block body = {};
    bool opaque = false;                 ///< true if the body is in another language
    Span where = {};                     ///< from the keyword to the name
    Span whole = {};                     ///< from the keyword to END_ACTION; without source in PLCopen XML
    std::vector<Network> networks = {};  ///< the chart that forms the body
};

enum class UnitKind : std::uint8_t { Program, FunctionBlock, Function };

struct Unit {
    UnitKind kind = UnitKind::Program;
    Name name = {};
    std::vector<Variable> variables = {};
    std::vector<Network> networks = {};  ///< the chart and its macro expansions; empty if the body is not a chart
    std::vector<Action> actions = {};
    Block body = {};   ///< statements in Structured Text outside of a chart
    Type result = {};  ///< return type of a function
    std::string comment = {};
    Span where = {};
};

/// Selects the rules for the execution of charts and for the visibility of variables.
enum class Dialect : std::uint8_t { Standard, Codesys };

struct File {
    Id<Source> source = {};
    Dialect dialect = Dialect::Standard;
    Table<Word> words = {};
    std::unordered_map<std::string, Id<Word>> index = {};  ///< ids of words, indexed by their upper-case form
    Table<Expr> exprs = {};
    Table<Statement> statements = {};
    std::vector<Variable> globals = {};
    std::vector<Name> global_lists = {};  ///< names of the lists in `globals`, which can qualify variables
    std::vector<Unit> units = {};
    std::vector<TypeDeclaration> types = {};
    std::vector<Task> tasks = {};
    std::vector<Instance> instances = {};
    std::vector<Comment> comments = {};

    Id<Word> intern(std::string_view text);
    std::string_view text(Id<Word> word) const { return words[word].text; }
    std::string_view text(Name name) const { return words[name.word].text; }
};

/// Returns the upper-case form of a name or keyword, which is used for comparisons.
std::string capitals(std::string_view text);

void append(Table<Expr>& exprs, Id<Expr> node, Id<Expr> operand);
/// Returns the operands of `node`, in order.
std::vector<Id<Expr>> operands(const File& file, Id<Expr> node);

}  // namespace grafverif::st
