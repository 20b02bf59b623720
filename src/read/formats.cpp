// SPDX-License-Identifier: MIT
#include "grafverif/read/formats.hpp"

#include <algorithm>
#include <array>
#include <string>

#include "grafverif/support/messages.hpp"
#include "grafverif/syntax/parse.hpp"
#include "grafverif/syntax/st_tree.hpp"
#include "read/agrafe.hpp"
#include "read/plcopen.hpp"
#include "read/sfc.hpp"
#include "read/sfc_text.hpp"
#include "read/xml.hpp"
#include "syntax/readable.hpp"

namespace grafverif {

namespace {

/// What a file of IEC 61131-3 can begin with, and one of ours cannot.
constexpr std::array first_words = {"PROGRAM", "FUNCTION_BLOCK", "FUNCTION", "VAR_GLOBAL", "TYPE", "CONFIGURATION",
                                    "VAR", "VAR_INPUT", "VAR_OUTPUT", "INITIAL_STEP"};

constexpr std::array our_first_words = {"grafcet", "component", "closed_loop", "include"};

/// Behind blanks, comments of either language and pragmas.
std::string_view without_comments(std::string_view text) {
    for (;;) {
        text.remove_prefix(std::min(text.find_first_not_of(" \t\r\n\f\v"), text.size()));
        std::string_view end;
        if (text.starts_with("//")) end = "\n";
        else if (text.starts_with("/*")) end = "*/";
        else if (text.starts_with("{")) end = "}";
        if (end.empty()) return text;
        const std::size_t at = text.find(end);
        if (at == std::string_view::npos) return {};
        text.remove_prefix(at + end.size());
    }
}

/// `station` of `charts/station.xml`.
std::string stem_of(std::string_view path) {
    path.remove_prefix(std::min(path.find_last_of('/') + 1, path.size()));
    return std::string(path.substr(0, path.find('.')));
}

tree::File broken(Id<Source> source) {
    tree::File file;
    file.source = source;
    file.broken = file.lost = true;
    return file;
}

tree::File read_xml(Id<Source> source, Sources& sources, const ReadOptions& options, Diagnostics& diagnostics) {
    const auto xml = Xml::read(source, sources, diagnostics);
    if (!xml) return broken(source);
    const std::string name = stem_of(sources[source].name);
    if (is(xml->root(), "Grafcet")) return read_agrafe(*xml, name, options.lossy, diagnostics);
    if (is(xml->root(), "project")) {
        Draft draft(source, options.lossy, diagnostics);
        const st::File file = read_plcopen(*xml, sources, draft);
        convert_charts(file, draft);
        return draft.take();
    }
    diagnostics.add(messages::unknown_format(xml->where(xml->root()), xml->root().name()));
    return broken(source);
}

}  // namespace

FileFormat format_of(std::string_view text) {
    if (is_utf16(text)) {   // XML comes so; text is told to come in UTF-8 by whoever reads it
        text.remove_prefix(std::min(text.find_first_not_of(std::string_view("\xFF\xFE\0 \t\r\n", 7)), text.size()));
        return text.starts_with('<') ? FileFormat::Xml : FileFormat::Unknown;
    }
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    const std::string_view first = without_comments(text);
    if (first.starts_with('<')) return FileFormat::Xml;
    if (first.starts_with("(*")) return FileFormat::StructuredText;
    std::size_t length = 0;
    while (length < first.size() && (first[length] == '_' || std::isalpha(static_cast<unsigned char>(first[length])) != 0)) ++length;
    const std::string_view word = first.substr(0, length);
    if (std::ranges::find(our_first_words, word) != our_first_words.end()) return FileFormat::Grafcet;
    const bool structured = std::ranges::find(first_words, st::capitals(word)) != first_words.end();
    return structured ? FileFormat::StructuredText : FileFormat::Unknown;
}

tree::File read_any(Id<Source> source, Sources& sources, const ReadOptions& options, Diagnostics& diagnostics) {
    switch (format_of(sources[source].text)) {
    case FileFormat::Unknown:
    case FileFormat::Grafcet:        return parse_file(source, sources, diagnostics);
    case FileFormat::Xml:            return read_xml(source, sources, options, diagnostics);
    case FileFormat::StructuredText: return read_sfc_text(source, sources, options.lossy, diagnostics);
    }
    return broken(source);
}

}  // namespace grafverif
