// SPDX-License-Identifier: MIT
// Values of a term and its subterms at an event of a run, which explain why a transition was or was not cleared. A
// controller evaluates the inputs that it sampled last, not their current values; properties use current values
// (claims.js). A value that the run does not determine is `undefined`.
//
// The evaluation follows IEC 60848, as `run/reader.cpp` does. An edge is true in the evolution after the change. A
// condition `t1/v` (no t2) is true only if the output of its timer and v are true.

// Evaluates the terms of a chart with the values that the controller uses at the event `moment`.
export class Decision {
    // If `before` is true, the terms are evaluated before the evolution at the event `moment`; otherwise after this
    // event.
    constructor(run, chart, controller, moment, before) {
        this.run = run;
        this.chart = chart;
        this.controller = run.controllers[controller];
        this.number = controller;
        this.moment = moment;
        this.state = before ? Math.max(moment - 1, 0) : moment;
        this.read = run.sampled(controller, moment);
        this.earlier = run.evolved(controller, before ? moment - 1 : moment);
        this.known = new Map();
    }

    value(term) {
        if (!this.known.has(term)) this.known.set(term, valueOf(this, this.chart.terms[term]));
        return this.known.get(term);
    }

    leaf(node) {
        switch (node.op) {
        case "input": return this.input(node.place);
        case "internal": return this.run.value(this.controller.internals[node.place], this.state);
        case "output": return this.output(node);
        case "step": return Number(this.run.isActive(this.controller.steps[node.place], this.state));
        case "timed": return this.timed(node.place);
        case "rise":
        case "fall": return this.edge(node);
        }
        return undefined;
    }

    // Returns the value of an input. If the run contains no samples, as in traces of `analyse`, the evolutions read the
    // input values of their event.
    input(place) {
        return this.read ? this.read.act.inputs[place] : this.run.value(this.controller.inputs[place], this.moment);
    }

    edge(node) {
        const now = this.value(node.args[0]), before = this.previous()?.value(node.args[0]);
        if (now === undefined || before === undefined) return undefined;
        return Number(node.op === "rise" ? !before && now : before && !now);
    }
    previous() {
        if (this.earlier === null) return null;
        const {moment} = this.earlier, several = this.run.evolutionsIn(this.number, moment) > 1;
        if (several && this.earlier.act.fired.length > 0) return null;
        // If the event contains several evolutions, the last evolution changed nothing, so the values before and after
        // it are equal.
        this.past ??= new Decision(this.run, this.chart, this.number, moment, !several);
        return this.past;
    }

    timed(place) {
        const condition = this.chart.timed[place], timer = this.run.data.conditions[this.number][place];
        if (timer === undefined || (timer !== null && !this.read)) return undefined;
        const over = timer === null ? false : this.read.act.timers[timer] ?? false;
        if (timer !== null && condition.rise > 0 && (over || !this.run.trace.timed) && this.beganSinceRead(condition)) return undefined;
        if (condition.rise > 0 && condition.fall > 0) return Number(over);
        if (over === condition.fall > 0) return Number(over);
        return this.value(condition.watched);
    }

    // Returns true if the observed term is true, and either has become true since the timers were last sampled, or the
    // timers have not been sampled yet.
    beganSinceRead({watched}) {
        if (this.value(watched) !== 1) return false;
        const {act, moment} = this.read;
        return act.timers.length === 0 || new Decision(this.run, this.chart, this.number, moment, true).value(watched) !== 1;
    }

    // Returns the value of an output. For a continuous output, this is the value that its actions determine now, not
    // the value that was last written. For a stored output, it is the value in the output image of the PLC.
    output(node) {
        if (node.stored) {
            const image = this.controller.images[node.place];
            return this.run.value(image ?? this.controller.outputs[node.place], this.state);
        }
        let unknown = false;
        for (const action of node.actions) {
            if (!this.run.isActive(this.controller.steps[action.step], this.state)) continue;
            const value = action.timed ? undefined : this.value(action.condition);
            if (value) return 1;
            unknown ||= value === undefined;
        }
        return unknown ? undefined : 0;
    }

    // Returns a remark about a leaf, for example about a sampled input that has changed; empty if there is none.
    remark(node) {
        if (node.op === "input" && this.read) {
            const signal = this.controller.inputs[node.place], now = this.run.value(signal, this.state);
            if (now !== this.read.act.inputs[node.place])
                return `read at ${this.run.timeText(this.read.moment)}; it is now ${this.run.signalText(signal, now)}`;
        }
        if (node.op === "timed") return [this.reading(node), this.age(this.chart.timed[node.place])].filter(Boolean).join("; ");
        return "";
    }
    // Returns text about a change of the output of a timer since the controller sampled it; empty if there was no
    // change.
    reading(node) {
        const place = this.run.data.conditions[this.number][node.place];
        if (!this.read || place === undefined || place === null) return "";
        const holds = this.run.timerEnded(this.controller.timers[place], this.read.moment, this.state);
        const now = holds === null ? "" : `; it is now ${holds ? "true" : "false"}`;
        if (this.value(this.chart.terms.indexOf(node)) === undefined) return `not read since the timer started${now}`;
        return now && holds !== (this.read.act.timers[place] ?? false) ? `read at ${this.run.timeText(this.read.moment)}${now}` : "";
    }
    age(condition) {
        const watched = this.chart.terms[condition.watched];
        if (watched.op !== "step" || !this.run.trace.timed) return "";
        const history = this.run.steps[this.controller.steps[watched.place]];
        if (!history.value(this.state)) return `${watched.text} is not active`;
        const age = this.run.times[this.state] - this.run.times[history.since(this.state)];
        return `${watched.text} has been active for ${age / 1000} s`;
    }
}

const arithmetic = {
    plus: (a, b) => a + b,
    minus: (a, b) => a - b,
    times: (a, b) => a * b,
    divide: (a, b) => (b === 0 ? undefined : Math.trunc(a / b)),
    modulo: (a, b) => (b === 0 ? undefined : a % b),
    equal: (a, b) => Number(a === b),
    "not-equal": (a, b) => Number(a !== b),
    less: (a, b) => Number(a < b),
    "less-equal": (a, b) => Number(a <= b),
    greater: (a, b) => Number(a > b),
    "greater-equal": (a, b) => Number(a >= b),
};

// Computes the value of a term. `reader.leaf` returns the value of a leaf. `reader.value` returns the value of an
// operand, which it computes only once.
export function valueOf(reader, node) {
    if (node.op === "constant") return node.value;
    if (node.op === "rise" || node.op === "fall" || !node.args) return reader.leaf(node);
    if (node.op === "if") {
        const condition = reader.value(node.args[0]);
        return condition === undefined ? undefined : reader.value(node.args[condition ? 1 : 2]);
    }
    const values = node.args.map((each) => reader.value(each));
    if (node.op === "and") return decided(values, 0);
    if (node.op === "or") return decided(values, 1);
    if (values.includes(undefined)) return undefined;
    if (node.op === "not") return Number(!values[0]);
    return node.op === "negate" ? -values[0] : arithmetic[node.op]?.(...values);
}

// Returns the value of an `and` or `or`. One operand with the value `decisive` is sufficient for the result `decisive`,
// which is 0 for `and` and 1 for `or`.
function decided(values, decisive) {
    if (values.includes(decisive)) return decisive;
    return values.includes(undefined) ? undefined : 1 - decisive;
}
