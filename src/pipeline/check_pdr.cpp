// SPDX-License-Identifier: MIT
// Checks systems with the embedded engines on circuits, or with external programs that replace these engines.
#include <fmt/format.h>

#include <algorithm>
#include <utility>

#include "check/pdr/check.hpp"
#include "check/portfolio.hpp"
#include "pipeline/check.hpp"
#include "pipeline/models.hpp"

namespace grafverif {

StateSearch bounded_search(std::optional<std::uint64_t> max_steps) {
    return {"bmc", {}, PdrOptions::Method::Bmc, max_steps.value_or(100)};
}

namespace {

std::string words_of(const PdrProgress& now) {
    const std::string far = now.property.empty() ? fmt::format("{} steps", now.frames)
                                                 : fmt::format("{}: {} frames", now.property, now.frames);
    return fmt::format("{}, {} MiB, {:.0f} s", far, now.bytes >> 20U, now.seconds);
}

}  // namespace

std::string words_of(const SymbolicProgress& now) {
    return fmt::format("{} steps deep, {} MiB, {:.0f} s", now.depth, now.bytes >> 20U, now.seconds);
}

namespace {

/// Converts the result of PDR or BMC to a report. If `result` is empty, the report contains no verdicts.
Report reported(PdrResult result, const SystemToCheck& check, SystemReporter::Of of, const std::string& engine,
                const CheckOptions& options) {
    SystemReporter reporter(check, of, engine, options, result.verdicts);
    const std::vector<std::string> failures = std::move(result.failures);
    reporter.add_all(std::move(result));
    Report report = std::move(reporter).report();
    report.failures.insert(report.failures.end(), failures.begin(), failures.end());
    return report;
}

}  // namespace

Report check_states(const SystemToCheck& check, const CheckOptions& options, const StateSearch& search) {
    PdrOptions pdr;
    pdr.method = search.method;
    pdr.max_steps = search.max_steps;
    pdr.reach = search.reach;
    pdr.proved = search.proved;
    pdr.shown = search.shown;
    pdr.properties = requested_names(check.system, options.properties);
    set_limits(pdr, options.limits);
    if (options.limits.progress)
        pdr.progress = [&options](const PdrProgress& now) {
            options.limits.progress({[&now] { return words_of(now); }});
        };
    const bool has_queries =
        options.properties.empty() || !pdr.properties.empty();  // an empty list selects all properties
    const auto of = search.reach ? SystemReporter::Of::Program : SystemReporter::Of::EmbeddedEngine;
    return reported(has_queries ? check_pdr(check.system, pdr) : PdrResult(), check, of, search.name, options);
}

Report check_together(const SystemToCheck& check, const CheckOptions& options, std::uint64_t alone) {
    PortfolioOptions all;
    all.witnesses = options.witnesses;
    all.whole = options.whole;
    set_limits(all, options.limits);
    if (options.limits.progress)
        all.progress = [&options](const PortfolioProgress& now) {
            options.limits.progress({[&now] {
                if (now.pdr.seconds == 0) return words_of(now.symbolic);
                return fmt::format("symbolic: {} steps deep; {}", now.symbolic.depth, words_of(now.pdr));
            }});
        };
    all.jobs = options.jobs;
    all.alone = alone;
    all.properties = requested_names(check.system, options.properties);
    all.first = [&](const std::atomic<bool>* stop) {
        CheckOptions own = options;
        own.jobs = 1;
        own.limits.memory = options.limits.memory.value_or(all.max_memory) / 4;
        own.limits.stop = stop;
        own.limits.progress = {};
        return decided_by_abstractions(check, own);
    };
    const bool has_queries =
        options.properties.empty() || !all.properties.empty();  // an empty list selects all properties
    PortfolioResult result = has_queries ? check_together(check.system, all) : PortfolioResult{{}, true};
    const std::string engine = result.alone ? "symbolic" : "auto";
    return reported(std::move(result), check, SystemReporter::Of::EmbeddedEngine, engine, options);
}

}  // namespace grafverif
