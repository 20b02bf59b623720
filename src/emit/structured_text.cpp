// SPDX-License-Identifier: MIT
// The controller's declarations around its body.
#include "grafverif/emit/structured_text.hpp"

#include <fmt/format.h>

#include "emit/structured_text_body.hpp"
#include "emit/structured_text_unit.hpp"

namespace grafverif::structured_text {

namespace {

using Role = Equations::Role;

std::string comment_of(const Equations& equations, const Names& names, const Options& options) {
    const bool search = options.mode == ExecutionMode::StabilitySearch;
    std::string text = fmt::format("{}: controller written by grafverif from the equations of the chart\n", equations.name);
    text += "One call is one PLC cycle: call it once per cycle of its task, with inputs that do not change meanwhile.\n";
    text += search ? "With stability search: evolutions follow each other until the situation is stable, then outputs are written.\n"
                   : "Without stability search: one evolution per call, outputs are written in every cycle.\n";
    text += fmt::format("{}: {}2 race of stored actions, 3 value outside its range{}; outputs then stay as they are.\n",
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
        made_.push_back({Section::Output, names_.fault, "INT", false, "0", "what stopped the controller; 0: nothing"});
        made_.push_back({Section::Local, names_.started, "BOOL", false, "FALSE", "the first evolution has been made"});
        if (options.mode == ExecutionMode::EveryCycle) return std::move(made_);
        made_.push_back({Section::Local, names_.stable, "BOOL", false, "FALSE", "one more evolution would change nothing"});
        made_.push_back({Section::Local, names_.evolutions, "UDINT", false, "0", "of this cycle"});
        made_.push_back({Section::Constant, names_.limit, "UDINT", false, std::to_string(options.max_evolutions),
                         "of one cycle; more of them are total instability"});
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
            made_.push_back({Section::Local, names_.fresh[id.index], type_word(variable.type), false, "", "next value of " + kept});
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

}  // namespace grafverif::structured_text
