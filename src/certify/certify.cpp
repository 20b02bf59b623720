// SPDX-License-Identifier: MIT
// grafverif-certify: checks the certificate that `grafverif check --certificate FOLDER` writes. The folder src/certify
// contains the complete program, which shares no code with grafverif. docs/how-to/certificates.md describes the files
// and the claims.
//
//   network.txt      the closed loop as a flat network of timed automata, with its properties and the caps of its clocks
//   certificate.txt  the claims (`holds P`, `violated P` with a run), and checksums
//   states.txt       a set of states, one per line
//
// If the set contains the initial state and all successors of its states, it contains every reachable state.
// grafverif-certify computes all successors itself.
#include <cstdio>
#include <optional>
#include <ranges>
#include <unordered_map>

#include "semantics.hpp"

namespace certify {

/// True if `states` states of the size of `one` would need too much memory.
bool are_too_many(std::size_t states, const State& one) {
    return states * (one.size() + 16) > 200'000'000;  // 16: the overhead of a state, in values
}

/// The text of a state in states.txt: all its values, each followed by a blank.
std::string text_of(const State& state) {
    std::string text;
    for (const Int value : state)
        (value >= 0 && value < 10 ? text += static_cast<char>('0' + value) : text += std::to_string(value)) += ' ';
    return text;
}

/// The graph of the states in states.txt. The constructor checks that they include the initial state and all successors
/// of each state.
class Graph {
public:
    Graph(Semantics& semantics, std::string_view text) : semantics_(semantics) {
        std::unordered_map<std::string_view, std::size_t> numbers;
        for (Words words("states.txt", text); words.next_line();) {
            lines_.push_back(words.remainder());
            if (!numbers.emplace(lines_.back(), size() - 1).second) reject_state(size() - 1, "occurs twice");
        }
        if (!numbers.contains(text_of(semantics.network.initial)))
            reject("states.txt does not contain the initial state");
        State next;
        for (std::size_t i = 0; i < size(); ++i) {
            const auto add = [&](const State& successor) {
                const auto found = numbers.find(text_of(successor));
                if (found == numbers.end()) reject_state(i, "has a successor that the file does not contain");
                targets_.push_back(found->second);
            };
            const State now = state(i);
            if (text_of(now) != lines_[i]) reject_state(i, "is invalid");
            starts_.push_back(targets_.size());
            waits_.push_back(semantics.moves(now, next, add));
            if (waits_.back()) add(next);
            if (!semantics.error.empty()) reject_state(i, "has a model error: " + semantics.error);
        }
        starts_.push_back(targets_.size());
    }

    std::size_t size() const { return lines_.size(); }

    /// Checks that `property` holds or, for `reachable`, that no state satisfies it.
    void check(const Property& property) {
        const Pattern pattern = property.pattern;
        std::vector<bool> starts(size()), goal(size());  // the property requires that a goal follows each start
        const auto delay = [&](std::size_t i) { return starts_[i + 1] - (waits_[i] ? 1 : 0); };
        for (std::size_t i = 0; i < size(); ++i) {
            const State now = state(i);
            if (semantics_.decides(property, now)) reject_state(i, "decides `" + property.name + "`");
            goal[i] = semantics_.is_goal(property, now, starts_[i] != delay(i), waits_[i]);
            starts[i] = pattern == Pattern::Possible || semantics_.concerns(property, now);
            if (pattern == Pattern::LeadsTo) starts[i] = starts[i] && semantics_.truth(property.operands[0], now);
            if (pattern == Pattern::Inevitable) starts[i] = now == semantics_.network.initial;
        }
        if (pattern <= Pattern::ExactlyOne) return;
        const auto first = [&](std::size_t i) { return pattern == Pattern::NoDeadlock ? delay(i) : starts_[i]; };
        std::vector<std::vector<std::size_t>> sources(size());
        std::vector<std::size_t> missing(size()), open;
        for (std::size_t i = 0; i < size(); ++i) {
            // number of successors of state i that must reach a goal before i counts as reaching a goal
            missing[i] = pattern < Pattern::Possible ? starts_[i + 1] - first(i) : 1;
            for (std::size_t k = first(i); k < starts_[i + 1]; ++k) sources[targets_[k]].push_back(i);
            if (goal[i]) open.push_back(i);
        }
        while (!open.empty()) {
            const std::size_t i = open.back();
            open.pop_back();
            for (const std::size_t source : sources[i]) {
                if (goal[source] || --missing[source] > 0) continue;
                goal[source] = true;
                open.push_back(source);
            }
        }
        for (std::size_t i = 0; i < size(); ++i)
            if (starts[i] && !goal[i]) reject_state(i, "violates `" + property.name + "`");
    }

private:
    [[noreturn]] static void reject_state(std::size_t i, const std::string& problem) {
        reject("states.txt:" + std::to_string(i + 1) + ": the state " + problem);
    }

    State state(std::size_t i) const {
        const Network& network = semantics_.network;
        State state;
        const char *at = lines_[i].data(), *const end = at + lines_[i].size();
        for (std::size_t k = 0; k < network.initial.size(); ++k) {
            Int& value = state.emplace_back();
            at = std::from_chars(at, end, value).ptr + 1;
            if (at > end || !network.admits(k, value)) reject_state(i, "is invalid");
        }
        for (std::size_t p = 0; p < network.processes.size(); ++p) semantics_.reduce(p, state);
        return state;
    }

    Semantics& semantics_;
    std::vector<std::string_view> lines_ = {};
    // In `targets_`: the successors of a state by edges, then the successor by a delay if `waits_` is true.
    std::vector<std::size_t> starts_ = {}, targets_ = {};
    std::vector<bool> waits_ = {};
};

/// A run from the initial state. The states from the index `loop` on repeat forever.
struct Run {
    std::vector<State> states = {};
    std::optional<std::size_t> loop = {};
};

Run read_run(Words& words, Semantics& semantics) {
    const std::vector<Process>& processes = semantics.network.processes;
    Run run{{semantics.network.initial}};
    Int longest = 10'000'000;  // maximum number of units of time in the remaining run
    for (State next; words.next_line() && !words.skip("end");) {
        if (are_too_many(run.states.size(), run.states[0])) reject("a run is too long");
        if (semantics.races(run.states.back())) reject("a run continues after a race");
        if (words.skip("loop")) run.loop = run.states.size() - 1;
        else if (words.skip("take")) {
            const std::size_t p = words.choice(processes, &Process::name);
            const Int i = words.number(0, std::ssize(processes[p].edges) - 1);
            semantics.error.clear();
            if (!semantics.take(p, processes[p].edges[static_cast<std::size_t>(i)], run.states.back(), next) ||
                !semantics.error.empty())
                reject("a run takes an edge of `" + processes[p].name + "` that is not enabled");
            run.states.push_back(next);
        } else if (words.skip("delay")) {
            const Int units = words.number(1, longest);
            longest -= units;
            run.states.push_back(run.states.back());
            for (Int i = 0; i < units; ++i) {
                if (!semantics.moves(run.states.back(), next, [](const State&) {})) reject("time cannot pass in a run");
                if (std::exchange(run.states.back(), next) == next) break;  // a further delay leads to the same state
            }
        } else words.fail("expected `take`, `delay`, `loop` or `end`");
    }
    return run;
}

/// True if no path from `from` leads to a state that the property requires: a state with an enabled edge (no deadlock),
/// with a possible delay (no timelock), or with the operand (always possible). For other patterns, true if `from` has
/// no successor.
bool is_trap(const Property& property, const State& from, Semantics& semantics) {
    std::set<State> seen{from};
    std::vector<State> open{from};
    for (State next; !open.empty();) {
        const State now = std::move(open.back());
        open.pop_back();
        bool has_edge = false;
        const auto visit = [&](const State& state) {
            has_edge = true;
            if (seen.insert(state).second) open.push_back(state);
        };
        const bool waits = semantics.moves(now, next, visit);
        if (semantics.is_goal(property, now, has_edge, waits) || !semantics.error.empty()) return false;
        if (property.pattern < Pattern::Possible && (waits || has_edge)) return false;
        if (waits) visit(next);
        if (are_too_many(seen.size(), from)) reject("too many states follow a run");
    }
    return true;
}

/// True if the run shows that the property is violated or, for `reachable`, that it holds.
bool shows(const Run& run, const Property& property, Semantics& semantics) {
    const std::vector<State>& states = run.states;
    if (property.pattern <= Pattern::ExactlyOne) return semantics.decides(property, states.back());
    if (property.pattern != Pattern::Inevitable && property.pattern != Pattern::LeadsTo) {
        // It is sufficient to test the last state: if an earlier state is a trap, the last state is also a trap,
        // because it follows the earlier state.
        const auto last = std::ranges::find_if(states | std::views::reverse, [&](const State& state) {
            return property.pattern == Pattern::Possible || semantics.concerns(property, state);
        });
        return last != states.rend() && is_trap(property, *last, semantics);
    }
    const bool repeats = run.loop && *run.loop + 1 < states.size() && states[*run.loop] == states.back();
    if (!repeats && !is_trap(property, states.back(), semantics)) return false;
    std::size_t since = states.size();  // index from which on no state satisfies the last operand
    while (since > 0 && !semantics.last_operand(property, states[since - 1])) --since;
    if (since == states.size() || (repeats && since > *run.loop)) return false;
    if (property.pattern == Pattern::Inevitable) return since == 0;
    return std::any_of(states.begin() + static_cast<std::ptrdiff_t>(since), states.end(), [&](const State& state) {
        return semantics.concerns(property, state) && semantics.truth(property.operands[0], state);
    });
}

/// Checks the certificate in `folder`. Returns a line of text for each property. Throws Rejected or std::runtime_error.
/// If `inner` is not empty, the certificate must concern only the property `inner`.
std::string check(const std::filesystem::path& folder, const std::string& inner = {}) {
    const std::string text = content_of(folder / "certificate.txt"), model = content_of(folder / "network.txt");
    const std::size_t end = text.rfind("checksum ");
    if (end == std::string::npos || text.substr(end) != "checksum " + checksum(text.substr(0, end)) + '\n')
        malformed("certificate.txt: damaged or incomplete (wrong checksum)");
    const Network network(model);
    Semantics semantics(network);
    semantics.check_caps();
    Words words("certificate.txt", std::string_view(text).substr(0, end));
    if (!words.next_line() || !words.skip("grafverif-certificate") || words.number() != 1)
        words.fail("this is not a certificate of version 1");
    if (!words.next_line() || !words.skip("network") || words.word() != checksum(model))
        words.fail("the certificate belongs to another network, or network.txt is damaged");
    if (!inner.empty() && (network.properties.size() != 1 || network.properties[0].name != inner))
        words.fail("the network of the folder `" + inner + "` must have only the property `" + inner + "`");
    std::set<std::string> open;  // properties for which the certificate contains no claim
    for (const Property& property : network.properties) open.insert(property.name);
    std::set<std::string> folders = open;
    std::string states, result, others;
    std::optional<Graph> graph;
    while (words.next_line()) {
        const std::string kind(words.word());
        if (kind == "states") {
            states = content_of(folder / "states.txt");
            if (graph || words.word() != checksum(states))
                words.fail("states.txt is damaged or belongs to another certificate");
            graph.emplace(semantics, states);
        } else if (kind == "omitted") {
            const std::string name(words.word());
            others += name + ": not certified:" + std::string(words.remainder()) + '\n';
        } else if (kind == "also") {
            const std::string name(words.word());
            if (!inner.empty() || name[0] == '.' || name.find('/') != std::string::npos) words.fail("invalid folder");
            if (!folders.insert(name).second) words.fail("two claims about `" + name + "`");
            others += check(folder / name, name);
        } else if (kind == "holds" || kind == "violated") {
            const Property& property = network.properties[words.choice(network.properties, &Property::name)];
            if (open.erase(property.name) == 0) words.fail("two claims about `" + property.name + "`");
            const bool by_states = (kind == "holds") != (property.pattern == Pattern::Reachable);
            if (by_states && !graph) words.fail("the claim requires `states`");
            if (by_states) graph->check(property);
            else if (!shows(read_run(words, semantics), property, semantics))
                reject("the run of `" + property.name + "` does not prove its verdict");
            result += property.name + ": " + kind + (by_states ? ", proved by the states\n" : ", shown by a run\n");
        } else words.fail("unknown line");
    }
    for (const std::string& name : open) result += name + ": not certified: no claim\n";
    return "network " + checksum(model) + ": " + std::to_string(graph ? graph->size() : 0) + " states\n" + result +
           others;
}

}  // namespace certify

int main(int count, char** values) try {
    if (count != 2)
        return std::fputs("usage: grafverif-certify FOLDER (the folder that `check --certificate FOLDER` wrote)\n",
                          stderr),
               2;
    return std::fputs(certify::check(values[1]).c_str(), stdout) < 0 ? 2 : 0;
} catch (const certify::Rejected& rejected) {
    std::fprintf(stderr, "rejected: %s\n", rejected.what());
    return 1;
} catch (const std::exception& failure) {
    std::fprintf(stderr, "error: %s\n", failure.what());
    return 2;
}
