// SPDX-License-Identifier: MIT
// bench_states FILE [SECONDS [PROPERTY...]] checks state properties one by one. The checked model
// is the closed loop of FILE with interleaved plant automata and grain atomic. Every engine checks
// each property: the embedded engines separately and as a portfolio, and ABC if it is on the PATH.
// The output is a table of processor seconds of all threads and programs. After SECONDS (default:
// 60) of real time, a check is stopped; `>` then precedes its processor time.
#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <iostream>
#include <set>

#include "app/engines.hpp"
#include "app/system/process.hpp"
#include "check/portfolio.hpp"
#include "grafverif/grafverif.hpp"
#include "ir/patterns.hpp"
#include "pipeline/check.hpp"
#include "pipeline/models.hpp"

namespace {

using namespace grafverif;

/// Returns the processor seconds of this process and its finished child processes.
double processor_seconds() {
    double seconds = 0;
    for (const int who : {RUSAGE_SELF, RUSAGE_CHILDREN}) {
        rusage used = {};
        getrusage(who, &used);
        for (const timeval& each : {used.ru_utime, used.ru_stime})
            seconds += static_cast<double>(each.tv_sec) + static_cast<double>(each.tv_usec) / 1e6;
    }
    return seconds;
}

/// Returns a table entry: the processor time of an engine for one property.
template <class Options, class Check>
std::string column(Options options, const std::string& property, double limit, const Check& check) {
    using Clock = std::chrono::steady_clock;
    options.properties = {property};
    options.deadline = Clock::now() + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limit));
    const double before = processor_seconds();
    const Verdict verdict = check(options);
    const std::string seconds = fmt::format("{:.2f}", processor_seconds() - before);
    return fmt::format(" {} |", verdict.outcome == Outcome::Unknown ? ">" + seconds : seconds);
}

std::string row(const SystemToCheck& check, const std::string& property, double limit,
                const std::optional<std::filesystem::path>& abc) {
    const TransitionSystem& system = check.system;
    const auto by_circuit = [&](const PdrOptions& options) { return check_pdr(system, options).verdicts.at(0); };
    PdrOptions bmc, theirs;
    bmc.method = PdrOptions::Method::Bmc;
    std::string words = fmt::format("| `{}` |", property) + column(PdrOptions(), property, limit, by_circuit);
    if (abc) theirs.reach = app::search_by_abc(abc->string(), nullptr);
    words += abc ? column(theirs, property, limit, by_circuit) : std::string(" |");
    words += column(bmc, property, limit, by_circuit);
    words += column(SymbolicOptions(), property, limit,
                    [&](const SymbolicOptions& options) { return check_symbolic(system, options).verdicts.at(0); });
    return words + column(PortfolioOptions(), property, limit, [&](const PortfolioOptions& requested) {
               CheckOptions options{.properties = requested.properties};
               options.limits.deadline = requested.deadline;
               return check_together(check, options).answers.at(0).verdict;
           });
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 2) return 2;
    const double limit = count > 2 ? std::atof(arguments[2]) : 60;
    ParseResult reading = read_file(arguments[1]);
    ModelOptions how;
    how.grain = Grain::Atomic;
    how.untimed.plant = PlantApproach::Automata;
    const auto system = reading.model
                            ? transition_system_of(*reading.model, Id<ClosedLoop>{0}, how, reading.diagnostics)
                            : std::optional<TransitionSystem>();
    std::cerr << reading.diagnostics_text();
    if (!system) return 2;
    const SystemToCheck check = system_to_check(*system, *reading.model, Id<ClosedLoop>{0}, how);
    const auto abc = app::find_program("berkeley-abc");
    const std::set<std::string> requested(arguments + std::min(count, 3), arguments + count);
    for (const Property& property : system->properties)
        if (is_about_single_states(property.pattern) && (requested.empty() || requested.contains(property.name)))
            std::cout << row(check, property.name, limit, abc) << std::endl;
}
