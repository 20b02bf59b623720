// SPDX-License-Identifier: MIT
#include "read/program/program.hpp"

#include <algorithm>
#include <utility>

#include "read/plcopen/plcopen.hpp"
#include "read/program/incomplete.hpp"
#include "read/program/scope.hpp"
#include "read/program/standard_blocks.hpp"
#include "support/messages_program.hpp"
#include "syntax/language/readable.hpp"

namespace grafverif {

struct ProgramText::Inside {
    st::File file = {};
    std::optional<program::Reader> reader = {};
};

ProgramText::ProgramText() : inside_(std::make_unique<Inside>()) {}
ProgramText::ProgramText(ProgramText&&) noexcept = default;
ProgramText& ProgramText::operator=(ProgramText&&) noexcept = default;
ProgramText::~ProgramText() = default;

const Program& ProgramText::program() const { return inside_->reader->program; }

std::optional<Id<Program::Node>> ProgramText::condition(const st::Text& text, const Sources& sources,
                                                        Diagnostics& diagnostics) {
    const auto root = st::parse_property(text, inside_->file, sources, diagnostics);
    if (!root) return {};
    inside_->reader->diagnostics = &diagnostics;
    return inside_->reader->condition(*root);
}

std::string_view standard_blocks_text() { return program::standard_blocks; }

namespace {

/// Removes those standard function blocks for which the file has its own definition. In a file with charts, such a
/// definition is an error that the reader reports, because the ACTION_CONTROL blocks use the standard function blocks.
void remove_redefined_blocks(st::File& file, std::size_t user, Diagnostics& diagnostics) {
    const auto end = file.units.begin() + static_cast<std::ptrdiff_t>(user);
    if (std::any_of(file.units.begin(), end, [](const st::Unit& unit) { return !unit.networks.empty(); })) return;
    const auto removed = std::remove_if(end, file.units.end(), [&](const st::Unit& standard) {
        const auto own = std::find_if(file.units.begin(), end,
                                      [&](const st::Unit& unit) { return unit.name.word == standard.name.word; });
        if (own == end) return false;
        diagnostics.add(messages::not_standard(
            own->name.where,
            "a unit with the name of the standard function block `" + std::string(file.text(own->name)) + "`",
            "a replacement of the standard function block"));
        return true;
    });
    file.units.erase(removed, file.units.end());
}

/// Parses the standard function blocks, and returns a reader that has resolved the names of `file`; empty after an
/// error.
std::optional<program::Reader> resolved(st::File& file, Sources& sources, Diagnostics& diagnostics,
                                        const Recorder& record) {
    const std::size_t user = file.units.size();
    const std::string standard(program::standard_blocks);
    const Id<Source> blocks = sources.add({std::string(standard_blocks_path), standard});
    if (!st::parse_programs({{{blocks, 0, static_cast<std::uint32_t>(standard.size())}, false}}, file, sources,
                            diagnostics))
        return {};
    remove_redefined_blocks(file, user, diagnostics);
    std::vector<program::UnitCharts> charts = program::read_charts(file, sources, diagnostics);
    std::optional<program::Reader> reader(std::in_place, file, sources, diagnostics, std::move(charts), record);
    reader->read(user);
    return reader;
}

}  // namespace

std::optional<ProgramText> read_program(Id<Source> source, Sources& sources, Diagnostics& diagnostics,
                                        const Recorder& record) {
    const std::size_t errors = diagnostics.errors();
    make_utf8(source, sources, diagnostics);
    const Span whole = without_mark({source, 0, static_cast<std::uint32_t>(sources[source].text.size())}, sources);
    if (!is_readable(whole, sources, diagnostics)) return {};
    const std::string_view content = std::string_view(sources[source].text).substr(whole.begin);
    ProgramText text;
    st::File& file = text.inside_->file;
    const std::size_t first = content.find_first_not_of(" \t\r\n");
    if (first < content.size() && content[first] == '<') {
        const std::optional<Xml> xml = Xml::read(source, sources, diagnostics);
        if (!xml) return {};
        if (!is(xml->root(), "project")) {
            diagnostics.add(messages::not_in_program(xml->where(xml->root()), "an XML document other than PLCopen XML",
                                                     "export PLCopen XML or Structured Text"));
            return {};
        }
        file = read_plcopen_program(*xml, sources, diagnostics);
    } else {
        file.source = source;
        st::parse_programs({{whole, false}}, file, sources, diagnostics);
        if (diagnostics.errors() != errors && record.is_recording()) {
            Diagnostics ignored;  // diagnostics of an incomplete text would be misleading
            program::add_incomplete_units(whole, file, sources);
            resolved(file, sources, ignored, record);
        }
    }
    if (diagnostics.errors() != errors) return {};
    text.inside_->reader = resolved(file, sources, diagnostics, record);
    if (diagnostics.errors() != errors) return {};
    return text;
}

}  // namespace grafverif
