// SPDX-License-Identifier: MIT
// Completion in a text field: a list of the names and keywords that the server proposes at the cursor.
import {make} from "./dom.js";
import {ask} from "./server.js";

const pause = 100, most = 60;
let lists = 0;

export class Completion {
    // `context()` returns the text of the file before and after the cursor of `field`, as `{before, after}`. `place` is
    // the element that will contain the list; `align(list)` moves the list to the cursor.
    constructor(field, place, context, align = () => {}) {
        Object.assign(this, {field, context, align, number: 0, asking: false, again: false, at: -1, timer: null, accepting: false});
        this.list = make("ul", {class: "proposals", role: "listbox", id: `proposals-${++lists}`, "aria-label": "Proposals", hidden: true});
        place.append(this.list);
        for (const [name, value] of [["aria-autocomplete", "list"], ["aria-controls", this.list.id], ["aria-haspopup", "listbox"]]) field.setAttribute(name, value);
        field.addEventListener("input", () => {
            clearTimeout(this.timer);
            if (this.accepting || this.word() === "") return this.close();
            this.timer = setTimeout(() => this.request(), pause);
        });
        field.addEventListener("keydown", (event) => this.key(event), {capture: true});
        field.addEventListener("blur", () => this.close());
        field.addEventListener("click", () => this.close());
        field.addEventListener("scroll", () => { if (!this.list.hidden) this.align(this.list); });
    }

    // Returns the part of a name before the cursor.
    word() { return this.field.value.slice(0, this.field.selectionStart).match(/[\p{L}\p{M}\p{N}_]*$/u)[0]; }

    // Requests proposals. While the server has not responded to a request, a later request waits.
    async request() {
        this.again = this.asking;
        if (this.asking) return;
        const number = ++this.number, {value, selectionStart} = this.field;
        this.asking = true;
        const answer = await ask("/completion", this.context()).catch(() => null);
        this.asking = false;
        if (this.again) return this.request();
        if (number !== this.number || value !== this.field.value || selectionStart !== this.field.selectionStart) return;
        const word = this.word(), low = word.toLowerCase();
        const found = (answer?.proposals ?? []).filter(({label}) => label !== word && label.toLowerCase().startsWith(low));
        if (document.activeElement !== this.field || found.length === 0) return this.close();
        this.show(found.sort((a, b) => a.keyword - b.keyword).slice(0, most));
    }

    show(found) {
        this.at = -1;
        this.list.replaceChildren(...found.map(({label, detail, documentation}, k) => make("li", {role: "option", id: `${this.list.id}-${k}`, title: documentation,
            // The field keeps the focus.
            onmousedown: (event) => { event.preventDefault(); this.accept(k); }}, make("b", {}, label), " ", make("span", {}, detail))));
        this.found = found;
        this.list.hidden = false;
        this.list.scrollTop = 0;
        this.field.setAttribute("aria-expanded", "true");
        this.align(this.list);
    }

    close() {
        clearTimeout(this.timer);
        this.again = false;
        ++this.number;
        this.list.hidden = true;
        this.field.setAttribute("aria-expanded", "false");
        this.field.removeAttribute("aria-activedescendant");
    }

    choose(at) {
        this.at = (at + this.found.length) % this.found.length;
        [...this.list.children].forEach((each, k) => each.setAttribute("aria-selected", k === this.at));
        this.field.setAttribute("aria-activedescendant", `${this.list.id}-${this.at}`);
        this.list.children[this.at].scrollIntoView({block: "nearest"});
    }

    // Inserts a proposal. If the proposal has places for values, such as the arguments of a component, moves the cursor
    // to the first place and proposes values for it.
    accept(k) {
        const {label, snippet} = this.found[k], end = this.field.selectionStart, begin = end - this.word().length;
        const text = snippet ? snippet.replace(/\$\d+/g, "") : label, place = snippet ? snippet.indexOf("$") : -1;
        this.accepting = true;
        this.field.setRangeText(text, begin, end, "end");
        if (place >= 0) this.field.setSelectionRange(begin + place, begin + place);
        this.field.dispatchEvent(new Event("input", {bubbles: true}));
        this.accepting = false;
        this.close();
        if (place >= 0) this.request();
    }

    key(event) {
        const done = () => { event.preventDefault(); event.stopImmediatePropagation(); };
        if (event.key === " " && event.ctrlKey) { done(); return this.request(); }
        if (this.list.hidden || event.ctrlKey || event.altKey || event.metaKey) return;
        if (event.key === "ArrowDown" || event.key === "ArrowUp") {
            done();
            this.choose(event.key === "ArrowDown" ? this.at + 1 : Math.max(this.at, 0) - 1);
        } else if ((event.key === "Enter" && this.at >= 0) || (event.key === "Tab" && !event.shiftKey)) {
            done();
            this.accept(Math.max(this.at, 0));
        } else if (event.key === "Escape") {
            done();
            this.close();
        }
    }
}
