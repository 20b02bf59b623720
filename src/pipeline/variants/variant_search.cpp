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

/// Bounds of the searches of a variant, if the check is repeated completely: at least; the same in passes.
constexpr std::uint64_t least_bound = 100'000, least_bound_in_passes = std::uint64_t{1} << 20U;

/// `network` with the observer of `property`, which is then its only property.
Network with_observer(const Network& network, Id<Property> property) {
    Network made = observed(network, {property});
    const Property decided = element_of(made.properties, network.properties[property].name, &Property::name);
    made.properties = {};
    made.properties.add(decided);
    return made;
}

}  // namespace

VariantSearch::VariantSearch(const CheckOptions& options, const Report& report, const VariantBounds& bounds)
    : options_(options) {
    SearchEffort last;
    std::uint64_t states = 0;
    bool abstracted = false;
    for (const PropertyResult& answer : report.answers) {
        states = std::max<std::uint64_t>(states, std::stoull("0" + answer.verdict.states));
        abstracted = abstracted || answer.verdict.abstraction.has_value();
        // Localization most often decides these properties again, so the complete network is searched only briefly
        // before.
        if (answer.verdict.scope.cells) last.begin.whole = bounds.brief;
    }
    const bool in_passes = (states > bounds.few_states || abstracted) && !options.whole;
    most_states_ =
        options.limits.states.value_or(std::max(8 * states, in_passes ? least_bound_in_passes : least_bound));
    last.rounds = std::min(last.rounds, most_states_);
    if (in_passes)
        for (const std::uint64_t states_of_round : {input_rounds[0], input_rounds[1]})
            efforts_.push_back({{.whole = bounds.brief, .local = states_of_round}, states_of_round, false});
    efforts_.push_back(last);
}

std::string_view VariantSearch::reason() const {
    return is_over(options_.limits.deadline) ? "time limit reached" : "stopped";
}

std::vector<Verdict> VariantSearch::operator()(const Network& network, std::vector<std::string> names,
                                               const SearchEffort& effort, const Deadline& deadline) {
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
    StagedSearch search(loop, observe, watched ? observed : network, options, false);
    search.begin(deadline, effort.begin);
    for (const std::uint64_t states : input_rounds)
        if (states <= effort.rounds && search.needs_whole()) (void)search.refine(states, deadline);
    if (effort.complete && search.needs_whole()) search.search_complete(deadline);
    return search.result().verdicts;
}

}  // namespace grafverif
