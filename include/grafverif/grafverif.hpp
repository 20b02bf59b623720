// SPDX-License-Identifier: MIT
// Public interface: reads charts and closed loops, and returns all models and results that are derived from them.
// Functions take and return plain values, append to the given Diagnostics, and keep no state between calls. Only the
// class Simulator has state. Calls whose arguments are different objects may run concurrently.
//
//   read_file, read_string    text -> Model (Chart, Component, ClosedLoop)
//   equations_of              Chart -> Equations
//   network_of                ClosedLoop -> Network of timed automata
//   transition_system_of      ClosedLoop or Chart -> TransitionSystem, untimed or with discrete time
//   uppaal_project, nusmv_model, structured_text_of   Network, TransitionSystem or Equations -> text for other tools
//   check, check_untimed      ClosedLoop -> Report: a Verdict for each property, with a run as evidence
//   compare                   Chart, Chart -> Comparison: the outputs are equal for all inputs, or a sequence
//                             distinguishes the charts
//   analysis_of               Chart -> Analysis: possible faults of the chart, and its elements that are never used
//   drawing_of, svg_of        Chart -> Drawing, and Drawing -> SVG text
//   automaton_of, mealy_of, test_of                 Chart -> LocationAutomaton, MealyMachine, TestSequence
//   simulator_of              ClosedLoop or Chart -> Simulator, controlled by commands
//
// Invalid input is reported as Diagnostics: a function that returns an empty optional has added at least one error. If
// memory is exhausted or a system call fails, functions throw std::bad_alloc or std::system_error.
#pragma once

#include <array>
#include <atomic>
#include <chrono>
#include <cstdint>
#include <functional>
#include <map>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

#include "grafverif/ir/choice.hpp"
#include "grafverif/ir/closed_loop.hpp"
#include "grafverif/ir/comparison.hpp"
#include "grafverif/ir/drawing.hpp"
#include "grafverif/ir/equations.hpp"
#include "grafverif/ir/execution.hpp"
#include "grafverif/ir/finding.hpp"
#include "grafverif/ir/location_automaton.hpp"
#include "grafverif/ir/mealy.hpp"
#include "grafverif/ir/network.hpp"
#include "grafverif/ir/report.hpp"
#include "grafverif/ir/test_sequence.hpp"
#include "grafverif/ir/transition_system.hpp"
#include "grafverif/support/diagnostic.hpp"
#include "grafverif/support/source.hpp"

namespace grafverif {

// Reading of input files

struct ReadOptions {
    /// Folders in which included files are searched, after the folder of the including file.
    std::vector<std::string> include_folders = {};
    /// True: constructs of imported formats (AGRAFE, PLCopen XML, SFC) that a Chart cannot
    /// represent are omitted, with a warning; false: these constructs are errors.
    bool lossy = false;
    /// Maps the name of a constant of closed loops to its value, as text. Each value overrides the constant in every
    /// loop that declares it. If no loop declares the constant, the error `no-such-choice` is reported.
    std::map<std::string, std::string> constants = {};
    /// Loads included files. By default, `read_file` loads only files below the folder of the file, the folder of its
    /// project (see docs/reference/files.md) or `include_folders`; `read_string` uses the current folder instead of the
    /// folder of the file.
    std::function<std::optional<std::string>(const std::string& path, std::string& why)> load = {};
};

/// Parse result: sources, diagnostics and, without errors, the model.
struct ParseResult {
    Sources sources = {};
    Diagnostics diagnostics = {};  ///< diagnostics of the parser; later calls with this object append their diagnostics
    std::optional<Model> model = {};

    /// Returns the diagnostics as text, each with its source line and a caret.
    std::string diagnostics_text() const;
};

/// Reads a file and all files that it includes. The format is detected: input language, AGRAFE, PLCopen XML or textual
/// SFC.
ParseResult read_file(const std::string& path, const ReadOptions& options = {});
/// Reads a model from a string. Diagnostics use `name` as the file name of the string.
ParseResult read_string(std::string text, const std::string& name, const ReadOptions& options = {});

/// Returns the chart or closed loop with the given name, or nullopt if there is none.
std::optional<Id<Chart>> find_chart(const Model& model, std::string_view name);
std::optional<Id<ClosedLoop>> find_loop(const Model& model, std::string_view name);

// Translation to models

/// Options for the translation of charts and closed loops. A given option overrides the value in the input file.
struct ModelOptions {
    std::optional<ExecutionMode> mode = {};
    std::optional<Grain> grain = {};
    ScheduleOptions untimed = {};  ///< options of transition systems; `ModelOptions::mode` replaces `untimed.mode`
};

std::optional<Equations> equations_of(const Model& model, Id<Chart> chart, Diagnostics& diagnostics);
std::optional<Network> network_of(const Model& model, Id<ClosedLoop> loop, const ModelOptions& options,
                                  Diagnostics& diagnostics);
std::optional<TransitionSystem> transition_system_of(const Model& model, Id<ClosedLoop> loop,
                                                     const ModelOptions& options, Diagnostics& diagnostics);
/// Returns the transition system of a chart without a closed loop. The inputs of this system are free.
std::optional<TransitionSystem> transition_system_of(const Model& model, Id<Chart> chart, const ModelOptions& options,
                                                     Diagnostics& diagnostics);

/// Returns `requested` if it is given, otherwise the execution mode that all closed loops select for `chart`. Returns
/// stability search if no loop contains the chart, or if the loops select different modes.
ExecutionMode execution_mode(const Model& model, Id<Chart> chart, std::optional<ExecutionMode> requested);

struct UppaalProject {
    std::string project = {};  ///< the model as XML, including its queries
    std::string queries = {};  ///< the queries only, for `verifyta`
};
/// Returns the model for UPPAAL and its queries. Warns about properties that UPPAAL does not support. If an integer
/// needs more than 32 bits, reports an error and returns an empty project.
UppaalProject uppaal_project(const Network& network, Diagnostics& diagnostics);
std::string nusmv_model(const TransitionSystem& system, Diagnostics& diagnostics);

/// Returns a function block of the chart (IEC 61131-3) as text or as PLCopen XML (TC6 2.01). Each call executes one PLC
/// cycle with at most `max_evolutions` evolutions. If Structured Text cannot express the chart, reports an error and
/// returns nullopt.
std::optional<std::string> structured_text_of(const Equations& equations, ExecutionMode mode, Diagnostics& diagnostics,
                                              bool plcopen_xml = false, std::uint32_t max_evolutions = 1000);

// Model checking

/// Progress of a computation. `words` returns a text that describes the progress, such as `12 steps deep, 80 MiB, 3 s`.
struct Progress {
    std::function<std::string()> words = {};
};

/// Limits of a computation. A computation that reaches a limit returns the verdicts that it has decided; all other
/// verdicts are unknown, and the report states the reason.
struct Limits {
    std::optional<std::uint64_t> states = {};  ///< maximum number of states; empty selects the default of the engine
    std::optional<std::uint64_t> memory = {};  ///< maximum memory in bytes; empty selects the default of the engine
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    /// Cancellation flag; any thread, and the function `progress`, may set it.
    const std::atomic<bool>* stop = nullptr;
    std::function<void(const Progress&)> progress = {};  ///< called periodically with the current progress
};

struct CheckOptions {
    /// Names of the properties to check; all if empty. If property `S` has the form `reachable all steps`, `S` selects
    /// all steps, and `S.X7` only step 7.
    std::vector<std::string> properties = {};
    bool witnesses = true;    ///< also return a run for each `reachable` property that holds
    bool every_move = false;  ///< also return a trace row for each auxiliary move of the generated model
    Limits limits = {};
    bool profile = false;  ///< timed engine: compute a state profile even if the search finds few states

    /// Called once by each search of the timed engine, when the search has found 2^20 states.
    std::function<void(const StateProfile&)> many = {};
    bool whole = false;  ///< true: explore independent subsystems of a loop as one system; false: separately

    /// Number of threads; does not affect the verdicts. 0 selects one thread per core, for untimed checks at most two.
    unsigned jobs = 0;
};

/// Decides the properties of a closed loop with the timed engine. All runs in the report have been replayed under the
/// rules of IEC 60848.
std::optional<Report> check(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how,
                            const CheckOptions& options, Diagnostics& diagnostics);
/// Decides the properties of the untimed model with the symbolic engine. If the symbolic engine needs a long time,
/// localization, PDR and BMC run in parallel with it. Each verdict states what it implies for the timed closed loop.
std::optional<Report> check_untimed(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how,
                                    const CheckOptions& options, Diagnostics& diagnostics);
/// Decides for each step of a chart without a closed loop if the step is reachable.
std::optional<Report> check_untimed(const Model& model, Id<Chart> chart, const ModelOptions& how,
                                    const CheckOptions& options, Diagnostics& diagnostics);

// Charts without a closed loop

/// Finds possible faults of a chart and elements that are never used, for arbitrary inputs.
std::optional<Analysis> analysis_of(const Model& model, Id<Chart> chart, std::optional<ExecutionMode> mode,
                                    const Limits& limits, Diagnostics& diagnostics);

struct CompareOptions {
    std::optional<ExecutionMode> mode = {};
    /// The time between two scans is a multiple of this value. If empty, a common divisor of all durations of the two
    /// charts is selected. The divisor is small enough that all timers can start in different scans, unless this
    /// requires fractions of a millisecond.
    std::optional<std::int64_t> resolution_ms = {};
    /// Initial situations of the two charts, which replace their initial steps; either both
    /// situations are given, or both are empty.
    std::array<std::vector<Id<Chart::Step>>, 2> from = {};
    /// True: search for a shortest distinguishing sequence; false: any distinguishing sequence is sufficient.
    bool shortest = true;
    Limits limits = {};
};
/// Decides if two charts, possibly of different models, have equal outputs for all input sequences (see Comparison).
std::optional<Comparison> compare(const Model& a, Id<Chart> of_a, const Model& b, Id<Chart> of_b,
                                  const CompareOptions& options, Diagnostics& diagnostics);

/// Returns a drawing of the chart in the notation of IEC 60848.
Drawing drawing_of(const Model& model, Id<Chart> chart, const DrawOptions& options = {});
std::string svg_of(const Drawing& drawing);

struct ConformOptions {
    std::optional<ExecutionMode> mode = {};
    /// Only for automaton_of: at a limit, return an incomplete automaton (`complete` is false) instead of an error.
    bool partial = false;
    bool minimise = false;  ///< true: equivalent states of a Mealy machine are merged
    TestCover cover = TestCover::Transitions;
    bool one_cycle_each = false;  ///< true: each step of a test is applied for one cycle, not for two
    Limits limits = {};
};
std::optional<LocationAutomaton> automaton_of(const Model& model, Id<Chart> chart, const ConformOptions& options,
                                              Diagnostics& diagnostics);
std::optional<MealyMachine> mealy_of(const Model& model, Id<Chart> chart, const ConformOptions& options,
                                     Diagnostics& diagnostics);
std::optional<TestSequence> test_of(const Model& model, Id<Chart> chart, const ConformOptions& options,
                                    Diagnostics& diagnostics);

// Output as text and JSON

/// text_of returns the text that the program `grafverif` prints for a result; json_of returns the result as JSON
/// (docs/reference/trace-format.md).
std::string text_of(const Report& report);
std::string json_of(const Report& report);
/// Returns the text of the report with file, line and column of each property; `sources` are the
/// sources of the model.
std::string text_of(const Report& report, const Sources& sources);
std::string json_of(const Report& report, const Sources& sources);
std::string text_of(const ChartRun& run);
std::string json_of(const ChartRun& run);
std::string text_of(const Analysis& analysis, const Sources& sources);
std::string json_of(const Analysis& analysis, const Sources& sources);
std::string text_of(const Comparison& comparison);
std::string json_of(const Comparison& comparison);
std::string text_of(const LocationAutomaton& automaton);
std::string json_of(const LocationAutomaton& automaton);
std::string text_of(const MealyMachine& machine);
std::string json_of(const MealyMachine& machine);
std::string json_of(const TestSequence& test);
/// Returns a timing diagram of the run.
std::string svg_of(const ChartRun& run, std::string_view title);
/// Returns a drawing: a graph if there are few states, otherwise a table; an empty string if there are too many states
/// for a table.
std::string svg_of(const LocationAutomaton& automaton);
std::string svg_of(const MealyMachine& machine);

// Simulation

/// Simulates a closed loop, or a chart without a closed loop. The simulator is controlled by the commands of `grafverif
/// simulate` and has the same semantics as the checks. The simulator copies all data that it needs from the model, so
/// the model may be destroyed first.
class Simulator {
public:
    struct Inside;
    explicit Simulator(std::unique_ptr<Inside> inside);
    Simulator(Simulator&&) noexcept;
    Simulator& operator=(Simulator&&) noexcept;
    ~Simulator();

    /// Executes one command, such as `START = true`, `wait 3s`, `do Gate open` or `back`, and then all moves that the
    /// simulator executes automatically. Returns an error message or an empty string.
    std::string execute(std::string_view command);
    /// Returns the error message of the last command or, before the first command, of the initialization; empty without
    /// an error.
    const std::string& problem() const;
    /// Returns the choices that are possible in the current state.
    std::vector<Choice> choices() const;
    /// Returns the complete run since power-on.
    const ChartRun& run() const;
    /// Returns the index of the row in which a step was first forced, or nullopt if no step was forced. From this row
    /// on, the run is not a run of the model.
    std::optional<std::size_t> what_if_row() const;
    /// Returns a description of a contradiction between IEC 60848 and the run before the first
    /// forced step (an internal error), or an empty string.
    std::string disagreement() const;

private:
    std::unique_ptr<Inside> inside_;
};

std::optional<Simulator> simulator_of(const Model& model, Id<ClosedLoop> loop, const ModelOptions& options,
                                      Diagnostics& diagnostics);
/// Returns a simulator of a chart without a closed loop. The commands of the user set the inputs of the chart.
std::optional<Simulator> simulator_of(const Model& model, Id<Chart> chart, std::optional<ExecutionMode> mode,
                                      Diagnostics& diagnostics);

}  // namespace grafverif
