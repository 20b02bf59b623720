// SPDX-License-Identifier: MIT
// program::Reader resolves names and checks types of Structured Text and Sequential Function Charts. Separate files
// handle declarations, types, names, expressions, functions, statements, calls, and the charts of the standard and of
// CODESYS.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <tuple>
#include <unordered_map>
#include <utility>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "ir/program/program.hpp"
#include "read/program/charts.hpp"
#include "syntax/resolve/references.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif::program {

using Node = Program::Node;
using Type = Program::Type;
using Unit = Program::Unit;
using Statement = Program::Statement;
using Variable = Program::Variable;

inline bool is_number(const Type& type) { return type.kind == Type::Kind::Integer; }
inline std::string quoted(std::string_view text) { return "`" + std::string(text) + "`"; }

class Reader {
public:
    /// `charts` contains one element for each unit of the file.
    Reader(st::File& file, const Sources& sources, Diagnostics& diagnostics, std::vector<UnitCharts> charts,
           const Recorder& record);

    /// Reads all declarations and bodies. `user` is the number of units in the file of the user; the standard units
    /// follow these units.
    void read(std::size_t user);
    /// Reads a Boolean expression over the variables of the main program and of its instances.
    std::optional<Id<Node>> condition(Id<st::Expr> root);

    Program program = {};
    Diagnostics* diagnostics;

private:
    /// A typed expression. `literal` is true for an integer without a type, which adapts to the type of other operands.
    struct Typed {
        Id<Node> node = {};
        bool literal = false;
    };
    using MaybeTyped = std::optional<Typed>;

    /// A resolved variable: its memory cell, type and declaration.
    struct Found {
        Program::Place place = {};
        Id<Type> type = {};
        Variable* variable = nullptr;  ///< the declaration in its unit
        Variable* instance = nullptr;  ///< the instance that contains the variable, or null
        Id<Unit> block = {};           ///< the type of the instance
        bool inside = false;           ///< true if the variable belongs to an instance
        bool locked = false;           ///< true if statements of this unit cannot assign the variable
        bool constant = false;
    };
    /// The target of a call statement.
    struct Callee {
        Program::Place place = {};
        Id<Unit> body = {};            ///< function block or action to execute
        Id<Unit> block = {};           ///< function block whose inputs the call can assign
        Variable* instance = nullptr;  ///< the instance of the block; nullptr for an action of this unit
    };
    struct Scope {
        std::unordered_map<std::uint32_t, std::uint32_t> variables =
            {};  ///< for each name: index in the variables of the unit
        std::unordered_map<std::uint32_t, Span> externals = {};
        std::unordered_map<std::uint32_t, Id<Unit>> actions = {};       ///< actions that statements can call
        std::map<std::string, std::uint32_t, std::less<>> stored = {};  ///< CODESYS: cells of values that S stores
        /// Key: name of a step or action, and name of a member. Value: index in the variables of the unit. This table
        /// is separate from `variables`, because a variable may have the name of a step.
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> members = {};
    };
    enum class State { New, Open, Done };
    static constexpr std::uint32_t ambiguous_member = 0xffffffff;  ///< the step name occurs in several charts

    // Defined in declarations.cpp:
    void index_types();
    void declare_types();
    void declare_type(std::size_t index);
    void declare_structure(const st::TypeDeclaration& declaration);
    std::optional<Id<Type>> array(const st::Type& type, Span where);
    std::optional<Id<Type>> subrange(const st::Type& type, Span where);
    void declare_actions(std::size_t index);
    std::optional<std::size_t> main_block(std::size_t user) const;
    void declare_names(std::size_t user);
    void declare_units();
    void declare(std::size_t index);
    void declare_variables(Id<Unit> unit, const std::vector<st::Variable>& variables, bool is_program);
    void declare(Id<Unit> unit, const st::Variable& variable, bool is_program);
    bool is_allowed(const Unit& unit, const st::Variable& variable, Id<Type> type, bool is_program);
    void check_addresses(const std::vector<const st::Variable*>& located);
    std::optional<Id<Type>> type_of(const st::Type& type, Span where);
    std::optional<Id<Type>> enumeration(std::string_view name, const st::Type& type, Span where);
    std::optional<std::int64_t> constant(Id<st::Expr> expr, Id<Type> type);
    void choose_main(std::size_t user);
    void task_of(const st::Instance& instance);
    void check_calls();
    void read_body(std::size_t index);
    void warn_once(std::string_view what, std::string_view reading, Span where);

    // Defined in chart.cpp:
    void declare_chart(std::size_t index);
    Id<Type> step_type(bool initial);
    std::uint32_t add_cells(Id<Unit> unit, std::string shown, Id<Type> type, Span where,
                            Variable::Section section = Variable::Section::Local);
    std::uint32_t add_cells(Id<Unit> unit, st::Name name, std::array<std::string_view, 2> members, Id<Type> type);
    std::optional<Found> chart_member(Id<st::Expr> path);
    // Defined in codesys_chart.cpp:
    void declare_codesys(std::size_t index, Chart& chart, const st::Network& network, const std::string& prefix);
    Program::Body codesys_chart(Chart& chart, const st::Network& network);
    void reset(const Chart& chart, const st::Network& network, Program::Body& body);
    void execute_steps(const Chart& chart, const st::Network& network, Program::Body& body);
    Id<Type> codesys_step_type(bool initial);
    std::optional<Found> step_of_chart(Id<st::Expr> path);
    std::uint32_t control_cell(const ChartAction& action, std::string_view name);
    void control_codesys(std::size_t action, const std::vector<Id<st::Word>>& steps, const Chart& chart,
                         Program::Body& body);
    void execute_actions(const Chart& chart, Program::Body& body);
    void evaluate_transitions(const Chart& chart, const st::Network& network, Program::Body& body);
    void execute_action(Id<st::Expr> path, Program::Body& body);
    std::optional<Found> flag_of(std::string_view name, bool stated, bool used, Span where);

    Program::Body chart(std::size_t index);
    Program::Sequence sequence_of(const st::Network& network, const std::vector<std::uint32_t>& cells) const;
    void evolve(const st::Network& network, const Chart& chart, Program::Body& body);
    void control(const Chart& chart, std::size_t action, Program::Body& body);
    void execute(const ChartAction& action, Program::Body& body);
    Id<Node> read(std::uint32_t cell, Id<Type> type, Span where);
    Id<Node> flag(Id<st::Word> step, Span where) { return read(cell_of(step), bool_, where); }
    Id<Node> all(Program::Op op, std::vector<Id<Node>> operands, Span where);
    void store(std::uint32_t cell, Id<Type> type, Id<Node> value, Span where, Program::Body& body);
    void add_if(std::vector<Program::Arm> arms, Span where, Program::Body& body);
    std::uint32_t cell_of(Id<st::Word> step) const;
    void check(Id<Node> fault, Span where, Program::Body& body);
    void check_transitions(const st::Network& network, const Chart& chart, const std::vector<std::uint32_t>& steps,
                           Program::Body& body);
    void check_durations(const Chart& chart, std::size_t action, const std::vector<Id<Node>>& active,
                         Program::Body& body);
    std::array<MaybeTyped, 2> compared(const std::vector<Id<st::Expr>>& sides);
    void limit_step_time(const Found& read);

    // Defined in expressions.cpp:
    MaybeTyped expression(Id<st::Expr> id);
    MaybeTyped leaf(Id<st::Expr> id);
    MaybeTyped as_bits(const Typed& value, Span where);
    MaybeTyped value_at(const Found& found, Span where);
    MaybeTyped junction(Id<st::Expr> id);
    MaybeTyped shift(Id<st::Expr> id, Program::Op op);
    MaybeTyped time_arithmetic(const st::Expr& from, Program::Op op, std::vector<Typed> operands);
    std::optional<Id<Node>> condition_of(Id<st::Expr> root);
    MaybeTyped comparison(Id<st::Expr> id);
    MaybeTyped arithmetic(Id<st::Expr> id);
    MaybeTyped call(Id<st::Expr> id);
    MaybeTyped standard_function(Id<st::Expr> id, const std::string& name);
    MaybeTyped conversion(Id<st::Expr> id, const std::string& name);
    MaybeTyped user_function(Id<st::Expr> id, std::size_t index);
    std::vector<Typed> arguments(Id<st::Expr> call, std::size_t least, std::size_t most, bool& ok);
    bool unify(std::vector<Typed>& operands, Span where);
    /// Converts `value` to `type`. `what` describes the value in error messages.
    std::optional<Id<Node>> converted(const Typed& value, Id<Type> type, Span where, std::string_view what);
    std::optional<Found> variable(Id<st::Expr> path);
    std::optional<Found> named(Id<st::Word> word, Span where);
    std::optional<Found> element(Id<st::Expr> path);
    std::optional<Found> member(Id<st::Expr> path);
    std::optional<std::optional<Found>> qualified(Id<st::Expr> path);
    Found found_in(Id<Unit> unit, std::uint32_t index);
    Program::Place main_place(std::uint32_t offset) const;
    bool is_main(Id<st::Word> word) const;
    Id<Node> add(Program::Op op, Id<Type> type, std::vector<Id<Node>> operands, Span where);
    Id<Node> number(std::int64_t value, Id<Type> type, Span where);
    std::optional<std::int64_t> value_of(Id<Node> node) const;
    bool boolean(const Typed& value) const { return type(value).kind == Type::Kind::Boolean && !value.literal; }
    const Type& type(const Typed& value) const { return program.types[program.nodes[value.node].type]; }
    std::string described(const Typed& value) const;

    // Defined in statements.cpp:
    Program::Body block(const st::Block& statements);
    void statement(Id<st::Statement> id, Program::Body& body);
    void assign(const Found& target, const Typed& value, Span where, Program::Body& body);
    std::optional<Found> target(Id<st::Expr> path);
    void invoke(Id<st::Expr> call, Program::Body& body);
    std::optional<Callee> callee(Id<st::Expr> path);
    std::optional<Callee> action(Id<st::Expr> path);
    bool is_composite(Id<Type> type) const;
    bool is_elementary(Id<Type> type) const;
    void copy(const Found& to, const Found& from, Span where, Program::Body& body);
    void copy_cells(Program::Place to, Program::Place from, Id<Type> type, Span where, Program::Body& body);
    std::optional<Found> pass_in_out(const Found& formal, Id<st::Expr> actual, Program::Body& before,
                                     Program::Body& after);
    bool is_open() const { return any_member_ || file_->dialect == st::Dialect::Codesys; }
    static Program::Place shifted(Program::Place place, std::uint32_t offset) {
        place.offset += offset;
        return place;
    }
    void if_statement(const st::Statement& from, Program::Body& body);
    void case_statement(const st::Statement& from, Program::Body& body);
    void label(Id<st::Expr> expr, Id<Type> type, Program::Arm& arm);
    void for_statement(const st::Statement& from, Program::Body& body);

    std::string text(Id<st::Word> word) const { return std::string(file_->text(word)); }
    /// Returns a name as it is written at `where` or, if `where` contains another text, at its first occurrence.
    std::string written(Id<st::Word> word, Span where) const;
    std::string capitals(Id<st::Word> word) const { return st::capitals(file_->text(word)); }
    void reject(Span where, std::string_view what, std::string_view hint);

    // Defined in record.cpp:
    void record_unit(const st::Unit& from) const;
    void record_values(std::string_view name, const st::Type& type) const;
    void record_type_name(const st::Type& type) const;
    void record_variable(Id<Unit> unit, const st::Variable& from, std::optional<Id<Type>> type) const;
    void record_chart(std::size_t index);
    void record_association(const st::Unit& unit, const st::Association& association) const;
    void refer(const st::Expr& use, Span declaration, bool writes = false) const;
    void refer_target(Id<st::Expr> path, Span declaration) const;

    st::File* file_;
    const Sources* sources_;
    Recorder record_;
    std::unordered_map<std::uint32_t, std::size_t> units_ = {};  ///< for each name: index of the unit
    std::vector<Id<Unit>> declared_ = {};                        ///< for each unit of the file: its unit in the program
    std::vector<State> states_ = {};
    std::unordered_map<std::uint32_t, Id<Type>> types_ = {};                 ///< types by name
    std::unordered_map<std::uint32_t, std::size_t> type_declarations_ = {};  ///< for each name: first declaration
    std::size_t type_depth_ = 0;           ///< number of types whose declarations are being read
    std::vector<State> type_states_ = {};  ///< for each type declaration of the file: its state
    struct EnumerationValue {
        Id<Type> type = {};
        std::int64_t value = 0;
        Span origin = {};
    };
    std::map<std::uint32_t, EnumerationValue> values_ = {};  ///< values of enumerations, by name
    std::vector<Scope> scopes_ = {};                         ///< for each unit of the program: its scope
    std::vector<std::vector<std::uint32_t>> calls_ = {};     ///< for each unit: the units that it calls
    Id<Unit> unit_ = {};                                     ///< the current unit
    Id<Unit> body_ = {};       ///< the unit whose body is being read: the current unit, or one of its actions
    bool any_member_ = false;  ///< true if local variables of instances can be read
    int loops_ = 0;
    /// While transitions of a CODESYS chart are read: the steps of the chart and their indices in the variables of the
    /// unit.
    const std::vector<std::pair<Id<st::Word>, std::uint32_t>>* transitions_ = nullptr;
    std::vector<UnitCharts> charts_;                  ///< for each unit of the file: its charts
    std::array<Id<Type>, 2> step_types_ = {};         ///< type of steps, type of initial steps
    std::array<Id<Type>, 2> codesys_steps_ = {};      ///< type of steps and type of initial steps in charts of CODESYS
    std::set<std::string, std::less<>> warned_ = {};  ///< warnings that have been reported, to avoid repetition
    std::optional<std::size_t> main_block_ = {};      ///< the function block that is executed as a program
    std::set<std::uint32_t> chart_units_ = {};        ///< units of steps and ACTION_CONTROL blocks
    bool action_ = false;                             ///< true within the body of an action
    std::optional<std::int64_t> compared_time_ = {};  ///< bound for the duration in the current comparison
    Id<Type> bool_ = {}, int_ = {}, dint_ = {}, time_ = {};
    std::map<std::tuple<std::uint32_t, std::int64_t, std::int64_t>, Id<Type>> arrays_ =
        {};  ///< array type by element type, first and last index
};

}  // namespace grafverif::program
