// SPDX-License-Identifier: MIT
// Execution of a chart by a PLC, and types of models of a closed loop.
//
// ScheduleOptions: selects the untimed model of a closed loop.
//
// Approach (DESDES06 sections 3, 5.1, 5.2):
//   none          the controllers without plant automata; their inputs are free
//   constraints   as `none`, but the inputs satisfy the constraints of the loop and of its components in every state
//   automata      the controllers with one automaton for each instance of the plant
// Schedule, only with plant automata:
//   interleaved   in each step one enabled automaton, or the PLC, moves
//   synchronous   in each step, every controller executes one cycle and every automaton takes one edge (DESDES06)
//   sequenced     plant and controllers alternate; the controllers run only when the plant is quiescent (WODES06)
// Time, only with plant automata and the interleaved schedule:
//   abstract      clocks are ignored: edges with clock constraints may be taken at any time
//   discrete      clocks count time units; the model has the same states as the timed engine
#pragma once

#include <cstdint>
#include <optional>
#include <string_view>

#include "grafverif/support/source.hpp"

namespace grafverif {

/// Execution mode (JESA13 section 3.2, Algorithms 1 and 2): outputs are written when the situation is stable, or in
/// every cycle.
enum class ExecutionMode { StabilitySearch, EveryCycle };

/// Returns `stability-search` or `every-cycle`.
constexpr std::string_view word(ExecutionMode mode) {
    return mode == ExecutionMode::StabilitySearch ? "stability-search" : "every-cycle";
}

/// Task cycle of a PLC: the time between the starts of two successive scans is any value from `least_ms` to `most_ms`.
/// The first scan is at power-on. A scan takes no time; it samples the inputs once, at the start of the scan.
struct TaskCycle {
    std::int64_t least_ms = 0, most_ms = 0;  ///< 1 <= least_ms <= most_ms
    Span origin = {};
    bool operator==(const TaskCycle&) const = default;
};

/// Interleaving granularity. Phased: the plant may move between the phases of a PLC cycle. Atomic: a complete PLC cycle
/// is one edge, so the plant cannot move within the cycle.
enum class Grain { Phased, Atomic };
/// Order of moves in an untimed model. Interleaved: any enabled automaton moves next. Synchronous: all controllers and
/// automata move in each step (DESDES06). Sequenced: controllers and plant alternate, and the plant moves until it is
/// quiescent (WODES06).
enum class Schedule { Interleaved, Synchronous, Sequenced };

enum class PlantApproach { None, Constraints, Automata };
enum class TimeModel { Abstract, Discrete };

struct ScheduleOptions {
    std::optional<ExecutionMode> mode = {};  ///< overrides the modes of the controllers
    PlantApproach plant = PlantApproach::None;
    std::optional<Schedule> schedule = {};  ///< overrides the schedule of the loop; default: interleaved
    TimeModel time = TimeModel::Abstract;
    bool fairness = false;  ///< assume that every plant movement ends: one justice condition for each movement
};

}  // namespace grafverif
