// SPDX-License-Identifier: MIT
#include "lsp/library.hpp"

#include <string>
#include <variant>

#include "pipeline/components.hpp"
#include "read/program/program.hpp"
#include "syntax/language/parse.hpp"
#include "syntax/resolve/resolve.hpp"

namespace grafverif::lsp {

namespace {

struct Library {
    References references = {};
    Files files = {};
    std::shared_ptr<Parsed> blocks = {};  ///< the standard function blocks

    Library() {
        Sources sources;
        Diagnostics diagnostics;
        for (const LibraryEntry& entry : library()) {
            auto parsed = std::make_shared<Parsed>();
            parsed->path = entry.path;
            parsed->text = std::make_shared<const Text>(std::string(entry.text));
            parsed->tree = parse_file(sources.add({parsed->path, std::string(entry.text)}), sources, diagnostics);
            for (const tree::Declaration& declaration : parsed->tree.declarations)
                if (const auto* component = std::get_if<tree::Component>(&declaration))
                    resolve_component(parsed->tree, *component, diagnostics, Recorder(&references));
            files.push_back(std::move(parsed));
        }
        blocks = std::make_shared<Parsed>();
        blocks->path = standard_blocks_path;
        blocks->text = std::make_shared<const Text>(std::string(standard_blocks_text()));
        blocks->language = TextLanguage::StructuredText;
    }
};

const Library& known_library() {
    static const Library known;
    return known;
}

}  // namespace

std::shared_ptr<const Parsed> library_file(std::string_view path) {
    if (path == standard_blocks_path) return known_library().blocks;
    for (const auto& file : known_library().files)
        if (file->path == path) return file;
    return nullptr;
}

const Names& library_names() {
    static const Names names({{&known_library().references, known_library().files}});
    return names;
}

}  // namespace grafverif::lsp
