// SPDX-License-Identifier: MIT
// The page of `edit`: a file as drawing and as text. The server computes every change of the text and every drawing; this
// page sends the operations and the typed text, and shows the result. Texts of the file are never interpreted as markup.
import {Completion} from "./complete.js";
import {draw, make, prose} from "./dom.js";
import {drawingElement, lightDrawings} from "./drawing.js";
import {Find} from "./find.js";
import {ask, gone} from "./server.js";
import {Simulator} from "./simulator.js";
import {modelsElements, showStatus, verdictWords} from "./verdicts.js";
import {Zoom} from "./zoom.js";

const by = (id) => document.getElementById(id);
const line_height = 20, padding = 8, typing_pause = 150;

// The operations on the selected element: key, name on the button, types of elements, description. If `chart` is true, the
// operation concerns the chart of the selected element, or the first chart.
const operations = [
    {key: "a", operation: "step-after", words: "Step after", of: ["step", "transition"], effect: "add a step and a transition after the element"},
    {key: "b", operation: "step-before", words: "Step before", of: ["step", "transition"], effect: "add a step and a transition before the element"},
    {key: "t", operation: "transition", words: "Transition", of: ["step"], effect: "add a transition from the step to a new step"},
    {key: "n", operation: "action", words: "Action\u2026", of: ["step", "transition"], effect: "add an action", field: "New action"},
    {key: "l", operation: "alternative", words: "Alternative", of: ["step", "transition"], effect: "add an alternative branch"},
    {key: "p", operation: "parallel", words: "Parallel", of: ["step", "transition"], effect: "add a parallel branch"},
    {key: "j", operation: "jump", words: "Jump to\u2026", of: ["step", "transition"], effect: "add a jump or a loop back from the step, or change the target of the transition; then select the target step"},
    {key: "e", operation: "replace", words: "Edit\u2026", of: ["transition", "action"], effect: "edit the condition or the action in place (also Enter or a double click)", field: ""},
    {key: "r", operation: "rename", words: "Rename\u2026", of: ["step", "transition"], effect: "rename the element at all its uses (also F2; for a step also Enter)", field: "Name"},
    {key: "m", words: "Mark", run: (page) => page.drawing.toggle(), of: ["step"], effect: "mark the step, or remove its mark (also Shift+click)"},
    {key: "Ctrl+C", words: "Copy", run: (page) => page.copy(), of: ["step"], effect: "copy the marked steps, or the selected step, with their transitions"},
    {key: "Ctrl+V", words: "Paste", run: (page) => page.paste(), of: ["step", "transition"], effect: "paste the copied steps, with new names, as an alternative branch"},
    {key: "k", operation: "macro", words: "Macro-step", of: ["step", "transition"], effect: "add a macro-step after the element, with an expansion"},
    {key: "g", operation: "enclosing", words: "Enclosing step\u2026", of: ["step", "transition"], effect: "add an enclosing step after the element, with a partial chart", field: "Name of the enclosed partial chart"},
    {key: "c", operation: "partial", words: "Partial chart\u2026", of: ["step", "transition"], effect: "add a partial chart", field: "Name of the new partial chart", chart: true},
    {key: "v", operation: "declare", words: "Variable\u2026", of: ["step", "transition"], effect: "declare an input, an output or an internal variable", field: "Name, or name and type such as n: int 0..3", chart: true, kinds: ["input", "output", "internal"]},
    {key: "Delete", operation: "delete", words: "Delete", of: ["step", "transition", "action"], effect: "delete the element and reconnect its links"},
];

const general_keys = [
    ["arrow keys", "select the next element in this direction"], ["Home", "select the first element"],
    ["Esc", "end editing in place or the choice of a target; otherwise clear the selection"],
    ["Ctrl+Z", "undo"], ["Ctrl+Y, Ctrl+Shift+Z", "redo"], ["Ctrl+S", "save the file"],
    ["/", "find a step or a variable in the drawing"], ["+, -, 0, F", "zoom in, zoom out, original size, fit the drawing"],
    ["Ctrl+wheel", "zoom"], ["drag, Shift+arrow keys", "move the drawing"], ["Ctrl+E", "change between drawing and text"], ["F1", "show this table"],
];

const keyName = (key) => (key === "Delete" ? "Del" : key.length === 1 ? key.toUpperCase() : key);
const titleOf = (element) => element.kind === "step" ? `step ${element.name}` : element.kind === "transition" ? `transition ${element.name}` : `action ${element.text}`;

// Number of lines of a drawing before its elements: the start tag, the title and the background. Each further line is
// one element.
const header = 3;

// Returns a map from each line of the text of a drawing to its nodes, or null if the lines and the nodes do not
// correspond.
function nodesByLine(text, svg) {
    const lines = text.split("\n").slice(header, -2), nodes = [...svg.children].slice(header - 1), known = new Map();
    if (lines.length !== nodes.length) return null;
    lines.forEach((line, k) => known.set(line, [...known.get(line) ?? [], nodes[k]]));
    return known;
}

// The drawings, and the selection of an element.
class Drawing {
    constructor(place, page) {
        Object.assign(this, {place, page, svgs: [], known: [], elements: [], selected: null, marked: [], lit: [], fired: [], marks: []});
        place.addEventListener("click", (event) => this.click(event));
        place.addEventListener("dblclick", () => { if (this.selected) page.edit(); });
        place.addEventListener("keydown", (event) => this.key(event));
        this.zoom = new Zoom(place, "the drawing");
        this.find = new Find(place, (group) => {
            const element = this.elements.find((each) => each.id === group.id || each.condition === group.id);
            if (element) this.select(element, true, false);
        });
        place.closest("section").querySelector(".head").append(this.find.element);
        place.addEventListener("pointermove", (event) => { place.classList.toggle("pointing", this.elementAt(event) !== null); });
    }

    // Shows drawings. If `scroll` is true, makes the selected element visible.
    show(charts, scroll) {
        this.elements = charts.flatMap((chart, index) => chart.elements.map((element) => ({...element, chart: index})));
        if (charts.length !== this.svgs.length || charts.length === 0) {
            this.svgs = [];
            this.known = [];
            this.place.replaceChildren(...charts.map(() => make("figure", {})));
            if (charts.length === 0)
                this.place.append(make("p", {class: "empty"}, "There is no chart to draw. Declare one in the text, for example ", make("code", {}, "grafcet lamp { initial step 0; }"), "."));
        }
        charts.forEach((chart, k) => {
            if (this.svgs[k] === chart.svg || this.update(k, chart.svg)) return;
            const many = charts.length > 1 ? make("figcaption", {}, make("h3", {}, chart.name)) : "";
            const drawing = chart.svg === null ? make("p", {class: "empty"}, "The chart is too large to be drawn here; edit its text.") : drawingElement(chart.name, chart.svg);
            drawing.removeAttribute("tabindex");
            this.place.children[k].replaceChildren(many, drawing);
            this.svgs[k] = chart.svg;
            this.known[k] = chart.svg === null ? null : nodesByLine(chart.svg, drawing.querySelector("svg"));
        });
        const known = this.selected, now = (old) => this.elements.find((each) => each.id === old.id && each.kind === old.kind);
        this.selected = null;
        this.marked = this.marked.map(now).filter(Boolean);
        if (known || this.marked.length > 0) this.select((known && now(known)) ?? null, false, scroll, true);
        lightDrawings(this.place, this.marks, this.lit, this.fired);
    }

    // Replaces the changed elements of drawing `k`. Returns false if the drawing must be replaced.
    update(k, text) {
        const svg = this.place.children[k].querySelector("svg"), known = this.known[k];
        if (!svg || !known || text === null) return false;
        const lines = text.split("\n"), body = lines.slice(header, -2), reused = new Map(), fresh = [];
        for (const line of body) {
            const at = reused.get(line) ?? 0;
            if (at >= (known.get(line)?.length ?? 0)) fresh.push(line);
            reused.set(line, at + 1);
        }
        const parsed = drawingElement("", lines[0] + fresh.join("") + "</svg>").querySelector("svg");
        if (!parsed || parsed.children.length !== fresh.length) return false;
        for (const name of ["width", "height", "viewBox"]) svg.setAttribute(name, parsed.getAttribute(name));
        for (const name of ["width", "height"]) svg.querySelector(".paper").setAttribute(name, parsed.getAttribute(name));
        for (const choice of svg.querySelectorAll(".choice")) choice.remove();
        const made = [...parsed.children];
        for (const [line, nodes] of known)
            for (const node of nodes.splice(reused.get(line) ?? 0)) node.remove();
        let next = svg.children[header - 1];
        const used = new Map();
        for (const line of body) {
            const at = used.get(line) ?? 0, nodes = known.get(line) ?? [];
            used.set(line, at + 1);
            if (at >= nodes.length) { nodes.push(made.shift()); known.set(line, nodes); }
            if (nodes[at] === next) next = next.nextElementSibling;
            else svg.insertBefore(nodes[at], next);
        }
        for (const [line, nodes] of known) if (nodes.length === 0) known.delete(line);
        this.svgs[k] = text;
        return true;
    }

    svg(element) { return this.place.children[element.chart]?.querySelector("svg"); }

    // Returns the areas of an element in its drawing.
    areas(element) { return [element.area, element.condition_area].filter(Boolean); }

    // Returns the element at the position of an event of the pointer. All areas are enlarged, areas of small height
    // more than others.
    elementAt(event) {
        for (const [chart, figure] of [...this.place.children].entries()) {
            const box = figure.querySelector("svg")?.getBoundingClientRect();
            if (!box) continue;
            const {scale} = this.zoom, [px, py] = [(event.clientX - box.left) / scale, (event.clientY - box.top) / scale];
            for (const element of this.elements)
                for (const [x, y, width, height] of element.chart === chart ? this.areas(element) : []) {
                    const pad = height < 12 ? 8 : 3;
                    if (px >= x - 3 && px <= x + width + 3 && py >= y - pad && py <= y + height + pad) return element;
                }
        }
        return null;
    }

    click(event) {
        if (event.target.closest("#in-place")) return;
        const element = this.elementAt(event);
        if (this.page.jumping) return this.page.jumpTo(element);
        if (event.shiftKey && element?.kind === "step") {
            if (this.marked.length === 0 && this.selected?.kind === "step" && this.selected !== element) this.marked = [this.selected];
            this.select(element, true, true, true);
            return this.toggle();
        }
        this.select(element);
        this.page.report("");
    }

    // Selects an element, or nothing. If `show_text` is true, also selects its text. If `scroll` is true, makes it visible.
    // The marks of steps are removed unless `keep` is true.
    select(element, show_text = true, scroll = true, keep = false) {
        for (const old of this.place.querySelectorAll(".choice")) old.remove();
        this.selected = element;
        if (!keep) this.marked = [];
        const frame = (each, kind) => {
            for (const [x, y, width, height] of this.areas(each)) {
                const pad = height < 12 ? 8 : 4;
                this.svg(each)?.append(draw("rect", {class: kind, x: x - 4, y: y - pad, width: width + 8, height: height + 2 * pad, rx: 3}));
            }
        };
        for (const each of this.marked) frame(each, "choice mark");
        if (element) frame(element, "choice");
        if (element && scroll) this.scrollTo(element);
        this.page.showSelection(element, show_text);
    }

    // Marks the selected step, or removes its mark.
    toggle() {
        const step = this.selected, others = this.marked.filter((each) => each !== step);
        this.marked = others.length === this.marked.length ? [...this.marked, step] : others;
        this.select(step, true, true, true);
    }

    // Returns the steps to copy.
    chosen() { return this.marked.length > 0 ? this.marked : [this.selected].filter((each) => each?.kind === "step"); }

    // Returns the position of an area of an element in the window.
    position(element, area = element.area) {
        const box = this.svg(element)?.getBoundingClientRect();
        if (!box || !area) return null;
        const [x, y, width, height] = area.map((each) => each * this.zoom.scale);
        return {left: box.left + x, top: box.top + y, right: box.left + x + width, bottom: box.top + y + height};
    }

    scrollTo(element) {
        const box = this.position(element), view = this.place.getBoundingClientRect();
        if (!box) return;
        if (box.top < view.top || box.bottom > view.bottom) this.place.scrollTop += (box.top + box.bottom - view.top - view.bottom) / 2;
        if (box.left < view.left || box.right > view.right) this.place.scrollLeft += (box.left + box.right - view.left - view.right) / 2;
    }

    key(event) {
        if (event.target.closest("#in-place")) return;
        const copying = (event.ctrlKey || event.metaKey) && !event.shiftKey && {c: "Ctrl+C", v: "Ctrl+V"}[event.key.toLowerCase()];
        if (!copying && (event.ctrlKey || event.metaKey || event.altKey)) return;
        const direction = !event.shiftKey && {ArrowUp: [0, -1], ArrowDown: [0, 1], ArrowLeft: [-1, 0], ArrowRight: [1, 0]}[event.key];
        const done = () => { event.preventDefault(); event.stopPropagation(); };
        if (direction) { this.move(direction); return done(); }
        if (event.key === "Home") { this.select(this.elements[0] ?? null); return done(); }
        if (event.key === "Escape") {
            if (this.page.jumping) this.page.endJump(); else this.select(null);
            return done();
        }
        if (event.key === "Enter" && this.page.jumping) { this.page.jumpTo(this.selected); return done(); }
        if (event.key === "Enter" || event.key === "F2") {
            if (this.selected) this.page.edit(event.key === "F2" && this.selected.kind !== "action" ? "rename" : undefined);
            return done();
        }
        const key = copying || (event.key === "Backspace" ? "Delete" : event.key);
        const known = operations.find((each) => each.key.toLowerCase() === key.toLowerCase());
        if (known && (this.selected || known.chart)) { this.page.start(known); done(); }
    }

    // Selects the nearest element in a direction.
    move([x, y]) {
        const centre = (element) => {
            const box = this.position(element);
            return box && [(box.left + box.right) / 2, (box.top + box.bottom) / 2];
        };
        const from = this.selected && centre(this.selected);
        if (!from) return this.select(this.elements[0] ?? null);
        let best = null, least = Infinity;
        for (const element of this.elements) {
            const at = element === this.selected ? null : centre(element);
            if (!at) continue;
            const ahead = (at[0] - from[0]) * x + (at[1] - from[1]) * y, aside = Math.abs((at[0] - from[0]) * y + (at[1] - from[1]) * x);
            if (ahead > 3 && ahead + 3 * aside < least) { least = ahead + 3 * aside; best = element; }
        }
        if (best) this.select(best, true, true, true);
    }

    light(lit, fired) {
        Object.assign(this, {lit, fired});
        lightDrawings(this.place, this.marks, lit, fired);
    }
}

// The text pane: a text field with line numbers. `changed` is called after each input of the user.
class TextPane {
    constructor(changed, moved) {
        Object.assign(this, {field: by("text"), lines: by("lines"), count: 0, marks: new Map(), free: false, range: null, changed, moved});
        this.field.addEventListener("input", () => { this.number(); changed(); });
        this.field.addEventListener("scroll", () => this.align());
        this.field.addEventListener("keydown", (event) => this.key(event));
        this.field.addEventListener("blur", () => { this.free = false; });
        new Completion(this.field, by("field"), () => {
            const {value, selectionStart} = this.field;
            return {before: value.slice(0, selectionStart), after: value.slice(selectionStart)};
        }, (list) => this.place(list));
        document.addEventListener("selectionchange", () => { if (document.activeElement === this.field) { this.showPosition(); moved(this.field.selectionStart); } });
    }

    get value() { return this.field.value; }

    set(text) {
        if (this.field.value === text) return;
        const {scrollTop, scrollLeft, selectionStart} = this.field;
        this.field.value = text;
        this.field.setSelectionRange(selectionStart, selectionStart);
        Object.assign(this.field, {scrollTop, scrollLeft});
        this.number();
    }

    key(event) {
        const {field} = this;
        if (event.key === "Escape") { this.free = true; return; }
        const insert = (text) => {
            event.preventDefault();
            field.setRangeText(text, field.selectionStart, field.selectionEnd, "end");
            field.dispatchEvent(new Event("input"));
        };
        if (event.key === "Tab" && !this.free && !event.shiftKey && !event.ctrlKey) return insert("    ");
        if (event.key === "Enter" && !event.ctrlKey) {
            const begin = field.value.lastIndexOf("\n", field.selectionStart - 1) + 1;
            return insert("\n" + field.value.slice(begin, field.selectionStart).match(/^[ \t]*/)[0]);
        }
        if (event.key !== "Shift") this.free = false;
    }

    // Moves a list below the cursor, or above it if there is more space.
    place(list) {
        const {field} = this, at = field.selectionStart, line = this.lineOf(at), pen = document.createElement("canvas").getContext("2d");
        pen.font = getComputedStyle(field).font;
        const before = field.value.slice(this.offset(line, 0), at).replaceAll("\t", "    ");
        const top = padding + line * line_height - field.scrollTop, left = 10 + pen.measureText(before).width - field.scrollLeft;
        const below = top + line_height, fits = below + list.offsetHeight <= field.clientHeight || top < list.offsetHeight;
        list.style.top = `${fits ? below : top - list.offsetHeight}px`;
        list.style.left = `${Math.max(0, Math.min(left, field.clientWidth - list.offsetWidth))}px`;
    }

    lineOf(offset) {
        let line = 0;
        for (let at = this.value.indexOf("\n"); at !== -1 && at < offset; at = this.value.indexOf("\n", at + 1)) ++line;
        return line;
    }

    // Returns the offset in the text of a position that a diagnostic gives as line and character.
    offset(line, character) {
        let begin = 0;
        for (let k = 0; k < line; ++k) begin = this.value.indexOf("\n", begin) + 1 || this.value.length;
        return Math.min(begin + character, this.value.length);
    }

    number() {
        const count = this.value.split("\n").length;
        if (count !== this.count) {
            this.count = count;
            this.lines.replaceChildren(Array.from({length: count}, (_, k) => k + 1).join("\n"));
            this.mark(this.marks);
        }
        this.align();
    }

    // Marks lines with errors and warnings: `marks` maps lines to `error` or `warning`.
    mark(marks) {
        this.marks = marks;
        for (const old of this.lines.querySelectorAll("span")) old.remove();
        this.lines.append(...[...marks].map(([line, kind]) => make("span", {class: kind, style: `top: ${padding + line * line_height}px`}, `${line + 1}`)));
    }

    // Shows the lines of a range as selected.
    stripe(range) {
        this.range = range;
        const stripe = by("stripe");
        stripe.hidden = range === null;
        if (range === null) return;
        const first = this.lineOf(range[0]), last = this.lineOf(Math.max(range[0], range[1] - 1));
        this.stripe_top = padding + first * line_height;
        stripe.style.height = `${(last - first + 1) * line_height}px`;
        this.align();
    }

    select(range) {
        const top = padding + this.lineOf(range[0]) * line_height, {field} = this;
        field.setSelectionRange(...range);
        if (top < field.scrollTop || top + line_height > field.scrollTop + field.clientHeight)
            field.scrollTop = top - field.clientHeight / 3;
        this.stripe(range);
    }

    align() {
        this.lines.scrollTop = this.field.scrollTop;
        if (this.range) by("stripe").style.top = `${this.stripe_top - this.field.scrollTop}px`;
    }

    showPosition() {
        const at = this.field.selectionStart, line = this.lineOf(at);
        by("position").textContent = `Line ${line + 1}, column ${at - this.offset(line, 0) + 1}`;
    }
}

// Returns the lines of a text as nodes. Lines that do not belong to the common beginning and end of both texts are marked.
function marked(text, other) {
    const lines = text.split("\n"), others = other.split("\n");
    let begin = 0, end = 0;
    while (begin < Math.min(lines.length, others.length) && lines[begin] === others[begin]) ++begin;
    while (end < Math.min(lines.length, others.length) - begin && lines.at(-1 - end) === others.at(-1 - end)) ++end;
    return lines.map((line, k) => k >= begin && k < lines.length - end ? make("mark", {}, line) : `${line}\n`);
}

class Page {
    constructor() {
        Object.assign(this, {state: null, known: 0, sent: null, queue: Promise.resolve(), timer: null, jumping: null, checked: null, drawn: null});
        this.text = new TextPane(() => this.typed(), (at) => this.caret(at));
        this.drawing = new Drawing(by("charts"), this);
        const simulating = by("simulating");
        this.simulator = new Simulator(by("simulation"), (request) => ask("/simulate", request),
                                       (lit, fired) => { if (simulating.open) this.drawing.light(lit, fired); });
        simulating.addEventListener("toggle", () => {
            if (simulating.open && this.checked) this.simulate(this.checked);
            else this.drawing.light([], []);
        });
        this.buttons = operations.map((each) => make("button", {type: "button", title: each.effect, disabled: true, onclick: () => this.start(each)},
            each.words, make("kbd", {}, keyName(each.key))));
        by("operations").append(...this.buttons);
        for (const [id, run] of Object.entries({save: () => this.change("/save"), undo: () => this.change("/undo"), redo: () => this.change("/redo"),
                                                keys: () => by("help").showModal(),
                                                "keep-page": () => this.change("/resolve", {keep: "page"}), "keep-file": () => this.change("/resolve", {keep: "file"})}))
            by(id).addEventListener("click", run);
        by("key-rows").append(...[...operations.map((each) => [keyName(each.key), each.effect]), ...general_keys]
            .map(([key, effect]) => make("tr", {}, make("td", {}, make("kbd", {}, key)), make("td", {}, effect))));
        document.addEventListener("keydown", (event) => this.key(event));
    }

    key(event) {
        const control = event.ctrlKey || event.metaKey, key = event.key.toLowerCase();
        const run = control && key === "s" ? () => this.change("/save")
                  : control && (key === "y" || (key === "z" && event.shiftKey)) ? () => this.change("/redo")
                  : control && key === "z" ? () => this.change("/undo")
                  : control && key === "e" ? () => (document.activeElement === this.text.field ? by("charts") : this.text.field).focus()
                  : event.key === "F1" ? () => by("help").showModal() : null;
        if (!run || (event.target.closest?.("#in-place, #simulation") && key !== "s")) return;
        event.preventDefault();
        run();
    }

    // -- requests -------------------------------------------------------------------------------------------------------

    // Executes requests sequentially.
    enqueue(run) {
        this.queue = this.queue.then(run).catch((error) => this.lose(error));
        return this.queue;
    }

    typed() {
        this.pending = true;
        clearTimeout(this.timer);
        this.timer = setTimeout(() => this.enqueue(() => this.sendText()), typing_pause);
        by("saved").className = "changed";
    }

    // Sends the typed text. Text that is typed in the meantime is sent by a later request.
    async sendText() {
        clearTimeout(this.timer);
        if (!this.pending) return;
        const text = this.text.value, version = this.state.text_version;
        const answer = await ask("/text", {version, text});
        this.pending = this.text.value !== text && !answer.problem;
        this.take(answer.state);
        if (answer.problem) this.report(answer.problem);
        if (this.pending) this.typed();
        else if (document.activeElement === this.text.field) this.caret(this.text.field.selectionStart);
    }

    // Sends a change after the typed text, and shows its result. Returns the response. A request with positions
    // contains the version of the text in which the positions are valid, so that the server rejects the request if
    // typed text has changed the positions.
    change(path, request = {}) {
        let result = null;
        return this.enqueue(async () => {
            await this.sendText();
            result = await ask(path, {version: this.state.text_version, ...request});
            if (request.trial) return;
            this.take(result.state, result.selected === undefined);
            this.report(result.problem ?? "");
            if (result.selected === undefined || result.problem) return;
            const element = this.drawing.elements.filter((each) => each.begin === result.selected).at(-1);
            if (element && this.state.readable) this.drawing.select(element);
            else this.text.select([result.selected, result.selected]);
        }).then(() => result);
    }

    // Shows a state of the file that the server has sent. If `scroll` is true, makes the selected element visible.
    take(state, scroll = true) {
        this.state = state;
        this.known = state.version;
        document.title = `${state.modified ? "* " : ""}${state.file} \u2013 grafverif`;
        by("file").textContent = state.file;
        if (!this.pending) this.text.set(state.text);
        by("saved").className = state.modified ? "changed" : "";
        by("saved").textContent = state.modified ? "Not saved" : "Saved";
        by("save").disabled = !(state.modified || state.missing) || state.read_only;
        by("undo").disabled = !state.can_undo;
        by("redo").disabled = !state.can_redo;
        const notices = [
            state.read_only && "The file is read-only. You can edit the text, but you cannot save it.",
            state.missing && "The file has been deleted. Saving creates it again.",
            state.restored && "Changes of an earlier session, which were not saved, are restored. Undo discards them.",
            state.notice,
        ].filter(Boolean);
        by("notices").replaceChildren(...notices.map((words) => make("p", {role: "status"}, ...prose(words))));
        by("conflict").hidden = state.other === null;
        if (state.other !== null) {
            by("page-text").replaceChildren(...marked(state.text, state.other));
            by("file-text").replaceChildren(...marked(state.other, state.text));
        }
        this.drawing.show(state.charts, scroll);
        this.showDiagnostics(state);
        this.age(!state.readable);
        this.showOperations();
    }

    showDiagnostics({diagnostics}) {
        const marks = new Map();
        for (const each of diagnostics)
            if (!each.file && marks.get(each.line) !== "error") marks.set(each.line, each.error ? "error" : "warning");
        this.text.mark(marks);
        by("diagnostics").replaceChildren(...diagnostics.map((each) => make("li", {class: each.error ? "error" : "warned"},
            make("button", {type: "button", disabled: Boolean(each.file), onclick: () => {
                this.text.select([this.text.offset(each.line, each.character), this.text.offset(each.end_line, each.end_character)]);
                this.text.field.focus();
            }}, make("span", {class: "where"}, `${each.file ? `${each.file}, ` : ""}line ${each.line + 1}`),
                `${each.error ? "Error" : "Warning"}: `, ...prose(each.message)))));
    }

    // If `old` is true, marks the drawing and the verdicts as outdated.
    age(old) {
        for (const place of [by("charts"), by("models")]) {
            place.classList.toggle("stale", old);
            place.closest("section").querySelector(".before").hidden = !old || place.children.length === 0 || place.querySelector(":scope > .empty") !== null;
        }
    }

    report(problem) { by("problem").replaceChildren(...prose(problem)); }

    // -- selection and operations -----------------------------------------------------------------------------------------

    caret(at) {
        if (!this.state?.readable || this.pending) return;
        const around = this.drawing.elements.filter((each) => each.begin <= at && at <= each.end);
        const element = around.sort((a, b) => (a.end - a.begin) - (b.end - b.begin))[0] ?? null;
        if (element !== this.drawing.selected) this.drawing.select(element, false);
    }

    showSelection(element, show_text) {
        const {marked} = this.drawing;
        const marks = marked.length > 0 ? `; marked: ${marked.map((each) => each.name).join(", ")}` : "";
        by("selection").textContent = element ? `Selected: ${titleOf(element)}${marks}` : `Nothing is selected${marks}.`;
        if (this.state?.readable && element && show_text && document.activeElement !== this.text.field) this.text.select([element.begin, element.end]);
        else this.text.stripe(element && this.state?.readable ? [element.begin, element.end] : null);
        this.showOperations();
    }

    showOperations() {
        const element = this.drawing.selected;
        operations.forEach((each, k) => { this.buttons[k].disabled = !this.state?.readable || !this.subject(each, element); });
    }

    // Returns the element to which an operation applies, or undefined if there is none.
    subject(operation, selected = this.drawing.selected) {
        if (operation.words === "Copy" && this.drawing.marked.length > 0) return this.drawing.marked[0];
        if (selected && operation.of.includes(selected.kind)) return selected;
        if (operation.chart) return this.drawing.elements.find((each) => each.chart === (selected?.chart ?? each.chart) && operation.of.includes(each.kind));
    }

    // Begins an operation on the selected element.
    start(operation) {
        const element = this.subject(operation);
        if (!element || !this.state.readable) return;
        this.endJump();
        if (operation.run) return operation.run(this);
        if (operation.field !== undefined) return this.openField(operation, element);
        by("charts").focus({preventScroll: true});
        if (operation.operation !== "jump") return this.change("/edit", {version: this.state.text_version, operation: operation.operation, at: element.at});
        this.jumping = {...element, version: this.state.text_version};
        by("charts").classList.add("jumping");
        by("selection").textContent = `Select the target step of the jump from ${titleOf(element)}: click on it, or use the arrow keys and Enter. Esc cancels.`;
    }

    // Copies the marked steps, or the selected step.
    copy() {
        const steps = this.drawing.chosen(), version = this.state.text_version;
        return this.enqueue(async () => {
            await this.sendText();
            const answer = await ask("/copy", {version, steps: steps.map((each) => each.at)});
            this.report(answer.problem);
            if (answer.problem) return;
            this.copied = answer.text;
            by("selection").textContent = `Copied: ${steps.map((each) => titleOf(each)).join(", ")}. Select a step or a transition, then paste.`;
            navigator.clipboard?.writeText(answer.text).catch(() => {});  // other programs can paste the text
        });
    }

    paste() {
        if (!this.copied) return this.report("Copy steps first.");
        return this.change("/edit", {version: this.state.text_version, operation: "paste", at: this.drawing.selected.at, text: this.copied});
    }

    edit(name = this.drawing.selected.kind === "step" ? "rename" : "replace") { this.start(operations.find((each) => each.operation === name)); }

    jumpTo(target) {
        const from = this.jumping;
        if (target?.kind !== "step") return this.report("Select a step as the target of the jump, or press Esc.");
        this.endJump();
        this.change("/edit", {version: from.version, operation: "jump", at: from.at, target: target.at});
    }

    endJump() {
        this.jumping = null;
        by("charts").classList.remove("jumping");
        this.showSelection(this.drawing.selected, false);
    }

    // Opens a field at the element for a text, which the server checks while it is typed.
    openField(operation, element) {
        by("in-place")?.remove();
        const label = operation.field || (element.kind === "transition" ? "Condition" : "Action");
        const version = this.state.text_version;
        let checked = 0;
        const request = () => ({version, operation: operation.operation, at: element.at, text: (kind ? `${kind.value} ` : "") + input.value});
        const problem = make("p", {class: "problem", role: "alert"});
        const close = () => { form.remove(); by("charts").focus({preventScroll: true}); };
        const check = async () => {
            const number = ++checked, answer = await this.change("/edit", {...request(), trial: true});
            if (number === checked && answer && input.value !== initial) problem.replaceChildren(...prose(answer.problem));
        };
        const kind = operation.kinds && make("select", {"aria-label": "Kind of the variable", onchange: () => check()}, ...operation.kinds.map((each) => make("option", {}, each)));
        const initial = operation.operation === "replace" ? element.text.replaceAll("\r\n", "\n") : operation.operation === "rename" ? element.name : "";
        const lines = initial.split("\n").length;
        const input = make(lines > 1 ? "textarea" : "input", {rows: lines > 1 && lines, autocomplete: "off", spellcheck: "false", oninput: () => {
            clearTimeout(this.check_timer);
            this.check_timer = setTimeout(check, typing_pause);
        }});
        input.value = initial;
        const apply = async (event) => {
            event.preventDefault();
            clearTimeout(this.check_timer);
            ++checked;
            if (input.value === initial) return close();
            if (this.state.text_version !== version) return problem.replaceChildren("The text has changed in the meantime; close this field and open it again.");
            const answer = await this.change("/edit", request());
            if (answer?.problem) { this.report(""); problem.replaceChildren(...prose(answer.problem)); }
            else close();
        };
        const form = make("form", {id: "in-place", onsubmit: apply, onkeydown: (event) => {
            if (event.key === "Enter" && event.ctrlKey && lines > 1) form.requestSubmit();
            if (event.key !== "Escape") return;
            event.stopPropagation();
            close();
        }}, kind ?? "", make("label", {}, operation.chart || operation.operation === "enclosing" ? label : `${label} of ${titleOf(element)}`, input), problem,
            make("div", {class: "row"}, make("button", {}, "Apply"), make("button", {type: "button", onclick: close}, "Cancel")));
        const charts = by("charts");
        const area = operation.operation === "replace" && element.condition_area ? element.condition_area : element.area;
        const place = () => {
            const view = charts.getBoundingClientRect(), box = this.drawing.position(element, area) ?? view;
            const left = Math.max(8, Math.min(box.left - view.left, charts.clientWidth - form.offsetWidth - 8));
            form.style.left = `${left + charts.scrollLeft}px`;
            form.style.top = `${Math.max(0, Math.min(box.bottom - view.top + 4, charts.clientHeight - form.offsetHeight - 8)) + charts.scrollTop}px`;
        };
        charts.append(form);
        place();
        if (["replace", "action"].includes(operation.operation)) {
            const proposals = make("div", {});
            input.after(proposals);
            new Completion(input, proposals, () => this.contextOf(operation, element, input), place);
        }
        input.focus({preventScroll: true});
        input.select();
    }

    // Returns the text of the file before and after the cursor of a field, as if the text of the field were in the file.
    contextOf({operation}, element, {value, selectionStart}) {
        const {text} = this.state, [before, after] = [value.slice(0, selectionStart), value.slice(selectionStart)];
        const [begin, head, tail, end] = operation === "replace" ? [element.part[0], "", "", element.part[1]]
                                       : element.kind === "step" ? [element.begin, `step ${element.name} { `, "; }", element.end]
                                                                 : [element.end - 1, " do ", "", element.end - 1];
        return {before: text.slice(0, begin) + head + before, after: after + tail + text.slice(end)};
    }

    // -- results of the server ----------------------------------------------------------------------------------------------

    lose(error) {
        showStatus("bad", error.message === gone ? `${gone}. It restores changes that were not saved.` : error.message);
    }

    async showVerdicts(state) {
        const [kind, words] = state.readable ? verdictWords(state) : ["bad", "the text has errors"];
        showStatus(kind, words);
        if (state.readable) by("models").replaceChildren(...modelsElements(state, false));
        const refused = state.readable && state.models.some((model) => model.state === "refused");
        by("reasons").hidden = !refused;
        by("reasons").textContent = refused ? state.diagnostics : "";
        this.checked = state;
        if (by("simulating").open) await this.simulate(state);
    }

    // Updates the simulator, which simulates the text that the server checked last.
    async simulate(state) {
        if (state.readable && state.reading !== this.drawn) {
            this.drawn = state.reading;
            const answer = await ask("/drawings");
            if (answer.reading === this.drawn) this.drawing.marks = (answer.marks ?? []).filter(Boolean);
        }
        this.simulator.take(state);
    }

    // Requests newer states in an endless loop. A hidden page sends no requests.
    async follow(path, take) {
        for (let pause = 0;;) {
            if (document.hidden) await new Promise((seen) => document.addEventListener("visibilitychange", seen, {once: true}));
            try {
                await take(await ask(path()));
                pause = 0;
            } catch (error) {
                this.lose(error);
                pause = Math.min(pause + 500, 5000);
                await new Promise((wait) => setTimeout(wait, pause));
            }
        }
    }

    run() {
        let verdicts = 0;
        this.follow(() => `/document?after=${this.known}`, (state) => this.enqueue(() => {
            // A state that is older than the known state is the response to a request from before the last change.
            // While typed text has not been sent, a new state is ignored, so that the server rejects the text if
            // another window has changed it.
            if (!state || (state.version <= this.known && this.known !== 0)) return;
            if (this.pending) this.known = state.version;
            else this.take(state);
        }));
        this.follow(() => `/state?after=${verdicts}`, async (state) => {
            if (!state) return;
            verdicts = state.version;
            await this.showVerdicts(state);
        });
    }
}

window.page = new Page();
window.page.run();
