// SPDX-License-Identifier: MIT
// The simulator. The simulator stores a list of moves; each move is a line of a script for `grafverif simulate`. The
// server executes the moves from power-on and returns the state to show. To undo a move, the simulator removes it from
// the list. The address of the page contains the list.

import {make, prose} from "./dom.js";
import {linkButton} from "./link.js";

const seconds = (milliseconds) => `${milliseconds / 1000} s`;

export class Simulator {
    // `ask(request)` returns the response of the server. `light(steps, transitions)` highlights the elements with these
    // ids in the drawings.
    constructor(place, ask, light) {
        Object.assign(this, {place, ask, light, of: null, moves: [], undone: [], answer: null, cursor: null, asked: 0, answers: 0, seed: 1, pressed: false});
        this.build();
        this.follow();
        window.addEventListener("hashchange", () => { if (location.hash !== this.written) { this.follow(); this.play(); } });
    }

    // Permanent elements

    build() {
        const button = (words, press, title) => make("button", {type: "button", onclick: press, title}, words);
        this.select = make("select", {onchange: () => this.begin(this.select.value)});
        this.buttons = {
            restart: button("Restart", () => this.begin(this.of), "Restart from power-on"),
            back: button("Back", () => this.back(), "Undo the last move"),
            again: button("Again", () => this.again(), "Redo the move"),
            next: button("Next", () => this.move("wait"), "Let time pass until the next automatic or possible event"),
            wait: button("Wait", () => this.move(`wait ${this.time.value.trim()}`), "Let time pass"),
            random: button("Random", () => this.random(), "Random moves"),
            save: button("Save script", () => this.save(), "Script for `grafverif simulate --script`"),
        };
        this.time = make("input", {value: "1s", "aria-label": "Duration to wait", onkeydown: (event) => {
            if (event.key === "Enter") this.buttons.wait.click();
        }});
        this.count = make("input", {type: "number", min: 1, max: 1000, value: 20, "aria-label": "Number of random moves"});
        this.every = make("input", {type: "checkbox", onchange: () => this.setEvery(this.every.checked)});
        this.step = make("select", {"aria-label": "Step to force", onchange: () => this.offerForce()});
        this.forceButton = make("button", {type: "button", onclick: () =>
            this.move(`force ${this.step.value} ${this.isActive(this.step.value) ? "off" : "on"}`)}, "Activate");
        this.trial = make("p", {class: "warning", role: "status"});
        this.clock = make("p", {});
        this.problem = make("p", {class: "problem", role: "alert"});
        this.warning = make("p", {class: "warning", role: "status"});
        const {restart, back, again, next, wait, random, save} = this.buttons;
        this.controls = make("div", {},
            make("div", {class: "row"}, make("label", {}, "Simulate ", this.select), restart, back, again, save, linkButton(() => location.href)),
            make("div", {class: "row"}, next, wait, this.time, random, this.count),
            make("details", {class: "force"}, make("summary", {}, "Force a step (what-if run)"),
                make("div", {class: "remark"}, "The simulation continues as a what-if run, which is not a run of the model. Forcing does not execute stored actions."),
                make("div", {class: "row"}, make("label", {}, "Step ", this.step), this.forceButton)),
            make("label", {class: "check", title: "In a closed loop, let the user choose every edge, including the phases of the PLC cycle"}, this.every, " every evolution"));
        this.panel = make("div", {});
        this.rows = make("tbody", {});
        this.table = make("div", {class: "trace", tabindex: 0, role: "region", "aria-label": "History; select a row with the arrow keys",
                                  onkeydown: (event) => this.key(event)},
            make("table", {},
                make("thead", {}, make("tr", {}, ...["time", "event", "cleared", "situation", "outputs"].map((title) => make("th", {scope: "col"}, title)))),
                this.rows));
        this.empty = make("p", {class: "empty", hidden: true});
        this.parts = make("div", {}, this.controls, this.clock, this.problem, this.trial, this.warning, this.panel, make("h3", {}, "History"), this.table);
        this.place.replaceChildren(this.parts, this.empty);
    }

    // Updates the list of models, and executes the moves again after a change of the file.
    take(state) {
        const known = JSON.stringify([state.readable, state.diagnostics, state.charts.map((chart) => chart.name), state.models.map((model) => model.name)]);
        const first = this.seen === undefined;
        if (state.readable) this.offer(state);
        this.empty.hidden = this.of !== null;
        this.parts.hidden = this.of === null;
        this.empty.textContent = state.readable ? "There is nothing to simulate. Declare a chart, or a closed loop with a chart and its plant." : "The simulator starts as soon as the file has no errors.";
        // If the file is unchanged, the new state only contains more verdicts, and the simulation remains valid.
        if (!first && known === this.seen && !this.changed(state)) return;
        this.seen = known;
        this.play();
    }

    changed(state) {
        const fresh = state.reading !== this.reading;
        this.reading = state.reading;
        return fresh;
    }

    offer(state) {
        this.reading ??= state.reading;
        const all = [...state.models.filter((model) => model.kind === "loop" && model.state !== "refused").map((model) => [`loop:${model.name}`, `closed loop ${model.name}`]),
                     ...state.charts.filter((chart) => chart.runs).map((chart) => [`chart:${chart.name}`, `chart ${chart.name}, inputs free`])];
        if (JSON.stringify(all) !== this.offered) {
            this.offered = JSON.stringify(all);
            this.select.replaceChildren(...all.map(([value, words]) => make("option", {value}, words)));
        }
        // If the file contains no model that can be simulated, for example because of an error, the selected model and
        // its moves are preserved.
        if (all.length > 0 && !all.some(([value]) => value === this.of)) {
            this.of = all[0][0];
            this.moves = [];
            this.undone = [];
        }
        if (this.of !== null) this.select.value = this.of;
    }

    // Moves

    // If `on` is true, every edge is a choice of the user. For a closed loop, this setting changes the possible moves,
    // so the list of moves is cleared.
    setEvery(on) {
        this.every.checked = on;
        this.set(this.of?.startsWith("loop:") ? [] : this.moves);
    }

    begin(of) {
        this.of = of;
        this.set([]);
    }

    set(moves, undone = []) {
        this.moves = moves;
        this.undone = undone;
        this.play();
    }

    move(line) {
        this.pressed = true;
        this.set([...this.moves, line]);
    }

    back() { if (this.moves.length > 0) this.set(this.moves.slice(0, -1), [this.moves.at(-1), ...this.undone]); }
    again() { if (this.undone.length > 0) this.set([...this.moves, this.undone[0]], this.undone.slice(1)); }
    random() {
        this.seed = Math.floor(Math.random() * 2 ** 31);
        this.play(Math.max(1, Math.min(1000, Number(this.count.value) || 1)));
    }

    async play(random = 0) {
        if (this.of === null) return;
        const [kind, name] = [this.of.slice(0, this.of.indexOf(":")), this.of.slice(this.of.indexOf(":") + 1)];
        const turn = ++this.asked, wanted = this.moves, pressed = this.pressed, everything = this.every.checked;
        let answer = null;
        this.pressed = false;
        try {
            answer = await this.ask({[kind]: name, moves: this.moves, random, seed: this.seed, everything});
            const {problem, moves} = answer;
            // If the last move failed, executes the list without this move.
            if (problem && moves.length > 0) answer = {...await this.ask({[kind]: name, moves: moves.slice(0, -1), everything}), problem};
        } catch (error) {
            answer = {error: error.message};
        }
        if (turn !== this.asked) return;  // the response is ignored, because a newer request was sent
        if (answer.error) {
            this.problem.textContent = answer.error;
            return;
        }
        // If the file has changed and some moves are impossible, these moves remain available for redo. A new move of
        // the user that is invalid is discarded.
        this.undone = [...wanted.slice(answer.moves.length + (pressed ? 1 : 0)), ...this.undone];
        this.show(answer);
    }

    show(answer) {
        this.answer = answer;
        ++this.answers;
        this.moves = answer.moves;
        this.problem.replaceChildren(...prose(answer.problem));
        this.warning.textContent = answer.broken_constraints.map((text) => `These inputs violate the constraint ${text}.`).join(" ");
        this.trial.textContent = answer.trial ? "What-if run: a step was forced. The marked rows are not a run of the model and prove nothing about it." : "";
        this.cursor = answer.rows.length - 1;
        this.clock.textContent = `${seconds(answer.time)} since power-on, ${this.moves.length} ${this.moves.length === 1 ? "move" : "moves"}`;
        this.showSteps(answer.steps);
        this.showPanel(answer);
        this.showRows(answer);
        this.enable(answer);
        this.write();
    }

    enable(answer) {
        const {back, again, next, wait} = this.buttons;
        back.disabled = this.moves.length === 0;
        again.disabled = this.undone.length === 0;
        wait.disabled = !answer.wait.may;
        next.disabled = !answer.wait.may || (answer.wait.limit === null && answer.wait.change === null);
    }

    showSteps(steps) {
        const chosen = this.step.value;
        this.step.replaceChildren(...steps.map(({name, active}) => make("option", {value: name}, active ? `${name}, active` : name)));
        if (steps.some(({name}) => name === chosen)) this.step.value = chosen;
        this.offerForce();
    }
    isActive(name) { return this.answer.steps.some((step) => step.name === name && step.active); }
    offerForce() { this.forceButton.textContent = this.isActive(this.step.value) ? "Deactivate" : "Activate"; }

    showPanel(answer) {
        const held = document.activeElement?.dataset?.signal ?? document.activeElement?.dataset?.command;
        const of = (role) => answer.signals.filter((signal) => signal.role === role);
        const boolean = (signal) => typeof signal.value === "boolean";
        const input = (signal) => boolean(signal)
            ? make("button", {type: "button", "data-signal": signal.name, "aria-pressed": signal.value ? "true" : "false",
                              onclick: () => this.move(`${signal.name} = ${!signal.value}`)}, `${signal.name} ${signal.value ? "is true" : "is false"}`)
            : make("label", {}, `${signal.name} `, make("input", {type: "number", min: signal.low, max: signal.high, value: signal.value, "data-signal": signal.name,
                              onchange: (event) => this.move(`${signal.name} = ${event.target.value}`)}));
        const value = (signal) => make("li", {class: boolean(signal) ? (signal.value ? "on" : "off") : ""},
            boolean(signal) ? make("span", {}, signal.name) : `${signal.name} = ${signal.value}`,
            boolean(signal) ? make("span", {class: "remark"}, signal.value ? " true" : " false") : "");
        const group = (title, list, element) => list.length === 0 ? [] : [make("h3", {}, title), element];
        const inputs = (title, id, chosen) => {
            const list = of("input").filter(chosen);
            return group(title, list, make("div", {class: "row", id}, ...list.map(input)));
        };
        const values = (role) => make("ul", {class: "values"}, ...of(role).map(value));
        const choices = answer.choices.filter((choice) => choice.words !== choice.command);
        this.panel.replaceChildren(
            ...inputs("Operator inputs", "inputs", (signal) => signal.by === "environment"),
            ...inputs("Sensors", "sensors", (signal) => signal.by === "plant"),
            ...inputs("Inputs", "free-inputs", (signal) => !signal.by),
            ...group("The plant can", choices, make("div", {class: "row", id: "choices"}, ...choices.map((choice) =>
                make("button", {type: "button", "data-command": choice.command, onclick: () => this.move(choice.command)}, choice.words)))),
            ...group("Outputs", of("output"), values("output")),
            ...group("Internal variables", of("internal"), values("internal")),
            ...group("Of the plant", of("plant"), values("plant")));
        if (held) (this.panel.querySelector(`[data-signal="${CSS.escape(held)}"]`) ?? this.panel.querySelector(`[data-command="${CSS.escape(held)}"]`))?.focus();
    }

    // Rows of the run

    showRows(answer) {
        this.rows.replaceChildren(...answer.rows.map((row, place) => make("tr", {class: row.trial ? "trial" : null, onclick: () => this.point(place)},
            ...[row.trial ? `trial ${row.time}` : row.time, row.inputs && row.inputs !== "none" ? `${row.what}: ${row.inputs}` : row.what, row.cleared, row.situation, row.outputs].map((text) => make("td", {}, text)))));
        this.point(this.cursor);
        this.table.scrollTop = this.table.scrollHeight;
    }

    point(place) {
        if (place < 0 || place >= this.answer.rows.length) return;
        this.cursor = place;
        [...this.rows.children].forEach((row, at) => row.setAttribute("aria-selected", at === place ? "true" : "false"));
        const row = this.rows.children[place], head = this.table.querySelector("thead").offsetHeight;
        if (row.offsetTop < this.table.scrollTop + head) this.table.scrollTop = row.offsetTop - head;
        const under = row.offsetTop + row.offsetHeight - this.table.clientHeight;
        if (under > this.table.scrollTop) this.table.scrollTop = under;
        this.light(this.answer.rows[place].lit, this.answer.rows[place].fired);
    }

    key(event) {
        const to = {ArrowDown: this.cursor + 1, ArrowUp: this.cursor - 1, Home: 0, End: this.rows.children.length - 1}[event.key];
        if (to === undefined) return;
        event.preventDefault();
        this.point(to);
    }

    // Conversion of the session to an address and to a script

    write() {
        this.written = `#${this.every.checked ? "every" : "sim"}=${encodeURIComponent([this.of, ...this.moves].join("\n"))}`;
        history.replaceState(null, "", this.written);
    }

    follow() {
        const cut = location.hash.indexOf("="), kind = location.hash.slice(1, cut);
        if (kind !== "sim" && kind !== "every") return;
        try {
            [this.of, ...this.moves] = decodeURIComponent(location.hash.slice(cut + 1)).split("\n");
            this.every.checked = kind === "every";
            this.undone = [];
        } catch {
            this.problem.textContent = "The address is invalid.";
        }
    }

    script() {
        const trial = this.answer.trial ? "// What-if run: not a run of the model after the first `force`.\n" : "";
        return `// ${this.of}\n${trial}${this.moves.map((move) => `${move}\n`).join("")}`;
    }
    save() {
        const link = make("a", {href: URL.createObjectURL(new Blob([this.script()], {type: "text/plain"})), download: "simulation.txt"});
        link.click();
        URL.revokeObjectURL(link.href);
    }
}
