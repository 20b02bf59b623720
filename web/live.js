// SPDX-License-Identifier: MIT
// The page of `serve`: requests the newest results for the file from the server and shows them. The contents of a file
// are inserted as text and are never interpreted as markup. Only the drawings are markup: the server generates them,
// and the browser parses them as SVG.
import {make, prose} from "./dom.js";
import {follow, lightStep, lightTransition} from "./marks.js";
import {Simulator} from "./simulator.js";

const token = new URLSearchParams(location.search).get("token") ?? "";
const by = (id) => document.getElementById(id);

export async function ask(path, body) {
    const answer = await fetch(path, {
        method: body === undefined ? "GET" : "POST",
        body: body === undefined ? undefined : JSON.stringify(body),
        headers: {"X-Grafverif-Token": token},
        cache: "no-store",
    });
    if (!answer.ok) throw new Error((await answer.text()).trim());
    return answer.json();
}

// Shows the drawings of the charts. Active steps, enabled transitions and cleared transitions are highlighted.
class Drawings {
    constructor(place) {
        Object.assign(this, {place, reading: null, lit: [], fired: [], marks: []});
    }

    async show(state) {
        if (!state.readable || state.reading === this.reading) return;
        this.reading = state.reading;
        const answer = await ask("/drawings");
        if (answer.reading !== this.reading || answer.drawings.length !== state.charts.length) return;  // the file has changed again
        this.marks = (answer.marks ?? []).filter(Boolean);
        this.place.replaceChildren(...state.charts.map((chart, place) => make("figure", {},
            make("figcaption", {}, make("h3", {}, chart.name)),
            answer.drawings[place] === null ? make("p", {class: "remark"}, "The chart is too large to be drawn here.")
                                            : this.element(chart.name, answer.drawings[place]))));
        this.light(this.lit, this.fired);
    }

    element(name, text) {
        const svg = document.importNode(new DOMParser().parseFromString(text, "image/svg+xml").documentElement, true);
        svg.setAttribute("role", "img");
        svg.setAttribute("aria-label", `Chart ${name}; a dot marks active steps`);
        svg.removeAttribute("aria-labelledby");
        return make("div", {class: "drawing", tabindex: 0, role: "region", "aria-label": `Drawing of ${name}`}, svg);
    }

    light(lit, fired) {
        Object.assign(this, {lit, fired});
        const show = (name, ids, light) => {
            for (const each of this.place.querySelectorAll(`.${name}`)) light(each, false);
            for (const id of ids) light(document.getElementById(id), true);
        };
        show("step.active", lit, lightStep);
        show("cleared", fired, lightTransition);
        const active = new Set(lit);
        for (const {transitions, actions} of this.marks) {
            for (const {ids, from} of transitions)
                for (const id of ids)
                    document.getElementById(id)?.classList.toggle("enabled", lit.length > 0 && from.every((step) => active.has(step)));
            for (const {id, step} of actions) document.getElementById(id)?.classList.toggle("active", active.has(step));
        }
        for (const view of this.place.querySelectorAll(".drawing")) follow(view, [...view.querySelectorAll(".step.active")]);
    }
}

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

function modelElement(model) {
    const running = model.state === "running" ? `Being checked${model.progress ? `: ${model.progress}` : ""} \u2026` : progress[model.state] ?? "";
    return make("div", {class: `model ${model.state}`},
        make("h3", {}, model.kind === "loop" ? `Closed loop ${model.name}` : `Chart ${model.name}: steps that can be reached`),
        running ? make("p", {class: "remark"}, running) : "",
        model.state === "done" ? make("p", {}, make("a", {href: reportAddress(model), target: "_blank", rel: "noopener"}, "Complete report with trace player")) : "",
        ...model.errors.map((error) => make("p", {class: "problem"}, `\u2717 ${error.message} [${error.code}]`)),
        ...[...model.properties].sort((a, b) => rank(a) - rank(b)).map(propertyElement));
}

// Returns the class and the text of the overall result. The result is positive only if every model of the file was
// checked, and all verdicts are as expected.
function verdictWords(state) {
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

class Page {
    constructor() {
        this.known = 0;
        this.drawings = new Drawings(by("charts"));
        this.simulator = new Simulator(by("simulation"), (request) => ask("/simulate", request),
                                       (lit, fired) => this.drawings.light(lit, fired));
    }

    show(state) {
        document.title = `${state.file.split("/").pop()} \u2013 grafverif`;
        by("file").textContent = state.file.split("/").pop();
        by("file").title = state.file;
        const [kind, words] = state.readable ? verdictWords(state) : ["bad", "the file has errors"];
        by("status").className = kind;
        by("status").textContent = `${{good: "\u2713 ", bad: "\u2717 ", unknown: "? "}[kind] ?? ""}${words}`;
        by("diagnostics").hidden = state.diagnostics === "";
        by("diagnostics").classList.toggle("errors", state.errors > 0);
        by("diagnostics-title").textContent = state.errors > 0 ? "Errors" : "Warnings";
        if (by("diagnostics-text").textContent !== state.diagnostics) by("diagnostics-text").textContent = state.diagnostics;
        this.drawings.show(state).catch((error) => this.lose(error));
        if (state.readable) by("models").replaceChildren(...state.models.map(modelElement));
        this.age(!state.readable);
        this.simulator.take(state);
    }

    // If `old` is true, marks the displayed drawings and verdicts as outdated.
    age(old) {
        for (const place of [by("charts"), by("models")]) {
            place.classList.toggle("stale", old);
            place.previousElementSibling.hidden = !old || place.children.length === 0;
        }
    }

    lose(error) {
        this.age(true);
        by("status").className = "bad";
        by("status").textContent = `\u2717 ${error instanceof TypeError ? "grafverif does not respond; restart it and open the address that it prints" : error.message}`;
    }

    // Requests new results without end. A hidden page sends no requests, because browsers limit the number of
    // connections to one server.
    async run() {
        for (let pause = 0;;) {
            if (document.hidden) await new Promise((seen) => document.addEventListener("visibilitychange", seen, {once: true}));
            try {
                const state = await ask(`/state?after=${this.known}`);
                pause = 0;
                if (!state) continue;
                this.known = state.version;
                this.show(state);
            } catch (error) {
                this.lose(error);
                pause = Math.min(pause + 500, 5000);
                await new Promise((wait) => setTimeout(wait, pause));
                this.known = 0;
            }
        }
    }
}

window.page = new Page();
window.page.run();
