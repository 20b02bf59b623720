// SPDX-License-Identifier: MIT
// Golden tests of all stages of the translation of each sample in tests/golden/<sample>/. GRAFVERIF_UPDATE_GOLDEN=1
// rewrites the files instead of comparing them; review the difference before you commit it.
#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>
#include <vector>

#include "app/command_context.hpp"
#include "pipeline/models.hpp"
#include "support/print_model.hpp"
#include "support/print_network.hpp"
#include "syntax/print/equations.hpp"

namespace grafverif::app {
namespace {

namespace fs = std::filesystem;

const fs::path root = GRAFVERIF_SOURCE_DIR;

void expect_golden(const fs::path& file, const std::string& actual) {
    if (std::getenv("GRAFVERIF_UPDATE_GOLDEN") != nullptr) {
        fs::create_directories(file.parent_path());
        std::ofstream(file, std::ios::binary) << actual;
    }
    std::ifstream in(file, std::ios::binary);
    ASSERT_TRUE(in) << file << " is missing; GRAFVERIF_UPDATE_GOLDEN=1 creates it";
    std::ostringstream expected;
    expected << in.rdbuf();
    EXPECT_EQ(expected.str(), actual) << file;
}

template <class Print, class Noun>
std::string printed(Print print, const Noun& noun) {
    std::ostringstream out;
    print(out, noun);
    return out.str();
}

class Golden : public testing::TestWithParam<std::string> {};

TEST_P(Golden, EveryStageIsAsReviewed) {
    const std::string sample = GetParam();
    const std::string stem = fs::path(sample).filename().string();
    const fs::path folder = root / "tests/golden" / stem;
    CommandContext job;
    const auto model = read_model((root / "samples" / (sample + ".grafcet")).string(), job);
    ASSERT_TRUE(model);
    const auto chart = chosen_chart(*model, job);
    const auto loop = chosen_loop(*model, job);
    ASSERT_TRUE(chart && loop);
    EXPECT_TRUE(verify(*model).empty());
    const auto equations = equations_of(*model, *chart, job);
    const auto network = network_of(*model, *loop, job);
    const auto system = transition_system_of(*model, *loop, job);
    ASSERT_TRUE(equations && network && system);
    EXPECT_TRUE(verify(*equations).empty());
    EXPECT_TRUE(verify(*network).empty());
    EXPECT_TRUE(verify(*system).empty());
    const UppaalProject project = uppaal_project(*network, job.diagnostics);

    expect_golden(folder / "1-chart.txt", printed([](auto& out, const Model& m) { print(out, m); }, *model));
    expect_golden(folder / "2-equations.txt",
                  printed([](auto& out, const Equations& e) { print_equations(out, e); }, *equations));
    expect_golden(folder / "3-network.txt",
                  printed([](auto& out, const Network& n) { print_network(out, n); }, *network));
    expect_golden(folder / "4-uppaal.xml", project.project);
    expect_golden(folder / "4-uppaal.q", project.queries);
    expect_golden(folder / "5-model.smv", nusmv_model(*system, job.diagnostics));
    if (model->loops[*loop].schedule) {
        job.options.untimed.plant = PlantApproach::Automata;
        const auto with_plant = transition_system_of(*model, *loop, job);
        ASSERT_TRUE(with_plant);
        EXPECT_TRUE(verify(*with_plant).empty());
        expect_golden(folder / "5-model-with-plant.smv", nusmv_model(*with_plant, job.diagnostics));
    }
    EXPECT_FALSE(job.diagnostics.has_errors());
    CheckOptions options;
    options.witnesses = false;
    if (stem == "transfer_line")  // this sample has too many states; localization checks its safety properties
        for (const Property& property : network->properties)
            if (property.pattern == Pattern::Never) options.properties.push_back(property.name);
    const auto report = grafverif::check(*model, *loop, {}, options, job.diagnostics);
    ASSERT_TRUE(report);
    expect_golden(folder / "6-verdicts.txt", text_of(*report));
    if (stem == "blinker" || stem == "oven_door") {
        const ExecutionMode mode = execution_mode(*model, *chart, job);
        const auto program = structured_text_of(*equations, {mode, 1000, structured_text::Form::Text}, job.diagnostics);
        const auto code = c_code_of(*equations, mode, 1000, stem + ".h", job.diagnostics);
        ASSERT_TRUE(program && code);
        expect_golden(folder / "7-controller.st", *program);
        expect_golden(folder / "7-controller.h", code->header);
        expect_golden(folder / "7-controller.c", code->source);
    }
    EXPECT_FALSE(job.diagnostics.has_errors());
}

INSTANTIATE_TEST_SUITE_P(Samples, Golden,
                         testing::Values("testing_station/testing_station", "testing_station/faulty",
                                         "oven_door/oven_door", "tanks/tanks", "blinker/blinker",
                                         "assembly_station/assembly_station", "pick_and_place/pick_and_place",
                                         "transfer_line/transfer_line", "filling_line/filling_line"),
                         [](const auto& sample) { return fs::path(sample.param).filename().string(); });

}  // namespace
}  // namespace grafverif::app
