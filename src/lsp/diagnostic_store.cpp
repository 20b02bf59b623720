// SPDX-License-Identifier: MIT
#include "lsp/diagnostic_store.hpp"

#include <algorithm>
#include <new>
#include <optional>
#include <set>
#include <system_error>
#include <utility>

#include "support/memory_reserve.hpp"
#include "support/messages.hpp"
#include "support/messages_choice.hpp"

namespace grafverif::lsp {

namespace {

/// Executes `work`. Returns an exception of type std::bad_alloc or std::system_error as a diagnostic.
template <class Work>
std::optional<Diagnostic> failure_of(const std::string& path, const Work& work) {
    try {
        const ReserveUse use(false);
        return work(), std::nullopt;
    } catch (const std::bad_alloc&) {
        return messages::out_of_memory({});
    } catch (const std::system_error& failure) {
        return messages::cannot_read(path, failure.what());
    }
}

}  // namespace

std::vector<std::shared_ptr<const Root>> DiagnosticStore::look(Workspace& workspace) {
    std::set<std::string> wanted;
    for (const OpenText& open : workspace.open_texts()) {
        wanted.insert(open.path);
        failure_of(open.path, [&] {  // an error is ignored, because the function `read` reports it later
            for (std::string& root : workspace.roots(open.path)) wanted.insert(std::move(root));
        });
    }
    std::erase_if(entries_, [&](const auto& entry) { return !wanted.contains(entry.first); });
    std::vector<std::shared_ptr<const Root>> fresh;
    for (const std::string& path : wanted) {
        bool holds = false;
        if (const auto known = root(path)) failure_of(path, [&] { holds = workspace.holds(known->inputs); });
        if (holds) continue;
        fresh.push_back(read(path, workspace));
        entries_.insert_or_assign(path, Entry{fresh.back(), {}});
    }
    return fresh;
}

std::shared_ptr<const Root> DiagnosticStore::read(const std::string& path, Workspace& workspace) {
    auto root = std::make_shared<Root>();
    root->path = path;
    root->number = ++readings_;
    const auto shown = [&](const std::string& each) { return workspace.shown(each); };
    const OpenText* const open = workspace.open_at(path);
    const auto failure =
        open != nullptr && open->out_of_step ? std::optional(messages::out_of_step()) : failure_of(path, [&] {
            root->reading = workspace.reading(path, root->inputs, root->references);
            root->places = std::make_shared<const Places>(root->reading.sources, path, shown);
            root->typed = lsp_diagnostics(root->reading.diagnostics, *root->places);
        });
    if (!failure) return root;
    Diagnostics diagnostics;
    diagnostics.add(*failure);
    root->reading = {};
    root->references = {};
    // A null text always counts as changed, so the next call reads the document again.
    root->inputs = {{path, nullptr}};
    root->places = std::make_shared<const Places>(root->reading.sources, path, shown);
    root->typed = lsp_diagnostics(diagnostics, *root->places);
    return root;
}

std::shared_ptr<const Root> DiagnosticStore::root(const std::string& path) const {
    const auto found = entries_.find(path);
    return found == entries_.end() ? nullptr : found->second.root;
}

std::vector<std::shared_ptr<const Root>> DiagnosticStore::roots() const {
    std::vector<std::shared_ptr<const Root>> all;
    for (const auto& [path, entry] : entries_) all.push_back(entry.root);
    return all;
}

bool DiagnosticStore::is_current(const Root& root) const {
    const auto found = entries_.find(root.path);
    return found != entries_.end() && found->second.root->number == root.number;
}

void DiagnosticStore::add(const Root& root, const std::string& source, std::vector<LspDiagnostic> source_diagnostics) {
    if (is_current(root)) entries_.at(root.path).added[source] = std::move(source_diagnostics);
}

std::map<std::string, std::vector<LspDiagnostic>> DiagnosticStore::all() const {
    std::map<std::string, std::set<LspDiagnostic>> found;
    const auto take = [&](const std::vector<LspDiagnostic>& source_diagnostics) {
        for (const LspDiagnostic& one : source_diagnostics) found[one.where.path].insert(one);
    };
    for (const auto& [path, entry] : entries_) {
        take(entry.root->typed);
        for (const auto& [source, source_diagnostics] : entry.added) take(source_diagnostics);
    }
    std::map<std::string, std::vector<LspDiagnostic>> sorted;
    for (const auto& [path, source_diagnostics] : found)
        sorted[path].assign(source_diagnostics.begin(), source_diagnostics.end());
    return sorted;
}

}  // namespace grafverif::lsp
