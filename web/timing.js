// SPDX-License-Identifier: MIT
// The timing diagram. The diagram has a row for each signal and step that changes in the run, and a column for each
// stop of the player. A cursor marks the position of the player. Only visible columns are drawn; names remain visible
// during scrolling. The width of a column is not a duration, so that the events of one instant are distinguishable.
import {draw, make} from "./dom.js";

const column = 30, line = 24, top = 40, high = 5, low = 19;
const groups = [["input", "inputs"], ["output", "outputs"], ["internal", "internals"], ["plant", "plant"]];

export class Timing {
    // `moments` are the events of the columns. `loop` is the index of the first column that is repeated forever, or
    // null. `choose(k)` is called when the user clicks column k.
    constructor(run, moments, loop, choose) {
        this.run = run;
        this.moments = moments;
        this.loop = loop;
        this.current = 0;
        this.tracks = tracksOf(run);
        const idle = run.trace.signals.filter((s, k) => s.role !== "image" && !run.signals[k].changes()).map((s) => s.name);
        this.height = top + this.tracks.length * line + 6;
        this.names = make("div", {class: "timing-names"}, ...this.tracks.map((track) =>
            make("div", {class: track.heading ? "track-heading" : "track", title: track.name}, track.name)));
        this.svg = draw("svg", {height: this.height, "aria-hidden": "true"});
        this.space = make("div", {class: "timing-space"});
        this.space.style.width = `${moments.length * column}px`;
        this.space.style.height = `${this.height}px`;
        this.space.append(this.svg);
        this.view = make("div", {class: "timing-view", tabindex: 0, role: "img",
                                 "aria-label": "Timing diagram; the table of signals has the same data",
                                 onscroll: () => this.draw(),
                                 onclick: (event) => this.click(event, choose)}, this.space);
        this.element = make("div", {class: "timing"},
                            make("div", {class: "timing-frame"}, this.names, this.view),
                            make("p", {class: "remark"}, "Columns are events; a time is shown only if it differs from the previous time.",
                                 idle.length === 0 ? "" : ` Constant: ${idle.join(", ")}.`));
        new ResizeObserver(() => this.draw()).observe(this.view);
    }

    click(event, choose) {
        const x = event.clientX - this.view.getBoundingClientRect().left + this.view.scrollLeft;
        choose(Math.min(Math.max(Math.floor(x / column), 0), this.moments.length - 1));
    }

    show(k) {
        this.current = k;
        const x = k * column, {scrollLeft, clientWidth} = this.view;
        if (clientWidth > 0 && (x < scrollLeft + column || x > scrollLeft + clientWidth - 2 * column))
            this.view.scrollLeft = x - clientWidth / 2;
        this.draw();
    }

    draw() {
        const {scrollLeft, clientWidth} = this.view;
        this.first = Math.max(0, Math.floor(scrollLeft / column) - 2);
        this.end = Math.min(this.moments.length, Math.ceil((scrollLeft + clientWidth) / column) + 2);
        this.svg.setAttribute("width", Math.max(this.end - this.first, 1) * column);
        this.svg.style.left = `${this.first * column}px`;
        const parts = [...this.background(), ...this.axis()];
        this.tracks.forEach((track, k) => { if (!track.heading) parts.push(...this.track(track, top + k * line)); });
        this.svg.replaceChildren(...parts);
    }
    x(k) { return (k - this.first) * column; }

    background() {
        const parts = [], bottom = this.height;
        if (this.loop !== null && this.loop < this.end)
            parts.push(draw("rect", {class: "lasso", x: this.x(Math.max(this.loop, this.first)), y: 0,
                                     width: this.x(this.moments.length) - this.x(Math.max(this.loop, this.first)), height: bottom}),
                       draw("text", {class: "axis", x: this.x(Math.max(this.loop, this.first)) + 4, y: 11}, "repeated forever"));
        if (this.current >= this.first && this.current < this.end)
            parts.push(draw("rect", {class: "cursor", x: this.x(this.current), y: 12, width: column, height: bottom - 12}));
        return parts;
    }

    axis() {
        const parts = [];
        let free = -1;
        for (let k = this.first; k < this.end; ++k) {
            const time = this.run.times[this.moments[k]];
            if (k > 0 && time === this.run.times[this.moments[k - 1]]) continue;
            parts.push(draw("line", {class: "rule", x1: this.x(k), x2: this.x(k), y1: 16, y2: this.height}));
            const text = this.run.timeText(this.moments[k]);
            if (this.x(k) < free) continue;
            parts.push(draw("text", {class: "axis", x: this.x(k) + 3, y: 28}, text));
            free = this.x(k) + 8 + text.length * 7;
        }
        return parts;
    }

    track(track, y) {
        const parts = [];
        for (let begin = this.first; begin < this.end;) {
            const value = track.value(this.moments[begin]);
            let end = begin + 1;
            while (end < this.end && track.value(this.moments[end]) === value) ++end;
            const from = this.x(begin), to = this.x(end);
            if (!track.boolean) parts.push(...box(from, to, y, value, track.kind));
            else {
                if (value) parts.push(draw("rect", {class: `fill ${track.kind}`, x: from, y: y + high, width: to - from, height: low - high}));
                const start = begin > this.first ? `M${from} ${y + (value ? low : high)}V` : `M${from} `;
                parts.push(draw("path", {class: `wave ${track.kind}`, d: `${start}${y + (value ? high : low)}H${to}`}));
            }
            begin = end;
        }
        return parts;
    }
}

function box(from, to, y, value, kind) {
    const middle = y + (high + low) / 2;
    return [draw("path", {class: `wave fill ${kind}`, d: `M${from} ${middle}L${from + 4} ${y + high}H${to - 4}L${to} ${middle}` +
                                                        `L${to - 4} ${y + low}H${from + 4}Z`}),
            draw("text", {class: "axis value", x: (from + to) / 2, y: y + low - 3}, `${value}`)];
}

// Returns the rows of the diagram: the signals and steps that change in the run, in groups with headings.
function tracksOf(run) {
    const tracks = [];
    const add = (heading, found) => { if (found.length > 0) tracks.push({heading: true, name: heading}, ...found); };
    for (const [role, heading] of groups)
        add(heading, run.trace.signals.flatMap((signal, k) => signal.role !== role || !run.signals[k].changes() ? []
            : [{name: signal.name, kind: heading, boolean: !signal.range, value: (m) => run.value(k, m)}]));
    add("steps", run.trace.steps.flatMap((step, k) => !run.steps[k].changes() && !run.isActive(k, 0) ? []
        : [{name: step.short_name, kind: "steps", boolean: true, value: (m) => Number(run.isActive(k, m))}]));
    return tracks;
}
