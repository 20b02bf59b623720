// SPDX-License-Identifier: MIT
// Public interface: from the text of a chart to all derived models and results. Functions are pure: they take and
// return plain values and keep no state between calls, except in a Simulator. Calls on different values may run
// concurrently.
//
//   read_file, read_string    text -> Model (Chart, Component, ClosedLoop)
//   equations_of              Chart -> Equations
//   network_of                ClosedLoop -> Network of timed automata
//   transition_system_of      ClosedLoop or Chart -> TransitionSystem without time
//   uppaal_project, nusmv_model, structured_text_of   the same models as text for other tools
//   check, check_untimed      -> Report: a Verdict per property, with its run
//   compare                   Chart, Chart -> Comparison: equal for all inputs, or a distinguishing sequence
//   analysis_of               Chart -> Analysis: possible faults, and elements that are never used
//   drawing_of, svg_of        Chart -> Drawing, and a drawing as SVG
//   automaton_of, mealy_of, test_of                 Chart -> LocationAutomaton, MealyMachine, TestSequence
//   simulator_of              ClosedLoop or Chart -> Simulator, controlled by commands
//
// Invalid input is reported as Diagnostics: a function that returns an empty optional has added at least one error.
// Failures of the system (memory, a library) are thrown as std::bad_alloc or std::system_error.
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

// Reading

struct ReadOptions {
    std::vector<std::string> include_folders = {};  ///< folders searched for includes, after the file's folder
    bool lossy = false;  ///< omit, with a warning, constructs of other formats that a chart cannot represent
    /// Values of constants of closed loops, as text. A value overrides the constant of that name in every loop that has
    /// one. If no loop has such a constant, the error `no-such-choice` is reported.
    std::map<std::string, std::string> constants = {};
    /// Loads included files. By default, they are read from the disk. For a file they must be within its folder, the
    /// folder of its project (see docs/reference/files.md) or `include_folders`; for a string, within the current
    /// folder.
    std::function<std::optional<std::string>(const std::string& path, std::string& why)> load = {};
};

/// Parse result: sources, diagnostics and, without errors, the model.
struct ParseResult {
    Sources sources = {};
    Diagnostics diagnostics = {};  ///< also receives the diagnostics of later stages
    std::optional<Model> model = {};

    /// Returns the diagnostics as text, each with its source line and a caret.
    std::string diagnostics_text() const;
};

/// Reads a file and all its includes. The format is detected: input language, AGRAFE, PLCopen XML or textual SFC.
ParseResult read_file(const std::string& path, const ReadOptions& options = {});
/// Reads a model from a string; `name` is its name in diagnostics.
ParseResult read_string(std::string text, const std::string& name, const ReadOptions& options = {});

/// Returns the chart or closed loop with the given name.
std::optional<Id<Chart>> find_chart(const Model& model, std::string_view name);
std::optional<Id<ClosedLoop>> find_loop(const Model& model, std::string_view name);

// Models

/// Options of charts and of models of loops. They override the values in the file.
struct ModelOptions {
    std::optional<ExecutionMode> mode = {};
    std::optional<Grain> grain = {};
    ScheduleOptions untimed = {};  ///< options of transition systems; `mode` above replaces its mode
};

std::optional<Equations> equations_of(const Model& model, Id<Chart> chart, Diagnostics& diagnostics);
std::optional<Network> network_of(const Model& model, Id<ClosedLoop> loop, const ModelOptions& options,
                                  Diagnostics& diagnostics);
std::optional<TransitionSystem> transition_system_of(const Model& model, Id<ClosedLoop> loop,
                                                     const ModelOptions& options, Diagnostics& diagnostics);
/// Returns the transition system of a chart without a closed loop. Its inputs are free.
std::optional<TransitionSystem> transition_system_of(const Model& model, Id<Chart> chart, const ModelOptions& options,
                                                     Diagnostics& diagnostics);

/// Returns `requested`; otherwise the execution mode of all loops of `chart` if they agree; otherwise stability search.
ExecutionMode execution_mode(const Model& model, Id<Chart> chart, std::optional<ExecutionMode> requested);

struct UppaalProject {
    std::string project = {};  ///< the model as XML, including its queries
    std::string queries = {};  ///< the queries only, for `verifyta`
};
/// Warns about properties that UPPAAL does not support. Empty after an error: there are integers of more than 32 bits.
UppaalProject uppaal_project(const Network& network, Diagnostics& diagnostics);
std::string nusmv_model(const TransitionSystem& system, Diagnostics& diagnostics);

/// Returns a function block of the chart (IEC 61131-3) as text or as PLCopen XML (TC6 2.01). Each call executes one PLC
/// cycle with at most `max_evolutions` evolutions. Empty after an error: the chart cannot be expressed.
std::optional<std::string> structured_text_of(const Equations& equations, ExecutionMode mode, Diagnostics& diagnostics,
                                              bool plcopen_xml = false, std::uint32_t max_evolutions = 1000);

// Proofs

/// Progress of a computation; `words` returns it as a sentence.
struct Progress {
    std::function<std::string()> words = {};
};

/// Limits of a computation. At a limit, it returns the results so far; other verdicts are unknown and state the reason.
struct Limits {
    std::optional<std::uint64_t> states = {};  ///< maximum number of states; empty selects the default of the engine
    std::optional<std::uint64_t> memory = {};  ///< bytes; empty selects the default of the engine
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;             ///< cancellation flag; any thread and `progress` may set it
    std::function<void(const Progress&)> progress = {};  ///< called periodically
};

struct CheckOptions {
    /// Names of the properties to check; all if empty. If property `S` expands, `S` selects each `S.X7`.
    std::vector<std::string> properties = {};
    bool witnesses = true;    ///< also return runs of properties that hold (`reachable`)
    bool every_move = false;  ///< include the internal moves of the translation in the rows of a run
    Limits limits = {};
    bool profile = false;  ///< always return a state profile, not only for many states (timed engine)
    std::function<void(const StateProfile&)> many = {};  ///< called once, at a million states of the timed engine
    bool whole = false;                                  ///< explore independent subsystems together
    unsigned jobs = 0;  ///< threads; 0 selects one per core (untimed: at most two); the verdicts do not depend on it
};

/// Decides the properties of a closed loop with the timed engine. All runs in the report are replayed (IEC 60848).
std::optional<Report> check(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how,
                            const CheckOptions& options, Diagnostics& diagnostics);
/// Decides the properties of the untimed model with the symbolic engine. If it takes long, localization, PDR and BMC
/// run in parallel. Each verdict states its consequence for the timed loop.
std::optional<Report> check_untimed(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how,
                                    const CheckOptions& options, Diagnostics& diagnostics);
/// Decides for each step of a chart without a closed loop if the step is reachable.
std::optional<Report> check_untimed(const Model& model, Id<Chart> chart, const ModelOptions& how,
                                    const CheckOptions& options, Diagnostics& diagnostics);

// Charts alone

/// Finds possible faults of a chart and elements that are never used, for arbitrary inputs.
std::optional<Analysis> analysis_of(const Model& model, Id<Chart> chart, std::optional<ExecutionMode> mode,
                                    const Limits& limits, Diagnostics& diagnostics);

struct CompareOptions {
    std::optional<ExecutionMode> mode = {};
    /// Unit of time between scans. If empty, a divisor of all durations is chosen. The number of scans within a
    /// duration is then at least the number of timers, as far as whole milliseconds allow.
    std::optional<std::int64_t> resolution_ms = {};
    /// Situations that replace the initial steps of the charts; not replaced if empty. Either both or neither is given.
    std::array<std::vector<Id<Chart::Step>>, 2> from = {};
    bool shortest = true;  ///< search for a shortest distinguishing sequence
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
    bool partial = false;   ///< for an automaton: at a limit, return the part found so far, which is not `complete`
    bool minimise = false;  ///< merge equivalent states of the machine
    TestCover cover = TestCover::Transitions;
    bool one_cycle_each = false;  ///< apply each step of a test for one cycle instead of two
    Limits limits = {};
};
std::optional<LocationAutomaton> automaton_of(const Model& model, Id<Chart> chart, const ConformOptions& options,
                                              Diagnostics& diagnostics);
std::optional<MealyMachine> mealy_of(const Model& model, Id<Chart> chart, const ConformOptions& options,
                                     Diagnostics& diagnostics);
std::optional<TestSequence> test_of(const Model& model, Id<Chart> chart, const ConformOptions& options,
                                    Diagnostics& diagnostics);

// Output as text and JSON

/// Results as printed by the program (text_of) and as JSON (json_of, docs/reference/trace-format.md).
std::string text_of(const Report& report);
std::string json_of(const Report& report);
/// Returns the text with file, line and column of each property; `sources` are the sources of the model.
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
/// Returns a graph, or a table if there are many states. Empty if there are too many states for a table.
std::string svg_of(const LocationAutomaton& automaton);
std::string svg_of(const MealyMachine& machine);

// Simulation

/// Simulates a closed loop, or a chart without one. It is controlled by the commands of `grafverif simulate` and has
/// the same semantics as the checks. A simulator stores all data of the model that it requires.
class Simulator {
public:
    struct Inside;
    explicit Simulator(std::unique_ptr<Inside> inside);
    Simulator(Simulator&&) noexcept;
    Simulator& operator=(Simulator&&) noexcept;
    ~Simulator();

    /// Executes one command, such as `START = true`, `wait 3s`, `do Gate open` or `back`, and then the automatic moves.
    /// Returns an error message or an empty string.
    std::string execute(std::string_view command);
    /// The error message of the last command, or of the initialization.
    const std::string& problem() const;
    /// The currently possible choices.
    std::vector<Choice> choices() const;
    /// The complete run since power-on.
    const ChartRun& run() const;
    /// Returns the first row that is not part of a run of the model because a step was forced, or nothing.
    std::optional<std::size_t> what_if_row() const;
    /// Returns a contradiction between the run, up to a forced step, and IEC 60848 (internal error), or nothing.
    std::string disagreement() const;

private:
    std::unique_ptr<Inside> inside_;
};

std::optional<Simulator> simulator_of(const Model& model, Id<ClosedLoop> loop, const ModelOptions& options,
                                      Diagnostics& diagnostics);
/// Returns a simulator of a chart without a closed loop. Commands set its inputs.
std::optional<Simulator> simulator_of(const Model& model, Id<Chart> chart, std::optional<ExecutionMode> mode,
                                      Diagnostics& diagnostics);

}  // namespace grafverif
