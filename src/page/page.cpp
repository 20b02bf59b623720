// SPDX-License-Identifier: MIT
#include "page/page.hpp"

#include "page/data.hpp"
#include "page/html.hpp"
#include "page/parts.hpp"
#include "page/web.hpp"

namespace grafverif {

namespace {

/// Returns the content security policy. It permits only the style and the script of the document.
std::string policy() {
    return "default-src 'none'; script-src 'sha256-" + std::string(page_script().sha256) + "'; style-src 'sha256-" +
           std::string(page_style().sha256) + "'; base-uri 'none'; form-action 'none'";
}

void add_contents(const PageContent& content, Html& html) {
    html.open("nav", {{"aria-label", "Sections"}}).open("ul");
    const auto add = [&html](const char* id, const char* title) {
        html.open("li").put("a", title, {{"href", std::string("#") + id}}).close("li");
    };
    add("verdicts", "Properties");
    if (!playable_runs(content).empty()) add("runs", "Runs");
    add("charts", "Charts");
    add("findings", "Findings");
    if (content.loop.valid()) add("plant", "Plant");
    add("equations", "Equations");
    add("coverage", "Coverage");
    html.close("ul").close("nav");
}

}  // namespace

std::string page_of(const PageContent& content) {
    Html html;
    html.trusted("<!DOCTYPE html>\n").open("html", {{"lang", "en"}}).open("head");
    html.open("meta", {{"charset", "utf-8"}})
        .open("meta", {{"http-equiv", "Content-Security-Policy"}, {"content", policy()}})
        .open("meta", {{"name", "viewport"}, {"content", "width=device-width, initial-scale=1"}})
        .open("meta", {{"name", "color-scheme"}, {"content", "light dark"}})
        .open("meta", {{"name", "generator"}, {"content", "grafverif " + content.version}});
    html.put("title", content.report.model + " - grafverif");
    html.trusted("<style>").trusted(page_style().text).trusted("</style>\n").close("head");
    html.open("body");
    add_head(content, html);
    add_contents(content, html);
    html.open("main");
    add_verdicts(content, html);
    add_runs(content, html);
    add_charts(content, html);
    add_findings(content, html);
    add_plant(content, html);
    add_equations(content, html);
    add_coverage(content, html);
    html.close("main");
    html.open("script", {{"type", "application/json"}, {"id", "data"}}).trusted(page_data(content)).close("script");
    html.open("script", {{"type", "module"}}).trusted(page_script().text).close("script");
    html.close("body").close("html");
    return html.str();
}

}  // namespace grafverif
