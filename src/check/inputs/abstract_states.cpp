// SPDX-License-Identifier: MIT
#include "check/inputs/abstract_states.hpp"

#include <algorithm>
#include <utility>

#include "check/timed/store/store.hpp"

namespace grafverif {

using timed::Word;

std::vector<InputLevel> panel_levels(const Network& loop, const std::vector<AbstractableProcess>& instances,
                                     const std::set<Id<Network::Process>>& read, bool all) {
    std::vector<InputLevel> levels;
    std::size_t splits = 0;
    for (const AbstractableProcess& instance : instances) {
        const std::size_t more = instance.valuations.size() * std::max<std::size_t>(loop.controllers.size(), 1);
        const bool returns = all ? instance.autonomous && instance.can_rest : instance.returns;
        const bool is_chosen = returns && !instance.valuations.empty() && !read.contains(instance.process) &&
                               splits + more <= timed::Choices::most_splits;
        if (is_chosen) splits += more;
        levels.push_back(is_chosen ? InputLevel::Chosen : InputLevel::Untimed);
    }
    store_what_is_read(instances, levels);
    return levels;
}

std::vector<InputLevel> levels_with_plant(const Network& loop, const std::vector<AbstractableProcess>& instances,
                                          std::vector<InputLevel> levels, const std::set<Id<Network::Process>>& read) {
    std::size_t splits = 0;
    for (std::size_t i = 0; i < instances.size(); ++i)
        if (levels[i] == InputLevel::Chosen) splits += instances[i].valuations.size();
    for (std::size_t i = 0; i < instances.size(); ++i) {
        const std::size_t more = instances[i].valuations.size();
        const bool is_timer = loop.processes[instances[i].process].kind == Network::ProcessKind::Timer;
        if (levels[i] == InputLevel::Chosen || is_timer || more == 0 || read.contains(instances[i].process) ||
            splits + more > timed::Choices::most_splits)
            continue;
        levels[i] = InputLevel::Chosen;
        splits += more;
    }
    store_what_is_read(instances, levels);
    return levels;
}

AbstractStates::AbstractStates(const Network& loop, const std::vector<AbstractableProcess>& instances,
                               const std::vector<InputLevel>& levels)
    : unstored_(loop.variables.size()) {
    build(loop, instances, levels);
}

AbstractStates::AbstractStates(const Network& loop, const std::vector<AbstractableProcess>& instances,
                               const std::vector<InputLevel>& levels, const std::string& property, Admits admits)
    : admits_(std::move(admits)), records_(true) {
    Network one = loop;  // the loop with only one property
    for (const Property& other : std::exchange(one.properties, {}))
        if (other.name == property) one.properties.add(other);
    one.settled = {};
    unstored_ = timed::unread_variables(one);
    build(one, instances, levels);
}

void AbstractStates::build(const Network& loop, const std::vector<AbstractableProcess>& instances,
                           const std::vector<InputLevel>& levels) {
    InputAbstraction abstraction = abstract_inputs(loop, instances, levels);
    network_ = grafverif::expand(abstraction.network);
    machine_.emplace(network_, std::move(abstraction.choices), unstored_);
    const timed::Layout& layout = machine_->layout();
    states_ = std::make_unique<PackedStates>(layout.stored);
    now_.assign(layout.words, 0);
    failed_ = !layout.fits() || machine_->timed();
    if (!failed_ && !admits_) states_->add(timed::packed_initial(network_, layout).data());
}

bool AbstractStates::all_wait(const Word* words) const {
    return std::ranges::all_of(network_.controllers, [&](const Network::Controller& controller) {
        return machine_->layout().locations[controller.process.index].get(words) == controller.waiting.index;
    });
}

const timed::Moves& AbstractStates::expand(std::uint32_t state, bool with_choices) {
    moves_.record_choices = with_choices;
    std::copy_n(states_->words(state), machine_->layout().stored, now_.begin());
    machine_->expand(now_.data(), moves_);
    return moves_;
}

std::uint32_t AbstractStates::successor(std::size_t move) {
    const Word* const words = moves_.words.data() + move * machine_->layout().words;
    if (admits_ && !admits_(now_.data(), moves_.edges[move], words)) return timed::Store::none;
    return states_->add(words).state;
}

void AbstractStates::copy(const Word* state, const timed::Layout& to, Word* words) const {
    const timed::Layout& from = machine_->layout();
    for (const Id<Network::Process> process : network_.processes.ids())
        to.locations[process.index].set(words, from.locations[process.index].get(state));
    for (const Id<Network::Variable> variable : network_.variables.ids())
        if (!network_.variables[variable].scratch && !unstored_[variable.index])
            to.variables[variable.index].set(words, from.variables[variable.index].get(state));
}

/// True if the expanded state permits the use of the abstraction: the state has no model error, no race and not too
/// many combinations of inputs, and each PLC is in its waiting location W or has an enabled urgent edge.
bool AbstractStates::is_supported() const {
    if (moves_.fault || moves_.cut) return false;
    const timed::Layout& layout = machine_->layout();
    if (machine_->has_race(now_.data())) return false;
    return std::ranges::all_of(network_.controllers, [&](const Network::Controller& controller) {
        if (layout.locations[controller.process.index].get(now_.data()) == controller.waiting.index) return true;
        return std::ranges::any_of(moves_.edges, [&](std::uint32_t edge) {
            return machine_->process_of(edge) == controller.process && machine_->urgent(edge);
        });
    });
}

std::optional<bool> AbstractStates::run(const FollowLimits& limits) {
    for (std::size_t polls = 0; !failed_ && next_ < states_->size(); ++polls) {
        if (states_->size() >= limits.states || bytes() > limits.bytes) return {};
        if (polls % search_poll_interval == 0 && is_over(limits.deadline, limits.stop)) return {};
        expand(static_cast<std::uint32_t>(next_++));
        failed_ = !is_supported();
        if (records_) first_moves_.push_back(recorded_.size());
        for (std::size_t move = 0; move < moves_.edges.size() && !failed_; ++move) {
            const std::uint32_t next = successor(move);
            if (records_) recorded_.push_back({moves_.edges[move], next});
        }
    }
    return !failed_;
}

}  // namespace grafverif
