// SPDX-License-Identifier: MIT
// Switches between the automatic, dark and light theme. This script replaces two functions of Debian's Furo: its script
// is a module, which browsers do not load from `file:` addresses, and its style sheet ignores the colour scheme of the
// browser.
const themes = ["auto", "dark", "light"];
const darkScheme = window.matchMedia("(prefers-color-scheme: dark)");

function storedTheme() {
    const theme = localStorage.getItem("theme");
    return themes.includes(theme) ? theme : "auto";
}

function applyTheme() {
    const theme = storedTheme();
    document.body.dataset.theme = theme === "auto" && darkScheme.matches ? "dark" : theme;
}

applyTheme();
darkScheme.addEventListener("change", applyTheme);
document.documentElement.classList.remove("no-js");
for (const button of document.querySelectorAll(".theme-toggle"))
    button.addEventListener("click", () => {
        localStorage.setItem("theme", themes[(themes.indexOf(storedTheme()) + 1) % themes.length]);
        applyTheme();
    });
