// SPDX-License-Identifier: MIT
#include "lsp/board.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace grafverif::lsp {

Places Root::places(const Workspace& workspace) const {
    return {reading.sources, path, [&](const std::string& each) { return workspace.shown(each); }};
}

std::vector<std::shared_ptr<const Root>> Board::look(Workspace& workspace) {
    std::set<std::string> wanted;
    for (const OpenText& open : workspace.open_texts())
        for (std::string& root : workspace.roots(open.path)) wanted.insert(std::move(root));
    std::erase_if(entries_, [&](const auto& entry) { return !wanted.contains(entry.first); });
    std::vector<std::shared_ptr<const Root>> fresh;
    for (const std::string& path : wanted) {
        Entry& entry = entries_[path];
        if (entry.root != nullptr && workspace.holds(entry.root->inputs)) continue;
        auto root = std::make_shared<Root>();
        root->path = path;
        root->number = ++readings_;
        root->reading = workspace.reading(path, root->inputs);
        root->typed = told(root->reading.diagnostics, root->places(workspace));
        entry = {root, {}};
        fresh.push_back(std::move(root));
    }
    return fresh;
}

std::shared_ptr<const Root> Board::root(const std::string& path) const {
    const auto found = entries_.find(path);
    return found == entries_.end() ? nullptr : found->second.root;
}

void Board::add(const Root& root, const std::string& source, std::vector<Told> told) {
    const auto found = entries_.find(root.path);
    if (found == entries_.end() || found->second.root->number != root.number) return;
    found->second.added[source] = std::move(told);
}

std::map<std::string, std::vector<Told>> Board::all() const {
    std::map<std::string, std::set<Told>> found;
    const auto take = [&](const std::vector<Told>& told) {
        for (const Told& one : told) found[one.where.path].insert(one);
    };
    for (const auto& [path, entry] : entries_) {
        take(entry.root->typed);
        for (const auto& [source, told] : entry.added) take(told);
    }
    std::map<std::string, std::vector<Told>> sorted;
    for (const auto& [path, told] : found) sorted[path].assign(told.begin(), told.end());
    return sorted;
}

}  // namespace grafverif::lsp
