// SPDX-License-Identifier: MIT
// Search for a step, a transition or a variable in drawings. All matches are marked; Enter goes to the next match. The
// key `/` focuses the field of the visible drawings.
import {draw, make} from "./dom.js";

const fields = new Set();  // the search fields of the page

// Returns the name of the step or the transition that `group` draws; null for other elements.
function nameIn(group, title) {
    return group.matches(".step, .transition") ? title.replace(/^(step|transition) /, "").replace(/, .*$/s, "") : null;
}

// Returns how well an element with the given title matches the text; null if the element does not match. The result is
// 0 for the name of a step or a transition, and 1 for a complete name in a condition or an action. For a part of a
// name, the result is 2. `X12` is step 12.
function rankOf(group, title, text) {
    const name = nameIn(group, title), low = (name ?? title).toLowerCase();
    if (name !== null && (low === text || (group.matches(".step") && `x${low}` === text))) return 0;
    const at = low.indexOf(text);
    if (at < 0) return null;
    const words = low.split(/[^\p{L}\p{M}\p{N}_.[\]]+/u);
    return name === null && words.includes(text) ? 1 : 2;
}

export class Find {
    // `place` contains the drawings. `found(group)` is called when a match is shown.
    constructor(place, found = () => {}) {
        Object.assign(this, {place, found, matches: [], current: -1, text: ""});
        this.field = make("input", {type: "search", placeholder: "Find (key /)", "aria-label": "Find a step or a variable in the drawing (key /)",
                                    autocomplete: "off", spellcheck: "false", oninput: () => this.search()});
        this.count = make("output", {class: "remark"});
        const button = (words, title, by) => make("button", {type: "button", "aria-label": title, title, onclick: () => this.go(by)}, words);
        this.moves = make("span", {class: "moves", hidden: true}, button("\u2191", "Previous match (Shift+Enter)", -1),
                          button("\u2193", "Next match (Enter)", 1));
        this.element = make("form", {class: "find-bar", role: "search", onsubmit: (event) => event.preventDefault(),
                                     onkeydown: (event) => this.key(event)}, this.field, this.count, this.moves);
        fields.add(this);
    }

    key(event) {
        event.stopPropagation();
        if (event.target !== this.field) return;
        if (event.key === "Enter") this.go(event.shiftKey ? -1 : 1);
        if (event.key !== "Escape") return;
        event.preventDefault();
        this.field.value = "";
        this.search();
        this.place.querySelector(".zoomed")?.focus({preventScroll: true});
    }

    // Returns the matches in the drawings, best matches first.
    matching(text) {
        const ranked = [];
        const drawings = text === "" ? [] : [...this.place.querySelectorAll("svg.grafcet")].filter((svg) => svg.checkVisibility());
        for (const group of drawings.flatMap((svg) => [...svg.querySelectorAll(":scope > g")])) {
            // The title of an action contains its step, so that the displayed texts are searched instead.
            const title = group.matches(".action, .forcing") ? [...group.querySelectorAll("text")].map((text) => text.textContent).join(" ")
                                                             : group.querySelector(":scope > title")?.textContent;
            const rank = title ? rankOf(group, title, text) : null;
            if (rank !== null) ranked.push({group, rank});
        }
        return ranked.sort((a, b) => a.rank - b.rank).map(({group}) => group);
    }

    // Marks the matches of the text in the field. If `jump` is true, shows the first match.
    search(jump = true) {
        this.text = this.field.value.trim().toLowerCase();
        this.mark(this.matching(this.text));
        this.current = -1;
        if (this.matches.length > 0 && jump) return this.go(1);
        this.count.textContent = this.text === "" ? "" : this.matches.length === 0 ? "no match" : `${this.matches.length} found`;
    }

    mark(matches) {
        for (const old of this.place.querySelectorAll(".find")) old.remove();
        this.matches = matches;
        this.moves.hidden = matches.length < 2;
        // All sizes are read before the drawing is changed, because each change invalidates the layout.
        const areas = matches.map((group) => group.getBBox());
        this.boxes = areas.map(({x, y, width, height}) =>
            draw("rect", {class: "find", x: x - 4, y: y - 4, width: width + 8, height: height + 8, rx: 4}));
        matches.forEach((group, k) => group.append(this.boxes[k]));
    }

    go(by) {
        // After a change of the drawings, the matches are determined again.
        if (this.boxes?.some((box) => !box.isConnected)) this.mark(this.matching(this.text));
        if (this.matches.length === 0) return;
        const from = this.current < 0 && by < 0 ? 0 : this.current;  // if no match is current, `by` = -1 selects the last match
        this.current = (from + by + this.matches.length) % this.matches.length;
        this.boxes.forEach((box, k) => box.classList.toggle("here", k === this.current));
        this.count.textContent = `${this.current + 1} of ${this.matches.length}`;
        this.show(this.matches[this.current]);
        this.found(this.matches[this.current]);
    }

    // Scrolls the view to the middle of `group`, and the page to the view.
    show(group) {
        const view = group.closest(".zoomed"), box = view.getBoundingClientRect(), at = group.getBoundingClientRect();
        view.scrollLeft += (at.left + at.right - box.left - box.right) / 2;
        view.scrollTop += (at.top + at.bottom - box.top - box.bottom) / 2;
        const {top, bottom} = group.getBoundingClientRect();
        if (top < this.element.getBoundingClientRect().bottom || bottom > window.innerHeight) group.scrollIntoView({block: "center"});
    }
}

document.addEventListener("keydown", (event) => {
    if (event.key !== "/" || event.ctrlKey || event.metaKey || event.altKey) return;
    if (event.target.closest?.("input:not([type=checkbox], [type=range]), textarea, select, dialog")) return;
    const shown = [...fields].filter((each) => each.element.checkVisibility())
        .sort((a, b) => (a.element.compareDocumentPosition(b.element) & Node.DOCUMENT_POSITION_FOLLOWING ? -1 : 1));
    const inSight = (each) => { const {top, bottom} = each.place.getBoundingClientRect(); return bottom > 0 && top < window.innerHeight; };
    const wanted = shown.find((each) => each.place.contains(document.activeElement)) ?? shown.find(inSight) ?? shown[0];
    if (!wanted) return;
    event.preventDefault();
    wanted.field.focus();
    wanted.field.select();
});
