// SPDX-License-Identifier: MIT
// Fuzz targets that read texts: the language of grafverif, other chart formats, and Structured Text. An accepted text
// must be well formed, and its printed form must be read back as the same model. A rejected text must have an error
// that can be displayed.
#include <algorithm>
#include <nlohmann/json.hpp>
#include <sstream>

#include "derive/program/scan.hpp"
#include "fuzz/common.hpp"
#include "fuzz/targets.hpp"
#include "read/formats.hpp"
#include "read/program/properties.hpp"
#include "read/text.hpp"
#include "support/print_model.hpp"
#include "syntax/language/format.hpp"
#include "syntax/language/parse.hpp"
#include "syntax/st/parse_st.hpp"

namespace grafverif::fuzz {

namespace {

/// Returns a description of a contradiction between the result of reading a text and its diagnostics, or an empty
/// string.
std::string result_complaint_of(bool read, const Diagnostics& diagnostics, const Sources& sources) {
    if (read == diagnostics.has_errors())
        return read ? "the text is accepted, but there are errors" : "the text is rejected without an error";
    if (diagnostics.all().size() > Diagnostics::limit * 4) return "there are too many diagnostics";
    std::ostringstream json;
    render_json(diagnostics.all(), sources, json);
    if (!nlohmann::json::accept(json.str())) return "not JSON:\n" + json.str();
    shown(diagnostics, sources);
    return {};
}

struct TextRead {
    std::optional<Model> model = {};
    std::string error_text = {};  ///< description of an error in the diagnostics; empty if there is none
    std::string rendered = {};
};

TextRead read(Id<Source> file, Sources& sources, bool lossy) {
    Diagnostics diagnostics;
    ReadContext context;
    context.load = [](const std::string&, std::string& why) { return why = "there are no files here", std::nullopt; };
    context.lossy = lossy;
    References references;
    context.references = &references;
    TextRead reading{read_text(file, sources, context, diagnostics), {}, {}};
    reading.error_text = result_complaint_of(reading.model.has_value(), diagnostics, sources);
    reading.rendered = shown(diagnostics, sources);
    if (reading.error_text.empty() && reading.model)
        for (const std::string& broken : verify(*reading.model))
            reading.error_text += "not well formed: " + broken + '\n';
    return reading;
}

std::string printed(const Model& model) {
    std::ostringstream text;
    print(text, model);
    return text.str();
}

/// Checks that the generated `text` is read back as `model`.
std::string reading_back(const Model& model, const std::string& text, Sources& sources) {
    const TextRead again = read(sources.add({"written.grafcet", text}), sources, false);
    if (!again.error_text.empty()) return again.error_text + "\nof:\n" + text;
    if (!again.model) return "the written text is rejected:\n" + again.rendered + text;
    if (printed(*again.model) != printed(model))
        return "the written text has another meaning:\n" + text + "\nwas:\n" + printed(model);
    return {};
}

/// True if a chart has names that the language cannot declare, because only instances of charts
/// have such names: `Head[1].N`.
bool has_names_of_instances(const Model& model) {
    const auto has_dot = [](const auto& each) { return each.name.find('.') != std::string::npos; };
    return std::ranges::any_of(model.charts, [&](const Chart& chart) {
        return !chart.instance_of.empty() || std::ranges::any_of(chart.variables, has_dot) ||
               std::ranges::any_of(chart.transitions, has_dot);
    });
}

/// Checks that formatting does not change the formatted `text`.
std::string form_complaint(const std::string& text, Sources& sources) {
    Diagnostics diagnostics;
    const tree::File file = parse_file(sources.add({"formatted.grafcet", text}), sources, diagnostics);
    if (file.broken || diagnostics.has_errors())
        return "the formatted text does not parse:\n" + shown(diagnostics, sources) + text;
    const std::string again = formatted(file);
    return again == text ? "" : "formatting again changes the text:\n" + text + "\nand:\n" + again;
}

std::string imported_complaint(std::string_view bytes, bool lossy) {
    Sources sources;
    const Id<Source> source = sources.add({"fuzzed.xml", std::string(bytes)});
    const TextRead reading = read(source, sources, lossy);
    if (!reading.error_text.empty() || !reading.model) return reading.error_text;
    Diagnostics diagnostics;
    const std::string text = formatted(laid_out(read_any(source, sources, {lossy}, diagnostics)));
    if (std::string error_text = form_complaint(text, sources); !error_text.empty()) return error_text;
    return reading_back(*reading.model, text, sources);
}

}  // namespace

std::string text_complaint(std::string_view bytes) {
    Sources sources;
    const Id<Source> source = sources.add({"fuzzed.grafcet", std::string(bytes)});
    const TextRead reading = read(source, sources, false);
    if (!reading.error_text.empty()) return reading.error_text;
    if (format_of(sources[source].text) != FileFormat::Grafcet) return {};
    Diagnostics diagnostics;
    const tree::File file = parse_file(source, sources, diagnostics);
    if (file.broken || diagnostics.has_errors()) return {};
    const std::string text = formatted(file);
    if (std::string error_text = form_complaint(text, sources); !error_text.empty() || !reading.model)
        return error_text;
    if (std::string error_text = reading_back(*reading.model, text, sources); !error_text.empty()) return error_text;
    if (has_names_of_instances(*reading.model)) return {};
    return reading_back(*reading.model, printed(*reading.model), sources);
}

std::string import_complaint(std::string_view bytes) {
    for (const bool lossy : {false, true})
        if (std::string error_text = imported_complaint(bytes, lossy); !error_text.empty()) return error_text;
    return {};
}

std::string program_complaint(std::string_view bytes) {
    Sources sources;
    Diagnostics diagnostics;
    const std::size_t end = std::min(bytes.find("\n---\n"), bytes.size());  // the properties follow `---`
    auto text = read_program(sources.add({"fuzzed.st", std::string(bytes.substr(0, end))}), sources, diagnostics);
    std::string error_text = result_complaint_of(text.has_value(), diagnostics, sources);
    if (!error_text.empty() || !text) return error_text;
    const auto scan = scan_of(text->program(), diagnostics);
    error_text = result_complaint_of(scan.has_value(), diagnostics, sources);
    if (!error_text.empty() || !scan) return error_text;
    for (const std::string& broken : verify(scan->equations)) error_text += "not well formed: " + broken + '\n';
    const Id<Source> properties =
        sources.add({"fuzzed.yaml", std::string(bytes.substr(std::min(end + 5, bytes.size())))});
    const bool read = read_properties(properties, sources, *text, diagnostics).has_value();
    return error_text + result_complaint_of(read, diagnostics, sources);
}

std::string structured_text_complaint(std::string_view bytes) {
    Sources sources;
    const Id<Source> source = sources.add({"fuzzed.st", std::string(bytes)});
    const auto length = static_cast<std::uint32_t>(bytes.size());
    for (const bool escaped : {false, true}) {
        const st::Text whole{{{source, 0, length / 2}, escaped}, {{source, length / 2, length}, escaped}};
        for (const int part : {0, 1, 2}) {
            st::File file;
            Diagnostics diagnostics;
            const bool read = part == 0   ? st::parse_units(whole, file, sources, diagnostics)
                              : part == 1 ? st::parse_statements(whole, file, sources, diagnostics).has_value()
                                          : st::parse_expression(whole, file, sources, diagnostics).has_value();
            if (std::string error_text = result_complaint_of(read, diagnostics, sources); !error_text.empty())
                return error_text;
        }
    }
    return {};
}

}  // namespace grafverif::fuzz
