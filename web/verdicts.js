// SPDX-License-Identifier: MIT
// The verdicts of the models of a file.
import {make, prose} from "./dom.js";
import {token} from "./server.js";

const outcomes = {holds: "holds", violated: "is violated", unknown: "is unknown"};

const kindOf = (property) => property.verdict === "unknown" ? "unknown" : property.as_expected ? "good" : "bad";

// Returns the sort key of a property: unexpected verdicts come first, then unknown verdicts, then expected violations,
// then properties that hold as expected.
const rank = (property) => ({bad: 0, unknown: 1, good: property.verdict === "violated" ? 2 : 3}[kindOf(property)]);

function propertyElement(property) {
    const kind = kindOf(property);
    const mark = {good: "\u2713", bad: "\u2717", unknown: "?"}[kind];
    const expected = property.expected === "violated" ? ", as expected" : "";
    const words = outcomes[property.verdict] + (property.vacuous ? " vacuously" : "") +
                  {good: expected, bad: ", unexpectedly", unknown: ""}[kind];
    return make("div", {class: `property ${kind}`},
        make("span", {class: "outcome"}, `${mark} ${property.name} ${words}`),
        property.text ? make("p", {}, property.text) : "",
        property.claim ? make("code", {}, property.claim) : "",
        property.reason ? make("p", {class: "remark"}, ...prose(property.reason)) : "",
        ...property.notes.map((note) => make("p", {class: "remark"}, ...prose(note))));
}

const progress = {waiting: "Waiting.", refused: "This model cannot be checked."};

const reportAddress = (model) => `/report?token=${token}&${model.kind}=${encodeURIComponent(model.name)}`;

// If `report` is true, the element of a model contains a link to its report.
export function modelElement(model, report) {
    const running = model.state === "running" ? `Being checked${model.progress ? `: ${model.progress}` : ""} \u2026` : progress[model.state] ?? "";
    return make("div", {class: `model ${model.state}`},
        make("h3", {}, model.kind === "loop" ? `Closed loop ${model.name}` : `Chart ${model.name}: steps that can be reached`),
        running ? make("p", {class: "remark"}, running) : "",
        report && model.state === "done" ? make("p", {}, make("a", {href: reportAddress(model), target: "_blank", rel: "noopener"}, "Complete report with trace player")) : "",
        ...model.errors.map((error) => make("p", {class: "problem"}, `\u2717 ${error.message} [${error.code}]`)),
        ...[...model.properties].sort((a, b) => rank(a) - rank(b)).map(propertyElement));
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
    const kind = faults.length > 0 ? "bad" : open > 0 ? "unknown" : "good";
    if (open > 0) faults.push(`${open} ${of} ${are(open)} undecided`);
    if (faults.length > 0) return [kind, faults.join("; ")];
    if (properties.length === 0) return ["", "nothing to check"];
    return ["good", properties.length === 1 ? "the verdict is as expected" : `all ${properties.length} verdicts are as expected`];
}
