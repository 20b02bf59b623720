// SPDX-License-Identifier: MIT
#include "lsp/board.hpp"

#include <algorithm>
#include <set>
#include <utility>

namespace grafverif::lsp {

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
        root->places = std::make_shared<const Places>(root->reading.sources, path,
                                                      [&](const std::string& each) { return workspace.shown(each); });
        root->typed = told(root->reading.diagnostics, *root->places);
        entry = {root, {}};
        fresh.push_back(std::move(root));
    }
    return fresh;
}

std::shared_ptr<const Root> Board::root(const std::string& path) const {
    const auto found = entries_.find(path);
    return found == entries_.end() ? nullptr : found->second.root;
}

std::vector<std::shared_ptr<const Root>> Board::roots() const {
    std::vector<std::shared_ptr<const Root>> all;
    for (const auto& [path, entry] : entries_) all.push_back(entry.root);
    return all;
}

bool Board::is_current(const Root& root) const {
    const auto found = entries_.find(root.path);
    return found != entries_.end() && found->second.root->number == root.number;
}

void Board::add(const Root& root, const std::string& source, std::vector<Told> told) {
    if (is_current(root)) entries_.at(root.path).added[source] = std::move(told);
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
