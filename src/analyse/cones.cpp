// SPDX-License-Identifier: MIT
#include "analyse/cones.hpp"

#include <algorithm>
#include <limits>
#include <map>
#include <set>
#include <utility>

#include "analyse/order.hpp"

namespace grafverif::analysis {

namespace {

using Numbers = std::vector<std::uint32_t>;

/// The maximum total number of variables of all cones, as a multiple of the number of variables in the complete chart.
/// If the total is larger, cones do not save work.
constexpr std::size_t most_wholes = 8;
/// The maximum number of variable visits for the computation of all cones together. If the maximum
/// is exceeded, only the complete chart is analysed.
constexpr std::size_t most_visits = 4'000'000;
constexpr std::size_t most_cones = 1000;

void add_leaves(const Equations& equations, Id<Expr> term, Numbers& to) {
    if (!term.valid()) return;
    for (const Id<Expr> leaf : leaves(equations.exprs, term))
        to.push_back(static_cast<std::uint32_t>(equations.exprs[leaf].value));
}

/// Tarjan's algorithm for strongly connected components, with an explicit stack because dependencies can be deep.
class Components {
public:
    explicit Components(const std::vector<Numbers>& edges)
        : edges_(edges), number_(edges.size(), none), low_(edges.size()), found_(edges.size(), none) {
        for (std::uint32_t node = 0; node < edges.size(); ++node)
            if (number_[node] == none) visit(node);
    }
    Numbers take() { return std::move(found_); }

private:
    static constexpr std::uint32_t none = std::numeric_limits<std::uint32_t>::max();

    void enter(std::uint32_t node) {
        number_[node] = low_[node] = next_++;
        open_.push_back(node);
        path_.emplace_back(node, 0);
    }

    void visit(std::uint32_t root) {
        enter(root);
        while (!path_.empty()) {
            auto& [node, edge] = path_.back();
            if (edge < edges_[node].size()) {
                const std::uint32_t to = edges_[node][edge++];
                if (number_[to] == none) enter(to);
                else if (found_[to] == none) low_[node] = std::min(low_[node], number_[to]);
                continue;
            }
            leave(node);
        }
    }

    void leave(std::uint32_t node) {
        path_.pop_back();
        if (!path_.empty()) low_[path_.back().first] = std::min(low_[path_.back().first], low_[node]);
        if (low_[node] != number_[node]) return;
        while (found_[node] == none) {
            found_[open_.back()] = components_;
            open_.pop_back();
        }
        ++components_;
    }

    const std::vector<Numbers>& edges_;
    Numbers number_, low_, found_;
    Numbers open_ = {};
    std::vector<std::pair<std::uint32_t, std::size_t>> path_ = {};
    std::uint32_t next_ = 0, components_ = 0;
};

/// Returns, for each query, the variables that it concerns.
std::vector<Numbers> subjects(const Equations& equations) {
    std::vector<Numbers> all;
    for (const Equations::StepActivity& step : equations.steps) all.push_back({step.variable.index});
    for (const Equations::Firing& firing : equations.firings) all.push_back({firing.variable.index});
    for (const Equations::Stored& stored : equations.stored) all.push_back({stored.variable.index});
    for (const Equations::Output& output : equations.outputs) all.push_back({output.variable.index});
    for (const Equations::Conflict& conflict : equations.conflicts)
        add_leaves(equations, conflict.condition, all.emplace_back());
    return all;
}

/// Marks the variables in `open` and all variables on which they depend, directly or indirectly. Returns the number of
/// marked variables.
std::size_t mark_cone(const Dependencies& reads, Numbers open, Cone& cone) {
    std::size_t marked = 0;
    while (!open.empty()) {
        const std::uint32_t variable = open.back();
        open.pop_back();
        if (cone[variable]) continue;
        cone[variable] = true;
        ++marked;
        open.insert(open.end(), reads.of(variable).begin(), reads.of(variable).end());
    }
    return marked;
}

/// A cone, and the variables of the cone that are stored between evolutions. The stored variables determine the cost of
/// searching the cone.
struct Candidate {
    Cone cone = {};
    Numbers kept = {};
};

class Choice {
public:
    explicit Choice(const Equations& equations)
        : equations_(equations), reads_(equations), keeps_(variables_that_matter(equations)) {
        for (const Id<Equations::Variable> id : equations.variables.ids())
            if (equations.variables[id].role == Equations::Role::Input) keeps_[id.index] = false;
    }

    std::vector<Cone> cones() {
        Candidate whole = candidate(Cone(equations_.variables.size(), true));
        if (!find_all()) return {whole.cone};
        std::vector<Candidate> chosen{std::move(whole)};
        std::size_t sum = 0;
        for (auto each = found_.rbegin(); each != found_.rend(); ++each) {
            Candidate next{std::move(each->second), each->first.second};
            if (std::ranges::any_of(chosen, [&](const Candidate& other) { return subsumes(other, next); })) continue;
            sum += next.kept.size();
            chosen.push_back(std::move(next));
        }
        if (sum > most_wholes * chosen.front().kept.size()) chosen.resize(1);
        std::vector<Cone> result;
        for (auto each = chosen.rbegin(); each != chosen.rend(); ++each) result.push_back(std::move(each->cone));
        return result;
    }

private:
    /// Size of the cone, followed by its stored variables: orders the cones.
    using Key = std::pair<std::size_t, Numbers>;

    Candidate candidate(Cone cone) const {
        Numbers kept;
        for (std::uint32_t variable = 0; variable < cone.size(); ++variable)
            if (cone[variable] && keeps_[variable]) kept.push_back(variable);
        return {std::move(cone), std::move(kept)};
    }

    /// Determines the cones of all queries. Returns false if there are too many cones, or too many variables to visit.
    bool find_all() {
        const Numbers component = reads_.components();
        // The known cones, represented by the components of their variables. All variables of one component have the
        // same cone.
        std::set<std::set<std::uint32_t>> known;
        std::size_t visits = 0;
        for (const Numbers& subject : subjects(equations_)) {
            std::set<std::uint32_t> key;
            for (const std::uint32_t variable : subject) key.insert(component[variable]);
            if (!known.insert(std::move(key)).second) continue;
            Cone cone(equations_.variables.size());
            visits += mark_cone(reads_, subject, cone) + cone.size() / 64;
            if (visits > most_visits) return false;
            Candidate made = candidate(std::move(cone));
            const std::size_t size = made.kept.size();
            const auto [same, fresh] = found_.try_emplace(Key{size, std::move(made.kept)}, made.cone);
            for (std::size_t k = 0; !fresh && k < made.cone.size(); ++k)
                if (made.cone[k]) same->second[k] = true;
            if (found_.size() > most_cones) return false;
        }
        return true;
    }

    /// True if the search of cone `large` can also decide all queries of cone `small` at little additional cost.
    static bool subsumes(const Candidate& large, const Candidate& small) {
        return 4 * large.kept.size() <= 5 * small.kept.size() && std::ranges::includes(large.kept, small.kept) &&
               contains(large.cone, small.cone);
    }

    static bool contains(const Cone& large, const Cone& small) {
        for (std::size_t k = 0; k < small.size(); ++k)
            if (small[k] && !large[k]) return false;
        return true;
    }

    const Equations& equations_;
    Dependencies reads_;
    std::vector<bool> keeps_;
    std::map<Key, Cone> found_ = {};
};

}  // namespace

Dependencies::Dependencies(const Equations& equations) : reads_(equations.variables.size()) {
    for (const Equations::Firing& firing : equations.firings)
        add_leaves(equations, firing.condition, reads_[firing.variable.index]);
    for (const Kept& each : kept(equations)) add_leaves(equations, each.next, reads_[each.variable.index]);
    for (const Equations::Output& output : equations.outputs)
        add_leaves(equations, output.value, reads_[output.variable.index]);
    for (const Equations::Timer& timer : equations.timers) reads_[timer.end.index].push_back(timer.watched.index);
    for (const Equations::Stored& stored : equations.stored) {
        Numbers& reads = reads_[stored.variable.index];
        for (const Id<Expr> term : {stored.race, stored.first, stored.first_race}) add_leaves(equations, term, reads);
        for (const Equations::Write& write : stored.writes) {
            add_leaves(equations, write.trigger, reads);
            add_leaves(equations, write.value, reads);
        }
    }
    for (Numbers& reads : reads_) {
        std::ranges::sort(reads);
        const auto rest = std::ranges::unique(reads);
        reads.erase(rest.begin(), rest.end());
    }
}

std::vector<std::uint32_t> Dependencies::components() const { return Components(reads_).take(); }

std::vector<Cone> cones(const Equations& equations) { return Choice(equations).cones(); }

}  // namespace grafverif::analysis
