// SPDX-License-Identifier: MIT
// The embedded engines on circuits at work, and programs in their place.
#include <fmt/format.h>

#include <algorithm>
#include <iterator>
#include <utility>

#include "check/pdr/check.hpp"
#include "pipeline/check.hpp"
#include "pipeline/models.hpp"

namespace grafverif {

StateSearch bounded_search(std::optional<std::uint64_t> max_steps) {
    return {"bmc", {}, PdrOptions::Method::Bmc, max_steps.value_or(100)};
}

Report check_states(const SystemToCheck& check, const CheckOptions& options, const StateSearch& search) {
    PdrOptions pdr;
    pdr.method = search.method;
    pdr.max_steps = search.max_steps;
    pdr.reach = search.reach;
    for (const std::size_t index : asked_properties(check.system, options.properties))
        pdr.properties.push_back(check.system.properties[{static_cast<std::uint32_t>(index)}].name);
    set_limits(pdr, options.limits);
    if (options.limits.progress)
        pdr.progress = [&options](const PdrProgress& now) {
            options.limits.progress({[&now] {
                const std::string far = now.property.empty() ? fmt::format("{} steps", now.frames)
                                                             : fmt::format("{}: {} frames", now.property, now.frames);
                return fmt::format("{}, {} MiB, {:.0f} s", far, now.bytes >> 20U, now.seconds);
            }});
        };
    PdrResult result;
    if (options.properties.empty() || !pdr.properties.empty())  // no names would ask for all
        result = check_pdr(check.system, pdr);
    const auto of = search.reach ? SystemReporter::Of::Program : SystemReporter::Of::EmbeddedEngine;
    SystemReporter reporter(check, of, search.name, options, result.verdicts);
    if (result.fault) reporter.add(*result.fault);
    for (std::size_t i = 0; i < result.verdicts.size(); ++i)
        reporter.add(std::move(result.verdicts[i]), std::move(result.runs[i]));
    reporter.add_omitted();
    Report report = std::move(reporter).report();
    std::ranges::move(result.failures, std::back_inserter(report.failures));
    return report;
}

}  // namespace grafverif
