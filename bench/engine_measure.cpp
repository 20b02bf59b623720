// SPDX-License-Identifier: MIT
// bench_engine WHAT [atomic]: checks one model with the timed engine and prints what it took: states, transitions per
// second, bytes per state, verdicts. WHAT: `station`, `two` (two stations in one network), `cylinders N`, or a sample's path.
#include <sys/resource.h>

#include <cstdlib>
#include <cstring>
#include <string>

#include <fmt/core.h>

#include "engine_loops.hpp"
#include "grafverif/check/timed.hpp"

namespace {

using namespace grafverif;

void print(const TimedResult& result) {
    const double states = static_cast<double>(result.states);
    fmt::print("{} states, {} transitions ({:.2f} per state), {:.2f} s, {:.2f} million transitions/s, {:.1f} bytes/state{}\n", result.states,
               result.transitions, static_cast<double>(result.transitions) / states, result.seconds,
               static_cast<double>(result.transitions) / result.seconds / 1e6, static_cast<double>(result.bytes) / states,
               result.complete ? "" : ", incomplete");
    for (const Verdict& verdict : result.verdicts)
        fmt::print("  {}: {}{}{}{}\n", verdict.property, word(verdict.outcome), verdict.vacuous ? ", vacuous" : "",
                   verdict.reason.empty() ? "" : ": ", verdict.reason);
    for (const ModelError& error : result.errors) fmt::print("  model error: {}\n", word(error.kind));
    rusage usage{};
    getrusage(RUSAGE_SELF, &usage);
    const double cpu = static_cast<double>(usage.ru_utime.tv_sec + usage.ru_stime.tv_sec) + static_cast<double>(usage.ru_utime.tv_usec + usage.ru_stime.tv_usec) / 1e6;
    fmt::print("  peak {} MiB, {:.2f} s of the processor\n", usage.ru_maxrss / 1024, cpu);
}

Network chosen(const std::string& what, int count, char** values) {
    const bool atomic = std::strcmp(values[count - 1], "atomic") == 0;
    const Grain grain = atomic ? Grain::Atomic : Grain::Phased;
    if (what == "station") return bench::loop(bench::sample("testing_station/testing_station.grafcet"), grain);
    if (what == "two") return bench::two_stations(grain);
    if (what == "cylinders") return bench::loop(bench::cylinders(count > 2 ? std::atoi(values[2]) : 3), grain);
    return bench::loop(bench::sample(what), grain);
}

}  // namespace

int main(int count, char** values) {
    if (count < 2) {
        fmt::print(stderr, "usage: bench_engine station|two|cylinders N|PATH [atomic]\n");
        return 2;
    }
    const auto progress = [](const TimedProgress& now) {
        fmt::print(stderr, "\r{} states, {} waiting, {} MiB, {:.1f} s ", now.states, now.queue, now.bytes >> 20U, now.seconds);
    };
    print(check_timed(chosen(values[1], count, values), {.progress = std::getenv("ENGINE_PROGRESS") ? progress : std::function<void(const TimedProgress&)>{}}));
}
