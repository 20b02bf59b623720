// SPDX-License-Identifier: MIT
// Highlights elements of a drawn chart by a class and by an additional mark, because users may not be able to
// distinguish colours.
import {draw} from "./dom.js";

// Adds a token to an active step as in IEC 60848: a dot in the lower half of the step.
export function lightStep(group, on) {
    group?.classList.toggle("active", on);
    sign(group, on, "token", (box) => draw("circle", {class: "token", cx: box.x + box.width / 2, cy: box.y + box.height - 7, r: 4}));
}

export function lightTransition(group, on) {
    group?.classList.toggle("cleared", on);
    sign(group, on, "tick", (box) => draw("path", {class: "tick",
        d: `M${box.x + box.width / 2 - 7} ${box.y + box.height + 1}h14l-7 10z`}));
}

function sign(group, on, name, drawn) {
    const there = group?.querySelector(`:scope > .${name}`);
    if (!group || on === Boolean(there)) return;
    if (there) return there.remove();
    const box = group.querySelector("rect, polygon, path, line")?.getBBox?.();
    if (box && (box.width > 0 || box.height > 0)) group.append(drawn(box));
}

// Scrolls `view`, but not the page, to the first active step.
export function follow(view, steps) {
    const group = steps.find((step) => step?.classList.contains("active") && step.querySelector(".token"));
    if (!group) return;
    const box = view.getBoundingClientRect(), step = group.getBoundingClientRect();
    if (step.top < box.top || step.bottom > box.bottom)
        view.scrollTop += (step.top + step.bottom - box.top - box.bottom) / 2;
    if (step.left < box.left || step.right > box.right)
        view.scrollLeft += (step.left + step.right - box.left - box.right) / 2;
}
