// SPDX-License-Identifier: MIT
// Virtual list: only the visible rows are elements of the page. Therefore the time for scrolling is independent of the
// number of rows.
import {make} from "./dom.js";

export class RowList {
    // `row(k)` returns the contents of row k. `choose(k)` is called when the user clicks row k. `height` is the height
    // of a row in pixels and must be equal to the height in page.css. The ids of the rows begin with `prefix`.
    constructor(label, count, row, choose, {height = 28, prefix = "row"} = {}) {
        this.height = height;
        this.prefix = prefix;
        this.count = count;
        this.row = row;
        this.choose = choose;
        this.current = 0;
        this.space = make("div", {class: "rows-space", role: "presentation"});
        this.space.style.height = `${count * this.height}px`;
        this.element = make("div", {
            class: "rows", role: "listbox", tabindex: 0, "aria-label": label,
            onscroll: () => this.draw(), onclick: (event) => this.click(event),
        }, this.space);
        new ResizeObserver(() => this.show(this.current)).observe(this.element);
    }

    draw() {
        const {height, element: {scrollTop, clientHeight}} = this;
        const first = Math.max(0, Math.floor(scrollTop / height) - 4);
        const last = Math.min(this.count, Math.ceil((scrollTop + clientHeight) / height) + 4);
        const rows = [];
        for (let k = first; k < last; ++k) rows.push(this.make(k));
        this.space.replaceChildren(...rows);
        this.element.setAttribute("aria-activedescendant", `${this.prefix}-${this.current}`);
    }
    make(k) {
        const current = k === this.current;
        const row = make("div", {
            class: current ? "row current" : "row", role: "option", id: `${this.prefix}-${k}`, "data-row": k,
            "aria-selected": current, "aria-posinset": k + 1, "aria-setsize": this.count,
        }, ...this.row(k));
        row.style.top = `${k * this.height}px`;
        return row;
    }

    click(event) {
        const row = event.target.closest("[data-row]");
        if (row) this.choose(Number(row.dataset.row));
    }

    show(k) {
        this.current = k;
        const {height, element: {scrollTop, clientHeight}} = this, top = k * height;
        if (clientHeight > 0 && (top < scrollTop + height || top > scrollTop + clientHeight - 2 * height))
            this.element.scrollTop = top - clientHeight / 2;
        this.draw();
    }
}
