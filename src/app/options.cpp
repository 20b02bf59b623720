// SPDX-License-Identifier: MIT
#include "app/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/program_options.hpp>
#include <charconv>
#include <limits>
#include <ostream>
#include <utility>

namespace grafverif::app {

namespace {

namespace po = boost::program_options;

bool accepts(const Verb& verb, Accepts what) { return std::ranges::find(verb.accepts, what) != verb.accepts.end(); }

po::typed_value<std::string>* text(const char* name) { return po::value<std::string>()->value_name(name); }

/// Those of `check`, `simulate` and `analyse`.
void add_checking_options(const Verb& verb, po::options_description& options) {
    auto add = options.add_options();
    if (accepts(verb, Accepts::Search)) {
        add("property", po::value<std::vector<std::string>>()->value_name("NAME"),
            "check this property only; may be repeated");
        add("engine", text("auto|timed|symbolic|verifyta|NuSMV|nuXmv"),
            "the engine that proves (default: auto, an embedded one)");
        add("untimed", po::bool_switch(), "check the untimed model, with the symbolic engine or NuSMV");
        add("max-states", text("N"), "give up after N states (default: 500000000)");
        add("junit", text("FILE"), "write a JUnit report to FILE");
    }
    if (accepts(verb, Accepts::Sequence)) add("sequence", text("FILE"), "the test sequence, as CSV (`test`: without it, one is made of the chart)");
    if (accepts(verb, Accepts::Bench)) {
        add("against", text("PROGRAM"), "the controller under test: a command for the shell");
        add("stop-on-failure", po::bool_switch(), "run no step after the first failure (the default)");
        add("go-on", po::bool_switch(), "run on after a failure, as far as the controller can");
        add("timeout", text("TIME"), "give an answer up after TIME, such as 500ms or 5s (default: 10s)");
        add("junit", text("FILE"), "write a JUnit report to FILE");
    }
    if (accepts(verb, Accepts::Analysis)) {
        add("format", text("text|json|sarif"), "form of the output (default: text)");
        add("exclusions", text("FILE"), "pairs of inputs that are never true together, in CSV");
    }
    if (accepts(verb, Accepts::Traces)) {
        add("trace-vcd", text("FILE"), "write the first trace as a waveform for GTKWave to FILE");
        add("trace-svg", text("FILE"), "write the first trace as a timing diagram to FILE");
    }
    if (accepts(verb, Accepts::Walk)) {
        add("script", text("FILE"), "take commands from FILE instead of standard input");
        add("random", text("SEED"), "make a random walk instead");
        add("steps", text("N"), "moves of the random walk (default: 100)");
    }
    if (accepts(verb, Accepts::Verbose)) add("verbose,v", po::bool_switch(), "tell what is internal too");
}

po::options_description visible_options(const Verb& verb) {
    po::options_description options("Options", 100);
    auto add = options.add_options();
    if (accepts(verb, Accepts::Output)) add("output,o", text("FILE"), "write to FILE instead of standard output");
    if (accepts(verb, Accepts::OutputDirectory))
        add("output,o", text("DIR"), "write into DIR, made if missing (default: ./NAME.grafverif)");
    if (accepts(verb, Accepts::Target)) add("target", text("uppaal|nusmv"), "write one target only (default: both)");
    if (accepts(verb, Accepts::Loop)) add("loop", text("NAME"), "the closed loop, where the file has several");
    if (accepts(verb, Accepts::Chart)) add("chart", text("NAME"), "the chart, where the file has several");
    if (accepts(verb, Accepts::Mode))
        add("mode", text("stability-search|every-cycle"), "when outputs are written; wins over what the file says");
    if (accepts(verb, Accepts::Grain))
        add("grain", text("phased|atomic"), "whether the plant may move within a PLC cycle; wins over the file");
    if (accepts(verb, Accepts::Untimed)) {
        add("plant", text("none|constraints|automata"),
            "what the untimed model knows of the plant: nothing, the constraints on its inputs, or its automata "
            "(default: none, or automata where an option below is given)");
        add("schedule", text("interleaved|synchronous|sequenced"),
            "who moves in a step of a model with plant automata; wins over the file (default: interleaved)");
        add("time", text("abstract|discrete"),
            "whether timed edges may be taken at any moment, or clocks count (default: abstract)");
        add("fairness", po::bool_switch(), "every movement of the plant comes to its end");
    }
    if (accepts(verb, Accepts::Format)) add("format", text("text|json"), "form of the output (default: text)");
    if (accepts(verb, Accepts::FormatLatex)) add("format", text("text|latex|json"), "form of the output (default: text)");
    if (accepts(verb, Accepts::FormatDiagram)) {
        add("format", text("text|json|dot|svg"), "form of the output (default: text)");
        add("counts", po::bool_switch(), "print counts only, no tables");
    }
    if (accepts(verb, Accepts::FormatTest)) add("format", text("csv|json|st|xml"), "form of the output: a table, JSON, Structured Text alone or in PLCopen XML (default: csv)");
    if (accepts(verb, Accepts::Cover)) {
        add("cover", text("transitions|evolutions|locations"),
            "what the test crosses: every combination of inputs in every state, every evolution once, or every location (default: transitions)");
        add("hold", text("stable|one"), "cycles of a step: two where the controller stays, or one each (default: stable)");
    }
    if (accepts(verb, Accepts::Minimise)) add("minimise", po::bool_switch(), "merge states that nobody can tell apart");
    if (accepts(verb, Accepts::Limits))
        add("max-states", text("N"), "give up after N locations or states (default: 20000000)");
    if (accepts(verb, Accepts::Clock))
        add("clock", text("simulated|real"), "how time passes: by `wait` lines, or by itself (default: simulated)");
    if (accepts(verb, Accepts::FormatXml)) add("format", text("xml|text"), "PLCopen XML or a textual unit (default: xml)");
    if (accepts(verb, Accepts::MaxEvolutions))
        add("max-evolutions", text("N"), "evolutions of one cycle, beyond which it is unstable (default: 1000)");
    add_checking_options(verb, options);
    if (accepts(verb, Accepts::InPlace)) {
        add("in-place,i", po::bool_switch(), "rewrite FILE itself");
        add("check", po::bool_switch(), "write nothing; exit 1 if FILE is not in canonical form");
    }
    if (verb.operand == "FILE") {
        add("include,I", po::value<std::vector<std::string>>()->value_name("DIR"),
            "look for included files in DIR too, and let them be read; may be repeated");
        add("lossy", po::bool_switch(), "leave out what cannot be taken over from another format, with a warning");
    }
    add("max-memory", text("SIZE"),
        "give up above SIZE, such as 500M or 2G (default: 4G of states, 2G of decision diagrams, and what the machine has)");
    if (!accepts(verb, Accepts::Bench)) add("timeout", text("TIME"), "give up after TIME, such as 90s or 5min");
    add("diagnostics", text("text|json"), "form of errors and warnings on standard error (default: text)");
    add("color", text("auto|always|never"), "colours in errors and warnings (default: auto)");
    add("quiet,q", po::bool_switch(), "no warnings, no list of files");
    add("help,h", po::bool_switch(), "show this help");
    return options;
}

/// A word of an option's value and what it means.
template <class T>
struct Choice {
    std::string_view word = {};
    T value = {};
};

/// Sets `target` from option `name` if it was given; a complaint if its value is none of `choices`.
template <class T, class Place>
std::string choose(const po::variables_map& values, const char* name, std::initializer_list<Choice<T>> choices,
                   Place& target) {
    if (values.count(name) == 0) return {};
    const std::string& given = values[name].as<std::string>();
    std::string known;
    for (const Choice<T>& choice : choices) {
        if (choice.word == given) {
            target = choice.value;
            return {};
        }
        known += fmt::format("{}`{}`", known.empty() ? "" : ", ", choice.word);
    }
    return fmt::format("`--{}` takes one of {}; not `{}`", name, known, given);
}

std::string choose_all(const Verb& verb, const po::variables_map& values, Options& options) {
    std::string complaint;
    const auto keep = [&complaint](std::string found) {
        if (complaint.empty()) complaint = std::move(found);
    };
    keep(choose<ExecutionMode>(values, "mode", {{"stability-search", ExecutionMode::StabilitySearch},
                                                {"every-cycle", ExecutionMode::EveryCycle}}, options.mode));
    keep(choose<Grain>(values, "grain", {{"phased", Grain::Phased}, {"atomic", Grain::Atomic}}, options.grain));
    keep(choose<Clock>(values, "clock", {{"simulated", Clock::Simulated}, {"real", Clock::Real}}, options.clock));
    keep(choose<Target>(values, "target", {{"uppaal", Target::Uppaal}, {"nusmv", Target::Nusmv}}, options.target));
    keep(choose<TestCover>(values, "cover", {{"transitions", TestCover::Transitions}, {"evolutions", TestCover::Evolutions},
                                             {"locations", TestCover::Locations}}, options.cover));
    keep(choose<bool>(values, "hold", {{"stable", false}, {"one", true}}, options.one_cycle_each));
    if (accepts(verb, Accepts::FormatTest)) {
        options.format = Format::Csv;
        keep(choose<Format>(values, "format", {{"csv", Format::Csv}, {"json", Format::Json}, {"st", Format::Text},
                                                   {"xml", Format::Xml}}, options.format));
    } else if (accepts(verb, Accepts::FormatDiagram))
        keep(choose<Format>(values, "format", {{"text", Format::Text}, {"json", Format::Json}, {"dot", Format::Dot}, {"svg", Format::Svg}},
                            options.format));
    else if (accepts(verb, Accepts::FormatLatex))
        keep(choose<Format>(values, "format", {{"text", Format::Text}, {"latex", Format::Latex}, {"json", Format::Json}},
                            options.format));
    else if (accepts(verb, Accepts::FormatXml)) {
        options.format = Format::Xml;
        keep(choose<Format>(values, "format", {{"xml", Format::Xml}, {"text", Format::Text}}, options.format));
    } else if (accepts(verb, Accepts::Analysis))
        keep(choose<Format>(values, "format", {{"text", Format::Text}, {"json", Format::Json}, {"sarif", Format::Sarif}},
                            options.format));
    else
        keep(choose<Format>(values, "format", {{"text", Format::Text}, {"json", Format::Json}}, options.format));
    keep(choose<DiagnosticFormat>(values, "diagnostics",
                                  {{"text", DiagnosticFormat::Text}, {"json", DiagnosticFormat::Json}}, options.diagnostics));
    keep(choose<ColourChoice>(values, "color", {{"auto", ColourChoice::Auto}, {"always", ColourChoice::Always},
                                                {"never", ColourChoice::Never}}, options.colour));
    return complaint;
}

/// The options of untimed models; those that only plant automata have ask for them.
std::string choose_untimed(const po::variables_map& values, Options& options) {
    ScheduleOptions& untimed = options.untimed;
    untimed.fairness = values.count("fairness") != 0 && values["fairness"].as<bool>();
    std::optional<PlantApproach> plant;
    for (const std::string& complaint :
         {choose<PlantApproach>(values, "plant", {{"none", PlantApproach::None},
                                                  {"constraints", PlantApproach::Constraints},
                                                  {"automata", PlantApproach::Automata}}, plant),
          choose<Schedule>(values, "schedule", {{"interleaved", Schedule::Interleaved},
                                                {"synchronous", Schedule::Synchronous},
                                                {"sequenced", Schedule::Sequenced}}, untimed.schedule),
          choose<TimeModel>(values, "time", {{"abstract", TimeModel::Abstract}, {"discrete", TimeModel::Discrete}},
                            untimed.time)})
        if (!complaint.empty()) return complaint;
    const bool discrete = untimed.time == TimeModel::Discrete;
    const char* asked = untimed.schedule ? "schedule" : discrete ? "time discrete" : untimed.fairness ? "fairness" : nullptr;
    untimed.plant = plant.value_or(asked != nullptr ? PlantApproach::Automata : PlantApproach::None);
    if (asked != nullptr && untimed.plant != PlantApproach::Automata)
        return fmt::format("`--{}` needs `--plant automata`", asked);
    if (discrete && untimed.schedule.value_or(Schedule::Interleaved) != Schedule::Interleaved)
        return "`--time discrete` needs `--schedule interleaved`";
    if (discrete) untimed.schedule = Schedule::Interleaved;
    return {};
}

/// A whole number, times the factor of its suffix; `suffixes`: the first is that of a number without one.
std::string read_number(const po::variables_map& values, const char* name,
                        std::initializer_list<Choice<std::uint64_t>> suffixes, std::optional<std::uint64_t>& target) {
    if (values.count(name) == 0) return {};
    const std::string& given = values[name].as<std::string>();
    const std::string complaint = fmt::format("`--{}` takes a whole number{}; not `{}`", name,
                                              suffixes.size() == 0 ? "" : " with a unit", given);
    std::uint64_t number = 0;
    const auto [end, failure] = std::from_chars(given.data(), given.data() + given.size(), number);
    if (failure != std::errc{}) return complaint;
    const std::string_view suffix(end, static_cast<std::size_t>(given.data() + given.size() - end));
    std::uint64_t factor = suffix.empty() && suffixes.size() == 0 ? 1 : 0;
    for (const Choice<std::uint64_t>& known : suffixes)
        if (known.word == suffix) factor = known.value;
    if (factor == 0 || number > std::numeric_limits<std::uint64_t>::max() / factor) return complaint;
    target = number * factor;
    return {};
}

std::string read_numbers(const po::variables_map& values, Options& options) {
    constexpr std::uint64_t mega = std::uint64_t{1} << 20U;
    std::optional<std::uint64_t> steps = options.steps, evolutions = options.max_evolutions;
    for (const std::string& complaint :
         {read_number(values, "max-states", {}, options.max_states),
          read_number(values, "max-memory", {{"", mega}, {"K", mega >> 10U}, {"M", mega}, {"G", mega << 10U}},
                      options.max_memory),
          read_number(values, "timeout", {{"", 1000}, {"ms", 1}, {"s", 1000}, {"min", 60'000}, {"h", 3'600'000}},
                      options.timeout_ms),
          read_number(values, "random", {}, options.random_seed), read_number(values, "steps", {}, steps),
          read_number(values, "max-evolutions", {}, evolutions)})
        if (!complaint.empty()) return complaint;
    options.steps = *steps;
    if (*evolutions == 0 || *evolutions > std::numeric_limits<std::uint32_t>::max())
        return "`--max-evolutions` takes a number from 1 to 4294967295";
    options.max_evolutions = static_cast<std::uint32_t>(*evolutions);
    constexpr std::uint64_t hundred_years = std::uint64_t{100} * 365 * 24 * 3'600'000;   // clocks count nanoseconds in 63 bits
    static_assert(2 * hundred_years < std::numeric_limits<std::int64_t>::max() / 1'000'000);
    if (options.timeout_ms) options.timeout_ms = std::min(*options.timeout_ms, hundred_years);
    return {};
}

/// `--without CURE`: models with a failure that the method cures, for the page that shows them. Not in --help.
void add_hidden_options(const Verb& verb, po::options_description& options) {
    auto add = options.add_options();
    add("operand", po::value<std::vector<std::string>>());
    if (accepts(verb, Accepts::Ablations)) add("without", po::value<std::vector<std::string>>());
}

std::string leave_out_cures(const po::variables_map& values, Options& options) {
    if (values.count("without") == 0) return {};
    for (const std::string& cure : values["without"].as<std::vector<std::string>>()) {
        if (cure == "urgency") options.without.sensors_not_urgent = true;
        else if (cure == "flags") options.without.cycle_always = true;
        else if (cure == "stable") options.without.cycle_unless_stable = true;
        else if (cure == "restart") options.without.timers_as_published = true;
        else return fmt::format("`--without` takes one of `urgency`, `flags`, `stable`, `restart`; not `{}`", cure);
        options.cures_left_out.push_back(cure);
    }
    return {};
}

std::string choose_engine(const po::variables_map& values, Options& options) {
    const bool modelled = values.count("plant") != 0 || values.count("schedule") != 0 || values.count("time") != 0;
    options.check_untimed =
        modelled || options.untimed.fairness || (values.count("untimed") != 0 && values["untimed"].as<bool>());
    std::string complaint = choose<Engine>(values, "engine",
                                           {{"auto", Engine::Auto}, {"timed", Engine::Timed}, {"symbolic", Engine::Symbolic},
                                            {"verifyta", Engine::Verifyta}, {"NuSMV", Engine::Nusmv}, {"nuXmv", Engine::Nuxmv}},
                                           options.engine);
    if (!complaint.empty()) return complaint;
    const bool timed = options.engine == Engine::Timed || options.engine == Engine::Verifyta;
    if (timed && options.check_untimed)
        return fmt::format("`--engine {}` checks timed models; leave out `--untimed` and what it takes", values["engine"].as<std::string>());
    options.check_untimed = options.check_untimed || (!timed && options.engine != Engine::Auto);
    return {};
}

}  // namespace

ParsedOptions parse_options(const Verb& verb, std::span<const std::string> arguments) {
    po::options_description all = visible_options(verb);
    add_hidden_options(verb, all);
    po::positional_options_description positional;
    positional.add("operand", -1);

    po::variables_map values;
    try {
        const auto style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
        po::store(po::command_line_parser(std::vector<std::string>(arguments.begin(), arguments.end()))
                      .options(all).positional(positional).style(style).run(), values);
        po::notify(values);
    } catch (const po::error& failure) {
        return {{}, failure.what()};
    }

    Options options;
    const auto text = [&values](const char* name) -> std::optional<std::string> {
        return values.count(name) == 0 ? std::nullopt : std::optional(values[name].as<std::string>());
    };
    const auto flag = [&values](const char* name) { return values.count(name) != 0 && values[name].as<bool>(); };
    if (values.count("operand") != 0) options.operands = values["operand"].as<std::vector<std::string>>();
    options.output = text("output");
    options.loop = text("loop");
    options.chart = text("chart");
    options.in_place = flag("in-place");
    options.check = flag("check");
    options.minimise = flag("minimise");
    options.counts = flag("counts");
    options.junit = text("junit");
    options.trace_vcd = text("trace-vcd");
    options.trace_svg = text("trace-svg");
    options.against = text("against").value_or("");
    options.sequence = text("sequence");
    options.go_on = flag("go-on");
    options.script = text("script");
    options.exclusions = text("exclusions");
    if (values.count("include") != 0) options.include_folders = values["include"].as<std::vector<std::string>>();
    if (values.count("property") != 0) options.properties = values["property"].as<std::vector<std::string>>();
    options.verbose = flag("verbose");
    options.quiet = flag("quiet");
    options.lossy = flag("lossy");
    options.help = flag("help");
    if (std::string complaint = choose_all(verb, values, options); !complaint.empty()) return {{}, complaint};
    if (std::string complaint = leave_out_cures(values, options); !complaint.empty()) return {{}, complaint};
    if (std::string complaint = choose_untimed(values, options); !complaint.empty()) return {{}, complaint};
    if (std::string complaint = choose_engine(values, options); !complaint.empty()) return {{}, complaint};
    if (std::string complaint = read_numbers(values, options); !complaint.empty()) return {{}, complaint};
    if (accepts(verb, Accepts::Bench)) options.patience_ms = std::exchange(options.timeout_ms, {});
    if (options.help) return {options, {}};
    if (accepts(verb, Accepts::Bench) && options.against.empty()) return {{}, "`--against PROGRAM` is missing"};
    if (options.go_on && flag("stop-on-failure")) return {{}, "`--stop-on-failure` and `--go-on` exclude each other"};
    if (options.operands.size() < verb.least_operands) return {{}, fmt::format("`{}` is missing", verb.operand)};
    if (options.operands.size() > verb.most_operands)
        return {{}, fmt::format("one argument too many: `{}`", options.operands[verb.most_operands])};
    return {options, {}};
}

void print_help(const Verb& verb, std::ostream& out) {
    out << fmt::format("Usage: grafverif {} {}[options]\n\n{}\n\n", verb.name,
                       verb.operand.empty() ? "" : verb.operand + " ", verb.description);
    out << visible_options(verb) << "\nExamples:\n";
    for (const std::string& example : verb.examples) out << "  " << example << '\n';
}

}  // namespace grafverif::app
