// SPDX-License-Identifier: MIT
// Measures the stages of the translation of generated charts with 1,000 to 100,000 steps: reading,
// derivation of equations, composition with the plant, and output for other tools. The time of each
// stage per step is reported; it must not grow with the number of steps.
#include <benchmark/benchmark.h>

#include <sstream>
#include <string>

#include "compose/compose.hpp"
#include "derive/derive.hpp"
#include "emit/nusmv/nusmv.hpp"
#include "emit/uppaal/uppaal.hpp"
#include "generate.hpp"
#include "pipeline/components.hpp"
#include "plant/plant.hpp"
#include "read/text.hpp"
#include "schedule/controller.hpp"

namespace grafverif {
namespace {

Model read(const std::string& text) {
    Sources sources;
    Diagnostics diagnostics;
    const Id<Source> file = sources.add({"ring.grafcet", text});
    return read_text(file, sources, {{}, library()}, diagnostics).value();
}

Equations derived(const Model& model) {
    Diagnostics diagnostics;
    return derive(*model.charts.begin(), diagnostics).value();
}

Network composed(const Model& model, const Equations& equations) {
    Diagnostics diagnostics;
    const ClosedLoop& loop = *model.loops.begin();
    const Network alone = plant(model, loop, diagnostics).value();
    return compose(alone, loop, {&equations, 1}, {}, diagnostics).value();
}

void per_step(benchmark::State& state) {
    state.counters["steps/s"] = benchmark::Counter(
        static_cast<double>(state.range(0)) * static_cast<double>(state.iterations()), benchmark::Counter::kIsRate);
    state.SetComplexityN(state.range(0));
}

void read_chart(benchmark::State& state) {
    const std::string text = bench::ring(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) benchmark::DoNotOptimize(read(text));
    per_step(state);
}

void derive_equations(benchmark::State& state) {
    const Model model = read(bench::ring(static_cast<std::size_t>(state.range(0))));
    for (auto _ : state) benchmark::DoNotOptimize(derived(model));
    per_step(state);
}

void compose_network(benchmark::State& state) {
    const Model model = read(bench::ring(static_cast<std::size_t>(state.range(0))));
    const Equations equations = derived(model);
    for (auto _ : state) benchmark::DoNotOptimize(composed(model, equations));
    per_step(state);
}

void emit_uppaal(benchmark::State& state) {
    const Model model = read(bench::ring(static_cast<std::size_t>(state.range(0))));
    const Network network = composed(model, derived(model));
    for (auto _ : state) {
        std::ostringstream out;
        uppaal::emit(uppaal::lower(network), out);
        benchmark::DoNotOptimize(out.tellp());
    }
    per_step(state);
}

void emit_nusmv(benchmark::State& state) {
    const Model model = read(bench::ring(static_cast<std::size_t>(state.range(0))));
    const Equations equations = derived(model);
    for (auto _ : state) {
        std::ostringstream out;
        nusmv::emit(schedule_controllers(model, *model.loops.begin(), {&equations, 1}), out);
        benchmark::DoNotOptimize(out.tellp());
    }
    per_step(state);
}

void text_to_uppaal(benchmark::State& state) {
    const std::string text = bench::ring(static_cast<std::size_t>(state.range(0)));
    for (auto _ : state) {
        const Model model = read(text);
        std::ostringstream out;
        uppaal::emit(uppaal::lower(composed(model, derived(model))), out);
        benchmark::DoNotOptimize(out.tellp());
    }
    per_step(state);
}

}  // namespace

BENCHMARK(read_chart)->RangeMultiplier(10)->Range(1'000, 100'000)->Complexity()->Unit(benchmark::kMillisecond);
BENCHMARK(derive_equations)->RangeMultiplier(10)->Range(1'000, 100'000)->Complexity()->Unit(benchmark::kMillisecond);
BENCHMARK(compose_network)->RangeMultiplier(10)->Range(1'000, 100'000)->Complexity()->Unit(benchmark::kMillisecond);
BENCHMARK(emit_uppaal)->RangeMultiplier(10)->Range(1'000, 100'000)->Complexity()->Unit(benchmark::kMillisecond);
BENCHMARK(emit_nusmv)->RangeMultiplier(10)->Range(1'000, 100'000)->Complexity()->Unit(benchmark::kMillisecond);
BENCHMARK(text_to_uppaal)->RangeMultiplier(10)->Range(1'000, 100'000)->Complexity()->Unit(benchmark::kMillisecond);

}  // namespace grafverif

BENCHMARK_MAIN();
