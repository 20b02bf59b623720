// SPDX-License-Identifier: MIT
// Explanations: why a transition is or is not cleared, and why a property is violated. The value of a term is shown as
// a tree that contains the values of all its subterms.
import {make, prose} from "./dom.js";
import {ClaimReader, sinceWords} from "./claims.js";
import {Decision} from "./terms.js";

const signs = {and: "all of", or: "one of", not: "not", rise: "rises", fall: "falls"};

function valueWords(node, value) {
    if (value === undefined) return "not known";
    return node.boolean ? (value ? "true" : "false") : `${value}`;
}

// Returns the tree of a term. `reader` returns values and remarks. The user can collapse the operands of each term. If
// `faulty` is true, the value false is highlighted as a fault.
function termTree(terms, term, reader, {faulty = true, open = true} = {}) {
    const node = terms[term], value = reader.value(term);
    const state = value === undefined ? "unknown" : node.boolean ? (value ? "true" : "false") : "number";
    const line = [
        make("span", {class: "mark", "aria-hidden": "true"}, {true: "✓", false: "✗", unknown: "?", number: "#"}[state]),
        make("code", {}, node.text),
        make("span", {class: "value"}, ` ${valueWords(node, value)}`),
    ];
    const remark = reader.remark(node, term);
    if (remark) line.push(make("span", {class: "remark"}, ` (${remark})`));
    const args = node.args ?? [], kind = state !== "false" || faulty ? `term ${state}` : "term";
    if (args.length === 0) return make("li", {class: kind}, ...line);
    if (signs[node.op]) line.push(make("span", {class: "remark"}, ` ${signs[node.op]}:`));
    const below = make("ul", {}, ...args.map((each) => termTree(terms, each, reader, {faulty, open: args.length < 12})));
    return make("li", {class: kind}, make("details", {open}, make("summary", {}, ...line), below));
}

// Explains why the transition is or is not cleared. If the transition is cleared in the displayed range of events,
// `cleared` contains the last event at which it is cleared, and how often it is cleared.
export function whyTransition(run, chart, controller, place, moment, cleared) {
    const transition = chart.transitions[place];
    const name = run.controllers.length > 1 ? `${run.controllers[controller].name}: ${transition.name}` : transition.name;
    const before = cleared !== undefined;
    if (before && run.evolutionsIn(controller, cleared.last) > 1)
        return make("div", {}, make("p", {class: "answer"},
            `${name} is cleared in one of several evolutions of this instant, which the trace does not distinguish.`));
    const reader = new Decision(run, chart, controller, before ? cleared.last : moment, before);
    const steps = run.controllers[controller].steps;
    const missing = transition.from.filter((step) => !run.isActive(steps[step], reader.state));
    const value = reader.value(transition.condition);
    const list = make("ul", {class: "terms"});
    for (const step of transition.from) {
        const active = run.isActive(steps[step], reader.state);
        list.append(make("li", {class: `term ${active}`},
                         make("span", {class: "mark", "aria-hidden": "true"}, active ? "✓" : "✗"),
                         make("span", {}, "step "), make("code", {}, chart.steps[step]),
                         make("span", {class: "value"}, active ? " is active" : " is not active")));
    }
    list.append(termTree(chart.terms, transition.condition, reader));
    return make("div", {}, make("p", {class: "answer"}, verdict(name, cleared, value, missing.map((step) => chart.steps[step]), reader)), list);
}

// Returns a text that states why the transition is or is not cleared. The inputs that the controller samples before an
// evolution determine which transitions the evolution clears.
function verdict(name, cleared, value, missing, {run, number, moment, read}) {
    if (cleared?.times > 1)
        return `${name} is cleared ${cleared.times} times here. The tree shows the condition of ${name} before it was cleared for the last time.`;
    if (cleared) return `${name} is cleared here. The tree shows the condition of ${name} before it was cleared.`;
    if (missing.length > 0) return `${name} cannot be cleared: ${missing.join(", ")} ${missing.length > 1 ? "are" : "is"} not active.`;
    if (value === undefined) return `${name} is enabled; the trace does not determine the value of its condition.`;
    if (!value) return `${name} is enabled, but its condition is false.`;
    if (run.isToEvolve(number, moment))
        return `${name} is enabled and its condition is true: the next evolution clears it, unless a forcing order prevents this.`;
    return `${name} is enabled; its condition is true for the ${read ? "inputs last read" : "current inputs"}.`;
}

// Returns true if the value false of the operand is not a violation of the property.
const mayBeFalse = ({pattern, headings}, operand) =>
    headings || ["never", "exactly-one"].includes(pattern) || (pattern === "leads-to" && operand === 0);

const wordsOf = {
    always: ["must always be true"],
    never: ["forbidden"],
    reachable: ["must be able to become true"],
    inevitable: ["must eventually become true"],
    "leads-to": ["premise", "required response"],
    "exactly-one": ["exactly one of these must be true"],
    "always-possible": ["must remain possible"],
};

// Explains a property at the event `moment`: the values of its operands, the events since which the operands have these
// values, and the causes. `decisive` is the event that decides the property.
export function whyProperty(claims, moment, decisive, go) {
    const {run, property} = claims;
    const words = property.headings ?? wordsOf[property.pattern] ?? [], when = property.at_stable ? " in quiescent states" : "";
    const reader = new ClaimReader(claims, moment);
    const link = (to, text) => make("button", {type: "button", class: "link", onclick: () => go(to)}, ...[text].flat());
    const parts = property.operands.map((term, k) => {
        const since = claims.since(term, moment), value = reader.value(term);
        const so = `${valueWords(property.terms[term], value)} ${sinceWords(run, since)}`;
        const heading = make("p", {class: "answer"}, words[Math.min(k, words.length - 1)] ?? "", when, ": ");
        if (value !== undefined) heading.append(since === 0 ? make("span", {class: "remark"}, so) : link(since, so));
        const makers = value === undefined ? [] : claims.causes(term, moment);
        if (makers.length > 0 && makers[0] !== term)
            heading.append(", caused by ", ...makers.flatMap((each, n) => [n > 0 ? ", " : "",
                make("code", {}, property.terms[each].text), ` = ${valueWords(property.terms[each], claims.value(each, since))}`]));
        return [heading, make("ul", {class: "terms"}, termTree(property.terms, term, reader, {faulty: !mayBeFalse(property, k)}))];
    });
    return make("div", {}, ...violation(run, link), ...(decisive === null ? [] : [standing(property, moment, decisive, link, run)]),
                ...parts.flat(), ...causes(run, moment, link));
}

// Returns text about the events by which a run violates a property that has an observer.
function violation({data}, link) {
    if (!data.violation) return [];
    const steps = data.violation.steps.flatMap(({moment, words}, k) =>
        [k > 0 ? "; " : "", ...(moment === null ? prose(words) : [link(moment, prose(words))])]);
    return [make("p", {class: "violation"}, ...steps, ".")];
}

// Returns text about the causes of the violation, with links to the events at which they begin, and about the changes
// without which the property holds.
function causes(run, moment, link) {
    const {causes, left_out = [], left_out_values = []} = run.trace, parts = [];
    const when = (m) => (m === 0 ? "power-on" : run.timeText(m));
    if (causes) {
        const items = causes.values.map(({words, from, to}) => {
            const until = to === from ? "" : to === run.last ? " on" : ` to ${when(to)}`;
            return make("li", {class: from <= moment && moment <= to ? "cause here" : "cause"}, make("code", {}, words),
                        from === to ? " at " : " from ", link(from, when(from)), until);
        });
        parts.push(make("p", {class: "answer"}, `${causes.exact ? "Causes" : "Causes, approximately"}:`),
                   make("ul", {class: "causes"}, ...items));
    }
    const moments = [...left_out.map((at) => ({at})), ...left_out_values.map(({moment, words}) => ({at: moment, words}))];
    moments.sort((a, b) => a.at - b.at);
    const inputs = !run.trace.timed && left_out_values.length > 0;
    if (moments.length > 0)
        parts.push(make("p", {class: "answer"}, "Without ",
                        ...moments.flatMap(({at, words}, k) => [k > 0 ? ", " : "", make("code", {}, words ?? moveText(run, at)),
                                                                " at ", link(at, when(at))]),
                        ", the property holds along the run",
                        inputs ? ", and after its end as long as nothing changes." : "."));
    return parts;
}

// Returns a move of an instance in the notation of printed traces, such as `Start (START)`.
function moveText(run, at) {
    const {instance, location} = run.trace.moments[at], {name, locations} = run.trace.instances[instance];
    const changes = run.trace.signals.flatMap(({name: signal, role, range}, k) => {
        const now = run.value(k, at), past = run.value(k, at - 1);
        if (now === past || !["input", "plant"].includes(role)) return [];
        return [range ? `${signal} ${past} -> ${now}` : `${now ? "" : "!"}${signal}`];
    });
    const what = [...(location === null ? [] : [locations[location]]), ...changes].join(", ");
    return what === "" ? name : `${name} (${what})`;
}

// Returns text that states whether the decisive event is before, at or after the current event.
function standing({pattern, at_stable, headings}, moment, decisive, link, run) {
    const there = decisive === 0 ? "power-on" : run.timeText(decisive);
    const said = (before, here, behind) => make("p", {class: "standing"},
        ...(moment < decisive ? [`${before} `, link(decisive, there), "."] : moment === decisive ? [here] : [`${behind} `, link(decisive, there), "."]));
    if (pattern === "leads-to")
        return said("The premise without a response occurs at", "The premise without a response occurs here.", "There has been no response since");
    if (headings)
        return said("Not violated yet; the violation occurs at", "The property is violated here.", "Violated since");
    if (at_stable || pattern === "exactly-one")
        return said("The property is violated at the end of the trace, at", "The property is violated here.", "Violated since");
    return said("Not violated yet; the violation occurs at", "The property is violated here for the first time.", "First violated at");
}

// Returns the event after which the state decides a violated property; null if this event is unknown. For `always` and
// `never`, it is the first event after which the property fails; for `leads to`, the first event with the premise after
// which no response follows; for a property with an observer, the event from which on the property fails. For `exactly
// one of`, and for `always` and `never` with `at stable`, it is the last event: a run does not state which of its
// earlier states are quiescent.
export function decisiveMoment(claims) {
    const {run, property} = claims;
    if (property.operands.length === 0) return null;
    if (property.headings) return run.data.violation?.moment ?? (run.loopMoment() === null ? run.last : null);
    const [p, q] = property.operands;
    switch (property.pattern) {
    case "never": return property.at_stable ? run.last : claims.first(p, 1, 0);
    case "always": return property.at_stable ? run.last : claims.first(p, 0, 0);
    case "leads-to": {
        if (property.at_stable || claims.value(q, run.last) !== 0) return null;
        return claims.first(p, 1, claims.since(q, run.last));
    }
    case "exactly-one": return run.last;
    }
    return null;
}
