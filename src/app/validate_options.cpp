// SPDX-License-Identifier: MIT
#include "app/validate_options.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <charconv>
#include <limits>
#include <string_view>
#include <system_error>
#include <utility>

#include "app/outputs.hpp"
#include "pipeline/files.hpp"

namespace grafverif::app {

namespace {

std::string validate_input(const CliCommand& verb, const Options& options) {
    std::vector<std::string> readers;
    if (accepts(verb, OptionGroup::Clock) && !accepts(verb, OptionGroup::Bench)) readers.push_back("the scans");
    if (accepts(verb, OptionGroup::Recording) && !accepts(verb, OptionGroup::Log)) readers.push_back("the samples");
    if (accepts(verb, OptionGroup::Walk) && !options.script && !options.random_seed)
        readers.push_back("the commands (without `--script`)");
    if (accepts(verb, OptionGroup::File))
        for (const std::string& file : options.operands)
            if (names_input(file)) readers.push_back("`FILE`");
    for (const auto& [name, path, use] : named_paths(options))
        if (use == PathUse::Read && names_input(path)) readers.push_back(fmt::format("`--{}`", name));
    if (readers.size() < 2) return {};
    return fmt::format("{} and {} cannot both be read from standard input; pass a file name for one of them",
                       readers[0], readers[1]);
}

std::string validate_streams(const CliCommand& verb, const Options& options) {
    const bool is_file = accepts(verb, OptionGroup::File) && !options.operands.empty();
    if (options.in_place && is_file && std::ranges::any_of(options.operands, names_input))
        return "`--in-place` cannot rewrite standard input; remove it or pass a file name";
    std::vector<std::string> documents;
    for (const auto& [name, path, use] : named_paths(options)) {
        const bool is_stream = names_input(path) || own_descriptor(path);
        if (use == PathUse::Updated && is_stream)
            return fmt::format("`--{}` cannot be a standard stream, because it is read and rewritten; pass a file name",
                               name);
        if (use == PathUse::WrittenFolder && is_stream)
            return fmt::format("`--{}` writes a folder, which `{}` is not; pass a folder name", name, path);
        if (use == PathUse::Written && names_output(path)) documents.push_back(fmt::format("`--{}`", name));
    }
    const bool is_json = options.format == Format::Json || options.format == Format::JsonLines;
    const bool writes_document = accepts(verb, OptionGroup::Output) && !accepts(verb, OptionGroup::Analysis);
    if (!options.output && writes_document && reports_on_output(options))
        documents.push_back("the output of `" + verb.name + "`");
    else if (!options.output && is_json) documents.push_back("JSON");
    if (documents.size() > 1)
        return fmt::format("{} and {} cannot both be written to standard output; pass a file name for one of them",
                           documents[0], documents[1]);
    return validate_input(verb, options);
}

}  // namespace

std::string validate_outputs(const CliCommand& verb, const Options& options) {
    if (accepts(verb, OptionGroup::OutputDirectory) && options.output == "-")
        return fmt::format(
            "`{}` writes a folder, which `-` is not; pass a folder name, or use a command that writes one "
            "document",
            verb.name);
    const bool several = (options.operands.size() > 1 && verb.most_operands == any_number) || options.all;
    if (options.name && several)
        return "`--name` applies to a single loop; remove `--name`, or pass one FILE without `--all`";
    if (options.name && (options.name->empty() || options.name->find('/') != std::string::npos))
        return fmt::format("invalid value `{}` of `--name`; use a file name without a folder", *options.name);
    if (options.all && (options.loop || options.chart))
        return "`--all` cannot be combined with `--loop` or `--chart`; remove `--all` or the other options";
    if (options.all_modes && options.mode) return "`--all-modes` and `--mode` are mutually exclusive; remove one";
    if (options.depfile_target && !options.depfile) return "`--depfile-target` requires `--depfile`; add it";
    if (options.depfile_reader && !options.depfile) return "`--depfile-format` requires `--depfile`; add it";
    if (options.certificate && (options.property_file || options.list))
        return "`--certificate` applies only to checks of closed loops and charts; remove `--certificate`, or remove "
               "`--properties` and `--list`";
    const bool one_form = options.format == Format::Json || options.trace_vcd || options.trace_svg ||
                          options.certificate || options.page ||
                          (options.output && !accepts(verb, OptionGroup::OutputDirectory));
    if (several && one_form && !options.list && !accepts(verb, OptionGroup::OutputDirectory))
        return fmt::format(
            "{} the results of one file and one loop only; for several files or loops, use `--junit`, "
            "`--sarif`{}",
            options.format == Format::Json ? "JSON output contains" : "the output contains",
            accepts(verb, OptionGroup::Verdicts) ? " or `--json-lines`" : "");
    if (several && accepts(verb, OptionGroup::InPlace) && !options.in_place && !options.check)
        return "several FILEs require `--check` or `--in-place`; add one of them";
    if (options.list && (options.junit || options.sarif || options.trace_vcd || options.trace_svg || options.page))
        return "`--list` runs no check and has no results; remove the report options";
    bool to_file = accepts(verb, OptionGroup::OutputDirectory);
    for (const auto& [name, path, use] : named_paths(options))
        to_file = to_file || (use == PathUse::Written && name != "depfile" && path != "-");
    if (options.depfile && !options.depfile_target && !to_file)
        return "`--depfile` requires the name of an output; pass `-o FILE`, or the target name of the build system "
               "with `--depfile-target NAME`";
    return validate_streams(verb, options);
}

namespace {

std::string validate_structured_text(const Options& options, const std::function<bool(const char* name)>& given) {
    using structured_text::Dialect;
    if (given("resolution") && !options.st.prove) return "`--resolution` requires `--prove`; add it";
    if (options.st.prove && options.sequence) return "`--prove` and `--sequence` are mutually exclusive; remove one";
    if (options.st.dialect == Dialect::Iec || options.st.dialect == Dialect::Codesys) return {};
    if (given("format")) return "`--format` applies only to the dialects `iec` and `codesys`; remove it";
    if (options.st.prove)
        return "`--prove` can read only the dialects `iec` and `codesys`; remove it or select one of these dialects";
    return {};
}

}  // namespace

std::string validate_combinations(const CliCommand& verb, const Options& options,
                                  const std::function<bool(const char* name)>& given) {
    constexpr std::array needs = {std::pair("from", "trace-svg"), std::pair("to", "trace-svg"),
                                  std::pair("seed", "limit"), std::pair("steps", "random")};
    for (const auto& [one, other] : needs)
        if (given(one) && !given(other)) return fmt::format("`--{}` requires `--{}`; add it", one, other);
    if (accepts(verb, OptionGroup::Walk) && given("junit") && !given("script"))
        return "`--junit` requires `--script`; add it";
    if (accepts(verb, OptionGroup::StructuredText))
        if (std::string error_text = validate_structured_text(options, given); !error_text.empty()) return error_text;
    constexpr std::array excludes = {std::pair("dialect", "sequence"), std::pair("chart", "loop"),
                                     std::pair("chart", "grain"),      std::pair("script", "random"),
                                     std::pair("sequence", "cover"),   std::pair("sequence", "hold")};
    const bool of_loops = accepts(verb, OptionGroup::Loop) || accepts(verb, OptionGroup::Bench);
    for (const auto& [one, other] : excludes)
        if (given(one) && given(other) && (of_loops || one != std::string_view("chart")))
            return fmt::format("`--{}` and `--{}` are mutually exclusive; remove one", one, other);
    if (of_loops && given("chart") && given("set"))
        return "`--set` sets a constant of a closed loop, but `--chart` selects a chart without its closed loop; "
               "remove "
               "`--set` or `--chart`";
    const bool bounded = options.engine == Engine::Bmc || options.engine == Engine::Auto;
    if (options.max_steps && !bounded)
        return "`--max-steps` applies only to `--engine bmc` and `--engine auto`; remove it or select one of these "
               "engines";
    if (options.events.from > options.events.to) return "`--from` is greater than `--to`; exchange the values";
    if (options.keep_going && options.stop_on_failure)
        return "`--stop-on-failure` and `--keep-going` are mutually exclusive; remove one";
    if (options.limit == 0) return "invalid value of `--limit`; use a number of at least 1";
    return {};
}

std::string validate_limits(Options& options) {
    const std::uint64_t evolutions = options.st.max_evolutions.value_or(1);
    if (evolutions == 0 || evolutions > std::numeric_limits<std::uint32_t>::max())
        return "invalid value of `--max-evolutions`; use a number from 1 to 4294967295";
    return {};
}

/// Selects plant automata if an option requires them and `--plant` is missing.
std::string validate_untimed(Options& options) {
    ScheduleOptions& untimed = options.untimed;
    const bool discrete = untimed.time == TimeModel::Discrete;
    const char* requested = untimed.schedule   ? "schedule"
                            : discrete         ? "time discrete"
                            : untimed.fairness ? "fairness"
                                               : nullptr;
    untimed.plant = options.plant.value_or(requested != nullptr ? PlantApproach::Automata : PlantApproach::None);
    if (requested != nullptr && untimed.plant != PlantApproach::Automata)
        return fmt::format("`--{}` requires `--plant automata`; add it", requested);
    if (discrete && untimed.schedule.value_or(Schedule::Interleaved) != Schedule::Interleaved)
        return "`--time discrete` requires `--schedule interleaved`; remove the other schedule";
    if (discrete) untimed.schedule = Schedule::Interleaved;
    return {};
}

std::string disable_corrections(const std::vector<std::string>& cures, Options& options) {
    for (const std::string& cure : cures) {
        if (cure == "urgency") options.without.sensors_not_urgent = true;
        else if (cure == "flags") options.without.cycle_always = true;
        else if (cure == "stable") options.without.cycle_unless_stable = true;
        else if (cure == "restart") options.without.timers_as_published = true;
        else
            return fmt::format("invalid value `{}` of `--ablate`; use one of `urgency`, `flags`, `stable`, `restart`",
                               cure);
        options.disabled_corrections.push_back(cure);
    }
    return {};
}

std::string take_constants(const std::vector<std::string>& given, Options& options) {
    for (const std::string& one : given) {
        const std::size_t sign = one.find('=');
        if (sign == 0 || sign == std::string::npos || sign + 1 == one.size())
            return fmt::format("invalid value `{}` of `--set`; pass a constant and its value, as in `--set N=4`", one);
        if (!options.constants.emplace(one.substr(0, sign), one.substr(sign + 1)).second)
            return fmt::format("`--set` sets `{}` twice; remove one of these options", one.substr(0, sign));
    }
    return {};
}

std::string take_jobs(const std::vector<std::string>& given, Options& options) {
    const char* const stop = given.front().data() + given.front().size();
    const auto [end, failure] = std::from_chars(given.front().data(), stop, options.jobs);
    if (failure == std::errc{} && end == stop && options.jobs - 1 < 1000) return {};
    return fmt::format("invalid value `{}` of `--jobs`; use a whole number from 1 to 1000", given.front());
}

}  // namespace grafverif::app
