// SPDX-License-Identifier: MIT
#include "app/settle.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <charconv>
#include <limits>
#include <system_error>

namespace grafverif::app {

std::string settle_outputs(const Verb& verb, const Options& options) {
    if (accepts(verb, Accepts::OutputDirectory) && options.output == "-")
        return fmt::format("`{}` writes a folder, which `-` is not; other verbs write one document to standard output",
                           verb.name);
    const bool several = (options.operands.size() > 1 && verb.most_operands == any_number) || options.all;
    if (options.name && several)
        return "`--name` names the files of one loop; of several FILEs, and with `--all`, each loop names its own";
    if (options.name && (options.name->empty() || options.name->find('/') != std::string::npos))
        return fmt::format("`--name` takes the name of a file without its folder; not `{}`", *options.name);
    if (options.all && (options.loop || options.chart)) return "`--all` and `--loop` or `--chart` exclude each other";
    if (options.each_mode && options.mode) return "`--each-mode` and `--mode` exclude each other";
    if (options.depfile_target && !options.depfile) return "`--depfile-target` needs `--depfile`";
    if (options.depfile_reader && !options.depfile) return "`--depfile-form` needs `--depfile`";
    const bool one_form = options.format == Format::Json || options.trace_vcd || options.trace_svg ||
                          (options.output && !accepts(verb, Accepts::OutputDirectory));
    if (several && one_form && !options.list && !accepts(verb, Accepts::OutputDirectory))
        return fmt::format("{} one file, or one loop; of several take `--junit`, `--sarif`{}",
                           options.format == Format::Json ? "JSON is of" : "the output is of",
                           accepts(verb, Accepts::Verdicts) ? " or `--json-lines`" : "");
    if (several && accepts(verb, Accepts::InPlace) && !options.in_place && !options.check)
        return "of several FILEs take `--check` or `--in-place`";
    if (options.list && (options.junit || options.sarif || options.trace_vcd || options.trace_svg))
        return "`--list` decides nothing, and has nothing to report";
    bool to_file = accepts(verb, Accepts::OutputDirectory);
    for (const auto* path : {&options.output, &options.junit, &options.sarif, &options.trace_vcd, &options.trace_svg})
        to_file = to_file || (*path && **path != "-");
    if (options.depfile && !options.depfile_target && !to_file)
        return "`--depfile` says what a file was made from: name one (`-o FILE`), or what the build system calls the "
               "result of this run (`--depfile-target NAME`)";
    return {};
}

std::string settle_limits(Options& options) {
    if (options.max_evolutions == 0 || options.max_evolutions > std::numeric_limits<std::uint32_t>::max())
        return "`--max-evolutions` takes a number from 1 to 4294967295";
    constexpr std::uint64_t hundred_years =
        std::uint64_t{100} * 365 * 24 * 3'600'000;  // clocks count nanoseconds in 63 bits
    static_assert(2 * hundred_years < std::numeric_limits<std::int64_t>::max() / 1'000'000);
    for (std::optional<std::uint64_t>* time : {&options.timeout_ms, &options.patience_ms})
        if (*time) *time = std::min(**time, hundred_years);
    return {};
}

/// Options that only plant automata have ask for them.
std::string settle_untimed(Options& options) {
    ScheduleOptions& untimed = options.untimed;
    const bool discrete = untimed.time == TimeModel::Discrete;
    const char* asked = untimed.schedule   ? "schedule"
                        : discrete         ? "time discrete"
                        : untimed.fairness ? "fairness"
                                           : nullptr;
    untimed.plant = options.plant.value_or(asked != nullptr ? PlantApproach::Automata : PlantApproach::None);
    if (asked != nullptr && untimed.plant != PlantApproach::Automata)
        return fmt::format("`--{}` needs `--plant automata`", asked);
    if (discrete && untimed.schedule.value_or(Schedule::Interleaved) != Schedule::Interleaved)
        return "`--time discrete` needs `--schedule interleaved`";
    if (discrete) untimed.schedule = Schedule::Interleaved;
    return {};
}

std::string leave_out_cures(const std::vector<std::string>& cures, Options& options) {
    for (const std::string& cure : cures) {
        if (cure == "urgency") options.without.sensors_not_urgent = true;
        else if (cure == "flags") options.without.cycle_always = true;
        else if (cure == "stable") options.without.cycle_unless_stable = true;
        else if (cure == "restart") options.without.timers_as_published = true;
        else return fmt::format("`--without` takes one of `urgency`, `flags`, `stable`, `restart`; not `{}`", cure);
        options.cures_left_out.push_back(cure);
    }
    return {};
}

std::string take_constants(const std::vector<std::string>& given, Options& options) {
    for (const std::string& one : given) {
        const std::size_t sign = one.find('=');
        if (sign == 0 || sign == std::string::npos || sign + 1 == one.size())
            return fmt::format("`--set` takes a constant and its value, as in `--set N=4`; not `{}`", one);
        if (!options.constants.emplace(one.substr(0, sign), one.substr(sign + 1)).second)
            return fmt::format("`--set` gives `{}` two values", one.substr(0, sign));
    }
    return {};
}

std::string take_jobs(const std::vector<std::string>& given, Options& options) {
    const char* const stop = given.front().data() + given.front().size();
    const auto [end, failure] = std::from_chars(given.front().data(), stop, options.jobs);
    if (failure == std::errc{} && end == stop && options.jobs - 1 < 1000) return {};
    return fmt::format("`--jobs` takes a whole number from 1 to 1000; not `{}`", given.front());
}

}  // namespace grafverif::app
