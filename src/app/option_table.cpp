// SPDX-License-Identifier: MIT
// Option table: the options of all commands, in the order of --help. Each row determines which commands accept an
// option, how its value is read, and its help text.
#include "app/option_table.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <functional>
#include <limits>
#include <string_view>
#include <utility>

#include "app/validate_options.hpp"

namespace grafverif::app {

namespace {

/// A keyword that can be the value of an option, and the meaning of this keyword.
template <class T>
struct Choice {
    std::string_view word = {};
    T value = {};
};

// -- types of options (`place`: a member of Options, or a function that returns a member) -----------------------------

template <class Place>
Option toggle(OptionGroup accepts, const char* name, Place place, const char* help) {
    return {accepts, name, "", help, [place](const auto&, Options& options) {
                std::invoke(place, options) = true;
                return std::string();
            }};
}

template <class Place>
Option text(OptionGroup accepts, const char* name, const char* value, Place place, const char* help) {
    const auto take = [place, option = Option{accepts, name}.long_name()](const auto& given, Options& options) {
        std::invoke(place, options) = given.front();
        return given.front().empty() ? fmt::format("the value of `--{}` is empty; pass one", option) : std::string();
    };
    return {accepts, name, value, help, take};
}

/// Returns an option whose value is a shell command.
template <class Place>
Option command(OptionGroup accepts, const char* name, const char* value, Place place, const char* help) {
    Option option = text(accepts, name, value, place, help);
    option.is_command = true;
    return option;
}

/// Returns an option that was called `former` in the previous version.
Option renamed(const char* former, Option option) {
    option.former = former;
    return option;
}

template <class Place>
Option list(OptionGroup accepts, const char* name, const char* value, Place place, const char* help) {
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
Option choice(OptionGroup accepts, const char* name, std::vector<Choice<T>> choices, Place place, const char* help) {
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

/// Returns an option for a whole number, which is multiplied by the factor of its suffix. The value must have one of
/// the `suffixes`; an error message suggests the first suffix. An empty list means that no suffix is accepted.
template <class Place>
Option number(OptionGroup accepts, const char* name, const char* value, std::vector<Choice<std::uint64_t>> suffixes,
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
                const bool known_suffix = found != suffixes.end();
                const bool fits = failure == std::errc{} && known_suffix &&
                                  read <= std::numeric_limits<std::uint64_t>::max() / found->value;
                if (!fits && known_suffix && failure != std::errc::invalid_argument)
                    return fmt::format("value `{1}` of `--{0}` is too large; reduce it", name, word);
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

/// Returns an option for a time in milliseconds. A time above a hundred years is replaced by a hundred years, because
/// clocks count nanoseconds in 63 bits.
template <class Place>
Option time(OptionGroup accepts, const char* name, Place place, const char* help) {
    static constexpr std::uint64_t hundred_years = std::uint64_t{100} * 365 * 24 * 3'600'000;
    static_assert(2 * hundred_years < std::numeric_limits<std::int64_t>::max() / 1'000'000);
    Option option =
        number(accepts, name, "TIME", {{"s", 1000}, {"ms", 1}, {"min", 60'000}, {"h", 3'600'000}}, place, help);
    option.take = [read = option.take, place](const std::vector<std::string>& given, Options& options) {
        std::string error_text = read(given, options);
        if (error_text.empty()) std::invoke(place, options) = std::min(*std::invoke(place, options), hundred_years);
        return error_text;
    };
    return option;
}

std::vector<Option> options_for_models() {
    constexpr ExecutionMode search = ExecutionMode::StabilitySearch, every = ExecutionMode::EveryCycle;
    const auto untimed = [](auto member) {
        return [member](Options & options) -> auto& { return options.untimed.*member; };
    };
    return {
        text(OptionGroup::Output, "output,o", "FILE", &Options::output, "write to FILE instead of standard output"),
        text(OptionGroup::OutputDirectory, "output,o", "DIR", &Options::output,
             "write the files into DIR (default: ./NAME.grafverif, which is created if missing)"),
        text(OptionGroup::OutputDirectory, "name", "NAME", &Options::name,
             "name the files NAME.xml, NAME.q, NAME.smv (default: name of the loop)"),
        toggle(OptionGroup::All, "all", &Options::all,
               "process every closed loop of each FILE (`analyse`, or `check` without closed loops: every chart)"),
        choice<Target>(OptionGroup::Target, "target", {{"uppaal", Target::Uppaal}, {"nusmv", Target::Nusmv}},
                       &Options::target, "write only the model for this program (default: both models)"),
        text(OptionGroup::Loop, "loop", "NAME", &Options::loop,
             "name of the closed loop to use, if FILE has several closed loops"),
        {OptionGroup::Constants, "set", "NAME=VALUE", "set a constant of the closed loop; repeatable", take_constants,
         true},
        text(OptionGroup::Chart, "chart", "NAME", &Options::chart,
             "name of the chart to use, if FILE has several charts"),
        choice<ExecutionMode>(OptionGroup::Mode, "mode", {{word(search), search}, {word(every), every}}, &Options::mode,
                              "execution mode: outputs are written when the situation is stable, or after each "
                              "evolution; overrides the mode in the model"),
        choice<Grain>(OptionGroup::Grain, "grain", {{"phased", Grain::Phased}, {"atomic", Grain::Atomic}},
                      &Options::grain,
                      "phased: the plant can move within a PLC cycle; atomic: the plant cannot move within a cycle; "
                      "overrides the grain in the model"),
        choice<CycleTime>(OptionGroup::Cycle, "cycle", {{"zero", CycleTime::Zero}, {"task", CycleTime::Task}},
                          &Options::cycle,
                          "cycle time of the PLCs: zero, or the task cycles of the model (default: task)"),
        choice<CycleTime>(OptionGroup::CycleBoth, "cycle",
                          {{"zero", CycleTime::Zero}, {"task", CycleTime::Task}, {"both", CycleTime::Both}},
                          &Options::cycle,
                          "cycle time of the PLCs: zero, or the task cycles of the model; both: check with both cycle "
                          "times, and add a note to each verdict that differs (default: task)"),
        choice<PlantApproach>(
            OptionGroup::Untimed, "plant",
            {{"none", PlantApproach::None},
             {"constraints", PlantApproach::Constraints},
             {"automata", PlantApproach::Automata}},
            &Options::plant,
            "plant in the untimed model: none, constraints on the inputs, or plant automata "
            "(default: automata with `--schedule`, `--time discrete`, `--fairness` or a task cycle; otherwise "
            "none)"),
        choice<Schedule>(OptionGroup::Untimed, "schedule",
                         {{"interleaved", Schedule::Interleaved},
                          {"synchronous", Schedule::Synchronous},
                          {"sequenced", Schedule::Sequenced}},
                         untimed(&ScheduleOptions::schedule),
                         "processes that move in one step of an untimed model with plant automata; overrides the "
                         "schedule in the model (default: interleaved)"),
        choice<TimeModel>(OptionGroup::Untimed, "time",
                          {{"abstract", TimeModel::Abstract}, {"discrete", TimeModel::Discrete}},
                          untimed(&ScheduleOptions::time),
                          "time in the untimed model: abstract: a timed edge can be taken at any time; discrete: "
                          "clocks are bounded counters (default: abstract)"),
        toggle(OptionGroup::Untimed, "fairness", untimed(&ScheduleOptions::fairness),
               "assume in the untimed model that every plant movement that has started also ends"),
    };
}

std::vector<Option> options_for_forms() {
    using F = Format;
    const char* const form = "output format (default: text)";
    const auto format = [](OptionGroup accepts, std::vector<Choice<F>> choices, const char* help) {
        return choice<F>(accepts, "format", std::move(choices), &Options::format, help);
    };
    return {
        format(OptionGroup::Format, {{"text", F::Text}, {"json", F::Json}}, form),
        format(OptionGroup::FormatLatex, {{"text", F::Text}, {"latex", F::Latex}, {"json", F::Json}}, form),
        choice<bool>(OptionGroup::FormatAiger, "format", {{"aag", false}, {"aig", true}}, &Options::binary,
                     "output format: ASCII or binary (default: aig for a file with this suffix, otherwise aag)"),
        format(OptionGroup::FormatDiagram, {{"text", F::Text}, {"json", F::Json}, {"dot", F::Dot}, {"svg", F::Svg}},
               form),
        toggle(OptionGroup::FormatDiagram, "counts", &Options::counts,
               "print only the numbers of locations, states and evolutions, without tables"),
        format(OptionGroup::FormatTest, {{"csv", F::Csv}, {"json", F::Json}, {"st", F::Text}, {"xml", F::Xml}},
               "output format: table, JSON, Structured Text or PLCopen XML (default: csv)"),
        choice<TestCover>(OptionGroup::Cover, "cover",
                          {{"transitions", TestCover::Transitions},
                           {"evolutions", TestCover::Evolutions},
                           {"locations", TestCover::Locations}},
                          &Options::cover,
                          "elements that the test covers: transitions: every combination of inputs in every state; "
                          "evolutions: every evolution once; locations: every location (default: transitions)"),
        choice<bool>(OptionGroup::Cover, "hold", {{"stable", false}, {"one", true}}, &Options::one_cycle_each,
                     "PLC cycles of a test step: stable: two if the inputs keep the controller in the reached state, "
                     "otherwise one; one: always one (default: stable)"),
        toggle(OptionGroup::Minimise, "minimise", &Options::minimise,
               "merge states that no sequence of inputs can distinguish by the outputs"),
        number(OptionGroup::Limits, "max-states", "N", {}, &Options::max_states,
               "stop if the automaton has more than N locations or states (default: 20000000)"),
        choice<Clock>(OptionGroup::Clock, "clock", {{"simulated", Clock::Simulated}, {"real", Clock::Real}},
                      &Options::clock,
                      "clock of the controller: simulated: only `wait` lines advance time; real: time passes as on a "
                      "PLC (default: simulated)"),
        format(OptionGroup::FormatXml, {{"xml", F::Xml}, {"text", F::Text}},
               "output format: PLCopen XML or text (default: xml)"),
        text(OptionGroup::Drawing, "situation", "STEPS", &Options::situation,
             "mark these steps as active, for example `3,5` or `G1.3`"),
        number(OptionGroup::Drawing, "columns", "N", {}, &Options::columns,
               "fold long charts into N columns (default: as many as fit on a page)"),
        choice<Notation>(OptionGroup::Drawing, "notation", {{"iec", Notation::Iec}, {"text", Notation::Text}},
                         &Options::notation, "notation of conditions: IEC 60848 or the text language (default: iec)"),
        number(
            OptionGroup::MaxEvolutions, "max-evolutions", "N", {},
            [](Options & options) -> auto& { return options.st.max_evolutions; },
            "maximum number of evolutions in one PLC cycle, with mode stability-search (default: 1000)"),
        choice<structured_text::Dialect>(
            OptionGroup::StructuredText, "dialect",
            {{"iec", structured_text::Dialect::Iec},
             {"codesys", structured_text::Dialect::Codesys},
             {"twincat", structured_text::Dialect::Twincat},
             {"siemens", structured_text::Dialect::Siemens}},
            [](Options & options) -> auto& { return options.st.dialect; }, "dialect of the program (default: iec)"),
        toggle(
            OptionGroup::StructuredText, "prove", [](Options & options) -> auto& { return options.st.prove; },
            "read the generated text back, and write it only if it is proved equivalent to the chart"),
        time(OptionGroup::StructuredText, "resolution", &Options::resolution_ms,
             "with --prove: assume that scans occur at multiples of TIME (default: 1ms)"),
    };
}

/// Returns the options that only some commands accept, such as `check`, `test`, `simulate` and `analyse`.
std::vector<Option> options_for_checks() {
    using F = Format;
    return {
        list(OptionGroup::Search, "property", "NAME", &Options::properties, "check only this property; repeatable"),
        list(OptionGroup::Questions, "property", "NAME", &Options::properties,
             "write only this property, with its observer if it has one; repeatable"),
        list(OptionGroup::Supervision, "property", "NAME", &Options::properties,
             "enforce only this property; repeatable"),
        list(
            OptionGroup::Tuning, "over", "NAME=LOW..HIGH[:STEP]",
            [](Options & options) -> auto& { return options.tune.ranges; },
            "decide the properties for these values of a constant of the closed loop (default step: 1, or 1s for a "
            "duration); repeatable"),
        list(OptionGroup::Tuning, "property", "NAME", &Options::properties, "decide only this property; repeatable"),
        {OptionGroup::Tuning, "jobs", "N", "check N models in parallel (default: one per core)", take_jobs},
        toggle(
            OptionGroup::Tuning, "every-point", [](Options & options) -> auto& { return options.tune.every_point; },
            "check the model of every combination of values separately, without reusing verdicts or traces"),
        text(OptionGroup::Tuning, "report", "FILE", &Options::page,
             "write an HTML report to FILE, with maps and a player for the traces"),
        number(
            OptionGroup::Faults, "order", "N", {}, [](Options & options) -> auto& { return options.faults.order; },
            "maximum number of faults in a combination (default: 1)"),
        list(OptionGroup::Faults, "property", "NAME", &Options::properties, "decide only this property; repeatable"),
        text(OptionGroup::Faults, "openpsa", "FILE", &Options::open_psa,
             "write the minimal combinations as a fault tree to FILE (Open-PSA Model Exchange Format)"),
        text(OptionGroup::Faults, "report", "FILE", &Options::page,
             "write an HTML report to FILE, with a player for the traces"),
        {OptionGroup::Faults, "jobs", "N", "check N models in parallel (default: one per core)", take_jobs},
        text(OptionGroup::Supervision, "marked", "TERM", &Options::marked,
             "condition that must remain reachable with the synthesized conditions (default: the initial situation)"),
        choice<Held>(OptionGroup::Supervision, "conditions",
                     {{"both", Held::Both}, {"transitions", Held::Transitions}, {"outputs", Held::Outputs}},
                     &Options::held, "elements of the charts to which conditions are added (default: both)"),
        choice<Engine>(OptionGroup::Search, "engine",
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
                       "engine (default: auto, which selects timed for a timed model; for an untimed model, it selects "
                       "symbolic, and runs localization, pdr and bmc in parallel after about one second)"),
        command(OptionGroup::Search, "engine-command", "CMD", &Options::engine_command,
                "check with an external AIGER model checker: the shell runs CMD FILE.aig"),
        toggle(OptionGroup::Search, "untimed", &Options::check_untimed,
               "check the untimed model instead of the timed model"),
        renamed(
            "whole",
            toggle(OptionGroup::Search, "monolithic", &Options::whole,
                   "explore the complete loop for every property: do not use sub-loops (independent subsystems), cells "
                   "(localization), input abstraction and covering (omission of states that a stored state "
                   "simulates)")),
        {OptionGroup::Search, "jobs", "N", "number of threads (default: one per core, at most two for untimed models)",
         take_jobs},
        number(OptionGroup::Search, "max-states", "N", {}, &Options::max_states,
               "stop after N states (default: 500000000)"),
        number(OptionGroup::Search, "max-steps", "N", {}, &Options::max_steps,
               "maximum trace length of engine bmc, in steps (default: 100)"),
        toggle(OptionGroup::Stats, "stats", &Options::stats,
               "print the components and clocks that contribute the most states (timed engine)"),
        text(OptionGroup::ProgramProperties, "properties", "FILE", &Options::property_file,
             "check each FILE operand as a PLC program (Structured Text, PLCopen XML) against the properties in this "
             "YAML file"),
        text(OptionGroup::Verdicts, "certificate", "DIR", &Options::certificate,
             "write a certificate of the verdicts into DIR; other programs can check it (see `grafverif-certify`)"),
        text(OptionGroup::Verdicts, "report", "FILE", &Options::page,
             "write an HTML report to FILE, as `report` does, with the type of certificate of each verdict"),
        toggle(OptionGroup::Verdicts, "why", &Options::why,
               "print the elements that each proof depends on (timed engine, and PLC programs with `--properties`)"),
        text(OptionGroup::Search, "junit", "FILE", &Options::junit, "write a JUnit report to FILE"),
        text(OptionGroup::Search, "sarif", "FILE", &Options::sarif,
             "write unexpected verdicts as SARIF to FILE, for code scanning"),
        {OptionGroup::Verdicts, "json-lines", "", "print one line of JSON per verdict",
         [](const auto&, Options& options) { return options.format = Format::JsonLines, std::string(); }},
        toggle(OptionGroup::Verdicts, "list", &Options::list,
               "list the file, loop and property of each check, separated by tabs, without executing the checks"),
        text(OptionGroup::Sequence, "sequence", "FILE", &Options::sequence,
             "read the test sequence of the chart from the CSV table FILE; without it, `test` generates a sequence"),
        command(OptionGroup::Bench, "against", "PROGRAM", &Options::against,
                "shell command that starts the controller under test"),
        toggle(OptionGroup::Bench, "stop-on-failure", &Options::stop_on_failure,
               "stop after the first failure (default)"),
        renamed("go-on",
                toggle(OptionGroup::Bench, "keep-going", &Options::keep_going, "continue after a failure if possible")),
        time(OptionGroup::Bench, "timeout", &Options::response_timeout_ms,
             "time limit for each response, for example 500ms or 5s (default: 10s)"),
        text(OptionGroup::Bench, "junit", "FILE", &Options::junit, "write a JUnit report to FILE"),
        choice<F>(OptionGroup::Analysis, "format", {{"text", F::Text}, {"json", F::Json}, {"sarif", F::Sarif}},
                  &Options::format, "output format (default: text)"),
        text(OptionGroup::Analysis, "sarif", "FILE", &Options::sarif, "also write the findings as SARIF to FILE"),
        text(OptionGroup::Analysis, "exclusions", "FILE", &Options::exclusions,
             "CSV table of pairs of inputs that are never true together"),
        text(OptionGroup::Date, "date", "TEXT", &Options::date, "date shown in the report (default: none)"),
        text(OptionGroup::Traces, "trace-vcd", "FILE", &Options::trace_vcd,
             "write the first trace as a waveform for GTKWave to FILE"),
        text(OptionGroup::Traces, "trace-svg", "FILE", &Options::trace_svg,
             "write the first trace as a timing diagram to FILE"),
        number(
            OptionGroup::Traces, "from", "EVENT", {}, [](Options & options) -> auto& { return options.events.from; },
            "number of the first event in the timing diagram (default: 0)"),
        number(
            OptionGroup::Traces, "to", "EVENT", {}, [](Options & options) -> auto& { return options.events.to; },
            "number of the last event in the timing diagram (default: last event of the trace)"),
        text(OptionGroup::Compare, "other-chart", "NAME", &Options::other_chart,
             "chart of OTHER (default: the name given by --chart)"),
        renamed("each-mode",
                toggle(OptionGroup::Compare, "all-modes", &Options::all_modes, "compare in each execution mode")),
        text(OptionGroup::Compare, "from-situation", "STEPS", &Options::from_situation,
             "start with these steps active, for example `3,5`, or `3,5:W3,W5` if the steps of the chart of OTHER have "
             "other names"),
        time(OptionGroup::Compare, "resolution", &Options::resolution_ms,
             "assume that scans occur at multiples of TIME"),
        choice<bool>(OptionGroup::Compare, "compare", {{"scans", false}, {"settled", true}}, &Options::settled,
                     "compare the outputs of programs after each scan, or after repeated scans with constant inputs "
                     "until no variable changes (default: scans)"),
        list(OptionGroup::Compare, "map", "NAME=NAME", &Options::renamings,
             "the first NAME, an input or output of FILE, corresponds to the second NAME in OTHER; repeatable"),
        list(OptionGroup::Compare, "ignore", "NAME", &Options::ignored_outputs,
             "do not compare this output; repeatable"),
        text(OptionGroup::Compare, "stop-output", "NAME[=NAME]", &Options::stop_output,
             "name of the output by which a program reports a stop (value other than 0; `FAULT` in programs that `st` "
             "generates); with two names, the output of FILE and that of OTHER"),
        toggle(OptionGroup::Compare, "imported-charts", &Options::imported_charts,
               "compare the charts that `import` creates from Structured Text and PLCopen XML, not the programs"),
        toggle(OptionGroup::Analysis, "imported-charts", &Options::imported_charts,
               "analyse the chart that `import` creates from Structured Text or PLCopen XML, not the program"),
        text(OptionGroup::Log, "log", "FILE", &Options::log, "recording to check: CSV, JSON lines or VCD"),
        text(OptionGroup::Log, "report", "FILE", &Options::page,
             "write an HTML report to FILE, with a player for the recording"),
        time(OptionGroup::Recording, "jitter", &Options::jitter_ms,
             "maximum difference between a recorded time and the time in the controller (default: 20ms)"),
        list(OptionGroup::Recording, "skew", "COLUMN[,COLUMN...]=TIME", &Options::skews,
             "the clock of these columns differs from the clock of the other columns by an unknown "
             "constant offset of at most TIME; repeatable"),
        list(OptionGroup::Recording, "map", "COLUMN=NAME", &Options::renamings,
             "the column COLUMN of the log contains the values of the input or output NAME; repeatable"),
        number(OptionGroup::Mutants, "limit", "N", {}, &Options::limit, "check at most N mutants (default: all)"),
        number(OptionGroup::Mutants, "seed", "SEED", {}, &Options::seed,
               "seed for the random selection of the mutants by --limit (default: 1)"),
        renamed("each", time(OptionGroup::Mutants, "mutant-timeout", &Options::mutant_timeout_ms,
                             "time limit for each mutant (default: 60s)")),
        {OptionGroup::Mutants, "jobs", "N", "check N mutants in parallel (default: one per core)", take_jobs},
        text(OptionGroup::Mutants, "state", "FILE", &Options::state_file,
             "store the results in FILE, and continue a stopped run from FILE"),
        text(OptionGroup::Mutants, "survivors", "DIR", &Options::survivors,
             "write the mutants that no property detects into DIR"),
        text(OptionGroup::Walk, "script", "FILE", &Options::script,
             "read commands from FILE instead of standard input"),
        text(OptionGroup::Walk, "junit", "FILE", &Options::junit,
             "write the expectations of the script as a JUnit report to FILE"),
        number(OptionGroup::Walk, "random", "SEED", {}, &Options::random_seed, "execute a random walk with this seed"),
        number(OptionGroup::Walk, "steps", "N", {}, &Options::steps,
               "number of moves of the random walk (default: 100)"),
        number(OptionGroup::Serve, "port", "N", {}, &Options::port, "listen on port N (default: any free port)"),
        toggle(OptionGroup::Serve, "open", &Options::open, "open the page in the browser"),
        time(OptionGroup::Serve, "timeout", &Options::response_timeout_ms,
             "time limit for each check, for example 90s or 5min"),
        time(OptionGroup::Lsp, "timeout", &Options::response_timeout_ms,
             "time limit for each check, for example 90s or 5min"),
        time(OptionGroup::Mcp, "timeout", &Options::response_timeout_ms,
             "largest time limit that a call of a tool can request (default: 10min)"),
        toggle(OptionGroup::Lsp, "stdio", &Options::stdio,
               "communicate over standard input and output (the default; accepted for editors that pass it)"),
        list(OptionGroup::Lsp, "include,I", "DIR", &Options::include_folders,
             "allow included files in DIR, and search for them there; repeatable"),
        toggle(OptionGroup::Verbose, "verbose,v", &Options::verbose,
               "also print internal steps, witnesses and the duration of the check"),
    };
}

std::vector<Option> options_for_all() {
    constexpr std::uint64_t mega = std::uint64_t{1} << 20U;
    return {
        toggle(OptionGroup::InPlace, "in-place,i", &Options::in_place, "rewrite FILE in place"),
        toggle(OptionGroup::InPlace, "check", &Options::check,
               "write nothing; exit 1 if FILE is not in canonical form"),
        list(OptionGroup::File, "include,I", "DIR", &Options::include_folders,
             "allow included files in DIR, and search for them there; repeatable"),
        list(OptionGroup::Within, "within", "DIR", &Options::within,
             "read FILE and included files only below DIR, with symbolic links resolved; repeatable"),
        toggle(OptionGroup::File, "lossy", &Options::lossy,
               "omit elements that cannot be imported from another format, and print a warning for each"),
        renamed("create",
                toggle(OptionGroup::Writes, "create-dirs", &Options::create, "create missing output folders")),
        text(OptionGroup::Writes, "depfile", "FILE", &Options::depfile,
             "write to FILE a depfile: a list of the input files of each output, for a build system"),
        renamed("depfile-form",
                choice<DepfileReader>(
                    OptionGroup::Writes, "depfile-format",
                    {{"make", DepfileReader::Make}, {"ninja", DepfileReader::Ninja}, {"cmake", DepfileReader::CMake}},
                    &Options::depfile_reader, "format of the depfile (default: make)")),
        text(OptionGroup::Writes, "depfile-target", "NAME", &Options::depfile_target,
             "target name in the depfile (default: the output names as passed)"),
        number(OptionGroup::Always, "max-memory", "SIZE", {{"M", mega}, {"K", mega >> 10U}, {"G", mega << 10U}},
               &Options::max_memory,
               "stop if the memory of this process exceeds SIZE, for example 500M or 2G (default: 4G for states, 2G "
               "for decision diagrams, at most the memory of the machine)"),
        time(OptionGroup::Timeout, "timeout", &Options::timeout_ms, "stop after TIME, for example 90s or 5min"),
        choice<DiagnosticFormat>(
            OptionGroup::Always, "diagnostics", {{"text", DiagnosticFormat::Text}, {"json", DiagnosticFormat::Json}},
            &Options::diagnostics, "format of errors and warnings on standard error (default: text)"),
        choice<ColourChoice>(
            OptionGroup::Always, "color",
            {{"auto", ColourChoice::Auto}, {"always", ColourChoice::Always}, {"never", ColourChoice::Never}},
            &Options::colour,
            "colour of verdicts, errors and warnings (default: auto, which uses colour on a terminal)"),
        toggle(OptionGroup::Always, "quiet,q", &Options::quiet,
               "print neither warnings nor the list of written files; `check` prints only unexpected and unknown "
               "verdicts"),
        toggle(OptionGroup::Always, "help,h", &Options::help, "show this help"),
        renamed("without", {OptionGroup::Ablations, "ablate", "CORRECTION", "", disable_corrections, true}),
        list(OptionGroup::Always, "operand", "", &Options::operands, ""),
    };
}

}  // namespace

std::vector<Option> options_of(const CliCommand& verb) {
    std::vector<Option> all;
    for (std::vector<Option>& group :
         std::vector{options_for_models(), options_for_forms(), options_for_checks(), options_for_all()})
        for (Option& option : group)
            if (accepts(verb, option.accepts)) all.push_back(std::move(option));
    return all;
}

}  // namespace grafverif::app
