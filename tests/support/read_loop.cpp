// SPDX-License-Identifier: MIT
#include "support/read_loop.hpp"

#include <filesystem>
#include <fstream>
#include <iterator>
#include <sstream>
#include <stdexcept>

#include "plant/plant.hpp"
#include "read/text.hpp"
#include "support/derived.hpp"

namespace grafverif {

namespace {

const std::filesystem::path root = GRAFVERIF_SOURCE_DIR;

std::string content(const std::filesystem::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) throw std::invalid_argument("cannot read " + path.string());
    return {std::istreambuf_iterator<char>(file), {}};
}

struct LibraryFile {
    std::string name = {}, text = {};
};

/// Returns the files of templates/, which are read only once.
std::vector<LibraryFile> library() {
    std::vector<LibraryFile> found;
    for (const auto& entry : std::filesystem::directory_iterator(root / "templates"))
        found.push_back({entry.path().stem().string(), content(entry.path())});
    return found;
}

[[noreturn]] void refuse(const Diagnostics& diagnostics, const Sources& sources) {
    std::ostringstream text;
    render_text(diagnostics.all(), sources, Colour::Plain, text);
    throw std::invalid_argument(text.str());
}

}  // namespace

std::vector<const Chart*> LoopUnderTest::charts() const {
    std::vector<const Chart*> list;
    for (const ClosedLoop::Controller& controller : model.loops[{0}].controllers)
        list.push_back(&model.charts[controller.chart]);
    return list;
}

LoopUnderTest composed_loop(Model model, const ComposeOptions& options) {
    Diagnostics diagnostics;
    const ClosedLoop& loop = model.loops[{0}];
    const auto equations = derived(model, diagnostics);
    if (!equations) refuse(diagnostics, {});
    const auto plant_network = plant(model, loop, diagnostics);
    if (!plant_network) refuse(diagnostics, {});
    auto network = compose(*plant_network, loop, *equations, options, diagnostics);
    if (!network) refuse(diagnostics, {});
    return {std::move(model), std::move(*network)};
}

LoopUnderTest read_loop(const std::string& text, const ComposeOptions& options) {
    const std::vector<LibraryFile> files = library();
    std::vector<LibraryEntry> entries;
    for (const LibraryFile& file : files) entries.push_back({file.name, file.text, file.name});
    Sources sources;
    Diagnostics diagnostics;
    const ReadContext context{[](const std::string&, std::string&) { return std::nullopt; }, entries};
    auto model = read_text(sources.add({"test.grafcet", text}), sources, context, diagnostics);
    if (!model) refuse(diagnostics, sources);
    return composed_loop(std::move(*model), options);
}

LoopUnderTest read_sample(const std::string& path, const ComposeOptions& options) {
    return read_loop(content(root / "samples" / path), options);
}

}  // namespace grafverif
