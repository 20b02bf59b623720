// SPDX-License-Identifier: MIT
// Parses the command line of a command, as defined by its rows of the option table, and validates
// combinations of options.
#include "app/options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <boost/program_options.hpp>
#include <ostream>

#include "app/option_table.hpp"
#include "app/validate_options.hpp"
#include "syntax/resolve/nearest_of.hpp"

namespace grafverif::app {

namespace {
namespace po = boost::program_options;

po::options_description described(const std::vector<Option>& options, bool hidden) {
    po::options_description result("Options", 100);
    for (const Option& option : options) {
        if (option.help.empty() && !hidden) continue;
        auto add = result.add_options();
        for (const std::string& name : {option.name, hidden ? option.former : std::string()}) {
            if (name.empty()) continue;
            if (option.repeated)
                add(name.c_str(), po::value<std::vector<std::string>>()->value_name(option.value), option.help.c_str());
            else if (option.value.empty()) add(name.c_str(), po::bool_switch(), option.help.c_str());
            else add(name.c_str(), po::value<std::string>()->value_name(option.value), option.help.c_str());
        }
    }
    return result;
}

/// Stores the given options in `options`. Returns an error message or an empty string.
std::string take_all(const std::vector<Option>& known, const po::variables_map& values, Options& options) {
    for (const Option& option : known) {
        const po::variable_value& value = values[option.long_name()];
        if (value.empty() || (!option.repeated && option.value.empty() && !value.as<bool>())) continue;
        std::vector<std::string> given;
        if (option.repeated) given = value.as<std::vector<std::string>>();
        else if (!option.value.empty()) given = {value.as<std::string>()};
        if (std::string error_text = option.take(given, options); !error_text.empty()) return error_text;
    }
    return {};
}

// -- combinations of options ------------------------------------------------------------------------------------------

/// Validates the engine. `modelled` is true if an option of untimed models was given.
std::string validate_engine(bool modelled, const po::variables_map& values, Options& options) {
    if (!options.engine_command.empty()) {
        if (options.engine != Engine::Embedded)
            return "`--engine` and `--engine-command` are mutually exclusive; remove one";
        options.engine = Engine::Hwmcc;
    }
    options.check_untimed = options.check_untimed || modelled || options.untimed.fairness;
    if (options.property_file && (options.check_untimed || options.engine != Engine::Embedded || options.loop ||
                                  options.chart || options.all || options.list || options.stats || options.sequence))
        return "`--properties` checks a PLC program with the embedded engines; remove the options that select an "
               "engine, "
               "a model, a loop or a chart, and `--list`, `--stats` and `--sequence`";
    const bool timed = options.engine == Engine::Timed || options.engine == Engine::Verifyta;
    if (timed && options.check_untimed)
        return fmt::format(
            "`--engine {}` checks only timed models; remove `--untimed` and the options of untimed "
            "models",
            values["engine"].as<std::string>());
    if (timed && options.chart)
        return fmt::format(
            "`--engine {}` checks only closed loops; remove `--engine` to check the chart (`--chart`) untimed",
            values["engine"].as<std::string>());
    // True if the engine can check timed and untimed models.
    const bool open = options.engine == Engine::Embedded || options.engine == Engine::Auto;
    if (options.stats && (options.check_untimed || !(open || options.engine == Engine::Timed)))
        return "`--stats` is supported only by the embedded timed engine; remove `--stats`, or the options that select "
               "another engine or the untimed model";
    if (options.why && (options.check_untimed || !(open || options.engine == Engine::Timed)))
        return "`--why` is supported only by the embedded timed engine for closed loops; remove `--why`, or the "
               "options that select another engine or the untimed model";
    if (options.why && (options.format == Format::JsonLines || !options.disabled_corrections.empty()))
        return "`--why` is supported only for text output and `--format json`, without `--ablate`; remove one of these "
               "options";
    options.check_untimed = options.check_untimed || (!timed && !open);
    return {};
}

/// Returns an error message if an option that runs a command is given as `--OPTION=COMMAND`. A
/// shell pattern can expand to a file with the name `--OPTION=COMMAND`, and the name of a file must
/// not run a command.
std::string adjacent_command(const std::vector<po::option>& given, const std::vector<Option>& known) {
    for (const po::option& one : given)
        for (const Option& option : known)
            if (option.is_command && one.string_key == option.long_name() && one.original_tokens.size() == 1)
                return fmt::format(
                    "`--{0}={1}` is ambiguous, because a file may have this name; write `--{0} {1}`, and put `--` "
                    "before file names",
                    option.long_name(), option.value);
    return {};
}

/// Replaces former names of options by current names. Returns the replaced names.
std::vector<FormerName> replace_former_names(std::vector<po::option>& given, const std::vector<Option>& known) {
    std::vector<FormerName> replaced;
    for (po::option& one : given)
        for (const Option& option : known)
            if (!option.former.empty() && one.string_key == option.former) {
                replaced.push_back({option.former, option.long_name()});
                one.string_key = option.long_name();
            }
    return replaced;
}

std::string unknown_option(const std::string& given, const std::vector<Option>& known) {
    std::vector<std::string> names;
    for (const Option& option : known)
        if (!option.help.empty()) names.push_back("--" + option.long_name());
    return unknown_name_text("option", given, names);
}

}  // namespace

bool accepts(const CliCommand& verb, OptionGroup what) {
    if (what == OptionGroup::File) return verb.operand.starts_with("FILE");
    if (what == OptionGroup::Timeout) {
        const auto has_another = {OptionGroup::Bench, OptionGroup::Serve, OptionGroup::Lsp, OptionGroup::Mcp,
                                  OptionGroup::Command};
        return std::ranges::none_of(has_another, [&](OptionGroup other) { return accepts(verb, other); });
    }
    if (what == OptionGroup::Writes)
        return accepts(verb, OptionGroup::Output) || accepts(verb, OptionGroup::OutputDirectory) ||
               accepts(verb, OptionGroup::Search) || accepts(verb, OptionGroup::Bench) ||
               accepts(verb, OptionGroup::Traces) || accepts(verb, OptionGroup::Log);
    return what == OptionGroup::Always || std::ranges::find(verb.accepts, what) != verb.accepts.end();
}

ParsedOptions parse_options(const CliCommand& verb, std::span<const std::string> arguments) {
    const std::vector<Option> known = options_of(verb);
    const po::options_description all = described(known, true);
    po::positional_options_description positional;
    positional.add("operand", -1);

    const auto own =
        accepts(verb, OptionGroup::Command)
            ? std::ranges::find_if_not(arguments, [](const std::string& word) { return word.starts_with('-'); })
            : arguments.end();
    po::variables_map values;
    std::vector<FormerName> former_names;
    try {
        const auto style = po::command_line_style::unix_style & ~po::command_line_style::allow_guessing;
        po::parsed_options parsed = po::command_line_parser(std::vector<std::string>(arguments.begin(), own))
                                        .options(all)
                                        .positional(positional)
                                        .style(style)
                                        .run();
        if (std::string error_text = adjacent_command(parsed.options, known); !error_text.empty())
            return {{}, std::move(error_text)};
        former_names = replace_former_names(parsed.options, known);
        po::store(parsed, values);
        po::notify(values);
    } catch (const po::unknown_option& failure) {
        return {{}, unknown_option(failure.get_option_name(), known)};
    } catch (const po::error& failure) {
        return {{}, failure.what()};
    }

    Options options;
    if (accepts(verb, OptionGroup::FormatTest)) options.format = Format::Csv;
    if (accepts(verb, OptionGroup::FormatXml)) options.format = Format::Xml;
    const bool modelled = values.count("plant") != 0 || values.count("schedule") != 0 || values.count("time") != 0;
    std::string error_text = take_all(known, values, options);
    if (error_text.empty()) error_text = validate_untimed(options);
    if (error_text.empty()) error_text = validate_engine(modelled, values, options);
    if (error_text.empty()) error_text = validate_limits(options);
    if (error_text.empty())
        error_text = validate_combinations(verb, options, [&](const char* name) { return values.count(name) != 0; });
    if (!error_text.empty()) return {{}, error_text};
    if (options.help) return {options, {}, former_names};
    options.operands.insert(options.operands.end(), own, arguments.end());
    if (accepts(verb, OptionGroup::Bench) && options.against.empty()) return {{}, "`--against PROGRAM` is missing"};
    if (accepts(verb, OptionGroup::Log) && !options.log) return {{}, "`--log FILE` is missing"};
    if (options.format == Format::Sarif) {  // `--format sarif -o FILE` is equivalent to `--sarif FILE`
        options.sarif = options.output.value_or("-");
        options.output.reset();
    }
    if (error_text = validate_outputs(verb, options); !error_text.empty()) return {{}, error_text};
    if (options.operands.size() < verb.least_operands) return {{}, fmt::format("`{}` is missing", verb.operand)};
    if (options.operands.size() > verb.most_operands)
        return {{}, fmt::format("unexpected argument `{}`; remove it", options.operands[verb.most_operands])};
    const std::string words = "|" + verb.operand + "|";  // the operand is one of `bash|zsh|fish`
    if (verb.operand.find('|') != std::string::npos && words.find("|" + options.operands[0] + "|") == std::string::npos)
        return {{},
                fmt::format("invalid argument `{2}` of `{0}`; use one of `{1}`", verb.name, verb.operand,
                            options.operands[0])};
    return {options, {}, former_names};
}

std::vector<NamedPath> named_paths(const Options& options) {
    std::vector<NamedPath> paths;
    for (const PathOption& option : path_options)
        if (const auto& path = options.*option.place) paths.push_back({option.name, *path, option.use});
    return paths;
}

std::vector<OptionText> option_texts(const CliCommand& verb) {
    std::vector<OptionText> texts;
    for (const Option& option : options_of(verb))
        if (!option.help.empty()) texts.push_back({option.long_name(), option.letter(), option.value, option.help});
    return texts;
}

void print_help(const CliCommand& verb, std::ostream& out) {
    out << fmt::format("Usage: grafverif {} {}[options]\n\n{}\n\n", verb.name,
                       verb.operand.empty() ? "" : verb.operand + " ", verb.description);
    out << described(options_of(verb), false) << "\nExamples:\n";
    for (const std::string& example : verb.examples) out << "  " << example << '\n';
}

}  // namespace grafverif::app
