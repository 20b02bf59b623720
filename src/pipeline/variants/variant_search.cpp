// SPDX-License-Identifier: MIT
#include "pipeline/variants/variant_search.hpp"

#include <algorithm>
#include <functional>
#include <iterator>
#include <utility>

#include "compose/observe.hpp"
#include "pipeline/staged_search.hpp"
#include "support/element_of.hpp"

namespace grafverif {

namespace {

/// Lower limits for the maximum number of states of a search: `least_bound` for a search in one pass,
/// `least_bound_in_passes` for a search in several passes.
constexpr std::uint64_t least_bound = 100'000, least_bound_in_passes = std::uint64_t{1} << 20U;

/// Returns `network` with the observer of `property`, and without all other properties.
Network with_observer(const Network& network, Id<Property> property) {
    Network made = observed(network, {property});
    const Property decided = element_of(made.properties, network.properties[property].name, &Property::name);
    made.properties = {};
    made.properties.add(decided);
    return made;
}

bool is_decided(const Verdict& verdict) {
    return verdict.outcome == Outcome::Holds && verdict.pattern != Pattern::ReachableAllSteps;
}

}  // namespace

VariantSearch::VariantSearch(const CheckOptions& options, const Report& report, const VariantBounds& bounds)
    : options_(options) {
    SearchEffort last;
    std::uint64_t states = 0, abstract_states = search_rounds[0];
    for (const PropertyResult& answer : report.answers) {
        const std::uint64_t own = std::stoull("0" + answer.verdict.states);
        states = std::max(states, own);
        if (answer.verdict.abstraction && is_decided(answer.verdict)) {
            known_.emplace(answer.verdict.property, *answer.verdict.abstraction);
            abstract_states = std::max(abstract_states, 2 * own);
        }
        // If localization decided a property of the original model, it usually also decides this property in the
        // variants. Therefore the complete network is searched only briefly before localization.
        if (answer.verdict.scope.cells) last.begin.whole = bounds.brief;
    }
    const bool in_passes = (states > bounds.few_states || !known_.empty()) && !options.whole;
    most_states_ =
        options.limits.states.value_or(std::max(8 * states, in_passes ? least_bound_in_passes : least_bound));
    for (const std::uint64_t round : search_rounds)
        if (round <= most_states_) last.rounds.push_back(round);
    if (in_passes && !known_.empty())
        efforts_.push_back({{.whole = bounds.brief, .local = 0}, {abstract_states}, false, true});
    if (in_passes)
        for (const std::uint64_t round : {search_rounds[0], search_rounds[1]})
            efforts_.push_back({{.whole = bounds.brief, .local = round}, {round}, false});
    efforts_.push_back(last);
}

std::string_view VariantSearch::reason() const {
    return is_over(options_.limits.deadline) ? "time limit reached" : "stopped";
}

std::vector<Verdict> VariantSearch::operator()(const Network& network, std::vector<std::string> names,
                                               const SearchEffort& effort, const Deadline& deadline) {
    if (effort.known) std::erase_if(names, [&](const std::string& name) { return !known_.contains(name); });
    std::vector<Id<Property>> by_observers = watched(network);
    std::erase_if(by_observers, [&](Id<Property> id) { return std::erase(names, network.properties[id].name) == 0; });
    std::vector<Verdict> found;
    const auto over = [&] { return stopped() || is_over(deadline); };
    if (!names.empty() && !over()) found = searched(network, names, effort, deadline, {});
    for (const Id<Property> id : by_observers)
        if (!over())
            std::ranges::move(searched(network, {network.properties[id].name}, effort, deadline, id),
                              std::back_inserter(found));
    return found;
}

std::vector<Verdict> VariantSearch::searched(const Network& network, const std::vector<std::string>& names,
                                             const SearchEffort& effort, const Deadline& deadline,
                                             std::optional<Id<Property>> watched) {
    ++searches_;
    CheckOptions options;
    options.properties = names;
    options.whole = options_.whole;
    options.jobs = options_.jobs;
    options.limits = options_.limits;
    options.limits.states = most_states_;
    options.limits.deadline = deadline;
    options.limits.progress = {};
    const Observe observe = [&](const Network& of) { return watched ? with_observer(of, *watched) : of; };
    const Network observed = watched ? observe(network) : Network{};
    const LoopToCheck loop{network};
    StagedSearch search(loop, observe, watched ? observed : network, options, {.timelock = false, .profile = false});
    InputLimits inputs;
    if (effort.known) inputs = {.alternatives = 0, .explored = 0, .coarse_rounds = 2, .known = known_};
    search.begin(deadline, effort.begin, inputs);
    for (const std::uint64_t states : effort.rounds)
        if (search.needs_whole()) (void)search.refine(states, deadline);
    if (effort.complete && search.needs_whole()) search.search_complete(deadline);
    return search.result().verdicts;
}

}  // namespace grafverif
