// SPDX-License-Identifier: MIT
// The verdicts of the models of a file.
import {make, prose} from "./dom.js";
import {token} from "./server.js";

const outcomes = {holds: "holds", violated: "is violated", unknown: "is unknown"};

const kindOf = (property) => property.verdict === "unknown" ? "unknown" : !property.as_expected ? "bad" : property.verdict === "violated" ? "expected" : "ok";

// Returns the sort key of a property: unexpected verdicts come first, then unknown verdicts, then expected violations,
// then properties that hold as expected.
const rank = (property) => ["bad", "unknown", "expected", "ok"].indexOf(kindOf(property));

// Returns the element of a property. `report` is the address of the report of the model, or an empty string.
function propertyElement(property, report) {
    const kind = kindOf(property);
    const mark = {holds: "\u2713", violated: "\u2717", unknown: "?"}[property.verdict];
    const expected = property.expected === "violated" ? ", as expected" : "";
    const words = outcomes[property.verdict] + (property.vacuous ? " vacuously" : "") +
                  {ok: expected, expected, bad: ", unexpectedly", unknown: ""}[kind];
    return make("div", {class: `property ${kind}`},
        make("p", {class: "verdict"}, make("span", {class: "mark", "aria-hidden": "true"}, mark), " ", make("strong", {}, property.name), " ", make("span", {class: "outcome"}, words)),
        property.text ? make("p", {}, property.text) : "",
        property.claim ? make("code", {}, property.claim) : "",
        property.reason ? make("p", {class: "remark"}, ...prose(property.reason)) : "",
        ...property.notes.map((note) => make("p", {class: "remark"}, ...prose(note))),
        report && property.has_trace && property.verdict === "violated" ? make("p", {}, make("a", {href: `${report}#${encodeURIComponent(property.name)}`, target: "_blank", rel: "noopener"}, "Show the counterexample")) : "");
}

const titles = {loop: (name) => `Closed loop ${name}`, chart: (name) => `Chart ${name}: steps that can be reached`, program: (name) => `Program ${name}`};

const progress = {waiting: "Waiting.", refused: "This model cannot be checked."};

const reportAddress = (model) => `/report?token=${token}&${model.kind === "loop" ? "loop" : "chart"}=${encodeURIComponent(model.name)}`;

// Returns the element of a model. If `report` is true, the element contains a link to the report of the model.
function modelElement(model, report) {
    const running = model.state === "running" ? `Being checked${model.progress ? `: ${model.progress}` : ""} \u2026` : progress[model.state] ?? "";
    return make("div", {class: `model ${model.state}`},
        make("h3", {}, titles[model.kind](model.name)),
        running ? make("p", {class: "remark"}, running) : "",
        report && model.state === "done" ? make("p", {}, make("a", {href: reportAddress(model), target: "_blank", rel: "noopener"}, "Complete report with trace player")) : "",
        ...model.errors.map((error) => make("p", {class: "problem"}, `\u2717 ${error.message} [${error.code}]`)),
        model.state === "done" && model.kind === "loop" && !model.properties.some((property) => property.declared) ? make("p", {class: "empty"}, "No properties are declared. Add one to the closed loop, for example ", make("code", {}, "property NAME: never A && B;")) : "",
        ...[...model.properties].sort((a, b) => rank(a) - rank(b)).map((property) => propertyElement(property, report && model.state === "done" ? reportAddress(model) : "")));
}

// Returns the elements of all models, or a sentence if there are none.
export function modelsElements(state, report) {
    if (state.models.length > 0) return state.models.map((model) => modelElement(model, report));
    return [make("p", {class: "empty"}, "There is nothing to check. Declare a chart, and a ", make("code", {}, "closed_loop"), " with its plant and its properties.")];
}

// Shows the overall result at the top of the page.
export function showStatus(kind, words) {
    const status = document.getElementById("status");
    status.className = kind;
    status.textContent = `${{ok: "\u2713 ", bad: "\u2717 ", unknown: "? "}[kind] ?? ""}${words}`;
}

// Returns the class and the text of the overall result. The result is positive only if every model of the file was
// checked, and all verdicts are as expected.
export function verdictWords(state) {
    const are = (count) => count === 1 ? "is" : "are";
    const properties = state.models.flatMap((model) => model.properties);
    const bad = properties.filter((property) => property.verdict !== "unknown" && !property.as_expected).length;
    const open = properties.filter((property) => property.verdict === "unknown").length;
    const faults = [], of = `of ${properties.length} ${properties.length === 1 ? "verdict" : "verdicts"}`;
    if (state.models.some((model) => model.state === "running" || model.state === "waiting")) return ["", "being checked"];
    if (state.errors > 0 || state.models.some((model) => model.state === "refused")) faults.push("a part of the file cannot be checked");
    if (state.models.some((model) => model.errors.length > 0)) faults.push("model error");
    if (bad > 0) faults.push(`${bad} ${of} ${are(bad)} not as expected`);
    const kind = faults.length > 0 ? "bad" : open > 0 ? "unknown" : "ok";
    if (open > 0) faults.push(`${open} ${of} ${are(open)} undecided`);
    if (faults.length > 0) return [kind, faults.join("; ")];
    if (properties.length === 0) return ["", "nothing to check"];
    return ["ok", properties.length === 1 ? "the verdict is as expected" : `all ${properties.length} verdicts are as expected`];
}
