// SPDX-License-Identifier: MIT
// Action blocks (IEC 61131-3, 2.6.4) as actions of GRAFCET.
#include <algorithm>

#include "support/messages.hpp"
#include "read/sfc/sfc.hpp"

namespace grafverif {

namespace {

class Actions {
public:
    explicit Actions(Sfc& sfc) : sfc_(sfc) {
        for (const st::Action& action : sfc.unit.actions) bodies_.emplace(action.name.word, &action);
    }

    SfcActions run() {
        for (const st::Network& network : sfc_.unit.networks)
            for (const st::Step& step : network.steps)
                for (const st::Association& one : step.actions) block(sfc_.steps.at(step.name.word), one);
        return std::move(made_);
    }

private:
    // -- what is added -----------------------------------------------------------------------------------------------

    std::vector<tree::Action>& of(const std::string& step) { return made_.of_steps[step]; }

    tree::Name name(const std::string& text, Span where) { return sfc_.draft.name(text, where); }
    Id<tree::Expr> variable(const std::string& text, Span where) { return sfc_.draft.variable(text, where); }

    tree::StoredAction stored(const std::string& target, Id<tree::Expr> value, tree::StoredWhen when, Span where) {
        return {{name(target, where), value, where}, when, {}, where};
    }

    void on_activation(const std::string& step, const std::string& target, bool value, Span where) {
        of(step).emplace_back(stored(target, sfc_.draft.constant(value, where), tree::StoredWhen::Activation, where));
    }

    void refuse(Span where, std::string_view what, std::string_view hint) { sfc_.draft.refuse(where, what, hint); }

    /// The variable behind a qualifier that stores: one for each output and qualifier.
    std::string latch(const std::string& output, std::string_view suffix) {
        const auto [known, fresh] = latches_.try_emplace(output + std::string(suffix));
        if (fresh) {
            known->second = sfc_.names.invent(output + std::string(suffix));
            made_.latches.push_back(known->second);
        }
        return known->second;
    }

    /// `output` is true while `condition` holds, whatever step is active.
    void always(const std::string& output, Id<tree::Expr> condition, Span where) {
        made_.always.emplace_back(tree::ContinuousAction{name(output, where), condition, {}, {}, where});
    }

    Id<tree::Expr> timed(std::int64_t milliseconds, const std::string& watched, Span where) {
        return sfc_.draft.node(tree::Op::Divide, {sfc_.draft.duration(milliseconds, where), variable(watched, where)}, where);
    }

    // -- action blocks -------------------------------------------------------------------------------------------------

    void block(const std::string& step, const st::Association& one) {
        const auto body = one.action.valid() ? bodies_.find(one.action.word) : bodies_.end();
        if (!one.action.valid()) return assignments(step, one, one.body);
        if (body != bodies_.end() && body->second->opaque)
            return refuse(one.where, "the action `" + std::string(sfc_.file.text(one.action)) + "`, which is not in Structured Text,",
                          "write it in Structured Text");
        if (body != bodies_.end()) return assignments(step, one, body->second->body);
        boolean(step, one);
    }

    /// The time of a qualifier that wants one.
    std::optional<std::int64_t> time(const st::Association& one) {
        if (!one.time.valid()) {
            sfc_.diagnostics().add(messages::missing_part(one.where, "the qualifier `" + one.qualifier + '`', "duration"));
            return {};
        }
        const auto found = duration_of(sfc_, one.time);
        if (found && *found == 0) {
            sfc_.diagnostics().add(messages::bad_value(one.where, "duration", "0", "a time longer than that"));
            return {};
        }
        return found;
    }

    /// A Boolean variable under a qualifier.
    void boolean(const std::string& step, const st::Association& one) {
        const std::string path(sfc_.file.text(one.action));
        if (path.find('.') != std::string::npos)
            return refuse(one.where, "the action `" + path + "` of another block", "move it into the block of the chart");
        const SfcVariable& target = variable_of(sfc_, path, one.action.where, SfcKind::Boolean, true);
        if (target.kind != SfcKind::Boolean || target.constant)
            return refuse(one.where, "an action on `" + path + "`, which is no Boolean variable,", "act on a BOOL");
        if (target.role == tree::VariableKind::Input)
            return refuse(one.where, "an action on the input `" + path + '`', "act on an output");
        const std::string output = target.name;
        const std::string& q = one.qualifier;
        const Span where = one.where;
        if (q != "R") driven_.insert(output);
        if (q == "P0") outlasting_.insert(output);
        if (q == "N" || q.empty()) of(step).emplace_back(tree::ContinuousAction{name(output, where), {}, {}, {}, where});
        else if (q == "S") on_activation(step, output, true, where);
        else if (q == "R") reset(step, output, where);
        else if (q == "P" || q == "P1" || q == "P0") pulse(step, output, q == "P0", where);
        else if (q == "D" || q == "L" || q == "SD" || q == "DS" || q == "SL") delayed(step, output, one);
        else
            sfc_.diagnostics().add(messages::bad_value(where, "qualifier", q, "one of N S R P P0 P1 D L SD DS SL"));
    }

    void reset(const std::string& step, const std::string& output, Span where) {
        on_activation(step, output, false, where);
        resets_.push_back({step, output, where});
    }

    /// True for one scan: set by the step, reset when the next evolution sees it.
    void pulse(const std::string& step, const std::string& output, bool deactivation, Span where) {
        const std::string state = latch(output, "_pulse");
        of(step).emplace_back(stored(state, sfc_.draft.constant(true, where),
                                     deactivation ? tree::StoredWhen::Deactivation : tree::StoredWhen::Activation, where));
        if (!pulses_.insert(state).second) return;
        tree::StoredAction end = stored(state, sfc_.draft.constant(false, where), tree::StoredWhen::Event, where);
        end.event = sfc_.draft.node(tree::Op::Rise, {variable(state, where)}, where);
        made_.always.emplace_back(std::move(end));
        always(output, variable(state, where), where);
    }

    void delayed(const std::string& step, const std::string& output, const st::Association& one) {
        const auto milliseconds = time(one);
        if (!milliseconds) return;
        const Span where = one.where;
        const std::string& q = one.qualifier;
        const Id<tree::Expr> length = sfc_.draft.duration(*milliseconds, where);
        if (q == "D") {
            of(step).emplace_back(tree::ContinuousAction{name(output, where), {}, length, {}, where});
        } else if (q == "L") {
            of(step).emplace_back(tree::ContinuousAction{name(output, where), {}, {}, length, where});
        } else if (q == "DS") {
            tree::StoredAction set = stored(output, sfc_.draft.constant(true, where), tree::StoredWhen::Event, where);
            set.event = sfc_.draft.node(tree::Op::Rise, {timed(*milliseconds, 'X' + step, where)}, where);
            of(step).emplace_back(std::move(set));
            sfc_.differs(where, "DS: where the time is over in the scan that leaves the step, the output is set here and not in a Sequential Function Chart");
        } else {
            const std::string state = latch(output, q == "SD" ? "_delayed" : "_limited");
            on_activation(step, state, true, where);
            timed_latches_[output].insert(state);
            const Id<tree::Expr> over = timed(*milliseconds, state, where);
            always(output, q == "SD" ? over : both(sfc_, variable(state, where), opposite(sfc_, over)), where);
        }
    }

    // -- assignments ---------------------------------------------------------------------------------------------------

    void assignments(const std::string& step, const st::Association& one, const st::Block& body) {
        const std::string& q = one.qualifier;
        const bool known = q == "N" || q.empty() || q == "P" || q == "P1" || q == "P0";
        if (!known) return refuse(one.where, "a list of statements under the qualifier " + q, "use N, P1 or P0, or a Boolean variable");
        const auto effects = effects_of(sfc_, body);
        if (!effects) return;
        const std::unordered_set<std::string> reads = sfc_.reads;
        const bool repeated = q == "N" || q.empty();
        for (const auto& [target, effect] : *effects) {
            note_order(one.where, target, reads);
            if (repeated) every_scan(step, one, target, effect, *effects, reads);
            else once(step, one, target, effect, q == "P0" ? tree::StoredWhen::Deactivation : tree::StoredWhen::Activation);
        }
    }

    Id<tree::Expr> whole(const SfcEffect& effect, const std::string& target, Span where) {
        if (effect.value.valid()) return sfc_.draft.copy(effect.value);
        return either(sfc_, sfc_.draft.copy(effect.set), both(sfc_, sfc_.draft.copy(effect.keep), variable(target, where)));
    }

    void once(const std::string& step, const st::Association& one, const std::string& target, const SfcEffect& effect,
              tree::StoredWhen when) {
        const Id<tree::Expr> value = whole(effect, target, one.where);
        if (value.valid()) of(step).emplace_back(stored(target, value, when, one.where));
    }

    bool is_constant(Id<tree::Expr> term) const {
        const tree::Expr& node = sfc_.draft[term];
        const bool negative = node.op == tree::Op::Negate && sfc_.draft[node.first].op == tree::Op::Number;
        return node.op == tree::Op::True || node.op == tree::Op::False || node.op == tree::Op::Number || negative;
    }

    /// Assigned anew in every scan while the step is active.
    void every_scan(const std::string& step, const st::Association& one, const std::string& target, const SfcEffect& effect,
                    const SfcEffects& all, const std::unordered_set<std::string>& reads) {
        const bool boolean = !effect.value.valid();
        if (boolean ? is_constant(effect.set) && is_constant(effect.keep) : is_constant(effect.value))
            return once(step, one, target, effect, tree::StoredWhen::Activation);
        for (const auto& [name, other] : all)
            if (reads.contains(name) && depends_on(effect, name))
                return refuse(one.where, "`" + name + "`, which every scan computes from the scan before,",
                              "use P1 where it is meant once");
        if (!boolean)
            return refuse(one.where, "the integer `" + target + "`, which follows others in every scan,", "use P1 where it is meant once");
        once(step, one, target, effect, tree::StoredWhen::Activation);
        Id<tree::Expr> set = sfc_.draft.copy(effect.set);
        Id<tree::Expr> clear = opposite(sfc_, either(sfc_, sfc_.draft.copy(effect.set), sfc_.draft.copy(effect.keep)));
        for (const bool value : {true, false}) {
            const Id<tree::Expr> when = value ? set : clear;
            if (!when.valid() || is_constant(when)) continue;
            tree::StoredAction change = stored(target, sfc_.draft.constant(value, one.where), tree::StoredWhen::Event, one.where);
            change.event = sfc_.draft.node(tree::Op::Rise, {when}, one.where);
            of(step).emplace_back(std::move(change));
        }
        sfc_.differs(one.where, "N: the statements run in every scan; here `" + target + "` follows its term while the step is active, last in the scan that leaves it");
    }

    bool depends_on(const SfcEffect& effect, const std::string& variable) const {
        std::vector<Id<tree::Expr>> work;
        for (const Id<tree::Expr> root : {effect.set, effect.keep, effect.value})
            if (root.valid()) work.push_back(root);
        while (!work.empty()) {
            const Id<tree::Expr> id = work.back();
            work.pop_back();
            if (sfc_.draft[id].op == tree::Op::Name && sfc_.draft.file().text(sfc_.draft[id].word) == variable) return true;
            for (const Id<tree::Expr> inner : sfc_.draft.operands(id)) work.push_back(inner);
        }
        return false;
    }

    /// Actions of one scan run one after the other; here all read the values before.
    void note_order(Span where, const std::string& target, const std::unordered_set<std::string>& reads) {
        const auto other = writers_.find(target);
        if (other != writers_.end() && other->second != where.begin && orders_.insert(target).second)
            sfc_.differs(where, "several actions assign `" + target + "`: where two do so in one scan the later one wins, here that is a race");
        writers_.try_emplace(target, where.begin);
        for (const std::string& read : reads) {
            const auto writer = writers_.find(read);
            if (writer == writers_.end() || writer->second == where.begin || !orders_.insert(read + "?").second) continue;
            sfc_.differs(where, "`" + read + "` is read by one action and assigned by another: in one scan they run one after the other, here both see the value before");
        }
    }

    struct Reset {
        std::string step = {}, output = {};
        Span where = {};
    };

    Sfc& sfc_;
    SfcActions made_ = {};
    std::unordered_map<Id<st::Word>, const st::Action*> bodies_ = {};
    std::unordered_map<std::string, std::string> latches_ = {};
    std::unordered_set<std::string> pulses_ = {};
    std::unordered_map<std::string, std::unordered_set<std::string>> timed_latches_ = {};
    std::unordered_map<std::string, std::uint32_t> writers_ = {};
    std::unordered_set<std::string> orders_ = {};

public:
    /// R ends SD and SL of its output too. What else acts on the output while the step of R is active goes on here.
    void finish(SfcActions& made) {
        const bool parallel = has_parallel_steps();
        for (const Reset& reset : resets_) {
            if (!(parallel ? driven_ : outlasting_).contains(reset.output)) continue;
            sfc_.differs(reset.where, "R of `" + reset.output + "`: it wins over every other action on `" + reset.output +
                                          "` as long as its step is active; here it takes back once what is stored");
            driven_.erase(reset.output), outlasting_.erase(reset.output);
        }
        for (const Reset& reset : resets_)
            for (const std::string& state : timed_latches_[reset.output])
                made.of_steps[reset.step].emplace_back(stored(state, sfc_.draft.constant(false, reset.where), tree::StoredWhen::Activation, reset.where));
    }

private:
    bool has_parallel_steps() const {
        for (const st::Network& network : sfc_.unit.networks)
            if (std::ranges::any_of(network.transitions, [](const st::Transition& one) { return one.to.size() > 1; }) ||
                std::ranges::count_if(network.steps, &st::Step::initial) > 1)
                return true;
        return false;
    }

    std::unordered_set<std::string> driven_ = {};       ///< outputs with another qualifier than R
    std::unordered_set<std::string> outlasting_ = {};   ///< outputs of P0, which acts when its step is left
    std::vector<Reset> resets_ = {};
};

}  // namespace

SfcActions actions_of(Sfc& sfc) {
    Actions actions(sfc);
    SfcActions made = actions.run();
    actions.finish(made);
    return made;
}

}  // namespace grafverif
