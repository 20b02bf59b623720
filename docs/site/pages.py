# SPDX-License-Identifier: MIT
"""Pages of the site: reads the Markdown files of the repository, checks their titles and links, and writes them for Sphinx.

In the repository, links to samples and sources are relative paths. The site has a page for each sample and other
files as downloads, so links are rewritten. The first use of a glossary term on a page becomes a link to its definition.
"""
import os
import re
import shutil
from pathlib import Path

LINK = re.compile(r"(!?)\[((?:[^][]|\[[^][]*\])*)\]\(([^)\s]+)\)")
FENCE = re.compile(r"^(```|~~~)")
AUDIENCE = re.compile(r"\bfor\b")
HEADING = re.compile(r"^(#{1,6}) +(.*?) *$")
GLOSSARY = "reference/glossary.md"
MAX_LINES = 250
# Pages that were renamed: former name -> page. The site has a redirection at each former address.
REDIRECTS = {
    "analyse": "how-to/analyse", "architecture": "explanation/architecture", "build_systems": "how-to/build-systems",
    "checking": "explanation/semantics", "ci": "how-to/ci", "compare": "how-to/compare", "components": "how-to/write-components",
    "conformance": "how-to/test-a-plc", "drawing": "how-to/draw", "editors": "how-to/editors", "engines": "explanation/timed-engine",
    "explosion": "how-to/large-models", "files": "reference/files", "import": "how-to/import", "install": "how-to/install",
    "language": "reference/language", "library": "how-to/cpp", "lsp": "how-to/language-server", "ltsmin": "how-to/ltsmin",
    "method": "explanation/method", "modelling-operators": "how-to/modelling-operators", "mutate": "how-to/mutate",
    "papers": "explanation/case-study", "performance": "explanation/performance", "properties": "reference/properties",
    "python": "how-to/python", "report": "how-to/report", "robustness": "explanation/robustness", "serve": "how-to/serve",
    "st": "how-to/structured-text", "supervise": "how-to/supervise", "trace": "reference/trace-format",
    "untimed": "explanation/untimed", "versions": "reference/versions", "why": "explanation/why",
}
REDIRECTION = """<!DOCTYPE html>
<html lang="en"><head><meta charset="utf-8"><title>Page moved</title>
<meta http-equiv="refresh" content="0; url={0}"><link rel="canonical" href="{0}"></head>
<body><p>This page has moved to <a href="{0}">{0}</a>.</p></body></html>
"""


def slug(heading):
    """Returns the anchor of a heading, as GitHub and MyST compute it."""
    text = re.sub(r"\[([^]]*)\]\([^)]*\)", r"\1", heading).replace("`", "").replace("*", "").lower()
    return re.sub(r"[^\w\- ]", "", text).strip().replace(" ", "-")


def absolute(path):
    """Returns the absolute `path` without `..`; symbolic links are not resolved."""
    return Path(os.path.abspath(path))


def prose(text):
    """Yields (number, line, True if inside a fenced block) for each line of `text`."""
    inside = False
    for number, line in enumerate(text.split("\n"), 1):
        fence = FENCE.match(line) is not None
        yield number, line, inside or fence
        if fence:
            inside = not inside


def headings(text):
    return [(number, len(match[1]), match[2]) for number, line, code in prose(text) if not code and (match := HEADING.match(line))]


def introduction(text):
    """Returns the first paragraph after the title."""
    lines = []
    for _, line, code in prose(text):
        if not code and not line.startswith("#") and (line.strip() or lines):
            if not line.strip():
                break
            lines.append(line)
    return " ".join(lines)


def anchors(text):
    found = set()
    for _, _, title in headings(text):
        name, count = slug(title), 1
        while name in found:
            name, count = f"{slug(title)}-{count}", count + 1
        found.add(name)
    return found


class Site:
    def __init__(self, root, target):
        self.root, self.target, self.problems = Path(root), Path(target), []
        self.pages = {}  # path in the site -> path in the repository
        for path in sorted((self.root / "docs").rglob("*.md")):
            self.pages[path.relative_to(self.root / "docs").as_posix()] = path
        for path in sorted((self.root / "samples").glob("*/README.md")):
            self.pages[f"samples/{path.parent.name}.md"] = path
        self.places = {absolute(path): place for place, path in self.pages.items()}
        self.texts = {place: path.read_text() for place, path in self.pages.items()}
        self.extra_anchors = {}  # anchors of generated parts of pages
        self.terms = self.read_terms()

    def problem(self, place, number, message):
        path = self.pages.get(place, place)
        shown = path.relative_to(self.root) if isinstance(path, Path) else path
        self.problems.append(f"{shown}:{number}: {message}")

    def read_terms(self):
        """Returns the terms of the glossary, each with its anchor; `Term (other form)` defines both forms."""
        terms = {}
        for _, level, title in headings(self.texts.get(GLOSSARY, "")):
            if level == 2:
                main, _, others = title.partition(" (")
                for term in filter(None, [main, *others.rstrip(")").split(", ")]):
                    for form in [term, term + "s", term + "es"]:
                        terms[form.lower()] = slug(title)
        for form in ["run", "runs"]:  # these words mostly have another meaning
            terms.pop(form, None)
        return terms

    def check(self):
        for place, text in self.texts.items():
            titles = headings(text)
            if not titles or titles[0][1] != 1:
                self.problem(place, 1, "the page has no title; begin it with `# Title`")
            elif len([1 for _, level, _ in titles if level == 1]) > 1:
                self.problem(place, titles[0][0], "the page has several titles; keep one `# Title`")
            if text.count("\n") > MAX_LINES and not place.startswith("samples/"):
                self.problem(place, MAX_LINES, f"the page has more than {MAX_LINES} lines; split it")
            if not place.startswith("samples/") and not AUDIENCE.search(introduction(text)):
                self.problem(place, 1, "the page does not state its audience; begin it with its purpose and `It is for ...`")
            for number, line, code in prose(text):
                if not code:
                    for match in LINK.finditer(re.sub(r"`[^`]*`", lambda code: " " * len(code[0]), line)):
                        self.check_link(place, number, match[3])
        for name, page in REDIRECTS.items():
            if f"{name}.md" in self.texts or f"{page}.md" not in self.texts:
                self.problems.append(f"docs/site/pages.py: redirection from `{name}` to `{page}`; the former page exists, or the new one does not")
        for name in ["README.md", "CONTRIBUTING.md"]:
            if (self.root / name).exists():
                for number, line, code in prose((self.root / name).read_text()):
                    for match in LINK.finditer(line) if not code else []:
                        target, _, anchor = match[3].partition("#")
                        if "://" in target or not target:
                            continue
                        path = absolute(self.root / target)
                        if not path.exists():
                            self.problems.append(f"{name}:{number}: broken link `{match[3]}`; no such file")
                        elif anchor and path in self.places and anchor not in self.all_anchors(self.places[path]):
                            self.problems.append(f"{name}:{number}: broken link `{match[3]}`; no such heading")

    def all_anchors(self, place):
        return anchors(self.texts[place]) | self.extra_anchors.get(place, set())

    def check_link(self, place, number, link):
        target, _, anchor = link.partition("#")
        if "://" in target or target.startswith("mailto:"):
            return
        path = absolute(self.pages[place].parent / target) if target else absolute(self.pages[place])
        if not path.exists():
            self.problem(place, number, f"broken link `{link}`; no such file")
        elif anchor and path in self.places and anchor not in self.all_anchors(self.places[path]):
            self.problem(place, number, f"broken link `{link}`; no such heading")

    def link_in_site(self, place, link):
        """Converts `link` of a page to a link between pages or files of the site."""
        target, hash_, anchor = link.partition("#")
        if "://" in target or not target:
            return link
        path = absolute(self.pages[place].parent / target)
        if path.is_dir():
            path = path / "README.md" if (path / "README.md").exists() else None
            if path is None:
                return os.path.relpath("gallery.md", Path(place).parent)
        if path in self.places:
            there = self.places[path]
        else:
            inner = path.relative_to(absolute(self.root))
            there = inner.relative_to("docs").as_posix() if inner.parts[0] == "docs" else f"files/{inner.as_posix()}"
            copy = self.target / there
            copy.parent.mkdir(parents=True, exist_ok=True)
            shutil.copyfile(path, copy)
        return os.path.relpath(there, Path(place).parent) + hash_ + anchor

    def with_terms(self, place, line, seen):
        """Links the first use of each glossary term on the page; headings, tables, code and links stay as they are."""
        if place == GLOSSARY or not self.terms or line.startswith(("#", "|", "    ", "<")):
            return line
        parts = re.split(r"(`[^`]*`|!?\[(?:[^][]|\[[^][]*\])*\]\([^)]*\))", line)
        home = os.path.relpath(GLOSSARY, Path(place).parent)

        def linked(match):
            anchor = self.terms[match[0].lower()]
            if anchor in seen:
                return match[0]
            seen.add(anchor)
            return f"[{match[0]}]({home}#{anchor})"

        words = "|".join(re.escape(term) for term in sorted(self.terms, key=len, reverse=True))
        pattern = re.compile(rf"(?<![\w-])(?:{words})(?![\w-])", re.IGNORECASE)
        return "".join(part if index % 2 else pattern.sub(linked, part) for index, part in enumerate(parts))

    def contents(self):
        """Returns the tables of contents of the front page for Sphinx: the links of each section of index.md, in
        order."""
        sections, lines = [], []
        for _, line, code in prose(self.texts.get("index.md", "")):
            heading = None if code else HEADING.match(line)
            if heading and len(heading[1]) == 2:
                sections.append((heading[2], []))
            elif sections and not code:
                sections[-1][1].extend((words, target) for bang, words, target in LINK.findall(line) if not bang and target.endswith(".md"))
        listed = [target for _, links in sections for _, target in links]
        for place in self.texts:
            if place not in [*listed, "index.md"] and not place.startswith("samples/"):
                self.problem("index.md", 1, f"`{place}` is not linked; add it to the section that it belongs to")
        for title, links in sections:
            lines += ["", "```{toctree}", ":hidden:", f":caption: {title}", ""]
            lines += [f"{words[:1].upper() + words[1:]} <{target.removesuffix('.md')}>" for words, target in links]
            lines += ["```"]
        samples = [f"{place.removesuffix('.md')}" for place in self.texts if place.startswith("samples/")]
        return "\n".join([*lines, "", "```{toctree}", ":hidden:", ":caption: Samples", "", *samples, "```", ""])

    def write(self, generated):
        """Writes all pages below `target`; `generated` maps a page to the Markdown that is appended to it."""
        (self.target / "redirections").mkdir()
        for name, page in REDIRECTS.items():
            (self.target / f"redirections/{name}.html").write_text(REDIRECTION.format(f"{page}.html"))
        for place in [*self.texts, *(set(generated) - set(self.texts))]:
            seen, lines = set(), []
            for _, line, code in prose(self.texts.get(place, "")):
                if not code:
                    line = LINK.sub(lambda m: f"{m[1]}[{m[2]}]({self.link_in_site(place, m[3])})", line)
                    line = self.with_terms(place, line, seen)
                elif line.startswith("```console"):
                    line = "```console"
                elif line.startswith("```grafcet"):
                    line = "```text"
                lines.append(line)
            path = self.target / place
            path.parent.mkdir(parents=True, exist_ok=True)
            path.write_text("\n".join(lines) + ("\n" + generated[place] if place in generated else ""))
