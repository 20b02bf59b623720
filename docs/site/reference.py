# SPDX-License-Identifier: MIT
"""Generated parts of the reference: commands, diagnostics, components, Python API, gallery.

Each function returns Markdown and appends undocumented items to `problems`.
"""
import ast
import json
import re
import subprocess
from xml.etree import ElementTree

import automaton

# -- commands ---------------------------------------------------------------------------------------------------------


def run(program, *arguments, cwd=None):
    done = subprocess.run([str(program), *arguments], cwd=cwd, capture_output=True, text=True, timeout=300)
    return done.stdout


def plain(roff):
    """Returns a line of a manual page without its markup; bold words become code."""
    text = re.sub(r"\\fB(.*?)\\fR", r"`\1`", roff)
    text = re.sub(r"\\fI(.*?)\\fR", r"\1", text)
    return text.replace("\\-", "-").replace("\\&", "").replace("\\(aq", "'").replace("\\e", "\\")


def sections(page):
    """Returns the sections of a manual page: name -> lines."""
    found, name = {}, ""
    for line in page.splitlines():
        if line.startswith(".SH "):
            name = line[4:].strip('"')
            found[name] = []
        elif name:
            found[name].append(line)
    return found


def tagged(lines):
    """Returns the (.TP tag, text) pairs of a section."""
    pairs, wants_tag = [], False
    for line in lines:
        if line == ".TP":
            wants_tag = True
        elif wants_tag:
            pairs.append([line, []])
            wants_tag = False
        elif pairs and not line.startswith("."):
            pairs[-1][1].append(line)
    return [(re.sub(r"\\f[BIR]", "", tag).replace("\\-", "-"), plain(" ".join(text)).strip()) for tag, text in pairs]


def paragraphs(lines):
    return plain("\n".join("" if line.startswith(".PP") else line for line in lines if not line.startswith((".nf", ".fi"))))


def cell(text):
    return text.replace("|", "\\|")


def commands(program):
    """Returns the commands of the program: name -> one line that describes it."""
    overview = sections(run(program, "manual"))
    known = overview.get("COMMANDS") or overview.get("VERBS") or []
    return {tag.split("(")[0].removeprefix("grafverif-"): text for tag, text in tagged(known)}


def options_of(page):
    return tagged(sections(page).get("OPTIONS", []))


def commands_page(program, problems):
    known = commands(program)
    if not known:
        problems.append("grafverif manual: no commands found")
    pages = {name: run(program, "manual", name) for name in known}
    options = {name: options_of(page) for name, page in pages.items()}
    uses = {}
    for name, rows in options.items():
        for row in rows:
            uses.setdefault(row, []).append(name)
        if not known[name]:
            problems.append(f"grafverif {name}: undocumented command; give it a summary")
        for tag, text in rows:
            if not text:
                problems.append(f"grafverif {name}: undocumented option `{tag}`; give it a help text in src/app/option_table.cpp")
    common = {row for row, names in uses.items() if len(names) >= len(known) - 2}

    def table(rows):
        return ["| Option | Effect |", "| --- | --- |"] + [f"| `{cell(tag)}` | {cell(text)} |" for tag, text in rows] + [""]

    lines = ["", "## Commands", "", "| Command | Purpose |", "| --- | --- |"]
    lines += [f"| [{name}](#grafverif-{name}) | {cell(text)} |" for name, text in known.items()]
    lines += ["", "## Common options", ""] + table([row for row in uses if row in common])
    for name, page in pages.items():
        part = sections(page)
        synopsis = re.sub(r"\\f[BIR]", "", " ".join(part.get("SYNOPSIS", []))).replace(".B ", "").replace(".I ", "").replace("\\-", "-")
        lines += [f"## grafverif {name}", "", "```text", synopsis, "```", "", paragraphs(part.get("DESCRIPTION", [])), ""]
        own = [row for row in options[name] if row not in common]
        if own:
            lines += table(own)
        if part.get("EXAMPLES"):
            shown = [line.strip().replace("\\-", "-").replace("\\e", "\\") for line in part["EXAMPLES"] if not line.startswith(".")]
            lines += ["Examples:", "", "```text", *shown, "```", ""]
    status = tagged(sections(run(program, "manual")).get("EXIT STATUS", []))
    if status:
        lines += ["## Exit status", "", "| Code | Meaning |", "| --- | --- |"] + [f"| {tag} | {cell(text)} |" for tag, text in status] + [""]
    return "\n".join(lines)


# -- diagnostics ------------------------------------------------------------------------------------------------------

LITERAL = re.compile(r'"((?:[^"\\]|\\.)*)"')


def templates(source):
    """Yields (level, code, message template) of each diagnostic in a source of src/support/messages*.cpp.

    The template joins the string literals of the first message; values are shown as `...`.
    """
    text = re.sub(r"^\s*//.*$", "", source, flags=re.M)
    for match in re.finditer(r'\b(error|warning)\(\s*"([a-z0-9-]+)"', text):
        begin = text.rfind("\n}", 0, match.start())
        end = text.find("\n}", match.end())
        tail = text[match.end() : end]
        local = text[max(begin, 0) : match.start()]
        words, last = [], None
        for literal in LITERAL.finditer(tail):
            gap = tail[last : literal.start()] if last is not None else ""
            if words and gap.strip():
                if len("".join(words)) > 12:
                    break
                words = []
            words.append(literal[1])
            last = literal.end()
        message = "".join(words)
        if len(message) < 12:  # the message is composed in an earlier statement
            message = "".join(max((m for m in re.findall(r'((?:"(?:[^"\\]|\\.)*"\s*)+)', local)), key=len, default=""))
            message = "".join(LITERAL.findall(message))
        yield match[1], match[2], re.sub(r"`?\{[^}]*\}`?", "`…`", message).replace('\\"', '"').replace("\\\\", "\\").strip()


HEADER = re.compile(r"^(?P<file>[\w./-]+?\.\w+)(?::\d+:\d+)?: (?P<level>error|warning): (?P<message>.*) \[(?P<code>[a-z0-9-]+)\]$")


def examples(folder):
    """Returns code -> (file, printed text) of the smallest test that shows the diagnostic; the test named after the
    code is preferred."""
    found = {}
    for expected in sorted(folder.glob("*.expected")):
        source = expected.with_suffix(".grafcet")
        blocks, current = [], None
        for line in expected.read_text().splitlines():
            header = HEADER.match(line)
            if header:
                current = [header["code"], header["level"], header["message"], [line]]
                blocks.append(current)
            elif current:
                current[3].append(line)
        for code, level, message, shown in blocks:
            rank = (re.sub(r"-\d+$", "", expected.stem) != code, source.stat().st_size if source.exists() else 0)
            if code not in found or rank < found[code][0]:
                found[code] = (rank, source, level, message, shown)
    return found


def diagnostics_page(root, problems):
    known = {}
    for path in sorted((root / "src/support").glob("messages*.cpp")):
        for level, code, message in templates(path.read_text()):
            if code not in known or len(message) > len(known[code][1]):
                known[code] = (level, message)
    shown = examples(root / "tests/diagnostics")
    codes = sorted({*known, *shown})  # some codes, such as `unknown-variable`, are composed at run time
    lines = ["", "## Index", "", ", ".join(f"[{code}](#{code})" for code in codes), ""]
    for code in codes:
        level, message = known.get(code, ("error", ""))
        example = shown.get(code)
        if example:
            level, message = example[2], example[3]
        if not message:
            problems.append(f"undocumented diagnostic `{code}`; add tests/diagnostics/{code}.grafcet")
            continue
        cause, _, remedy = message.partition("; ")
        lines += [f"## {code}", "", f"**{level.capitalize()}.** {sentence(cause)}", ""]
        if remedy:
            lines += [f"**Remedy:** {sentence(remedy)}", ""]
        if example:
            source = example[1].read_text(errors="replace")
            if source.count("\n") <= 40 and source.isprintable() is False and "\x00" not in source:
                lines += ["Example:", "", "````text", *printable(source), "````", ""]
            lines += ["Output:", "", "````text", *printable("\n".join(example[4])), "````", ""]
    return "\n".join(lines), codes


def sentence(text):
    text = text.strip()
    text = text[:1].upper() + text[1:] if not text.startswith("`") else text
    return text if text.endswith((".", "?")) else text + "."


def printable(text):
    """Returns the lines of `text` without the licence line; unprintable characters are replaced."""
    clean = "".join(c if c == "\n" or c.isprintable() else "\N{REPLACEMENT CHARACTER}" for c in text.replace("\t", "    "))
    return [line for line in clean.rstrip("\n").split("\n") if "SPDX-License" not in line and not line.startswith("````")]


# -- components -------------------------------------------------------------------------------------------------------


def components_page(root, program, target, problems):
    lines = []
    for path in sorted((root / "templates").glob("*.grafcet")):
        name, comment, body = path.stem, [], []
        for line in path.read_text().splitlines():
            if line.startswith("//") and not body:
                comment.append(line[2:].removeprefix(" "))
            elif line.strip():
                body.append(line)
        parts, heading = {"": []}, ""
        for line in comment:
            if line in ("Interface", "Behaviour", "Assumptions", "Source"):
                heading = line
                parts[heading] = []
            elif not line.startswith("SPDX"):
                parts[heading].append(line.strip())
        lines += [f"## {name}", "", " ".join(filter(None, parts[""])), ""]
        described = {row.split()[0]: row.split(None, 2) for row in parts.get("Interface", []) if len(row.split()) > 2}
        data = json.loads(run(program, "components", name, "--format", "json"))
        lines += ["| Name | Kind | Type | Meaning |", "| --- | --- | --- | --- |"]
        for port in data.get("parameters", []):
            row = described.get(port["name"])
            if row is None:
                problems.append(f"templates/{path.name}: undocumented parameter `{port['name']}`; describe it under Interface")
                row = ["", "", ""]
            lines.append(f"| `{port['name']}` | {port['kind']} | {port.get('type') or ''} | {cell(row[2])} |")
        lines += [""]
        for part in ("Behaviour", "Assumptions", "Source"):
            if parts.get(part):
                lines += [f"**{part}.** " + " ".join(filter(None, parts[part])), ""]
        drawing = automaton.svg("\n".join(body))
        if drawing:
            (target / "components").mkdir(parents=True, exist_ok=True)
            (target / "components" / f"{name}.svg").write_text(drawing)
            lines += [f"![Automaton of {name}](../components/{name}.svg)", ""]
    return "\n".join(lines)


# -- Python -----------------------------------------------------------------------------------------------------------


def broken(call, width=88):
    """Returns the lines of a signature, broken after commas outside brackets to at most `width` characters."""
    if len(call) <= width:
        return [call]
    rows, row, depth = [], "", 0
    indent = " " * (call.index("(") + 1)
    for piece in re.split(r"(?<=, )", call):
        if depth <= 1 and row.strip() and len(row) + len(piece) > width:
            rows.append(row.rstrip())
            row = indent
        row += piece
        depth += sum(piece.count(c) for c in "([{") - sum(piece.count(c) for c in ")]}")
    return [*rows, row]


def python_page(path, problems):
    """Returns the public classes and functions of the package with their docstrings."""
    tree = ast.parse(path.read_text())
    lines = []

    def entry(node, prefix, level):
        if node.name.startswith("_") and node.name != "__init__":
            return
        if isinstance(node, ast.ClassDef):
            lines.extend(["#" * level + f" {node.name}", ""])
        else:
            arguments = ast.unparse(node.args)
            arguments = re.sub(r"^(self|cls)(, )?", "", arguments)
            result = f" -> {ast.unparse(node.returns)}" if node.returns and node.name != "__init__" else ""
            head = prefix.rstrip(".") if node.name == "__init__" else prefix + node.name
            if any(ast.unparse(d) == "property" for d in node.decorator_list):
                call = f"{head}: {ast.unparse(node.returns)}" if node.returns else head
            else:
                call = f"{head}({arguments}){result}"
            lines.extend(["```text", *broken(call), "```", ""])
        text = ast.get_docstring(node)
        if text:
            lines.extend([re.sub(r"(?<!`)<", "&lt;", text), ""])
        elif isinstance(node, ast.ClassDef) or not prefix:
            problems.append(f"{path.name}: `{prefix}{node.name}` has no docstring")
        if isinstance(node, ast.ClassDef):
            for inner in node.body:
                if isinstance(inner, (ast.FunctionDef, ast.ClassDef)):
                    entry(inner, f"{node.name}.", level + 1)

    functions = [n for n in tree.body if isinstance(n, ast.FunctionDef) and not n.name.startswith("_")]
    classes = [n for n in tree.body if isinstance(n, ast.ClassDef) and not n.name.startswith("_")]
    if functions:
        lines += ["", "## Functions", ""]
    for node in functions + classes:
        entry(node, "", 2)
    return "\n".join(lines)


# -- C++ --------------------------------------------------------------------------------------------------------------


def headers(root):
    """Returns the public headers below include/, the main header first."""
    found = [path.relative_to(root / "include").as_posix() for path in (root / "include").rglob("*.hpp")]
    return sorted(found, key=lambda name: (name.count("/"), name))


def doxygen(root, target):
    """Writes the XML of Doxygen for the public headers below `target`."""
    settings = {"INPUT": root / "include", "RECURSIVE": "YES", "OUTPUT_DIRECTORY": target, "GENERATE_XML": "YES",
                "GENERATE_HTML": "NO", "GENERATE_LATEX": "NO", "QUIET": "YES", "WARNINGS": "NO", "EXTRACT_ALL": "YES",
                "STRIP_FROM_PATH": root / "include", "XML_PROGRAMLISTING": "NO", "AUTOLINK_SUPPORT": "NO"}
    text = "\n".join(f"{name} = {value}" for name, value in settings.items())
    subprocess.run(["doxygen", "-"], input=text, text=True, check=True, timeout=300)


def introduction(path):
    """Returns the comment at the head of a header."""
    lines = []
    for line in path.read_text().splitlines():
        if not line.startswith("//"):
            break
        if "SPDX" not in line:
            lines.append(line[2:].removeprefix(" "))
    return lines


def words_of(element):
    return " ".join("".join(element.itertext()).split()) if element is not None else ""


def cpp_page(root, xml):
    """Returns one section per public header with its introduction and its declarations; breathe inserts the types.

    Functions are generated from the XML, because breathe requires the exact arguments to find an overload.
    """
    declared = {}  # header -> directives
    for path in sorted(xml.glob("*.xml")):
        for compound in ElementTree.parse(path).getroot().iter("compounddef"):
            kind, name = compound.get("kind"), words_of(compound.find("compoundname"))
            location = compound.find("location")
            if kind in ("struct", "class") and location is not None and "::detail" not in name and "<" not in name:
                place = location.get("file", "")
                declared.setdefault(place, []).append((int(location.get("line", 0)), [f".. doxygen{kind}:: {name}", "   :members:"]))
            for member in compound.iter("memberdef") if kind == "namespace" else []:
                location = member.find("location")
                row = []
                if member.get("kind") == "enum" and words_of(member.find("name")):
                    row = [f".. doxygenenum:: {words_of(member.find('qualifiedname'))}"]
                elif member.get("kind") == "function" and "operator" not in words_of(member.find("name")):
                    declaration = words_of(member.find("definition")) + words_of(member.find("argsstring"))
                    if member.find("templateparamlist") is None:
                        row = [f".. cpp:function:: {declaration}", "", "   " + words_of(member.find("briefdescription"))]
                if row:
                    declared.setdefault(location.get("file", ""), []).append((int(location.get("line", 0)), row))
    lines = []
    for name in headers(root):
        lines += [f"## {name}", "", "```text", *introduction(root / "include" / name), "```", ""]
        rows = next((rows for place, rows in declared.items() if place.endswith(name)), [])
        inner = {row[0].split(":: ")[1] for _, row in rows if "struct::" in row[0] or "class::" in row[0]}
        for _, row in sorted(rows):
            if row[0].split(":: ")[1].rpartition("::")[0] not in inner:
                lines += ["```{eval-rst}", *row, "```", ""]
    return "\n".join(lines)


# -- gallery ----------------------------------------------------------------------------------------------------------


def folded(rows):
    """Merges the rows for `reachable all steps` that have the same verdict."""
    found = {}
    for row in rows:
        name = re.sub(r"\.[^.]*X\w+$", "", row["property"])
        found.setdefault((name, row["verdict"]), {**row, "property": name})
    return list(found.values())


def gallery_page(root, program, target, timeout="60s"):
    lines = []
    for path in sorted((root / "samples").glob("*/*.grafcet")):
        place = path.relative_to(root).as_posix()
        limits = ["--json-lines", "--timeout", timeout, "--max-states", "20000000"]
        for command in [["check", place, "--all"], ["check", place, "--untimed", "--plant", "automata"]]:
            shown = run(program, *command, *limits, cwd=root)
            rows = [json.loads(line) for line in shown.splitlines() if line.startswith("{")]
            rows = folded([row for row in rows if row.get("property")])
            if sum(row["verdict"] == "unknown" for row in rows) * 2 < len(rows) or not rows:
                break
        title = path.stem if path.stem == path.parent.name else f"{path.parent.name}/{path.stem}"
        lines += [f"## {title}", "", f"Source and explanation: [{place}](samples/{path.parent.name}.md).", ""]
        picture = path.with_suffix(".svg")
        if picture.exists():
            copy = target / "drawings" / f"{path.parent.name}_{picture.name}"
            copy.parent.mkdir(parents=True, exist_ok=True)
            copy.write_text(picture.read_text())
            lines += [f"![{path.stem}](drawings/{copy.name})", ""]
        if rows:
            lines += [f"`grafverif {' '.join(command)}`", ""]
            lines += ["| Property | Meaning | Verdict | States | Time |", "| --- | --- | --- | --- | --- |"]
            for row in rows:
                meaning = row.get("text") or ""
                seconds = row.get("seconds")
                time = "" if seconds is None else f"{seconds * 1000:.1f} ms" if seconds < 1 else f"{seconds:.1f} s"
                states = f"{row['states']:,}" if row.get("states") is not None else ""
                lines.append(f"| `{row['property']}` | {cell(meaning)} | {row['verdict']} | {states} | {time} |")
            lines += [""]
    return "\n".join(lines)
