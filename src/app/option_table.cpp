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
                    return fmt::format("`--{}` takes one of {}; not `{}`", name, known, given.front());
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
                    return fmt::format("`--{}` takes a whole number; not `{}`", name, word);
                if (!fits)
                    return fmt::format("`--{}` takes a whole number with a unit, one of {}; not `{}`", name, known,
                                       word);
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
             "write into DIR (default: ./NAME.grafverif, made if missing)"),
        text(Accepts::OutputDirectory, "name", "NAME", &Options::name,
             "call the files NAME.xml, NAME.q, NAME.smv (default: the name of the loop)"),
        toggle(Accepts::All, "all", &Options::all, "every closed loop of FILE (`analyse`: every chart), one by one"),
        choice<Target>(Accepts::Target, "target", {{"uppaal", Target::Uppaal}, {"nusmv", Target::Nusmv}},
                       &Options::target, "write one target only (default: both)"),
        text(Accepts::Loop, "loop", "NAME", &Options::loop, "the closed loop, where the file has several"),
        {Accepts::Constants, "set", "NAME=VALUE", "give a constant of the closed loop a value; may be repeated",
         take_constants, true},
        text(Accepts::Chart, "chart", "NAME", &Options::chart, "the chart, where the file has several"),
        choice<ExecutionMode>(Accepts::Mode, "mode", {{word(search), search}, {word(every), every}}, &Options::mode,
                              "when outputs are written; wins over what the file says"),
        choice<Grain>(Accepts::Grain, "grain", {{"phased", Grain::Phased}, {"atomic", Grain::Atomic}}, &Options::grain,
                      "whether the plant may move within a PLC cycle; wins over the file"),
        choice<PlantApproach>(
            Accepts::Untimed, "plant",
            {{"none", PlantApproach::None},
             {"constraints", PlantApproach::Constraints},
             {"automata", PlantApproach::Automata}},
            &Options::plant,
            "what the untimed model knows of the plant: nothing, the constraints on its inputs, or its automata "
            "(default: none, or automata where an option below is given)"),
        choice<Schedule>(
            Accepts::Untimed, "schedule",
            {{"interleaved", Schedule::Interleaved},
             {"synchronous", Schedule::Synchronous},
             {"sequenced", Schedule::Sequenced}},
            untimed(&ScheduleOptions::schedule),
            "who moves in a step of a model with plant automata; wins over the file (default: interleaved)"),
        choice<TimeModel>(Accepts::Untimed, "time",
                          {{"abstract", TimeModel::Abstract}, {"discrete", TimeModel::Discrete}},
                          untimed(&ScheduleOptions::time),
                          "whether timed edges may be taken at any moment, or clocks count (default: abstract)"),
        toggle(Accepts::Untimed, "fairness", untimed(&ScheduleOptions::fairness),
               "every movement of the plant comes to its end"),
    };
}

std::vector<Option> options_for_forms() {
    using F = Format;
    const char* const form = "form of the output (default: text)";
    const auto format = [](Accepts accepts, std::vector<Choice<F>> choices, const char* help) {
        return choice<F>(accepts, "format", std::move(choices), &Options::format, help);
    };
    return {
        format(Accepts::Format, {{"text", F::Text}, {"json", F::Json}}, form),
        format(Accepts::FormatLatex, {{"text", F::Text}, {"latex", F::Latex}, {"json", F::Json}}, form),
        choice<bool>(Accepts::FormatAiger, "format", {{"aag", false}, {"aig", true}}, &Options::binary,
                     "form of the output: ASCII or binary (default: aig for a file that ends so, else aag)"),
        format(Accepts::FormatDiagram, {{"text", F::Text}, {"json", F::Json}, {"dot", F::Dot}, {"svg", F::Svg}}, form),
        toggle(Accepts::FormatDiagram, "counts", &Options::counts, "print counts only, no tables"),
        format(Accepts::FormatTest, {{"csv", F::Csv}, {"json", F::Json}, {"st", F::Text}, {"xml", F::Xml}},
               "form of the output: a table, JSON, Structured Text alone or in PLCopen XML (default: csv)"),
        choice<TestCover>(Accepts::Cover, "cover",
                          {{"transitions", TestCover::Transitions},
                           {"evolutions", TestCover::Evolutions},
                           {"locations", TestCover::Locations}},
                          &Options::cover,
                          "what the test crosses: every combination of inputs in every state, every evolution once, or "
                          "every location (default: transitions)"),
        choice<bool>(Accepts::Cover, "hold", {{"stable", false}, {"one", true}}, &Options::one_cycle_each,
                     "cycles of a step: two where the controller stays, or one each (default: stable)"),
        toggle(Accepts::Minimise, "minimise", &Options::minimise, "merge states that nobody can tell apart"),
        number(Accepts::Limits, "max-states", "N", {}, &Options::max_states,
               "give up after N locations or states (default: 20000000)"),
        choice<Clock>(Accepts::Clock, "clock", {{"simulated", Clock::Simulated}, {"real", Clock::Real}},
                      &Options::clock, "how time passes: by `wait` lines, or by itself (default: simulated)"),
        format(Accepts::FormatXml, {{"xml", F::Xml}, {"text", F::Text}},
               "PLCopen XML or a textual unit (default: xml)"),
        text(Accepts::Drawing, "situation", "STEPS", &Options::situation,
             "mark these steps as active, such as `3,5` or `G1.3`"),
        number(Accepts::Drawing, "columns", "N", {}, &Options::columns,
               "fold long charts into N columns (default: as many as a page takes)"),
        choice<Notation>(Accepts::Drawing, "notation", {{"iec", Notation::Iec}, {"text", Notation::Text}},
                         &Options::notation, "logic as the standard writes it, or as the file does (default: iec)"),
        number(Accepts::MaxEvolutions, "max-evolutions", "N", {}, &Options::max_evolutions,
               "evolutions of one cycle, beyond which it is unstable (default: 1000)"),
    };
}

/// The options of `check`, `test`, `simulate` and `analyse`.
std::vector<Option> options_for_checks() {
    using F = Format;
    return {
        list(Accepts::Search, "property", "NAME", &Options::properties, "check this property only; may be repeated"),
        list(Accepts::Questions, "property", "NAME", &Options::properties,
             "write this property only, with its observer if it has one; may be repeated"),
        list(Accepts::Supervision, "property", "NAME", &Options::properties, "keep this one only; may be repeated"),
        text(Accepts::Supervision, "marked", "TERM", &Options::marked, "what stays within reach (default: the start)"),
        choice<Held>(Accepts::Supervision, "conditions",
                     {{"both", Held::Both}, {"transitions", Held::Transitions}, {"outputs", Held::Outputs}},
                     &Options::held, "what gets conditions (default: both)"),
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
            "the engine that proves (default: timed, of untimed models symbolic; auto: of untimed models the "
            "embedded ones beside each other)"),
        command(Accepts::Search, "engine-command", "CMD", &Options::engine_command,
                "prove with a checker of the hardware model checking competition: the shell runs CMD FILE.aig"),
        toggle(Accepts::Search, "untimed", &Options::check_untimed,
               "check the untimed model, with the symbolic engine or NuSMV"),
        toggle(Accepts::Search, "whole", &Options::whole,
               "search the whole loop for every property, also where sub-loops share only time or cells decide it"),
        {Accepts::Search, "jobs", "N", "search with N threads (default: one for each core)", take_jobs},
        number(Accepts::Search, "max-states", "N", {}, &Options::max_states,
               "give up after N states (default: 500000000)"),
        number(Accepts::Search, "max-steps", "N", {}, &Options::max_steps,
               "give up after all runs of N steps (engine bmc; default: 100)"),
        toggle(Accepts::Stats, "stats", &Options::stats, "say where the states come from (timed engine)"),
        toggle(Accepts::Verdicts, "why", &Options::why,
               "say what the properties that hold rest on, by leaving it out (timed engine)"),
        text(Accepts::Search, "junit", "FILE", &Options::junit, "write a JUnit report to FILE"),
        text(Accepts::Search, "sarif", "FILE", &Options::sarif,
             "write what is against expectation as SARIF to FILE, for code scanning"),
        {Accepts::Verdicts, "json-lines", "", "print a JSON object per verdict, each in a line",
         [](const auto&, Options& options) { return options.format = Format::JsonLines, std::string(); }},
        toggle(Accepts::Verdicts, "list", &Options::list,
               "decide nothing: print FILE, loop and property of each check there is, with tabs between"),
        text(Accepts::Sequence, "sequence", "FILE", &Options::sequence,
             "a test sequence of the chart, as CSV (`test`: without it, one is made)"),
        command(Accepts::Bench, "against", "PROGRAM", &Options::against,
                "the controller under test: a command for the shell"),
        toggle(Accepts::Bench, "stop-on-failure", &Options::stop_on_failure,
               "run no step after the first failure (the default)"),
        toggle(Accepts::Bench, "go-on", &Options::go_on, "run on after a failure, as far as the controller can"),
        time(Accepts::Bench, "timeout", &Options::patience_ms,
             "give an answer up after TIME, such as 500ms or 5s (default: 10s)"),
        text(Accepts::Bench, "junit", "FILE", &Options::junit, "write a JUnit report to FILE"),
        choice<F>(Accepts::Analysis, "format", {{"text", F::Text}, {"json", F::Json}, {"sarif", F::Sarif}},
                  &Options::format, "form of the output (default: text)"),
        text(Accepts::Analysis, "sarif", "FILE", &Options::sarif, "write the findings as SARIF to FILE, too"),
        text(Accepts::Analysis, "exclusions", "FILE", &Options::exclusions,
             "pairs of inputs that are never true together, in CSV"),
        text(Accepts::Date, "date", "TEXT", &Options::date, "the date to show (default: none)"),
        text(Accepts::Traces, "trace-vcd", "FILE", &Options::trace_vcd,
             "write the first trace as a waveform for GTKWave to FILE"),
        text(Accepts::Traces, "trace-svg", "FILE", &Options::trace_svg,
             "write the first trace as a timing diagram to FILE"),
        number(
            Accepts::Traces, "from", "EVENT", {}, [](Options & options) -> auto& { return options.events.from; },
            "the first event of the timing diagram, as it numbers them (default: 0)"),
        number(
            Accepts::Traces, "to", "EVENT", {}, [](Options & options) -> auto& { return options.events.to; },
            "the last event of the timing diagram (default: that of the trace)"),
        text(Accepts::Compare, "other-chart", "NAME", &Options::other_chart,
             "the chart of OTHER (default: as --chart)"),
        toggle(Accepts::Compare, "each-mode", &Options::each_mode, "ask in each mode, one after the other"),
        text(Accepts::Compare, "from-situation", "STEPS", &Options::from_situation,
             "begin with these steps: `3,5`; `3,5:W3,W5` where b calls them otherwise"),
        time(Accepts::Compare, "resolution", &Options::resolution_ms, "scans are at multiples of TIME"),
        number(Accepts::Mutants, "limit", "N", {}, &Options::limit, "judge N mutants at most (default: all)"),
        number(Accepts::Mutants, "seed", "SEED", {}, &Options::seed, "which ones --limit chooses (default: 1)"),
        time(Accepts::Mutants, "each", &Options::each_ms, "give each up after TIME (default: 60s)"),
        {Accepts::Mutants, "jobs", "N", "judge N mutants at once (default: one for each core)", take_jobs},
        text(Accepts::Mutants, "state", "FILE", &Options::state_file,
             "keep what is found in FILE, and go on from there"),
        text(Accepts::Mutants, "survivors", "DIR", &Options::survivors,
             "write those that no property notices into DIR"),
        text(Accepts::Walk, "script", "FILE", &Options::script, "take commands from FILE instead of standard input"),
        text(Accepts::Walk, "junit", "FILE", &Options::junit,
             "write what the script expects as a JUnit report to FILE"),
        number(Accepts::Walk, "random", "SEED", {}, &Options::random_seed, "make a random walk instead"),
        number(Accepts::Walk, "steps", "N", {}, &Options::steps, "moves of the random walk (default: 100)"),
        number(Accepts::Serve, "port", "N", {}, &Options::port, "listen on port N (default: any that is free)"),
        toggle(Accepts::Serve, "open", &Options::open, "open the page in the browser"),
        time(Accepts::Serve, "timeout", &Options::patience_ms, "give each check up after TIME, such as 90s or 5min"),
        time(Accepts::Lsp, "timeout", &Options::patience_ms, "give each check up after TIME, such as 90s or 5min"),
        toggle(Accepts::Lsp, "stdio", &Options::stdio, "speak on standard input and output, as it does anyhow"),
        list(Accepts::Lsp, "include,I", "DIR", &Options::include_folders,
             "look for included files in DIR too, and let them be read; may be repeated"),
        toggle(Accepts::Verbose, "verbose,v", &Options::verbose, "tell what is internal too"),
    };
}

std::vector<Option> options_for_all() {
    constexpr std::uint64_t mega = std::uint64_t{1} << 20U;
    return {
        toggle(Accepts::InPlace, "in-place,i", &Options::in_place, "rewrite FILE itself"),
        toggle(Accepts::InPlace, "check", &Options::check, "write nothing; exit 1 if FILE is not in canonical form"),
        list(Accepts::File, "include,I", "DIR", &Options::include_folders,
             "look for included files in DIR too, and let them be read; may be repeated"),
        toggle(Accepts::File, "lossy", &Options::lossy,
               "leave out what cannot be taken over from another format, with a warning"),
        toggle(Accepts::Writes, "create", &Options::create, "make missing folders of outputs"),
        text(Accepts::Writes, "depfile", "FILE", &Options::depfile,
             "write to FILE which files the outputs were made from, included ones too"),
        choice<DepfileReader>(
            Accepts::Writes, "depfile-form",
            {{"make", DepfileReader::Make}, {"ninja", DepfileReader::Ninja}, {"cmake", DepfileReader::CMake}},
            &Options::depfile_reader, "who reads the depfile (default: make)"),
        text(Accepts::Writes, "depfile-target", "NAME", &Options::depfile_target,
             "what --depfile calls the result (default: the outputs, as named here)"),
        number(Accepts::Always, "max-memory", "SIZE", {{"M", mega}, {"K", mega >> 10U}, {"G", mega << 10U}},
               &Options::max_memory,
               "give up above SIZE, such as 500M or 2G (default: 4G of states, 2G of decision diagrams, and what the "
               "machine has)"),
        time(Accepts::Timeout, "timeout", &Options::timeout_ms, "give up after TIME, such as 90s or 5min"),
        choice<DiagnosticFormat>(
            Accepts::Always, "diagnostics", {{"text", DiagnosticFormat::Text}, {"json", DiagnosticFormat::Json}},
            &Options::diagnostics, "form of errors and warnings on standard error (default: text)"),
        choice<ColourChoice>(
            Accepts::Always, "color",
            {{"auto", ColourChoice::Auto}, {"always", ColourChoice::Always}, {"never", ColourChoice::Never}},
            &Options::colour, "colours of verdicts, errors and warnings (default: auto, on a terminal)"),
        toggle(Accepts::Always, "quiet,q", &Options::quiet, "no warnings, no list of files; of `check`: failures only"),
        toggle(Accepts::Always, "help,h", &Options::help, "show this help"),
        {Accepts::Ablations, "without", "CURE", "", leave_out_cures, true},
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
