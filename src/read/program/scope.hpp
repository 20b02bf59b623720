// SPDX-License-Identifier: MIT
// program::Reader: resolves names and checks types of Structured Text and Sequential Function Charts. Its functions are
// in four files: declarations, expressions, statements and charts.
#pragma once

#include <array>
#include <map>
#include <optional>
#include <set>
#include <string>
#include <string_view>
#include <unordered_map>
#include <utility>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"
#include "ir/program/program.hpp"
#include "read/program/charts.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif::program {

using Node = Program::Node;
using Type = Program::Type;
using Unit = Program::Unit;
using Statement = Program::Statement;
using Variable = Program::Variable;

class Reader {
public:
    /// `charts` contains one chart for each unit of the file.
    Reader(st::File& file, const Sources& sources, Diagnostics& diagnostics, std::vector<Chart> charts);

    /// `user` is the number of units of the user, which precede the standard ones.
    void read(std::size_t user);
    /// Reads a Boolean expression over the variables of `main` and of its instances.
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

    /// A variable together with the cell that it denotes.
    struct Found {
        Program::Place place = {};
        Id<Type> type = {};
        Variable* variable = nullptr;  ///< variable of its unit
        Variable* instance = nullptr;  ///< instance that contains it, if it was named through the instance
        bool inside = false;           ///< true if it was named through an instance
    };
    struct Scope {
        std::unordered_map<std::uint32_t, std::uint32_t> variables =
            {};  ///< word -> index in the variables of the unit
        std::unordered_map<std::uint32_t, Span> externals = {};
        /// Step or action, and member -> index in the variables. A variable may have the name of a step.
        std::map<std::pair<std::uint32_t, std::uint32_t>, std::uint32_t> members = {};
    };
    enum class State { New, Open, Done };

    // Defined in declarations.cpp:
    void declare_types();
    void declare_units(std::size_t user);
    void declare(std::size_t index);
    void declare_variables(Id<Unit> unit, const std::vector<st::Variable>& variables, bool is_program);
    void declare(Id<Unit> unit, const st::Variable& variable, bool is_program);
    void check_addresses(const std::vector<const st::Variable*>& located);
    std::optional<Id<Type>> type_of(const st::Type& type, Span where);
    std::optional<Id<Type>> enumeration(std::string_view name, const st::Type& type, Span where);
    std::optional<std::int64_t> constant(Id<st::Expr> expr, Id<Type> type);
    void choose_main(std::size_t user);
    void task_of(const st::Instance& instance);
    void check_calls();

    // Defined in chart.cpp:
    void declare_chart(std::size_t index);
    Id<Type> step_type(bool initial);
    std::uint32_t add_cells(Id<Unit> unit, std::string shown, Id<Type> type, Span where,
                            Variable::Section section = Variable::Section::Local);
    std::uint32_t add_cells(Id<Unit> unit, st::Name name, std::array<std::string_view, 2> members, Id<Type> type);
    std::optional<Found> chart_member(Id<st::Expr> path);
    Program::Body chart(std::size_t index);
    void evolve(const st::Network& network, const Chart& chart, Program::Body& body);
    void control(const ChartAction& action, Program::Body& body);
    void execute(const ChartAction& action, Program::Body& body);
    Id<Node> read(std::uint32_t cell, Id<Type> type, Span where);
    Id<Node> flag(Id<st::Word> step, Span where) { return read(cell_of(step), bool_, where); }
    Id<Node> all(Program::Op op, std::vector<Id<Node>> operands, Span where);
    void store(std::uint32_t cell, Id<Type> type, Id<Node> value, Span where, Program::Body& body);
    void add_if(std::vector<Program::Arm> arms, Span where, Program::Body& body);
    std::uint32_t cell_of(Id<st::Word> step) const;
    std::array<MaybeTyped, 2> compared(const std::vector<Id<st::Expr>>& sides);
    void limit_step_time(const Found& read);

    // Defined in expressions.cpp:
    MaybeTyped expression(Id<st::Expr> id);
    MaybeTyped leaf(Id<st::Expr> id);
    MaybeTyped junction(Id<st::Expr> id);
    MaybeTyped comparison(Id<st::Expr> id);
    MaybeTyped arithmetic(Id<st::Expr> id);
    MaybeTyped call(Id<st::Expr> id);
    MaybeTyped standard_function(Id<st::Expr> id, const std::string& name);
    MaybeTyped conversion(Id<st::Expr> id, const std::string& name);
    MaybeTyped user_function(Id<st::Expr> id, std::size_t index);
    std::vector<Typed> arguments(Id<st::Expr> call, std::size_t least, std::size_t most, bool& ok);
    bool unify(std::vector<Typed>& operands, Span where);
    /// Returns `value` as a node of `type`. An error names `what`.
    std::optional<Id<Node>> converted(const Typed& value, Id<Type> type, Span where, std::string_view what);
    std::optional<Found> variable(Id<st::Expr> path);
    std::optional<Found> named(Id<st::Word> word, Span where);
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
    void if_statement(const st::Statement& from, Program::Body& body);
    void case_statement(const st::Statement& from, Program::Body& body);
    void label(Id<st::Expr> expr, Id<Type> type, Program::Arm& arm);
    void for_statement(const st::Statement& from, Program::Body& body);

    std::string text(Id<st::Word> word) const { return std::string(file_->text(word)); }
    std::string capitals(Id<st::Word> word) const { return st::capitals(file_->text(word)); }
    void reject(Span where, std::string_view what, std::string_view hint);

    st::File* file_;
    const Sources* sources_;
    std::unordered_map<std::uint32_t, std::size_t> units_ = {};  ///< word -> unit of the file
    std::vector<Id<Unit>> declared_ = {};                        ///< unit of the program per unit of the file
    std::vector<State> states_ = {};
    std::unordered_map<std::uint32_t, Id<Type>> types_ = {};                  ///< word -> type
    std::map<std::uint32_t, std::pair<Id<Type>, std::int64_t>> values_ = {};  ///< values of enumerations, by word
    std::vector<Scope> scopes_ = {};                                          ///< scope of each unit of the program
    std::vector<std::vector<std::uint32_t>> calls_ = {};                      ///< functions that each unit calls
    Id<Unit> unit_ = {};                                                      ///< the current unit
    bool any_member_ = false;  ///< true if local variables of instances can be read
    int loops_ = 0;
    std::vector<Chart> charts_;                       ///< chart of each unit of the file
    std::array<Id<Type>, 2> step_types_ = {};         ///< type of steps, type of initial steps
    std::set<std::uint32_t> chart_units_ = {};        ///< units of steps and action controls
    bool action_ = false;                             ///< true within the body of an action
    std::optional<std::int64_t> compared_time_ = {};  ///< duration with which the current operand is compared
    Id<Type> bool_ = {}, int_ = {}, dint_ = {}, time_ = {};
};

}  // namespace grafverif::program
