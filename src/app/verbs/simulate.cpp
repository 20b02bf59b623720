// SPDX-License-Identifier: MIT
// `simulate`: a closed loop, or a chart alone, moved by hand, by a script, or at random; what it did is told like a counterexample and
// replayed on the rules in the end.
#include <fmt/format.h>

#include <algorithm>
#include <istream>
#include <ostream>
#include <sstream>

#include "app/outputs.hpp"
#include "app/traces.hpp"
#include "app/verbs.hpp"
#include "pipeline/check.hpp"
#include "pipeline/models.hpp"
#include "report/report.hpp"
#include "report/terminal.hpp"
#include "simulate/commands.hpp"
#include "simulate/simulation.hpp"
#include "support/printable.hpp"

namespace grafverif::app {

namespace {

/// A conversation: each line a command, answered by the steps that it caused.
class Session {
public:
    Session(Simulation& simulation, const Streams& streams) : simulation_(simulation), out_(streams.out) {}

    void begin(bool prompts) {
        prompts_ = prompts;
        print_header(usual_widths, out_);
        answer(simulation_.begin());
    }

    /// What went wrong; empty: all is well.
    std::string obey(const Command& command) {
        over_ = over_ || std::holds_alternative<QuitCommand>(command);
        if (std::holds_alternative<HelpCommand>(command)) out_ << help;
        return simulation_.obey(command);
    }

    /// Shows the new steps, what went wrong, and in a conversation what may be chosen.
    void answer(const std::string& problem) {
        const ChartRun& run = simulation_.told();
        if (run.rows.size() < shown_) {
            shown_ = run.rows.size() - 1;
            out_ << "back to:\n";
        }
        for (; shown_ < run.rows.size(); ++shown_)
            if (is_shown(run, shown_)) print_row(run, shown_, shown_ + 1 == run.rows.size(), usual_widths, out_);
        tell_broken_constraints();
        if (!problem.empty()) out_ << "! " << printable(problem) << '\n';
        if (prompts_ && !over_) prompt();
        out_ << std::flush;
    }

    bool over() const { return over_; }

private:
    static constexpr const char* help =
        "  NUMBER             make that choice\n"
        "  NAME = VALUE       make an input true, false or a number\n"
        "  do INSTANCE [LOC]  the instance does what it can\n"
        "  wait [3s]          let time pass; alone: until something happens by itself, or can\n"
        "  force STEP on|off  a trial: make the step active by hand, or not; not a run of the model from there on\n"
        "  back               undo the last command\n"
        "  quit               end\n";

    /// Each constraint when it begins to be broken.
    void tell_broken_constraints() {
        std::vector<std::string> now = simulation_.broken_constraints();
        for (const std::string& constraint : now)
            if (std::ranges::find(broken_, constraint) == broken_.end())
                out_ << fmt::format("! these inputs break the constraint `{}`\n", printable(constraint));
        broken_ = std::move(now);
    }

    void prompt() {
        std::size_t number = 0;
        for (const Choice& choice : simulation_.choices()) out_ << fmt::format("{:>5}  {}\n", ++number, choice.words);
        const Patience patience = simulation_.patience();
        if (patience.may_pass)
            out_ << (patience.limit ? fmt::format(" wait  up to {}\n", seconds_text(*patience.limit * patience.unit_ms))
                                    : " wait  as long as you like\n");
        out_ << "> ";
    }

    Simulation& simulation_;
    std::ostream& out_;
    bool prompts_ = false;
    bool over_ = false;
    std::size_t shown_ = 0;
    std::vector<std::string> broken_ = {};  ///< constraints
};

ExitCode converse(Simulation& simulation, const Streams& streams) {
    Session session(simulation, streams);
    session.begin(true);
    for (std::string line; !session.over() && std::getline(streams.in, line);)
        session.answer(session.obey(command_of(line)));
    streams.out << '\n';
    return ExitCode::Done;
}

/// A script stops at its first command that cannot be obeyed.
ExitCode follow_script(Simulation& simulation, const std::string& path, const Streams& streams, Job& job) {
    const auto script = read_source(path, job);
    if (!script) return ExitCode::Input;
    Session session(simulation, streams);
    session.begin(false);
    std::istringstream lines(job.sources[*script].text);
    std::size_t number = 1;
    for (std::string line; !session.over() && std::getline(lines, line); ++number) {
        const std::string problem = session.obey(command_of(line));
        session.answer("");
        if (problem.empty()) continue;
        streams.err << fmt::format("{}:{}: error: {}\n", printable(path), number, printable(problem));
        return ExitCode::Input;
    }
    return ExitCode::Done;
}

Detail detail_of(const Job& job) { return job.options.verbose ? Detail::Everything : Detail::Chart; }

std::string walk(Simulation& simulation, std::uint64_t seed, std::uint64_t steps) {
    RandomWalk walk(seed);
    if (std::string problem = simulation.begin(); !problem.empty()) return problem;
    for (std::uint64_t i = 0; i < steps; ++i) {
        const std::optional<Command> next = walk.draw(simulation);
        if (!next) return "nothing can happen any more";
        if (std::string problem = simulation.obey(*next); !problem.empty()) return problem;
    }
    return {};
}

/// Moves `simulation` as the options ask for it; what was done is replayed on the rules of the charts, and written where
/// it is asked for.
ExitCode move(Simulation& simulation, const std::vector<const Chart*>& charts, Job& job, const Streams& streams) {
    ExitCode code = ExitCode::Done;
    std::string problem;
    if (job.options.random_seed) problem = walk(simulation, *job.options.random_seed, job.options.steps);
    else if (job.options.script) code = follow_script(simulation, *job.options.script, streams, job);
    else code = converse(simulation, streams);
    const ChartRun run = job.options.random_seed ? simulation.retold(detail_of(job)) : simulation.told();
    if (job.options.random_seed) print_trace(run, streams.out);
    if (!problem.empty()) streams.out << "! " << printable(problem) << '\n';
    const bool is_trial = simulation.trial_row().has_value();  // of which the rules of the charts know nothing
    if (const auto found = is_trial ? std::nullopt : disagreement(run, charts)) {
        streams.err << "grafverif: internal failure: " << replay_failure("this run", *found) << '\n';
        return ExitCode::Failure;
    }
    const std::string title = is_trial ? run.name + ", a trial by hand: not a run of the model" : run.name;
    std::vector<OutputFile> files = trace_files(run, title, job.options);
    for (OutputFile& file : files)
        if (is_trial && job.options.trace_vcd && file.path == *job.options.trace_vcd)
            file.content.insert(0, "$comment a trial by hand: not a run of the model $end\n");
    write_outputs(files, job, streams);
    return code;
}

ExitCode simulate_loop(const Model& model, Job& job, const Streams& streams) {
    const auto loop = chosen_loop(model, job);
    const auto network = loop ? network_of(model, *loop, job) : std::nullopt;
    if (!network) return ExitCode::Input;
    // At random every edge is drawn.
    const std::vector<const Chart*> charts = charts_of(model, model.loops[*loop]);
    Simulation simulation(*network, charts, job.options.random_seed ? Detail::Everything : detail_of(job));
    return move(simulation, charts, job, streams);
}

ExitCode simulate_chart(const Model& model, Job& job, const Streams& streams) {
    const auto chart = chosen_chart(model, job);
    if (!chart || !equations_of(model, *chart, job)) return ExitCode::Input;  // what has none has no rules
    Simulation simulation(model.charts[*chart], execution_mode(model, *chart, job), detail_of(job));
    return move(simulation, {&model.charts[*chart]}, job, streams);
}

}  // namespace

ExitCode simulate(Job& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    if (!model) return ExitCode::Input;
    return is_of_a_chart(*model, job.options) ? simulate_chart(*model, job, streams)
                                              : simulate_loop(*model, job, streams);
}

Verb simulate_usage() {
    return {"simulate",
            "FILE",
            1,
            1,
            "move a closed loop, or a chart, by hand, by a script, or at random",
            "Runs FILE's closed loop: choose what the plant and its environment do, set inputs, let time pass; the "
            "controller\n"
            "follows by itself. Commands come from standard input, or from a script; with --verbose every edge is a "
            "choice.\n"
            "A file without a closed loop, or --chart: the chart alone, its inputs set by hand.\n"
            "  NAME = VALUE       make an input true, false or a number; of a chart alone also `NAME = VALUE, ...`, at "
            "once\n"
            "  wait 3s            let time pass (ms, s, min); `wait` alone: until something happens by itself, or can\n"
            "  do INSTANCE [LOC]  the instance does what it can, or what leads it to location LOC\n"
            "  force STEP on|off  a trial: make the step active by hand, or not; not a run of the model from there on\n"
            "  back, quit         undo the last command, end",
            {"grafverif simulate samples/blinker/blinker.grafcet",
             "grafverif simulate station.grafcet --script press_start.txt",
             "grafverif simulate samples/oven_door/oven_door.grafcet --chart oven_door",
             "grafverif simulate station.grafcet --random 7 --steps 500 --trace-svg walk.svg"},
            {Accepts::Walk, Accepts::Loop, Accepts::Chart, Accepts::Mode, Accepts::Grain, Accepts::Traces,
             Accepts::Verbose}};
}

}  // namespace grafverif::app
