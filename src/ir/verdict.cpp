// SPDX-License-Identifier: MIT
#include "grafverif/ir/verdict.hpp"

#include <fmt/format.h>

#include <string>

#include "support/overloaded.hpp"

namespace grafverif {

namespace {

std::string edge_text(const Network& network, const ModelError& error) {
    const Network::Process& process = network.processes[error.process];
    for (const Network::Controller& controller : network.controllers)
        if (controller.process == error.process) return fmt::format("an evolution of `{}`", controller.words.name);
    const Network::Template& automaton = network.templates[process.automaton];
    const Network::Edge& edge = automaton.edges[error.edge];
    return fmt::format("`{}` on the edge {} -> {}", process.name, automaton.locations[edge.from].name,
                       automaton.locations[edge.to].name);
}

}  // namespace

std::string text_of(const Network& network, const ModelError& error) {
    switch (error.kind) {
    case ModelError::Kind::OutOfRange: {
        const Network::Variable& variable = network.variables[error.variable];
        return fmt::format("`{}` would leave its range {}..{}, in {}", variable.name, variable.type.low,
                           variable.type.high, edge_text(network, error));
    }
    case ModelError::Kind::ActionRace: return "two stored actions give one variable different values in one evolution";
    case ModelError::Kind::NoValue: return fmt::format("division by zero, in {}", edge_text(network, error));
    }
    unreachable();
}

std::string_view word(Outcome outcome) {
    switch (outcome) {
    case Outcome::Holds: return "holds";
    case Outcome::Violated: return "violated";
    case Outcome::Unknown: return "unknown";
    }
    unreachable();
}

std::string_view word(UnknownReason obstacle) {
    switch (obstacle) {
    case UnknownReason::None: return "";
    case UnknownReason::Bound: return "bound";
    case UnknownReason::Memory: return "memory";
    case UnknownReason::Stopped: return "stopped";
    case UnknownReason::Inexact: return "inexact";
    case UnknownReason::Unsupported: return "unsupported";
    case UnknownReason::Faulty: return "faulty";
    case UnknownReason::Failed: return "failed";
    case UnknownReason::Unchecked: return "unchecked";
    case UnknownReason::Disagrees: return "engine-disagrees";
    }
    unreachable();
}

std::string_view word(ModelError::Kind kind) {
    switch (kind) {
    case ModelError::Kind::OutOfRange: return "out-of-range";
    case ModelError::Kind::ActionRace: return "action-race";
    case ModelError::Kind::NoValue: return "no-value";
    }
    unreachable();
}

Verdict verdict_on(Id<Property> about, const Property& property) {
    return {.about = about,
            .property = property.name,
            .pattern = property.pattern,
            .declared = about.valid(),
            .expected_violated = property.expected_violated,
            .origin = property.origin};
}

void set_unknown(Verdict& verdict, UnknownReason obstacle, std::string reason) {
    verdict.outcome = Outcome::Unknown;
    verdict.obstacle = obstacle;
    verdict.reason = std::move(reason);
}

std::string memory_limit_reached(std::uint64_t bytes) {
    return "memory limit of " + std::to_string(bytes >> 20U) + " MiB reached";
}

void distrust(Verdict& verdict, std::string_view why) {
    set_unknown(verdict, UnknownReason::Disagrees,
                std::string(word(UnknownReason::Disagrees)) + ": " + std::string(why));
}

bool as_expected(const Verdict& verdict) {
    return verdict.outcome == (verdict.expected_violated ? Outcome::Violated : Outcome::Holds);
}

}  // namespace grafverif
