// SPDX-License-Identifier: MIT
// The page of a report. The address of the page selects the run in the player and the event of this run. The element
// `data` contains the data of the page (src/page/data.hpp).
import {make} from "./dom.js";
import {Find} from "./find.js";
import {linkButton} from "./link.js";
import {Player} from "./player.js";
import {Decision} from "./terms.js";
import {Zoom} from "./zoom.js";

export class Page {
    constructor(data, place) {
        this.data = data;
        this.place = place;
        this.players = new Map();
        this.Decision = Decision;  // interface for other scripts, which compute values of terms with this class
        this.select = make("select", {"aria-label": "Trace to play", onchange: () => this.open(this.select.value)},
            ...data.runs.map((run) => make("option", {value: run.name}, run.title)));
        this.stage = make("div", {});
        this.problem = make("p", {class: "warning", role: "status", hidden: true});
        this.tools = make("div", {});
        if (data.runs.length > 0)
            this.place.replaceChildren(make("div", {class: "pick-run"}, make("label", {}, "Run: ", this.select), linkButton(() => this.link()), this.tools),
                                       this.problem, this.stage);
        else this.place.replaceChildren(this.problem);
        window.addEventListener("hashchange", () => this.follow(false));
        document.addEventListener("keydown", (event) => this.key(event));
        if (!this.follow(true) && data.runs.length > 0) this.open(data.runs[0].name, null, true);
    }

    // If no element has the focus and the player is visible, the left and right arrow keys control the player. Other
    // keys scroll the page.
    key(event) {
        if (event.target !== document.body || !["ArrowLeft", "ArrowRight"].includes(event.key) || !this.player) return;
        const {top, bottom} = this.player.element.getBoundingClientRect();
        if (top < window.innerHeight && bottom > 0) this.player.key(event);
    }

    // Returns the address of the displayed run and event.
    link() { return location.href.split("#")[0] + this.fragment(this.player.run.address(this.player.moment)); }
    fragment(address) { return `#${encodeURIComponent(this.current)}/${address}`; }

    // Shows the run and the event that the address of the page names, such as `#P16/23`. Returns false if the address
    // names no run.
    follow(quiet) {
        let address = "";
        try {
            address = decodeURIComponent(location.hash.slice(1));
        } catch {
            return false;
        }
        const cut = address.lastIndexOf("/"), name = cut < 0 ? address : address.slice(0, cut);
        this.problem.hidden = true;
        if (!this.data.runs.some((run) => run.name === name)) {
            this.miss(address, name);
            return false;
        }
        if (this.player && this.current === name && `#${address}` === this.written) return true;
        this.open(name, cut < 0 ? null : address.slice(cut + 1), quiet);
        this.place.closest("section")?.scrollIntoView();
        this.player.element.focus({preventScroll: true});  // the player then receives keys
        return true;
    }

    // If the page does not contain the run that the address names, shows the property of this name, or a message if
    // no property has this name.
    miss(address, name) {
        const property = document.getElementById(`property-${name}`);
        if (property) {
            property.open = true;
            return property.scrollIntoView();
        }
        if (address === "" || document.getElementById(address)) return;
        this.problem.textContent = `The link refers to the run \u201c${name}\u201d, which this report does not contain. ${this.data.runs.length > 0 ? "Select a run from the list, or create" : "Create"} the report again with this property.`;
        this.problem.hidden = false;
    }

    open(name, moment = null, quiet = false) {
        this.player?.pause();
        this.quiet = true;
        this.current = name;
        if (!this.players.has(name)) {
            const run = this.data.runs.find((each) => each.name === name);
            this.players.set(name, new Player(this.data, run, (address) => this.write(address)));
        }
        this.player = this.players.get(name);
        this.select.value = name;
        this.stage.replaceChildren(this.player.element);
        this.tools.replaceChildren(this.player.tools);
        const wanted = moment === null ? null : this.player.run.momentAt(moment);
        if (wanted === null) this.player.go(this.player.visited ? this.player.moment : this.player.decisive ?? 0);
        else this.player.go(wanted);
        this.player.visited = true;
        this.quiet = false;
        if (!quiet) this.write(this.player.run.address(this.player.moment));
    }

    write(address) {
        if (this.quiet) return;
        this.problem.hidden = true;
        this.written = `#${this.current}/${address}`;
        history.replaceState(null, "", this.fragment(address));
    }
}

for (const view of document.querySelectorAll("figure > .drawing")) new Zoom(view, view.parentElement.querySelector("figcaption")?.textContent.replace(/:.*/s, "") ?? "the chart");
const drawings = document.getElementById("charts");
if (drawings?.querySelector("svg.grafcet")) drawings.querySelector("h2").after(new Find(drawings).element);
const element = document.getElementById("data"), place = document.getElementById("player") ?? make("div", {});
// A page without runs has no player, but its address is evaluated, too.
if (!place.isConnected) document.querySelector("main")?.prepend(place);
if (element) window.page = new Page(JSON.parse(element.textContent), place);
for (const button of document.querySelectorAll("[data-run]")) {
    button.disabled = !window.page?.data.runs.some((run) => run.name === button.dataset.run);
    const omitted = "Trace omitted: page size limit";
    if (button.disabled) button.textContent = button.dataset.name ? `${button.dataset.name} (${omitted})` : omitted;
    button.addEventListener("click", () => {
        window.page.open(button.dataset.run);
        place.closest("section").scrollIntoView();
        window.page.player.element.focus({preventScroll: true});
    });
}
