// SPDX-License-Identifier: MIT
#include "emit/uppaal/names.hpp"

#include <algorithm>
#include <span>
#include <string_view>

namespace grafverif::uppaal {
namespace {

/// Converts the names of several tables to legal names in one scope, and returns them for one table at a time.
class Scope {
public:
    template <class Entities>
    void add(const Entities& entities) {
        for (const auto& entity : entities) names_.push_back(entity.name);
    }

    void legalise(Target target, const std::unordered_set<std::string>& taken) {
        legal_ = legal_names(target, names_, taken);
        given_ = 0;
    }

    /// Returns the legal names of the next `count` elements, in the order in which they were added.
    std::vector<std::string> take(std::size_t count) {
        const auto first = legal_.begin() + static_cast<std::ptrdiff_t>(given_);
        given_ += count;
        return {first, first + static_cast<std::ptrdiff_t>(count)};
    }

    std::vector<Renaming> changed() const { return renamings(names_, legal_); }
    const std::vector<std::string>& all() const { return legal_; }

private:
    std::vector<std::string> names_ = {}, legal_ = {};
    std::size_t given_ = 0;
};

/// Determines which of the given global variables a template reads or writes. Visits shared subterms once.
class Globals {
public:
    explicit Globals(const Network& network) : network_(network), seen_(network.exprs.size(), false) {}

    std::unordered_set<std::string> of(const Network::Template& automaton, const std::vector<std::string>& variables,
                                       const std::unordered_set<std::string>& requested) {
        for (const Network::Edge& edge : automaton.edges) {
            pending_.push_back(edge.guard);
            push(edge.assignments);
        }
        for (const Network::Procedure& procedure : automaton.procedures) push(procedure.assignments);
        std::unordered_set<std::string> found;
        while (!pending_.empty()) {
            const Id<Expr> id = pending_.back();
            pending_.pop_back();
            if (seen_[id.index]) continue;
            seen_[id.index] = true;
            const Expr& node = network_.exprs[id];
            if (node.op == Op::Variable && requested.contains(variables[static_cast<std::size_t>(node.value)]))
                found.insert(variables[static_cast<std::size_t>(node.value)]);
            const auto operands = network_.exprs.operands(id);
            pending_.insert(pending_.end(), operands.begin(), operands.end());
        }
        return found;
    }

private:
    void push(const std::vector<Network::Assignment>& assignments) {
        for (const auto& [target, value] : assignments) pending_.insert(pending_.end(), {target, value});
    }

    const Network& network_;
    std::vector<bool> seen_;
    std::vector<Id<Expr>> pending_ = {};
};

/// Returns a name without the suffixes that make it legal or unique: `X` for `X`, `X_`, `X_2`, `X__3`.
std::string_view stem(std::string_view name) {
    for (std::size_t before = name.size() + 1; name.size() < before;) {
        before = name.size();
        const std::size_t digits = name.find_last_not_of("0123456789");
        if (digits != std::string_view::npos && digits > 0 && name[digits] == '_') name = name.substr(0, digits);
    }
    return name;
}

/// Returns the global variables whose names may conflict with a local name or function of a template. The result is
/// small even if there are many global variables, because there are few local names.
std::unordered_set<std::string> rivals(const Network& network, const std::vector<std::string>& variables) {
    std::unordered_set<std::string> locals = {std::string(stem(guard_prefix))};
    const auto add = [&](const auto& entities) {
        for (const auto& entity : entities)
            locals.emplace(stem(legal_names(Target::UppaalLocal, std::span(&entity.name, 1)).front()));
    };
    for (const Network::Template& automaton : network.templates) {
        add(automaton.parameters);
        add(automaton.clocks);
        add(automaton.procedures);
        add(automaton.locations);
    }
    std::unordered_set<std::string> found;
    for (const std::string& name : variables)
        if (locals.contains(std::string(stem(name)))) found.insert(name);
    return found;
}

/// Names parameters, clocks and procedures first, and then locations, because queries can refer only to locations.
LocalNames local_names(const Network& network, const Network::Template& automaton, Names& names,
                       const std::unordered_set<std::string>& rivals) {
    Scope inner, places;
    inner.add(automaton.parameters);
    inner.add(automaton.clocks);
    inner.add(automaton.procedures);
    places.add(automaton.locations);

    LocalNames local;
    if (!rivals.empty()) local.taken = Globals(network).of(automaton, names.variables, rivals);
    local.taken.insert(names.channel);
    inner.legalise(Target::UppaalLocal, local.taken);
    local.taken.insert(inner.all().begin(), inner.all().end());
    places.legalise(Target::Uppaal, local.taken);
    local.taken.insert(places.all().begin(), places.all().end());
    local.parameters = inner.take(automaton.parameters.size());
    local.clocks = inner.take(automaton.clocks.size());
    local.procedures = inner.take(automaton.procedures.size());
    local.locations = places.take(automaton.locations.size());
    for (const Scope* scope : {&inner, &places})
        for (const auto& [name, legal] : scope->changed())
            names.changed.push_back({automaton.name + '.' + name, legal});
    return local;
}

}  // namespace

Names names(const Network& network) {
    Scope scope;
    scope.add(network.variables);
    scope.add(network.processes);
    scope.add(network.templates);
    scope.legalise(Target::Uppaal, {});

    Names names;
    names.variables = scope.take(network.variables.size());
    names.processes = scope.take(network.processes.size());
    names.templates = scope.take(network.templates.size());
    names.changed = scope.changed();
    names.channel = "hurry";
    while (std::ranges::find(scope.all(), names.channel) != scope.all().end()) names.channel += '_';
    const std::unordered_set<std::string> contested = rivals(network, names.variables);
    for (const Network::Template& automaton : network.templates)
        names.locals.push_back(local_names(network, automaton, names, contested));
    return names;
}

}  // namespace grafverif::uppaal
