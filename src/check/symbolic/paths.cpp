// SPDX-License-Identifier: MIT
#include "check/symbolic/paths.hpp"

#include <algorithm>
#include <cassert>

namespace grafverif::symbolic {

bool grow(const StateSpace& model, Rings& rings, Bdd& reached, const Bdd& within, const Bdd& goal,
          const std::function<void(std::size_t)>& progress) {
    for (;;) {
        if (rings.back().is_false()) {
            rings.pop_back();
            return false;
        }
        if (!(rings.back() & goal).is_false()) return true;
        if (progress) progress(rings.size());
        const Bdd next = model.image(rings.back()) & within & ~reached;
        reached |= next;
        rings.push_back(next);
    }
}

std::vector<State> way(const StateSpace& model, const Rings& rings, const Bdd& goal) {
    for (std::size_t ring = 0; ring < rings.size(); ++ring) {
        const Bdd found = rings[ring] & goal;
        if (found.is_false()) continue;
        std::vector<State> path{model.pick(found, {})};
        while (ring-- > 0)
            path.push_back(model.pick(model.preimage(model.only(path.back())) & rings[ring], path.back()));
        std::ranges::reverse(path);
        return path;
    }
    return {};
}

Bdd can_reach(const StateSpace& model, const Bdd& within, const Bdd& goal) {
    Bdd result = within & goal;
    for (Bdd latest = result; !latest.is_false(); result |= latest)
        latest = model.preimage(latest) & within & ~result;
    return result;
}

Bdd can_stay(const StateSpace& model, const Bdd& within, const std::vector<Bdd>& justice) {
    Bdd result = within;
    for (;;) {
        const Bdd before = result;
        result &= model.preimage(result);
        for (const Bdd& each : justice)
            result &= model.preimage(can_reach(model, result, each));
        if (result == before) return result;
    }
}

namespace {

/// A shortest path from `from` to `goal` in `within`, of no step or more; else the rings that were searched in vain.
std::vector<State> walk(const StateSpace& model, const Bdd& from, const Bdd& within, const Bdd& goal, Rings& rings) {
    rings = {from & within};
    Bdd reached = rings.front();
    return grow(model, rings, reached, within, goal) ? way(model, rings, goal) : std::vector<State>{};
}

void append(Path& path, const std::vector<State>& states) {
    path.states.insert(path.states.end(), states.begin(), states.end());
}

}  // namespace

Path stay(const StateSpace& model, const State& first, const Bdd& staying, const std::vector<Bdd>& justice) {
    // A round from a state through all justice conditions. Where it does not close, its end lies in a strongly
    // connected component further down, from where the next round starts: there are finitely many.
    Path path{{first}, {}};
    for (;;) {
        const std::size_t start = path.states.size() - 1;
        const State origin = path.states.back();
        Rings rings;
        for (const Bdd& each : justice) {
            const bool met = std::any_of(path.states.begin() + static_cast<std::ptrdiff_t>(start), path.states.end(),
                                         [&](const State& state) { return evaluate(each, state); });
            if (met) continue;
            append(path, walk(model, model.image(model.only(path.states.back())), staying, each, rings));
        }
        const std::vector<State> back =
            walk(model, model.image(model.only(path.states.back())), staying, model.only(origin), rings);
        if (!back.empty()) {
            append(path, {back.begin(), back.end() - 1});
            path.loop = start;
            return path;
        }
        assert(!rings.empty());
        append(path, way(model, rings, rings.back()));
    }
}

SystemRun run_of(const StateSpace& model, const FlatSystem& flat, const Path& path) {
    SystemRun run;
    run.loop = path.loop;
    for (std::size_t i = 0; i < path.states.size(); ++i) {
        const State* next = i + 1 < path.states.size() ? &path.states[i + 1] : nullptr;
        if (next == nullptr && path.loop) next = &path.states[*path.loop];
        run.states.push_back(symbol_values(flat, model.values(path.states[i], next)));
    }
    return run;
}

}  // namespace grafverif::symbolic
