// SPDX-License-Identifier: MIT
#include "check/pdr/pdr.hpp"

#include <algorithm>
#include <array>
#include <cassert>
#include <memory>
#include <optional>
#include <queue>
#include <unordered_map>
#include <utility>

#include "check/pdr/justify.hpp"

namespace grafverif::pdr {

namespace {

/// True if the cube contains the initial state, in which every latch is false.
bool holds_first_state(const Cube& cube) { return std::ranges::all_of(cube, is_inverted); }

bool contains(const Cube& cube, const Cube& part) { return std::ranges::includes(cube, part); }

/// A proof obligation: a set of states from which a bad state is reachable.
struct Obligation {
    Cube state = {};
    Sources inputs = {};        ///< inputs of the step to `successor`; for the last state, inputs for which the state
                                ///< is bad
    std::size_t successor = 0;  ///< index of the obligation of the next state; for the last state, the index of this
                                ///< obligation
    std::size_t frame = 0, depth = 0;
};

class PdrSearch {
public:
    PdrSearch(const Circuit& circuit, Literal bad, LimitMonitor& watch, std::function<void(std::size_t)> progress,
              KnownInvariant known)
        : circuit_(circuit),
          bad_(bad),
          watch_(watch),
          progress_(std::move(progress)),
          known_(std::move(known)),
          justifier_(circuit) {
        for (const Circuit::Latch& latch : circuit.latches) next_[latch.node] = latch.next;
    }

    /// Runs the search and returns its result. Throws Exhausted if a limit is reached; the next call then continues the
    /// search.
    PdrAnswer result() {
        obligations_.clear();
        if (frames_.empty()) add_frame();  // frame 0 represents only the initial state
        if (!solver_) renew();
        if (top() == 0) {
            if (auto found = bad_state(0)) return reached(add(std::move(*found)));
            add_frame();
        }
        for (;; add_frame()) {
            if (progress_) progress_(top());
            while (auto found = bad_state(top())) {
                const std::size_t end = block(add(std::move(*found)));
                if (end != none) return reached(end);
            }
            if (const auto frame = propagated()) return unreached(*frame);
            if (solver_->clauses() > 4 * (live_ + 1000) + clauses_when_new_) renew();
        }
    }

private:
    static constexpr std::size_t none = static_cast<std::size_t>(-1);

    std::size_t top() const { return frames_.size() - 1; }

    // -- the solver ------------------------------------------------------------------------------------------------

    void add_frame() {
        frames_.emplace_back();
        active_.push_back(solver_ ? solver_->fresh() : 0);
    }

    /// Replaces the solver by a new solver. The new solver does not contain clauses that are no longer used.
    void renew() {
        solver_.emplace(circuit_, watch_);
        for (int& each : active_) each = solver_->fresh();
        solver_->all_false_under(active_[0]);
        live_ = 0;
        exclude_known();
        for (std::size_t frame = 1; frame < frames_.size(); ++frame)
            for (const Cube& cube : frames_[frame]) exclude(cube, frame);
        clauses_when_new_ = solver_->clauses();
    }

    /// Excludes the cubes of the known invariant, which contain no reachable state, from all frames.
    void exclude_known() {
        if (invariant_ == nullptr) return;
        for (const Cube& cube : *invariant_) {
            std::vector<int> clause;
            for (const Literal literal : cube) clause.push_back(-solver_->of(literal));
            solver_->add(clause);
        }
    }

    /// Adds the known invariant to the search as soon as the search has made KnownInvariant::after queries.
    void look_for_known() {
        if (!known_.cubes || invariant_ != nullptr || queries_ < known_.after) return;
        invariant_ = &known_.cubes();
        exclude_known();
    }

    void exclude(const Cube& cube, std::size_t frame) {
        std::vector<int> clause{-active_[frame]};
        for (const Literal literal : cube) clause.push_back(-solver_->of(literal));
        solver_->add(clause);
        ++live_;
    }

    /// Returns the assumptions that restrict a query to the states of `frame`. The assumptions exclude the cubes of
    /// this frame and of all later frames.
    std::vector<int> in_frame(std::size_t frame) const {
        return {active_.begin() + static_cast<std::ptrdiff_t>(frame), active_.end()};
    }

    /// True if a step leads into `cube` from a state of the frame. If `from_outside` is true, only steps from states
    /// outside of `cube` count. If no such step exists, stores in `core` a subset of the literals of `cube` that
    /// suffices to exclude such a step.
    bool steps_into(const Cube& cube, std::size_t frame, bool from_outside, Cube& core) {
        std::vector<int> assumptions = in_frame(frame);
        const std::size_t first = assumptions.size();
        std::vector<int> outside;
        for (const Literal literal : cube) {
            assumptions.push_back(solver_->of(next_of(literal)));
            if (from_outside) outside.push_back(-solver_->of(literal));
        }
        ++queries_;
        if (solver_->solve(assumptions, outside)) return true;
        core.clear();
        for (std::size_t i = 0; i < cube.size(); ++i)
            if (solver_->failed(assumptions[first + i])) core.push_back(cube[i]);
        exclude_first_state(core, cube);
        return false;
    }

    Literal next_of(Literal latch) const { return next_.at(node_of(latch)) ^ (latch & 1U); }

    std::vector<Literal> nexts_of(const Cube& cube) const {
        std::vector<Literal> nexts;
        for (const Literal literal : cube) nexts.push_back(next_of(literal));
        return nexts;
    }

    /// Adds literals of `cube` to `core` so that `core` does not contain the initial state. Requires that `cube` does
    /// not contain the initial state.
    static void exclude_first_state(Cube& core, const Cube& cube) {
        if (!holds_first_state(core)) return;
        const auto found = std::ranges::find_if_not(cube, is_inverted);
        assert(found != cube.end());
        core.insert(std::ranges::lower_bound(core, *found), *found);
    }

    /// Returns an obligation with values of latches and inputs that are sufficient to make `targets` true. The values
    /// are those of the satisfying assignment that the solver has found.
    Obligation found_for(const std::vector<Literal>& targets) {
        Justifier::Justification part =
            justifier_.part(targets, [this](Literal literal) { return solver_->value(literal); });
        Obligation found;
        found.state = std::move(part.latches);
        found.inputs = std::move(part.inputs);
        return found;
    }

    std::optional<Obligation> bad_state(std::size_t frame) {
        std::vector<int> assumptions = in_frame(frame);
        assumptions.push_back(solver_->of(bad_));
        if (!solver_->solve(assumptions)) return {};
        Obligation found = found_for({bad_});
        found.frame = frame;
        found.successor = obligations_.size();
        return found;
    }

    // -- blocking --------------------------------------------------------------------------------------------------

    std::size_t add(Obligation obligation) {
        obligations_.push_back(std::move(obligation));
        return obligations_.size() - 1;
    }

    /// Excludes the states of the obligation `first` from its frame and from all later frames; for this purpose, the
    /// function also excludes their predecessors from earlier frames. Returns `none` after success. If the exclusion is
    /// impossible, returns the index of an obligation that contains the initial state.
    std::size_t block(std::size_t first) {
        const auto later = [this](std::size_t a, std::size_t b) {
            const Obligation &one = obligations_[a], &other = obligations_[b];
            return one.frame != other.frame ? one.frame > other.frame : one.depth > other.depth;
        };
        std::priority_queue<std::size_t, std::vector<std::size_t>, decltype(later)> open(later);
        open.push(first);
        while (!open.empty()) {
            look_for_known();
            const std::size_t at = open.top();
            const Cube state = obligations_[at].state;
            const std::size_t frame = obligations_[at].frame;
            if (frame == 0 || holds_first_state(state)) return at;
            open.pop();
            Cube core;
            if (!is_excluded(state, frame)) {
                if (steps_into(state, frame - 1, true, core)) {
                    Obligation before = found_for(nexts_of(state));
                    before.frame = frame - 1;
                    before.successor = at;
                    before.depth = obligations_[at].depth + 1;
                    open.push(at);
                    open.push(add(std::move(before)));
                    continue;
                }
                block_cube(std::move(core), frame);
            }
            if (frame < top()) {
                obligations_[at].frame = frame + 1;
                open.push(at);
            }
        }
        obligations_.clear();
        return none;
    }

    bool is_excluded(const Cube& state, std::size_t frame) const {
        for (std::size_t i = frame; i < frames_.size(); ++i)
            for (const Cube& cube : frames_[i])
                if (contains(state, cube)) return true;
        return false;
    }

    /// Generalizes the cube and excludes the result from the frame and from each following frame, as long as the
    /// exclusion is possible.
    void block_cube(Cube cube, std::size_t frame, bool obstacles = false) {
        generalise(cube, frame - 1, obstacles);
        Cube core;
        while (frame < top() && !steps_into(cube, frame, true, core)) {
            cube = core;
            ++frame;
        }
        for (std::size_t i = 1; i <= frame; ++i)
            std::erase_if(frames_[i], [&](const Cube& each) { return contains(each, cube); });
        for (const Literal literal : cube) ++uses_[literal];
        exclude(cube, frame);
        frames_[frame].push_back(std::move(cube));
    }

    /// Removes literals from the cube that are not necessary for its exclusion. The least frequently used literals are
    /// tried first.
    void generalise(Cube& cube, std::size_t before, bool obstacles) {
        Cube order = cube;
        std::ranges::stable_sort(order, {}, [this](Literal literal) {
            const auto found = uses_.find(literal);
            return found == uses_.end() ? 0U : found->second;
        });
        for (const Literal literal : order) {
            if (cube.size() == 1 || !std::ranges::binary_search(cube, literal)) continue;
            Cube fewer = cube;
            std::erase(fewer, literal);
            if (excludes(fewer, before, obstacles)) cube = std::move(fewer);
        }
    }

    /// True if no step leads from a state of the frame `before` that is outside of `cube` into `cube`. In this case,
    /// removes literals from `cube` that are not necessary to exclude such a step. If a state of the frame has a step
    /// into `cube`, but the state has no predecessor in the previous frame, the function first excludes this state. At
    /// most three states are excluded in this way (Hassan, Bradley and Somenzi 2013: "Better generalization in IC3").
    bool excludes(Cube& cube, std::size_t before, bool obstacles) {
        if (holds_first_state(cube)) return false;
        Cube core;
        for (unsigned left = 3; steps_into(cube, before, true, core); --left) {
            if (obstacles || left == 0 || before == 0) return false;
            const Cube state = found_for(nexts_of(cube)).state;
            if (holds_first_state(state) || steps_into(state, before - 1, true, core)) return false;
            block_cube(std::move(core), before, true);
        }
        cube = std::move(core);
        return true;
    }

    /// Moves each cube to the list of the next frame if the cube can also be excluded from the next frame. Returns the
    /// first frame whose list of cubes becomes empty, or nullopt if every list still contains a cube. A frame with an
    /// empty list and the next frame exclude the same states.
    std::optional<std::size_t> propagated() {
        for (std::size_t frame = 1; frame < top(); ++frame) {
            const std::vector<Cube> cubes = frames_[frame];
            for (const Cube& cube : cubes) {
                Cube core;
                if (std::ranges::find(frames_[frame], cube) == frames_[frame].end()) continue;
                if (steps_into(cube, frame, false, core)) continue;
                for (std::size_t i = 1; i <= frame + 1; ++i)
                    std::erase_if(frames_[i], [&](const Cube& each) { return contains(each, core); });
                exclude(core, frame + 1);
                frames_[frame + 1].push_back(std::move(core));
            }
            if (frames_[frame].empty()) return frame;
        }
        return {};
    }

    // -- results ---------------------------------------------------------------------------------------------------

    PdrAnswer reached(std::size_t at) const {
        PdrAnswer answer{.reached = true, .frames = top()};
        std::unordered_map<std::uint32_t, std::size_t> place;
        for (std::size_t i = 0; i < circuit_.inputs.size(); ++i) place[circuit_.inputs[i].node] = i;
        for (;;) {
            std::vector<bool>& inputs = answer.inputs.emplace_back(circuit_.inputs.size());
            for (const Literal literal : obligations_[at].inputs)
                inputs[place.at(node_of(literal))] = !is_inverted(literal);
            if (obligations_[at].successor == at) return answer;
            at = obligations_[at].successor;
        }
    }

    PdrAnswer unreached(std::size_t frame) const {
        PdrAnswer answer{.frames = top()};
        for (std::size_t i = frame + 1; i < frames_.size(); ++i)
            answer.invariant.insert(answer.invariant.end(), frames_[i].begin(), frames_[i].end());
        if (invariant_ != nullptr)
            answer.invariant.insert(answer.invariant.end(), invariant_->begin(), invariant_->end());
        return answer;
    }

    const Circuit& circuit_;
    Literal bad_;
    LimitMonitor& watch_;
    std::function<void(std::size_t)> progress_;
    KnownInvariant known_;
    const std::vector<Cube>* invariant_ = nullptr;  ///< the cubes of `known_`; null until the search uses them
    std::uint64_t queries_ = 0;
    Justifier justifier_;
    std::unordered_map<std::uint32_t, Literal> next_ = {};  ///< maps the node of each latch to the literal of its next
                                                            ///< value
    std::optional<Solver> solver_ = {};
    /// For each frame: the cubes that this frame excludes, but the next frame does not exclude.
    std::vector<std::vector<Cube>> frames_ = {};
    std::vector<int> active_ = {};  ///< for each frame: the assumption that activates its clauses
    std::vector<Obligation> obligations_ = {};
    std::unordered_map<Literal, unsigned> uses_ = {};
    std::uint64_t live_ = 0, clauses_when_new_ = 0;
};

}  // namespace

PdrAnswer reach(const Circuit& circuit, Literal bad, LimitMonitor& watch,
                const std::function<void(std::size_t)>& progress, KnownInvariant known) {
    return PdrSearch(circuit, bad, watch, progress, std::move(known)).result();
}

std::function<PdrAnswer()> search_for(const Circuit& circuit, Literal bad, LimitMonitor& watch,
                                      std::function<void(std::size_t)> progress, KnownInvariant known) {
    return [search = std::make_shared<PdrSearch>(circuit, bad, watch, std::move(progress), std::move(known))] {
        return search->result();
    };
}

}  // namespace grafverif::pdr
