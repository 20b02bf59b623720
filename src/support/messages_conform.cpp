// SPDX-License-Identifier: MIT
// Texts of diagnostics about location automata, Mealy machines and test sequences.
#include <fmt/format.h>

#include "support/messages.hpp"
#include "support/messages_system.hpp"
#include "support/wording.hpp"

namespace grafverif::messages {

Diagnostic excludes_every_input(Span where) {
    return error("excludes-every-input", where,
                 "no combination of inputs is left by this constraint and those before it; weaken one of them");
}

Diagnostic initial_never_stable(Span where, std::string_view inputs, std::string_view cycle) {
    return error(
        "never-stable", where,
        fmt::format(
            "from the initial situation no combination of inputs leads to a stable one; with {} the situations {} "
            "follow each other for ever",
            clipped(inputs), clipped(cycle)));
}

Diagnostic action_race(Span where, std::string_view variable, std::string_view when) {
    return error(
        "action-race", where,
        fmt::format(
            "two actions store different values in `{}` at once: in {}; make their conditions exclusive, or exclude "
            "these inputs by a `constraint`",
            clipped(variable), clipped(when)));
}

Diagnostic forcing_race(Span where, std::string_view when) {
    return error("action-race", where,
                 fmt::format("two forcing orders that exclude each other are active at once: in {}", clipped(when)));
}

Diagnostic no_value_in_location(Span where, std::string_view when) {
    return error("no-value", where,
                 fmt::format("this has no value in {}: division by zero, or a number too large", clipped(when)));
}

Diagnostic out_of_range_in_location(Span where, std::string_view variable, std::int64_t value, std::string_view when) {
    return error("out-of-range", where,
                 fmt::format("`{}` would get the value {}, which is outside its range, in {}", clipped(variable), value,
                             clipped(when)));
}

Diagnostic too_many_locations(Span where, std::uint64_t limit) {
    return error("bound-reached", where,
                 fmt::format("the location automaton has more than {} locations; raise `--max-states`", limit));
}

Diagnostic too_many_pairs(Span where, std::size_t states, std::uint64_t limit) {
    return error(
        "too-large", where,
        fmt::format(
            "{} states under every combination of inputs are more than {} transitions to cover; `--cover evolutions` "
            "or `--cover locations` asks for less",
            states, limit));
}

Diagnostic too_many_nodes(std::size_t nodes, std::size_t limit) {
    return error(
        "too-large", {},
        fmt::format(
            "{} states make no drawing or table that a person could read, the limit is {}; `--format dot` is for "
            "Graphviz",
            nodes, limit));
}

Diagnostic too_many_states(Span where, std::uint64_t limit) {
    return error(
        "bound-reached", where,
        fmt::format("the Mealy machine has more than {} states, as its timers run; raise `--max-states`", limit));
}

Diagnostic automaton_too_large(Span where) {
    return error("bound-reached", where,
                 "the conditions of the location automaton need more memory than allowed; raise `--max-memory`");
}

Diagnostic stopped(Span where, bool by_user) {
    return error("stopped", where,
                 fmt::format("stopped before the end {}; nothing was written",
                             by_user ? "by Ctrl-C or another signal" : "by the time limit, which `--timeout` sets"));
}

Diagnostic timed_out(std::uint64_t milliseconds) {
    const std::string time =
        milliseconds % 1000 == 0 ? fmt::format("{} s", milliseconds / 1000) : fmt::format("{} ms", milliseconds);
    return error("stopped", {},
                 fmt::format("stopped before the end: the time allowed, {}, is over; raise `--timeout`", time));
}

Diagnostic interrupted() { return error("stopped", {}, "stopped before the end, as asked for by Ctrl-C"); }

Diagnostic out_of_memory(std::optional<std::uint64_t> allowed) {
    return error(
        "out-of-memory", {},
        allowed ? fmt::format("stopped before the end: the memory allowed, {} MiB, is used up; raise `--max-memory`",
                              *allowed >> 20U)
                : std::string("stopped before the end: the system gives no more memory"));
}

Diagnostic threads_refused() {
    return error("threads-refused", {},
                 "stopped before the end: the system refuses to start a thread or a process; raise its limits (`ulimit "
                 "-u`, `ulimit -v`) or `--max-memory`");
}

Diagnostic too_many_inputs(Span where, std::string_view chart, std::size_t bits, std::size_t limit) {
    return error(
        "too-many-inputs", where,
        fmt::format(
            "the inputs of `{}` have 2^{} combinations, and every one of them in every state is too much above 2^{}; "
            "`--cover evolutions` or `--cover locations` asks for less",
            clipped(chart), bits, limit));
}

}  // namespace grafverif::messages
