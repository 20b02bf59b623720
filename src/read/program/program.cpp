// SPDX-License-Identifier: MIT
#include "read/program/program.hpp"

#include <utility>

#include "read/plcopen/plcopen.hpp"
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

std::optional<ProgramText> read_program(Id<Source> source, Sources& sources, Diagnostics& diagnostics) {
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
        if (!st::parse_programs({{whole, false}}, file, sources, diagnostics)) return {};
    }
    if (diagnostics.errors() != errors) return {};
    const std::size_t user = file.units.size();
    const std::string standard(program::standard_blocks);
    const Id<Source> blocks = sources.add({"standard function blocks", standard});
    if (!st::parse_programs({{{blocks, 0, static_cast<std::uint32_t>(standard.size())}, false}}, file, sources,
                            diagnostics))
        return {};
    std::vector<program::UnitCharts> charts = program::read_charts(file, sources, diagnostics);
    text.inside_->reader.emplace(file, sources, diagnostics, std::move(charts));
    text.inside_->reader->read(user);
    if (diagnostics.errors() != errors) return {};
    return text;
}

}  // namespace grafverif
