// SPDX-License-Identifier: MIT
// View of the automaton of a plant instance. The current location of the instance is highlighted.
import {make} from "./dom.js";
import {Zoom} from "./zoom.js";

export class InstanceView {
    // `plant` maps the name of an instance to the id of the figure of its component. If no instance has a drawing,
    // `element` is undefined.
    constructor(plant, run) {
        this.run = run;
        this.figures = run.trace.instances.map(({name}) => (Object.hasOwn(plant, name) ? document.querySelector(`#${plant[name]} .drawing svg`) : null));
        const drawn = run.trace.instances.flatMap((_, k) => (this.figures[k] ? [k] : []));
        if (drawn.length === 0) return;
        this.moment = 0;
        this.pick = make("select", {"aria-label": "Instance", onchange: () => this.choose(Number(this.pick.value))},
            ...drawn.map((k) => make("option", {value: k}, run.trace.instances[k].name)));
        this.words = make("span", {class: "remark"});
        this.place = make("div", {class: "chart-view automaton", tabindex: 0, role: "region", "aria-label": "Drawing of the instance"});
        this.zoom = new Zoom(this.place, "the instance");
        this.element = make("div", {}, make("p", {}, make("label", {class: "pick"}, "instance ", this.pick), " ", this.words), this.zoom.element);
        this.choose(drawn[0]);
    }

    choose(instance) {
        this.current = instance;
        const svg = this.figures[instance].cloneNode(true);
        svg.setAttribute("role", "img");
        svg.setAttribute("aria-label", `The automaton of ${this.run.trace.instances[instance].name}`);
        // Removes the ids in the copy, because ids must be unique in the page. The arrow heads of the copy then use the
        // marker of the original drawing.
        for (const each of svg.querySelectorAll("[id]")) each.removeAttribute("id");
        this.nodes = [...svg.querySelectorAll("rect.node")];
        svg.dataset.name = this.run.trace.instances[instance].name;
        this.place.replaceChildren(svg);
        this.zoom.adapt();
        this.show(this.moment);
    }

    show(moment) {
        if (!this.element) return;
        this.moment = moment;
        const location = this.run.locations[this.current].value(moment);
        this.nodes.forEach((node, k) => node.classList.toggle("active", k === location));
        this.words.textContent = location === null ? "" : `is in ${this.run.trace.instances[this.current].locations[location]}`;
    }
}
