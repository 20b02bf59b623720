# SPDX-License-Identifier: MIT
"""Draws the automaton of a component with Graphviz, in colours for the light and the dark theme."""
import re
import shutil
import subprocess
from html import escape


def parts(body):
    """Returns the locations and edges of a component given in canonical text."""
    locations, edges = [], []
    for statement in re.split(r"[;{}]", body):
        statement = " ".join(statement.split())
        location = re.fullmatch(r"(initial )?(urgent )?location (\w+)(?: invariant (.*?))?(?: with (.*))?", statement)
        edge = re.fullmatch(r"(urgent|timed) (\w+) -> (\w+)(.*)", statement)
        if location:
            locations.append((location[3], bool(location[1]), location[4] or "", location[5] or ""))
        elif edge:
            label = edge[4].strip()
            guard = re.search(r"when (.*?)(?: do |$)", label)
            action = re.search(r"\bdo (.*)$", label)
            edges.append((edge[2], edge[3], edge[1], guard[1] if guard else "", action[1] if action else ""))
    return locations, edges


def dot(body):
    locations, edges = parts(body)
    lines = ["digraph {", 'bgcolor="transparent"; rankdir=LR; nodesep=0.5; ranksep=0.9;',
             'node [shape=box, style=rounded, fontname="sans-serif", fontsize=11];',
             'edge [fontname="sans-serif", fontsize=10];', "_start [shape=point, width=0.08];"]
    for name, initial, invariant, start in locations:
        label = f"<b>{escape(name)}</b>" + (f"<br/>{escape(invariant)}" if invariant else "")
        lines.append(f'"{name}" [label=<{label}>];')
        if initial:
            lines.append(f'_start -> "{name}" [label=<{wrapped(start) or " "}>];')
    for source, target, kind, guard, action in edges:
        rows = [wrapped(row) for row in [guard, action] if row]
        label = "<br/>".join(rows) or " "
        style = ', style="dashed"' if kind == "timed" else ""
        lines.append(f'"{source}" -> "{target}" [label=<{label}>{style}];')
    return "\n".join(lines + ["}"])


def wrapped(text, width=34):
    """Breaks a long guard or list of assignments at operators."""
    rows, row = [], ""
    for piece in re.split(r"(?<=&&)|(?<=\|\|)|(?<=,)", text):
        if row and len(row) + len(piece) > width:
            rows.append(row)
            row = ""
        row += piece
    return "<br/>".join(escape(line.strip()) for line in [*rows, row])


def svg(body):
    """Returns the SVG of the automaton, or None if it has no locations or Graphviz is not installed."""
    if not parts(body)[0] or shutil.which("dot") is None:
        return None
    done = subprocess.run(["dot", "-Tsvg"], input=dot(body), capture_output=True, text=True, timeout=60)
    return done.stdout[done.stdout.index("<svg") :] if done.returncode == 0 and "<svg" in done.stdout else None
