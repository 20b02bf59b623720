// SPDX-License-Identifier: MIT
// `simulate`: a closed loop moved by hand, by a script, or at random; what it did is told like a counterexample and
// replayed on the rules in the end.
#include <fmt/format.h>

#include <istream>
#include <ostream>
#include <random>
#include <sstream>

#include "app/commands.hpp"
#include "app/outputs.hpp"
#include "app/simulation.hpp"
#include "app/traces.hpp"
#include "app/verbs.hpp"
#include "pipeline/check.hpp"
#include "pipeline/models.hpp"
#include "report/terminal.hpp"
#include "run/network_walk.hpp"
#include "support/overloaded.hpp"
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
        answer(simulation_.settle());
    }

    /// What went wrong; empty: all is well.
    std::string obey(const Command& command) {
        return std::visit(
            overloaded{
                [&](const SetCommand& set) { return simulation_.set(set.name, set.value); },
                [&](const WaitCommand& wait) { return obey_wait(wait); },
                [&](const DoCommand& act) { return simulation_.act(act.instance, act.location); },
                [&](const ChooseCommand& choice) { return obey_choice(choice); },
                [&](BackCommand) { return std::string(simulation_.back() ? "" : "there is nothing to undo"); },
                [&](QuitCommand) { return over_ = true, std::string(); },
                [&](HelpCommand) { return out_ << help, std::string(); },
                [](NoCommand) { return std::string(); },
                [](const BadCommand& bad) { return bad.complaint; },
            },
            command);
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
        "  back               undo the last command\n"
        "  quit               end\n";

    std::string obey_wait(const WaitCommand& wait) {
        if (!wait.milliseconds) return simulation_.wait();
        const std::int64_t unit = simulation_.network().time_unit_ms;
        if (*wait.milliseconds % unit != 0)
            return fmt::format("the time unit of this loop is {}; wait a multiple of it", seconds_text(unit));
        return simulation_.wait(*wait.milliseconds / unit);
    }

    std::string obey_choice(const ChooseCommand& choice) {
        const std::vector<Fire> choices = simulation_.choices();
        if (choices.empty()) return "there is no choice now; let time pass with `wait`";
        if (choice.number > choices.size()) return fmt::format("there are {} choices", choices.size());
        return simulation_.choose(choices[choice.number - 1]);
    }

    void prompt() {
        std::size_t number = 0;
        for (const Fire& fire : simulation_.choices())
            out_ << fmt::format("{:>5}  {}\n", ++number,
                                choice_words(simulation_.network(), simulation_.state(), fire));
        const Leeway way = leeway(simulation_.network(), simulation_.state());
        const std::int64_t unit = simulation_.network().time_unit_ms;
        if (way.may_pass)
            out_ << (way.limit ? fmt::format(" wait  up to {}\n", seconds_text(*way.limit * unit))
                               : " wait  as long as you like\n");
        out_ << "> ";
    }

    Simulation& simulation_;
    std::ostream& out_;
    bool prompts_ = false;
    bool over_ = false;
    std::size_t shown_ = 0;
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

/// One move after the other, each of those possible as likely as the others; how long time passes is drawn too.
class RandomWalk {
public:
    explicit RandomWalk(std::uint64_t seed) : random_(seed) {}

    std::optional<Move> draw(const Simulation& simulation) {
        const std::vector<Fire> choices = simulation.choices();
        const Leeway way = leeway(simulation.network(), simulation.state());
        const std::uint64_t count = choices.size() + (way.may_pass ? 1 : 0);
        if (count == 0) return {};
        const std::uint64_t drawn = random_() % count;
        if (drawn < choices.size()) return choices[drawn];
        constexpr std::int64_t longest = 20;
        const std::int64_t most = std::min(way.limit.value_or(longest), way.change.value_or(longest));
        return Delay{
            1 + static_cast<std::int64_t>(random_() % static_cast<std::uint64_t>(std::max<std::int64_t>(most, 1)))};
    }

private:
    std::mt19937_64 random_;
};

std::string walk(Simulation& simulation, std::uint64_t seed, std::uint64_t steps) {
    RandomWalk walk(seed);
    std::string problem;
    for (std::uint64_t i = 0; i < steps; ++i) {
        const std::optional<Move> next = walk.draw(simulation);
        if (!next) return "nothing can happen any more";
        if (!simulation.move(*next, problem)) return problem;
    }
    return {};
}

}  // namespace

ExitCode simulate(Job& job, const Streams& streams) {
    const auto model = read_model(job.options.operands[0], job);
    const auto loop = model ? chosen_loop(*model, job) : std::nullopt;
    const auto network = loop ? network_of(*model, *loop, job) : std::nullopt;
    if (!network) return ExitCode::Input;

    const Detail detail = job.options.verbose ? Detail::Everything : Detail::Chart;
    ExitCode code = ExitCode::Done;
    ChartRun run;
    if (job.options.random_seed) {
        Simulation simulation(*network, Detail::Everything);  // every edge is drawn
        const std::string problem = walk(simulation, *job.options.random_seed, job.options.steps);
        run = tell(project(*network, simulation.run()), detail);
        print_trace(run, streams.out);
        if (!problem.empty()) streams.out << "! " << problem << '\n';
    } else {
        Simulation simulation(*network, detail);
        code = job.options.script ? follow_script(simulation, *job.options.script, streams, job)
                                  : converse(simulation, streams);
        run = simulation.told();
    }
    if (const auto found = disagreement(run, charts_of(*model, model->loops[*loop]))) {
        streams.err << "grafverif: internal failure: " << replay_failure("this run", *found) << '\n';
        return ExitCode::Failure;
    }
    write_outputs(trace_files(run, network->name, job.options), job, streams);
    return code;
}

Verb simulate_usage() {
    return {"simulate",
            "FILE",
            1,
            1,
            "move a closed loop by hand, by a script, or at random",
            "Runs FILE's closed loop: choose what the plant and its environment do, set inputs, let time pass; the "
            "controller\n"
            "follows by itself. Commands come from standard input, or from a script; with --verbose every edge is a "
            "choice.\n"
            "  NAME = VALUE       make an input true, false or a number\n"
            "  wait 3s            let time pass (ms, s, min); `wait` alone: until something happens by itself, or can\n"
            "  do INSTANCE [LOC]  the instance does what it can, or what leads it to location LOC\n"
            "  back, quit         undo the last command, end",
            {"grafverif simulate samples/blinker/blinker.grafcet",
             "grafverif simulate station.grafcet --script press_start.txt",
             "grafverif simulate station.grafcet --random 7 --steps 500 --trace-svg walk.svg"},
            {Accepts::Walk, Accepts::Loop, Accepts::Mode, Accepts::Grain, Accepts::Traces, Accepts::Verbose}};
}

}  // namespace grafverif::app
