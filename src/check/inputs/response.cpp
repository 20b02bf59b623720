// SPDX-License-Identifier: MIT
#include "check/inputs/response.hpp"

#include <algorithm>
#include <set>
#include <unordered_map>

#include "check/inputs/abstract_states.hpp"
#include "check/timed/components.hpp"
#include "ir/slots.hpp"

namespace grafverif {

namespace {

using timed::End;
using timed::Word;

/// Returns all processes whose locations the property reads and all instances whose outputs the property reads.
std::set<Id<Network::Process>> instances_read_by(const Network& loop, const std::vector<AbstractableProcess>& instances,
                                                 const Property& property) {
    std::set<Id<Network::Process>> found;
    for (const Id<Expr> operand : property.operands)
        for (const Id<Expr> leaf : leaves(loop.exprs, operand)) {
            const Expr& node = loop.exprs[leaf];
            if (node.op == Op::At) found.insert({at_process(node)});
            for (const AbstractableProcess& instance : instances)
                for (const Id<Network::Variable> output : instance.outputs)
                    if (node.op == Op::Variable && static_cast<std::uint32_t>(node.value) == output.index)
                        found.insert(instance.process);
        }
    return found;
}

class Response {
public:
    Response(const Network& loop, const std::vector<AbstractableProcess>& instances, const Property& property,
             const std::vector<InputLevel>& levels)
        : loop_(loop),
          states_(loop, instances, levels),
          property_(*std::ranges::find(states_.network().properties, property.name, &Property::name)),
          is_inevitable_(property.pattern == Pattern::Inevitable),
          p_(is_inevitable_ ? timed::Program::yes : compiled(property_.operands.front())),
          q_(compiled(property_.operands.back())),
          is_stored_(loop.processes.size(), true) {
        for (std::size_t i = 0; i < instances.size(); ++i)
            is_stored_[instances[i].process.index] = levels[i] != InputLevel::Chosen;
    }

    std::optional<bool> run(const FollowLimits& limits) {
        if (const std::optional<bool> found = states_.run(limits); !found || !*found) return found;
        TimedOptions options;
        options.deadline = limits.deadline;
        options.stop = limits.stop;
        const timed::Limits polled(options);
        try {
            return no_run_avoids(polled);
        } catch (const timed::Limits::Stop&) {
            return {};
        }
    }

    bool vacuous() const { return !requested_; }
    /// Returns the Chosen instances (indices in the list of instances) whose values can end the runs without q that
    /// `run` has found.
    const std::set<std::size_t>& deciding() const { return deciding_; }
    std::size_t states() const { return states_.size(); }

private:
    /// Properties of a strongly connected component of states without q.
    struct Component {
        bool urgent = true;                // true if an urgent edge is enabled in each state of the component
        std::vector<bool> moves = {};      // per process: true if one of its edges connects two states of the component
        std::vector<bool> unbounded = {};  // per process: true if, in some state, the invariant of its location has no
                                           // bound
    };

    std::uint32_t compiled(Id<Expr> term) {
        return states_.machine().compiler().condition(term, timed::Program::yes, timed::Program::no);
    }

    /// True if `term` is true or undefined in the state.
    bool may_hold(std::uint32_t term, std::uint32_t state) {
        return states_.machine().holds(term, states_.words(state), registers_) != End::No;
    }
    bool is_goal(std::uint32_t state) {
        return states_.machine().holds(q_, states_.words(state), registers_) == End::Yes;
    }

    bool is_urgent(const timed::Moves& moves) const {
        return std::ranges::any_of(moves.edges, [&](std::uint32_t move) {
            const auto process = states_.machine().process_of(move);
            const auto edge = states_.machine().edge_of(move);
            const Network::Template& automaton = loop_.templates[loop_.processes[process].automaton];
            return edge.index < automaton.edges.size() && automaton.edges[edge].urgent;
        });
    }

    /// True if the process is stored, and the invariant of its location in the state has a bound.
    bool is_bounded(std::uint32_t process, std::uint32_t state) const {
        if (!is_stored_[process]) return false;
        const auto location = states_.machine().layout().locations[process].get(states_.words(state));
        const Network::Template& automaton = loop_.templates[loop_.processes[{process}].automaton];
        return !automaton.locations[{static_cast<std::uint32_t>(location)}].invariant.empty();
    }

    bool no_run_avoids(const timed::Limits& limits) {
        timed::Components components(states_.size(), limits, [&](std::uint32_t state, const auto& take) {
            const std::size_t moves = states_.expand(state).edges.size();
            for (std::size_t move = 0; move < moves; ++move)
                if (const std::uint32_t next = states_.successor(move); !is_goal(next)) take(next);
        });
        for (std::uint32_t state = 0; state < (is_inevitable_ ? 1 : states_.size()); ++state) {
            if (!may_hold(p_, state)) continue;
            requested_ = true;
            if (!is_goal(state)) components.visit(state);
        }
        std::unordered_map<std::uint32_t, Component> found;
        for (std::uint32_t state = 0; state < states_.size(); ++state) {
            limits.poll();
            if (components.of(state) == timed::Store::none) continue;
            if (may_stay(state)) return fails_in(components.of(state), components, limits);
            if (components.has_cycle(state)) add(state, components, found[components.of(state)]);
        }
        const auto repeated = std::ranges::find_if(found, [&](const auto& entry) { return may_repeat(entry.second); });
        return repeated == found.end() || fails_in(repeated->first, components, limits);
    }

    /// Finds the Chosen instances whose values enable moves out of `component`, in which a run may stay. Returns false.
    template <class Components>
    bool fails_in(std::uint32_t component, const Components& components, const timed::Limits& limits) {
        const std::vector<InputChoice>& choices = states_.machine().choices();
        for (std::uint32_t state = 0; state < states_.size(); ++state) {
            limits.poll();
            if (components.of(state) != component) continue;
            const timed::Moves& moves = states_.expand(state, true);
            for (std::size_t move = 0; move < moves.edges.size(); ++move) {
                if (components.of(states_.successor(move)) == component) continue;
                for (std::size_t i = 0; i < choices.size(); ++i) {
                    if (states_.machine().process_of(moves.edges[move]) != choices[i].plc) continue;
                    const Word all = ~Word{0} >> (64 - choices[i].valuations.size());
                    if ((moves.chosen[move * choices.size() + i] & all) != all) deciding_.insert(choices[i].instance);
                }
            }
        }
        return false;
    }

    /// True if time can pass forever in the state.
    bool may_stay(std::uint32_t state) {
        if (is_urgent(states_.expand(state))) return false;
        for (std::uint32_t process = 0; process < loop_.processes.size(); ++process)
            if (is_bounded(process, state)) return false;
        return true;
    }

    template <class Components>
    void add(std::uint32_t state, const Components& components, Component& component) {
        component.moves.resize(loop_.processes.size());
        component.unbounded.resize(loop_.processes.size());
        const timed::Moves& moves = states_.expand(state);
        component.urgent = component.urgent && is_urgent(moves);
        for (std::size_t move = 0; move < moves.edges.size(); ++move)
            if (components.of(states_.successor(move)) == components.of(state))
                component.moves[states_.machine().process_of(moves.edges[move]).index] = true;
        for (std::uint32_t process = 0; process < loop_.processes.size(); ++process)
            if (!is_bounded(process, state)) component.unbounded[process] = true;
    }

    /// True if a run in which time diverges can stay in the component forever.
    bool may_repeat(const Component& component) const {
        if (component.urgent) return false;
        for (std::size_t process = 0; process < loop_.processes.size(); ++process)
            if (!component.unbounded[process] && !component.moves[process]) return false;
        return true;
    }

    const Network& loop_;
    AbstractStates states_;
    const Property& property_;  // the property, with terms of the abstraction
    const bool is_inevitable_;
    const std::uint32_t p_, q_;
    std::vector<bool> is_stored_;          // per process: false for instances with the level Chosen
    std::set<std::size_t> deciding_ = {};  // result of `deciding`
    bool requested_ = false;
    std::vector<std::int64_t> registers_ = {};
};

}  // namespace

ResponseResult prove_response(const Network& loop, const std::vector<AbstractableProcess>& instances,
                              const Property& property, const FollowLimits& limits) {
    ResponseResult result;
    const std::set<Id<Network::Process>> read = instances_read_by(loop, instances, property);
    const std::vector<InputLevel> finest = panel_levels(loop, instances, read);
    result.levels = levels_with_plant(loop, instances, finest, read);
    while (true) {
        FollowLimits left = limits;  // the abstractions share the maximum number of states
        left.states -= std::min(left.states, result.states);
        Response response(loop, instances, property, result.levels);
        result.holds = response.run(left);
        result.vacuous = response.vacuous();
        result.states += response.states();
        if (result.holds != false) return result;
        const std::vector<InputLevel> before = result.levels;
        for (const std::size_t instance : response.deciding()) result.levels[instance] = finest[instance];
        store_what_is_read(instances, result.levels);
        if (result.levels != before) continue;
        if (result.levels == finest) return result;
        result.levels = finest;
    }
}

}  // namespace grafverif
