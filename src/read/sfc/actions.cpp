// SPDX-License-Identifier: MIT
// Converts action blocks (IEC 61131-3, 2.6.4) to actions of GRAFCET. Each block is converted separately, in the order
// of the steps. Result for each qualifier, or for a list of statements:
//
//   N            a continuous action                        S, R     stored actions on activation
//   D, L         a continuous action with a delay or limit  DS       a stored action after the time has elapsed
//   P, P1, P0    the step sets a latch; in the additional partial chart the latch drives the output and is then reset
//   SD, SL       the step sets a latch; the output is then true after (SD) or until (SL) the time has elapsed
//   statements   stored actions for the assignments that bodies.cpp computes
//
// A latch is an internal variable that stores a Boolean value. The action blocks of all steps with the same output and
// the same type of qualifier use one latch. R ends the effects of all other action blocks on the same output.
// Therefore, R is converted after the list of all action blocks is complete.
#include <algorithm>
#include <iterator>

#include "read/sfc/sfc.hpp"
#include "support/messages.hpp"

namespace grafverif {

namespace {

/// An action block whose action is a Boolean variable.
struct Act {
    std::string step = {}, output = {}, qualifier = {};
    Span where = {};
    std::int64_t milliseconds = 0;  ///< duration, if the qualifier requires one
};

/// The result of converting an action block: actions of the step, and actions that are independent of the step.
struct Made {
    std::vector<tree::Action> of_step = {}, always = {};
};

bool is_one_of(std::string_view qualifier, std::initializer_list<std::string_view> some) {
    return std::ranges::find(some, qualifier) != some.end();
}

tree::StoredAction stored(Draft& draft, const std::string& target, Id<tree::Expr> value, tree::StoredWhen when,
                          Span where) {
    return {{draft.name(target, where), value, where}, when, {}, where};
}

tree::StoredAction on_activation(Draft& draft, const std::string& target, bool value, Span where) {
    return stored(draft, target, draft.constant(value, where), tree::StoredWhen::Activation, where);
}

/// Returns an action that assigns `value` to `target` when `condition` becomes true.
tree::StoredAction on_rise(Draft& draft, const std::string& target, bool value, Id<tree::Expr> condition, Span where) {
    tree::StoredAction action = stored(draft, target, draft.constant(value, where), tree::StoredWhen::Event, where);
    action.event = draft.node(tree::Op::Rise, {condition}, where);
    return action;
}

/// Returns an action that makes `output` true while `condition` is true.
tree::ContinuousAction continuous(Draft& draft, const std::string& output, Id<tree::Expr> condition, Span where) {
    return {draft.name(output, where), condition, {}, {}, where};
}

Id<tree::Expr> timed(Draft& draft, std::int64_t milliseconds, const std::string& watched, Span where) {
    return draft.node(tree::Op::Divide, {draft.duration(milliseconds, where), draft.variable(watched, where)}, where);
}

/// Detects differences in the order of evaluation: a Sequential Function Chart executes the actions of a scan
/// sequentially, but in GRAFCET all actions of an evolution read the previous values. Each type of difference is
/// reported once per variable.
class Order {
public:
    /// Records an action at `where` that assigns `target` and reads the variables `reads`. Returns the differences that
    /// have not been reported before.
    std::vector<std::string> differences(Span where, const std::string& target, const std::set<std::string>& reads) {
        std::vector<std::string> found;
        if (elsewhere(target, where) && reported_.insert(target).second)
            found.push_back("several actions assign `" + target +
                            "`: if two of them are executed in one scan, the later action determines the value in "
                            "the Sequential Function Chart, but in the imported chart the actions race");
        writers_.try_emplace(target, where.begin);
        for (const std::string& read : reads)
            if (elsewhere(read, where) && reported_.insert(read + "?").second)
                found.push_back("`" + read +
                                "` is read by one action and assigned by another: the Sequential Function Chart "
                                "executes the actions sequentially, but in the imported chart the reading action "
                                "uses the value before the evolution");
        return found;
    }

private:
    /// True if the first recorded action that assigns the variable is not the action at `where`.
    bool elsewhere(const std::string& variable, Span where) const {
        const auto writer = writers_.find(variable);
        return writer != writers_.end() && writer->second != where.begin;
    }

    std::unordered_map<std::string, std::uint32_t> writers_ = {};  ///< first assignment to each variable (position)
    std::unordered_set<std::string> reported_ = {};
};

class Blocks {
public:
    explicit Blocks(Sfc& sfc) : sfc_(sfc), draft_(sfc.draft) {}

    SfcActions actions() {
        SfcActions result;
        std::vector<Act> acts;
        for (const st::Network& network : sfc_.unit.networks)
            for (const st::Step& step : network.steps)
                for (const st::Association& one : step.actions) {
                    const std::string& name = sfc_.steps.at(step.name.word);
                    Made made = block(name, one, acts);
                    std::ranges::move(made.of_step, std::back_inserter(result.of_steps[name]));
                    std::ranges::move(made.always, std::back_inserter(result.always));
                }
        for (const auto& [step, action] : ended_by_resets(acts)) result.of_steps[step].emplace_back(action);
        result.latches = std::move(latches_);
        return result;
    }

private:
    void refuse(Span where, std::string_view what, std::string_view hint) { draft_.refuse(where, what, hint); }

    /// Converts an action block. If its action is a Boolean variable, also adds the block to `acts`.
    Made block(const std::string& step, const st::Association& one, std::vector<Act>& acts) {
        if (!one.action.valid()) return statements(one, one.body);
        const auto body = std::ranges::find(sfc_.unit.actions, one.action.word,
                                            [](const st::Action& action) { return action.name.word; });
        if (body == sfc_.unit.actions.end()) {
            const std::optional<Act> act = act_of(step, one);
            if (!act) return {};
            acts.push_back(*act);
            return made_of(*act);
        }
        if (!body->opaque) return statements(one, body->body);
        refuse(one.where,
               "the action `" + std::string(sfc_.file.text(one.action)) + "`, which is not in Structured Text,",
               "write it in Structured Text");
        return {};
    }

    // -- Boolean variables --------------------------------------------------------------------------------------------

    std::optional<Act> act_of(const std::string& step, const st::Association& one) {
        const std::string path(sfc_.file.text(one.action));
        const auto refused = [&](const std::string& what, std::string_view hint) {
            refuse(one.where, what, hint);
            return std::nullopt;
        };
        if (path.find('.') != std::string::npos)
            return refused("the action `" + path + "` of another block", "move it into the block of the chart");
        const SfcVariable& target = variable_of(sfc_, path, one.action.where, SfcKind::Boolean, true);
        if (target.kind != SfcKind::Boolean || target.constant)
            return refused("an action on `" + path + "`, which is not a Boolean variable,", "use a Boolean variable");
        if (target.role == tree::VariableKind::Input)
            return refused("an action on the input `" + path + '`', "use an output");
        Act act{step, target.name, one.qualifier.empty() ? "N" : one.qualifier, one.where};
        if (is_one_of(act.qualifier, {"N", "S", "R", "P", "P1", "P0"})) return act;
        if (!is_one_of(act.qualifier, {"D", "L", "SD", "DS", "SL"})) {
            sfc_.diagnostics().add(
                messages::bad_value(one.where, "qualifier", one.qualifier, "one of N S R P P0 P1 D L SD DS SL"));
            act.qualifier = {};
            return act;
        }
        act.milliseconds = time(one).value_or(0);
        if (act.milliseconds == 0) act.qualifier = {};
        return act;
    }

    /// Returns the duration in milliseconds of an action block whose qualifier requires a duration; empty after an
    /// error.
    std::optional<std::int64_t> time(const st::Association& one) {
        if (!one.time.valid()) {
            sfc_.diagnostics().add(
                messages::missing_part(one.where, "the qualifier `" + one.qualifier + '`', "duration"));
            return {};
        }
        const auto found = duration_of(sfc_, {}, one.time);
        if (found && *found == 0)
            sfc_.diagnostics().add(messages::bad_value(one.where, "duration", "0", "a longer time"));
        return found;
    }

    Made made_of(const Act& act) {
        const std::string& q = act.qualifier;
        const Span where = act.where;
        if (q == "N") return {{continuous(draft_, act.output, {}, where)}, {}};
        if (q == "S" || q == "R") return {{on_activation(draft_, act.output, q == "S", where)}, {}};
        if (is_one_of(q, {"P", "P1", "P0"})) return pulse(act);
        if (q == "SD" || q == "SL") return outlasting(act);
        if (q == "DS") {
            sfc_.differs(
                where,
                "DS: if the time expires in the scan that deactivates the step, the imported chart sets the output, "
                "but a Sequential Function Chart does not");
            return {{on_rise(draft_, act.output, true, timed(draft_, act.milliseconds, 'X' + act.step, where), where)},
                    {}};
        }
        if (q.empty()) return {};  // already reported
        tree::ContinuousAction action = continuous(draft_, act.output, {}, where);
        (q == "D" ? action.delay : action.limit) = draft_.duration(act.milliseconds, where);
        return {{action}, {}};
    }

    /// Returns the name of the latch for an output and a type of qualifier (`suffix`), and true if the latch is new.
    std::pair<std::string, bool> latch(const std::string& output, std::string_view suffix) {
        const auto [known, fresh] = latch_of_.try_emplace(output + std::string(suffix));
        if (fresh) latches_.push_back(known->second = sfc_.names.invent(output + std::string(suffix)));
        return {known->second, fresh};
    }

    /// Converts the qualifiers P, P1 and P0. The output is true for one scan: the step sets the latch, and the next
    /// evolution resets the latch.
    Made pulse(const Act& act) {
        const auto [state, fresh] = latch(act.output, "_pulse");
        const auto when = act.qualifier == "P0" ? tree::StoredWhen::Deactivation : tree::StoredWhen::Activation;
        Made made{{stored(draft_, state, draft_.constant(true, act.where), when, act.where)}, {}};
        if (!fresh) return made;
        made.always.emplace_back(on_rise(draft_, state, false, draft_.variable(state, act.where), act.where));
        made.always.emplace_back(continuous(draft_, act.output, draft_.variable(state, act.where), act.where));
        return made;
    }

    Made outlasting(const Act& act) {
        const bool delayed = act.qualifier == "SD";
        const std::string state = latch(act.output, delayed ? "_delayed" : "_limited").first;
        const Id<tree::Expr> over = timed(draft_, act.milliseconds, state, act.where);
        const Id<tree::Expr> condition =
            delayed ? over : both(draft_, draft_.variable(state, act.where), opposite(draft_, over));
        return {{on_activation(draft_, state, true, act.where)},
                {continuous(draft_, act.output, condition, act.where)}};
    }

    /// R also ends SD and SL on the same output. Therefore, returns pairs of a step with the qualifier R and an action
    /// that resets a latch of SD or SL. Reports each output on which other actions may act while the step with R is
    /// active, because the conversion of R does not suppress these actions.
    std::vector<std::pair<std::string, tree::StoredAction>> ended_by_resets(const std::vector<Act>& acts) {
        std::unordered_set<std::string> driven;  // outputs on which other actions may act while R is active
        const bool parallel = has_parallel_steps();
        for (const Act& act : acts)
            if (act.qualifier == "P0" || (parallel && act.qualifier != "R")) driven.insert(act.output);
        std::vector<std::pair<std::string, tree::StoredAction>> ends;
        for (const Act& act : acts) {
            if (act.qualifier != "R") continue;
            if (driven.erase(act.output) != 0)
                sfc_.differs(
                    act.where,
                    "R of `" + act.output + "`: in a Sequential Function Chart, R overrides every other action on `" +
                        act.output +
                        "` while the step of R is active; in the imported chart, R resets the stored value once");
            for (const char* const suffix : {"_delayed", "_limited"})
                if (const auto known = latch_of_.find(act.output + suffix); known != latch_of_.end())
                    ends.emplace_back(act.step, on_activation(draft_, known->second, false, act.where));
        }
        return ends;
    }

    bool has_parallel_steps() const {
        return std::ranges::any_of(sfc_.unit.networks, [](const st::Network& network) {
            return std::ranges::any_of(network.transitions,
                                       [](const st::Transition& one) { return one.to.size() > 1; }) ||
                   std::ranges::count_if(network.steps, &st::Step::initial) > 1;
        });
    }

    // -- statements ---------------------------------------------------------------------------------------------------

    Made statements(const st::Association& one, const st::Block& block) {
        const std::string& q = one.qualifier;
        const bool repeated = q.empty() || q == "N";
        Made made;
        if (!repeated && !is_one_of(q, {"P", "P1", "P0"})) {
            refuse(one.where, "a list of statements with the qualifier " + q, "use N, P1 or P0, or a Boolean variable");
            return made;
        }
        const std::optional<SfcBody> body = body_of(sfc_, block);
        if (!body) return made;
        for (const auto& [target, effect] : body->effects) {
            for (const std::string& difference : order_.differences(one.where, target, body->reads))
                sfc_.differs(one.where, difference);
            const auto when = q == "P0" ? tree::StoredWhen::Deactivation : tree::StoredWhen::Activation;
            std::ranges::move(
                repeated ? every_scan(one.where, target, effect, *body) : once(one.where, target, effect, when),
                std::back_inserter(made.of_step));
        }
        return made;
    }

    std::vector<tree::Action> once(Span where, const std::string& target, const SfcEffect& effect,
                                   tree::StoredWhen when) {
        const Id<tree::Expr> value =
            effect.value.valid() ? draft_.copy(effect.value)
                                 : either(draft_, draft_.copy(effect.set),
                                          both(draft_, draft_.copy(effect.keep), draft_.variable(target, where)));
        if (!value.valid()) return {};
        return {stored(draft_, target, value, when, where)};
    }

    bool is_constant(Id<tree::Expr> term) const {
        const tree::Expr& node = draft_[term];
        const bool negative = node.op == tree::Op::Negate && draft_[node.first].op == tree::Op::Number;
        return node.op == tree::Op::True || node.op == tree::Op::False || node.op == tree::Op::Number || negative;
    }

    /// Converts an assignment with the qualifier N, which a Sequential Function Chart executes in every scan while the
    /// step is active. Returns actions that assign on activation and whenever the value of the term changes.
    std::vector<tree::Action> every_scan(Span where, const std::string& target, const SfcEffect& effect,
                                         const SfcBody& body) {
        const bool boolean = !effect.value.valid();
        if (boolean ? is_constant(effect.set) && is_constant(effect.keep) : is_constant(effect.value))
            return once(where, target, effect, tree::StoredWhen::Activation);
        for (const auto& [name, other] : body.effects)
            if (body.reads.contains(name) && depends_on(effect, name)) {
                refuse(where, "`" + name + "`, whose value from the previous scan is read in every scan,",
                       "use P1 to execute the assignment once");
                return {};
            }
        if (!boolean) {
            refuse(where, "the integer `" + target + "`, which is computed from other variables in every scan,",
                   "use P1 to execute the assignment once");
            return {};
        }
        std::vector<tree::Action> actions = once(where, target, effect, tree::StoredWhen::Activation);
        const Id<tree::Expr> set = draft_.copy(effect.set);
        const Id<tree::Expr> clear =
            opposite(draft_, either(draft_, draft_.copy(effect.set), draft_.copy(effect.keep)));
        for (const bool value : {true, false})
            if (const Id<tree::Expr> when = value ? set : clear; when.valid() && !is_constant(when))
                actions.emplace_back(on_rise(draft_, target, value, when, where));
        sfc_.differs(where,
                     "N: a Sequential Function Chart executes the statements in every scan; in the imported chart, `" +
                         target +
                         "` follows the assigned term while the step is active, and is assigned for the last time "
                         "in the scan that deactivates the step");
        return actions;
    }

    bool depends_on(const SfcEffect& effect, const std::string& variable) const {
        std::vector<Id<tree::Expr>> work;
        for (const Id<tree::Expr> root : {effect.set, effect.keep, effect.value})
            if (root.valid()) work.push_back(root);
        while (!work.empty()) {
            const Id<tree::Expr> id = work.back();
            work.pop_back();
            if (draft_[id].op == tree::Op::Name && draft_.file().text(draft_[id].word) == variable) return true;
            for (const Id<tree::Expr> inner : draft_.operands(id)) work.push_back(inner);
        }
        return false;
    }

    Sfc& sfc_;
    Draft& draft_;
    Order order_ = {};
    std::unordered_map<std::string, std::string> latch_of_ = {};  ///< name of each latch, by output and suffix
    std::vector<std::string> latches_ = {};                       ///< latches in the order of creation
};

}  // namespace

SfcActions actions_of(Sfc& sfc) { return Blocks(sfc).actions(); }

}  // namespace grafverif
