// SPDX-License-Identifier: MIT
// The page of `serve`: the newest state of the file, asked for again and again, and shown. Everything is built of text; what
// anybody wrote in a file is never read as markup, save the drawings, which the server made and the browser reads as SVG.
import {make} from "./dom.js";
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

// The drawings of the charts, in which steps are lit.
class Drawings {
    constructor(place) {
        this.place = place;
        this.drawn = "";
    }

    show(state) {
        this.place.classList.toggle("stale", !state.readable);
        if (!state.readable) return;
        const all = JSON.stringify(state.charts);
        if (all === this.drawn) return;
        this.drawn = all;
        this.place.replaceChildren(...state.charts.map((chart) => {
            const drawing = make("div", {class: "drawing", tabindex: 0, role: "region", "aria-label": `Drawing of ${chart.name}`});
            if (chart.svg) {
                const svg = new DOMParser().parseFromString(chart.svg, "image/svg+xml").documentElement;
                drawing.append(document.importNode(svg, true));
            }
            return make("figure", {style: "margin: 0"}, make("h3", {}, chart.name), chart.svg ? drawing : "");
        }));
        this.light(this.lit ?? [], this.fired ?? []);
    }

    light(lit, fired) {
        this.lit = lit;
        this.fired = fired;
        for (const element of this.place.querySelectorAll(".lit, .fired")) element.classList.remove("lit", "fired");
        for (const id of lit) document.getElementById(id)?.classList.add("lit");
        for (const id of fired) document.getElementById(id)?.classList.add("fired");
    }
}

const outcomes = {holds: "holds", violated: "is violated", unknown: "is not known"};

function propertyElement(property) {
    const kind = property.as_expected ? "good" : property.verdict === "unknown" ? "unknown" : "bad";
    const mark = {good: "\u2713", bad: "\u2717", unknown: "?"}[kind];
    const expected = property.expected === "violated" ? ", as is expected of it" : "";
    const words = outcomes[property.verdict] + (property.as_expected ? expected : property.verdict === "unknown" ? "" : ", against expectation");
    return make("div", {class: `property ${kind}`},
        make("span", {class: "outcome"}, `${mark} ${property.name} ${words}`),
        property.prose ? make("p", {}, property.prose) : "",
        make("code", {}, property.text),
        property.reason ? make("p", {class: "remark"}, property.reason) : "",
        ...property.notes.map((note) => make("p", {class: "remark"}, note)));
}

const progress = {waiting: "Its turn comes.", refused: "It cannot be checked."};

function modelElement(model) {
    const running = model.state === "running" ? `Being checked${model.progress ? `: ${model.progress}` : ""} \u2026` : progress[model.state] ?? "";
    return make("div", {class: `model ${model.state}`},
        make("h3", {}, model.kind === "loop" ? `Closed loop ${model.name}` : `Chart ${model.name}: steps that can be reached`),
        running ? make("p", {class: "remark"}, running) : "",
        ...model.errors.map((error) => make("p", {class: "problem"}, `\u2717 ${error.message} [${error.code}]`)),
        ...model.properties.map(propertyElement));
}

function verdictWords(state) {
    const properties = state.models.flatMap((model) => model.properties);
    const broken = state.models.some((model) => model.errors.length > 0);
    if (state.models.some((model) => model.state === "running" || model.state === "waiting")) return ["", "being checked"];
    if (properties.length === 0 && !broken) return ["", "nothing to check"];
    const bad = properties.filter((property) => !property.as_expected).length;
    return bad > 0 || broken ? ["bad", `${bad} of ${properties.length} verdicts are not as expected`]
                             : ["good", properties.length === 1 ? "the verdict is as expected" : `all ${properties.length} verdicts are as expected`];
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
        by("file").textContent = state.file;
        const [kind, words] = state.readable ? verdictWords(state) : ["bad", "it has errors"];
        by("status").className = kind;
        by("status").textContent = `${{good: "\u2713 ", bad: "\u2717 "}[kind] ?? ""}${words}`;
        by("diagnostics").hidden = state.complaints === "";
        if (by("complaints").textContent !== state.complaints) by("complaints").textContent = state.complaints;
        this.drawings.show(state);
        if (state.readable) by("models").replaceChildren(...state.models.map(modelElement));
        by("models").classList.toggle("stale", !state.readable);
        this.simulator.take(state);
    }

    lose(error) {
        by("status").className = "bad";
        by("status").textContent = `\u2717 ${error instanceof TypeError ? "grafverif does not answer any more; start it again and open the address that it prints" : error.message}`;
    }

    // A page that nobody sees asks for nothing: browsers keep only a few connections to one place.
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
