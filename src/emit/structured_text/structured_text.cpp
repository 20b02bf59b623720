// SPDX-License-Identifier: MIT
// Writes the declarations of the controller and its body.
#include "emit/structured_text/structured_text.hpp"

#include <fmt/format.h>

#include <limits>
#include <string>
#include <vector>

#include "emit/structured_text/body.hpp"
#include "emit/structured_text/unit.hpp"
#include "ir/interval.hpp"
#include "support/messages.hpp"

namespace grafverif::structured_text {

namespace {

using Role = Equations::Role;

std::string comment_of(const Equations& equations, const Names& names, const Options& options) {
    const bool search = options.mode == ExecutionMode::StabilitySearch;
    std::string text =
        fmt::format("{}: controller written by grafverif from the equations of the chart\n", equations.name);
    text +=
        "One call is one PLC cycle: call it once per cycle of its task, with inputs that do not change during the "
        "call.\n";
    text += search ? "With stability search: a call executes evolutions until the situation is stable, and then writes "
                     "the outputs.\n"
                   : "Without stability search: a call executes one evolution and writes the outputs.\n";
    text += fmt::format(
        "{} is the reason of a stop: {}2 race of stored actions, 3 value outside its range{}. After a stop, the "
        "outputs do not change.\n",
        names.fault, search ? "1 no stable situation, " : "",
        equations.conflicts.empty() ? "" : ", 4 forcing orders in conflict");
    for (const Renaming& renaming : names.changed) text += fmt::format("{} is {}\n", renaming.name, renaming.legal);
    return text;
}

const char* type_word(const Type& type) { return type.boolean ? "BOOL" : "DINT"; }

std::string literal(const Type& type, std::int64_t value) {
    if (type.boolean) return value != 0 ? "TRUE" : "FALSE";
    return std::to_string(value);
}

std::string comment_of(const Equations::Variable& variable) {
    if (variable.type.boolean || variable.role == Role::TimerEnd) return {};
    return fmt::format("{} to {}", variable.type.low, variable.type.high);
}

class Declarations {
public:
    Declarations(const Equations& equations, const Names& names, const Body& body)
        : equations_(equations), names_(names), body_(body) {}

    std::vector<UnitVariable> all(const Options& options) {
        for (const Id<Equations::Variable> id : equations_.variables.ids()) variable(id);
        for (const TimerNames& timer : names_.timers) {
            if (!timer.on.empty()) made_.push_back({Section::Local, timer.on, "TON", true, "", ""});
            if (!timer.lasted.empty()) made_.push_back({Section::Local, timer.lasted, "BOOL", false, "FALSE", ""});
            if (!timer.off.empty()) made_.push_back({Section::Local, timer.off, "TOF", true, "", ""});
        }
        made_.push_back({Section::Output, names_.fault, "INT", false, "0", "reason of the stop; 0 while running"});
        made_.push_back(
            {Section::Local, names_.started, "BOOL", false, "FALSE", "the first evolution has been executed"});
        if (options.mode == ExecutionMode::EveryCycle) return std::move(made_);
        made_.push_back({Section::Local, names_.stable, "BOOL", false, "FALSE", "the situation is stable"});
        made_.push_back({Section::Local, names_.evolutions, "UDINT", false, "0", "evolutions in this cycle"});
        made_.push_back({Section::Constant, names_.limit, "UDINT", false, std::to_string(options.max_evolutions),
                         "maximum per cycle; more evolutions are total instability"});
        return std::move(made_);
    }

private:
    void variable(Id<Equations::Variable> id) {
        const Equations::Variable& variable = equations_.variables[id];
        const Section section = variable.role == Role::Input    ? Section::Input
                                : variable.role == Role::Output ? Section::Output
                                                                : Section::Local;
        const std::string initial = literal(variable.type, variable.initial);
        const std::string& name = names_.variables[id.index];
        const std::string& kept = names_.storage[id.index];
        made_.push_back({section, name, type_word(variable.type), false, initial, comment_of(variable)});
        if (kept != name)
            made_.push_back({Section::Local, kept, type_word(variable.type), false, initial, "image of " + name});
        if (body_.waits[id.index])
            made_.push_back(
                {Section::Local, names_.fresh[id.index], type_word(variable.type), false, "", "next value of " + kept});
    }

    const Equations& equations_;
    const Names& names_;
    const Body& body_;
    std::vector<UnitVariable> made_ = {};
};

}  // namespace

void emit(const Equations& equations, const Options& options, std::ostream& out) {
    const Names names = names_of(equations);
    Body body = body_of(equations, names, options);
    Unit unit{false, names.block, comment_of(equations, names, options), {}, {}};
    unit.variables = Declarations(equations, names, body).all(options);
    unit.body = std::move(body.text);
    print(unit, options.form, out);
}

// Detects constructs that a block cannot compute exactly according to the equations.

namespace {

constexpr std::int64_t longest_ms = std::numeric_limits<std::int32_t>::max();

/// For each term: the reason why DINT arithmetic does not compute it exactly, or an empty text if it does. One pass
/// over the table is sufficient, because children precede parents.
class Obstacles {
public:
    explicit Obstacles(const Equations& equations) : exprs_(equations.exprs), reasons_(equations.exprs.size()) {
        const std::vector<bool> wide = wide_terms(equations.exprs, [&](const Expr& leaf) {
            return equations.variables[Id<Equations::Variable>{static_cast<std::uint32_t>(leaf.value)}].type;
        });
        for (std::uint32_t index = 0; index < exprs_.size(); ++index) {
            const Id<Expr> term{index};
            for (const Id<Expr> operand : exprs_.operands(term))
                if (reasons_[index] == nullptr) reasons_[index] = reasons_[operand.index];
            if (reasons_[index] == nullptr) reasons_[index] = own(term);
            if (reasons_[index] == nullptr && wide[index]) reasons_[index] = "a value that may need more than 32 bits";
        }
    }

    const char* of(Id<Expr> term) const { return term.valid() ? reasons_[term.index] : nullptr; }

private:
    const char* own(Id<Expr> term) const {
        const Expr& node = exprs_[term];
        const bool divides = node.op == Op::Divide || node.op == Op::Modulo;
        if (divides && exprs_[exprs_.operands(term)[1]].op != Op::Integer) return "a division by a variable";
        if (divides && exprs_[exprs_.operands(term)[1]].value == 0) return "a division by zero";
        return nullptr;
    }

    const Exprs& exprs_;
    std::vector<const char*> reasons_;
};

}  // namespace

bool expressible(const Equations& equations, Diagnostics& diagnostics) {
    const std::size_t errors = diagnostics.errors();
    const Obstacles obstacles(equations);
    const auto check = [&](Id<Expr> term, Span where) {
        if (const char* reason = obstacles.of(term)) diagnostics.add(messages::not_in_structured_text(where, reason));
    };
    for (const Equations::Firing& firing : equations.firings) check(firing.condition, firing.origin);
    for (const Equations::Output& output : equations.outputs) check(output.value, output.origin);
    for (const Equations::Stored& stored : equations.stored)
        for (const Equations::Write& write : stored.writes) {
            check(write.trigger, write.origin);
            check(write.value, write.origin);
        }
    for (const Equations::Previous& previous : equations.previous) check(previous.value, previous.origin);
    for (const Equations::ObservedTerm& watch : equations.watches) check(watch.value, watch.origin);
    for (const Equations::Conflict& conflict : equations.conflicts) check(conflict.condition, conflict.origin);
    for (const Equations::Timer& timer : equations.timers)
        if (timer.rise_ms > longest_ms || timer.fall_ms > longest_ms)
            diagnostics.add(messages::not_in_structured_text(timer.origin, "a duration of more than 24 days"));
    return diagnostics.errors() == errors;
}

}  // namespace grafverif::structured_text
