// SPDX-License-Identifier: MIT
#include "check/inputs/response.hpp"

#include <algorithm>
#include <map>
#include <memory>
#include <set>

#include "check/inputs/avoiding_runs.hpp"
#include "ir/slots.hpp"

namespace grafverif {

namespace {

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

class ResponseProof {
public:
    using Levels = AvoidingRuns::Levels;

    ResponseProof(const Network& loop, const std::vector<AbstractableProcess>& instances, const Property& property,
                  const FollowLimits& limits, const InputAblations& ablations)
        : loop_(loop), instances_(instances), property_(property), limits_(limits), ablations_(ablations) {
        const std::set<Id<Network::Process>> read = instances_read_by(loop, instances, property);
        finest_ = panel_levels(loop, instances, read);
        coarsest_ = levels_with_plant(loop, instances, finest_, read);
    }

    ResponseResult result() {
        result_.levels = coarsest_;
        const std::optional<bool> holds = excludes(coarsest_, nullptr);
        if (const auto& first = explored_[coarsest_]) result_.vacuous = first->vacuous();
        result_.holds = limited_ && holds == false ? std::nullopt : holds;
        return result_;
    }

private:
    /// The runs that remain in an abstraction.
    struct Remaining {
        std::unique_ptr<AvoidingRuns> runs = {};
        std::vector<Remainder> remainders = {};
        std::size_t situations = 0;  // number of situations of the coarser abstraction in which the runs remain
    };

    FollowLimits left() const {  // the abstractions share the limits
        FollowLimits limits = limits_;
        limits.states -= std::min(limits.states, result_.states);
        limits.bytes -= std::min(limits.bytes, bytes_);
        return limits;
    }

    /// Adds the result of an exploration. Returns true if the exploration is complete.
    bool is_complete(const AvoidingRuns& runs, const std::optional<bool>& explored) {
        result_.states += runs.states();
        bytes_ += runs.bytes();
        limited_ = limited_ || !explored;
        if (explored != true) return false;
        for (std::size_t i = 0; i < result_.levels.size(); ++i)
            result_.levels[i] = std::max(result_.levels[i], runs.levels()[i]);
        return true;
    }

    /// Returns the states of a Chosen process; null if the process is not supported.
    const ProcessStates* local(std::size_t instance) {
        const Id<Network::Process> id = instances_[instance].process;
        const auto [found, is_new] = locals_.try_emplace(instance);
        if (is_new) {
            auto states = std::make_unique<ProcessStates>(loop_, users_, clocks_[id.index], id, unlimited_);
            if (states->explore()) found->second = std::move(states);
        }
        return found->second.get();
    }

    /// Returns the number of combinations of states of the processes that `fine` stores and `coarse` does not store.
    double combinations(const Levels& coarse, const Levels& fine) {
        double found = 1;
        for (std::size_t i = 0; i < fine.size(); ++i)
            if (const ProcessStates* const states = fine[i] == coarse[i] ? nullptr : local(i))
                found *= static_cast<double>(states->states().size());
        return found;
    }

    /// Explores a refinement of `coarser` in the situations of the remainder. Returns nullopt if the refinement is not
    /// supported, or a limit is reached.
    std::optional<Remaining> refined(const AvoidingRuns& coarser, const Remainder& remainder, const Levels& levels) {
        std::vector<const ProcessStates*> stored;
        for (std::size_t i = 0; i < levels.size(); ++i)
            if (levels[i] != coarser.levels()[i]) {
                stored.push_back(local(i));
                if (stored.back() == nullptr) return {};
            }
        const double starts = combinations(coarser.levels(), levels) * static_cast<double>(remainder.starts.size());
        if (starts > static_cast<double>(left().states)) {
            limited_ = true;
            return {};
        }
        Remaining made{std::make_unique<AvoidingRuns>(loop_, instances_, property_, levels, &remainder)};
        ++result_.refinements;
        if (!is_complete(*made.runs, made.runs->explore(coarser, stored, left(), ablations_))) return {};
        auto remainders = made.runs->remaining(nullptr, limits_);
        limited_ = limited_ || !remainders;
        if (!remainders) return {};
        made.remainders = std::move(*remainders);
        made.situations = count_of(made.remainders, remainder.last.columns);
        return made;
    }

    /// Excludes runs that avoid q and finally remain in the situations `within` (all situations, if null). Explores all
    /// states of the abstraction.
    std::optional<bool> excludes(const Levels& levels, const Situations* within) {
        const auto [found, is_new] = explored_.try_emplace(levels);
        if (is_new) {
            auto runs = std::make_unique<AvoidingRuns>(loop_, instances_, property_, levels);
            if (is_complete(*runs, runs->explore(left()))) found->second = std::move(runs);
        }
        if (!found->second) return false;
        AvoidingRuns& runs = *found->second;
        auto remainders = runs.remaining(within, limits_);
        if (!remainders) return {};
        for (Remainder& one : *remainders) {
            if (refinements_exclude(runs, one)) continue;
            Levels all = levels;
            for (const std::size_t instance : one.deciding) all[instance] = finest_[instance];
            store_what_is_read(instances_, all);
            if (all == levels) all = finest_;
            if (all == levels) return false;
            if (const std::optional<bool> done = excludes(all, &one.last); done != true) return done;
        }
        return true;
    }

    /// True if refinements exclude the remaining runs of an abstraction. Stores one more process at a time, because one
    /// process usually suffices.
    bool refinements_exclude(AvoidingRuns& runs, Remainder& remainder) {
        const auto is_chosen = [&](std::size_t instance) { return runs.levels()[instance] != finest_[instance]; };
        if (loop_.controllers.size() != 1 || std::ranges::none_of(remainder.deciding, is_chosen)) return false;
        if (!runs.find_starts(remainder, limits_)) return false;
        std::set<Levels> tried = {runs.levels()};
        std::optional<Remaining> best;
        const auto attempt = [&](Levels levels) {
            store_what_is_read(instances_, levels);
            if (!tried.insert(levels).second) return;
            std::optional<Remaining> made = refined(runs, remainder, levels);
            if (made && (!best || made->situations < best->situations)) best = std::move(made);
        };
        Levels all = runs.levels();
        // Levels with one more process, by the number of combinations of states of the additional processes.
        std::multimap<double, Levels> single;
        for (const std::size_t instance : remainder.deciding) {
            all[instance] = finest_[instance];
            Levels one = runs.levels();
            one[instance] = finest_[instance];
            store_what_is_read(instances_, one);
            single.emplace(combinations(runs.levels(), one), std::move(one));
        }
        for (const auto& [combinations, levels] : single) {
            attempt(levels);
            if (best && best->remainders.empty()) return true;
        }
        if (!best || best->situations == remainder.last.values.size()) attempt(all);
        return best && std::ranges::all_of(best->remainders,
                                           [&](Remainder& one) { return refinements_exclude(*best->runs, one); });
    }

    /// Returns the number of different situations, with regard to some columns.
    static std::size_t count_of(const std::vector<Remainder>& remainders, const std::vector<std::uint32_t>& columns) {
        Situations all;
        for (const Remainder& one : remainders) all.values.merge(one.last.restricted_to(columns).values);
        return all.values.size();
    }

    const Network& loop_;
    const std::vector<AbstractableProcess>& instances_;
    const Property& property_;
    const FollowLimits& limits_;
    const InputAblations& ablations_;
    const TimedOptions options_ = {};
    const timed::Limits unlimited_{options_};
    const VariableUsers users_{loop_};
    const std::vector<ProcessClocks> clocks_ = analyse_clocks(loop_);
    Levels coarsest_ = {}, finest_ = {};
    // By index of the process in the list of processes; null if the states of the process are unknown.
    std::map<std::size_t, std::unique_ptr<ProcessStates>> locals_ = {};
    // The abstractions with all their states; null if an abstraction is not supported or reached a limit.
    std::map<Levels, std::unique_ptr<AvoidingRuns>> explored_ = {};
    std::uint64_t bytes_ = 0;  // memory of all abstractions
    bool limited_ = false;     // true if a limit has ended an exploration
    ResponseResult result_ = {};
};

}  // namespace

ResponseResult prove_response(const Network& loop, const std::vector<AbstractableProcess>& instances,
                              const Property& property, const FollowLimits& limits, const InputAblations& ablations) {
    return ResponseProof(loop, instances, property, limits, ablations).result();
}

}  // namespace grafverif
