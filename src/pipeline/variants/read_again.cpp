// SPDX-License-Identifier: MIT
#include "pipeline/variants/read_again.hpp"

#include "pipeline/components.hpp"
#include "pipeline/files.hpp"
#include "read/text.hpp"

namespace grafverif {

std::optional<Model> read_again(Id<Source> main, const std::map<std::string, std::string>& texts, const Sources& from,
                                Sources& to, const ReadOptions& read, Diagnostics& diagnostics) {
    std::map<std::string, std::string> known;
    for (const Source& source : from) known.emplace(source.name, source.text);
    for (const auto& [name, text] : texts) known[name] = text;
    const Id<Source> file = to.add({from[main].name, known[from[main].name]});
    const auto load = [&](const std::string& path, std::string& why) -> std::optional<std::string> {
        if (const auto found = known.find(path); found != known.end()) return found->second;
        return why = "the file was not read before", std::nullopt;
    };
    ReadContext context{load, library(), read.lossy, identity_of_existing, read.include_folders, {}};
    context.constants.insert(read.constants.begin(), read.constants.end());
    return read_text(file, to, context, diagnostics);
}

}  // namespace grafverif
