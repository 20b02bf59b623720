// SPDX-License-Identifier: MIT
// Texts of diagnostics about location automata, Mealy machines and test sequences.
#include <fmt/format.h>

#include "support/messages.hpp"
#include "support/messages_system.hpp"
#include "support/wording.hpp"

namespace grafverif::messages {

Diagnostic excludes_every_input(Span where) {
    return error("excludes-every-input", where,
                 "no combination of inputs satisfies this constraint and the constraints before it; weaken one of "
                 "these constraints");
}

Diagnostic initial_never_stable(Span where, std::string_view inputs, std::string_view cycle) {
    return error("never-stable", where,
                 fmt::format("no combination of inputs leads from the initial situation to a stable one: with {}, the "
                             "chart cycles forever through the situations {}; add a condition that breaks the cycle",
                             clipped(inputs), clipped(cycle)));
}

Diagnostic action_race(Span where, std::string_view variable, std::string_view when) {
    return error("action-race", where,
                 fmt::format("two actions store different values in `{}` in the same evolution, in {}; make their "
                             "conditions exclusive, or exclude these inputs with a `constraint`",
                             clipped(variable), clipped(when)));
}

Diagnostic forcing_race(Span where, std::string_view when) {
    return error(
        "action-race", where,
        fmt::format("two contradictory forcing orders are active at the same time, in {}; make their steps exclusive",
                    clipped(when)));
}

Diagnostic no_value_in_location(Span where, std::string_view when) {
    return error(
        "no-value", where,
        fmt::format("the value is undefined in {}: division by zero or overflow; guard the operation with a condition",
                    clipped(when)));
}

Diagnostic out_of_range_in_location(Span where, std::string_view variable, std::int64_t value, std::string_view when) {
    return error(
        "out-of-range", where,
        fmt::format("`{}` is assigned {}, which is outside its range, in {}; extend the range or guard the assignment",
                    clipped(variable), value, clipped(when)));
}

Diagnostic too_many_locations(Span where, std::uint64_t limit) {
    return error("bound-reached", where,
                 fmt::format("the location automaton has more than {} locations; raise `--max-states`", limit));
}

Diagnostic too_many_pairs(Span where, std::size_t states, std::uint64_t limit) {
    return error("too-large", where,
                 fmt::format("{} states with every combination of inputs require more than {} transitions; use "
                             "`--cover evolutions` or `--cover locations`",
                             states, limit));
}

Diagnostic too_many_nodes(std::size_t nodes, std::size_t limit) {
    return error(
        "too-large", {},
        fmt::format("an automaton with {} states is too large to draw (limit: {}); use `--format dot` with Graphviz",
                    nodes, limit));
}

Diagnostic too_many_states(Span where, std::uint64_t limit) {
    return error(
        "bound-reached", where,
        fmt::format("the Mealy machine has more than {} states, including states of timers; raise `--max-states`",
                    limit));
}

Diagnostic automaton_too_large(Span where) {
    return error("bound-reached", where,
                 "the conditions of the location automaton exceed the memory limit; raise `--max-memory`");
}

Diagnostic stopped(Span where, bool by_user) {
    return error("stopped", where,
                 fmt::format("stopped {}; no output was written",
                             by_user ? "by Ctrl-C or another signal" : "at the time limit (`--timeout`)"));
}

Diagnostic timed_out(std::uint64_t milliseconds) {
    const std::string time =
        milliseconds % 1000 == 0 ? fmt::format("{} s", milliseconds / 1000) : fmt::format("{} ms", milliseconds);
    return error("stopped", {}, fmt::format("time limit of {} reached before completion; raise `--timeout`", time));
}

Diagnostic interrupted() { return error("stopped", {}, "interrupted by Ctrl-C before completion"); }

Diagnostic out_of_memory(std::optional<std::uint64_t> allowed) {
    return error(
        "out-of-memory", {},
        allowed ? fmt::format("memory limit of {} MiB reached before completion; raise `--max-memory`", *allowed >> 20U)
                : std::string("out of memory: the system refused an allocation; make more memory available"));
}

Diagnostic deprecated_option(std::string_view former, std::string_view name) {
    return warning("deprecated-option", {}, fmt::format("`--{}` is deprecated; use `--{}`", former, name));
}

Diagnostic threads_refused() {
    return error("threads-refused", {},
                 "the system refuses to start a thread or process; raise its limits (`ulimit -u`, `ulimit -v`) or "
                 "`--max-memory`");
}

Diagnostic too_many_inputs(Span where, std::string_view chart, std::size_t bits, std::size_t limit) {
    return error("too-many-inputs", where,
                 fmt::format("the inputs of `{}` have 2^{} combinations, which is too many to test in every state "
                             "(limit: 2^{}); use `--cover evolutions` or `--cover locations`",
                             clipped(chart), bits, limit));
}

}  // namespace grafverif::messages
