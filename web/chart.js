// SPDX-License-Identifier: MIT
// The drawn chart of one controller, its steps and transitions lit as they are at a moment of a run. An active step has a
// token in it, as the standard marks it, and a cleared transition a mark beside it: colour never says it alone.
import {draw, make} from "./dom.js";

export class ChartView {
    // `choose(kind, place)`: the reader points at a transition or a step.
    constructor(chart, run, controller, choose) {
        this.chart = chart;
        this.run = run;
        this.controller = run.controllers[controller];
        const drawn = document.querySelector(`#${CSS.escape(chart.figure)} svg`);
        this.svg = drawn ? drawn.cloneNode(true) : draw("svg");
        for (const each of this.svg.querySelectorAll("[id]")) {
            each.dataset.element = each.id;
            each.removeAttribute("id");
        }
        this.svg.removeAttribute("aria-labelledby");
        this.svg.setAttribute("role", "group");
        this.svg.setAttribute("aria-label", `Chart ${chart.name}; its active steps carry a token`);
        this.steps = chart.ids.steps.map((id) => this.find(id));
        this.transitions = chart.ids.transitions.map((id) => this.find(id));
        this.conditions = chart.ids.conditions.map((id) => this.find(id));
        this.actions = chart.ids.continuous.map((id) => this.find(id));
        this.orders = chart.ids.forcing.map((id) => this.find(id));
        this.element = make("div", {class: "chart-view", tabindex: 0, role: "region", "aria-label": `Drawing of ${chart.name}`},
                            this.svg);
        this.transitions.forEach((group, place) => {
            for (const each of [group, this.conditions[place]]) this.offer(each, place, choose);
        });
    }

    find(id) { return this.svg.querySelector(`[data-element="${CSS.escape(id)}"]`); }

    offer(group, place, choose) {
        if (!group) return;
        group.classList.add("choice");
        group.addEventListener("click", () => choose(place));
    }

    show(moment, cleared, chosen) {
        this.chart.steps.forEach((_, place) => {
            const active = this.run.isActive(this.controller.steps[place], moment);
            this.mark(this.steps[place], "active", active);
            this.token(this.steps[place], active);
        });
        this.chart.transitions.forEach((transition, place) => {
            const id = this.controller.transitions[place];
            const enabled = transition.from.every((step) => this.run.isActive(this.controller.steps[step], moment));
            for (const group of [this.transitions[place], this.conditions[place]]) {
                this.mark(group, "cleared", cleared.has(id));
                this.mark(group, "enabled", enabled);
                this.mark(group, "chosen", place === chosen);
            }
            this.tick(this.transitions[place], cleared.has(id));
        });
        this.chart.ownerOfAction.forEach((step, place) =>
            this.mark(this.actions[place], "active", this.run.isActive(this.controller.steps[step], moment)));
        this.chart.ownerOfForcing.forEach((step, place) =>
            this.mark(this.orders[place], "active", this.run.isActive(this.controller.steps[step], moment)));
    }

    mark(group, name, on) { group?.classList.toggle(name, on); }

    // The token of IEC 60848: a dot in the lower half of the step.
    token(group, on) {
        const there = group?.querySelector(":scope > .token");
        if (!group || on === Boolean(there)) return;
        if (there) return there.remove();
        const box = this.outline(group);
        if (box)
            group.append(draw("circle", {
                class: "token", cx: box.x + box.width / 2, cy: box.y + box.height - 7, r: 4,
            }));
    }
    tick(group, on) {
        const there = group?.querySelector(":scope > .tick");
        if (!group || on === Boolean(there)) return;
        if (there) return there.remove();
        const box = this.outline(group);
        if (box) {
            const x = box.x + box.width / 2, y = box.y + box.height + 1;
            group.append(draw("path", {class: "tick", d: `M${x - 7} ${y}H${x + 7}L${x} ${y + 10}Z`}));
        }
    }
    outline(group) {
        const shape = group.querySelector("rect, polygon, path, line");
        const box = shape?.getBBox?.();
        return box && (box.width > 0 || box.height > 0) ? box : null;
    }

    // Brings the first active step into sight, without moving the page.
    follow() {
        const group = this.steps.find((step) => step?.classList.contains("active") && step.querySelector(".token"));
        if (!group) return;
        const view = this.element.getBoundingClientRect(), step = group.getBoundingClientRect();
        if (step.top < view.top || step.bottom > view.bottom)
            this.element.scrollTop += (step.top + step.bottom - view.top - view.bottom) / 2;
        if (step.left < view.left || step.right > view.right)
            this.element.scrollLeft += (step.left + step.right - view.left - view.right) / 2;
    }
}
