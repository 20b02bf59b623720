// SPDX-License-Identifier: MIT
#include "check/pdr/refutation.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <new>
#include <sstream>
#include <stdexcept>
#include <utility>

namespace grafverif::pdr {

namespace {

/// Derives clauses by unit propagation. For each derived clause, records the clauses from which it follows.
class Propagation {
public:
    explicit Propagation(const Clauses& clauses)
        : value_(2 * static_cast<std::size_t>(clauses.variables) + 2),
          reason_(static_cast<std::size_t>(clauses.variables) + 1, none),
          watched_(value_.size()),
          given_(clauses.list.size()) {
        for (const std::vector<int>& clause : clauses.list) add(clause, {});
    }

    /// True if the empty clause has been derived.
    bool refuted() const { return !refuted_by_.empty(); }

    /// Adds a clause that follows from the earlier clauses by unit propagation. Returns false if the clause does not
    /// follow.
    bool derive(const std::vector<int>& clause) {
        const std::size_t permanent = trail_.size();
        std::size_t conflict = none;
        for (const int literal : clause) {
            if (value(literal) < 0) continue;
            if (value(literal) > 0) conflict = reason_[variable(literal)];
            else assign(-literal, none);
            if (conflict != none) break;
        }
        if (conflict == none) conflict = propagate();
        const bool follows = conflict != none;
        std::vector<std::size_t> from = follows ? sources(conflict) : std::vector<std::size_t>();
        while (trail_.size() > permanent) {
            value_[index(trail_.back())] = value_[index(-trail_.back())] = 0;
            reason_[variable(trail_.back())] = none;
            trail_.pop_back();
        }
        propagated_ = permanent;
        if (follows) add(clause, std::move(from));
        return follows;
    }

    /// Returns the proof steps on which the empty clause depends, as text in the format LRAT.
    std::string text() const {
        std::vector<bool> needed(steps_.size());
        for (const std::size_t source : refuted_by_) needed[source] = true;
        for (std::size_t i = steps_.size(); i-- > given_;)
            if (needed[i])
                for (const std::size_t source : steps_[i].from) needed[source] = true;
        std::string text;
        for (std::size_t i = given_; i < steps_.size(); ++i) {
            if (!needed[i]) continue;
            text += fmt::format("{} {}", i + 1, joined(steps_[i].literals));
            for (const std::size_t source : steps_[i].from) text += fmt::format("{} ", source + 1);
            text += "0\n";
        }
        text += fmt::format("{} 0 ", steps_.size() + 1);
        for (const std::size_t source : refuted_by_) text += fmt::format("{} ", source + 1);
        return text + "0\n";
    }

    static std::string joined(const std::vector<int>& literals) {
        std::string text;
        for (const int literal : literals) text += fmt::format("{} ", literal);
        return text + "0 ";
    }

private:
    struct Step {
        std::vector<int> literals = {};  ///< the first two literals are the watched literals of unit propagation
        std::vector<std::size_t> from = {};
    };
    static constexpr std::size_t none = SIZE_MAX;

    static std::size_t variable(int literal) { return static_cast<std::size_t>(std::abs(literal)); }
    static std::size_t index(int literal) { return 2 * variable(literal) + (literal < 0 ? 1U : 0U); }
    int value(int literal) const { return value_[index(literal)]; }

    void assign(int literal, std::size_t reason) {
        value_[index(literal)] = 1;
        value_[index(-literal)] = -1;
        reason_[variable(literal)] = reason;
        trail_.push_back(literal);
    }

    /// Adds a proof step, and permanently assigns the literals that follow from its clause.
    void add(const std::vector<int>& clause, std::vector<std::size_t> from) {
        const std::size_t made = steps_.size();
        steps_.push_back({clause, std::move(from)});
        if (refuted()) return;
        std::vector<int>& literals = steps_.back().literals;
        std::ranges::sort(literals);
        literals.erase(std::unique(literals.begin(), literals.end()), literals.end());
        std::ranges::stable_partition(literals, [this](int literal) { return value(literal) >= 0; });
        std::size_t conflict = none;
        if (literals.empty() || value(literals[0]) < 0) conflict = made;
        else if (literals.size() == 1 || value(literals[1]) < 0) {
            if (value(literals[0]) == 0) assign(literals[0], made);
            conflict = propagate();
        }
        if (literals.size() > 1)
            for (const std::size_t k : {0U, 1U}) watched_[index(literals[k])].push_back(made);
        if (conflict != none) refuted_by_ = sources(conflict);
    }

    /// Assigns all literals that follow by unit propagation. Returns the index of a clause whose literals are all
    /// false, or `none`.
    std::size_t propagate() {
        while (propagated_ < trail_.size()) {
            const int now = -trail_[propagated_++];  // a literal that has become false
            std::vector<std::size_t> watching = std::exchange(watched_[index(now)], {});
            for (std::size_t k = 0; k < watching.size(); ++k) {
                std::vector<int>& literals = steps_[watching[k]].literals;
                if (literals[0] == now) std::swap(literals[0], literals[1]);
                const auto other = value(literals[0]) > 0
                                       ? literals.end()
                                       : std::find_if(literals.begin() + 2, literals.end(),
                                                      [this](int literal) { return value(literal) >= 0; });
                if (other != literals.end()) {
                    std::swap(literals[1], *other);
                    watched_[index(literals[1])].push_back(watching[k]);
                    continue;
                }
                watched_[index(now)].push_back(watching[k]);
                if (value(literals[0]) > 0) continue;
                if (value(literals[0]) < 0) {
                    watched_[index(now)].insert(watched_[index(now)].end(),
                                                watching.begin() + static_cast<std::ptrdiff_t>(k) + 1, watching.end());
                    return watching[k];
                }
                assign(literals[0], watching[k]);
            }
        }
        return none;
    }

    /// Returns the indices of the clauses that imply the conflict, in the order of propagation; the last index is that
    /// of the conflict clause.
    std::vector<std::size_t> sources(std::size_t conflict) const {
        std::vector<bool> seen(reason_.size());
        std::vector<std::size_t> from{conflict};
        for (const int literal : steps_[conflict].literals) seen[variable(literal)] = true;
        for (std::size_t i = trail_.size(); i-- > 0;) {
            const std::size_t reason = reason_[variable(trail_[i])];
            if (!seen[variable(trail_[i])] || reason == none || reason == conflict) continue;
            from.push_back(reason);
            for (const int literal : steps_[reason].literals) seen[variable(literal)] = true;
        }
        std::ranges::reverse(from);
        return from;
    }

    std::vector<Step> steps_ = {};
    std::vector<int> value_;           ///< for each index(literal): 1 true, -1 false, 0 not assigned
    std::vector<std::size_t> reason_;  ///< for each variable: the index of the clause that implies its value
    std::vector<std::vector<std::size_t>> watched_;
    std::size_t given_;            ///< number of given clauses
    std::vector<int> trail_ = {};  ///< true literals, in the order of assignment
    std::size_t propagated_ = 0;
    std::vector<std::size_t> refuted_by_ = {};  ///< clauses from which the empty clause follows
};

/// A file in memory, because CaDiCaL writes proofs only to files.
struct MemoryFile {
    MemoryFile() : file(::open_memstream(&text, &size)) {
        if (file == nullptr) throw std::bad_alloc();
    }
    MemoryFile(const MemoryFile&) = delete;
    MemoryFile& operator=(const MemoryFile&) = delete;
    ~MemoryFile() {
        static_cast<void>(std::fclose(file));
        std::free(text);
    }
    std::string content() const {
        if (std::fflush(file) != 0) throw std::bad_alloc();
        return {text, size};
    }

    char* text = nullptr;
    std::size_t size = 0;
    FILE* file = nullptr;
};

/// Returns the refutation of the clauses by CaDiCaL in the format DRAT, or nullopt if the clauses are satisfiable.
std::optional<std::string> proof_of_solver(const Clauses& clauses, LimitMonitor& watch) {
    MemoryFile file;
    SatSolver solver(watch);
    solver.write_proof(file.file);
    for (const std::vector<int>& clause : clauses.list) solver.add(clause);
    if (solver.solve({})) return {};
    solver.end_proof();
    return file.content();
}

}  // namespace

std::string dimacs(const Clauses& clauses) {
    std::string text = fmt::format("p cnf {} {}\n", clauses.variables, clauses.list.size());
    for (const std::vector<int>& clause : clauses.list) {
        for (const int literal : clause) text += fmt::format("{} ", literal);
        text += "0\n";
    }
    return text;
}

std::optional<std::string> refutation(const Clauses& clauses, LimitMonitor& watch) {
    Propagation propagation(clauses);
    if (propagation.refuted()) return propagation.text();
    const std::optional<std::string> proof = proof_of_solver(clauses, watch);
    if (!proof) return {};
    std::istringstream lines(*proof);
    for (std::string line; !propagation.refuted() && std::getline(lines, line);) {
        if (line.starts_with("d ")) continue;  // the proof remains valid without the deletion of clauses
        std::istringstream words(line);
        std::vector<int> clause;
        for (int literal = 0; words >> literal && literal != 0;) clause.push_back(literal);
        watch.look();
        if (!propagation.derive(clause)) throw std::logic_error("a clause of the proof does not follow");
    }
    if (!propagation.refuted()) throw std::logic_error("the proof does not contain the empty clause");
    return propagation.text();
}

}  // namespace grafverif::pdr
