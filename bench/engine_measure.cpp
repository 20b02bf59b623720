// SPDX-License-Identifier: MIT
// bench_engine WHAT [safety] [jobs=N] [atomic|text] checks one model with the timed engine. The
// output contains the number of states, the transitions per second, the bytes per state and the
// verdicts. safety: check only state properties. jobs: number of threads. text: print the generated
// model instead. WHAT is the path of a sample or one of:
//   `station`, `cylinders N`
//   `two`: two stations in one network, explored together
//   `stations N`: N stations in one loop, checked compositionally
//   `line N`: a transfer line of N cells, whose safety properties are checked by localization
#include <fmt/core.h>
#include <sys/resource.h>

#include <algorithm>
#include <cstdlib>
#include <cstring>
#include <string>
#include <vector>

#include "check/localization/localization.hpp"
#include "check/timed/timed.hpp"
#include "engine_loops.hpp"

namespace {

using namespace grafverif;

/// Returns the processor seconds of this process, without those of other processes.
double processor_seconds() {
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    return static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) +
           static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec) / 1e6;
}

bool said(const char* word, int count, char** values) {
    return std::any_of(values + 2, values + count, [&](const char* value) { return std::strcmp(value, word) == 0; });
}

std::vector<std::string> about_states(const Network& network) {
    std::vector<std::string> names;
    for (const Property& property : network.properties)
        if (property.pattern <= Pattern::Reachable || property.pattern == Pattern::ExactlyOneOf)
            names.push_back(property.name);
    return names;
}

void print(const TimedResult& result, double seconds) {
    const auto states = static_cast<double>(result.states), transitions = static_cast<double>(result.transitions);
    fmt::print("{} states, {} transitions ({:.2f} per state), {:.2f} s of the processor, {:.2f} s by the clock{}\n",
               result.states, result.transitions, transitions / states, seconds, result.seconds,
               result.complete ? "" : ", incomplete");
    fmt::print("{:.2f} million transitions/s, {:.2f} million states/s, {:.1f} bytes/state, {} of them packed\n",
               transitions / seconds / 1e6, states / seconds / 1e6, static_cast<double>(result.bytes) / states,
               result.state_bytes);
    for (const Verdict& verdict : result.verdicts)
        fmt::print("  {}: {}{}{}{}\n", verdict.property, word(verdict.outcome), verdict.vacuous ? ", vacuous" : "",
                   verdict.reason.empty() ? "" : ": ", verdict.reason);
    for (const ModelError& error : result.errors) fmt::print("  model error: {}\n", word(error.kind));
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    fmt::print("  peak {} MiB, {:.2f} s of the processor in all\n", usage.ru_maxrss / 1024, processor_seconds());
}

/// Returns the text of a generated model, or an empty string if `what` is not a generated model.
std::string made(const std::string& what, int count, char** values) {
    const int size = count > 2 ? std::atoi(values[2]) : 3;
    if (what == "cylinders") return bench::cylinders(size);
    if (what == "stations") return bench::stations(size);
    return what == "line" ? bench::transfer_line(size) : "";
}

Network chosen(const std::string& what, int count, char** values) {
    const bool atomic = said("atomic", count, values);
    const Grain grain = atomic ? Grain::Atomic : Grain::Phased;
    if (what == "station") return bench::loop(bench::sample("testing_station/testing_station.grafcet"), grain);
    if (what == "two") return bench::two_stations(grain);
    if (const std::string text = made(what, count, values); !text.empty()) return bench::loop(text, grain);
    return bench::loop(bench::sample(what), grain);
}

}  // namespace

int main(int count, char** values) {
    if (count < 2) {
        fmt::print(
            stderr,
            "usage: bench_engine station|two|cylinders N|stations N|line N|PATH [safety] [jobs=N] [atomic|text]\n");
        return 2;
    }
    if (std::strcmp(values[count - 1], "text") == 0) {
        fmt::print("{}", made(values[1], count, values));
        return 0;
    }
    const auto progress = [](const TimedProgress& now) {
        fmt::print(stderr, "\r{} states, {} waiting, {} MiB, {:.1f} s ", now.states, now.queue, now.bytes >> 20U,
                   now.seconds);
    };
    TimedOptions options;
    if (std::getenv("ENGINE_PROGRESS") != nullptr) options.progress = progress;
    for (int i = 2; i < count; ++i)
        if (std::strncmp(values[i], "jobs=", 5) == 0) options.jobs = static_cast<unsigned>(std::atoi(values[i] + 5));
    const Network network = chosen(values[1], count, values);
    if (said("safety", count, values)) options.properties = about_states(network);
    const double before = processor_seconds();
    const std::string what = values[1];
    // The check of `no timelock` needs the complete network of a line, which exceeds the memory.
    if (what == "line")
        for (const Property& property : network.properties)
            if (property.pattern == Pattern::Never) options.properties.push_back(property.name);
    const bool by_parts = what == "stations" || what == "line";
    const TimedResult result = by_parts ? check_timed_by_cells(network, options) : check_timed(network, options);
    print(result, processor_seconds() - before);
}
