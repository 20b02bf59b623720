// SPDX-License-Identifier: MIT
// `simulate`: executes a closed loop, or a chart without a loop, interactively, with a script, or at random. The run is
// printed in the form of a counterexample. At the end, the interpreter replays the run, unless a step was forced.
#include <fmt/format.h>

#include <algorithm>
#include <filesystem>
#include <istream>
#include <map>
#include <optional>
#include <ostream>
#include <sstream>
#include <string_view>
#include <system_error>

#include "app/commands.hpp"
#include "app/reports.hpp"
#include "app/system/interrupt.hpp"
#include "app/system/line_editor.hpp"
#include "app/system/write_files.hpp"
#include "app/traces.hpp"
#include "pipeline/check.hpp"
#include "pipeline/files.hpp"
#include "pipeline/models.hpp"
#include "report/junit.hpp"
#include "report/report.hpp"
#include "report/terminal.hpp"
#include "simulate/commands.hpp"
#include "simulate/completion.hpp"
#include "simulate/recording.hpp"
#include "simulate/script.hpp"
#include "simulate/simulation.hpp"
#include "support/messages.hpp"
#include "support/printable.hpp"

namespace grafverif::app {

namespace {

/// An interactive session. Each line is a command, and the response shows the steps that the command caused.
class Session {
public:
    Session(Simulation& simulation, const Streams& streams)
        : simulation_(simulation), recording_(simulation), out_(streams.out) {}

    /// Starts the session. If `prompts` is true, shows the choices and then `prompt`.
    void begin(bool prompts, std::string_view prompt = "") {
        prompts_ = prompts;
        prompt_ = prompt;
        print_header(usual_widths, out_);
        answer(simulation_.begin());
    }

    /// Returns the error message, or an empty string if there is none. `line` is the text of the command.
    std::string execute(const Command& command, std::string_view line) {
        over_ = over_ || std::holds_alternative<QuitCommand>(command);
        if (std::holds_alternative<HelpCommand>(command)) out_ << help;
        if (std::holds_alternative<ShowCommand>(command)) show();
        if (std::holds_alternative<RepeatCommand>(command) || std::holds_alternative<EndCommand>(command))
            return "`repeat` and `}` are allowed only in scripts; enter each command as often as needed";
        if (const auto* const save = std::get_if<SaveCommand>(&command)) return saved(save->file);
        return recording_.execute(command, line);
    }

    /// Shows the new steps, the error, and in an interactive session the choices.
    void answer(const std::string& problem) {
        const ChartRun& run = simulation_.recorded_run();
        if (run.rows.size() < shown_) {
            shown_ = run.rows.size() - 1;
            out_ << "back to:\n";
        }
        for (; shown_ < run.rows.size(); ++shown_)
            if (is_shown(run, shown_)) print_row(run, shown_, shown_ + 1 == run.rows.size(), usual_widths, out_);
        report_violated_constraints();
        if (!problem.empty()) out_ << "! " << printable(problem) << '\n';
        if (prompts_ && !over_) prompt();
        out_ << std::flush;
    }

    bool over() const { return over_; }

private:
    static constexpr const char* help =
        "  NUMBER             make this choice\n"
        "  NAME = VALUE       set an input to true, false or a number\n"
        "  do INSTANCE [LOC]  take an enabled edge of the instance\n"
        "  wait [3s]          let time pass; without a duration: until the next automatic or possible event\n"
        "  force STEP on|off  activate or deactivate the step; the run is then a what-if run, not a run of the model\n"
        "  expect CLAIM       check that CLAIM holds now: X3, not LAMP, LEVEL >= 3, Gate in open, several with `and`\n"
        "  expect within 5s CLAIM   check that CLAIM becomes true within this time\n"
        "  wait until CLAIM   let time pass until CLAIM is true; no time passes if CLAIM became true in this instant\n"
        "  show               print all current values\n"
        "  back, undo         undo the last command\n"
        "  save FILE          write the session as a script that expects the observed values\n"
        "  quit               exit\n";

    void show() {
        const ChartRun& run = simulation_.recorded_run();
        const ChartRun::State& now = run.moments.back().after;
        out_ << "time       " << event_text(run, now) << "\nsituation ";
        for (const Id<ChartRun::Step> step : now.situation) out_ << ' ' << printable(run.steps[step].short_name);
        out_ << (now.situation.empty() ? " none\n" : "\n");
        for (const Id<ChartRun::Signal> id : run.signals.ids()) {
            const ChartRun::Signal& signal = run.signals[id];
            if (signal.role == ChartRun::Role::Image) continue;
            const std::int64_t value = now.values[id.index];
            const std::string range =
                signal.type.boolean ? "" : fmt::format("   ({}..{})", signal.type.low, signal.type.high);
            out_ << fmt::format("{:<10} {} = {}{}\n", word(signal.role), printable(signal.name),
                                !signal.type.boolean ? std::to_string(value)
                                : value != 0         ? "true"
                                                     : "false",
                                range);
        }
    }

    /// Saves the session. An existing file is overwritten only if it is a saved session.
    std::string saved(const std::string& file) {
        std::string why;
        const bool is_there = std::filesystem::exists(std::filesystem::symlink_status(file));
        const auto old = is_there ? content_of_file(file, why) : std::nullopt;
        if (is_there && !(old && old->starts_with(saved_session)))
            return fmt::format("`{}` exists and is not a saved session; choose another name", file);
        const std::filesystem::path folder = std::filesystem::path(file).parent_path();
        if (!folder.empty() && !std::filesystem::is_directory(folder))
            return fmt::format("folder `{}` does not exist; create it or choose another one", folder.string());
        try {
            write_files({{file, recording_.script()}});
        } catch (const std::system_error& failure) {
            return failure.what();
        }
        out_ << fmt::format("saved; replay the session with `--script {}`\n", printable(file));
        return {};
    }

    /// Reports the constraints that are violated now and were not violated after the previous command.
    void report_violated_constraints() {
        std::vector<std::string> now = simulation_.violated_constraints();
        for (const std::string& constraint : now)
            if (std::ranges::find(broken_, constraint) == broken_.end())
                out_ << fmt::format("! these inputs violate the constraint `{}`\n", printable(constraint));
        broken_ = std::move(now);
    }

    void prompt() {
        std::size_t number = 0;
        for (const Choice& choice : simulation_.choices()) out_ << fmt::format("{:>5}  {}\n", ++number, choice.words);
        const DelayBounds delay_bounds = simulation_.delay_bounds();
        if (delay_bounds.may_pass)
            out_ << (delay_bounds.limit
                         ? fmt::format(" wait  up to {}\n", seconds_text(*delay_bounds.limit * delay_bounds.unit_ms))
                         : " wait  any time\n");
        out_ << prompt_;
    }

    Simulation& simulation_;
    Recording recording_;
    std::ostream& out_;
    bool prompts_ = false;
    std::string_view prompt_ = {};
    bool over_ = false;
    std::size_t shown_ = 0;
    std::vector<std::string> broken_ = {};  ///< names of violated constraints
};

ExitCode converse(Simulation& simulation, const Streams& streams, CommandContext& job) {
    constexpr const char* prompt = "> ";
    const Interrupt interrupt;
    std::optional<LineEditor> editor;
    if (streams.typed)
        editor.emplace(
            prompt, [&](std::string_view line) { return completions(simulation, line); }, last_word,
            interrupt.requested());
    const auto next = [&]() -> std::optional<std::string> {
        std::string line;
        if (editor) return editor->line();
        return std::getline(streams.in, line) ? std::optional(line) : std::nullopt;
    };
    Session session(simulation, streams);
    session.begin(true, editor ? "" : prompt);
    while (!session.over()) {
        const std::optional<std::string> line = next();
        if (!line) break;
        session.answer(session.execute(command_of(*line), *line));
    }
    streams.out << '\n';
    if (interrupt.requested()) job.diagnostics.add(messages::interrupted());
    return ExitCode::Done;
}

/// The results of the expectations in one line of a script.
struct ExpectationResult {
    std::string text = {};
    std::string unmet = {};  ///< description of the first failure; empty if the expectation was met at each evaluation
};

/// Executes a script, which stops at the first command that fails. An unmet expectation is reported, and the script
/// continues.
class ScriptRun {
public:
    ScriptRun(const Script& script, std::string path, Session& session, Simulation& simulation, const Streams& streams)
        : script_(script), path_(std::move(path)), session_(session), simulation_(simulation), streams_(streams) {}

    ExitCode run() {
        // For each open `repeat`: its position in the script and the remaining number of repetitions.
        std::vector<std::pair<std::size_t, std::uint64_t>> rounds;
        for (std::size_t at = 0; at < script_.lines.size() && !session_.over();) {
            const Script::Line& line = script_.lines[at++];
            if (const auto* const repeat = std::get_if<RepeatCommand>(&line.command)) {
                rounds.emplace_back(at, repeat->times);
            } else if (std::holds_alternative<EndCommand>(line.command)) {
                if (--rounds.back().second > 0) at = rounds.back().first;
                else rounds.pop_back();
            } else if (!execute(line)) {
                return ExitCode::Input;
            }
        }
        return std::ranges::any_of(expectations_, [](const auto& each) { return !each.second.unmet.empty(); })
                   ? ExitCode::Verdict
                   : ExitCode::Done;
    }

    const std::map<std::uint32_t, ExpectationResult>& expectations() const { return expectations_; }
    const std::string& ended() const { return ended_; }

private:
    bool execute(const Script::Line& line) {
        const std::string problem = session_.execute(line.command, "");
        session_.answer("");
        if (const auto* const expected = std::get_if<ExpectCommand>(&line.command)) {
            ExpectationResult& here = expectations_[line.number];
            here.text = expected->claim.text;
            if (here.unmet.empty() && simulation_.unmet()) here.unmet = problem;
        }
        if (problem.empty()) return true;
        streams_.err << fmt::format("{}:{}: {}: {}\n", printable(path_), line.number,
                                    simulation_.unmet() ? "not met" : "error", printable(problem));
        if (!simulation_.unmet()) ended_ = problem;
        return simulation_.unmet();
    }

    const Script& script_;
    std::string path_;
    Session& session_;
    Simulation& simulation_;
    const Streams& streams_;
    std::map<std::uint32_t, ExpectationResult> expectations_ = {};  ///< results, by the line of the expectation
    std::string ended_ = {};                                        ///< error of the command that ended the script
};

ExitCode follow_script(Simulation& simulation, const std::string& path, const Streams& streams, CommandContext& job) {
    const auto source = read_source(path, job);
    if (!source) return ExitCode::Input;
    const Script script = script_of(job.sources[*source].text);
    for (const auto& [number, what] : script.error_texts)
        streams.err << fmt::format("{}:{}: error: {}\n", printable(path), number, printable(what));
    if (!script.error_texts.empty()) return ExitCode::Input;
    Session session(simulation, streams);
    session.begin(false);
    ScriptRun run(script, path, session, simulation, streams);
    const ExitCode code = run.run();
    if (job.options.junit) {
        std::vector<JunitCase> cases;
        for (const auto& [line, each] : run.expectations()) cases.push_back({each.text, line, each.unmet});
        job.reports->suites = junit_suite(path, cases, run.ended());
    }
    return code;
}

Detail detail_of(const CommandContext& job) { return job.options.verbose ? Detail::Everything : Detail::Chart; }

std::string walk(Simulation& simulation, std::uint64_t seed, std::uint64_t steps) {
    RandomWalk walk(seed);
    if (std::string problem = simulation.begin(); !problem.empty()) return problem;
    for (std::uint64_t i = 0; i < steps; ++i) {
        const std::optional<Command> next = walk.draw(simulation);
        if (!next) return "no further event is possible";
        if (std::string problem = simulation.execute(*next); !problem.empty()) return problem;
    }
    return {};
}

/// Executes `simulation` according to the options, replays the run with the interpreter unless a step was forced, and
/// writes the requested files.
ExitCode move(Simulation& simulation, const std::vector<const Chart*>& charts, CommandContext& job,
              const Streams& streams) {
    ExitCode code = ExitCode::Done;
    std::string problem;
    if (job.options.random_seed) problem = walk(simulation, *job.options.random_seed, job.options.steps);
    else if (job.options.script) code = follow_script(simulation, *job.options.script, streams, job);
    else code = converse(simulation, streams, job);
    const ChartRun run =
        job.options.random_seed ? simulation.with_trace_rows(detail_of(job)) : simulation.recorded_run();
    if (job.options.random_seed) print_trace(run, streams.out);
    if (!problem.empty()) streams.out << "! " << printable(problem) << '\n';
    const bool is_what_if = simulation.what_if_row().has_value();  // a run with forced steps may violate IEC 60848
    if (const auto found = is_what_if ? std::nullopt : disagreement(run, charts)) {
        streams.err << "grafverif: internal error: " << replay_failure("this run", *found) << '\n';
        return ExitCode::Failure;
    }
    const std::string title =
        is_what_if ? run.name + ", a what-if run with forced steps: not a run of the model" : run.name;
    std::vector<OutputFile> files = trace_files(run, title, job.options);
    for (OutputFile& file : files)
        if (is_what_if && job.options.trace_vcd && file.path == *job.options.trace_vcd)
            file.content.insert(0, "$comment a what-if run with forced steps: not a run of the model $end\n");
    job.reports->files = std::move(files);
    return code;
}

ExitCode simulate_loop(const Model& model, CommandContext& job, const Streams& streams) {
    const auto loop = chosen_loop(model, job);
    const auto network = loop ? network_of(model, *loop, job) : std::nullopt;
    if (!network) return ExitCode::Input;
    // In a random walk, each edge is a separate choice.
    const std::vector<const Chart*> charts = charts_of(model, model.loops[*loop]);
    Simulation simulation(*network, charts, job.options.random_seed ? Detail::Everything : detail_of(job));
    return move(simulation, charts, job, streams);
}

ExitCode simulate_chart(const Model& model, CommandContext& job, const Streams& streams) {
    const auto chart = chosen_chart(model, job);
    if (!chart || !equations_of(model, *chart, job)) return ExitCode::Input;  // the simulation needs the equations
    Simulation simulation(model.charts[*chart], execution_mode(model, *chart, job), detail_of(job));
    return move(simulation, {&model.charts[*chart]}, job, streams);
}

}  // namespace

ExitCode simulate(CommandContext& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    if (!model) return ExitCode::Input;
    return is_of_a_chart(*model, job.options) ? simulate_chart(*model, job, streams)
                                              : simulate_loop(*model, job, streams);
}

CliCommand simulate_usage() {
    return {
        "simulate",
        "FILE",
        1,
        1,
        "simulate a closed loop or a chart interactively, from a script or at random",
        "Runs the closed loop of FILE. Commands select the moves of the plant and its environment, set inputs, and\n"
        "let time pass; the controller moves automatically. Commands come from standard input or from a script\n"
        "(--script). With --verbose, every edge is a choice. If FILE has no closed loop, or with --chart, a chart "
        "runs\n"
        "alone, and commands set its inputs.\n"
        "  NAME = VALUE       set an input to true, false or a number; `NAME = VALUE, ...` sets inputs of a chart "
        "together\n"
        "  wait 3s            let time pass (ms, s, min); without a duration: until the next automatic or possible "
        "event\n"
        "  do INSTANCE [LOC]  take an enabled edge of the instance; with LOC, an edge that leads to this location\n"
        "  force STEP on|off  activate or deactivate the step; the run is then a what-if run, not a run of the model\n"
        "  expect CLAIM       check that CLAIM holds now: X3, not LAMP, LEVEL >= 3, Gate in open, several with `and`;\n"
        "                     `expect within 5s CLAIM`: check that CLAIM becomes true within this time\n"
        "  wait until CLAIM   let time pass until CLAIM is true; no time passes if CLAIM became true in this instant\n"
        "  repeat 3 {         in a script: repeat the lines up to `}` 3 times\n"
        "  show, undo, quit   print all current values; undo the last command; exit\n"
        "  save FILE          write the session as a script that expects the observed values\n"
        "At a terminal, lines are edited with libedit (~/.editrc): arrow keys, Ctrl-R for history search, Tab for "
        "completion;\n"
        "Ctrl-C discards a line, Ctrl-D exits.\n"
        "Exit code 1: an expectation of the script was not met.",
        {"grafverif simulate samples/blinker/blinker.grafcet",
         "grafverif simulate station.grafcet --script press_start.txt",
         "grafverif simulate samples/oven_door/oven_door.grafcet --chart oven_door",
         "grafverif simulate station.grafcet --random 7 --steps 500 --trace-svg walk.svg"},
        {OptionGroup::Within, OptionGroup::Walk, OptionGroup::Loop, OptionGroup::Constants, OptionGroup::Chart,
         OptionGroup::Mode, OptionGroup::Grain, OptionGroup::Cycle, OptionGroup::Traces, OptionGroup::Verbose}};
}

}  // namespace grafverif::app
