// SPDX-License-Identifier: MIT
#include "read/include.hpp"

#include <filesystem>
#include <string>
#include <unordered_map>
#include <unordered_set>

#include "grafverif/support/messages.hpp"
#include "grafverif/read/formats.hpp"

namespace grafverif {

namespace {

std::string identity(const std::string& path, const ReadContext& context) {
    return context.identity ? context.identity(path) : path;
}

/// `folder`/`written`, without detours where that leads to the same file: `link/../a` need not be `a`.
std::string joined(const std::filesystem::path& folder, const std::string& written, const ReadContext& context) {
    const std::filesystem::path path = folder / written;
    const std::string shorter = path.lexically_normal().generic_string();
    return identity(shorter, context) == identity(path.generic_string(), context) || !context.identity ? shorter : path.generic_string();
}

/// The file that `written` means in the file named `from`: the first that is there, or else the first looked for.
std::string located(const std::string& from, const std::string& written, const ReadContext& context) {
    const std::string beside = joined(std::filesystem::path(from).parent_path(), written, context);
    if (!context.identity || !context.identity(beside).empty()) return beside;
    for (const std::string& folder : context.folders)
        if (const std::string path = joined(folder, written, context); !context.identity(path).empty()) return path;
    return beside;
}

enum class State { Open, Done };

/// A file whose includes are being followed; the chain of open files is explicit, so that its length is no matter.
struct Open {
    tree::File file = {};
    std::string identity = {};
    std::size_t next = 0;   ///< declaration to look at
};

}  // namespace

std::vector<tree::File> parse_with_includes(Id<Source> file, Sources& sources, const ReadContext& context,
                                            bool& missing, Diagnostics& diagnostics) {
    std::vector<tree::File> files;
    std::unordered_map<std::string, State> states;
    std::vector<Open> open;
    const auto enter = [&](Id<Source> source, std::string identity) {
        states[identity] = State::Open;
        open.push_back({read_any(source, sources, {context.lossy}, diagnostics), std::move(identity), 0});
    };
    const std::string main = sources[file].name;
    enter(file, identity(context.identity ? main : std::filesystem::path(main).lexically_normal().generic_string(), context));
    while (!open.empty()) {
        Open& top = open.back();
        if (top.next == top.file.declarations.size()) {
            states[top.identity] = State::Done;
            files.push_back(std::move(top.file));
            open.pop_back();
            continue;
        }
        const auto* include = std::get_if<tree::Include>(&top.file.declarations[top.next++]);
        if (include == nullptr) continue;
        const std::string path = located(sources[top.file.source].name, include->path, context);
        const std::string known_as = identity(path, context);
        const auto known = states.find(known_as.empty() ? path : known_as);
        if (known != states.end()) {
            if (known->second == State::Open) diagnostics.add(messages::include_cycle(include->where, path));
            continue;
        }
        std::string why = "there is no way to other files here";
        auto text = context.load ? context.load(path, why) : std::nullopt;
        if (!text) {
            missing = true;
            diagnostics.add(messages::cannot_include(include->where, include->path, why));
            states[known_as.empty() ? path : known_as] = State::Done;
            continue;
        }
        enter(sources.add({path, std::move(*text)}), known_as);
    }
    return files;
}

}  // namespace grafverif
