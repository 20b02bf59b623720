// SPDX-License-Identifier: MIT
#include "read/formats.hpp"

#include <algorithm>
#include <array>
#include <string>
#include <vector>

#include "grafverif/support/diagnostic.hpp"
#include "read/agrafe/agrafe.hpp"
#include "read/draft.hpp"
#include "read/plcopen/plcopen.hpp"
#include "read/sfc/sfc.hpp"
#include "read/xml.hpp"
#include "support/messages.hpp"
#include "support/text/encoding.hpp"
#include "syntax/language/parse.hpp"
#include "syntax/language/readable.hpp"
#include "syntax/language/tree.hpp"
#include "syntax/st/parse_st.hpp"
#include "syntax/st/st_tree.hpp"

namespace grafverif {

namespace {

// -- the textual form of Sequential Function Charts (IEC 61131-3, 2.6) --

std::string_view without_marks(std::string_view comment) {
    if (comment.starts_with("//")) return comment.substr(2);
    return comment.substr(2, comment.size() - 4);
}

/// Attaches each comment to the element that follows it, or to the element that precedes it on its line.
void keep_comments(const st::File& file, std::string_view text, Draft& draft) {
    std::vector<Span> places;
    for (const st::Unit& unit : file.units) {
        places.push_back(unit.where);
        for (const st::Variable& one : unit.variables) places.push_back(one.name.where);
        for (const st::Network& network : unit.networks) {
            for (const st::Step& one : network.steps) places.push_back(one.where);
            for (const st::Transition& one : network.transitions) places.push_back(one.where);
        }
    }
    std::ranges::sort(places, {}, &Span::begin);
    for (const st::Comment& comment : file.comments) {
        const auto next = std::ranges::upper_bound(places, comment.where.begin, {}, &Span::begin);
        const bool same_line =
            next != places.begin() &&
            text.substr(std::prev(next)->begin, comment.where.begin - std::prev(next)->begin).find('\n') ==
                std::string_view::npos;
        const Span about = same_line ? *std::prev(next) : next == places.end() ? comment.where : *next;
        for (std::string& line : comment_lines(without_marks(comment.text)))
            draft.comment(about, std::move(line), same_line);
    }
}

/// Reads the charts of `source`. After an error, the result is incomplete.
tree::File read_sfc_text(Id<Source> source, const Sources& sources, bool lossy, Diagnostics& diagnostics) {
    Draft draft(source, lossy, diagnostics);
    const Span whole = without_mark({source, 0, static_cast<std::uint32_t>(sources[source].text.size())}, sources);
    if (!is_readable(whole, sources, diagnostics)) return draft.take();
    st::File file;
    file.source = source;
    if (!st::parse_units({{whole, false}}, file, sources, diagnostics)) return draft.take();
    keep_comments(file, sources[source].text, draft);
    convert_charts(file, draft);
    return draft.take();
}

/// Words that can be the first word of a file in a language of IEC 61131-3, but not of a .grafcet file.
constexpr std::array first_text = {"PROGRAM", "FUNCTION_BLOCK", "FUNCTION",   "VAR_GLOBAL",  "TYPE", "CONFIGURATION",
                                   "VAR",     "VAR_INPUT",      "VAR_OUTPUT", "INITIAL_STEP"};

constexpr std::array our_first_words = {"grafcet", "component", "closed_loop", "include"};

/// Returns the text without white space, comments (`//`, `/* */`) and pragmas (`{ }`) at its start. A comment `(*` is
/// kept, because it identifies Structured Text.
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

/// True if the text begins with `program NAME =`. In IEC 61131-3, `=` cannot follow the name of a program.
bool declares_program(std::string_view text) {
    constexpr std::string_view keyword = "program";
    if (!text.starts_with(keyword)) return false;
    text = without_comments(text.substr(keyword.size()));
    text.remove_prefix(std::min(text.find_first_of(" \t\r\n\f\v=/("), text.size()));
    return without_comments(text).starts_with('=');
}

/// Returns the file name without folder and extension, for example `station` for `charts/station.xml`.
std::string stem_of(std::string_view path) {
    path.remove_prefix(std::min(path.find_last_of('/') + 1, path.size()));
    return std::string(path.substr(0, path.find('.')));
}

tree::File broken(Id<Source> source) {
    tree::File file;
    file.source = source;
    file.broken = file.incomplete = true;
    return file;
}

tree::File read_xml(Id<Source> source, Sources& sources, const ImportOptions& options, Diagnostics& diagnostics) {
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
    if (is_utf16(text)) return format_of(utf8_of_utf16(text));
    if (text.starts_with("\xEF\xBB\xBF")) text.remove_prefix(3);
    const std::string_view first = without_comments(text);
    if (first.starts_with('<')) return FileFormat::Xml;
    if (first.starts_with("(*")) return FileFormat::StructuredText;
    std::size_t length = 0;
    while (length < first.size() &&
           (first[length] == '_' || std::isalpha(static_cast<unsigned char>(first[length])) != 0))
        ++length;
    const std::string_view word = first.substr(0, length);
    if (std::ranges::find(our_first_words, word) != our_first_words.end() || declares_program(first))
        return FileFormat::Grafcet;
    const bool structured = std::ranges::find(first_text, st::capitals(word)) != first_text.end();
    return structured ? FileFormat::StructuredText : FileFormat::Unknown;
}

tree::File read_any(Id<Source> source, Sources& sources, const ImportOptions& options, Diagnostics& diagnostics) {
    const FileFormat format = format_of(sources[source].text);
    if (format != FileFormat::Xml) make_utf8(source, sources, diagnostics);
    switch (format) {
    case FileFormat::Unknown:
    case FileFormat::Grafcet: return parse_file(source, sources, diagnostics, options.stop);
    case FileFormat::Xml: return read_xml(source, sources, options, diagnostics);
    case FileFormat::StructuredText: return read_sfc_text(source, sources, options.lossy, diagnostics);
    }
    return broken(source);
}

}  // namespace grafverif
