// SPDX-License-Identifier: MIT
// Zoom and pan of the drawings in a scrolling element, for the pages of `report`, `serve` and `edit`: wheel with Ctrl,
// pinch, drag, keys and buttons. The size of the drawings changes and the element scrolls; coordinates in a drawing are
// unchanged. A drawing with many steps has an overview map.
import {draw, make} from "./dom.js";
import {savePicture} from "./picture.js";

const least_zoom = 0.01, most_zoom = 8, steps_of_map = 60, size_of_map = 130, zoom_step = 1.25;

const isField = (target) => Boolean(target.closest?.("input, textarea, select, form, button, a, summary"));

export class Zoom {
    // `view` is the scrolling element with the drawings of `name`. `old` is the zoom of an earlier version of the view,
    // whose scale and position are kept. The element `element` replaces `view` in the page and contains it.
    constructor(view, name, old = null) {
        Object.assign(this, {view, name, scale: old?.scale ?? 1, mode: old?.mode ?? "width"});
        this.position = old?.view.isConnected ? [old.view.scrollLeft, old.view.scrollTop] : null;
        this.build();
        view.replaceWith(this.element);
        this.frame.prepend(view);
        view.classList.add("zoomed");
        view.addEventListener("wheel", (event) => this.wheel(event), {passive: false});
        view.addEventListener("touchstart", (event) => this.pinch(event, true), {passive: false});
        view.addEventListener("touchmove", (event) => this.pinch(event, false), {passive: false});
        view.addEventListener("pointerdown", (event) => this.drag(event));
        view.addEventListener("keydown", (event) => this.key(event));
        view.addEventListener("scroll", () => this.frameMap());
        this.width = 0;
        new ResizeObserver(() => { if (view.offsetWidth !== this.width) this.adapt(); this.drawMap(); }).observe(view);
        new MutationObserver(() => this.refresh())
            .observe(view, {subtree: true, childList: true, attributeFilter: ["class", "viewBox"]});
        this.adapt();
    }

    build() {
        const button = (words, title, run) => make("button", {type: "button", title, "aria-label": title, onclick: run}, words);
        this.level = make("output", {"aria-label": "Zoom"});
        this.problem = make("span", {class: "problem", role: "alert"});
        const save = (type) => button(type.toUpperCase(), `Download the drawing as ${type.toUpperCase()}`, () => this.save(type));
        const bar = make("div", {class: "zoom-bar", role: "toolbar", "aria-label": `View of ${this.name}`},
            button("\u2212", "Zoom out (-)", () => this.by(1 / zoom_step)), this.level, button("+", "Zoom in (+)", () => this.by(zoom_step)),
            button("Fit", "Fit the drawing to its panel (F)", () => this.fit()), button("100 %", "Original size (0)", () => this.to(1)),
            make("span", {class: "space"}), this.problem, save("svg"), save("png"));
        this.blocks = draw("path", {class: "blocks"});
        this.live = draw("path", {class: "live"});
        this.window = draw("rect", {class: "window"});
        this.map = draw("svg", {class: "map", "aria-hidden": "true", preserveAspectRatio: "none"}, this.blocks, this.live, this.window);
        this.map.addEventListener("pointerdown", (event) => {
            event.preventDefault();
            this.map.setPointerCapture(event.pointerId);
            this.jump(event);
        });
        this.map.addEventListener("pointermove", (event) => { if (this.map.hasPointerCapture(event.pointerId)) this.jump(event); });
        this.frame = make("div", {class: "zoom-frame"}, this.map);
        this.element = make("div", {class: "zoom"}, bar, this.frame);
    }

    svgs() { return [...this.view.querySelectorAll("svg")]; }

    async save(type) {
        this.problem.textContent = "";
        try {
            for (const svg of this.svgs()) await savePicture(svg, svg.dataset.name ?? this.name, type);
        } catch {
            const other = type === "png" ? "SVG" : "PNG";
            this.problem.textContent = `The browser cannot write this drawing as ${type.toUpperCase()}; download it as ${other}.`;
        }
    }

    // Returns the width and the height of all drawings together at the original size, and the available space.
    extent() {
        const boxes = this.svgs().map((svg) => svg.viewBox.baseVal), style = getComputedStyle(this.view);
        const height = parseFloat(style.maxHeight) || this.view.clientHeight;
        return {width: Math.max(1, ...boxes.map((box) => box.width)), height: Math.max(1, boxes.reduce((sum, box) => sum + box.height, 0)),
                across: this.view.offsetWidth - parseFloat(style.paddingLeft) - parseFloat(style.paddingRight) - 20,
                down: height - parseFloat(style.paddingTop) - parseFloat(style.paddingBottom) - 6};
    }

    // Computes the scale that belongs to the mode: `width` reduces a drawing that is wider than the panel while its
    // texts remain readable, and `fit` shows the complete drawing. In the mode `free`, the user has selected the scale.
    adapt() {
        const {width, height, across, down} = this.extent();
        this.width = this.view.offsetWidth;
        if (this.width > 0 && this.mode === "width") this.scale = Math.min(1, Math.max(across / width, 0.7));
        if (this.width > 0 && this.mode === "fit") this.scale = Math.min(1.5, Math.max(least_zoom, Math.min(across / width, down / height)));
        this.refresh();
        if (!this.position || this.width === 0) return;
        [this.view.scrollLeft, this.view.scrollTop] = this.position;
        this.position = null;
    }

    fit() {
        this.mode = "fit";
        this.adapt();
    }

    // Sets the scale. The point of the drawing at the position (x, y) of the window, by default in the middle of the
    // view, keeps its position.
    to(scale, x, y) {
        const view = this.view.getBoundingClientRect(), svgs = this.svgs();
        if (svgs.length === 0) return;
        x ??= view.left + view.width / 2;
        y ??= view.top + view.height / 2;
        const distance = (svg) => { const box = svg.getBoundingClientRect(); return Math.max(box.top - y, y - box.bottom, 0); };
        const held = svgs.reduce((best, svg) => (distance(svg) < distance(best) ? svg : best));
        const before = held.getBoundingClientRect();
        this.mode = "free";
        this.scale = Math.min(most_zoom, Math.max(least_zoom, scale));
        this.refresh();
        const after = held.getBoundingClientRect();
        this.view.scrollLeft += after.left + (x - before.left) / before.width * after.width - x;
        this.view.scrollTop += after.top + (y - before.top) / before.height * after.height - y;
        this.frameMap();
    }
    by(factor, x, y) { this.to(this.scale * factor, x, y); }

    // Applies the scale to all drawings of the view, including drawings that have replaced others.
    refresh() {
        for (const svg of this.svgs()) {
            const {width, height} = svg.viewBox.baseVal;
            svg.style.width = `${width * this.scale}px`;
            svg.style.height = `${height * this.scale}px`;
        }
        this.level.textContent = `${Math.round(this.scale * 100)} %`;
        this.drawMap();
    }

    // Input of the user

    wheel(event) {
        if (!event.ctrlKey && !event.metaKey) return;
        event.preventDefault();
        const pixels = event.deltaY * [1, 16, 400][event.deltaMode];
        this.by(Math.exp(-Math.min(25, Math.max(-25, pixels)) / 100), event.clientX, event.clientY);
    }

    pinch(event, begin) {
        if (event.touches.length !== 2) return;
        event.preventDefault();
        const [a, b] = event.touches, x = (a.clientX + b.clientX) / 2, y = (a.clientY + b.clientY) / 2;
        const apart = Math.max(1, Math.hypot(a.clientX - b.clientX, a.clientY - b.clientY));
        if (!begin && this.grip) {
            this.view.scrollLeft += this.grip.x - x;
            this.view.scrollTop += this.grip.y - y;
            this.by(apart / this.grip.apart, x, y);
        }
        this.grip = {x, y, apart};
    }

    // Moves the drawing with the mouse. A movement of less than 5 pixels is a click.
    drag(event) {
        const {view} = this, box = view.getBoundingClientRect();
        if (event.pointerType === "touch" || event.button !== 0 || isField(event.target)) return;
        // On a scroll bar, the pointer does not move the drawing.
        if (event.clientX > box.left + view.clientLeft + view.clientWidth) return;
        if (event.clientY > box.top + view.clientTop + view.clientHeight) return;
        const {clientX, clientY} = event, {scrollLeft, scrollTop} = view;
        let moved = false;
        const move = (to) => {
            if (!moved && Math.hypot(to.clientX - clientX, to.clientY - clientY) < 5) return;
            if (!moved) view.setPointerCapture(event.pointerId);
            moved = true;
            view.classList.add("dragged");
            view.scrollLeft = scrollLeft + clientX - to.clientX;
            view.scrollTop = scrollTop + clientY - to.clientY;
        };
        const stop = (click) => { click.stopPropagation(); };
        const ends = ["pointerup", "pointercancel"];
        const end = () => {
            view.removeEventListener("pointermove", move);
            for (const name of ends) window.removeEventListener(name, end);
            view.classList.remove("dragged");
            if (!moved) return;
            view.addEventListener("click", stop, {capture: true, once: true});
            setTimeout(() => view.removeEventListener("click", stop, {capture: true}), 50);
        };
        view.addEventListener("pointermove", move);
        for (const name of ends) window.addEventListener(name, end);
    }

    key(event) {
        if (event.ctrlKey || event.metaKey || event.altKey || isField(event.target)) return;
        const pan = event.shiftKey && {ArrowLeft: [-80, 0], ArrowRight: [80, 0], ArrowUp: [0, -80], ArrowDown: [0, 80]}[event.key];
        const run = pan ? () => this.view.scrollBy(...pan)
                        : {"+": () => this.by(zoom_step), "=": () => this.by(zoom_step), "-": () => this.by(1 / zoom_step),
                           "0": () => this.to(1), f: () => this.fit()}[event.key];
        if (!run) return;
        event.preventDefault();
        event.stopPropagation();
        run();
    }

    // Overview map

    // Draws the steps as small boxes. Active steps are highlighted.
    drawMap() {
        const {view} = this, {scrollWidth, scrollHeight, clientWidth, clientHeight} = view, steps = view.querySelectorAll(".step");
        const hidden = steps.length < steps_of_map || clientWidth === 0 || (scrollWidth <= clientWidth + 1 && scrollHeight <= clientHeight + 1);
        this.map.classList.toggle("hidden", hidden);
        if (hidden) return;
        const box = view.getBoundingClientRect(), dx = view.scrollLeft - view.clientLeft - box.left, dy = view.scrollTop - view.clientTop - box.top;
        const of = (step) => {
            const {left, top, width, height} = step.getBoundingClientRect();
            return `M${left + dx} ${top + dy}h${width}v${height}h${-width}z`;
        };
        const side = Math.min(size_of_map, clientHeight * 0.4, clientWidth * 0.3), scale = Math.min(side / scrollWidth, side / scrollHeight);
        this.blocks.setAttribute("d", [...steps].map(of).join(""));
        this.live.setAttribute("d", [...steps].filter((step) => step.classList.contains("active")).map(of).join(""));
        this.map.setAttribute("viewBox", `0 0 ${scrollWidth} ${scrollHeight}`);
        this.map.style.width = `${Math.max(44, scrollWidth * scale)}px`;
        this.map.style.height = `${Math.max(44, scrollHeight * scale)}px`;
        this.frameMap();
    }

    // Moves the frame of the visible part.
    frameMap() {
        const {scrollLeft, scrollTop, clientWidth, clientHeight} = this.view;
        for (const [name, value] of Object.entries({x: scrollLeft, y: scrollTop, width: clientWidth, height: clientHeight}))
            this.window.setAttribute(name, value);
    }

    // Scrolls to the point of the map at the position of the pointer.
    jump(event) {
        const {view} = this, box = this.map.getBoundingClientRect();
        view.scrollLeft = (event.clientX - box.left) / box.width * view.scrollWidth - view.clientWidth / 2;
        view.scrollTop = (event.clientY - box.top) / box.height * view.scrollHeight - view.clientHeight / 2;
    }
}
