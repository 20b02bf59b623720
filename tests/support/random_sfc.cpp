// SPDX-License-Identifier: MIT
#include "support/random_sfc.hpp"

#include <fmt/format.h>
#include <fmt/ranges.h>

#include <algorithm>
#include <numeric>

namespace grafverif {

void RandomSfc::Stretch::follow(bool value, std::int64_t at) {
    rises = value && !on;
    falls = on && !value;
    if (rises) since = at;
    on = value;
}

bool RandomSfc::is_true(const Literal& literal) const {
    const auto value = [&] {
        switch (literal.kind) {
        case Kind::Input: return values[literal.index];
        case Kind::Active: return steps[literal.index].active;
        case Kind::Time: {
            const Step& step = steps[literal.index];
            return (step.active ? now - step.since : step.lasted) >= literal.least;
        }
        case Kind::Variable:
        case Kind::Action: return actions[literal.index].q;
        }
        return false;
    };
    return value() != literal.negated;
}

bool RandomSfc::is_active(std::size_t action, const std::string& qualifier) const {
    return std::ranges::any_of(steps, [&](const Step& step) {
        return step.active && std::ranges::find(step.blocks, std::pair{action, qualifier}) != step.blocks.end();
    });
}

void RandomSfc::evolve() {
    std::vector<std::size_t> by_priority(transitions.size());
    std::iota(by_priority.begin(), by_priority.end(), std::size_t{0});
    std::ranges::stable_sort(by_priority, {}, [&](std::size_t i) { return transitions[i].priority; });
    std::vector<bool> left(steps.size()), entered(steps.size());
    cleared = 0;
    selected = false;
    for (const std::size_t i : by_priority) {
        const Transition& one = transitions[i];
        if (!std::ranges::all_of(one.from, [&](std::size_t step) { return steps[step].active; })) continue;
        if (!std::ranges::all_of(one.condition, [&](const Literal& literal) { return is_true(literal); })) continue;
        if (std::ranges::any_of(one.from, [&](std::size_t step) { return left[step]; })) {
            selected = true;
            continue;
        }
        ++cleared;
        for (const std::size_t step : one.from) left[step] = true;
        for (const std::size_t step : one.to) entered[step] = true;
    }
    for (std::size_t i = 0; i < steps.size(); ++i) {
        Step& step = steps[i];
        if (entered[i]) {
            step.active = true;
            step.since = now;
        } else if (left[i]) {
            step.active = false;
            step.lasted = now - step.since;
        }
    }
}

void RandomSfc::control(std::size_t index) {
    Action& action = actions[index];
    const bool reset = is_active(index, "R");
    const bool before = action.q;
    action.pulse.follow(is_active(index, "P"), now);
    action.entry.follow(is_active(index, "P1"), now);
    action.exit.follow(is_active(index, "P0"), now);
    bool value = is_active(index, "N") || action.pulse.rises;
    const bool delayed = action.timed == "DS";
    // With SD and SL the action is stored before its time is counted.
    if (!action.timed.empty() && action.timed.front() == 'S') {
        action.delay.follow(!reset && (action.delay.on || is_active(index, action.timed)), now);
    } else if (!action.timed.empty()) {
        action.delay.follow(is_active(index, action.timed), now);
    }
    const bool over = action.delay.on && now - action.delay.since >= action.duration;
    if (action.timed == "L" || action.timed == "SL") value = value || (action.delay.on && !over);
    if (action.timed == "D" || action.timed == "SD") value = value || over;
    action.stored = !reset && (action.stored || is_active(index, "S") || (delayed && over));
    action.q = !reset && (value || action.stored);
    action.executed = action.q || before || action.entry.rises || action.exit.falls;
}

void RandomSfc::scan(const std::vector<std::int64_t>& sampled, std::int64_t elapsed) {
    for (std::size_t i = 0; i < inputs; ++i) values[i] = sampled[i] != 0;
    now += elapsed;
    if (started) evolve();
    else steps[0].active = true, steps[0].since = now;
    started = true;
    std::vector<bool> before;
    for (const Action& action : actions) before.push_back(action.q);
    for (const std::size_t index : order) control(index);
    // A statement reads a Boolean variable before the assignment of a later action changes it.
    std::vector<bool> after;
    for (const Action& action : actions) after.push_back(action.q);
    for (std::size_t i = 0; i < actions.size(); ++i)
        if (actions[i].variable) actions[i].q = before[i];
    for (const std::size_t index : order) {
        Action& action = actions[index];
        if (action.variable) action.q = after[index];
        else if (action.executed) {
            ++action.count;
            action.copy = is_true(action.copied);
        }
    }
}

std::string RandomSfc::text(const Literal& literal) const {
    const std::string negation = literal.negated ? "NOT " : "";
    switch (literal.kind) {
    case Kind::Input: return fmt::format("{}i{}", negation, literal.index);
    case Kind::Active: return fmt::format("{}S{}.X", negation, literal.index);
    case Kind::Variable: return fmt::format("{}v{}", negation, literal.index);
    case Kind::Action: return fmt::format("{}v{}.Q", negation, literal.index);
    case Kind::Time: break;
    }
    return literal.negated ? fmt::format("T#{}ms > S{}.T", literal.least, literal.index)
                           : fmt::format("S{}.T >= T#{}ms", literal.index, literal.least);
}

std::string RandomSfc::condition(const Transition& transition) const {
    std::string all;
    for (const Literal& literal : transition.condition) all += (all.empty() ? "(" : " AND (") + text(literal) + ")";
    return all.empty() ? "TRUE" : all;
}

std::string RandomSfc::statements(std::size_t action) const {
    return fmt::format("c{0} := c{0} + 1; m{0} := {1};", action, text(actions[action].copied));
}

std::string RandomSfc::text() const {
    std::string text = "PROGRAM Main\nVAR_INPUT i0, i1, i2 : BOOL; END_VAR\n";
    for (std::size_t i = 0; i < actions.size(); ++i)
        text += actions[i].variable ? fmt::format("VAR v{} : BOOL; END_VAR\n", i)
                                    : fmt::format("VAR c{0} : INT; m{0} : BOOL; END_VAR\n", i);
    for (std::size_t i = 0; i < steps.size(); ++i) {
        text += fmt::format("{} S{}:", i == 0 ? "INITIAL_STEP" : "STEP", i);
        for (const auto& [action, qualifier] : steps[i].blocks) {
            const bool timed = qualifier == actions[action].timed;
            text += fmt::format(" v{}({}{});", action, qualifier,
                                timed ? fmt::format(", T#{}ms", actions[action].duration) : "");
        }
        text += " END_STEP\n";
    }
    const auto list = [](const std::vector<std::size_t>& of) {
        return of.size() == 1 ? fmt::format("S{}", of[0]) : fmt::format("(S{})", fmt::join(of, ", S"));
    };
    for (std::size_t i = 0; i < transitions.size(); ++i) {
        const Transition& one = transitions[i];
        text += fmt::format("TRANSITION t{}{} FROM {} TO {} := {}; END_TRANSITION\n", i,
                            one.priority == 0 ? "" : fmt::format(" (PRIORITY := {})", one.priority), list(one.from),
                            list(one.to), condition(one));
    }
    for (std::size_t i = 0; i < actions.size(); ++i)
        if (!actions[i].variable) text += fmt::format("ACTION v{}: {} END_ACTION\n", i, statements(i));
    return text + "END_PROGRAM\n";
}

std::string RandomSfc::xml(Random& random) const {
    const auto id_of = [&](std::size_t transition) { return steps.size() + transition; };
    const auto connection = [](std::size_t id) { return fmt::format("<connection refLocalId=\"{}\"/>", id); };
    const auto body = [](const std::string& text) { return fmt::format("<ST><xhtml>{}</xhtml></ST>", text); };
    std::string elements;
    std::size_t next = steps.size() + transitions.size();
    for (std::size_t i = 0; i < steps.size(); ++i) {
        elements +=
            fmt::format("<step localId=\"{0}\" name=\"S{0}\" initialStep=\"{1}\"><connectionPointIn>", i, i == 0);
        for (std::size_t j = 0; j < transitions.size(); ++j)
            if (std::ranges::find(transitions[j].to, i) != transitions[j].to.end()) elements += connection(id_of(j));
        elements += "</connectionPointIn></step>\n";
        for (const auto& [action, qualifier] : steps[i].blocks) {
            const bool timed = qualifier == actions[action].timed;
            elements += fmt::format(
                "<actionBlock localId=\"{}\"><connectionPointIn>{}</connectionPointIn><action "
                "qualifier=\"{}\"{}><reference name=\"v{}\"/></action></actionBlock>\n",
                next++, connection(i), qualifier,
                timed ? fmt::format(" duration=\"T#{}ms\"", actions[action].duration) : "", action);
        }
    }
    std::vector<std::size_t> shuffled(transitions.size());
    std::iota(shuffled.begin(), shuffled.end(), std::size_t{0});
    std::ranges::shuffle(shuffled, random);
    for (const std::size_t i : shuffled) {
        const Transition& one = transitions[i];
        elements +=
            fmt::format("<transition localId=\"{}\"{}><position x=\"{}\" y=\"0\"/><connectionPointIn>", id_of(i),
                        one.priority == 0 ? "" : fmt::format(" priority=\"{}\"", one.priority), 10 * i);
        for (const std::size_t step : one.from) elements += connection(step);
        elements += fmt::format("</connectionPointIn><condition><inline>{}</inline></condition></transition>\n",
                                body(condition(one)));
    }
    std::string variables, named;
    const auto variable = [](const std::string& name, const char* type) {
        return fmt::format("<variable name=\"{}\"><type><{}/></type></variable>", name, type);
    };
    for (std::size_t i = 0; i < actions.size(); ++i) {
        const std::string index = std::to_string(i);
        variables += actions[i].variable ? variable("v" + index, "BOOL")
                                         : variable("c" + index, "INT") + variable("m" + index, "BOOL");
        if (!actions[i].variable)
            named += fmt::format("<action name=\"v{}\"><body>{}</body></action>\n", i, body(statements(i)));
    }
    return fmt::format(
        "<project xmlns=\"http://www.plcopen.org/xml/tc6_0201\"><types><dataTypes/><pous><pou name=\"Main\" "
        "pouType=\"program\"><interface><inputVars>{}</inputVars><localVars>{}</localVars></interface>\n<actions>{}"
        "</actions>\n<body><SFC>\n{}</SFC></body></pou></pous></types></project>\n",
        variable("i0", "BOOL") + variable("i1", "BOOL") + variable("i2", "BOOL"), variables, named, elements);
}

namespace {

class Maker {
public:
    explicit Maker(Random& random) : random_(random) {}

    RandomSfc make() {
        const std::size_t first = add_step();
        const std::size_t last = sequence(first, 2);
        add({last}, {first});
        actions();
        conditions();
        return std::move(chart_);
    }

private:
    bool is(int percent) { return chance(random_, percent); }
    std::size_t below(std::size_t count) {
        return static_cast<std::size_t>(random_number(random_, 0, static_cast<std::int64_t>(count) - 1));
    }
    std::int64_t duration() { return 5 * random_number(random_, 0, 8); }

    std::size_t add_step() {
        chart_.steps.emplace_back();
        return chart_.steps.size() - 1;
    }
    void add(std::vector<std::size_t> from, std::vector<std::size_t> to) {
        chart_.transitions.push_back({std::move(from), std::move(to)});
    }

    /// Adds a sequence of steps after `step`. Returns the last step of the sequence.
    std::size_t sequence(std::size_t step, int depth) {
        const std::size_t start = step;
        for (std::size_t count = below(3) + (depth == 2 ? 1 : 0); count > 0; --count) {
            const std::size_t form = depth == 0 ? 0 : below(4);
            if (is(15)) add({step}, {step});
            if (is(20)) add({step}, {start});
            std::vector<std::size_t> firsts, lasts;
            for (std::size_t branches = form == 0 ? 0 : 2; branches > 0; --branches) {
                firsts.push_back(add_step());
                lasts.push_back(sequence(firsts.back(), depth - 1));
            }
            const std::size_t next = add_step();
            if (form == 0) add({step}, {next});
            if (form == 1) {  // a selection of sequences
                for (std::size_t i = 0; i < 2; ++i) add({step}, {firsts[i]}), add({lasts[i]}, {next});
                if (is(40)) add({step}, {next});
            }
            if (form > 1) add({step}, firsts), add(lasts, {next});
            step = next;
        }
        return step;
    }

    void actions() {
        static const std::vector<std::string> timed = {"L", "D", "SD", "DS", "SL"};
        static const std::vector<std::string> untimed = {"N", "N", "S", "R", "P", "P1", "P0"};
        for (std::size_t i = 0; i < 5; ++i) {
            RandomSfc::Action& action = chart_.actions.emplace_back();
            action.variable = i < 2;
            if (is(70)) action.timed = timed[below(timed.size())];
            action.duration = duration();
        }
        for (RandomSfc::Step& step : chart_.steps)
            for (std::size_t count = below(4); count > 0; --count) {
                const std::size_t index = below(chart_.actions.size());
                RandomSfc::Action& action = chart_.actions[index];
                const bool with_time = !action.timed.empty() && is(50);
                step.blocks.emplace_back(
                    index, with_time ? action.timed : untimed[below(untimed.size() - (action.variable ? 2 : 0))]);
                if (!action.used) chart_.order.push_back(index);
                action.used = true;
            }
    }

    RandomSfc::Literal literal() {
        using Kind = RandomSfc::Kind;
        const std::size_t kind = below(10);
        RandomSfc::Literal made{Kind::Input, below(RandomSfc::inputs), 0, is(30)};
        if (kind == 0) made.kind = Kind::Active, made.index = below(chart_.steps.size());
        if (kind == 1 || kind == 2)
            made.kind = Kind::Time, made.index = below(chart_.steps.size()), made.least = duration();
        if (kind == 3) made.kind = Kind::Variable, made.index = below(2);
        if (kind == 4) {
            const std::size_t index = 2 + below(3);
            if (chart_.actions[index].used) made.kind = Kind::Action, made.index = index;
        }
        return made;
    }

    void conditions() {
        std::vector<std::int64_t> priorities(chart_.transitions.size());
        std::iota(priorities.begin(), priorities.end(), 1);
        std::ranges::shuffle(priorities, random_);
        const bool by_priority = is(50);
        for (std::size_t i = 0; i < chart_.transitions.size(); ++i) {
            RandomSfc::Transition& one = chart_.transitions[i];
            for (std::size_t count = below(3); count > 0; --count) one.condition.push_back(literal());
            if (by_priority) one.priority = priorities[i];
        }
        for (RandomSfc::Action& action : chart_.actions) action.copied = literal();
    }

    Random& random_;
    RandomSfc chart_ = {};
};

}  // namespace

RandomSfc random_sfc(Random& random) { return Maker(random).make(); }

}  // namespace grafverif
