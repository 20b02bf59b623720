// SPDX-License-Identifier: MIT
// The page of `serve`: requests the newest results for the file from the server and shows them. The contents of a file
// are inserted as text and are never interpreted as markup.
import {make} from "./dom.js";
import {drawingElement, lightDrawings} from "./drawing.js";
import {ask} from "./server.js";
import {Simulator} from "./simulator.js";
import {modelElement, verdictWords} from "./verdicts.js";

const by = (id) => document.getElementById(id);

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
                                            : drawingElement(chart.name, answer.drawings[place]))));
        this.light(this.lit, this.fired);
    }

    light(lit, fired) {
        Object.assign(this, {lit, fired});
        lightDrawings(this.place, this.marks, lit, fired);
    }
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
        if (state.readable) by("models").replaceChildren(...state.models.map((model) => modelElement(model, true)));
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
