// SPDX-License-Identifier: MIT
// A button that copies the address of the displayed state.
import {make} from "./dom.js";

// Copies a text. Returns false if the browser does not permit copying.
async function copy(text) {
    try {
        await navigator.clipboard.writeText(text);
        return true;
    } catch {
        const field = make("textarea", {readonly: true, class: "off-screen"});
        field.value = text;
        document.body.append(field);
        field.select();
        const done = document.execCommand("copy");
        field.remove();
        return done;
    }
}

// Returns a button that copies the address that `address()` returns.
export function linkButton(address) {
    const words = "Copy link";
    const button = make("button", {type: "button", title: "Copy the address of this state", "aria-live": "polite", onclick: async () => {
        button.textContent = await copy(address()) ? "\u2713 Copied" : "Copy from the address bar";
        setTimeout(() => { button.textContent = words; }, 2000);
    }}, words);
    return button;
}
