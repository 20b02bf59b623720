// SPDX-License-Identifier: MIT
// Switches between the automatic, dark and light theme. Debian's Furo ships its script as a module, which browsers do not load
// from files; this one also works without a server.
document.addEventListener("DOMContentLoaded", () => {
    const themes = ["auto", "dark", "light"];
    document.documentElement.classList.remove("no-js");
    for (const button of document.querySelectorAll(".theme-toggle"))
        button.addEventListener("click", () => {
            const next = themes[(themes.indexOf(document.body.dataset.theme) + 1) % themes.length];
            document.body.dataset.theme = next;
            localStorage.setItem("theme", next);
        });
});
