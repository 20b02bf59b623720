// SPDX-License-Identifier: MIT
// Tests the projects of all samples, in every mode and grain.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>

#include "app/command_context.hpp"
#include "emit/uppaal/uppaal.hpp"
#include "support/uppaal_reader.hpp"
#include "unit/emit/uppaal/drawings.hpp"
#include "unit/emit/uppaal/dtd.hpp"

namespace grafverif {
namespace {

namespace fs = std::filesystem;

bool contains(const fs::path& file, const char* text) {
    std::ifstream in(file);
    return std::string(std::istreambuf_iterator<char>(in), {}).find(text) != std::string::npos;
}

/// True if the file contains a closed loop; false for files that are only included by others.
bool has_loop(const fs::path& file) { return contains(file, "closed_loop"); }

std::vector<std::string> samples() {
    std::vector<std::string> found;
    for (const fs::directory_entry& entry : fs::recursive_directory_iterator(GRAFVERIF_SOURCE_DIR "/samples"))
        if (entry.path().extension() == ".grafcet" && has_loop(entry.path())) found.push_back(entry.path().string());
    std::ranges::sort(found);
    return found;
}

/// Returns the networks of the loops of a file, which are ready to emit.
std::vector<Network> networks(const std::string& file) {
    std::vector<Network> list;
    app::CommandContext reading;
    const auto model = app::read_model(file, reading);
    if (!model) return {};
    for (const Id<ClosedLoop> loop : model->loops.ids()) {
        for (const Grain grain : {Grain::Phased, Grain::Atomic}) {
            for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle}) {
                app::CommandContext job;
                job.options.grain = grain;
                job.options.mode = mode;
                const auto network = app::network_of(*model, loop, job);
                if (network) list.push_back(uppaal::lower(*network));
            }
        }
    }
    return list;
}

class UppaalSamples : public testing::TestWithParam<std::string> {};

TEST_P(UppaalSamples, AreDrawnClearlyValidAndReadBack) {
    const std::vector<Network> list = networks(GetParam());
    ASSERT_FALSE(list.empty());
    for (const Network& network : list) {
        std::ostringstream out;
        uppaal::emit(network, out);
        EXPECT_EQ(test::overlaps(out.str()), "");
        // Variables of programs have other names in the project; randomized_program_loop compares their behaviour.
        if (!contains(GetParam(), "\nprogram ")) {
            EXPECT_EQ(test::comparable_text(test::read_uppaal(out.str())),
                      test::comparable_text(test::as_read_back(network)));
        }
        EXPECT_TRUE(!test::has_xmllint() || test::is_valid(out.str()));
    }
}

INSTANTIATE_TEST_SUITE_P(All, UppaalSamples, testing::ValuesIn(samples()), [](const auto& sample) {
    const fs::path file = sample.param;
    return file.parent_path().filename().string() + '_' + file.stem().string();
});

}  // namespace
}  // namespace grafverif
