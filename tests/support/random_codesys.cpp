// SPDX-License-Identifier: MIT
#include "support/random_codesys.hpp"

#include <fmt/format.h>

#include <algorithm>

namespace grafverif {

namespace {

bool is_variable(const std::string& name) { return name.front() == 'v'; }

}  // namespace

void RandomCodesys::control(Chart& chart, const std::string& name, Control& one) {
    const auto active = [&](const std::string& qualifier) {
        return std::ranges::any_of(chart.steps, [&](const Step& step) {
            return step.active && std::ranges::find(step.blocks, std::pair{name, qualifier}) != step.blocks.end();
        });
    };
    const bool reset = active("R");
    if (reset) stored[name] = false;
    else if (active("S")) stored[name] = true;
    one.pulse.follow(active("P"), now);
    one.delay.follow(active("D"), now);
    one.limit.follow(active("L"), now);
    one.before = one.q;
    one.q =
        !reset && (active("N") || stored[name] || one.pulse.rises || (one.delay.on && now - one.delay.since >= delay) ||
                   (one.limit.on && now - one.limit.since < delay));
    if (is_variable(name) && reset) one.before = true;  // R sets the variable to false
}

bool RandomCodesys::is_true(const Chart& chart, const Transition& one) {
    if (!one.condition.empty()) return (one.condition == "TRUE" || values[one.condition]) != one.negated;
    const Step& step = chart.steps[one.timed];
    return (step.active ? now - step.since : step.lasted) >= one.least;
}

void RandomCodesys::execute(Chart& chart) {
    if (uses_reset && values["SFCReset"]) {
        ++resets;
        for (Step& step : chart.steps) {
            if (step.active) step.lasted = now - step.since;
            step.active = step.next = false;
        }
        chart.steps.front().next = true;
        for (const auto& [name, ignored] : chart.controls) stored[name] = false;
    }
    for (Step& step : chart.steps) {
        step.before = std::exchange(step.active, step.next);
        if (step.active && !step.before) step.since = now;
        if (step.before && !step.active) step.lasted = now - step.since;
    }
    for (const Step& step : chart.steps)
        if (step.exit != 0 && step.before && !step.active) run(step.exit), ++exits;
    for (const Step& step : chart.steps)
        if (step.entry != 0 && step.active && !step.before) run(step.entry);
    for (const Step& step : chart.steps)
        if (step.main != 0 && step.active) run(step.main);
    for (auto& [name, one] : chart.controls) control(chart, name, one);
    for (const bool ending : {true, false})
        for (const auto& [name, one] : chart.controls) {
            if (ending ? one.q || !one.before : !one.q) continue;
            if (is_variable(name)) values[name] = !ending;
            else run(name.back() - '0');
            ends += ending ? 1 : 0;
        }
    std::vector<bool> left(chart.steps.size()), entered(chart.steps.size());
    for (const Transition& one : chart.transitions) {
        const auto usable = [&](std::size_t step) { return chart.steps[step].active && !left[step]; };
        if (!std::ranges::all_of(one.from, usable)) continue;
        if (!is_true(chart, one)) continue;
        ++cleared;
        for (const std::size_t step : one.from) left[step] = true;
        for (const std::size_t step : one.to) entered[step] = true;
    }
    for (std::size_t i = 0; i < left.size(); ++i)
        if (entered[i] || left[i]) chart.steps[i].next = entered[i];
}

void RandomCodesys::scan(const std::vector<std::int64_t>& inputs, std::int64_t elapsed) {
    now += elapsed;
    for (std::size_t i = 0; i < 3; ++i) values[fmt::format("i{}", i)] = inputs[i] != 0;
    values["SFCReset"] = inputs[3] != 0;
    execute(charts[0]);
    if (values["i2"]) execute(charts[1]);
}

std::string RandomCodesys::xml() const {
    const auto connection = [](std::size_t id) { return fmt::format("<connection refLocalId=\"{}\"/>", id); };
    const auto data = [](const std::string& name, const std::string& content) {
        return fmt::format("<addData><data name=\"http://www.3s-software.com/plcopenxml/{}\">{}</data></addData>", name,
                           content);
    };
    std::string named;
    for (int i = 1; i <= actions; ++i)
        named += fmt::format(
            "<action name=\"A{0}\"><body><ST><xhtml>log := (log * 7 + {0}) MOD 1000;</xhtml></ST></body></action>\n",
            i);
    for (std::size_t c = 0; c < charts.size(); ++c) {
        const Chart& chart = charts[c];
        std::size_t next = chart.steps.size() + 2 * chart.transitions.size();
        std::string elements;
        for (std::size_t i = 0; i < chart.steps.size(); ++i) {
            const Step& step = chart.steps[i];
            std::string lines, attributes;
            for (std::size_t j = 0; j < chart.transitions.size(); ++j)
                if (std::ranges::find(chart.transitions[j].to, i) != chart.transitions[j].to.end())
                    lines += connection(chart.steps.size() + j);
            for (const auto& [guid, action] : {std::pair("a6b08bd8-b696-47e3-9cbf-7408b61c9ff8", step.entry),
                                               {"700a583f-b4d4-43e4-8c14-629c7cd3bec8", step.main},
                                               {"a2621e18-7de3-4ea6-ae6d-89e9e0b7befd", step.exit}})
                if (action != 0) attributes += fmt::format("<attribute guid=\"{}\">A{}</attribute>", guid, action);
            elements += fmt::format(
                "<step localId=\"{0}\" name=\"S{0}\" initialStep=\"{1}\"><connectionPointIn>{2}</connectionPointIn>{3}"
                "</step>\n",
                i, i == 0, lines, data("sfc/element", "<attributes xmlns=\"\">" + attributes + "</attributes>"));
            for (const auto& [name, qualifier] : step.blocks)
                elements += fmt::format(
                    "<actionBlock localId=\"{}\"><connectionPointIn>{}</connectionPointIn><action qualifier=\"{}\"{}>"
                    "<reference name=\"{}\"/></action></actionBlock>\n",
                    next++, connection(i), qualifier,
                    qualifier == "D" || qualifier == "L" ? fmt::format(" duration=\"T#{}ms\"", delay) : "", name);
        }
        for (std::size_t j = 0; j < chart.transitions.size(); ++j) {
            const Transition& one = chart.transitions[j];
            std::string lines;
            for (const std::size_t step : one.from) lines += connection(step);
            const std::size_t id = chart.steps.size() + j, value = id + chart.transitions.size();
            elements += fmt::format(
                "<inVariable localId=\"{}\"><connectionPointOut/><expression>{}{}</expression></inVariable>\n"
                "<transition localId=\"{}\"><connectionPointIn>{}</connectionPointIn><condition><connectionPointIn>{}"
                "</connectionPointIn></condition></transition>\n",
                value, one.negated ? "NOT " : "",
                one.condition.empty() ? fmt::format("S{}.t &gt;= T#{}ms", one.timed, one.least) : one.condition, id,
                lines, connection(value));
        }
        const std::string settings = fmt::format(
            "<SFCSettings><UseDefaults>false</UseDefaults><Flags><Init Declare=\"true\" Use=\"true\"/>"
            "<Reset Declare=\"true\" Use=\"{}\"/><Pause Declare=\"true\" Use=\"false\"/></Flags></SFCSettings>",
            uses_reset);
        named += fmt::format("<action name=\"Chart{}\"><body><SFC>\n{}</SFC></body>{}</action>\n", c, elements,
                             data("sfcsettings", settings));
    }
    const auto variable = [](const std::string& name, const char* type) {
        return fmt::format("<variable name=\"{}\"><type><{}/></type></variable>", name, type);
    };
    std::string inputs, locals = variable("log", "INT");
    for (const char* name : {"i0", "i1", "i2", "SFCReset"}) inputs += variable(name, "BOOL");
    for (const char* name : {"v0", "v1", "v2"}) locals += variable(name, "BOOL");
    return fmt::format(
        "<project xmlns=\"http://www.plcopen.org/xml/tc6_0200\"><types><dataTypes/><pous><pou name=\"Main\" "
        "pouType=\"program\"><interface><inputVars>{}</inputVars><localVars>{}</localVars></interface>\n<actions>{}"
        "</actions>\n<body><ST><xhtml>Chart0(); IF i2 THEN Chart1(); END_IF</xhtml></ST></body></pou></pous></types>"
        "</project>\n",
        inputs, locals, named);
}

namespace {

class Drawing {
public:
    explicit Drawing(Random& random) : random_(random) {}

    RandomCodesys::Chart chart() {
        chart_ = {};
        const std::size_t first = add_step();
        const std::size_t last = sequence(first, 2);
        add({last}, {first});
        for (std::size_t i = 0; i < chart_.steps.size(); ++i) decorate(i);
        return std::move(chart_);
    }

private:
    bool is(int percent) { return chance(random_, percent); }
    int below(int count) { return static_cast<int>(random_number(random_, 0, count - 1)); }

    std::size_t add_step() {
        chart_.steps.emplace_back();
        chart_.steps.back().next = chart_.steps.size() == 1;
        return chart_.steps.size() - 1;
    }

    void add(std::vector<std::size_t> from, std::vector<std::size_t> to) {
        static const std::vector<std::string> conditions = {"i0", "i1", "v0", "v1", "TRUE"};
        RandomCodesys::Transition made;
        if (is(20)) {
            made.timed = from.front();
            made.least = 5 * below(6);
        } else {
            made.condition = conditions[static_cast<std::size_t>(below(5))];
            made.negated = made.condition != "TRUE" && is(40);
        }
        made.from = std::move(from);
        made.to = std::move(to);
        chart_.transitions.push_back(std::move(made));
    }

    std::size_t sequence(std::size_t step, int depth) {
        for (int count = below(3) + (depth == 2 ? 1 : 0); count > 0; --count) {
            const int form = depth == 0 ? 0 : below(4);
            if (is(15)) add({step}, {step});
            const std::size_t one = form == 0 ? 0 : add_step(), other = form == 0 ? 0 : add_step();
            const std::size_t one_end = form == 0 ? 0 : sequence(one, depth - 1);
            const std::size_t other_end = form == 0 ? 0 : sequence(other, depth - 1);
            const std::size_t next = add_step();
            if (form == 0) add({step}, {next});
            else if (form == 1)
                add({step}, {one}), add({step}, {other}), add({one_end}, {next}), add({other_end}, {next});
            else add({step}, {one, other}), add({one_end, other_end}, {next});
            step = next;
        }
        return step;
    }

    void decorate(std::size_t index) {
        RandomCodesys::Step& step = chart_.steps[index];
        const bool repeats = std::ranges::any_of(chart_.transitions, [&](const RandomCodesys::Transition& one) {
            return std::ranges::find(one.from, index) != one.from.end() &&
                   std::ranges::find(one.to, index) != one.to.end();
        });
        if (is(50)) step.main = below(RandomCodesys::actions) + 1;
        if (!repeats && index != 0 && is(40)) step.entry = below(RandomCodesys::actions) + 1;
        if (!repeats && is(40)) step.exit = below(RandomCodesys::actions) + 1;
        for (int count = below(3); count > 0; --count) {
            static const std::vector<std::string> qualifiers = {"N", "S", "R", "P"};
            const int which = below(6);
            const std::string name = which < 3 ? fmt::format("v{}", which) : fmt::format("A{}", which - 2);
            std::string qualifier = qualifiers[static_cast<std::size_t>(below(4))];
            if (name == "v2") qualifier = is(50) ? "D" : qualifier;
            if (name == "A2") qualifier = is(50) ? "L" : qualifier;
            step.blocks.emplace_back(name, qualifier);
            chart_.controls.try_emplace(name);
        }
    }

    Random& random_;
    RandomCodesys::Chart chart_ = {};
};

}  // namespace

RandomCodesys random_codesys(Random& random) {
    RandomCodesys made;
    Drawing drawing(random);
    for (RandomCodesys::Chart& chart : made.charts) chart = drawing.chart();
    made.uses_reset = chance(random, 60);
    return made;
}

}  // namespace grafverif
