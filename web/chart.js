// SPDX-License-Identifier: MIT
// View of the chart of one controller at an event of a run. Active steps, enabled transitions and cleared transitions
// are highlighted.
import {draw, make} from "./dom.js";
import {follow, lightStep, lightTransition} from "./marks.js";
import {Zoom} from "./zoom.js";

export class ChartView {
    // `choose(place)` is called when the user clicks the transition with the index `place`.
    constructor(chart, run, controller, choose) {
        this.chart = chart;
        this.run = run;
        this.controller = run.controllers[controller];
        const drawn = document.querySelector(`#${CSS.escape(chart.figure)} .drawing svg`);
        this.svg = drawn ? drawn.cloneNode(true) : draw("svg", {viewBox: "0 0 1 1"});
        for (const mark of this.svg.querySelectorAll(".find")) mark.remove();
        for (const each of this.svg.querySelectorAll("[id]")) {
            each.dataset.element = each.id;
            each.removeAttribute("id");
        }
        this.svg.removeAttribute("aria-labelledby");
        this.svg.setAttribute("role", "group");
        this.svg.setAttribute("aria-label", `Chart ${chart.name}; a token marks its active steps`);
        this.steps = chart.ids.steps.map((id) => this.find(id));
        this.transitions = chart.ids.transitions.map((id) => this.find(id));
        this.conditions = chart.ids.conditions.map((id) => this.find(id));
        this.actions = chart.ids.continuous.map((id) => this.find(id));
        this.orders = chart.ids.forcing.map((id) => this.find(id));
        this.view = make("div", {class: "chart-view", tabindex: 0, role: "region", "aria-label": `Drawing of ${chart.name}`}, this.svg);
        this.element = new Zoom(this.view, chart.name).element;
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
        this.steps.forEach((group, place) => lightStep(group, this.run.isActive(this.controller.steps[place], moment)));
        this.chart.transitions.forEach((transition, place) => {
            const id = this.controller.transitions[place];
            const enabled = transition.from.every((step) => this.run.isActive(this.controller.steps[step], moment));
            lightTransition(this.transitions[place], cleared.has(id));
            this.mark(this.conditions[place], "cleared", cleared.has(id));
            for (const group of [this.transitions[place], this.conditions[place]]) {
                this.mark(group, "enabled", enabled);
                this.mark(group, "chosen", place === chosen);
            }
        });
        this.chart.ownerOfAction.forEach((step, place) =>
            this.mark(this.actions[place], "active", this.run.isActive(this.controller.steps[step], moment)));
        this.chart.ownerOfForcing.forEach((step, place) =>
            this.mark(this.orders[place], "active", this.run.isActive(this.controller.steps[step], moment)));
    }

    mark(group, name, on) { group?.classList.toggle(name, on); }

    follow() { follow(this.view, this.steps); }
}
