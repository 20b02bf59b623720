// SPDX-License-Identifier: MIT
// Drawings of charts. The server generates the drawings, and the browser parses them as SVG. All other texts from the
// server are inserted as text, not as markup.
import {make} from "./dom.js";
import {follow, lightStep, lightTransition} from "./marks.js";

// Returns an element with the drawing `text` of the chart `name`.
export function drawingElement(name, text) {
    const svg = document.importNode(new DOMParser().parseFromString(text, "image/svg+xml").documentElement, true);
    svg.setAttribute("role", "img");
    svg.dataset.name = name;
    svg.setAttribute("aria-label", `Chart ${name}; a dot marks active steps`);
    svg.removeAttribute("aria-labelledby");
    return make("div", {class: "drawing", tabindex: 0, role: "region", "aria-label": `Drawing of ${name}`}, svg);
}

const followed = new WeakMap();  // maps each place to the active steps to which its drawings were scrolled

// Highlights active steps, enabled transitions and cleared transitions of the drawings in `place`. `marks`, from the
// response of the server, contains the ids of the drawn transitions and actions.
export function lightDrawings(place, marks, lit, fired) {
    const show = (name, ids, light) => {
        for (const each of place.querySelectorAll(`.${name}`)) light(each, false);
        for (const id of ids) light(document.getElementById(id), true);
    };
    show("step.active", lit, lightStep);
    show("cleared", fired, lightTransition);
    const active = new Set(lit);
    for (const {transitions, actions} of marks) {
        for (const {ids, from} of transitions)
            for (const id of ids)
                document.getElementById(id)?.classList.toggle("enabled", lit.length > 0 && from.every((step) => active.has(step)));
        for (const {id, step} of actions) document.getElementById(id)?.classList.toggle("active", active.has(step));
    }
    // If the active steps are unchanged, the user's position is kept.
    if (followed.get(place) === String(lit)) return;
    followed.set(place, String(lit));
    for (const view of place.querySelectorAll(".drawing")) follow(view.closest(".zoomed") ?? view, [...view.querySelectorAll(".step.active")]);
}
