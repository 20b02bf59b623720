// SPDX-License-Identifier: MIT
// How a PLC executes a chart, and which models are made of a closed loop.
//
// ScheduleOptions: which untimed model of a closed loop is made.
//
// Approach (DESDES06 sections 3, 5.1, 5.2):
//   none          the controllers alone; their inputs are free
//   constraints   the same, and the constraints of the loop and of its components hold of the inputs in every state
//   automata      one automaton per instance of the plant
// Schedule, with plant automata only:
//   interleaved   one automaton, or the PLC, moves in each step; any that can
//   synchronous   the controllers run one cycle and every automaton takes one edge in each step (DESDES06)
//   sequenced     plant and controllers take turns; the plant settles before the controllers see it (WODES06)
// Time, with plant automata and interleaved only:
//   abstract      a timed edge may fire at any moment
//   discrete      clocks count units of time; the states are those of the timed engine
#pragma once

#include <optional>
#include <string_view>

namespace grafverif {

/// How a PLC executes a chart (JESA13 section 3.2, Algorithms 1 and 2): outputs are written once the situation is stable,
/// or in every cycle.
enum class ExecutionMode { StabilitySearch, EveryCycle };

/// `stability-search`, `every-cycle`.
constexpr std::string_view word(ExecutionMode mode) {
    return mode == ExecutionMode::StabilitySearch ? "stability-search" : "every-cycle";
}

/// Whether the plant may move between the phases of one PLC cycle, or a cycle is one edge.
enum class Grain { Phased, Atomic };
/// In an untimed model with plant automata: any enabled automaton moves next; controller and automata step together
/// (DESDES06); plant and controller take turns, and the plant settles in between (WODES06).
enum class Schedule { Interleaved, Synchronous, Sequenced };

enum class PlantApproach { None, Constraints, Automata };
enum class TimeModel { Abstract, Discrete };

struct ScheduleOptions {
    std::optional<ExecutionMode> mode = {};  ///< wins over the controllers'
    PlantApproach plant = PlantApproach::None;
    std::optional<Schedule> schedule = {};  ///< wins over the loop's; else interleaved
    TimeModel time = TimeModel::Abstract;
    bool fairness = false;  ///< every movement ends: one justice condition for each
};

}  // namespace grafverif
