// SPDX-License-Identifier: MIT
#include "lsp/workspace.hpp"

#include <algorithm>
#include <set>
#include <utility>

#include "pipeline/files.hpp"
#include "pipeline/models.hpp"
#include "read/formats.hpp"
#include "read/program/program.hpp"
#include "rpc/uri.hpp"
#include "syntax/language/parse.hpp"

namespace grafverif::lsp {

namespace {

constexpr std::size_t most_entries = 20'000;  ///< maximum number of files and folders to visit in the workspace

/// Maximum size in bytes of a file that is not open and is searched for includes of open documents; larger files are
/// ignored.
constexpr std::size_t largest_scanned = 4U << 20U;

/// True if the text may refer to other files.
bool may_refer(std::string_view text) {
    return text.find("include") != std::string_view::npos || text.find("program") != std::string_view::npos;
}

/// Parses a text in Structured Text: adds its comments to `parsed`, and determines if it has syntax errors.
void parse_structured_text(Parsed& parsed) {
    const std::string& text = parsed.text->bytes();
    Sources sources;
    Diagnostics diagnostics;
    st::File file;
    file.source = sources.add({parsed.path, text});
    const Span whole = {file.source, 0, static_cast<std::uint32_t>(text.size())};
    parsed.broken = !st::parse_programs({{whole, false}}, file, sources, diagnostics);
    for (st::Comment& comment : file.comments) {
        const std::size_t line = text.rfind('\n', comment.where.begin);
        const std::size_t begin = line == std::string::npos ? 0 : line + 1;
        const bool own_line = text.find_first_not_of(" \t", begin) == comment.where.begin;
        parsed.tree.comments.push_back({std::move(comment.text), comment.where, own_line});
    }
}

}  // namespace

TextLanguage language_of(const std::string& path, std::string_view text) {
    switch (format_of(text)) {
    case FileFormat::Grafcet: return TextLanguage::Grafcet;
    case FileFormat::Xml: return TextLanguage::Other;
    case FileFormat::StructuredText: return TextLanguage::StructuredText;
    case FileFormat::Unknown: break;
    }
    return path.ends_with(".st") ? TextLanguage::StructuredText : TextLanguage::Grafcet;
}

// -- open documents ---------------------------------------------------------------------------------------------------

std::string Workspace::key(const std::string& path) const {
    std::string known_as = identity_of_existing(path);
    return known_as.empty() ? path : known_as;
}

void Workspace::open(const std::string& uri, std::int64_t version, const std::string& text) {
    const std::string path = rpc::path_of_uri(uri);
    auto nothing = std::make_shared<const Text>(std::string());
    OpenText fresh{uri, path, identity_of_existing(path), version, std::move(nothing), true};
    OpenText& open = open_.insert_or_assign(uri, std::move(fresh)).first->second;
    open.text = std::make_shared<const Text>(text);
    open.out_of_step = false;
}

void Workspace::change(const std::string& uri, std::int64_t version, const std::vector<Change>& changes) {
    const auto found = open_.find(uri);
    if (found == open_.end()) return;
    OpenText& open = found->second;
    open.version = version;
    try {
        for (const Change& change : changes) {
            open.text = std::make_shared<const Text>(changed(*open.text, change));
            open.out_of_step = open.out_of_step && change.range;
        }
    } catch (const std::bad_alloc&) {
        open.out_of_step = true;
        throw;
    }
}

void Workspace::close(const std::string& uri) {
    open_.erase(uri);
    disk_.erase(rpc::path_of_uri(uri));
}

const OpenText* Workspace::find(const std::string& uri) const {
    const auto found = open_.find(uri);
    return found == open_.end() ? nullptr : &found->second;
}

const OpenText* Workspace::open_at(const std::string& path) const {
    for (const auto& [uri, open] : open_)
        if (open.path == path) return &open;
    const std::string wanted = identity_of_existing(path);
    if (wanted.empty()) return nullptr;
    for (const auto& [uri, open] : open_)
        if (open.identity == wanted) return &open;
    return nullptr;
}

std::string Workspace::uri_of(const std::string& path) const {
    const OpenText* const open = open_at(path);
    return open != nullptr ? open->uri : rpc::uri_of_path(path);
}

std::string Workspace::shown(const std::string& path) const {
    const OpenText* const open = open_at(path);
    return open != nullptr ? open->path : path;
}

std::vector<OpenText> Workspace::open_texts() const {
    std::vector<OpenText> all;
    for (const auto& [uri, open] : open_) all.push_back(open);
    return all;
}

// -- files on disk ----------------------------------------------------------------------------------------------------

bool Workspace::refresh() {
    for (auto& [uri, open] : open_) open.identity = identity_of_existing(open.path);
    if (!watch_.changed()) return false;
    watch_.clear();
    disk_.clear();
    scanned_ = false;
    return true;
}

std::shared_ptr<const Text> Workspace::text(const std::string& path) {
    if (const OpenText* const open = open_at(path)) return open->text;
    if (const auto known = disk_.find(path); known != disk_.end()) return known->second;
    watch_.note(path);
    std::string why;
    auto content = within_.read(path, why);
    auto text = content ? std::make_shared<const Text>(std::move(*content)) : nullptr;
    return disk_.emplace(path, std::move(text)).first->second;
}

std::shared_ptr<const Parsed> Workspace::parsed(const std::string& path) {
    auto text = this->text(path);
    if (text == nullptr) return nullptr;
    std::shared_ptr<const Parsed>& known = parsed_[path];
    if (known != nullptr && (known->text == text || known->text->bytes() == text->bytes())) return known;
    auto parsed = std::make_shared<Parsed>();
    parsed->path = path;
    parsed->text = text;
    parsed->language = language_of(path, text->bytes());
    parsed->is_renamable = parsed->language != TextLanguage::Other;
    if (parsed->language == TextLanguage::StructuredText) parse_structured_text(*parsed);
    if (parsed->language == TextLanguage::Grafcet) {
        Sources sources;
        Diagnostics diagnostics;
        parsed->tree = parse_file(sources.add({path, text->bytes()}), sources, diagnostics);
        parsed->broken = parsed->tree.broken;
    }
    return known = parsed;
}

// -- inverse includes -------------------------------------------------------------------------------------------------

std::vector<std::string> Workspace::includes(const Parsed& file) {
    ReadContext context;
    context.folders = include_folders_;
    context.identity = [this](const std::string& path) {
        std::string known_as = identity_of_existing(path);
        return known_as.empty() && open_at(path) != nullptr ? path : known_as;
    };
    std::vector<std::string> paths;
    for (const tree::Declaration& declaration : file.tree.declarations)
        if (const auto* include = std::get_if<tree::Include>(&declaration))
            paths.push_back(path_of_include(file.path, include->path, context));
        else if (const auto* program = std::get_if<tree::PlcProgram>(&declaration))
            paths.push_back(path_of_include(file.path, program->path, context));
    return paths;
}

void Workspace::scan() {
    if (scanned_) return;
    std::size_t most = most_entries;
    std::set<std::string> files;
    for (const std::string& folder : folders_) {
        FilesBelow below = files_below(folder, ".grafcet", most, stop_);
        watch_.note(below.folders);
        files.insert(below.files.begin(), below.files.end());
    }
    cut_short_ = most == 0;
    files_.assign(files.begin(), files.end());
    scanned_ = true;
}

std::vector<std::string> Workspace::roots(const std::string& path) {
    scan();
    std::set<std::string> candidates(files_.begin(), files_.end());
    for (const auto& [uri, open] : open_) candidates.insert(open.path);
    // Maps the key of each included file to the files that include it.
    std::map<std::string, std::vector<std::string>> includers;
    std::map<std::string, std::string> keys;
    for (const std::string& candidate : candidates) {
        const auto text = this->text(candidate);
        if (text == nullptr || text->bytes().size() > largest_scanned) continue;
        if (!may_refer(text->bytes())) continue;
        for (const std::string& included : includes(*parsed(candidate))) includers[key(included)].push_back(candidate);
    }
    std::vector<std::string> found = {path};
    std::set<std::string> seen = {key(path)};
    for (std::size_t next = 0; next < found.size(); ++next)
        for (const std::string& includer : includers[key(found[next])])
            if (seen.insert(key(includer)).second) found.push_back(includer);
    return found;
}

// -- parsing ----------------------------------------------------------------------------------------------------------

ParseResult Workspace::reading(const std::string& path, Inputs& inputs, References& references) {
    ParseResult reading;
    const auto main = text(path);
    inputs.emplace_back(path, main);
    if (main == nullptr) return reading;
    const Id<Source> file = reading.sources.add({path, main->bytes()});
    if (language_of(path, main->bytes()) == TextLanguage::StructuredText) {
        read_program(file, reading.sources, reading.diagnostics, Recorder(&references));
        return reading;
    }
    const Reach reach(path, include_folders_, within_);
    ReadContext context = context_of(reach, include_folders_, false);
    context.references = &references;
    context.load = [&](const std::string& included, std::string& why) -> std::optional<std::string> {
        const auto content = text(included);
        inputs.emplace_back(included, content);
        auto on_disk = reach.read(included, why);
        // The file exists, but its folder is not permitted for included files.
        if (!on_disk && !identity_of_existing(included).empty()) return {};
        if (content == nullptr) return on_disk;
        return content->bytes();
    };
    context.identity = [this](const std::string& included) {
        std::string known_as = identity_of_existing(included);
        return known_as.empty() && open_at(included) != nullptr ? included : known_as;
    };
    reading.model = read_text(file, reading.sources, context, reading.diagnostics);
    return reading;
}

bool Workspace::holds(const Inputs& inputs) {
    return std::ranges::all_of(inputs, [this](const auto& input) { return text(input.first) == input.second; });
}

}  // namespace grafverif::lsp
