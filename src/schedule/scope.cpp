// SPDX-License-Identifier: MIT
#include "schedule/scope.hpp"

namespace grafverif::schedule {

namespace {

std::string outputs_written(std::span<const ControllerPart> controllers) {
    std::string text;
    for (const ControllerPart& controller : controllers) {
        text += controllers.size() > 1 ? "The outputs of " + controller.equations.name : "Outputs";
        text += controller.mode == ExecutionMode::StabilitySearch ? " are written when the situation is stable. "
                                                                  : " are written in every cycle. ";
    }
    return text;
}

const std::string power_on =
    "State 0 is power-on. The first step is the first evolution; if it changes nothing, it is omitted. ";

const char* fair_runs =
    "Verdicts on properties of runs assume fairness: every movement of the plant ends, every running timer expires or "
    "stops, and urgent edges are not postponed forever. Buttons, faults and other parts of the environment remain "
    "free. ";

}  // namespace

std::string controllers_scope(std::span<const ControllerPart> controllers, bool constrained) {
    const bool several = controllers.size() > 1;
    const std::string one = several ? "the controllers" : "the controller";
    std::string text =
        "This model is " + one + " alone: in every cycle the inputs" +
        (constrained ? ", within the constraints," : "") + " and the outputs of timers take any value. " +
        (several ? "In one step, each selected controller runs one PLC cycle; each is selected infinitely often. "
                 : "One step is one PLC cycle. ") +
        power_on + outputs_written(controllers);
    text +=
        "An `always`, `never`, `exactly one of` or `inevitable` that holds here, and a `leads to` that holds and whose "
        "premise reads no input, holds with every plant " +
        std::string(constrained ? "that satisfies the constraints " : "") + "in grain atomic, provided that " +
        (several ? "each controller runs" : "the plant lets the controller run") +
        "; a `reachable` that is violated here is also violated with every such plant. Any other property that is "
        "violated here may hold with the real plant. All other verdicts apply only to this model: a `reachable` that "
        "holds, `always possible`, CTL and LTL formulas, properties of observers, and all properties at stable except "
        "`always`, `never` and `exactly one of`.";
    if (constrained)
        text += " The constraints are assumptions: prove with plant automata that the plant satisfies them.";
    return text;
}

std::string together_scope(Schedule schedule, std::span<const ControllerPart> controllers, bool fairness) {
    std::string text =
        "This model is the closed loop with its plant automata, without time: a timed edge may be taken at any time. ";
    if (schedule == Schedule::Synchronous)
        text +=
            "Schedule synchronous: in one step every controller runs one PLC cycle and every automaton takes one "
            "edge, all from the same state; an automaton stays in its location only if no urgent edge can be taken. ";
    else
        text +=
            "Schedule sequenced: controllers and plant alternate. The controllers run cycles until they are stable "
            "(one cycle if outputs are written in every cycle); then the plant executes rounds until a round changes "
            "nothing. In a round, the automata take one edge each, in any order; an automaton stays in its location "
            "only if no urgent edge can be taken; "
            "timed edges can be taken only in the first round. Every property is checked at the end of each evolution "
            "of the plant (PTE) and of the controllers, but not in the states between. ";
    text += power_on + outputs_written(controllers);
    if (fairness) text += fair_runs;
    return text +
           "This schedule restricts the order of events: every verdict applies only to this model, not to the timed "
           "closed loop. In the timed closed loop, sensor changes can be sampled separately, and outputs can change "
           "between two sensor changes.";
}

std::string network_scope(const Network& network, const ScheduleOptions& options) {
    const std::string grain = network.grain == Grain::Phased ? "phased" : "atomic";
    std::string text = "This model is the closed loop with its plant automata, schedule interleaved, grain " + grain +
                       ": in each step, one automaton or the PLC takes an edge";
    if (options.time == TimeModel::Discrete) {
        text +=
            ", or time passes by one unit. Clocks count time units: the states are those of the timed closed loop in "
            "integer time. ";
        if (options.fairness) text += fair_runs;
        return text +
               "Verdicts on `always`, `never`, `exactly one of` and `reachable` are valid for the timed loop in this "
               "grain if its clock constraints are closed; other verdicts are valid for integer time only.";
    }
    text +=
        "; if no urgent edge can be taken, a step may also change nothing. Time is not modelled: a timed edge may be "
        "taken at any time. ";
    if (options.fairness)
        return text + fair_runs +
               "Verdicts on properties about single states do not depend on fairness. An `always`, `never` or `exactly "
               "one of` that holds here also holds in the timed closed loop of this mode and grain. A `reachable` that "
               "is violated here is also violated in the timed loop. All other verdicts apply only to this model. "
               "In a CTL formula, EF requires a fair run.";
    return text +
           "Every run of the timed closed loop of this mode and grain is also a run of this model. Therefore, an "
           "`always`, `never`, `exactly one of`, `inevitable` or `leads to` that holds here also holds in the timed "
           "loop. A `reachable` that is violated here is also violated in the timed loop. No other verdict is "
           "preserved: any other property that is violated here may hold in the timed loop.";
}

}  // namespace grafverif::schedule
