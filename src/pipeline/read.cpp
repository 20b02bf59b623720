// SPDX-License-Identifier: MIT
// Parses a text, the files that it includes, and the components of the library that it uses, and returns a Model.
#include <sstream>
#include <utility>

#include "grafverif/grafverif.hpp"
#include "pipeline/components.hpp"
#include "pipeline/files.hpp"
#include "pipeline/models.hpp"
#include "read/text.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

ParseResult read(const std::string& path, std::optional<std::string> text, const std::string& why,
                 const ReadOptions& options) {
    ParseResult reading;
    if (!text) {
        reading.diagnostics.add(messages::cannot_read(path, why));
        return reading;
    }
    const Id<Source> file = reading.sources.add({path, std::move(*text)});
    const Reach reach(path, options.include_folders);
    ReadContext context = context_of(reach, options.include_folders, options.lossy);
    context.constants.insert(options.constants.begin(), options.constants.end());
    if (options.load) context.load = options.load, context.identity = {};
    reading.model = read_text(file, reading.sources, context, reading.diagnostics);
    return reading;
}

}  // namespace

ReadContext context_of(const Reach& reach, const std::vector<std::string>& folders, bool lossy) {
    const auto load = [&reach](const std::string& included, std::string& why) { return reach.read(included, why); };
    return {load, library(), lossy, identity_of_existing, folders, {}};
}

ParseResult read_file(const std::string& path, const ReadOptions& options) {
    std::string why;
    auto text = content_of_file(path, why);
    return read(path, std::move(text), why, options);
}

ParseResult read_string(std::string text, const std::string& name, const ReadOptions& options) {
    return read(name, std::move(text), {}, options);
}

std::string ParseResult::diagnostics_text() const {
    std::ostringstream out;
    render_text(diagnostics.all(), sources, Colour::Plain, out);
    return std::move(out).str();
}

namespace {

template <class T>
std::optional<Id<T>> find(const Table<T>& table, std::string_view name) {
    for (const Id<T> id : table.ids())
        if (table[id].name == name) return id;
    return {};
}

}  // namespace

std::optional<Id<Chart>> find_chart(const Model& model, std::string_view name) { return find(model.charts, name); }
std::optional<Id<ClosedLoop>> find_loop(const Model& model, std::string_view name) { return find(model.loops, name); }

}  // namespace grafverif
