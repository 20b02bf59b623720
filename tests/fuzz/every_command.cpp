// SPDX-License-Identifier: MIT
#include "fuzz/every_command.hpp"

#include <algorithm>
#include <exception>
#include <fstream>
#include <iterator>
#include <nlohmann/json.hpp>
#include <pugixml.hpp>
#include <regex>
#include <utility>

#include "fuzz/common.hpp"
#include "read/test_csv.hpp"
#include "support/nusmv_reader.hpp"
#include "support/run_structured_text.hpp"
#include "support/uppaal_reader.hpp"
#include "syntax/language/parse.hpp"
#include "syntax/st/parse_st.hpp"
#include "unit/app/run_program.hpp"

namespace grafverif::fuzz {

namespace {

namespace fs = std::filesystem;

const std::vector<std::string> limits{"--timeout", "2s", "--max-memory", "500M"};

std::vector<VerbRun> all_runs() {
    using enum Written;
    std::vector<VerbRun> runs{
        {{"fmt", "FILE"}, Grafcet},
        {{"import", "FILE"}, Grafcet},
        {{"draw", "FILE"}, Xml},
        {{"draw", "FILE", "--columns", "3", "--notation", "text"}, Xml},
        {{"equations", "FILE"}},
        {{"equations", "FILE", "--format", "json"}, Json},
        {{"equations", "FILE", "--format", "latex"}},
        {{"st", "FILE"}, Plcopen},
        {{"st", "FILE", "--format", "text"}, StructuredText},
        {{"st", "FILE", "--format", "text", "--mode", "every-cycle"}, StructuredText},
        {{"st", "FILE", "--dialect", "twincat"}, Xml},
        {{"st", "FILE", "--dialect", "siemens"}},
        {{"c", "FILE"}},
        {{"c", "FILE", "--mode", "every-cycle"}},
        {{"nusmv", "FILE"}, Nusmv},
        {{"nusmv", "FILE", "--mode", "every-cycle"}, Nusmv},
        {{"components"}},
        {{"plc", "FILE"}, Text, false, "1\n0\nwait 1s\n1,1,1,1\n0,0,0,0\n0\n"},
        {{"plc", "FILE", "--mode", "every-cycle"}, Text, false, "wait 3s\n0,0\n1,1\n0,0\nnothing\n"},
        {{"uppaal", "FILE"}, Uppaal, true},
        {{"build", "FILE", "-o", "FOLDER/models", "--create-dirs"}, Text, true},
        {{"nusmv", "FILE", "--plant", "constraints"}, Nusmv, true},
        {{"simulate", "FILE", "--random", "3", "--steps", "30", "--trace-vcd", "FOLDER/t.vcd", "--trace-svg",
          "FOLDER/t.svg"},
         Text},
        {{"simulate", "FILE"}, Text, false, "1\nwait\nwait 1s\nback\n2\nin1 = true\ndo nobody\nquit\n"},
    };
    for (const char* schedule : {"interleaved", "synchronous", "sequenced"})
        runs.push_back({{"nusmv", "FILE", "--plant", "automata", "--schedule", schedule}, Nusmv, true});
    runs.push_back({{"nusmv", "FILE", "--time", "discrete", "--grain", "atomic"}, Nusmv, true});
    const auto bounded = [&runs](std::vector<std::string> arguments, Written written, bool of_loop) {
        arguments.insert(arguments.end(), limits.begin(), limits.end());
        runs.push_back({std::move(arguments), written, of_loop, {}});
    };
    bounded({"check", "FILE", "--format", "json", "--max-states", "20000", "--junit", "FOLDER/r.xml", "--trace-vcd",
             "FOLDER/t.vcd", "--trace-svg", "FOLDER/t.svg"},
            Json, false);
    bounded({"check", "FILE", "--max-states", "20000", "--grain", "atomic", "--mode", "every-cycle"}, Text, false);
    bounded({"check", "FILE", "--untimed", "--format", "json", "--junit", "FOLDER/r.xml"}, Json, false);
    bounded({"check", "FILE", "--plant", "automata", "--fairness"}, Text, true);
    bounded({"check", "FILE", "--schedule", "sequenced", "--format", "json"}, Json, true);
    bounded({"check", "FILE", "--time", "discrete"}, Text, true);
    bounded({"report", "FILE", "--max-states", "20000"}, Text, false);
    bounded({"analyse", "FILE"}, Text, false);
    bounded({"analyse", "FILE", "--format", "json"}, Json, false);
    bounded({"analyse", "FILE", "--format", "sarif", "--mode", "every-cycle"}, Json, false);
    bounded({"st", "FILE", "--prove", "--format", "text", "--resolution", "1s"}, Text, false);
    for (const char* verb : {"automaton", "mealy"}) {
        bounded({verb, "FILE"}, Text, false);
        bounded({verb, "FILE", "--format", "json", "--mode", "every-cycle"}, Json, false);
        bounded({verb, "FILE", "--format", "dot"}, Text, false);
        bounded({verb, "FILE", "--format", "svg"}, Xml, false);
        bounded({verb, "FILE", "--counts"}, Text, false);
    }
    bounded({"testgen", "FILE"}, TestTable, false);
    bounded({"testgen", "FILE", "--mode", "every-cycle", "--cover", "locations", "--hold", "one"}, TestTable, false);
    bounded({"testgen", "FILE", "--format", "json", "--minimise"}, Json, false);
    bounded({"testgen", "FILE", "--format", "st", "--cover", "evolutions"}, StructuredText, false);
    bounded({"testgen", "FILE", "--format", "xml"}, Plcopen, false);
    return runs;
}

std::string units_complaint(const std::string& text) {
    Sources sources;
    Diagnostics diagnostics;
    const Id<Source> source = sources.add({"units.st", text});
    st::File file;
    const st::Text whole{{{source, 0, static_cast<std::uint32_t>(text.size())}, false}};
    return st::parse_units(whole, file, sources, diagnostics) ? ""
                                                              : "not Structured Text: " + shown(diagnostics, sources);
}

/// Checks that a generated table belongs to the chart from which it was generated.
std::string table_complaint(const std::string& text, const VerbRun& run, const Model& model) {
    if (model.charts.size() != 1) return {};
    Sources sources;
    Diagnostics diagnostics;
    const bool every_cycle = std::ranges::find(run.arguments, "every-cycle") != run.arguments.end();
    const auto mode = every_cycle ? ExecutionMode::EveryCycle : ExecutionMode::StabilitySearch;
    const auto test = read_test_csv(sources.add({"test.csv", text}), sources, *model.charts.begin(), mode, diagnostics);
    return test ? "" : "not a test table: " + shown(diagnostics, sources);
}

std::string grafcet_complaint(const std::string& text) {
    Sources sources;
    Diagnostics diagnostics;
    return parse_file(sources.add({"written.grafcet", text}), sources, diagnostics).broken
               ? "not a .grafcet file: " + shown(diagnostics, sources)
               : "";
}

std::string written_complaint(const std::string& text, const VerbRun& run, Written written, const Model& model) {
    try {
        switch (written) {
        case Written::Text: return {};
        case Written::Grafcet: return grafcet_complaint(text);
        case Written::Json: return nlohmann::json::accept(text) ? "" : "not valid JSON";
        case Written::Xml: {
            const pugi::xml_parse_result read = pugi::xml_document().load_buffer(text.data(), text.size());
            return read ? "" : std::string("not XML: ") + read.description();
        }
        case Written::Uppaal: test::read_uppaal(text); return {};
        case Written::Nusmv: return read_nusmv(text).error_text;
        case Written::TestTable: return table_complaint(text, run, model);
        case Written::Plcopen: return units_complaint(units_of_plcopen(text));
        case Written::StructuredText: return units_complaint(text);
        }
    } catch (const std::exception& failure) {
        return std::string("not in the expected format: ") + failure.what();
    }
    return "unknown format";
}

/// Returns the type of a file according to its name.
Written written_to(const fs::path& path) {
    const std::string name = path.extension().string();
    if (name == ".smv") return Written::Nusmv;
    if (name == ".svg") return Written::Xml;
    if (name == ".xml") return path.parent_path().filename() == "models" ? Written::Uppaal : Written::Xml;
    return Written::Text;
}

std::string content_of(const fs::path& path) {
    std::ifstream file(path, std::ios::binary);
    return {std::istreambuf_iterator<char>(file), {}};
}

std::string result_complaint(const VerbRun& run, const app::Result& result, const Model& model,
                             const fs::path& folder) {
    static const std::regex refusal(R"((^|\n)[^\n]*error: [^\n]* \[[a-z0-9-]+\])");
    std::string files;
    for (const auto& entry : fs::recursive_directory_iterator(folder)) {
        if (!entry.is_regular_file()) continue;
        const bool is_report = entry.path().extension() == ".xml";  // the report of a rejected input contains its error
        if (result.code == app::ExitCode::Input && !is_report)
            return "the input is rejected, but the command writes " + entry.path().string();
        const std::string wrong = written_complaint(content_of(entry.path()), run, written_to(entry.path()), model);
        if (!wrong.empty()) return entry.path().string() + ": " + wrong;
    }
    switch (result.code) {
    case app::ExitCode::Failure: return "internal error";
    case app::ExitCode::Input:
        if (run.arguments[0] == "plc" && result.out.find("error: ") != std::string::npos)
            return {};  // the command rejected this line
        return std::regex_search(result.err, refusal) ? "" : "the input is rejected without an error";
    case app::ExitCode::Unknown:
        if (result.out.empty()) return {};
        break;
    case app::ExitCode::Done:
    case app::ExitCode::Verdict: break;
    }
    return written_complaint(result.out, run, run.written, model);
}

}  // namespace

std::span<const VerbRun> command_runs() {
    static const std::vector<VerbRun> runs = all_runs();
    return runs;
}

std::string error_text(const VerbRun& run, const fs::path& file, const Model& model, const fs::path& folder) {
    std::vector<std::string> arguments;
    std::string command = "grafverif";
    for (const std::string& argument : run.arguments) {
        const bool written = argument.starts_with("FOLDER");
        arguments.push_back(argument == "FILE" ? file.string()
                            : written          ? folder.string() + argument.substr(6)
                                               : argument);
        command += ' ' + argument;
    }
    fs::create_directories(folder);
    const app::Result result = app::grafverif(arguments, run.typed);
    const std::string wrong = result_complaint(run, result, model, folder);
    fs::remove_all(folder);
    if (wrong.empty()) return {};
    return command + ": " + wrong + "\nexit code " + std::to_string(static_cast<int>(result.code)) + "\nFILE:\n" +
           content_of(file) + "\nstandard output:\n" + result.out + "\nstandard error:\n" + result.err;
}

}  // namespace grafverif::fuzz
