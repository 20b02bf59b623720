// SPDX-License-Identifier: MIT
#include "check/symbolic/paths.hpp"

#include <algorithm>
#include <cassert>

namespace grafverif::symbolic {

bool grow(const StateSpace& model, bdd::Rings& rings, const Bdd& within, const Bdd& goal,
          const std::function<bool(std::size_t)>& keep_going) {
    for (bool found = !rings.each.empty(); found; found = rings.add(model.image(rings.each.back()) & within)) {
        if (!(rings.each.back() & goal).is_false()) return true;
        if (keep_going && !keep_going(rings.each.size())) return true;
    }
    return false;
}

std::vector<State> shortest_path(const StateSpace& model, const bdd::Rings& rings, const Bdd& goal) {
    const std::optional<std::size_t> nearest = rings.nearest(goal);
    if (!nearest) return {};
    return bdd::path_back(*nearest, model.pick(rings.each[*nearest] & goal, {}),
                          [&](std::size_t ring, const State& next) {
                              return model.pick(model.preimage(model.only(next)) & rings.each[ring], next);
                          });
}

Bdd can_reach(const StateSpace& model, const Bdd& within, const Bdd& goal) {
    Bdd result = within & goal;
    for (Bdd latest = result; !latest.is_false(); result |= latest) latest = model.preimage(latest) & within & ~result;
    return result;
}

namespace {

/// Computes can_stay for the case without justice conditions: removes the states that have no successor in the set,
/// until each remaining state has a successor in the set. Each iteration examines only the predecessors of the states
/// that were removed last.
Bdd can_stay(const StateSpace& model, const Bdd& within) {
    Bdd result = within & model.preimage(within);
    for (Bdd removed = within & ~result; !removed.is_false(); result &= ~removed) {
        const Bdd before = model.preimage(removed) & result;
        removed = before & ~model.preimage(model.image(before) & result);
    }
    return result;
}

}  // namespace

Bdd can_stay(const StateSpace& model, const Bdd& within, const std::vector<Bdd>& justice) {
    if (justice.empty()) return can_stay(model, within);
    Bdd result = within;
    for (;;) {
        const Bdd before = result;
        result &= model.preimage(result);
        for (const Bdd& each : justice) result &= model.preimage(can_reach(model, result, each));
        if (result == before) return result;
    }
}

namespace {

/// Returns the states that are reachable from `from` through states of `within`, as rings (sets of states at the same
/// distance). The last ring is the first ring that intersects `goal`.
bdd::Rings rings_to(const StateSpace& model, const Bdd& from, const Bdd& within, const Bdd& goal) {
    bdd::Rings rings;
    rings.add(from & within);
    grow(model, rings, within, goal);
    return rings;
}

void append(Path& path, const std::vector<State>& states) {
    path.states.insert(path.states.end(), states.begin(), states.end());
}

}  // namespace

Path stay(const StateSpace& model, const State& first, const Bdd& staying, const std::vector<Bdd>& justice) {
    // Each iteration extends the path so that each justice condition holds in some state of the extension. If no path
    // leads from the last state back to the beginning of the extension, the last state is in a later strongly connected
    // component. In this case, the next iteration begins in the last state. The iteration terminates because there are
    // finitely many components. Without justice conditions, the path may end in a state that a step leaves unchanged.
    Path path{{first}, {}};
    const Bdd still = justice.empty() ? staying & model.still() : Bdd();
    for (;;) {
        const std::size_t start = path.states.size() - 1;
        const State origin = path.states.back();
        if (evaluate(still, origin)) {
            path.loop = start;
            return path;
        }
        const auto around_last = [&](const Bdd& goal) {
            return rings_to(model, model.image(model.only(path.states.back())), staying, goal);
        };
        for (const Bdd& each : justice) {
            const bool met = std::any_of(path.states.begin() + static_cast<std::ptrdiff_t>(start), path.states.end(),
                                         [&](const State& state) { return evaluate(each, state); });
            if (met) continue;
            append(path, shortest_path(model, around_last(each), each));
        }
        const Bdd here = model.only(origin), end = here | still;
        const bdd::Rings rings = around_last(end);
        const std::vector<State> back = shortest_path(model, rings, end);
        if (!back.empty()) {
            const bool closes = evaluate(here, back.back());
            append(path, {back.begin(), back.end() - (closes ? 1 : 0)});
            path.loop = closes ? start : path.states.size() - 1;
            return path;
        }
        assert(!rings.each.empty());
        append(path, shortest_path(model, rings, rings.each.back()));
    }
}

FlatRun run_of(const StateSpace& model, const Path& path) {
    FlatRun run{{}, path.loop};
    for (std::size_t i = 0; i < path.states.size(); ++i) {
        const State* next = i + 1 < path.states.size() ? &path.states[i + 1] : nullptr;
        if (next == nullptr && path.loop) next = &path.states[*path.loop];
        const Bdd step = i < path.steps.size() ? path.steps[i] : Bdd::constant(true);
        run.states.push_back(model.values(path.states[i], next, step));
    }
    return run;
}

}  // namespace grafverif::symbolic
