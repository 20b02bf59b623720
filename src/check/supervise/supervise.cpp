// SPDX-License-Identifier: MIT
// Synthesizes the conditions of a supervisor from the solution of a game (see game.hpp). The synthesis explores the
// states that are reachable under the current conditions. If an evolution reaches a losing state, the synthesis
// recomputes all conditions for the explored states and continues the exploration, until no evolution reaches a losing
// state. Two further types of states are treated as losing: states that the observations do not distinguish
// sufficiently, and states from which no marked state is reachable under the conditions. If states of these types
// exist, the synthesis is restarted; the resulting conditions are still sound and are classified as `Cautious`.
#include "check/supervise/supervise.hpp"

#include <algorithm>
#include <new>
#include <utility>

#include "check/supervise/cover.hpp"
#include "check/supervise/game.hpp"
#include "check/supervise/observation_map.hpp"
#include "check/symbolic/paths.hpp"
#include "grafverif/ir/verdict.hpp"

namespace grafverif {

namespace supervise {

namespace {

constexpr std::size_t most_products = 64;  ///< maximum number of terms (products) of a condition

using symbolic::StateSpace;

/// A policy: the permissions that the supervisor refuses to one controller (player). `refusals` contains, for each
/// permission, the observations for which the permission is refused; for outputs, these are the observations after the
/// evolution. `obeyed` represents the same policy as a function of states and permissions.
struct Policy {
    std::vector<Bdd> refusals = {};
    Bdd obeyed = Bdd::constant(true);
};

class Synthesis {
public:
    Synthesis(const TransitionSystem& system, const Supervision& requested, const SuperviseOptions& options)
        : requested_(requested),
          progress_(options.progress),
          flat_(flattened(system)),
          space_({options.max_memory, options.deadline, options.stop}) {
        const auto here = [&](Id<Expr> term) { return flattened(system, flat_, term); };
        for (const Supervision::Controller& controller : requested.controllers) {
            Terms& terms = terms_.emplace_back();
            terms.evolves = here(controller.evolves);
            for (const Id<Expr> seen : controller.seen) terms.seen.push_back(here(seen));
            for (const Supervision::Permission& permission : controller.permissions) {
                terms.may.push_back(flat_.symbols[permission.symbol.index]);
                terms.effects.push_back(here(permission.effect));
                std::vector<Id<Expr>>& sites = terms.site_effects.emplace_back();
                for (std::size_t site = 0; site < permission.sites.size(); ++site) {
                    const bool known = site < permission.site_effects.size() && permission.site_effects[site].valid();
                    sites.push_back(known ? here(permission.site_effects[site]) : Id<Expr>{});
                }
            }
        }
        for (const Id<Expr> bad : requested.bad) bad_terms_.push_back(here(bad));
        marked_term_ = here(requested.marked);
    }

    Supervisor run() {
        prepare();
        if (!result_.reason.empty()) return std::move(result_);
        report_phase("computing the losing states");
        LosingRegion losing = game_->solve(bad_, marked_);
        if (!(losing.all & model_->initial()).is_false()) {
            find_violated(unrestricted());
            return nothing(losing);
        }
        while (!settled(losing)) {
            result_.claim = Supervisor::Permissiveness::Cautious;
            report_phase("recomputing the conditions");
            if (!(losing.all & model_->initial()).is_false())
                return unknown(
                    "the inputs and steps of the charts do not distinguish the states in which a move must be disabled "
                    "from the states in which it must be enabled");
        }
        report_phase("simplifying the conditions");
        if (!write(losing)) return unknown("a condition has more than 64 terms");
        if (!result_.conditions.empty()) {
            const Bdd free = unrestricted();
            find_violated(free);
            find_newly_unreachable(free);
        }
        result_.outcome = Supervisor::Outcome::Found;
        return std::move(result_);
    }

private:
    struct Terms {
        Id<Expr> evolves = {};
        std::vector<Id<Expr>> seen = {}, may = {}, effects = {};
        /// For each permission and site (an action that may set the output): a term or an invalid id.
        std::vector<std::vector<Id<Expr>>> site_effects = {};
    };

    Supervisor unknown(std::string why) {
        Supervisor made;
        made.reason = std::move(why);
        return made;
    }

    void report_phase(const std::string& doing) const {
        if (progress_) progress_(doing + ", " + std::to_string(space_.bytes() >> 20U) + " MiB");
    }

    void prepare() {
        model_.emplace(flat_, space_, true);
        BddTerms terms = model_->terms();
        const auto bit = [&](Id<Expr> term) {
            const BddTerm& value = terms(term);
            return value.bits.front() & ~value.undefined;
        };
        for (const Id<Expr> term : bad_terms_) {
            bads_.push_back(terms(term).bits.front() | terms(term).undefined);
            bad_ |= bads_.back();
        }
        marked_ = bit(marked_term_);
        std::vector<Player> players;
        for (const Terms& each : terms_) {
            Player& player = players.emplace_back();
            player.evolves = bit(each.evolves);
            std::vector<Bdd>& effects = effects_.emplace_back();
            std::vector<Bdd>& seen = observed_.emplace_back();
            for (const Id<Expr> term : each.may) player.may.push_back(bit(term));
            for (const Id<Expr> term : each.effects) effects.push_back(bit(term));
            std::vector<std::vector<Bdd>>& site_effects = site_effects_.emplace_back();
            for (const std::vector<Id<Expr>>& sites : each.site_effects) {
                std::vector<Bdd>& of_sites = site_effects.emplace_back();
                for (const Id<Expr> term : sites) of_sites.push_back(term.valid() ? bit(term) : Bdd::constant(true));
            }
            for (const Id<Expr> term : each.seen) seen.push_back(bit(term));
            seen_.emplace_back(*model_, space_, seen);
        }
        const Bdd reached = all_reached();
        if (model_->leak(reached)) result_.reason = "a variable of the plant leaves its range";
        else if (reached.is_false()) result_.reason = "the model has no initial state";
        else game_.emplace(*model_, space_, std::move(players), reached);
    }

    Bdd all_reached() const {
        report_phase("exploring the loop");
        if (model_->has_clusters()) {
            const Bdd closure = model_->closure(model_->initial());
            if ((closure & ~model_->invariant()).is_false() && !model_->leak(closure)) return closure;
        }
        bdd::Rings rings;
        rings.add(model_->initial());
        (void)symbolic::grow(*model_, rings, model_->invariant(), {}, [&](std::size_t) {
            report_phase("exploring the loop, " + std::to_string(rings.each.size()) + " steps deep");
            return !model_->leak(rings.each.back());
        });
        return rings.reached;
    }

    const Supervision::Permission& permission(std::size_t player, std::size_t index) const {
        return requested_.controllers[player].permissions[index];
    }

    // -- conditions over observations ---------------------------------------------------------------------------------

    /// Returns the pairs of a state and permissions to which a refusal applies: the permission `index` is refused for
    /// the observations `sights`.
    Bdd refused(std::size_t player, std::size_t index, const Bdd& sights) const {
        if (sights.is_false()) return {};
        const Bdd states = seen_[player].states(sights);
        return permission(player, index).output ? game_->evolves_to(player, states) : states;
    }

    /// Returns the policy that does not refuse any permission.
    Policy lenient(std::size_t player) const {
        Policy made{std::vector<Bdd>(game_->may(player).size())};
        for (const Bdd& may : game_->may(player)) made.obeyed &= may;
        return made;
    }

    /// Returns a policy for the states of `within`. The function decides the permissions sequentially: first the
    /// permissions of transitions, then those of outputs. A permission is refused for the observations of all states in
    /// which no allowed combination of permissions includes it. If no combination of permissions is allowed in a state,
    /// the state is added to `none_left`.
    Policy decided(std::size_t player, const Bdd& within, const LosingRegion& losing, Bdd& none_left) const {
        const std::vector<Bdd>& may = game_->may(player);
        Policy made{std::vector<Bdd>(may.size())};
        const Bdd here = within & game_->ready(player);
        Bdd pairs = game_->allowed(player, losing) & here;
        const auto decide = [&](std::size_t index, const Bdd& wanted) {
            const Bdd never = game_->states(wanted) & ~game_->states(wanted & may[index]);
            Bdd& sights = made.refusals[index];
            if (!never.is_false())
                sights = seen_[player].sights(permission(player, index).output ? game_->evolved(player, pairs & never)
                                                                               : never);
            const Bdd obeyed = may[index] ^ refused(player, index, sights);
            pairs &= obeyed;
            made.obeyed &= obeyed;
            return obeyed;
        };
        Bdd wanted = pairs;  // the allowed pairs in which no further output can be permitted
        for (std::size_t index = 0; index < may.size(); ++index)
            if (permission(player, index).output) wanted &= may[index] | ~game_->states(wanted & may[index]);
        for (std::size_t index = 0; index < may.size(); ++index)
            if (!permission(player, index).output) wanted &= decide(index, wanted);
        for (std::size_t index = 0; index < may.size(); ++index)
            if (permission(player, index).output) (void)decide(index, pairs);
        none_left |= here & ~game_->states(pairs);
        return made;
    }

    std::vector<Policy> lenient() const {
        std::vector<Policy> made;
        for (std::size_t player = 0; player < game_->players(); ++player) made.push_back(lenient(player));
        return made;
    }

    /// Returns the states that are reachable in the system without conditions.
    Bdd unrestricted() const {
        report_phase("exploring the loop without conditions");
        return closed(model_->initial(), {}, lenient());
    }

    /// Returns `states` and all states that are reachable from `states` under the policies on paths without a losing
    /// state.
    Bdd closed(Bdd states, const LosingRegion& losing, const std::vector<Policy>& policies) const {
        for (Bdd latest = states; !latest.is_false(); states |= latest) {
            Bdd next = game_->moved(latest);
            for (std::size_t player = 0; player < game_->players(); ++player)
                next |= game_->evolved(player, latest & game_->ready(player) & policies[player].obeyed);
            latest = next & ~losing.all & ~states;
        }
        return states;
    }

    /// Computes the policies of all players. If no policies avoid the losing states, adds further states to `losing`
    /// and returns false.
    bool settled(LosingRegion& losing) {
        policies_ = lenient();
        Bdd considered = model_->initial();
        for (;;) {
            considered = closed(considered, losing, policies_);
            Bdd fails, none_left;
            for (std::size_t player = 0; player < game_->players(); ++player)
                fails |= considered & game_->ready(player) & policies_[player].obeyed &
                         game_->evolves_to(player, losing.all);
            if (fails.is_false()) break;
            for (std::size_t player = 0; player < game_->players(); ++player)
                policies_[player] = decided(player, considered, losing, none_left);
            if (none_left.is_false()) continue;
            losing = game_->solve(none_left, marked_, std::move(losing));
            return false;
        }
        under_ = closed(model_->initial(), losing, policies_);
        const Bdd circling = under_ & ~returning(losing);
        if (circling.is_false()) return true;
        losing = game_->solve(circling, marked_, std::move(losing));
        return false;
    }

    /// Returns the states of `under_` from which a marked state is reachable under the policies.
    Bdd returning(const LosingRegion& losing) const {
        std::vector<Bdd> pairs;
        for (std::size_t player = 0; player < game_->players(); ++player)
            pairs.push_back(game_->allowed(player, losing) & under_ & policies_[player].obeyed);
        Bdd found = under_ & marked_;
        for (Bdd latest = found; !latest.is_false(); found |= latest) {
            Bdd before = game_->moves_to(latest);
            for (std::size_t player = 0; player < game_->players(); ++player)
                before |= game_->states(pairs[player] & game_->evolves_to(player, latest));
            latest = before & under_ & ~found;
        }
        return found;
    }

    // -- classification of the conditions -----------------------------------------------------------------------------

    /// Returns the pairs of a state and permissions in which the permission `index` has an effect: it changes the
    /// evolution.
    Bdd relevant(std::size_t player, std::size_t index) const {
        const Bdd& may = game_->may(player)[index];
        const auto with = [&](const Bdd& f, bool value) {
            const BddLiteral literal{may.top(), value};
            return cofactor(f, cube(space_, {&literal, 1}));
        };
        const Bdd& effect = effects_[player][index];
        if (!permission(player, index).output) return with(effect, true);  // states in which the firing condition holds
        const Bdd set = game_->evolves_to(player, effect);
        return with(set, true) & ~with(set, false);
    }

    /// Adds the conditions and their classification to the result. Returns false if a condition has more than
    /// `most_products` terms.
    bool write(const LosingRegion& losing) {
        for (std::size_t player = 0; player < game_->players(); ++player) {
            const Bdd here = under_ & game_->ready(player);
            const Bdd chosen = here & policies_[player].obeyed;
            std::vector<Bdd> matters;
            for (std::size_t index = 0; index < game_->may(player).size(); ++index) {
                matters.push_back(relevant(player, index) & game_->ready(player));
                const Bdd& may = game_->may(player)[index];
                const Bdd effective = chosen & matters.back();
                if ((effective & may).is_false() && !(effective & ~may).is_false())
                    result_.disabled.push_back({player, index});
                if (!write(player, index, chosen, matters.back())) return false;
            }
            claim(player, chosen, matters, game_->allowed(player, losing) & here);
        }
        if (!result_.hidden.empty()) result_.claim = Supervisor::Permissiveness::Cautious;
        if (result_.claim != Supervisor::Permissiveness::Cautious && !result_.traded.empty())
            result_.claim = Supervisor::Permissiveness::Several;
        return true;
    }

    bool write(std::size_t player, std::size_t index, const Bdd& chosen, const Bdd& matters) {
        if (policies_[player].refusals[index].is_false()) return true;
        const Bdd& may = game_->may(player)[index];
        const bool output = permission(player, index).output;
        const auto sights = [&](const Bdd& pairs) {
            return seen_[player].sights(output ? game_->evolved(player, pairs) : game_->states(pairs));
        };
        const auto add_site = [&](std::optional<std::size_t> site, const Bdd& pairs, const Bdd& active) {
            return add(player, index, site, sights(pairs & may) & active, sights(pairs & ~may) & active);
        };
        if (!output) return add_site({}, chosen & matters, Bdd::constant(true));
        const std::vector<std::size_t>& sites = permission(player, index).sites;
        for (std::size_t site = 0; site < sites.size(); ++site) {
            const BddLiteral literal = seen_[player].literals()[sites[site]];
            const Bdd sets = game_->evolves_to(player, site_effects_[player][index][site]);
            if (!add_site(site, chosen & matters & sets, cube(space_, {&literal, 1}))) return false;
        }
        return true;
    }

    bool add(std::size_t player, std::size_t index, std::optional<std::size_t> site, const Bdd& on, const Bdd& off) {
        if (off.is_false()) return true;
        const std::vector<BddLiteral>& literals = seen_[player].literals();
        std::vector<std::uint32_t> variables;
        for (const BddLiteral& literal : literals) variables.push_back(literal.variable);
        std::ranges::reverse(variables);
        const std::optional<Cover> found = cover(space_, on, off, variables, most_products);
        if (!found) return false;
        Supervisor::Condition condition{.controller = player, .permission = index, .site = site};
        condition.all = found->negated;
        for (const std::vector<BddLiteral>& product : found->products) {
            std::vector<Supervisor::Literal>& term = condition.terms.emplace_back();
            for (const BddLiteral& literal : product) {
                const auto at = std::ranges::find(literals, literal.variable, &BddLiteral::variable);
                const bool value = (literal.value == at->value) != found->negated;
                term.push_back({static_cast<std::size_t>(at - literals.begin()), value});
            }
        }
        result_.conditions.push_back(std::move(condition));
        return true;
    }

    /// Compares the chosen permissions with all allowed combinations of permissions, and records the permissions that
    /// could be granted more often. A permission without effect is treated as granted.
    void claim(std::size_t player, const Bdd& chosen, const std::vector<Bdd>& matters, Bdd allowed) {
        const std::vector<Bdd>& may = game_->may(player);
        std::vector<Bdd> permitted;  // states in which the permission is granted or has no effect
        Bdd above = Bdd::constant(true);
        for (std::size_t index = 0; index < may.size(); ++index) {
            allowed &= may[index] | matters[index];
            permitted.push_back(game_->states(chosen & (may[index] | ~matters[index])));
            above &= implies(permitted.back(), may[index]);
        }
        for (std::size_t index = 0; index < may.size(); ++index) {
            const Bdd more = allowed & may[index] & ~permitted[index] & game_->states(chosen);
            if (!(more & above).is_false()) result_.hidden.push_back({player, index});
            else if (!more.is_false()) result_.traded.push_back({player, index});
        }
    }

    void find_violated(const Bdd& free) {
        for (const Bdd& bad : bads_) result_.violated.push_back(!(free & bad).is_false());
    }

    void find_newly_unreachable(const Bdd& free) {
        for (std::size_t player = 0; player < observed_.size(); ++player)
            for (std::size_t seen = 0; seen < observed_[player].size(); ++seen)
                if (const Bdd& each = observed_[player][seen]; !(free & each).is_false() && (under_ & each).is_false())
                    result_.newly_unreachable.push_back({player, seen});
    }

    // -- runs that cannot be prevented --------------------------------------------------------------------------------

    Supervisor nothing(const LosingRegion& losing) {
        result_.outcome = Supervisor::Outcome::None;
        symbolic::Path path;
        symbolic::State state = model_->pick(losing.all & model_->initial(), {});
        for (;;) {
            path.states.push_back(state);
            const auto stage = std::ranges::find_if(
                losing.stages, [&](const LosingRegion::Stage& each) { return evaluate(each.states, state); });
            result_.blocked = stage->blocked;
            if (stage->blocked || evaluate(bad_, state)) break;
            step(path, state, losing, static_cast<std::size_t>(stage - losing.stages.begin()));
        }
        result_.run = run_of(*model_, path);
        result_.flat = flat_;
        return std::move(result_);
    }

    /// Appends to `path` a step from `state` to a state of a stage before `stage`. The step is an uncontrollable move
    /// if such a move exists, and otherwise an evolution with all permissions.
    void step(symbolic::Path& path, symbolic::State& state, const LosingRegion& losing, std::size_t stage) const {
        const Bdd only = model_->only(state);
        const auto go = [&](const Bdd& to, const Bdd& how) {
            for (std::size_t before = 0; before < stage; ++before) {
                const Bdd next = to & losing.stages[before].states;
                if (next.is_false()) continue;
                path.steps.push_back(how);
                state = model_->pick(next, state);
                return true;
            }
            return false;
        };
        if (go(game_->moved(only), game_->is_move())) return;
        Bdd earlier;
        for (std::size_t before = 0; before < stage; ++before) earlier |= losing.stages[before].states;
        for (std::size_t player = 0; player < game_->players(); ++player) {
            const Bdd free = lenient(player).obeyed;
            if ((only & game_->helpless(player, earlier)).is_false()) continue;
            if (go(game_->evolved(player, only & free), game_->is_evolution(player) & free)) return;
        }
    }

    const Supervision& requested_;
    std::function<void(const std::string&)> progress_ = {};
    FlatSystem flat_;
    BddSpace space_;
    std::vector<Terms> terms_ = {};
    std::vector<Id<Expr>> bad_terms_ = {};
    Id<Expr> marked_term_ = {};
    std::optional<StateSpace> model_ = {};
    std::optional<Game> game_ = {};
    std::vector<ObservationMap> seen_ = {};       ///< observation map of each player
    std::vector<std::vector<Bdd>> effects_ = {};  ///< for each player and permission: condition of its effect

    /// For each player, permission and site (an action that may set the output): set of the steps in which the action
    /// of the site sets the output.
    std::vector<std::vector<std::vector<Bdd>>> site_effects_ = {};
    std::vector<std::vector<Bdd>> observed_ = {};  ///< functions of the state that each player observes
    std::vector<Bdd> bads_ = {};                   ///< for each bad term: states in which it is true or undefined
    Bdd bad_ = {}, marked_ = {};
    std::vector<Policy> policies_ = {};  ///< policy of each player
    Bdd under_ = {};                     ///< states that are reachable under the policies
    Supervisor result_ = {};
};

}  // namespace

}  // namespace supervise

Supervisor supervisor_of(const TransitionSystem& system, const Supervision& requested,
                         const SuperviseOptions& options) {
    Supervisor unknown;
    try {
        return supervise::Synthesis(system, requested, options).run();
    } catch (const BddExhausted& exhausted) {
        const bool stopped = exhausted.cause() == BddExhausted::Cause::Stopped;
        unknown.reason = stopped ? "stopped" : memory_limit_reached(options.max_memory);
    } catch (const std::bad_alloc&) {
        unknown.reason = "out of memory";
    }
    return unknown;
}

}  // namespace grafverif
