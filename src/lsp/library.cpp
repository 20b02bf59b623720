// SPDX-License-Identifier: MIT
#include "lsp/library.hpp"

#include <functional>
#include <map>
#include <string>
#include <utility>

#include "pipeline/components.hpp"
#include "read/text.hpp"
#include "syntax/language/parse.hpp"

namespace grafverif::lsp {

namespace {

using LibraryFiles = std::map<std::string, std::shared_ptr<const Parsed>, std::less<>>;

const LibraryFiles& library_files() {
    static const LibraryFiles files = [] {
        LibraryFiles all;
        for (const LibraryEntry& entry : library()) {
            auto parsed = std::make_shared<Parsed>();
            parsed->path = entry.path;
            parsed->text = std::make_shared<const Text>(std::string(entry.text));
            Sources sources;
            Diagnostics diagnostics;
            parsed->tree = parse_file(sources.add({parsed->path, std::string(entry.text)}), sources, diagnostics);
            all.emplace(entry.name, std::move(parsed));
        }
        return all;
    }();
    return files;
}

}  // namespace

std::shared_ptr<const Parsed> library_file(std::string_view component) {
    const auto found = library_files().find(component);
    return found == library_files().end() ? nullptr : found->second;
}

const Names& library_names() {
    static const Names names = [] {
        Files all;
        for (const auto& [name, file] : library_files()) all.push_back(file);
        return Names(std::move(all));
    }();
    return names;
}

}  // namespace grafverif::lsp
