// SPDX-License-Identifier: MIT
// Simulator: owns a model and a simulation of this model.
#include <utility>

#include "pipeline/check.hpp"
#include "pipeline/models.hpp"
#include "run/replay.hpp"
#include "simulate/simulation.hpp"

namespace grafverif {

struct Simulator::Inside {
    Network network = {};  ///< the network, if a closed loop is simulated
    std::vector<Chart> kept = {};
    std::vector<const Chart*> charts = {};
    std::optional<Simulation> moved = {};
    std::string problem = {};
};

Simulator::Simulator(std::unique_ptr<Inside> inside) : inside_(std::move(inside)) {}
Simulator::Simulator(Simulator&&) noexcept = default;
Simulator& Simulator::operator=(Simulator&&) noexcept = default;
Simulator::~Simulator() = default;

std::string Simulator::execute(std::string_view command) {
    return inside_->problem = inside_->moved->execute(command_of(command));
}
const std::string& Simulator::problem() const { return inside_->problem; }
std::vector<Choice> Simulator::choices() const { return inside_->moved->choices(); }
const ChartRun& Simulator::run() const { return inside_->moved->recorded_run(); }
std::optional<std::size_t> Simulator::what_if_row() const { return inside_->moved->what_if_row(); }

std::string Simulator::disagreement() const {
    if (what_if_row()) return {};
    const auto found = grafverif::disagreement(run(), inside_->charts);
    return found ? replay_failure("this run", *found) : std::string();
}

namespace {

void keep(Simulator::Inside& inside, const std::vector<const Chart*>& charts) {
    inside.kept.reserve(charts.size());
    for (const Chart* const chart : charts) inside.charts.push_back(&inside.kept.emplace_back(*chart));
}

}  // namespace

std::optional<Simulator> simulator_of(const Model& model, Id<ClosedLoop> loop, const ModelOptions& options,
                                      Diagnostics& diagnostics) {
    std::optional<Network> network = network_of(model, loop, options, diagnostics);
    if (!network) return {};
    auto inside = std::make_unique<Simulator::Inside>();
    inside->network = std::move(*network);
    keep(*inside, charts_of(model, model.loops[loop]));
    inside->problem = inside->moved.emplace(inside->network, inside->charts, Detail::Chart).begin();
    return Simulator(std::move(inside));
}

std::optional<Simulator> simulator_of(const Model& model, Id<Chart> chart, std::optional<ExecutionMode> mode,
                                      Diagnostics& diagnostics) {
    if (!equations_of(model, chart, diagnostics)) return {};  // the interpreter requires a chart with valid equations
    auto inside = std::make_unique<Simulator::Inside>();
    keep(*inside, {&model.charts[chart]});
    inside->problem = inside->moved.emplace(inside->kept[0], execution_mode(model, chart, mode), Detail::Chart).begin();
    return Simulator(std::move(inside));
}

}  // namespace grafverif
