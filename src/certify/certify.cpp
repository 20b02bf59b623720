// SPDX-License-Identifier: MIT
// grafverif-certify: checks the certificate that `grafverif check --certificate FOLDER` writes. The folder src/certify
// contains the complete program, which shares no code with grafverif. docs/how-to/certificates.md describes the files
// and the claims.
//
//   network.txt      the closed loop as a flat network of timed automata, with its properties
//   certificate.txt  the claims (`holds P`, `violated P`, some with a run), and checksums
//   states.txt       a set of states, one per line
//   P/states.txt     a set of states of a fragment or subsystem of the network (semantics.hpp)
//   P/               a folder of the same form, for a property with a separate network
//
// If a set contains the initial state and all successors of its states, it contains every reachable state. The program
// computes all successors itself.
#include <cstdio>
#include <optional>

#include "semantics.hpp"

namespace certify {

/// True if `states` states of the size of `one` would need too much memory. The overhead of a state
/// is counted as 16 values.
bool are_too_many(Index states, const State& one) { return states * (one.size() + 16) > 200'000'000; }

/// Reads the values of a state in the order of `Network::ranges`; `*` is an unknown value.
State read_state(Words& words, const Network& network) {
    State state;
    for (const auto& [low, high] : network.ranges) state.push_back(words.skip("*") ? unknown : words.number(low, high));
    return state;
}

/// A sorted set of states, which contains the initial state and all successors of its states.
struct Graph {
    Graph(const Network& network, std::string file, std::vector<State> sorted, const Fragment& fragment)
        : states(std::move(sorted)), file_(std::move(file)), semantics_(network, fragment) {
        if (std::ranges::adjacent_find(states, std::ranges::greater_equal()) != states.end())
            reject(file_ + ": the states are not sorted");
        State initial = network.initial;
        for (Index k = 0; k < initial.size(); ++k)
            if (semantics_.known[k] == unknown) initial[k] = unknown;
        if (!std::ranges::binary_search(states, initial)) reject(file_ + " does not contain the initial state");
        for (Index i = 0; i < states.size(); ++i) {
            for (Index k = 0; k < initial.size(); ++k)  // only a variable that is assigned can be open
                if (states[i][k] == unknown && semantics_.known[k] != unknown && !network.assigned.contains(k))
                    reject_state(i, "is invalid");
            Moves moves = semantics_.moves(states[i]);
            waits_.push_back(moves.waits);
            targets_.emplace_back();
            for (const State& next : moves.next) {
                const auto found = std::ranges::lower_bound(states, next);
                if (found == states.end() || *found != next)
                    reject_state(i, "has a successor that the file does not contain");
                targets_.back().push_back(static_cast<Index>(found - states.begin()));
            }
            errors.merge(moves.errors);
        }
    }

    const std::vector<State> states;
    std::set<std::string> errors = {};  // the model errors of all states

    /// Checks that `property` holds or, for `reachable`, that no state satisfies it.
    void check(const Property& property) {
        const Pattern pattern = property.pattern;
        if (pattern > Pattern::ExactlyOne &&
            ((semantics_.partial && !semantics_.subsystem) || semantics_.step > 1 || !errors.empty()))
            reject(file_ + " is incomplete, or a model error is possible");
        const Index size = states.size();
        std::vector<bool> starts(size), goal(size);  // a path to a goal is necessary from each start
        std::vector<std::vector<Index>> sources(size);
        std::vector<Index> missing(size, 1), open;  // missing: number of successors that must reach a goal
        for (Index i = 0; i < size; ++i) {
            const State& now = states[i];
            if (semantics_.decides(property, now)) reject_state(i, "decides `" + property.name + "`");
            if (pattern <= Pattern::ExactlyOne) continue;
            const Index count = targets_[i].size(), edges = count - (waits_[i] ? 1 : 0);
            for (Index k = pattern == Pattern::NoDeadlock ? edges : 0; k < count; ++k)
                sources[targets_[i][k]].push_back(i);
            if (pattern < Pattern::Possible) missing[i] = count;
            if (pattern == Pattern::Inevitable) starts[i] = now == semantics_.network.initial;
            else if (pattern == Pattern::LeadsTo) starts[i] = semantics_.holds(0, property, now);
            else starts[i] = pattern == Pattern::Possible || semantics_.concerns(property, now);
            goal[i] = semantics_.is_goal(property, now, edges > 0, waits_[i]);
            if (goal[i]) open.push_back(i);
        }
        for (Index n = 0; n < open.size(); ++n)
            for (const Index source : sources[open[n]])
                if (!goal[source] && --missing[source] == 0) {
                    goal[source] = true;
                    open.push_back(source);
                }
        for (Index i = 0; i < size; ++i)
            if (starts[i] && !goal[i]) reject_state(i, "violates `" + property.name + "`");
    }

private:
    [[noreturn]] void reject_state(Index i, const std::string& problem) const {
        reject(file_ + ":" + std::to_string(i + 1) + ": the state " + problem);
    }

    const std::string file_;
    Semantics semantics_;
    std::vector<std::vector<Index>> targets_ = {};  // targets of edges, then of a delay if `waits_`
    std::vector<bool> waits_ = {};
};

/// Reads a run from the initial state: each state is a successor of the previous one.
std::vector<State> read_run(Words& words, Semantics& semantics) {
    std::vector<State> run{semantics.network.initial};
    while (words.next_line() && !words.skip("end")) {
        if (are_too_many(run.size(), run[0])) reject("a run is too long");
        const Moves moves = semantics.moves(run.back());
        run.push_back(read_state(words, semantics.network));
        if (std::ranges::find(moves.next, run.back()) == moves.next.end())
            reject("a state of a run is not a successor of the previous state");
    }
    return run;
}

/// True if no path from `from` leads to a state that the property requires: a state with an enabled edge (no deadlock),
/// with a possible delay (no timelock), or with the operand (always possible). For other patterns, true if `from` has
/// no successor.
bool is_trap(const Property& property, const State& from, Semantics& semantics) {
    std::set<State> seen{from};
    std::vector<State> open{from};
    for (Index n = 0; n < open.size(); ++n) {
        const Moves moves = semantics.moves(open[n]);
        if (!moves.errors.empty() || (property.pattern < Pattern::Possible && !moves.next.empty())) return false;
        if (semantics.is_goal(property, open[n], moves.next.size() > (moves.waits ? 1 : 0), moves.waits)) return false;
        for (const State& next : moves.next)
            if (seen.insert(next).second) open.push_back(next);
        if (are_too_many(seen.size(), from)) reject("too many states are reachable from the last state of a run");
    }
    return true;
}

/// True if the run shows that the property is violated or, for `reachable`, that it holds.
bool shows(const std::vector<State>& run, const Property& property, Semantics& semantics) {
    const auto is_goal = [&](const State& state) { return semantics.is_goal(property, state, false, false); };
    const Term& race = semantics.network.terms[property.operands.empty() ? 0 : property.operands[0]];
    // A variable with a single value represents a race: only a model error assigns another value.
    if (property.pattern == Pattern::Never && !property.stable && race.op == Op::Value && race.low == race.high &&
        semantics.moves(run.back()).exceeded.contains(race.place))
        return true;
    if (property.pattern <= Pattern::ExactlyOne) return semantics.decides(property, run.back());
    if (property.pattern >= Pattern::Possible) {
        // It is sufficient to test the last state: if an earlier state is a trap, the last state is also a trap,
        // because it follows the earlier state.
        const auto last = std::find_if(run.rbegin(), run.rend(), [&](const State& state) {
            return property.pattern == Pattern::Possible || semantics.concerns(property, state);
        });
        return last != run.rend() && is_trap(property, *last, semantics);
    }
    const auto loop = std::find(run.rbegin() + 1, run.rend(), run.back());  // from this state on, the run can repeat
    if (loop == run.rend() && !is_trap(property, run.back(), semantics)) return false;
    const auto last = std::find_if(run.rbegin(), run.rend(), is_goal);
    if (last == run.rbegin() || (loop != run.rend() && last <= loop)) return false;
    if (property.pattern == Pattern::Inevitable) return last == run.rend();
    return std::any_of(run.rbegin(), last, [&](const State& state) { return semantics.holds(0, property, state); });
}

/// Checks the certificate in `folder`. Returns a line for each property; each line begins with `prefix`. Throws
/// Rejected or std::runtime_error.
std::string check(const std::filesystem::path& folder, const std::string& prefix = {}) {
    const std::string text = content_of(folder / "certificate.txt"), model = content_of(folder / "network.txt");
    const Index end = text.rfind("checksum ");
    if (end == std::string::npos || text.substr(end) != "checksum " + checksum(text.substr(0, end)) + '\n')
        malformed("certificate.txt: damaged or incomplete (wrong checksum)");
    const Network network(model);
    Semantics semantics(network, {network.initial});
    Words words("certificate.txt", std::string_view(text).substr(0, end));
    words.header("grafverif-certificate");
    if (!words.next_line() || !words.skip("network") || words.word() != checksum(model))
        words.fail("the certificate belongs to another network, or network.txt is damaged");
    std::set<std::string> open;  // properties for which the certificate contains no claim
    for (const Property& property : network.properties) open.insert(property.name);
    std::string result;
    std::optional<Graph> graph;
    std::vector<std::set<std::string>> sets;  // the model errors of each set
    std::set<Index> covered;                  // processes of the subsystems
    Fragment fragment;
    Index states = 0;
    const auto subfolder = [&] {
        const std::string name = words.name();
        if (name[0] == '.' || name.find('/') != std::string::npos) words.fail("invalid folder");
        return name;
    };
    while (words.next_line()) {
        const std::string kind = words.name();
        if (kind == "reacts") fragment.reacting.insert(network.find(words, "process "));
        else if (kind == "step") fragment.step = words.number(1, greatest_clock);
        else if (kind == "states" || kind == "bounds" || kind == "subsystem") {
            const std::string sum = words.name(), file = (words.at_end() ? "" : subfolder() + '/') + "states.txt";
            const std::string content = content_of(folder / file);
            if (sum != checksum(content)) words.fail(file + " is damaged or belongs to another certificate");
            std::vector<State> sorted;
            fragment.known = State(network.initial.size(), unknown);
            for (Words lines(file, content); lines.next_line();) {
                sorted.push_back(read_state(lines, network));
                std::ranges::transform(sorted.back(), fragment.known, fragment.known.begin(), std::ranges::max);
                fragment.partial = fragment.partial || std::ranges::count(sorted.back(), unknown) != 0;
            }
            if (sorted.empty()) reject(file + " contains no state");
            states += sorted.size();
            fragment.kind = kind;
            graph.emplace(network, file, std::move(sorted), fragment);
            if (kind == "states") sets.push_back(graph->errors);
            else if (kind == "bounds") fragment.bounds.push_back(graph->states);
            else graph->check({"no deadlock", false, Pattern::NoDeadlock});
            for (Index p = 0; p < network.processes.size(); ++p)
                if (kind == "subsystem" && fragment.known[network.processes[p].place] != unknown) covered.insert(p);
            if (kind != "states") graph.reset();
            fragment = {.known = {}, .bounds = std::move(fragment.bounds)};
        } else if (kind == "omitted") {
            result += prefix + words.name() + ": not certified:";
            result += std::string(words.remainder()) + '\n';
        } else if (kind == "also") {
            const std::string name = subfolder() + '/';
            result += check(folder / name, prefix + name);
        } else if (kind == "holds" || kind == "violated") {
            const Property& property = network.properties[network.find(words, "property ")];
            if (open.erase(property.name) == 0) words.fail("two claims about `" + property.name + "`");
            const bool by_states = (kind == "holds") != (property.pattern == Pattern::Reachable);
            const bool by_subsystems = property.pattern == Pattern::NoDeadlock && !property.stable &&
                                       !covered.empty() && covered.size() == network.processes.size();
            if (by_states && !by_subsystems && !graph) reject("no states prove `" + property.name + "`");
            if (by_states && !by_subsystems) graph->check(property);
            else if (!by_states && !shows(read_run(words, semantics), property, semantics))
                reject("the run of `" + property.name + "` does not prove the verdict");
            result +=
                prefix + property.name + ": " + kind + (by_states ? ", proved by the states\n" : ", shown by a run\n");
        } else words.fail("unknown line");
    }
    for (const std::string& error : sets.empty() ? std::set<std::string>() : sets[0])
        if (std::ranges::all_of(sets, [&](const auto& set) { return set.contains(error); }))
            reject("a model error is possible: " + error);
    for (const std::string& name : open) result += prefix + name + ": not certified: the file has no verdict\n";
    return prefix + "network " + checksum(model) + ": " + std::to_string(states) + " states\n" + result;
}

}  // namespace certify

int main(int count, char** values) try {
    if (count != 2) return std::fputs("usage: grafverif-certify FOLDER (of `check --certificate FOLDER`)\n", stderr), 2;
    return std::fputs(certify::check(values[1]).c_str(), stdout) < 0 ? 2 : 0;
} catch (const certify::Rejected& rejected) {
    return std::fprintf(stderr, "rejected: %s\n", rejected.what()), 1;
} catch (const std::exception& failure) {
    return std::fprintf(stderr, "error: %s\n", failure.what()), 2;
}
