// SPDX-License-Identifier: MIT
#include "pipeline/variants/supervise.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <map>
#include <utility>

#include "ir/patterns.hpp"
#include "pipeline/check.hpp"
#include "pipeline/models.hpp"
#include "pipeline/staged_search.hpp"
#include "pipeline/variants/read_again.hpp"
#include "pipeline/variants/supervise_model.hpp"
#include "pipeline/variants/supervise_text.hpp"
#include "report/trace_rows.hpp"
#include "run/project.hpp"
#include "support/element_of.hpp"
#include "support/messages.hpp"
#include "support/messages_program.hpp"
#include "support/unique_names.hpp"

namespace grafverif {

namespace {

using System = TransitionSystem;

/// Maximum number of states that the timed engine explores in the second proof. If this number is not sufficient, PDR
/// makes the second proof.
constexpr std::uint64_t most_timed_states = 2'000'000;

/// Synthesizes conditions for one closed loop, and proves that they enforce the properties.
class Supervising {
public:
    Supervising(const Model& model, Id<ClosedLoop> loop, Id<Source> main, Sources& sources,
                const SuperviseRequest& request, Diagnostics& diagnostics)
        : model_(model), loop_(loop), main_(main), sources_(sources), request_(request), diagnostics_(diagnostics) {
        made_.loop = model.loops[loop].name;
        made_.marked = request.marked;
        UniqueNames fresh;
        for (const Property& property : model.loops[loop].properties) fresh.take(property.name);
        marked_ = fresh.fresh("marked_situation");
    }

    std::optional<Supervised> run() {
        std::optional<Model> marked = with_marked_situation();
        if (!marked) return {};
        const Model plain = *marked;
        if (!held_back(*marked)) return std::move(made_);
        ClosedLoop& loop = marked->loops[loop_];
        auto system = transition_system_of(*marked, loop_, untimed(request_), diagnostics_);
        if (!system) return {};
        const auto properties = kept(*system, request_, marked_, diagnostics_);
        if (!properties) return {};
        for (const Id<Property> id : *properties) made_.kept.push_back(system->properties[id].name);
        for (const Property& property : model_.loops[loop_].properties) {
            if (std::ranges::find(made_.kept, property.name) != made_.kept.end()) continue;
            made_.ignored.push_back({property.name, reason_to_ignore(property)});
        }
        if (made_.kept.empty()) {
            made_.reason =
                "all properties of states are expected to be violated; select the properties to enforce with "
                "`--property`";
            return std::move(made_);
        }
        const Supervision requested = supervision(*system, *marked, loop, *properties);
        SuperviseOptions options;
        set_limits(options, request_.limits);
        if (request_.limits.progress)
            options.progress = [this](const std::string& doing) {
                request_.limits.progress({[&doing] { return doing; }});
            };
        const Supervisor found = supervisor_of(*system, requested, options);
        made_.outcome = found.outcome;
        made_.reason = found.reason;
        made_.claim = found.claim;
        made_.blocked = found.blocked;
        for (const Supervisor::Selection& which : found.hidden) made_.hidden.push_back(subject(which));
        for (const Supervisor::Selection& which : found.traded) made_.traded.push_back(subject(which));
        for (const Supervisor::Selection& which : found.disabled)
            (held_[which.controller][which.permission].output ? made_.disabled_outputs : made_.disabled_transitions)
                .push_back(shown(which.controller, subject(which)));
        for (const auto& [player, seen] : found.newly_unreachable)
            if (seen >= sights_[player].first_step)
                made_.never_active_steps.push_back(shown(player, sights_[player].names[seen]));
        if (found.run) report_run(plain, found);
        if (found.outcome == Supervisor::Outcome::Found) write(found);
        if (made_.outcome != Supervisor::Outcome::Unknown) check_timed_without(found.violated);
        return std::move(made_);
    }

private:
    std::string reason_to_ignore(const Property& property) const {
        if (!request_.properties.empty()) return "not selected";
        if (is_about_all_states(property.pattern)) return "expected violated";
        return property.watch.duration_ms > 0 ? "with a duration, which the untimed model omits"
                                              : "not a property of all states";
    }

    /// Returns the name of an element of the controller's chart. If there are several controllers, the name is prefixed
    /// by the name of the chart.
    std::string shown(std::size_t controller, const std::string& name) const {
        const auto& controllers = model_.loops[loop_].controllers;
        const Id<ClosedLoop::Controller> id{static_cast<std::uint32_t>(controller)};
        return controllers.size() > 1 ? model_.charts[controllers[id].chart].name + "." + name : name;
    }

    /// Checks, for the timed loop without conditions, the properties that the untimed model without conditions
    /// violates. These properties are the elements of `made_.kept` for which `violated` is true.
    void check_timed_without(const std::vector<bool>& violated) {
        std::vector<std::string> names;
        for (std::size_t index = 0; index < violated.size(); ++index)
            if (violated[index]) names.push_back(made_.kept[index]);
        Diagnostics diagnostics;
        const auto network = network_of(model_, loop_, untimed(request_), diagnostics);
        if (!network || names.empty()) return;
        std::erase_if(names, [known = property_names(*network)](const std::string& name) {
            return std::ranges::find(known, name) == known.end();
        });
        if (names.empty()) return;
        const Report report = check_without_causes(loop_to_check(model_, loop_, *network), in_timed_loop(names));
        for (const std::string& name : names) {
            const auto answer = std::ranges::find(report.answers, name,
                                                  [](const PropertyResult& each) { return each.verdict.property; });
            made_.timed.push_back({name, answer == report.answers.end() ? Outcome::Unknown : answer->verdict.outcome});
        }
    }

    CheckOptions in_timed_loop(const std::vector<std::string>& names) const {
        CheckOptions timed = options(names);
        timed.limits.states = std::min(timed.limits.states.value_or(most_timed_states), most_timed_states);
        return timed;
    }

    const std::string& subject(const Supervisor::Selection& which) const {
        return held_[which.controller][which.permission].subject;
    }

    /// Returns the model to restrict. If `--marked` is given, the model has an additional property: the marked
    /// situation remains reachable.
    std::optional<Model> with_marked_situation() {
        if (request_.marked.empty()) return model_;
        const Id<Source> file = model_.loops[loop_].origin.source;
        auto text = with_marked(file, sources_, made_.loop, marked_, request_.marked, diagnostics_);
        if (!text) return {};
        return read_again(main_, {{sources_[file].name, std::move(*text)}}, Sources(sources_), sources_, request_.read,
                          diagnostics_);
    }

    /// Adds an input for each permission to the charts. Returns false if a chart cannot be restricted because two
    /// controllers execute it.
    bool held_back(Model& model) {
        ClosedLoop& loop = model.loops[loop_];
        UniqueNames names;
        for (const ClosedLoop::Shared& shared : loop.shared) names.take(shared.name);
        for (const ClosedLoop::Controller& controller : loop.controllers)
            for (const Chart::Variable& variable : model.charts[controller.chart].variables) names.take(variable.name);
        std::vector<bool> known(model.charts.size());
        for (const ClosedLoop::Controller& controller : loop.controllers) {
            if (known[controller.chart.index]) {
                made_.reason = fmt::format(
                    "two controllers run the chart `{}`, so each condition applies to both; give each controller a "
                    "separate chart",
                    controller.name);
                return false;
            }
            known[controller.chart.index] = true;
        }
        for (const Id<ClosedLoop::Controller> id : loop.controllers.ids())
            held_.push_back(add_permissions(model, loop, id, model_.charts[model_.loops[loop_].controllers[id].chart],
                                            request_, names));
        return true;
    }

    Supervision supervision(System& system, const Model& model, const ClosedLoop& loop,
                            const std::vector<Id<Property>>& properties) {
        Supervision requested;
        Table<System::Symbol>& symbols = system.modules[system.main].symbols;
        for (std::size_t index = 0; index < system.controllers.size(); ++index) {
            const System::Controller& controller = system.controllers[index];
            const Id<ClosedLoop::Controller> id{static_cast<std::uint32_t>(index)};
            const auto symbol = [](const auto& list, const std::string& name) {
                return element_of(list, name, [](const auto& each) { return each.name; }).variable;
            };
            for (const PermittedElement& held : held_[index])
                symbols[symbol(controller.words.inputs, held.permission)].kind = System::ChoiceSymbol{};
            Supervision::Controller& player = requested.controllers.emplace_back();
            std::vector<Id<Expr>> steps{controller.evolves};
            if (controller.starts.valid()) steps.push_back(controller.starts);
            player.evolves = system.exprs.disjunction(steps);
            const ObservableVariables& sight = sights_.emplace_back(sight_of(system, controller, loop, id));
            player.seen = sight.terms;
            for (const PermittedElement& held : held_[index]) {
                Supervision::Permission& permission = player.permissions.emplace_back();
                permission.symbol = symbol(controller.words.inputs, held.permission);
                permission.output = held.output;
                const auto& effects = held.output ? controller.words.outputs : controller.words.transitions;
                permission.effect = system.exprs.leaf(Op::Variable, symbol(effects, held.subject).index);
                const Chart& chart = model.charts[loop.controllers[id].chart];
                for (const Id<Chart::Step> step : held.steps) {
                    const auto seen = std::ranges::find(sight.names, step_variable(chart, step));
                    permission.sites.push_back(static_cast<std::size_t>(seen - sight.names.begin()));
                }
                for (const std::string& sets : held.sets)
                    permission.site_effects.push_back(
                        sets.empty() ? Id<Expr>{}
                                     : system.exprs.leaf(Op::Variable, symbol(controller.words.outputs, sets).index));
            }
        }
        for (const Id<Property> id : properties) requested.bad.push_back(violation(system, system.properties[id]));
        const auto marked = std::ranges::find(system.properties, marked_, &Property::name);
        requested.marked =
            marked != system.properties.end() ? marked->operands[0] : initial_situation(system, model, loop);
        return requested;
    }

    /// Reports a run that violates a property although conditions were added, because no conditions can prevent it. All
    /// permissions are granted in this run; therefore it is also a run of the original loop.
    void report_run(const Model& plain, const Supervisor& found) {
        const auto system = transition_system_of(plain, loop_, untimed(request_), diagnostics_);
        if (!system) return;
        const FlatSystem flat = flattened(*system);
        FlatRun run;
        for (const std::vector<std::int64_t>& state : found.run->states) {
            std::vector<std::int64_t>& values = run.states.emplace_back();
            for (const FlatSystem::Variable& variable : flat.variables) {
                const auto same = std::ranges::find(found.flat.variables, variable.name, &FlatSystem::Variable::name);
                values.push_back(state[static_cast<std::size_t>(same - found.flat.variables.begin())]);
            }
        }
        ChartRun chart_run = project(*system, system_run(flat, run));
        if (const auto wrong = disagreement(chart_run, charts_of(plain, plain.loops[loop_])))
            made_.failures.push_back(replay_failure("the trace that no conditions prevent", *wrong));
        else made_.run = with_rows(std::move(chart_run));
    }

    void write(const Supervisor& found) {
        std::map<Id<Source>, std::map<std::uint32_t, NamedTerm>> edits;
        const ClosedLoop& loop = model_.loops[loop_];
        for (const Supervisor::Condition& condition : found.conditions) {
            const PermittedElement& held = held_[condition.controller][condition.permission];
            const Chart& chart =
                model_.charts[loop.controllers[{static_cast<std::uint32_t>(condition.controller)}].chart];
            NamedTerm term{.all = condition.all};
            for (const auto& group : condition.terms) {
                auto& names = term.terms.emplace_back();
                for (const Supervisor::Literal& literal : group)
                    names.emplace_back(sights_[condition.controller].names[literal.seen], literal.value);
            }
            const std::size_t site = condition.site.value_or(0);
            const Span place = held.places[site];
            const std::string step = held.output ? step_variable(chart, held.steps[site]) : std::string();
            const bool sum = term.all ? term.terms.size() == 1 && term.terms[0].size() > 1 : term.terms.size() > 1;
            made_.conditions.push_back({chart.name, held.subject, step, text_of(term), sum, place});
            edits[place.source].emplace(place.begin, std::move(term));
        }
        std::map<std::string, std::string> texts;
        for (const auto& [file, terms] : edits) {
            texts[sources_[file].name] = with_conditions(file, sources_, terms);
            made_.file = file;
        }
        if (edits.empty()) {
            made_.file = loop.origin.source;
            texts[sources_[*made_.file].name] = with_conditions(*made_.file, sources_, {});
        }
        made_.text = texts.begin()->second;
        if (edits.size() > 1) made_.file.reset();
        prove(std::move(texts));
    }

    /// If `--marked` is given, adds the property about the marked situation to the closed loop in `texts`.
    void add_marked(std::map<std::string, std::string>& texts, Diagnostics& diagnostics) const {
        if (request_.marked.empty()) return;
        const std::string& file = sources_[model_.loops[loop_].origin.source].name;
        const auto changed = texts.find(file);
        Sources sources;
        const Id<Source> source = sources.add(
            {file, changed == texts.end() ? sources_[model_.loops[loop_].origin.source].text : changed->second});
        if (auto text = with_marked(source, sources, made_.loop, marked_, request_.marked, diagnostics))
            texts[file] = std::move(*text);
    }

    /// Parses the texts of the charts with conditions, and proves the properties with two different engines.
    void prove(std::map<std::string, std::string> texts) {
        Sources sources;
        Diagnostics diagnostics;
        const auto fail = [&](const std::string& why) {
            made_.failures.push_back("the chart with conditions: " + why);
        };
        add_marked(texts, diagnostics);
        const auto model = read_again(main_, texts, sources_, sources, request_.read, diagnostics);
        const auto loop = model ? find_loop(*model, made_.loop) : std::nullopt;
        auto system = loop ? transition_system_of(*model, *loop, untimed(request_), diagnostics) : std::nullopt;
        if (!system) return fail("the text cannot be read");
        if (request_.marked.empty()) {
            Property marked{.name = marked_, .pattern = Pattern::AlwaysPossible};
            marked.operands = {initial_situation(*system, *model, model->loops[*loop])};
            system->properties.add(std::move(marked));
        }
        const SystemToCheck check = system_to_check(*system, *model, *loop, untimed(request_));
        std::vector<std::string> names = made_.kept;
        names.push_back(marked_);
        const std::vector<std::string> unproved = left_unproved(grafverif::check(check, options(names)), names);
        if (unproved.empty()) prove_again(*model, *loop, check);
    }

    CheckOptions options(const std::vector<std::string>& names) const {
        CheckOptions made;
        made.properties = names;
        made.witnesses = false;
        made.limits = request_.limits;
        return made;
    }

    /// Makes the second proof with the timed engine, which uses a network instead of a transition system. If the timed
    /// engine does not decide a property, PDR proves it.
    void prove_again(const Model& model, Id<ClosedLoop> loop, const SystemToCheck& check) {
        Diagnostics diagnostics;
        std::vector<std::string> names = made_.kept;
        if (const auto network = network_of(model, loop, untimed(request_), diagnostics)) {
            const std::vector<std::string> known = property_names(*network);
            CheckOptions timed = in_timed_loop({});
            for (const Property& property : network->properties)
                if (property.pattern == Pattern::NoTimelock) timed.properties = {property.name};
            if (timed.properties.empty()) timed.properties = {"no_timelock"};
            for (const std::string& name : names)
                if (std::ranges::find(known, name) != known.end()) timed.properties.push_back(name);
            const Report report = check_without_causes(loop_to_check(model, loop, *network), timed);
            for (const PropertyResult& answer : report.answers)
                if (answer.verdict.pattern == Pattern::NoTimelock) made_.timelock = answer.verdict.outcome;
            Report selected = report;
            std::erase_if(selected.answers, [](const PropertyResult& answer) {
                return answer.verdict.pattern == Pattern::NoTimelock || answer.verdict.outcome == Outcome::Unknown;
            });
            names = unanswered(selected, names);
            (void)left_unproved(selected, {});
        }
        if (!names.empty()) (void)left_unproved(check_states(check, options(names)), names);
    }

    static std::vector<std::string> unanswered(const Report& report, std::vector<std::string> names) {
        for (const PropertyResult& answer : report.answers) std::erase(names, answer.verdict.property);
        return names;
    }

    /// Returns the properties in `names` that `report` does not prove: it contains no verdict on them, or a verdict
    /// other than `holds`. If the result is not empty, sets the outcome to unknown. Adds an internal failure for each
    /// violated property.
    std::vector<std::string> left_unproved(const Report& report, const std::vector<std::string>& names) {
        made_.failures.insert(made_.failures.end(), report.failures.begin(), report.failures.end());
        for (const ModelErrorTrace& breakdown : report.error_traces) made_.failures.push_back(breakdown.message);
        std::vector<std::string> left = unanswered(report, names);
        std::string why = "the property was not checked";
        for (const PropertyResult& answer : report.answers) {
            const Verdict& verdict = answer.verdict;
            if (verdict.outcome == Outcome::Holds) continue;
            left.push_back(verdict.property);
            why = verdict.reason;
            if (verdict.outcome == Outcome::Violated)
                made_.failures.push_back(fmt::format("with the conditions, engine {} finds `{}` violated",
                                                     report.settings.engine, verdict.property));
        }
        if (!left.empty()) {
            made_.outcome = Supervisor::Outcome::Unknown;
            made_.reason = fmt::format("conditions were found, but engine {} did not prove `{}` for them: {}",
                                       report.settings.engine, left.front(), why);
        }
        return left;
    }

    const Model& model_;
    Id<ClosedLoop> loop_ = {};
    Id<Source> main_ = {};
    Sources& sources_;
    const SuperviseRequest& request_;
    Diagnostics& diagnostics_;
    std::string marked_ = {};  ///< name of the property: the marked situation remains reachable
    std::vector<std::vector<PermittedElement>> held_ = {};  ///< for each controller: its permissions
    std::vector<ObservableVariables> sights_ = {};  ///< for each controller: the variables that conditions may read
    Supervised made_ = {};
};

}  // namespace

std::optional<Supervised> supervised(const Model& model, Id<ClosedLoop> loop, Id<Source> main, Sources& sources,
                                     const SuperviseRequest& request, Diagnostics& diagnostics) {
    // Task cycles are rejected, because all evolutions of one scan would use the same permissions, but the supervisor
    // chooses permissions for each evolution.
    const std::size_t errors = diagnostics.errors();
    for (const ClosedLoop::Controller& controller : model.loops[loop].controllers)
        if (model.charts[controller.chart].program)
            diagnostics.add(messages::only_for_charts(controller.origin, controller.name,
                                                      "`supervise` restricts the transitions of charts",
                                                      "use a chart as the controller"));
        else if (controller.cycle)
            diagnostics.add(messages::not_yet(controller.cycle->origin, "a task cycle in `supervise`"));
        else if (const auto copies = replicated_element(model.charts[controller.chart], sources))
            diagnostics.add(messages::not_yet(*copies, "a replicated declaration or a chart instance in `supervise`"));
    if (diagnostics.errors() != errors) return {};
    return Supervising(model, loop, main, sources, request, diagnostics).run();
}

}  // namespace grafverif
