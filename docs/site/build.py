#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""build.py GRAFVERIF TARGET: writes the sources of the site below TARGET, for sphinx-build.

Prints one line per problem and fails if a page has no title, a link is broken, or a command, option, diagnostic or
parameter is undocumented. Sphinx is not needed. `--doxygen DIR` adds the C++ API, for which Doxygen writes XML into
DIR. `--quick` omits the gallery, whose verdicts take a minute.
"""
import argparse
import shutil
import sys
from pathlib import Path

import reference
from pages import Site, absolute, anchors


def generated_parts(site, root, program, target, quick):
    """Returns the generated parts of the reference: page -> Markdown."""
    parts, problems = {}, site.problems
    parts["reference/cli.md"] = reference.commands_page(program, problems)
    parts["reference/diagnostics.md"], _ = reference.diagnostics_page(root, problems)
    parts["reference/components.md"] = reference.components_page(root, program, target, problems)
    parts["reference/python-api.md"] = reference.python_page(root / "python/grafverif/__init__.py", problems)
    if not quick:
        parts["gallery.md"] = reference.gallery_page(root, program, target)
    return parts


def main():
    arguments = argparse.ArgumentParser(description=__doc__)
    arguments.add_argument("program", type=Path)
    arguments.add_argument("target", type=Path)
    arguments.add_argument("--root", type=Path, default=Path(__file__).resolve().parents[2])
    arguments.add_argument("--doxygen", type=Path)
    arguments.add_argument("--quick", action="store_true")
    given = arguments.parse_args()
    root = absolute(given.root)
    if given.target.exists():
        shutil.rmtree(given.target)
    given.target.mkdir(parents=True)
    site = Site(root, given.target)
    parts = {}
    if given.doxygen:
        reference.doxygen(root, given.doxygen)
        parts["reference/cpp-api.md"] = reference.cpp_page(root, given.doxygen / "xml")
    parts |= generated_parts(site, root, given.program.resolve(), given.target, given.quick)
    for place, text in parts.items():
        if place not in site.texts:
            site.problems.append(f"docs/{place}: the page is missing; its generated part needs a title and an introduction")
        site.extra_anchors[place] = anchors(text)
    site.check()
    parts["index.md"] = site.contents()
    if not site.problems:
        site.write(parts)
    for problem in site.problems:
        print(problem, file=sys.stderr)
    return 1 if site.problems else 0


if __name__ == "__main__":
    sys.exit(main())
