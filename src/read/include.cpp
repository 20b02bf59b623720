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

/// `written` as seen from the file named `from`. Lexical only: no file is touched.
std::string joined(const std::string& from, const std::string& written) {
    return (std::filesystem::path(from).parent_path() / written).lexically_normal().generic_string();
}

enum class State { Open, Done };

/// A file whose includes are being followed; the chain of open files is explicit, so that its length is no matter.
struct Open {
    tree::File file = {};
    std::string path = {};
    std::size_t next = 0;   ///< declaration to look at
};

}  // namespace

std::vector<tree::File> parse_with_includes(Id<Source> file, Sources& sources, const ReadContext& context,
                                            bool& missing, Diagnostics& diagnostics) {
    std::vector<tree::File> files;
    std::unordered_map<std::string, State> states;
    std::vector<Open> open;
    const auto enter = [&](Id<Source> source, std::string path) {
        states[path] = State::Open;
        open.push_back({read_any(source, sources, {context.lossy}, diagnostics), std::move(path), 0});
    };
    enter(file, std::filesystem::path(sources[file].name).lexically_normal().generic_string());
    while (!open.empty()) {
        Open& top = open.back();
        if (top.next == top.file.declarations.size()) {
            states[top.path] = State::Done;
            files.push_back(std::move(top.file));
            open.pop_back();
            continue;
        }
        const auto* include = std::get_if<tree::Include>(&top.file.declarations[top.next++]);
        if (include == nullptr) continue;
        const std::string path = joined(sources[top.file.source].name, include->path);
        const auto known = states.find(path);
        if (known != states.end()) {
            if (known->second == State::Open) diagnostics.add(messages::include_cycle(include->where, path));
            continue;
        }
        std::string why = "there is no way to other files here";
        auto text = context.load ? context.load(path, why) : std::nullopt;
        if (!text) {
            missing = true;
            diagnostics.add(messages::cannot_include(include->where, include->path, why));
            states[path] = State::Done;
            continue;
        }
        enter(sources.add({path, std::move(*text)}), path);
    }
    return files;
}

}  // namespace grafverif
