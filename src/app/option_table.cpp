// SPDX-License-Identifier: MIT
// Option table: the options of all commands, in the order of --help. Its rows determine which options a command
// accepts, how they are read, and their help text.
#include "app/option_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>

#include "app/settle.hpp"

namespace grafverif::app {

namespace {

/// A keyword of an option's value and its meaning.
template <class T>
struct Choice {
    std::string_view word = {};
    T value = {};
};

// -- types of options: `place` is a member of Options, or a function that returns one
// ------------------------------------

template <class Place>
Option toggle(Accepts accepts, const char* name, Place place, const char* help) {
    return {accepts, name, "", help, [place](const auto&, Options& options) {
                std::invoke(place, options) = true;
                return std::string();
            }};
}

template <class Place>
Option text(Accepts accepts, const char* name, const char* value, Place place, const char* help) {
    const auto take = [place, option = Option{accepts, name}.long_name()](const auto& given, Options& options) {
        std::invoke(place, options) = given.front();
        return given.front().empty() ? fmt::format("the value of `--{}` is empty", option) : std::string();
    };
    return {accepts, name, value, help, take};
}

/// A shell command.
template <class Place>
Option command(Accepts accepts, const char* name, const char* value, Place place, const char* help) {
    Option option = text(accepts, name, value, place, help);
    option.is_command = true;
    return option;
}

/// An option that had the name `former` in the previous version.
Option renamed(const char* former, Option option) {
    option.former = former;
    return option;
}

template <class Place>
Option list(Accepts accepts, const char* name, const char* value, Place place, const char* help) {
    return {accepts,
            name,
            value,
            help,
            [place](const std::vector<std::string>& given, Options& options) {
                std::invoke(place, options) = given;
                return std::string();
            },
            true};
}

template <class T, class Place>
Option choice(Accepts accepts, const char* name, std::vector<Choice<T>> choices, Place place, const char* help) {
    std::string words, known;
    for (const Choice<T>& one : choices) {
        words += fmt::format("{}{}", words.empty() ? "" : "|", one.word);
        known += fmt::format("{}`{}`", known.empty() ? "" : ", ", one.word);
    }
    return {accepts, name, words, help, [=](const std::vector<std::string>& given, Options& options) {
                const auto found = std::ranges::find(choices, given.front(), &Choice<T>::word);
                if (found == choices.end())
                    return fmt::format("invalid value `{2}` of `--{0}`; use one of {1}", name, known, given.front());
                std::invoke(place, options) = found->value;
                return std::string();
            }};
}

/// A whole number, multiplied by the factor of its suffix. `suffixes`: the accepted suffixes, the usual one first; one
/// is required.
template <class Place>
Option number(Accepts accepts, const char* name, const char* value, std::vector<Choice<std::uint64_t>> suffixes,
              Place place, const char* help) {
    if (suffixes.empty()) suffixes = {{"", 1}};
    std::string known;
    for (const Choice<std::uint64_t>& one : suffixes)
        known += fmt::format("{}`{}`", known.empty() ? "" : ", ", one.word);
    return {accepts, name, value, help, [=](const std::vector<std::string>& given, Options& options) {
                const std::string& word = given.front();
                const char* const stop = word.data() + word.size();
                std::uint64_t read = 0;
                const auto [end, failure] = std::from_chars(word.data(), stop, read);
                const std::string_view suffix(end, static_cast<std::size_t>(stop - end));
                const auto found = std::ranges::find(suffixes, suffix, &Choice<std::uint64_t>::word);
                const bool fits = failure == std::errc{} && found != suffixes.end() &&
                                  read <= std::numeric_limits<std::uint64_t>::max() / found->value;
                if (!fits && suffix.empty() && failure == std::errc{})
                    return fmt::format("`--{} {}` has no unit; write `{}{}`", name, word, word, suffixes.front().word);
                if (!fits && suffixes.size() == 1)
                    return fmt::format("invalid value `{1}` of `--{0}`; use a whole number", name, word);
                if (!fits)
                    return fmt::format("invalid value `{2}` of `--{0}`; use a whole number with one of the units {1}",
                                       name, known, word);
                std::invoke(place, options) = read * found->value;
                return std::string();
            }};
}

/// A time in milliseconds, at most a hundred years, since clocks count nanoseconds in 63 bits.
template <class Place>
Option time(Accepts accepts, const char* name, Place place, const char* help) {
    static constexpr std::uint64_t hundred_years = std::uint64_t{100} * 365 * 24 * 3'600'000;
    static_assert(2 * hundred_years < std::numeric_limits<std::int64_t>::max() / 1'000'000);
    Option option =
        number(accepts, name, "TIME", {{"s", 1000}, {"ms", 1}, {"min", 60'000}, {"h", 3'600'000}}, place, help);
    option.take = [read = option.take, place](const std::vector<std::string>& given, Options& options) {
        std::string complaint = read(given, options);
        if (complaint.empty()) std::invoke(place, options) = std::min(*std::invoke(place, options), hundred_years);
        return complaint;
    };
    return option;
}

std::vector<Option> options_for_models() {
    constexpr ExecutionMode search = ExecutionMode::StabilitySearch, every = ExecutionMode::EveryCycle;
    const auto untimed = [](auto member) {
        return [member](Options & options) -> auto& { return options.untimed.*member; };
    };
    return {
        text(Accepts::Output, "output,o", "FILE", &Options::output, "write to FILE instead of standard output"),
        text(Accepts::OutputDirectory, "output,o", "DIR", &Options::output,
             "write into DIR (default: ./NAME.grafverif, created if missing)"),
        text(Accepts::OutputDirectory, "name", "NAME", &Options::name,
             "name the files NAME.xml, NAME.q, NAME.smv (default: name of the loop)"),
        toggle(Accepts::All, "all", &Options::all, "process every closed loop of FILE (`analyse`: every chart)"),
        choice<Target>(Accepts::Target, "target", {{"uppaal", Target::Uppaal}, {"nusmv", Target::Nusmv}},
                       &Options::target, "write one target only (default: both)"),
        text(Accepts::Loop, "loop", "NAME", &Options::loop, "closed loop to use if the file has several"),
        {Accepts::Constants, "set", "NAME=VALUE", "set a constant of the closed loop; repeatable", take_constants,
         true},
        text(Accepts::Chart, "chart", "NAME", &Options::chart, "chart to use if the file has several"),
        choice<ExecutionMode>(Accepts::Mode, "mode", {{word(search), search}, {word(every), every}}, &Options::mode,
                              "execution mode, which determines when outputs are written; overrides the model"),
        choice<Grain>(Accepts::Grain, "grain", {{"phased", Grain::Phased}, {"atomic", Grain::Atomic}}, &Options::grain,
                      "phased: the plant can move within a PLC cycle; atomic: it cannot; overrides the model"),
        choice<PlantApproach>(Accepts::Untimed, "plant",
                              {{"none", PlantApproach::None},
                               {"constraints", PlantApproach::Constraints},
                               {"automata", PlantApproach::Automata}},
                              &Options::plant,
                              "plant of the untimed model: none, the constraints on its inputs, or its automata "
                              "(default: none, or automata if an option below is given)"),
        choice<Schedule>(Accepts::Untimed, "schedule",
                         {{"interleaved", Schedule::Interleaved},
                          {"synchronous", Schedule::Synchronous},
                          {"sequenced", Schedule::Sequenced}},
                         untimed(&ScheduleOptions::schedule),
                         "processes that move in one step of a model with plant automata; overrides the model "
                         "(default: interleaved)"),
        choice<TimeModel>(Accepts::Untimed, "time",
                          {{"abstract", TimeModel::Abstract}, {"discrete", TimeModel::Discrete}},
                          untimed(&ScheduleOptions::time),
                          "abstract: a timed edge can be taken at any time; discrete: clocks are bounded counters "
                          "(default: abstract)"),
        toggle(Accepts::Untimed, "fairness", untimed(&ScheduleOptions::fairness),
               "assume that every plant movement terminates"),
    };
}

std::vector<Option> options_for_forms() {
    using F = Format;
    const char* const form = "output format (default: text)";
    const auto format = [](Accepts accepts, std::vector<Choice<F>> choices, const char* help) {
        return choice<F>(accepts, "format", std::move(choices), &Options::format, help);
    };
    return {
        format(Accepts::Format, {{"text", F::Text}, {"json", F::Json}}, form),
        format(Accepts::FormatLatex, {{"text", F::Text}, {"latex", F::Latex}, {"json", F::Json}}, form),
        choice<bool>(Accepts::FormatAiger, "format", {{"aag", false}, {"aig", true}}, &Options::binary,
                     "output format: ASCII or binary (default: aig for a file with this suffix, otherwise aag)"),
        format(Accepts::FormatDiagram, {{"text", F::Text}, {"json", F::Json}, {"dot", F::Dot}, {"svg", F::Svg}}, form),
        toggle(Accepts::FormatDiagram, "counts", &Options::counts, "print only counts, no tables"),
        format(Accepts::FormatTest, {{"csv", F::Csv}, {"json", F::Json}, {"st", F::Text}, {"xml", F::Xml}},
               "output format: table, JSON, Structured Text or PLCopen XML (default: csv)"),
        choice<TestCover>(Accepts::Cover, "cover",
                          {{"transitions", TestCover::Transitions},
                           {"evolutions", TestCover::Evolutions},
                           {"locations", TestCover::Locations}},
                          &Options::cover,
                          "test coverage: every combination of inputs in every state, every evolution once, or every "
                          "location (default: transitions)"),
        choice<bool>(Accepts::Cover, "hold", {{"stable", false}, {"one", true}}, &Options::one_cycle_each,
                     "cycles per step: two if the situation does not change, or always one (default: stable)"),
        toggle(Accepts::Minimise, "minimise", &Options::minimise, "merge states that cannot be distinguished"),
        number(Accepts::Limits, "max-states", "N", {}, &Options::max_states,
               "stop after N locations or states (default: 20000000)"),
        choice<Clock>(Accepts::Clock, "clock", {{"simulated", Clock::Simulated}, {"real", Clock::Real}},
                      &Options::clock, "simulated: `wait` lines advance time; real: time passes (default: simulated)"),
        format(Accepts::FormatXml, {{"xml", F::Xml}, {"text", F::Text}}, "PLCopen XML or text (default: xml)"),
        text(Accepts::Drawing, "situation", "STEPS", &Options::situation,
             "mark these steps as active, for example `3,5` or `G1.3`"),
        number(Accepts::Drawing, "columns", "N", {}, &Options::columns,
               "fold long charts into N columns (default: as many as fit on a page)"),
        choice<Notation>(Accepts::Drawing, "notation", {{"iec", Notation::Iec}, {"text", Notation::Text}},
                         &Options::notation, "notation of conditions: IEC 60848, or the text language (default: iec)"),
        number(Accepts::MaxEvolutions, "max-evolutions", "N", {}, &Options::max_evolutions,
               "maximum number of evolutions of a stable cycle (default: 1000)"),
    };
}

/// The options of `check`, `test`, `simulate` and `analyse`.
std::vector<Option> options_for_checks() {
    using F = Format;
    return {
        list(Accepts::Search, "property", "NAME", &Options::properties, "check only this property; repeatable"),
        list(Accepts::Questions, "property", "NAME", &Options::properties,
             "write only this property, with its observer if it has one; repeatable"),
        list(Accepts::Supervision, "property", "NAME", &Options::properties, "enforce only this property; repeatable"),
        text(Accepts::Supervision, "marked", "TERM", &Options::marked,
             "condition that must remain reachable (default: the initial situation)"),
        choice<Held>(Accepts::Supervision, "conditions",
                     {{"both", Held::Both}, {"transitions", Held::Transitions}, {"outputs", Held::Outputs}},
                     &Options::held, "elements that get conditions (default: both)"),
        choice<Engine>(
            Accepts::Search, "engine",
            {{"auto", Engine::Auto},
             {"timed", Engine::Timed},
             {"symbolic", Engine::Symbolic},
             {"pdr", Engine::Pdr},
             {"bmc", Engine::Bmc},
             {"abc", Engine::Abc},
             {"verifyta", Engine::Verifyta},
             {"NuSMV", Engine::Nusmv},
             {"nuXmv", Engine::Nuxmv}},
            &Options::engine,
            "engine (default: auto: timed; for untimed models symbolic, which localization, pdr and bmc join "
            "after about a second)"),
        command(Accepts::Search, "engine-command", "CMD", &Options::engine_command,
                "check with an external AIGER model checker: the shell runs CMD FILE.aig"),
        toggle(Accepts::Search, "untimed", &Options::check_untimed, "check the untimed model (see `--engine`)"),
        renamed(
            "whole",
            toggle(Accepts::Search, "monolithic", &Options::whole,
                   "explore the complete loop for every property, without sub-loops (independent subsystems) and cells "
                   "(localization)")),
        {Accepts::Search, "jobs", "N", "number of threads (default: one per core; two at most for untimed models)",
         take_jobs},
        number(Accepts::Search, "max-states", "N", {}, &Options::max_states,
               "stop after N states (default: 500000000)"),
        number(Accepts::Search, "max-steps", "N", {}, &Options::max_steps,
               "maximum trace length of engine bmc, in steps (default: 100)"),
        toggle(Accepts::Stats, "stats", &Options::stats,
               "print the components and clocks that contribute most states (timed engine)"),
        text(Accepts::Verdicts, "properties", "FILE", &Options::property_file,
             "check FILE operands as PLC programs (Structured Text), with the properties of this YAML file"),
        toggle(Accepts::Verdicts, "why", &Options::why, "print the elements that each proof depends on (timed engine)"),
        text(Accepts::Search, "junit", "FILE", &Options::junit, "write a JUnit report to FILE"),
        text(Accepts::Search, "sarif", "FILE", &Options::sarif,
             "write unexpected verdicts as SARIF to FILE, for code scanning"),
        {Accepts::Verdicts, "json-lines", "", "print one line of JSON per verdict",
         [](const auto&, Options& options) { return options.format = Format::JsonLines, std::string(); }},
        toggle(Accepts::Verdicts, "list", &Options::list,
               "list file, loop and property of each check without running it (tab-separated)"),
        text(Accepts::Sequence, "sequence", "FILE", &Options::sequence,
             "test sequence of the chart, as CSV (default of `test`: generate one)"),
        command(Accepts::Bench, "against", "PROGRAM", &Options::against,
                "shell command that starts the controller under test"),
        toggle(Accepts::Bench, "stop-on-failure", &Options::stop_on_failure, "stop after the first failure (default)"),
        renamed("go-on", toggle(Accepts::Bench, "keep-going", &Options::go_on,
                                "continue after a failure if the controller can")),
        time(Accepts::Bench, "timeout", &Options::patience_ms,
             "time limit for each answer, for example 500ms or 5s (default: 10s)"),
        text(Accepts::Bench, "junit", "FILE", &Options::junit, "write a JUnit report to FILE"),
        choice<F>(Accepts::Analysis, "format", {{"text", F::Text}, {"json", F::Json}, {"sarif", F::Sarif}},
                  &Options::format, "output format (default: text)"),
        text(Accepts::Analysis, "sarif", "FILE", &Options::sarif, "also write the findings as SARIF to FILE"),
        text(Accepts::Analysis, "exclusions", "FILE", &Options::exclusions,
             "CSV table of pairs of inputs that are never true together"),
        text(Accepts::Date, "date", "TEXT", &Options::date, "date shown in the report (default: none)"),
        text(Accepts::Traces, "trace-vcd", "FILE", &Options::trace_vcd,
             "write the first trace as a waveform for GTKWave to FILE"),
        text(Accepts::Traces, "trace-svg", "FILE", &Options::trace_svg,
             "write the first trace as a timing diagram to FILE"),
        number(
            Accepts::Traces, "from", "EVENT", {}, [](Options & options) -> auto& { return options.events.from; },
            "first event of the timing diagram, as numbered there (default: 0)"),
        number(
            Accepts::Traces, "to", "EVENT", {}, [](Options & options) -> auto& { return options.events.to; },
            "last event of the timing diagram (default: last event of the trace)"),
        text(Accepts::Compare, "other-chart", "NAME", &Options::other_chart, "chart of OTHER (default: as --chart)"),
        renamed("each-mode", toggle(Accepts::Compare, "all-modes", &Options::each_mode, "compare in each mode")),
        text(Accepts::Compare, "from-situation", "STEPS", &Options::from_situation,
             "start with these steps active: `3,5`; `3,5:W3,W5` if b names them differently"),
        time(Accepts::Compare, "resolution", &Options::resolution_ms, "scan at multiples of TIME"),
        number(Accepts::Mutants, "limit", "N", {}, &Options::limit, "check at most N mutants (default: all)"),
        number(Accepts::Mutants, "seed", "SEED", {}, &Options::seed, "seed for the selection by --limit (default: 1)"),
        renamed("each", time(Accepts::Mutants, "mutant-timeout", &Options::each_ms,
                             "time limit for each mutant (default: 60s)")),
        {Accepts::Mutants, "jobs", "N", "check N mutants in parallel (default: one per core)", take_jobs},
        text(Accepts::Mutants, "state", "FILE", &Options::state_file, "store results in FILE, and resume from it"),
        text(Accepts::Mutants, "survivors", "DIR", &Options::survivors, "write surviving mutants into DIR"),
        text(Accepts::Walk, "script", "FILE", &Options::script, "read commands from FILE instead of standard input"),
        text(Accepts::Walk, "junit", "FILE", &Options::junit,
             "write the expectations of the script as a JUnit report to FILE"),
        number(Accepts::Walk, "random", "SEED", {}, &Options::random_seed, "random walk with this seed"),
        number(Accepts::Walk, "steps", "N", {}, &Options::steps, "number of moves of the random walk (default: 100)"),
        number(Accepts::Serve, "port", "N", {}, &Options::port, "listen on port N (default: any free port)"),
        toggle(Accepts::Serve, "open", &Options::open, "open the page in the browser"),
        time(Accepts::Serve, "timeout", &Options::patience_ms, "time limit for each check, for example 90s or 5min"),
        time(Accepts::Lsp, "timeout", &Options::patience_ms, "time limit for each check, for example 90s or 5min"),
        toggle(Accepts::Lsp, "stdio", &Options::stdio, "communicate over standard input and output (always the case)"),
        list(Accepts::Lsp, "include,I", "DIR", &Options::include_folders,
             "allow included files in DIR, and search for them there; repeatable"),
        toggle(Accepts::Verbose, "verbose,v", &Options::verbose, "include internal steps, witnesses and timing"),
    };
}

std::vector<Option> options_for_all() {
    constexpr std::uint64_t mega = std::uint64_t{1} << 20U;
    return {
        toggle(Accepts::InPlace, "in-place,i", &Options::in_place, "rewrite FILE in place"),
        toggle(Accepts::InPlace, "check", &Options::check, "write nothing; exit 1 if FILE is not in canonical form"),
        list(Accepts::File, "include,I", "DIR", &Options::include_folders,
             "allow included files in DIR, and search for them there; repeatable"),
        toggle(Accepts::File, "lossy", &Options::lossy,
               "omit elements of another format that cannot be imported, with a warning"),
        renamed("create",
                toggle(Accepts::Writes, "create-dirs", &Options::create, "create missing output directories")),
        text(Accepts::Writes, "depfile", "FILE", &Options::depfile,
             "write the input files of the outputs, included files too, to FILE"),
        renamed("depfile-form",
                choice<DepfileReader>(
                    Accepts::Writes, "depfile-format",
                    {{"make", DepfileReader::Make}, {"ninja", DepfileReader::Ninja}, {"cmake", DepfileReader::CMake}},
                    &Options::depfile_reader, "format of the depfile (default: make)")),
        text(Accepts::Writes, "depfile-target", "NAME", &Options::depfile_target,
             "target name in the depfile (default: the outputs as passed)"),
        number(Accepts::Always, "max-memory", "SIZE", {{"M", mega}, {"K", mega >> 10U}, {"G", mega << 10U}},
               &Options::max_memory,
               "stop above SIZE, for example 500M or 2G (default: 4G of states, 2G of decision diagrams, and the "
               "memory of the machine)"),
        time(Accepts::Timeout, "timeout", &Options::timeout_ms, "stop after TIME, for example 90s or 5min"),
        choice<DiagnosticFormat>(
            Accepts::Always, "diagnostics", {{"text", DiagnosticFormat::Text}, {"json", DiagnosticFormat::Json}},
            &Options::diagnostics, "format of errors and warnings on standard error (default: text)"),
        choice<ColourChoice>(
            Accepts::Always, "color",
            {{"auto", ColourChoice::Auto}, {"always", ColourChoice::Always}, {"never", ColourChoice::Never}},
            &Options::colour, "colour of verdicts, errors and warnings (default: auto: on a terminal)"),
        toggle(Accepts::Always, "quiet,q", &Options::quiet,
               "print no warnings and no list of files; `check`: failures only"),
        toggle(Accepts::Always, "help,h", &Options::help, "show this help"),
        renamed("without", {Accepts::Ablations, "ablate", "CORRECTION", "", leave_out_cures, true}),
        list(Accepts::Always, "operand", "", &Options::operands, ""),
    };
}

}  // namespace

std::vector<Option> options_of(const Verb& verb) {
    std::vector<Option> all;
    for (std::vector<Option>& group :
         std::vector{options_for_models(), options_for_forms(), options_for_checks(), options_for_all()})
        for (Option& option : group)
            if (accepts(verb, option.accepts)) all.push_back(std::move(option));
    return all;
}

}  // namespace grafverif::app
