// SPDX-License-Identifier: MIT
#include "support/untimed_loop.hpp"

#include <gtest/gtest.h>

#include <sstream>
#include <stdexcept>

#include "plant/plant.hpp"
#include "schedule/controller.hpp"
#include "schedule/network.hpp"
#include "schedule/together.hpp"
#include "support/derived.hpp"
#include "support/read_loop.hpp"

namespace grafverif {

namespace {

[[noreturn]] void give_up(const Diagnostics& diagnostics) {
    std::string problem = "no model";
    for (const Diagnostic& diagnostic : diagnostics.all()) problem += "\n" + diagnostic.message;
    throw std::invalid_argument(problem);
}

std::optional<TransitionSystem> scheduled(const Model& model, const ScheduleOptions& options, Grain grain,
                                          Diagnostics& diagnostics) {
    const ClosedLoop& loop = model.loops[{0}];
    const auto derivation = derived(model, diagnostics);
    if (!derivation) return {};
    const std::vector<Equations>& equations = *derivation;
    if (options.plant != PlantApproach::Automata) {
        if (options.plant == PlantApproach::Constraints && !constraints_agree(loop, diagnostics)) return {};
        return schedule_controllers(model, loop, equations, options);
    }
    const auto plant_network = plant(model, loop, diagnostics);
    if (!plant_network) return {};
    if (options.schedule.value_or(loop.schedule.value_or(Schedule::Interleaved)) != Schedule::Interleaved)
        return schedule_together(model, loop, equations, *plant_network, options, diagnostics);
    const auto network = compose(*plant_network, loop, equations, {grain, options.mode, {}}, diagnostics);
    if (!network) return {};
    return schedule_network(model, loop, equations, *network, options, diagnostics);
}

}  // namespace

TransitionSystem untimed_loop(const Model& model, const ScheduleOptions& options, Grain grain) {
    Diagnostics diagnostics;
    auto system = scheduled(model, options, grain, diagnostics);
    if (!system) give_up(diagnostics);
    EXPECT_EQ(verify(*system), std::vector<std::string>{});
    return std::move(*system);
}

std::vector<TransitionSystem> untimed_models(const Model& model, bool fairness) {
    struct Kind {
        ScheduleOptions options = {};
        Grain grain = Grain::Phased;
    };
    using enum PlantApproach;
    using enum Schedule;
    std::vector<Kind> kinds{{{.plant = None}}, {{.plant = Constraints}}};
    for (const Schedule schedule : {Synchronous, Sequenced})
        kinds.push_back({{.plant = Automata, .schedule = schedule}});
    for (const Grain grain : {Grain::Atomic, Grain::Phased})
        for (const TimeModel time : {TimeModel::Abstract, TimeModel::Discrete})
            kinds.push_back({{.plant = Automata, .schedule = Interleaved, .time = time}, grain});
    std::vector<TransitionSystem> made;
    for (Kind& kind : kinds) {
        kind.options.fairness = fairness && kind.options.plant == Automata;
        Diagnostics diagnostics;
        auto system = scheduled(model, kind.options, kind.grain, diagnostics);
        if (!system) continue;
        EXPECT_EQ(verify(*system), std::vector<std::string>{}) << system->scope;
        made.push_back(std::move(*system));
    }
    return made;
}

TransitionSystem untimed_text(const std::string& text, const ScheduleOptions& options, Grain grain) {
    return untimed_loop(read_loop(text).model, options, grain);
}

TransitionSystem untimed_sample(const std::string& path, const ScheduleOptions& options, Grain grain) {
    return untimed_loop(read_sample(path).model, options, grain);
}

}  // namespace grafverif
