// SPDX-License-Identifier: MIT
// A run, with functions that return the values at an event. For each signal, step and instance, the events at which its
// value changed are stored with the new values. The value at an event is found by bisection.
//
// A `moment` is the index of an event (docs/reference/trace-format.md). A row summarizes one or more events. One step
// of the player is a row or a single event.

export class History {
    constructor(first) {
        this.at = [0];
        this.values = [first];
    }
    add(moment, value) {
        if (value === this.values[this.values.length - 1]) return;
        if (moment === this.at[this.at.length - 1]) this.values[this.values.length - 1] = value;
        else {
            this.at.push(moment);
            this.values.push(value);
        }
    }
    place(moment) { return lastAtMost(this.at, moment); }
    value(moment) { return this.values[Math.max(this.place(moment), 0)]; }
    since(moment) { return this.at[Math.max(this.place(moment), 0)]; }
    changes() { return this.at.length > 1; }
}

// Returns the index of the last number in an increasing list that is not greater than `limit`; -1 if there is none.
export function lastAtMost(list, limit) {
    let low = 0, high = list.length;
    while (low < high) {
        const middle = (low + high) >> 1;
        if (list[middle] <= limit) low = middle + 1;
        else high = middle;
    }
    return low - 1;
}

export class Run {
    constructor(data) {
        this.data = data;
        this.name = data.name;
        this.trace = data.run;
        this.rows = data.rows;
        this.controllers = data.run.controllers;
        this.times = data.run.moments.map((moment) => moment.time);
        this.last = data.run.moments.length - 1;
        this.readMoments();
        this.shown = data.rows.flatMap((row, index) => (row.shown ? [index] : []));
        this.inside = new Set(data.inside);
        this.rowMoments = data.rows.map((row) => row.moment);
    }

    // Returns false for an observer, because an observer does not belong to the closed loop.
    isShown(instance) { return this.trace.instances[instance].kind !== "observer"; }

    readMoments() {
        const {steps, instances, moments} = this.trace;
        this.signals = this.trace.signals.map(() => null);
        this.steps = steps.map(() => new History(false));
        this.locations = instances.map((instance) => new History(this.data.initial[instance.name] ?? null));
        this.samples = this.controllers.map(() => []);
        this.evolutions = this.controllers.map(() => []);
        this.changed = moments.map(() => null);
        let active = new Set();
        moments.forEach((moment, m) => {
            for (const [signal, value] of moment.values)
                if (this.signals[signal]) this.signals[signal].add(m, value);
                else this.signals[signal] = new History(value);
            if (moment.situation) {
                const now = new Set(moment.situation);
                for (const step of active) if (!now.has(step)) this.steps[step].add(m, false);
                for (const step of now) this.steps[step].add(m, true);
                active = now;
            }
            if (moment.location !== null && moment.instance !== null)
                this.locations[moment.instance].add(m, moment.location);
            for (const act of moment.acts) this.readAct(act, m);
        });
    }

    readAct(act, moment) {
        if (act.inputs.length !== 0 || act.does.includes("sample")) this.samples[act.controller].push({moment, act});
        if (act.does.includes("evolve") || act.does.includes("start"))
            this.evolutions[act.controller].push({moment, act});
    }

    value(signal, moment) { return this.signals[signal].value(moment); }
    isActive(step, moment) { return this.steps[step].value(moment); }
    situation(moment) { return this.steps.flatMap((history, step) => (history.value(moment) ? [step] : [])); }

    // Returns the last sampling of inputs by the controller at or before the event `moment`; null if there is none.
    sampled(controller, moment) { return this.lastOf(this.samples[controller], moment); }
    evolved(controller, moment) { return this.lastOf(this.evolutions[controller], moment); }
    // Returns true if, after `moment`, the controller has sampled its inputs and has not yet made the evolution that
    // reads them.
    isToEvolve(controller, moment) {
        const read = this.sampled(controller, moment), made = this.evolved(controller, moment);
        return read !== null && (made === null || made.moment < read.moment);
    }
    lastOf(list, moment) {
        let low = 0, high = list.length;
        while (low < high) {
            const middle = (low + high) >> 1;
            if (list[middle].moment <= moment) low = middle + 1;
            else high = middle;
        }
        return low === 0 ? null : list[low - 1];
    }

    // Returns the output of the timer after its last change between the events `from` (exclusive) and `to`; null if the
    // output did not change.
    timerEnded(timer, from, to) {
        for (let m = to; m > from; --m)
            if (this.trace.moments[m].timer === timer) return this.trace.moments[m].timer_holds;
        return null;
    }

    // Returns the number of evolutions that the controller makes in the event `moment`.
    evolutionsIn(controller, moment) {
        return this.trace.moments[moment].acts.filter((act) => act.controller === controller && act.does.includes("evolve")).length;
    }

    // Returns the index of the row that contains the event `moment`: the first row that ends at or after this event.
    rowOf(moment) { return Math.min(lastAtMost(this.rowMoments, moment - 1) + 1, this.rows.length - 1); }
    // Returns the first event of the row.
    beginOf(row) { return row === 0 ? 0 : this.rowMoments[row - 1] + 1; }

    // Returns the transitions that are cleared in a range of events. For each of these transitions, also returns how
    // often it is cleared, and the last event at which it is cleared.
    cleared(from, to) {
        const found = new Map();
        for (let m = from; m <= to; ++m)
            for (const act of this.trace.moments[m].acts)
                if (act.does.includes("evolve"))
                    for (const transition of act.fired) found.set(transition, {last: m, times: (found.get(transition)?.times ?? 0) + 1});
        return found;
    }

    // Returns the text for the event `moment` in an address: `23` is the last event of row 23, and `23+2` is two events
    // later.
    address(moment) {
        const row = lastAtMost(this.rowMoments, moment);
        const beyond = row < 0 ? moment : moment - this.rowMoments[row];
        return beyond === 0 ? `${row}` : `${Math.max(row, 0)}+${beyond}`;
    }
    momentAt(address) {
        const match = /^(\d{1,9})(?:\+(\d{1,9}))?$/.exec(address);
        if (!match || this.rows.length === 0) return null;
        const row = Math.min(Number(match[1]), this.rows.length - 1);
        return Math.min(this.rowMoments[row] + Number(match[2] ?? 0), this.last);
    }

    loopMoment() {
        const from = this.data.loop_from;
        return from === null ? null : from < this.rows.length ? this.rowMoments[from] : this.last;
    }

    timeText(moment) {
        const time = this.times[moment];
        return this.trace.timed ? `${time / 1000} s` : `step ${time}`;
    }

    signalText(signal, value) {
        return value === undefined ? "?" : this.trace.signals[signal].range ? `${value}` : value ? "1" : "0";
    }
}
