// SPDX-License-Identifier: MIT
// Properties about states one by one: bench_states FILE [SECONDS]. The closed loop of FILE with its plant automata,
// interleaved, in grain atomic; each property by the PDR engine and, where it is on the PATH, by ABC in its place.
#include <fmt/core.h>

#include <chrono>
#include <cstdlib>
#include <iostream>

#include "app/engines.hpp"
#include "app/system/process.hpp"
#include "check/pdr/check.hpp"
#include "grafverif/grafverif.hpp"

namespace {

using namespace grafverif;

/// What is found within the time, and how long it took.
std::string decided(const TransitionSystem& system, PdrOptions options, double limit) {
    using Clock = std::chrono::steady_clock;
    const auto start = Clock::now();
    options.deadline = start + std::chrono::duration_cast<Clock::duration>(std::chrono::duration<double>(limit));
    const PdrResult result = check_pdr(system, options);
    const double seconds = std::chrono::duration<double>(Clock::now() - start).count();
    return fmt::format("{:<9}{:8.2f} s", word(result.verdicts.at(0).outcome), seconds);
}

}  // namespace

int main(int count, char** arguments) {
    if (count < 2) return 2;
    const double limit = count > 2 ? std::atof(arguments[2]) : 60;
    Reading reading = read_file(arguments[1]);
    ModelOptions how;
    how.grain = Grain::Atomic;
    how.untimed.plant = PlantApproach::Automata;
    const auto system = reading.model
                            ? transition_system_of(*reading.model, Id<ClosedLoop>{0}, how, reading.diagnostics)
                            : std::optional<TransitionSystem>();
    std::cerr << reading.complaints();
    if (!system) return 2;
    const auto abc = app::find_program("berkeley-abc");
    for (const Property& property : system->properties) {
        PdrOptions options;
        options.properties = {property.name};
        std::string row = fmt::format("{:<24}pdr {}", property.name, decided(*system, options, limit));
        if (abc) {
            options.reach = app::search_by_abc(abc->string(), nullptr);
            row += "   abc " + decided(*system, options, limit);
        }
        std::cout << row << std::endl;
    }
}
