// SPDX-License-Identifier: MIT
// Values of the terms of a property along a run, evaluated on the states of the closed loop. The value of a term can
// change only if one of its operands changes, so the history of a term is computed from the histories of its operands.
// A value that the run does not contain is `undefined`.
import {History} from "./run.js";
import {valueOf} from "./terms.js";

export class Claims {
    constructor(run, property) {
        this.run = run;
        this.property = property;
        this.terms = property.terms;
        this.histories = [];
        for (const node of this.terms) this.histories.push(this.historyOf(node));  // operands precede the terms that contain them
    }

    value(term, moment) { return this.histories[term].value(moment); }
    // Returns the event since which the term has its value at `moment`.
    since(term, moment) { return this.histories[term].since(moment); }
    // Returns the first event, from `moment` on, after which the term has the value `value` in a state of the model;
    // null if there is none.
    first(term, value, moment) {
        const history = this.histories[term], {at, values} = history;
        for (let k = Math.max(history.place(moment), 0); k < at.length; ++k) {
            if (values[k] !== value) continue;
            const end = k + 1 < at.length ? at[k + 1] : this.run.last + 1;
            for (let m = Math.max(at[k], moment); m < end; ++m) if (!this.run.inside.has(m)) return m;
        }
        return null;
    }

    // Returns the leaves that caused the last change of the term up to `moment`: the leaves that changed at the same
    // event and determine the value of the term.
    causes(term, moment) {
        const since = this.since(term, moment), found = new Set();
        const seek = (each) => {
            if (this.since(each, since) !== since) return;
            const args = this.terms[each].args ?? [], value = this.value(each, since);
            if (args.length === 0) return found.add(each);
            // The false operands determine a false `and`, and the true operands determine a true `or`. All operands
            // determine any other term.
            const {op} = this.terms[each], decisive = (op === "and" && value === 0) || (op === "or" && value === 1);
            for (const arg of args) if (!decisive || this.value(arg, since) === value) seek(arg);
        };
        if (since > 0) seek(term);
        return [...found];
    }

    historyOf(node) {
        if (node.op === "constant") return new History(node.value);
        if (node.args) return this.made(node);
        const leaf = this.leaf(node);
        if (!leaf) return new History(undefined);
        const {history, of} = leaf, made = new History(of(history.values[0]));
        history.at.forEach((moment, k) => made.add(moment, of(history.values[k])));
        return made;
    }

    made(node) {
        const moments = new Set(node.args.flatMap((arg) => this.histories[arg].at));
        let made = null;
        for (const moment of [...moments].sort((a, b) => a - b)) {
            const value = valueOf({value: (term) => this.value(term, moment), leaf: () => undefined}, node);
            if (made) made.add(moment, value);
            else made = new History(value);
        }
        return made;
    }

    // Returns the history of the signal, step or instance of a leaf, and a function that converts its values to values
    // of the leaf; null if the run does not contain this element.
    leaf(node) {
        const {run} = this, {steps, signals, locations} = run, controller = run.controllers[node.controller];
        const known = (history, of = (value) => (value === undefined ? undefined : Number(value))) => history && {history, of};
        switch (node.op) {
        case "input": return known(signals[controller?.inputs[node.place]]);
        case "output": return known(signals[controller?.outputs[node.place]]);
        case "internal": return known(signals[controller?.internals[node.place]]);
        case "step": return known(steps[controller?.steps[node.place]]);
        case "signal": return known(signals[run.trace.signals.findIndex(({name, role}) => name === node.text && role !== "image")]);
        case "location": {
            const place = run.trace.instances.findIndex(({name}) => name === node.instance);
            return known(locations[place], (now) =>
                (now === null ? undefined : Number(run.trace.instances[place].locations[now] === node.location)));
        }
        }
        return null;
    }
}

// Provides the values of the terms at one event. The class has the interface that termTree (why.js) requires.
export class ClaimReader {
    constructor(claims, moment) { Object.assign(this, {claims, moment}); }
    value(term) { return this.claims.value(term, this.moment); }
    remark(node, term) {
        if (node.op === "constant" || this.value(term) === undefined) return "";
        return sinceWords(this.claims.run, this.claims.since(term, this.moment));
    }
}

export function sinceWords(run, since) { return since === 0 ? "since power-on" : `since ${run.timeText(since)}`; }
