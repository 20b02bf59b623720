// SPDX-License-Identifier: MIT
#include "syntax/print/automaton.hpp"

#include <fmt/format.h>

#include <nlohmann/json.hpp>
#include <ostream>

#include "support/json_text.hpp"
#include "syntax/print/dialect.hpp"

namespace grafverif {

namespace {

using Automaton = LocationAutomaton;
using Json = nlohmann::ordered_json;

std::string count_text(std::optional<std::uint64_t> count) { return count ? std::to_string(*count) : "very many"; }

std::string location_line(const Automaton& automaton, Id<Automaton::Location> id) {
    const Automaton::Location& location = automaton.locations[id];
    std::string line = fmt::format("{}  {}{}", id.index, id == automaton.init ? "INIT " : "",
                                   situation_text(automaton, location.situation));
    for (const Id<Automaton::Stored> stored : automaton.stored.ids())
        line += fmt::format("  {} = {}", automaton.stored[stored].name, location.values[stored.index]);
    for (std::size_t k = 0; k < location.emissions.size(); ++k)
        line += (k == 0 ? "  / " : ", ") + emission_text(automaton, location.emissions[k]);
    return line;
}

Json location_json(const Automaton& automaton, Id<Automaton::Location> id) {
    const Automaton::Location& location = automaton.locations[id];
    Json situation = Json::array(), values = Json::object(), outputs = Json::object();
    for (const Id<Automaton::Step> step : location.situation) situation.push_back(automaton.steps[step].name);
    for (const Id<Automaton::Stored> stored : automaton.stored.ids())
        values[automaton.stored[stored].name] = location.values[stored.index];
    for (const Automaton::Emission& emission : location.emissions)
        outputs[automaton.outputs[emission.output].name] = condition_text(automaton, emission.value);
    return {{"location", id.index}, {"situation", situation}, {"values", values}, {"outputs", outputs}};
}

Json evolution_json(const Automaton& automaton, const Automaton::Evolution& evolution) {
    Json restarted = Json::array(), falling = Json::array();
    for (const Id<Automaton::Input> timer : evolution.restarted) restarted.push_back(automaton.inputs[timer].name);
    for (const Id<Automaton::Input> timer : evolution.falling) falling.push_back(automaton.inputs[timer].name);
    return {{"from", evolution.from.index},
            {"to", evolution.to.index},
            {"condition", condition_text(automaton, evolution.condition)},
            {"restarted", restarted},
            {"falling", falling}};
}

std::string timer_line(const Automaton& automaton, const Automaton::Input& timer) {
    std::string text = timer.name + ": output of a timer; a tester can only wait for it";
    const std::string what = watched_text(automaton, timer);
    const bool step = timer.timed.valid();
    if (timer.rise_ms != 0)
        text +=
            fmt::format(", {} after {} {}", duration_text(timer.rise_ms), what, step ? "was activated" : "became true");
    if (timer.fall_ms != 0)
        text += fmt::format("{} until {} after {} {}", timer.rise_ms == 0 ? "," : "", duration_text(timer.fall_ms),
                            what, step ? "was deactivated" : "became false");
    return text;
}

Json instability_json(const Automaton& automaton, const Automaton::Instability& instability) {
    Json witness = Json::object(), cycle = Json::array();
    for (const Id<Automaton::Input> input : automaton.inputs.ids())
        witness[automaton.inputs[input].name] = instability.witness[input.index];
    for (const auto& situation : instability.cycle) cycle.push_back(situation_text(automaton, situation));
    return {{"from", instability.from.index},
            {"condition", condition_text(automaton, instability.condition)},
            {"witness", witness},
            {"cycle", cycle}};
}

/// Writes a JSON array with one entry per line. Each entry is written immediately, so that the array is never stored in
/// memory.
template <class Entries, class Write>
void print_table(std::ostream& out, const char* name, const Entries& entries, Write write) {
    out << ",\n  \"" << name << "\": [";
    bool first = true;
    for (const auto& entry : entries) {
        out << (first ? "\n    " : ",\n    ") << json_text(write(entry), -1);
        first = false;
    }
    out << "\n  ]";
}

/// Prints the opening bracket and the members of a JSON object. The caller can print further members and must print the
/// closing bracket.
void print_members(std::ostream& out, const Json& object) {
    bool first = true;
    for (const auto& [name, value] : object.items()) {
        out << (first ? "{\n  " : ",\n  ") << json_text(Json(name), -1) << ": " << json_text(value, -1);
        first = false;
    }
}

}  // namespace

AutomatonCounts counts(const Automaton& automaton) {
    AutomatonCounts result{automaton.locations.size(), automaton.evolutions.size(),
                           evolutions_from(automaton, automaton.init).size(), 0, 0};
    for (const Automaton::Instability& instability : automaton.instabilities) {
        std::optional<std::uint64_t>& sum =
            instability.from == automaton.init ? result.unstable_from_init : result.unstable;
        sum = sum && instability.combinations ? std::optional(*sum + *instability.combinations) : std::nullopt;
    }
    return result;
}

std::string condition_text(const Automaton& automaton, Id<Expr> condition) {
    return expr_text(automaton.exprs, condition, plain_spelling, [&](std::ostream& out, const Expr& leaf) {
        out << automaton.inputs[Id<Automaton::Input>{static_cast<std::uint32_t>(leaf.value)}].name;
    });
}

std::string emission_text(const Automaton& automaton, const Automaton::Emission& emission) {
    const std::string& name = automaton.outputs[emission.output].name;
    const Expr& value = automaton.exprs[emission.value];
    if (value.op == Op::True) return name;
    return name + (value.op == Op::Integer ? " = " : " if ") + condition_text(automaton, emission.value);
}

void print_automaton(std::ostream& out, const Automaton& automaton, bool details) {
    const AutomatonCounts count = counts(automaton);
    const char* const least = automaton.complete ? "" : "at least ";
    out << fmt::format("Location automaton of {}, {}\n", automaton.name, word(automaton.mode));
    if (!automaton.complete)
        out << fmt::format(
            "incomplete: the evolutions of {} locations are known, {} further locations are unexplored\n",
            automaton.looked_at, count.locations - automaton.looked_at);
    out << fmt::format("{0}{1} locations, INIT included\n{0}{2} evolutions, {3} of them from INIT\n", least,
                       count.locations, count.evolutions, count.evolutions_from_init);
    if (automaton.mode == ExecutionMode::StabilitySearch)
        out << "pairs of location and inputs for which the situation never becomes stable: " << least
            << fmt::format("{}{}\n", count_text(count.unstable),
                           count.unstable_from_init == 0
                               ? ""
                               : ", and " + count_text(count.unstable_from_init) + " more from INIT");
    if (!is_true(automaton.exprs, automaton.assumed))
        out << "assumed: " << condition_text(automaton, automaton.assumed) << '\n';
    for (const Automaton::Input& input : automaton.inputs)
        if (is_timer(input)) out << timer_line(automaton, input) << '\n';
    if (!details) return;
    for (const Id<Automaton::Location> id : automaton.locations.ids()) {
        out << '\n' << location_line(automaton, id) << '\n';
        for (const Automaton::Evolution& evolution : evolutions_from(automaton, id)) {
            out << fmt::format("    -> {} {}  when {}", evolution.to.index,
                               situation_text(automaton, automaton.locations[evolution.to].situation),
                               condition_text(automaton, evolution.condition));
            for (const Id<Automaton::Input> timer : evolution.restarted)
                out << "; starts " << automaton.inputs[timer].name;
            for (const Id<Automaton::Input> timer : evolution.falling) out << "; ends " << automaton.inputs[timer].name;
            out << '\n';
        }
        for (const Automaton::Instability& instability : instabilities_of(automaton, id)) {
            out << "    never stable when " << condition_text(automaton, instability.condition) << ":";
            for (const auto& situation : instability.cycle) out << ' ' << situation_text(automaton, situation) << " ->";
            out << ' ' << situation_text(automaton, instability.cycle.front()) << '\n';
        }
    }
}

void print_automaton_json(std::ostream& out, const Automaton& automaton, bool details) {
    const AutomatonCounts count = counts(automaton);
    Json head = {{"name", automaton.name},
                 {"mode", word(automaton.mode)},
                 {"complete", automaton.complete},
                 {"looked_at", automaton.looked_at},
                 {"locations", count.locations},
                 {"evolutions", count.evolutions},
                 {"evolutions_from_init", count.evolutions_from_init},
                 {"unstable", optional_json(count.unstable)},
                 {"unstable_from_init", optional_json(count.unstable_from_init)}};
    if (details) {
        Json inputs = Json::array(), outputs = Json::array();
        for (const Automaton::Input& input : automaton.inputs) {
            Json one = {{"name", input.name}};
            if (is_timer(input))
                one["rise_ms"] = input.rise_ms, one["fall_ms"] = input.fall_ms,
                one["watched"] = watched_text(automaton, input);
            inputs.push_back(std::move(one));
        }
        for (const Automaton::Output& output : automaton.outputs) outputs.push_back(output.name);
        head["inputs"] = inputs, head["outputs"] = outputs,
        head["assumed"] = condition_text(automaton, automaton.assumed);
    }
    print_members(out, head);
    if (details) {
        print_table(out, "location_table", automaton.locations.ids(),
                    [&](Id<Automaton::Location> id) { return location_json(automaton, id); });
        print_table(out, "evolution_table", automaton.evolutions,
                    [&](const Automaton::Evolution& evolution) { return evolution_json(automaton, evolution); });
        print_table(out, "instability_table", automaton.instabilities, [&](const Automaton::Instability& instability) {
            return instability_json(automaton, instability);
        });
    }
    out << "\n}\n";
}

}  // namespace grafverif
