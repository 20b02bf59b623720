// SPDX-License-Identifier: MIT
// The front door: from the text of a chart to everything that is made of it. Each function takes plain values and gives
// one; nothing is kept between calls, save in a Simulator, and calls on different values may run at once.
//
//   read_file, read_string    text -> Model (Chart, Component, ClosedLoop)
//   equations_of              Chart -> Equations
//   network_of                ClosedLoop -> Network of timed automata
//   transition_system_of      ClosedLoop or Chart -> TransitionSystem without time
//   uppaal_project, nusmv_model, structured_text_of   the same as text, for other tools
//   check, check_untimed      -> Report: a Verdict per property, with the run that shows it
//   compare                   Chart, Chart -> Comparison: equal for all inputs, or a sequence that tells them apart
//   analysis_of               Chart -> Analysis: what can go wrong in it, and what never happens
//   drawing_of, svg_of        Chart -> Drawing, and the same as SVG
//   automaton_of, mealy_of, test_of                 Chart -> LocationAutomaton, MealyMachine, TestSequence
//   simulator_of              ClosedLoop or Chart -> Simulator, which commands move
//
// A user's mistakes are Diagnostics: a function that returns nothing has added at least one error. What the system refuses
// (memory, a library) is thrown, as std::bad_alloc or std::system_error.
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
    std::vector<std::string> include_folders = {};  ///< looked in for includes, after the folder of the including file
    bool lossy = false;  ///< what a file of another format says and a chart cannot is left out, with a warning
    /// Values of constants of closed loops, as they are written: wherever a loop has one of that name, in the place of its
    /// own. The error `no-such-choice` where none has.
    std::map<std::string, std::string> constants = {};
    /// Where included files come from. Without it they are read from the disk, within the folder of the file, that of
    /// its project (see docs/files.md) and `include_folders`; a string includes from the current folder.
    std::function<std::optional<std::string>(const std::string& path, std::string& why)> load = {};
};

/// What was read: all texts, what is wrong with them, and, where nothing is, what they say.
struct Reading {
    Sources sources = {};
    Diagnostics diagnostics = {};  ///< for what is made of the model later too
    std::optional<Model> model = {};

    /// The diagnostics as a person reads them, each with its line and a caret.
    std::string complaints() const;
};

/// A file and all it includes: our text, AGRAFE, PLCopen XML or textual SFC, whatever is in it.
Reading read_file(const std::string& path, const ReadOptions& options = {});
/// The same of a text; `name` stands for it in diagnostics.
Reading read_string(std::string text, const std::string& name, const ReadOptions& options = {});

/// The chart, or closed loop, of that name.
std::optional<Id<Chart>> find_chart(const Model& model, std::string_view name);
std::optional<Id<ClosedLoop>> find_loop(const Model& model, std::string_view name);

// Models

/// How charts are executed and loops made models, where it shall not be as the file says.
struct ModelOptions {
    std::optional<ExecutionMode> mode = {};
    std::optional<Grain> grain = {};
    ScheduleOptions untimed = {};  ///< of transition systems; its mode is the one above
};

std::optional<Equations> equations_of(const Model& model, Id<Chart> chart, Diagnostics& diagnostics);
std::optional<Network> network_of(const Model& model, Id<ClosedLoop> loop, const ModelOptions& options,
                                  Diagnostics& diagnostics);
std::optional<TransitionSystem> transition_system_of(const Model& model, Id<ClosedLoop> loop,
                                                     const ModelOptions& options, Diagnostics& diagnostics);
/// Of a chart alone, its inputs free.
std::optional<TransitionSystem> transition_system_of(const Model& model, Id<Chart> chart, const ModelOptions& options,
                                                     Diagnostics& diagnostics);

/// How `chart` is executed where no loop says it: as `asked`, or as every loop that runs it says, or with stability
/// search.
ExecutionMode execution_mode(const Model& model, Id<Chart> chart, std::optional<ExecutionMode> asked);

struct UppaalProject {
    std::string project = {};  ///< XML, its queries in it
    std::string queries = {};  ///< the queries alone, for `verifyta`
};
/// Warns of properties that the tool cannot be asked. Empty after an error: integers of more than 32 bits, which neither has.
UppaalProject uppaal_project(const Network& network, Diagnostics& diagnostics);
std::string nusmv_model(const TransitionSystem& system, Diagnostics& diagnostics);

/// A function block of the chart (IEC 61131-3), one call being one PLC cycle: as text, or as PLCopen XML (TC6 2.01). At
/// most `max_evolutions` are made in a call in search of stability. Nothing after an error: the block cannot be written.
std::optional<std::string> structured_text_of(const Equations& equations, ExecutionMode mode, Diagnostics& diagnostics,
                                              bool plcopen_xml = false, std::uint32_t max_evolutions = 1000);

// Proofs

/// How far a computation is; `words` makes the sentence.
struct Progress {
    std::function<std::string()> words = {};
};

/// What bounds a computation. At a bound it ends with what is known: verdicts are unknown, with the reason.
struct Limits {
    std::optional<std::uint64_t> states = {};  ///< empty: as many as the engine allows by itself; likewise memory
    std::optional<std::uint64_t> memory = {};  ///< bytes
    std::optional<std::chrono::steady_clock::time_point> deadline = {};
    const std::atomic<bool>* stop = nullptr;             ///< looked at all the time; anybody may set it, `progress` too
    std::function<void(const Progress&)> progress = {};  ///< called now and then
};

struct CheckOptions {
    std::vector<std::string> properties = {};  ///< names; empty: all. Of one that expands: `S` means each `S.X7`
    bool witnesses = true;                     ///< runs that show what holds (`reachable`) too
    bool every_move = false;                   ///< the rows of a run tell the moves of the translation too
    Limits limits = {};
    bool profile = false;  ///< says where the states come from, be they few or many (timed engine)
    std::function<void(const StateProfile&)> many = {};  ///< called once where the timed engine finds a million states
    bool whole = false;                                  ///< sub-loops that share only time are searched together
    unsigned jobs = 0;  ///< threads of the timed engine; 0: as many as there are cores. Verdicts and runs are the same
};

/// Decides the properties of a closed loop with the timed engine. Every run in the report has been replayed on the rules
/// of IEC 60848.
std::optional<Report> check(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how,
                            const CheckOptions& options, Diagnostics& diagnostics);
/// The same of the model without time, with the symbolic engine; what its verdicts say of the timed loop stands with
/// each.
std::optional<Report> check_untimed(const Model& model, Id<ClosedLoop> loop, const ModelOptions& how,
                                    const CheckOptions& options, Diagnostics& diagnostics);
/// Of a chart alone: that each step can be reached.
std::optional<Report> check_untimed(const Model& model, Id<Chart> chart, const ModelOptions& how,
                                    const CheckOptions& options, Diagnostics& diagnostics);

// Charts alone

/// What can go wrong in a chart and what never happens in it, whatever the inputs do.
std::optional<Analysis> analysis_of(const Model& model, Id<Chart> chart, std::optional<ExecutionMode> mode,
                                    const Limits& limits, Diagnostics& diagnostics);

struct CompareOptions {
    std::optional<ExecutionMode> mode = {};
    /// Time passes in whole multiples of it; empty: of a part of all durations, so short that as many scans as there are
    /// timers lie within one of these, where milliseconds allow it.
    std::optional<std::int64_t> resolution_ms = {};
    /// Steps that each chart begins with, as if they were its initial ones; none: its own. Both or none.
    std::array<std::vector<Id<Chart::Step>>, 2> from = {};
    bool shortest = true;  ///< a sequence that tells the charts apart is made as short as can be
    Limits limits = {};
};
/// Whether a chart of one model and one of another answer all sequences of inputs alike (see Comparison). Both may be of
/// one model.
std::optional<Comparison> compare(const Model& a, Id<Chart> of_a, const Model& b, Id<Chart> of_b,
                                  const CompareOptions& options, Diagnostics& diagnostics);

/// The chart as IEC 60848 draws it.
Drawing drawing_of(const Model& model, Id<Chart> chart, const DrawOptions& options = {});
std::string svg_of(const Drawing& drawing);

struct ConformOptions {
    std::optional<ExecutionMode> mode = {};
    bool partial = false;   ///< of an automaton: at a limit, what was found, not `complete`
    bool minimise = false;  ///< states of the machine that nobody can tell apart become one
    TestCover cover = TestCover::Transitions;
    bool one_cycle_each = false;  ///< steps of a test last one cycle, not two
    Limits limits = {};
};
std::optional<LocationAutomaton> automaton_of(const Model& model, Id<Chart> chart, const ConformOptions& options,
                                              Diagnostics& diagnostics);
std::optional<MealyMachine> mealy_of(const Model& model, Id<Chart> chart, const ConformOptions& options,
                                     Diagnostics& diagnostics);
std::optional<TestSequence> test_of(const Model& model, Id<Chart> chart, const ConformOptions& options,
                                    Diagnostics& diagnostics);

// For people and programs

/// As the program prints it (text_of), and in its form for programs (json_of, docs/trace.md).
std::string text_of(const Report& report);
std::string json_of(const Report& report);
/// The same with file, line and column of each property; `sources`: what the model was read from.
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
/// A timing diagram.
std::string svg_of(const ChartRun& run, std::string_view title);
/// A graph; of many states a table; empty where those are more than anybody could look through.
std::string svg_of(const LocationAutomaton& automaton);
std::string svg_of(const MealyMachine& machine);

// By hand

/// A closed loop, or a chart alone, moved by the commands of `grafverif simulate`, on the rules that checks use. It keeps
/// what it needs of the model.
class Simulator {
public:
    struct Inside;
    explicit Simulator(std::unique_ptr<Inside> inside);
    Simulator(Simulator&&) noexcept;
    Simulator& operator=(Simulator&&) noexcept;
    ~Simulator();

    /// One command: `START = true`, `wait 3s`, `do Gate open`, `back`; what follows it by itself follows. What went wrong,
    /// in words; empty: all is well.
    std::string obey(std::string_view command);
    /// What went wrong in the last command, or before the first one, as it was told.
    const std::string& problem() const;
    /// What may be chosen now.
    std::vector<Choice> choices() const;
    /// All that happened since the power-on.
    const ChartRun& run() const;
    /// The first of its rows that is no run of the model any more, since a step was forced by hand; empty: all are.
    std::optional<std::size_t> trial_row() const;
    /// Where the rules of IEC 60848 part with the run, a fault of ours; empty: nowhere. Trials are none of theirs.
    std::string disagreement() const;

private:
    std::unique_ptr<Inside> inside_;
};

std::optional<Simulator> simulator_of(const Model& model, Id<ClosedLoop> loop, const ModelOptions& options,
                                      Diagnostics& diagnostics);
/// Of a chart alone, its inputs set by hand.
std::optional<Simulator> simulator_of(const Model& model, Id<Chart> chart, std::optional<ExecutionMode> mode,
                                      Diagnostics& diagnostics);

}  // namespace grafverif
