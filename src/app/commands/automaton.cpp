// SPDX-License-Identifier: MIT
// `automaton` and `mealy`: show the behaviour of a controller as a location automaton and as a Mealy machine.
#include "syntax/print/automaton.hpp"

#include <fmt/format.h>

#include <ostream>
#include <sstream>

#include "app/commands.hpp"
#include "emit/layout/diagram.hpp"
#include "support/messages.hpp"

namespace grafverif::app {

namespace {

/// Prints to the file given by `-o`, otherwise to standard output. Text for standard output is not stored in memory
/// before it is printed, because an automaton may be large.
template <class Print>
void print_to_output(CommandContext& job, const Streams& streams, Print print) {
    if (!job.options.output) return print(streams.out);
    std::ostringstream text;
    print(text);
    deliver(std::move(text).str(), job, streams);
}

/// Writes the drawing. Returns false after an error.
bool draw(const Diagram& drawn, CommandContext& job, const Streams& streams) {
    const std::size_t nodes = job.options.format == Format::Svg ? drawn.nodes.size() : 0;
    if (nodes > largest_table) {
        job.diagnostics.add(messages::too_many_nodes(nodes, largest_table));
        return false;
    }
    if (nodes > largest_drawing && !job.options.quiet)
        streams.err << fmt::format(
            "note: {} locations are too many for a drawing (limit: {}); a table is written instead\n", nodes,
            largest_drawing);
    print_to_output(job, streams, [&](std::ostream& out) {
        job.options.format == Format::Svg ? emit_svg(drawn, out) : emit_dot(drawn, out);
    });
    return true;
}

bool is_drawing(Format format) { return format == Format::Dot || format == Format::Svg; }

}  // namespace

ExitCode automaton(CommandContext& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto chart = model ? chosen_chart(*model, job) : std::nullopt;
    const ResourceLimits bounds(job.options, streams);
    ConformOptions options = conform_options(job.options, bounds.limits());
    options.partial = job.options.counts && !is_drawing(job.options.format);
    const auto found = chart ? automaton_of(*model, *chart, options, job.diagnostics) : std::nullopt;
    if (!found) return bounds.interrupted() ? ExitCode::Unknown : ExitCode::Input;
    if (is_drawing(job.options.format)) return draw(diagram(*found), job, streams) ? ExitCode::Done : ExitCode::Input;
    print_to_output(job, streams, [&](std::ostream& out) {
        if (job.options.format == Format::Json) print_automaton_json(out, *found, !job.options.counts);
        else print_automaton(out, *found, !job.options.counts);
    });
    return found->complete ? ExitCode::Done : ExitCode::Unknown;
}

ExitCode mealy(CommandContext& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto chart = model ? chosen_chart(*model, job) : std::nullopt;
    const ResourceLimits bounds(job.options, streams);
    const auto found =
        chart ? mealy_of(*model, *chart, conform_options(job.options, bounds.limits()), job.diagnostics) : std::nullopt;
    if (!found) return bounds.interrupted() ? ExitCode::Unknown : ExitCode::Input;
    if (is_drawing(job.options.format)) return draw(diagram(*found), job, streams) ? ExitCode::Done : ExitCode::Input;
    print_to_output(job, streams, [&](std::ostream& out) {
        if (job.options.format == Format::Json) print_mealy_json(out, *found, !job.options.counts);
        else print_mealy(out, *found, !job.options.counts);
    });
    return ExitCode::Done;
}

CliCommand automaton_usage() {
    return {
        "automaton",
        "FILE",
        1,
        1,
        "print the location automaton of a chart",
        "Prints the location automaton: one location for each combination of a situation and stored values; "
        "evolutions\n"
        "between locations, each with a condition on the inputs; and the inputs for which the situation never becomes "
        "stable.\n"
        "Constraints of the chart restrict the inputs. The default mode is the mode of the closed loop that contains "
        "this "
        "chart,\n"
        "or stability-search if there is none.\n"
        "Formats: text, JSON, DOT (Graphviz), SVG.",
        {"grafverif automaton samples/tanks/tanks.grafcet --mode every-cycle",
         "grafverif automaton samples/tanks/tanks.grafcet --format svg -o tanks.svg",
         "grafverif automaton samples/tanks/tanks.grafcet --format json --counts"},
        {OptionGroup::Output, OptionGroup::Chart, OptionGroup::Mode, OptionGroup::FormatDiagram, OptionGroup::Limits}};
}

CliCommand mealy_usage() {
    return {
        "mealy",
        "FILE",
        1,
        1,
        "print the Mealy machine of a chart",
        "Prints the Mealy machine of a chart: the location automaton with the values of all outputs for every\n"
        "combination of inputs in every state. INIT (the controller after power-on) is merged with the location of\n"
        "the initial situation. Sets of inputs are printed as conditions, not as lists. For a chart with timers, the\n"
        "machine has additional transitions in which time passes.\n"
        "Formats: text, JSON, DOT (Graphviz), SVG.",
        {"grafverif mealy samples/tanks/tanks.grafcet",
         "grafverif mealy samples/tanks/tanks.grafcet --minimise --format json"},
        {OptionGroup::Output, OptionGroup::Chart, OptionGroup::Mode, OptionGroup::FormatDiagram, OptionGroup::Minimise,
         OptionGroup::Limits}};
}

}  // namespace grafverif::app
