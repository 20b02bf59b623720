// SPDX-License-Identifier: MIT
// Downloads of a drawing as SVG or PNG. A picture has light colours and contains the current highlights. A picture
// needs no style sheet, because the computed colours, lines and fonts are stored in its elements.
import {make} from "./dom.js";

const inherited = ["color", "fill", "fill-opacity", "font-family", "font-size", "font-style", "font-weight", "stroke",
                   "stroke-dasharray", "stroke-width", "text-anchor"];
const longest_side = 16000, most_pixels = 1e8;  // limits of browsers for the size of a picture

// Returns a copy of the drawing `svg` that needs no style sheet.
function pictureOf(svg) {
    const copy = svg.cloneNode(true), {width, height} = svg.viewBox.baseVal;
    for (const mark of copy.querySelectorAll("rect.find, rect.choice")) mark.remove();
    copy.style.cssText = "";
    copy.setAttribute("width", width);
    copy.setAttribute("height", height);
    for (const line of copy.querySelectorAll("[marker-end]")) {
        const id = line.getAttribute("marker-end").replace(/^url\("?#(.*?)"?\)$/, "$1"), tip = document.getElementById(id);
        if (tip && !copy.querySelector(`#${CSS.escape(id)}`)) copy.append(tip.cloneNode(true));
    }
    const place = make("div", {class: `${svg.parentElement.className} light picture`, "aria-hidden": "true"}, copy);
    document.body.append(place);
    // The styles are read before the attributes are changed, because the attributes change the styles.
    const styles = new Map();  // for each element: the values of the inherited properties
    for (const element of [copy, ...copy.querySelectorAll("*")]) {
        const style = getComputedStyle(element);
        styles.set(element, inherited.map((name) => style.getPropertyValue(name)));
    }
    for (const [element, values] of styles) {
        const above = styles.get(element.parentElement);
        inherited.forEach((name, k) => {
            if (above?.[k] === values[k]) element.removeAttribute(name);
            else element.setAttribute(name, values[k]);
        });
        for (const name of ["class", "style", "role", "aria-label", "data-element"]) element.removeAttribute(name);
        if (!element.matches("marker")) element.removeAttribute("id");
    }
    place.remove();
    return copy;
}

function fileName(name, type) { return `${name.replace(/[^\p{L}\p{M}\p{N}._-]+/gu, "-").replace(/^[-.]+|-+$/g, "") || "chart"}.${type}`; }

function save(address, name) { make("a", {href: address, download: name}).click(); }

// Downloads the drawing `svg` of the chart `name`. `type` is `svg` or `png`. Throws if the browser cannot write the
// drawing as PNG.
export async function savePicture(svg, name, type) {
    const copy = pictureOf(svg), text = new XMLSerializer().serializeToString(copy);
    if (type === "svg") {
        const address = URL.createObjectURL(new Blob([text], {type: "image/svg+xml"}));
        save(address, fileName(name, type));
        return setTimeout(() => URL.revokeObjectURL(address), 10000);
    }
    const {width, height} = svg.viewBox.baseVal, image = new Image();
    const scale = Math.min(2, longest_side / Math.max(width, height), Math.sqrt(most_pixels / (width * height)));
    image.src = `data:image/svg+xml;charset=utf-8,${encodeURIComponent(text)}`;
    await image.decode();
    const canvas = make("canvas", {width: Math.round(width * scale), height: Math.round(height * scale)});
    canvas.getContext("2d").drawImage(image, 0, 0, canvas.width, canvas.height);
    const address = canvas.toDataURL("image/png");
    if (!address.startsWith("data:image/png")) throw new Error("the canvas is too large");  // the address is `data:,`
    save(address, fileName(name, type));
}
