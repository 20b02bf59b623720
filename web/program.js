// SPDX-License-Identifier: MIT
// View of the PLC program of one controller at an event of a run: the lines of the program with the values that the
// last scan computed. Marks show the lines that this scan executed, and the active steps.
import {make} from "./dom.js";
import {RowList} from "./list.js";
import {History, lastAtMost} from "./run.js";

const lineHeight = 21;  // height of a line in pixels; must be equal to the height in page.css

export class ProgramView {
    constructor(chart, run, controller) {
        this.program = chart.program;
        this.run = run;
        this.controller = run.controllers[controller];
        this.lines = document.getElementById(this.program.listing).textContent.trimEnd().split("\n");
        this.moment = this.from = 0;
        this.readScans(run.data.scans[controller]);
        this.readLines();
        this.words = make("p", {class: "remark"});
        this.list = new RowList(`Lines of ${this.controller.name}`, this.lines.length, (k) => this.line(k),
                                (k) => this.list.show(k), {height: lineHeight, prefix: `line-${controller}`});
        this.element = make("section", {class: "panel program"}, make("h4", {}, `Program: ${this.controller.name}`),
                            this.words, ...this.pickers(), this.list.element);
        this.list.element.classList.add("lines");
    }

    readScans(scans) {
        this.histories = this.program.points.map(() => new History(null));
        this.scans = scans?.map(([moment]) => moment) ?? null;
        for (const [moment, changes] of scans ?? [])
            for (const [point, value, count = 1] of changes)
                this.histories[point].add(moment, value === null ? null : {value, count});
    }

    readLines() {
        const {code, points, instances, steps} = this.program;
        this.units = new Map(code);  // for each line that has values: its unit
        this.points = new Map();     // for each line: its points, in the order of display
        points.forEach(({line}, point) => this.points.set(line, [...this.points.get(line) ?? [], point]));
        // Results are displayed before the variables on which they depend, so that results remain visible in a narrow
        // panel.
        const late = (point) => (points[point].role === "read" ? 1 : 0);
        for (const list of this.points.values())
            list.sort((a, b) => late(a) - late(b) || points[a].order - points[b].order);
        this.steps = new Map();
        steps.forEach(({line, instance}, step) => this.steps.set(line, [...this.steps.get(line) ?? [], {step, instance}]));
        this.chosen = new Map();  // for each unit: the displayed instance
        this.used = new Map();    // for each unit: the instances that a run of the page executes
        for (const {instance} of points) {
            if (instance === null) continue;
            const {unit} = instances[instance];
            this.used.set(unit, (this.used.get(unit) ?? new Set()).add(instance));
        }
        for (const [unit, all] of this.used) this.chosen.set(unit, Math.min(...all));
    }

    // Returns, for each unit with several instances, a list box that selects the displayed instance.
    pickers() {
        const {units, instances} = this.program;
        return [...this.used].filter(([, all]) => all.size > 1).map(([unit, all]) => {
            const pick = make("select", {onchange: () => {
                this.chosen.set(unit, Number(pick.value));
                this.list.draw();
            }}, ...[...all].sort((a, b) => a - b).map((k) => make("option", {value: k}, instances[k].name)));
            return make("label", {class: "pick"}, `instance of ${units[unit]} `, pick);
        });
    }

    isChosen(instance) {
        return instance === null || this.chosen.get(this.program.instances[instance].unit) === instance;
    }

    line(k) {
        const points = (this.points.get(k) ?? []).filter((point) => this.isChosen(this.program.points[point].instance));
        const evaluated = points.filter((point) => this.histories[point].value(this.moment) !== null);
        const active = (this.steps.get(k) ?? []).some(({step, instance}) =>
            this.isChosen(instance) && this.run.isActive(this.controller.steps[step], this.moment));
        const skipped = this.units.has(k) && evaluated.length === 0 && this.scans !== null;
        const [mark, what] = active ? ["■", "active step"] : evaluated.length > 0 ? ["●", "executed"] : ["", ""];
        const texts = new Map(evaluated.map((point) => this.value(point)).map((each) => [each.textContent, each]));
        const values = [...texts.values()];  // if a line reads a variable twice, its value is shown once
        return [make("span", {class: "mark", title: what}, mark), make("span", {class: "number"}, `${k + 1}`),
                make("code", {class: active ? "code active" : skipped ? "code skipped" : "code", title: this.lines[k]}, this.lines[k]),
                make("span", {class: "values", title: values.map((each) => each.textContent).join("  ")}, ...values)];
    }

    value(point) {
        const {role, name, format} = this.program.points[point], history = this.histories[point];
        const {value, count} = history.value(this.moment), fresh = history.since(this.moment) >= this.from;
        const sign = {result: ":=", condition: "→"}[role];
        const text = role === "executed" ? "" : [name, sign, valueText(format, value)].filter(Boolean).join(" ");
        return make("span", {class: `${role}${fresh && role !== "executed" ? " changed" : ""}`}, text, count > 1 ? ` ×${count}` : "");
    }

    // Shows the state at the event `moment`. `from` is the first event of the current row.
    show(moment, from) {
        this.moment = moment;
        this.from = from;
        const scan = this.scans === null ? -1 : lastAtMost(this.scans, moment);
        this.words.textContent = this.scans === null ? "The values of the lines are omitted: page size limit."
            : scan < 0 ? "No scan has been executed."
            : `Values of the scan at ${this.run.timeText(this.scans[scan])}. ● executed, ■ active step.`;
        this.list.show(this.changedLine() ?? this.list.current);
    }

    // Returns the first line in which a value changed in the current row; null if there is none.
    changedLine() {
        const {points} = this.program;
        let first = null;
        this.histories.forEach((history, point) => {
            const {line, role, instance} = points[point];
            if (history.since(this.moment) < this.from || history.value(this.moment) === null) return;
            if (role === "executed" || !this.isChosen(instance)) return;
            if (first === null || line < first) first = line;
        });
        return first;
    }

    // Scrolls to the line with the condition of a transition.
    showTransition(place) {
        this.list.show(this.program.transitions[place]);
    }
}

function valueText(format, value) {
    if (format === "boolean") return value ? "TRUE" : "FALSE";
    if (format === "time") return value % 1000 === 0 ? `T#${value / 1000}s` : `T#${value}ms`;
    return format?.[value] ?? `${value}`;
}
