// SPDX-License-Identifier: MIT
// Golden tests of the diagnostics as printed. Each file <code>[-n].grafcet is processed up to the first failing stage,
// and the printed diagnostics must equal <code>[-n].expected. GRAFVERIF_UPDATE_GOLDEN=1 rewrites the expected files.
#include <gtest/gtest.h>

#include <algorithm>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <functional>
#include <map>
#include <optional>
#include <set>
#include <sstream>
#include <string>
#include <vector>

#include "compose/compose.hpp"
#include "conform/automaton.hpp"
#include "conform/mealy.hpp"
#include "conform/test_sequence.hpp"
#include "derive/derive.hpp"
#include "derive/program/controller.hpp"
#include "plant/plant.hpp"
#include "read/exclusions.hpp"
#include "read/text.hpp"
#include "schedule/controller.hpp"
#include "schedule/network.hpp"
#include "syntax/language/format.hpp"
#include "syntax/language/parse.hpp"

namespace grafverif {
namespace {

namespace fs = std::filesystem;

const fs::path root = GRAFVERIF_SOURCE_DIR;

std::optional<std::string> content(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    if (!file) return {};
    std::ostringstream text;
    text << file.rdbuf();
    return std::move(text).str();
}

struct LibraryFile {
    std::string name = {}, text = {}, path = {};
};

const std::vector<LibraryFile>& library_files() {
    static const std::vector<LibraryFile> files = [] {
        std::vector<LibraryFile> found;
        for (const auto& entry : fs::directory_iterator(root / "templates")) {
            if (entry.path().extension() != ".grafcet") continue;
            found.push_back(
                {entry.path().stem().string(), content(entry.path()).value(), entry.path().filename().string()});
        }
        std::ranges::sort(found, {}, &LibraryFile::name);
        return found;
    }();
    return files;
}

std::vector<fs::path> examples() {
    std::vector<fs::path> found;
    for (const auto& entry : fs::directory_iterator(root / "tests/diagnostics"))
        if (entry.path().extension() == ".grafcet") found.push_back(entry.path());
    std::ranges::sort(found);
    return found;
}

/// Runs the stages of `testgen` in both execution modes, until a stage reports an error.
void test(const Equations& equations, Diagnostics& diagnostics) {
    for (const ExecutionMode mode : {ExecutionMode::StabilitySearch, ExecutionMode::EveryCycle}) {
        AutomatonOptions options;
        options.mode = mode;
        const auto automaton = location_automaton(equations, options, diagnostics);
        const auto machine = automaton ? mealy_machine(*automaton, {}, diagnostics) : std::nullopt;
        if (machine) test_sequence(*machine, {}, equations.origin, diagnostics);
        if (diagnostics.has_errors()) return;
    }
}

/// Returns the controller that executes the program of a chart, or null if the chart has no program or no controller.
const ClosedLoop::Controller* program_controller(const Model& model, Id<Chart> chart) {
    if (!model.charts[chart].program) return nullptr;
    for (const ClosedLoop& loop : model.loops)
        for (const ClosedLoop::Controller& controller : loop.controllers)
            if (controller.chart == chart) return &controller;
    return nullptr;
}

/// Runs the stages of `build`: translates every chart to equations, and every loop to a network and to a transition
/// system with the constraints of the loop. If `tested`, every chart is also translated to a test sequence.
void build(const Model& model, bool tested, Diagnostics& diagnostics) {
    std::vector<std::optional<Equations>> equations;
    for (const Id<Chart> id : model.charts.ids()) {
        const ClosedLoop::Controller* const program = program_controller(model, id);
        equations.push_back(
            program != nullptr
                ? controller_equations(*model.charts[id].program,
                                       {.name = program->name, .cycle = program->cycle, .origin = program->origin},
                                       diagnostics)
                : derive(model.charts[id], diagnostics));
    }
    for (const std::optional<Equations>& one : equations)
        if (tested && one) test(*one, diagnostics);
    for (const ClosedLoop& loop : model.loops) {
        const auto network = plant(model, loop, diagnostics);
        std::vector<Equations> controllers;
        for (const auto& controller : loop.controllers)
            if (equations[controller.chart.index]) controllers.push_back(*equations[controller.chart.index]);
        if (!network || controllers.size() != loop.controllers.size()) continue;
        const auto composed = compose(*network, loop, controllers, {}, diagnostics);
        constraints_agree(loop, diagnostics);
        if (composed && !diagnostics.has_errors())
            schedule_network(model, loop, controllers, *composed, {}, diagnostics);
    }
}

/// Reads <code>[-n].csv, if it exists, as a table of exclusions for the chart.
void exclude(const std::string& name, const std::optional<Model>& model, Sources& sources, Diagnostics& diagnostics) {
    const fs::path path = fs::path(name).replace_extension(".csv");
    const auto table = content(root / "tests/diagnostics" / path);
    if (!table || !model) return;
    const Id<Source> id = sources.add({path.string(), *table});
    read_exclusions(id, sources, *model->charts.begin(), diagnostics);
}

/// Returns the constants of `--set` if the first line of the file is `// --set N=4 T=3s`.
std::map<std::string, std::string, std::less<>> constants_of(const std::string& text) {
    std::istringstream words(text.substr(0, text.find('\n')));
    std::map<std::string, std::string, std::less<>> constants;
    std::string word;
    if (words >> word && word == "//" && words >> word && word == "--set")
        while (words >> word) constants[word.substr(0, word.find('='))] = word.substr(word.find('=') + 1);
    return constants;
}

struct Reported {
    Sources sources = {};
    Diagnostics diagnostics = {};
};

Reported reported_about(const std::string& name, const std::string& text) {
    std::vector<LibraryEntry> library;
    for (const LibraryFile& file : library_files()) library.push_back({file.name, file.text, file.path});
    ReadContext context{[](const std::string& path, std::string& why) {
                            auto found = content(root / "tests/diagnostics" / path);
                            if (!found) why = "there is no such file";
                            return found;
                        },
                        library};
    context.constants = constants_of(text);
    Reported reported;
    auto& [sources, diagnostics] = reported;
    const auto model = read_text(sources.add({name, text}), sources, context, diagnostics);
    EXPECT_EQ(model.has_value(), !diagnostics.has_errors());
    if (model) build(*model, text.starts_with("// testgen"), diagnostics);
    exclude(name, model, sources, diagnostics);
    return reported;
}

std::string words(const Reported& reported) {
    std::ostringstream text;
    render_text(reported.diagnostics.all(), reported.sources, Colour::Plain, text);
    return std::move(text).str();
}

/// Returns how often `reported` contains a diagnostic with the code and the message of `one`.
std::ptrdiff_t times(const Reported& reported, const Diagnostic& one) {
    return std::ranges::count_if(reported.diagnostics.all(), [&](const Diagnostic& other) {
        return other.code == one.code && other.message == one.message;
    });
}

/// Returns the code that a file tests: `unknown-step-2` tests `unknown-step`.
std::string code_of(const fs::path& reject) {
    std::string code = reject.stem().string();
    const std::size_t number = code.find_last_not_of("0123456789");
    if (number + 1 < code.size() && code[number] == '-') code.resize(number);
    return code;
}

TEST(DiagnosticExamples, PrintTheExpectedText) {
    const bool update = std::getenv("GRAFVERIF_UPDATE_GOLDEN") != nullptr;
    for (const fs::path& reject : examples()) {
        SCOPED_TRACE(reject.filename().string());
        const std::string reported = words(reported_about(reject.filename().string(), content(reject).value()));
        const fs::path expected = fs::path(reject).replace_extension(".expected");
        if (update) std::ofstream(expected, std::ios::binary) << reported;
        EXPECT_EQ(content(expected).value_or(""), reported);
        EXPECT_NE(reported.find('[' + code_of(reject) + ']'), std::string::npos) << reported;
    }
}

TEST(DiagnosticExamples, AreCorrectedByTheirFixes) {
    std::set<std::string> codes;
    for (const fs::path& reject : examples()) {
        const std::string name = reject.filename().string(), text = content(reject).value();
        const Reported reported = reported_about(name, text);
        for (const Diagnostic& diagnostic : reported.diagnostics.all()) {
            if (!diagnostic.fix || reported.sources[diagnostic.fix->where.source].name != name) continue;
            SCOPED_TRACE(name + ": " + diagnostic.message);
            codes.insert(diagnostic.code);
            const Fix& fix = *diagnostic.fix;
            std::string mended = text;
            mended.replace(fix.where.begin, fix.where.end - fix.where.begin, fix.replacement);
            EXPECT_LT(times(reported_about(name, mended), diagnostic), times(reported, diagnostic)) << mended;
        }
    }
    for (const char* code : {"unknown-variable", "unknown-step", "unknown-component", "undriven-input",
                             "missing-semicolon", "single-equals", "other-spelling", "clock-reset"})
        EXPECT_TRUE(codes.contains(code)) << code;
}

TEST(DiagnosticExamples, FormattingIsIdempotent) {
    for (const fs::path& reject : examples()) {
        SCOPED_TRACE(reject.filename().string());
        Sources sources;
        Diagnostics diagnostics;
        const tree::File file = parse_file(sources.add({"reject", content(reject).value()}), sources, diagnostics);
        if (file.broken) continue;
        const std::string once = formatted(file);
        const tree::File again = parse_file(sources.add({"formatted", once}), sources, diagnostics);
        ASSERT_FALSE(again.broken) << once;
        EXPECT_EQ(formatted(again), once);
    }
}

TEST(DiagnosticExamples, HaveBothFiles) {
    for (const auto& entry : fs::directory_iterator(root / "tests/diagnostics")) {
        if (entry.path().extension() != ".expected") continue;
        EXPECT_TRUE(fs::exists(fs::path(entry.path()).replace_extension(".grafcet"))) << entry.path();
    }
}

}  // namespace
}  // namespace grafverif
