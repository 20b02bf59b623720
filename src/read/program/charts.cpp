// SPDX-License-Identifier: MIT
#include "read/program/charts.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <optional>
#include <set>
#include <string_view>
#include <unordered_map>
#include <utility>

#include "support/messages.hpp"
#include "support/messages_program.hpp"
#include "syntax/resolve/nearest_of.hpp"
#include "syntax/st/parse_st.hpp"

namespace grafverif::program {

namespace {

/// The declarations and statements of the block ACTION_CONTROL (IEC 61131-3, 2.6.4.5) for one qualifier. In
/// `statements`, the duration replaces `{0}`, and the condition that resets the action replaces `{1}`.
struct Qualifier {
    std::string_view name = {};
    bool timed = false;
    std::string_view variables = {}, statements = {};
    std::string_view value = {};    ///< term that makes Q (and A) true
    std::string_view trigger = {};  ///< term that makes A true, but not Q
};
constexpr std::array qualifiers = {
    Qualifier{"N", false, "", "", "N", ""},
    Qualifier{"R", false, "", "", "", ""},
    Qualifier{"S", false, "S_FF : RS;", "S_FF(S := S, R1 := {1});", "S_FF.Q1", ""},
    Qualifier{"L", true, "L_TMR : TON;", "L_TMR(IN := L, PT := {0});", "L AND NOT L_TMR.Q", ""},
    Qualifier{"D", true, "D_TMR : TON;", "D_TMR(IN := D, PT := {0});", "D_TMR.Q", ""},
    Qualifier{"P", false, "P_TRIG : R_TRIG;", "P_TRIG(CLK := P);", "P_TRIG.Q", ""},
    Qualifier{"SD", true, "SD_FF : RS; SD_TMR : TON;", "SD_FF(S := SD, R1 := {1}); SD_TMR(IN := SD_FF.Q1, PT := {0});",
              "SD_TMR.Q", ""},
    Qualifier{"DS", true, "DS_TMR : TON; DS_FF : RS;", "DS_TMR(IN := DS, PT := {0}); DS_FF(S := DS_TMR.Q, R1 := {1});",
              "DS_FF.Q1", ""},
    Qualifier{"SL", true, "SL_FF : RS; SL_TMR : TON;", "SL_FF(S := SL, R1 := {1}); SL_TMR(IN := SL_FF.Q1, PT := {0});",
              "SL_FF.Q1 AND NOT SL_TMR.Q", ""},
    Qualifier{"P1", false, "P1_TRIG : R_TRIG;", "P1_TRIG(CLK := P1);", "", "P1_TRIG.Q"},
    Qualifier{"P0", false, "P0_END, P0_OLD : BOOL;", "P0_END := P0_OLD AND NOT P0; P0_OLD := P0;", "", "P0_END"},
};

/// Returns the text of the ACTION_CONTROL block of an action. If the action is a Boolean variable, the output Q is its
/// value. The statements of an action are executed while the output A is true, which includes one scan after Q becomes
/// false (the final scan). `times` contains the constant durations; if it contains several, the inputs `TIME_1`,
/// `TIME_2`, ... select one of them.
std::string control_text(const ChartAction& action, const std::vector<std::int64_t>& times) {
    const std::string duration = times.empty() ? "T" : fmt::format("T#{}ms", times.front());
    const std::string reset = action.steps.contains("R") ? "R" : "FALSE";
    std::string inputs, variables, statements, value = "FALSE", active = "Q OR Q_OLD";
    for (const Qualifier& one : qualifiers) {
        if (!action.steps.contains(std::string(one.name))) continue;
        inputs += fmt::format("{}{}", inputs.empty() ? "" : ", ", one.name);
        variables += one.variables;
        for (std::size_t i = 1; one.timed && i < times.size(); ++i)
            statements +=
                fmt::format("{} TIME_{} THEN {} ", i == 1 ? "IF" : "ELSIF", i + 1,
                            fmt::format(fmt::runtime(one.statements), fmt::format("T#{}ms", times[i]), reset));
        const bool selects = one.timed && times.size() > 1;
        statements +=
            fmt::format("{}{}{}", selects ? "ELSE " : "", fmt::format(fmt::runtime(one.statements), duration, reset),
                        selects ? " END_IF;" : "");
        if (!one.value.empty()) value += fmt::format(" OR {}", one.value);
        if (!one.trigger.empty()) active += fmt::format(" OR {}", one.trigger);
    }
    for (std::size_t i = 1; times.size() > 1 && i <= times.size(); ++i) inputs += fmt::format(", TIME_{}", i);
    return fmt::format(
        "FUNCTION_BLOCK ACTION_CONTROL VAR_INPUT {} : BOOL; T : TIME; END_VAR\n"
        "VAR_OUTPUT Q, A : BOOL; END_VAR VAR Q_OLD : BOOL; {} END_VAR\n"
        "{}\nQ := NOT {} AND ({});\nA := {};\nQ_OLD := Q;\nEND_FUNCTION_BLOCK\n",
        inputs, variables, statements, reset, value, active);
}

using Marking = std::vector<bool>;
constexpr std::size_t most_markings = 20'000;

class ChartReader {
public:
    ChartReader(st::File& file, std::size_t unit, Sources& sources, Diagnostics& diagnostics)
        : file_(file), unit_(file.units[unit]), sources_(sources), diagnostics_(diagnostics) {}

    /// Reads a chart of CODESYS. The chart is the body of a unit or an action.
    Chart read_codesys(const std::vector<st::Network>& networks) {
        const std::size_t errors = diagnostics_.errors();
        unit_.networks = networks;
        const st::Network& network = unit_.networks.front();
        check_structure(network);
        if (!network.flags.others.empty())
            reject(network.where, "the flag `" + network.flags.others + "` of a chart",
                   "disable the flag in the settings of the chart");
        for (const st::Step& step : network.steps) {
            if (step.initial && step.entry.valid())
                reject(file_.exprs[step.entry].where, "an entry action of the initial step", "move it to a later step");
            if ((step.entry.valid() || step.exit.valid()) && repeats(network, step))
                reject(step.where, "an entry or exit action of a step that the same transition leaves and activates",
                       "use a second step");
            for (const st::Association& association : step.actions) add_codesys(step, association);
        }
        for (ChartAction& action : chart_.actions) {
            action.controlled = std::ranges::any_of(
                action.steps, [](const auto& one) { return one.first != "N" && one.first != "R" && one.first != "S"; });
            if (action.controlled) control(action);
        }
        std::ranges::stable_sort(chart_.actions, {}, &ChartAction::label);  // actions run in alphabetical order
        if (diagnostics_.errors() == errors) check_safety(network);
        chart_.valid = diagnostics_.errors() == errors;
        return std::move(chart_);
    }

    Chart read() {
        const std::size_t errors = diagnostics_.errors();
        const st::Network& network = unit_.networks.front();
        if (!unit_.body.empty())
            reject(file_.statements[unit_.body.front()].where, "a statement next to a Sequential Function Chart",
                   "move it to an action");
        check_structure(network);
        for (const st::Action& action : unit_.actions) declare(action);
        for (const st::Step& step : network.steps)
            for (const st::Association& association : step.actions) add(step, association);
        for (ChartAction& action : chart_.actions) control(action);
        if (diagnostics_.errors() == errors) check_safety(network);
        chart_.valid = diagnostics_.errors() == errors;
        return std::move(chart_);
    }

private:
    void reject(Span where, std::string_view what, std::string_view hint) {
        diagnostics_.add(messages::not_in_program(where, what, hint));
    }
    std::string text(st::Name name) const { return std::string(file_.text(name)); }

    void check_structure(const st::Network& network) {
        if (unit_.kind == st::UnitKind::Function)
            reject(network.where, "a Sequential Function Chart as the body of a function", "use a function block");
        if (unit_.networks.size() > 1)
            reject(unit_.networks[1].where, "a macro-step", "write its steps into the chart");
        steps(network);
        for (const st::Transition& transition : network.transitions) check(transition);
        order(network);
    }

    /// Determines the actions for which action blocks with different durations can be active simultaneously. According
    /// to the standard, this is an error.
    void check_durations(const Marking& marking) {
        for (std::size_t i = 0; i < chart_.actions.size(); ++i) {
            const auto active = [&](const std::vector<Id<st::Word>>& steps) {
                return std::ranges::any_of(steps, [&](Id<st::Word> step) { return marking[index_.at(step.index)]; });
            };
            if (std::ranges::count_if(chart_.actions[i].durations, active) > 1) chart_.checked_actions[i] = true;
        }
    }

    static bool repeats(const st::Network& network, const st::Step& step) {
        const auto names = [&](const std::vector<st::Name>& list) {
            return std::ranges::find(list, step.name.word, &st::Name::word) != list.end();
        };
        return std::ranges::any_of(network.transitions, [&](const st::Transition& transition) {
            return names(transition.from) && names(transition.to);
        });
    }

    void add_codesys(const st::Step& step, const st::Association& association) {
        constexpr std::array accepted = {"N", "R", "S", "L", "D", "P", "P0", "P1"};
        const auto qualifier = std::ranges::find(qualifiers, association.qualifier, &Qualifier::name);
        if (association.unread)
            return reject(association.where, "an action block with an indicator variable",
                          "remove the indicator variable");
        if (!association.path.valid())
            return reject(association.where, "an action block without a name", "name an action or a Boolean variable");
        if (qualifier == qualifiers.end() || std::ranges::find(accepted, association.qualifier) == accepted.end())
            return reject(association.where, "the qualifier `" + association.qualifier + "` in a chart of CODESYS",
                          "use one of N, R, S, L, D, P, P0, P1");
        if (qualifier->timed != association.time.valid())
            return reject(association.where,
                          "the qualifier `" + association.qualifier +
                              (qualifier->timed ? "` without a duration" : "` with a duration"),
                          qualifier->timed ? "write a duration after the qualifier" : "remove the duration");
        const std::string label = path_text(file_, association.path);
        if (label.empty()) return reject(association.where, "this action", "name an action or a Boolean variable");
        auto action = std::ranges::find(chart_.actions, label, &ChartAction::label);
        if (action == chart_.actions.end()) {
            times_.emplace_back();
            ChartAction made;
            made.path = association.path;
            made.label = label;
            made.where = association.where;
            action = chart_.actions.insert(action, std::move(made));
        }
        action->steps[association.qualifier].push_back(step.name.word);
        if (qualifier->timed) times_[static_cast<std::size_t>(action - chart_.actions.begin())].push_back(&association);
    }

    void steps(const st::Network& network) {
        const st::Step* initial = nullptr;
        for (const st::Step& step : network.steps) {
            const auto [known, fresh] = index_.try_emplace(step.name.word.index, index_.size());
            if (!fresh) {
                const auto first =
                    std::ranges::find(network.steps, step.name.word, [](const st::Step& one) { return one.name.word; });
                diagnostics_.add(messages::duplicate_name(step.name.where, "step", text(step.name), first->name.where));
            }
            if (step.initial && initial != nullptr)
                reject(step.where, "a second initial step", "write `STEP` instead of `INITIAL_STEP`");
            if (step.initial) initial = &step;
        }
        if (initial == nullptr)
            reject(network.where, "a Sequential Function Chart without initial step",
                   "write `INITIAL_STEP` for the first step");
    }

    void check(const st::Transition& transition) {
        if (transition.from.empty() || transition.to.empty())
            diagnostics_.add(messages::missing_part(transition.where, "this transition",
                                                    transition.from.empty() ? "step before it" : "step after it"));
        if (!transition.condition.valid())
            reject(transition.where, "a transition without condition", "write its condition");
        for (const auto* side : {&transition.from, &transition.to}) {
            std::set<std::uint32_t> seen;
            for (const st::Name& step : *side) {
                if (!seen.insert(step.word.index).second)
                    reject(step.where, "a step named twice in a transition", "name it once");
                if (index_.contains(step.word.index)) continue;
                std::vector<std::string> known;
                for (const st::Step& one : unit_.networks.front().steps) known.push_back(text(one.name));
                diagnostics_.add(messages::unknown(step.where, "step", text(step), nearest_of(text(step), known)));
            }
        }
    }

    void order(const st::Network& network) {
        const std::vector<st::Transition>& transitions = network.transitions;
        for (std::size_t i = 0; i < transitions.size(); ++i) chart_.order.push_back(i);
        std::ranges::stable_sort(chart_.order, {}, [&](std::size_t i) { return transitions[i].priority; });
        for (std::size_t i = 0; i < transitions.size(); ++i) {
            const auto leaves_same_step = [&](const st::Transition& other) {
                return std::ranges::any_of(other.from, [&](const st::Name& step) {
                    return std::ranges::find(transitions[i].from, step.word, &st::Name::word) !=
                           transitions[i].from.end();
                });
            };
            for (std::size_t j = 0; j < i; ++j) {
                const std::int64_t one = transitions[i].priority, other = transitions[j].priority;
                if ((one == 0 && other == 0) || (one != 0 && other != 0 && one != other)) continue;
                if (!leaves_same_step(transitions[j])) continue;
                reject(transitions[i].where,
                       one == other ? "a second transition of the same priority after a step"
                                    : "a selection of which only some transitions have a priority",
                       "give each transition after the step a different `PRIORITY`");
                break;
            }
        }
    }

    void declare(const st::Action& action) {
        if (action.opaque) reject(action.where, "an action in this language", "write it in Structured Text");
        const auto [known, fresh] = actions_.try_emplace(action.name.word.index, &action);
        if (!fresh)
            diagnostics_.add(
                messages::duplicate_name(action.name.where, "action", text(action.name), known->second->name.where));
    }

    void add(const st::Step& step, const st::Association& association) {
        const auto qualifier = std::ranges::find(qualifiers, association.qualifier, &Qualifier::name);
        if (association.unread)
            return reject(association.where, "an action block with an indicator variable",
                          "remove the indicator variable");
        if (qualifier == qualifiers.end())
            return reject(association.where, "the qualifier `" + association.qualifier + "`",
                          "use one of N, R, S, L, D, P, SD, DS, SL, P0, P1");
        if (qualifier->timed != association.time.valid())
            return reject(association.where,
                          "the qualifier `" + association.qualifier +
                              (qualifier->timed ? "` without a duration" : "` with a duration"),
                          qualifier->timed ? "write a duration after the qualifier" : "remove the duration");
        const auto declared = actions_.find(association.action.word.index);
        const bool named = association.action.valid();
        ChartAction* action = nullptr;
        if (named)
            for (ChartAction& one : chart_.actions)
                if (one.name.valid() && one.name.word == association.action.word) action = &one;
        if (action == nullptr) {
            action = &chart_.actions.emplace_back();
            times_.emplace_back();
            action->name = association.action;
            action->label = named ? text(association.action) : fmt::format("action {}", chart_.actions.size());
            action->variable = named && declared == actions_.end();
            if (!action->variable) action->body = named ? declared->second->body : association.body;
            action->where = association.where;
        }
        if (action->variable && (qualifier->name == "P0" || qualifier->name == "P1"))
            reject(association.where, fmt::format("the qualifier `{}` for a Boolean variable", qualifier->name),
                   "use the qualifier `P`, or an action that assigns the variable");
        action->steps[association.qualifier].push_back(step.name.word);
        if (qualifier->timed) times_[static_cast<std::size_t>(action - chart_.actions.data())].push_back(&association);
    }

    /// Returns the value in milliseconds of a duration literal or of a constant with a literal as its value; empty for
    /// other expressions.
    std::optional<std::int64_t> duration(Id<st::Expr> expr) const {
        const st::Expr& node = file_.exprs[expr];
        if (node.op == st::Op::Time) return node.value;
        if (node.op != st::Op::Name) return {};
        for (const auto* variables : {&unit_.variables, &std::as_const(file_).globals})
            for (const st::Variable& variable : *variables)
                if (variable.name.word == node.word) {
                    if (!variable.constant || !variable.initial.valid()) return {};
                    const st::Expr& initial = file_.exprs[variable.initial];
                    if (initial.op == st::Op::Time) return initial.value;
                    return {};
                }
        return {};
    }

    /// Generates the ACTION_CONTROL block of an action. According to the standard, it is an error if two action blocks
    /// with durations are active simultaneously.
    void control(ChartAction& action) {
        const auto& timed = times_[static_cast<std::size_t>(&action - chart_.actions.data())];
        std::vector<std::int64_t> times;
        for (const st::Association* one : timed) {
            const auto time = duration(one->time);
            const std::string& qualifier = timed.front()->qualifier;
            const auto known = time ? std::ranges::find(times, *time) : times.end();
            const bool another = known == times.end() && one != timed.front();
            if (one->qualifier != qualifier || (another && (!time || (qualifier != "L" && qualifier != "D")))) {
                reject(one->where, "a second duration of the action `" + action.label + "`",
                       "use one qualifier and one constant duration for each action, or several constant durations "
                       "with L or D");
                continue;
            }
            if (!time) {
                action.time = one->time;
                continue;
            }
            const auto index = static_cast<std::size_t>(known - times.begin());
            if (known == times.end()) {
                times.push_back(*time);
                action.durations.emplace_back();
            }
            for (const st::Step& step : unit_.networks.front().steps)
                if (std::ranges::any_of(step.actions, [&](const st::Association& own) { return &own == one; }))
                    action.durations[index].push_back(step.name.word);
        }
        if (times.size() < 2) action.durations.clear();
        const std::string body = control_text(action, times);
        const Id<Source> source = sources_.add({"action control", body});
        const st::Text all = {{{source, 0, static_cast<std::uint32_t>(body.size())}, false}};
        action.control = file_.units.size();
        st::parse_programs(all, file_, sources_, diagnostics_);
        // The name is unique, because it contains the index of the unit in the file.
        file_.units.back().name.word = file_.intern(fmt::format("ACTION_CONTROL {}", action.control));
    }

    /// Finds the transitions that can activate an active step in some situation. The search ignores conditions and
    /// clears transitions one by one, because the simultaneous clearing of several transitions has the same effect as
    /// clearing them in sequence. If a chart has too many situations, every transition is assumed to activate an active
    /// step.
    void check_safety(const st::Network& network) {
        chart_.checked.assign(network.transitions.size(), false);
        chart_.checked_actions.assign(chart_.actions.size(), false);
        Marking first(index_.size());
        for (const st::Step& step : network.steps)
            if (step.initial) first[index_.at(step.name.word.index)] = true;
        std::set<Marking> seen = {first};
        std::vector<Marking> open = {first};
        while (!open.empty()) {
            if (seen.size() >= most_markings) {
                chart_.checked.assign(network.transitions.size(), true);
                chart_.checked_actions.assign(chart_.actions.size(), true);
                return;
            }
            const Marking marking = std::move(open.back());
            open.pop_back();
            check_durations(marking);
            for (std::size_t i = 0; i < network.transitions.size(); ++i) {
                const st::Transition& transition = network.transitions[i];
                const auto marked = [&](const Marking& in, const st::Name& step) {
                    return in[index_.at(step.word.index)];
                };
                if (!std::ranges::all_of(transition.from, [&](const st::Name& one) { return marked(marking, one); }))
                    continue;
                Marking next = marking;
                for (const st::Name& step : transition.from) next[index_.at(step.word.index)] = false;
                for (const st::Name& step : transition.to) {
                    if (marked(next, step)) chart_.checked[i] = true;
                    next[index_.at(step.word.index)] = true;
                }
                if (seen.insert(next).second) open.push_back(std::move(next));
            }
        }
    }

    st::File& file_;
    st::Unit unit_;  // a copy, because the addition of units to the file invalidates references
    Sources& sources_;
    Diagnostics& diagnostics_;
    Chart chart_ = {};
    std::unordered_map<std::uint32_t, std::size_t> index_ = {};  ///< for each step name: index of the step
    std::unordered_map<std::uint32_t, const st::Action*> actions_ = {};
    /// For each action: its action blocks with a duration.
    std::vector<std::vector<const st::Association*>> times_ = {};
};

}  // namespace

std::string path_text(const st::File& file, Id<st::Expr> path) {
    const st::Expr& node = file.exprs[path];
    if (node.op == st::Op::Name) return st::capitals(file.text(node.word));
    if (node.op != st::Op::Member) return {};
    const std::string owner = path_text(file, node.first);
    return owner.empty() ? owner : owner + "." + st::capitals(file.text(node.word));
}

std::vector<UnitCharts> read_charts(st::File& file, Sources& sources, Diagnostics& diagnostics) {
    std::vector<UnitCharts> charts;
    const std::size_t units = file.units.size();
    const bool codesys = file.dialect == st::Dialect::Codesys;
    for (std::size_t index = 0; index < units; ++index) {
        UnitCharts& made = charts.emplace_back();
        const auto networks = file.units[index].networks;
        if (!networks.empty() && codesys)
            made.body = ChartReader(file, index, sources, diagnostics).read_codesys(networks);
        else if (!networks.empty()) made.body = ChartReader(file, index, sources, diagnostics).read();
        for (std::size_t i = 0; i < file.units[index].actions.size(); ++i) {
            const auto inner = file.units[index].actions[i].networks;
            made.actions.emplace_back();
            if (!inner.empty())
                made.actions.back() = ChartReader(file, index, sources, diagnostics).read_codesys(inner);
        }
    }
    charts.resize(file.units.size());
    return charts;
}

}  // namespace grafverif::program
