// SPDX-License-Identifier: MIT
// The player of one run. The player shows the drawn charts, the list of events, the values with their changes,
// explanations, and the timing diagram, all at the same event. Buttons, a slider, keys, and addresses (`#P16/23`)
// control the player.
import {ChartView} from "./chart.js";
import {Claims} from "./claims.js";
import {make} from "./dom.js";
import {InstanceView} from "./instance.js";
import {Find} from "./find.js";
import {RowList} from "./list.js";
import {ProgramView} from "./program.js";
import {Run} from "./run.js";
import {Timing} from "./timing.js";
import {decisiveMoment, whyProperty, whyTransition} from "./why.js";

const keys = {
    ArrowRight: (player) => player.step(1),
    ArrowLeft: (player) => player.step(-1),
    Home: (player) => player.go(0),
    End: (player) => player.go(player.run.last),
    " ": (player) => player.play(),
    PageDown: (player) => player.step(10),
    PageUp: (player) => player.step(-10),
};

export class Player {
    // `moved(address)` is called with the address of the new position when the position of the player changes.
    constructor(page, data, moved) {
        this.page = page;
        this.run = new Run(data);
        this.moved = moved;
        this.property = data.property === null ? null : page.properties[data.property];
        this.claims = this.property ? new Claims(this.run, this.property) : null;
        this.decisive = this.claims && data.kind === "counterexample" ? decisiveMoment(this.claims) : null;
        this.causeRows = new Set((this.run.trace.causes?.values ?? []).map(({from}) => this.run.shown.find(
            (index) => this.run.rowMoments[index] >= from) ?? this.run.shown.at(-1)));
        this.moment = 0;
        this.chosen = null;
        this.everyMove = false;
        this.timer = null;
        this.build();
        this.restep();
    }

    chartOf(controller) { return this.page.charts[this.run.data.charts[controller]]; }
    isProgram(controller) { return this.chartOf(controller).program !== undefined; }
    // Returns the transitions of a controller whose conditions the player explains. For a program, the result is empty,
    // because its conditions are lines of the program.
    transitionsOf(controller) { return this.isProgram(controller) ? [] : this.chartOf(controller).transitions; }

    build() {
        this.programs = new Map();
        this.run.controllers.forEach((_, controller) => {
            if (this.isProgram(controller)) this.programs.set(controller, new ProgramView(this.chartOf(controller), this.run, controller));
        });
        this.views = this.run.controllers.map((_, controller) =>
            new ChartView(this.chartOf(controller), this.run, controller, (place) => this.choose(controller, place)));
        const drawn = this.views.filter((_, controller) => !this.isProgram(controller) || this.chartOf(controller).steps.length > 0);
        this.caption = make("p", {class: "caption", role: "status", "aria-live": "polite"});
        this.why = make("div", {class: "why"});
        this.claim = make("div", {class: "why"});
        this.signals = make("div", {class: "signals"});
        this.instance = new InstanceView(this.page.plant, this.run);
        this.filter = make("input", {type: "search", placeholder: "filter", "aria-label": "Show signals whose name contains",
                                     oninput: () => this.showSignals()});
        this.changedOnly = make("input", {type: "checkbox", onchange: () => this.showSignals()});
        this.rows = new RowList("Rows of the trace", this.run.shown.length, (k) => this.row(k),
                                (k) => this.go(this.run.rowMoments[this.run.shown[k]]));
        this.timingPlace = make("div", {});
        const charts = make("div", {class: "charts"}, ...drawn.map((view) => view.element),
            drawn.length === 0 ? "" : make("p", {class: "remark"},
                "Yellow: active steps and actions. Blue: enabled transitions. Red with a triangle: cleared transitions."),
            ...[...this.programs.values()].map((view) => view.element));
        // Controls that the page shows next to the list of runs.
        this.tools = make("div", {class: "tools"}, drawn.length === 0 ? "" : new Find(charts).element, this.everyMoveBox());
        this.element = make("div", {class: "player", tabindex: -1, onkeydown: (event) => this.key(event)},
            this.controls(), this.caption,
            make("div", {class: "stage"}, charts,
                make("div", {class: "side"},
                    panel("Event", this.rows.element),
                    this.property?.operands.length > 0 ? panel(`Why: ${this.property.name}`, this.claim) : "",
                    panel("Inputs, outputs, variables, plant",
                        make("div", {class: "filters"}, this.filter, make("label", {}, this.changedOnly, " only changed values")),
                        this.signals),
                    this.programs.size === this.run.controllers.length ? ""
                        : panel("Why: a transition", make("label", {class: "pick"}, "transition ", this.picker()), this.why),
                    this.instance.element ? panel("Plant automaton", this.instance.element) : ""),
                make("section", {class: "panel timing-panel"}, make("h4", {}, "Timing diagram"), this.timingPlace)));
    }

    controls() {
        const button = (label, text, action, key) => make("button", {type: "button", "aria-label": label,
            title: key ? `${label} (${key})` : label, onclick: action}, text);
        this.playButton = button("Play", "play", () => this.play(), "space");
        this.slider = make("input", {type: "range", min: 0, step: 1, "aria-label": "Position in the trace",
                                     oninput: () => this.go(this.stops[Number(this.slider.value)])});
        this.place = make("output", {class: "place"});
        const loop = this.run.loopMoment();
        return make("div", {class: "controls", role: "toolbar", "aria-label": "Player"},
            button("To the start", "|◀", () => this.go(0), "Home"),
            button("Back", "◀", () => this.step(-1), "left"),
            this.playButton,
            button("Forward", "▶", () => this.step(1), "right"),
            button("To the end", "▶|", () => this.go(this.run.last), "End"),
            loop === null ? "" : button("To the start of the loop", "↻ loop", () => this.go(loop)),
            this.decisive === null ? "" : button("Jump to the violation", "! jump to violation", () => this.go(this.decisive)),
            this.slider, this.place);
    }

    everyMoveBox() {
        const moves = make("input", {type: "checkbox", onchange: () => { this.everyMove = moves.checked; this.restep(); }});
        return make("label", {title: "Show each phase of a PLC cycle and each evolution"}, moves, " every move");
    }

    picker() {
        this.pick = make("select", {"aria-label": "Transition", onchange: () => {
            const [controller, place] = this.pick.value.split(" ").map(Number);
            this.choose(controller, place);
        }}, make("option", {value: ""}, "enabled and cleared transitions"));
        this.run.controllers.forEach((_, controller) => this.transitionsOf(controller).forEach((transition, place) =>
            this.pick.append(make("option", {value: `${controller} ${place}`}, this.nameOf(controller, transition)))));
        return this.pick;
    }

    nameOf(controller, transition) {
        return this.run.controllers.length > 1 ? `${this.run.controllers[controller].name}: ${transition.name}` : transition.name;
    }

    key(event) {
        const plain = !event.altKey && !event.ctrlKey && !event.metaKey && !event.shiftKey;
        const typing = event.target.closest("input:not([type=range]), select, summary") ||
                       (event.key === " " && event.target.closest("button"));
        const action = keys[event.key];
        if (!plain || typing || !action) return;
        event.preventDefault();
        action(this);
    }

    // Computes the events at which the player stops: the last event of each displayed row or, if every move is shown,
    // all events.
    restep() {
        this.stops = this.everyMove || this.run.shown.length === 0 ? this.run.times.map((_, m) => m)
            : this.run.shown.map((row) => this.run.rowMoments[row]);
        const loop = this.run.loopMoment();
        const loopStop = loop === null ? null : Math.max(this.stops.findIndex((m) => m >= loop), 0);
        this.slider.max = this.stops.length - 1;
        this.timing = new Timing(this.run, this.stops, loopStop, (k) => this.go(this.stops[k]));
        this.timingPlace.replaceChildren(this.timing.element);
        this.go(this.moment);
    }

    // Returns the index of the last stop at or before the current event.
    stop() {
        let low = 0, high = this.stops.length;
        while (low < high) {
            const middle = (low + high) >> 1;
            if (this.stops[middle] <= this.moment) low = middle + 1;
            else high = middle;
        }
        return Math.max(low - 1, 0);
    }

    step(by) {
        const stop = this.stop(), between = by < 0 && this.stops[stop] < this.moment ? 1 : 0;
        this.go(this.stops[Math.min(Math.max(stop + by + between, 0), this.stops.length - 1)]);
    }

    play() {
        if (this.timer !== null) return this.pause();
        if (this.moment >= this.stops[this.stops.length - 1]) this.go(0);
        this.playButton.textContent = "pause";
        this.playButton.setAttribute("aria-label", "Pause");
        this.timer = setInterval(() => this.tickOn(), 700);
    }
    tickOn() {
        if (!this.element.isConnected) return this.pause();
        const last = this.moment >= this.stops[this.stops.length - 1], loop = this.run.loopMoment();
        if (last && loop !== null && loop < this.run.last) this.go(loop);
        else if (last) this.pause();
        else this.step(1);
    }
    pause() {
        clearInterval(this.timer);
        this.timer = null;
        this.playButton.textContent = "play";
        this.playButton.setAttribute("aria-label", "Play");
    }

    choose(controller, place) {
        if (this.programs.has(controller)) return this.programs.get(controller).showTransition(place);
        this.chosen = Number.isInteger(place) ? {controller, place} : null;
        this.pick.value = this.chosen ? `${controller} ${place}` : "";
        this.show();
    }

    go(moment) {
        this.moment = Math.min(Math.max(moment ?? 0, 0), this.run.last);
        this.show();
        this.moved(this.run.address(this.moment));
    }

    // Returns the range of events from the event after the previous stop to the current event.
    range() {
        const stop = this.stop();
        const begin = this.stops[stop] < this.moment ? this.stops[stop] + 1 : stop === 0 ? 0 : this.stops[stop - 1] + 1;
        return {from: Math.min(begin, this.moment), to: this.moment};
    }

    // Returns the index of the current row in the list of displayed rows.
    shownRow() {
        const row = this.run.rowOf(this.moment);
        return Math.max(this.run.shown.findLastIndex((shown) => shown <= row), 0);
    }

    show() {
        const {from, to} = this.range(), stop = this.stop();
        this.clearedNow = this.run.cleared(from, to);
        this.views.forEach((view, controller) => {
            view.show(this.moment, this.clearedNow, this.chosen?.controller === controller ? this.chosen.place : null);
            view.follow();
        });
        for (const view of this.programs.values()) view.show(to, from);
        this.slider.value = stop;
        const row = this.shownRow();
        const place = `${this.run.shown.length > 0 ? `row ${row + 1} of ${this.run.shown.length} · ` : ""}${this.run.timeText(this.moment)}`;
        this.slider.setAttribute("aria-valuetext", place);
        this.place.textContent = place;
        this.caption.textContent = this.words();
        this.rows.show(row);
        this.timing.show(stop);
        this.instance.show(this.moment);
        this.showSignals();
        this.showWhy();
    }

    words() {
        const row = this.run.rows[this.run.rowOf(this.moment)];
        const inside = row && row.moment !== this.moment;  // true if the current event is not the last event of its row
        const words = inside ? this.moveWords() : row ? [row.words, this.inputWords(), row.cleared && `cleared: ${row.cleared}`].filter(Boolean).join(" — ") : "";
        const loop = this.run.loopMoment(), ever = loop !== null && this.moment >= loop ? " Repeated forever from here." : "";
        const end = this.moment === this.run.last && this.run.data.end ? ` ${this.run.data.end}.` : "";
        const move = this.everyMove && !inside ? ` [${this.moveWords()}]` : "";
        return `${this.run.timeText(this.moment)}: ${words || "power on"}.${move}${ever}${end}`;
    }
    // Returns text about the inputs that change at the current stop, with their new values; empty at power-on.
    inputWords() {
        const {from} = this.range(), {run} = this;
        if (from === 0) return "";
        return run.trace.signals.flatMap(({name, role, range}, k) => {
            const now = run.value(k, this.moment);
            if (role !== "input" || now === run.value(k, from - 1)) return [];
            return [`${name} := ${range ? now : Boolean(now)}`];
        }).join(", ");
    }
    moveWords() {
        const moment = this.run.trace.moments[this.moment];
        const names = {begin: "a cycle begins", start: "power on", sample: "inputs are read", evolve: "an evolution clears no transition",
                       write: "outputs are written", "write-if-stable": "outputs are written if the situation is stable"};
        const {controllers, instances, transitions} = this.run.trace, several = controllers.length > 1;
        const acts = moment.acts.filter((act) => act.does.length > 0).map((act) => {
            const fired = act.does.includes("evolve") ? act.fired.map((each) => transitions[each].name).join(", ") : "";
            const does = act.does.map((each) => (each === "evolve" && fired ? `an evolution clears ${fired}` : names[each]));
            return `${several ? `${controllers[act.controller].name}: ` : ""}${does.join(", ")}`;
        });
        if (acts.length > 0) return acts.join("; ");
        if (moment.kind === "controller") return "the cycle continues";
        return moment.kind === "delay" ? "time passes" : [moment.kind, instances[moment.instance]?.name].filter(Boolean).join(" ");
    }

    row(k) {
        const index = this.run.shown[k], row = this.run.rows[index];
        const time = k > 0 && this.run.times[row.moment] === this.run.times[this.run.rowMoments[this.run.shown[k - 1]]]
            ? "" : this.run.timeText(row.moment);
        const loop = this.run.data.loop_from !== null && index >= this.run.data.loop_from;
        const cell = (name, text) => make("span", {class: name, title: text}, text);
        return [cell("loop-mark", `${loop ? "↻" : ""}${this.causeRows.has(index) ? "*" : ""}`), cell("when", time), cell("what", row.words),
                cell("fired", row.cleared ? `⇣ ${row.cleared}` : "")];
    }

    showSignals() {
        const {from} = this.range(), before = Math.max(from - 1, 0);
        const wanted = this.filter.value.toLowerCase(), changedOnly = this.changedOnly.checked;
        const body = make("tbody", {});
        const add = (kind, name, now, past, changed) => {
            if ((changedOnly && !changed) || !name.toLowerCase().includes(wanted)) return;
            body.append(make("tr", {class: changed ? "changed" : null},
                make("td", {class: "kind"}, kind), make("th", {scope: "row"}, name),
                make("td", {}, now, changed ? make("span", {class: "remark"}, ` was ${past}`) : "")));
        };
        const signals = this.run.trace.signals;
        for (const role of ["input", "output", "internal", "plant", "image"])
            signals.forEach((signal, k) => {
                if (signal.role !== role) return;
                const now = this.run.value(k, this.moment), past = this.run.value(k, before);
                add(role === "image" ? "to be written" : role, signal.name, this.run.signalText(k, now),
                    this.run.signalText(k, past), now !== past);
            });
        this.run.trace.instances.forEach((instance, k) => {
            if (!this.run.isShown(k)) return;
            const text = (m) => instance.locations[this.run.locations[k].value(m)] ?? "–";
            add(instance.kind, instance.name, text(this.moment), text(before), text(this.moment) !== text(before));
        });
        if (body.childElementCount === 0)
            body.append(make("tr", {}, make("td", {colspan: 3}, "no matching values")));
        this.signals.replaceChildren(make("table", {}, make("thead", {}, make("tr", {}, make("th", {scope: "col"}, "kind"),
            make("th", {scope: "col"}, "name"), make("th", {scope: "col"}, "value"))), body));
    }

    showWhy() {
        if (this.property?.operands.length > 0)
            this.claim.replaceChildren(whyProperty(this.claims, this.moment, this.decisive, (m) => this.go(m)));
        if (this.programs.size === this.run.controllers.length) return;
        const wanted = this.chosen ? [this.chosen] : this.interesting();
        this.why.replaceChildren(...wanted.map(({controller, place}) => {
            const id = this.run.controllers[controller].transitions[place];
            return whyTransition(this.run, this.chartOf(controller), controller, place, this.moment, this.clearedNow.get(id));
        }));
        if (wanted.length === 0) this.why.textContent = "No transition is enabled.";
    }
    // Returns the transitions to explain if the user has selected none: first the cleared transitions, then the enabled
    // transitions, at most 12.
    interesting() {
        const cleared = [], enabled = [];
        this.run.controllers.forEach((controller, number) => this.transitionsOf(number).forEach((transition, place) => {
            if (this.clearedNow.has(controller.transitions[place])) cleared.push({controller: number, place});
            else if (transition.from.every((step) => this.run.isActive(controller.steps[step], this.moment)))
                enabled.push({controller: number, place});
        }));
        return [...cleared, ...enabled].slice(0, 12);
    }
}

function panel(title, ...content) {
    return make("section", {class: "panel"}, make("h4", {}, title), ...content);
}
