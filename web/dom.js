// SPDX-License-Identifier: MIT
// Creates elements of the page from names, attributes and text nodes. Therefore texts from the user's files are never
// interpreted as markup.

export function make(tag, attributes = {}, ...children) { return fill(document.createElement(tag), attributes, children); }

export function draw(tag, attributes = {}, ...children) {
    return fill(document.createElementNS("http://www.w3.org/2000/svg", tag), attributes, children);
}

function fill(element, attributes, children) {
    for (const [name, value] of Object.entries(attributes))
        if (name.startsWith("on")) element.addEventListener(name.slice(2), value);
        else if (value === true) element.setAttribute(name, "");
        else if (value !== false && value !== null && value !== undefined) element.setAttribute(name, value);
    element.append(...children);
    return element;
}

// Converts a text to strings and `code` elements. In the text, backticks enclose code.
export const prose = (text) => text.split("`").map((part, k) => (k % 2 === 1 ? make("code", {}, part) : part));
