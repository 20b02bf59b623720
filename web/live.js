// SPDX-License-Identifier: MIT
// The page of `serve`: requests the newest results for the file from the server and shows them. The contents of a file
// are inserted as text and are never interpreted as markup.
import {make} from "./dom.js";
import {drawingElement, lightDrawings} from "./drawing.js";
import {Find} from "./find.js";
import {ask} from "./server.js";
import {Simulator} from "./simulator.js";
import {modelsElements, showStatus, verdictWords} from "./verdicts.js";
import {Zoom} from "./zoom.js";

const by = (id) => document.getElementById(id);

// Returns the reason why a chart or program has no drawing.
function notDrawn(chart) {
    if (chart.steps === 0) return ["The program contains no Sequential Function Chart, so it has no drawing."];
    return ["The chart has more than 5,000 steps and is not drawn here. Use ", make("code", {}, "grafverif draw"), "."];
}

// Shows the drawings of the charts. Active steps, enabled transitions and cleared transitions are highlighted.
class Drawings {
    constructor(place) {
        Object.assign(this, {place, reading: null, lit: [], fired: [], marks: [], zooms: new Map()});
        this.find = new Find(place);
        this.find.element.hidden = true;
        place.closest("section").querySelector(".head").append(this.find.element);
    }

    async show(state) {
        if (!state.readable || state.reading === this.reading) return;
        this.reading = state.reading;
        const answer = await ask("/drawings");
        if (answer.reading !== this.reading || answer.drawings.length !== state.charts.length) return;  // the file has changed again
        this.marks = (answer.marks ?? []).filter(Boolean);
        const figures = state.charts.map((chart, place) => make("figure", {},
            make("figcaption", {}, make("h3", {}, chart.name)),
            answer.drawings[place] === null ? make("p", {class: "empty"}, ...notDrawn(chart)) : this.zoomed(chart.name, answer.drawings[place])));
        if (figures.length === 0) figures.push(make("p", {class: "empty"}, "The file has no chart. Declare one by ", make("code", {}, "grafcet NAME { ... }"), "; this page then shows its drawing."));
        this.place.replaceChildren(...figures);
        this.find.element.hidden = !this.place.querySelector("svg.grafcet");
        this.find.search(false);
        this.light(this.lit, this.fired);
    }

    // Returns the drawing of a chart with the scale and the position of the former drawing.
    zoomed(name, text) {
        this.zooms.set(name, new Zoom(drawingElement(name, text), name, this.zooms.get(name)));
        return this.zooms.get(name).element;
    }

    light(lit, fired) {
        Object.assign(this, {lit, fired});
        lightDrawings(this.place, this.marks, lit, fired);
    }
}

// Returns the lines of diagnostics. Messages wrap; lines of the file with their markers keep their columns.
function diagnosticLines(text) {
    return text.split(/(?<=\n)/).map((line) => (line.startsWith(" ") ? line : make("span", {class: "message"}, line)));
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
        showStatus(kind, words);
        if (!state.readable && by("charts").childElementCount === 0) {
            by("charts").replaceChildren(make("p", {class: "empty"}, "The file has errors and cannot be drawn. Correct the errors above and save the file; this page then shows its charts."));
            by("models").replaceChildren(make("p", {class: "empty"}, "A file with errors is not checked."));
        }
        by("diagnostics").hidden = state.diagnostics === "";
        by("diagnostics").classList.toggle("errors", state.errors > 0);
        by("diagnostics-title").textContent = state.errors > 0 ? "Errors" : "Warnings";
        if (by("diagnostics-text").textContent !== state.diagnostics) by("diagnostics-text").replaceChildren(...diagnosticLines(state.diagnostics));
        this.drawings.show(state).catch((error) => this.lose(error));
        if (state.readable) by("models").replaceChildren(...modelsElements(state, true));
        this.age(!state.readable);
        this.simulator.take(state);
    }

    // If `old` is true, marks the displayed drawings and verdicts as outdated.
    age(old) {
        for (const place of [by("charts"), by("models")]) {
            place.classList.toggle("stale", old);
            place.closest("section").querySelector(".before").hidden = !old || place.children.length === 0 || place.querySelector(":scope > .empty") !== null;
        }
    }

    lose(error) {
        this.age(true);
        showStatus("bad", error.message);
    }

    // Requests new results in an endless loop. A hidden page sends no requests, because browsers limit the number of
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
