#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Reports unclear wording in documents, messages, comments and test names.

    language_lint.py [--all] [--count] [--update] [FILE...]

Each finding is printed as `file:line: phrase; write TERMS instead`. The terms are in language_terms.txt. Findings up to
the number in language_baseline.txt are tolerated; the lint fails if the number for a file and an area is exceeded.

    --all       print tolerated findings too
    --count     print the number of findings for each area and directory
    --update    lower the baseline to the present numbers; never raises a number

A comment `lint-ok: WORD` on the same line silences findings that contain WORD.
"""

import argparse
import bisect
import collections
import fnmatch
import io
import os
import pathlib
import re
import sys
import tokenize

HERE = pathlib.Path(__file__).resolve().parent
AREAS = {"D": "document", "M": "message", "C": "comment", "H": "header", "T": "test-name"}
MAX_WORDS = 30
SKIPPED_FOLDERS = re.compile(r"build(-.*)?|\..*|node_modules|__pycache__|corpus")
CPP = {".cpp", ".hpp", ".c", ".h"}


class Text:
    """A piece of prose: its characters, the line number of each character, and the area of the lint to which it
    belongs."""

    def __init__(self, area):
        self.area, self.parts, self.starts, self.lines, self.size = area, [], [], [], 0
        self.heading = False

    def add(self, text, line):
        self.parts.append(text)
        self.starts.append(self.size)
        self.lines.append(line)
        self.size += len(text)

    def line_at(self, offset):
        return self.lines[bisect.bisect_right(self.starts, offset) - 1]

    def __str__(self):
        return "".join(self.parts)


# -- terms ------------------------------------------------------------------------------------------------------------


class Term:
    def __init__(self, line):
        line, _, files = line.partition(" ! ")
        line, _, areas = line.partition(" @ ")
        pattern, _, self.remedy = (part.strip() for part in line.partition(" = "))
        self.areas = set(areas.strip() or "DMCT")
        if "C" in self.areas:
            self.areas.add("H")
        self.excepted = files.split()
        self.pattern = rf"\b(?:{pattern})\b"

    def applies(self, area, path):
        return area in self.areas and not any(fnmatch.fnmatch(path, glob) for glob in self.excepted)


class Terms:
    def __init__(self, lines):
        self.terms = [Term(line) for line in lines if line.strip() and not line.startswith("#")]
        self.compiled = {}

    def find(self, text, area, path):
        """Yields (start, end, remedy) of each phrase to replace."""
        chosen = tuple(i for i, term in enumerate(self.terms) if term.applies(area, path))
        if chosen not in self.compiled:
            joined = "|".join(f"(?P<t{i}>{self.terms[i].pattern})" for i in chosen)
            self.compiled[chosen] = re.compile(joined or r"(?!)", re.I)
        for match in self.compiled[chosen].finditer(text):
            yield match.start(), match.end(), self.terms[int(match.lastgroup[1:])].remedy


# -- texts of a file --------------------------------------------------------------------------------------------------


def markdown_texts(source, path):
    """Yields the prose of a Markdown document, without fenced blocks, code spans, link targets and HTML comments."""
    fenced, wanted, text = None, path != "CHANGELOG.md", None
    for number, line in enumerate(source.split("\n"), 1):
        fence = re.match(r"\s*(```+|~~~+)", line)
        boundary = fence and (fenced is None or line.strip().startswith(fenced))
        if boundary:
            fenced = fence.group(1) if fenced is None else None
        if path == "CHANGELOG.md" and line.startswith("## "):
            boundary, wanted = True, "unreleased" in line.lower()
        line = re.sub(r"\]\([^)]*\)|^\[[^\]]+\]: \S+|<!--.*?-->|<[^>]*>", "]", line)
        begins = re.match(r"\s*([-*+]|\d+[.)]|#+|\||>)(\s|$)|\s*$", line)
        if text is not None and (boundary or begins or text.heading):
            yield text
            text = None
        if boundary or fenced or not wanted:
            continue
        for cell in line.split("|") if line.startswith("|") else [re.sub(r"^\s*([-*+]|\d+[.)]|#+)\s", "", line)]:
            if line.startswith("|") and text is not None:
                yield text
                text = None
            text = text or Text("D")
            text.heading = line.startswith(("#", "|"))
            text.add(cell + "\n", number)
    if text is not None:
        yield text


CPP_TOKEN = re.compile(
    r'(?P<line>//[^\n]*)|(?P<block>/\*.*?\*/)|(?:u8|[uUL])?R"(?P<delimiter>[^()\\ ]{0,16})\((?P<raw>.*?)\)(?P=delimiter)"'
    r'|"(?P<string>(?:\\.|[^"\\\n])*)"|(?<![0-9A-Za-z_])\'(?:\\.|[^\'\\\n])+\'', re.S)
JS_TOKEN = re.compile(
    r'(?P<line>//[^\n]*)|(?P<block>/\*.*?\*/)|"(?P<string>(?:\\.|[^"\\\n])*)"|\'(?P<single>(?:\\.|[^\'\\\n])*)\''
    r'|`(?P<raw>(?:\\.|[^`\\])*)`|(?<=[(,=:\[!&|?{};+])\s*/(?![/*])(?:\\.|\[(?:\\.|[^\]\\\n])*\]|[^/\\\n])+/', re.S)
ESCAPES = {"n": "\n", "t": " ", '"': '"', "'": "'", "\\": "\\", "0": " ", "r": ""}
TEST_NAME = re.compile(r"^\s*(?:TYPED_)?TEST(?:_[FP])?\(\s*(\w+),\s*(\w+)", re.M)


def split_name(name):
    return re.sub(r"(?<=[a-z0-9])(?=[A-Z])|_", " ", name)


def code_texts(source, path, token):
    """Yields the string literals, comments and test names of a C++ or JavaScript source."""
    newlines = [match.start() for match in re.finditer("\n", source)]

    def line_of(offset):
        return bisect.bisect_left(newlines, offset) + 1

    comment_area = "H" if path.startswith("include/") else "C"
    messages = path.startswith(("src/", "web/", "python/", "include/"))
    literal, comment, end, column = None, None, 0, 0
    for match in token.finditer(source):
        groups = match.groupdict()
        between = source[end:match.start()]
        line = line_of(match.start())
        body = next((groups[name] for name in ("string", "single", "raw") if groups.get(name) is not None), None)
        if body is not None and messages:
            begin = source.rfind("\n", 0, match.start()) + 1
            if source[begin:match.start()].lstrip().startswith("#"):
                body = None
        if body is not None and messages:
            if literal is None or between.strip():
                if literal is not None:
                    yield literal
                literal = Text("M")
            if groups.get("raw") is not None:
                for index, piece in enumerate(body.split("\n")):
                    literal.add(piece + "\n", line_of(match.start("raw")) + index)
            else:
                literal.add(re.sub(r"\\(.)", lambda m: ESCAPES.get(m.group(1), m.group(1)), body, flags=re.S), line)
            end = match.end()
        elif groups["line"] is not None or groups["block"] is not None:
            begin = source.rfind("\n", 0, match.start()) + 1
            here = match.start() - begin
            alone = not source[begin:match.start()].strip()
            if comment is not None and (not alone or here != column or comment.lines[-1] + 1 != line):
                yield comment
                comment = None
            if groups["line"] is not None:
                if comment is None:
                    comment, column = Text(comment_area), here
                comment.add(re.sub(r"^///?<?!? ?", "", groups["line"]) + "\n", line)
            else:
                block = Text(comment_area)
                for index, piece in enumerate(groups["block"][2:-2].split("\n")):
                    block.add(re.sub(r"^\s*\*+ ?", "", piece) + "\n", line + index)
                yield block
            if literal is not None and not between.strip():
                end = match.end()
        else:
            continue
    if literal is not None:
        yield literal
    if comment is not None:
        yield comment
    for match in TEST_NAME.finditer(source) if path.startswith("tests/") else ():
        text = Text("T")
        text.add(split_name(match.group(1)) + ". " + split_name(match.group(2)), line_of(match.start(1)))
        yield text


def python_texts(source, path):
    """Yields the string literals (messages), comments, docstrings and test names of a Python source."""
    public = path.startswith("python/")
    comment, previous = None, None
    for item in tokenize.generate_tokens(io.StringIO(source).readline):
        line = item.start[0]
        if item.type == tokenize.COMMENT:
            if comment is not None and comment.lines[-1] + 1 != line:
                yield comment
                comment = None
            comment = comment or Text("C")
            comment.add(item.string.lstrip("#! ") + "\n", line)
            continue
        if item.type == tokenize.STRING:
            docstring = previous in (None, tokenize.NEWLINE, tokenize.INDENT, tokenize.DEDENT, tokenize.NL)
            if public or docstring:
                text = Text("M" if public else "C")
                body = re.sub(r"^\w*(\"\"\"|'''|\"|')|(\"\"\"|'''|\"|')$", "", item.string)
                for index, piece in enumerate(body.split("\n")):
                    text.add(piece.strip() + "\n", line + index)
                yield text
        if item.type == tokenize.NAME and item.string.startswith("test_"):
            text = Text("T")
            text.add(split_name(item.string), line)
            yield text
        if item.type != tokenize.NL or previous is None:
            previous = item.type
    if comment is not None:
        yield comment


def hash_texts(source, path):
    """Yields the comments that occupy complete lines, of CMake files and scripts."""
    text = None
    for number, line in enumerate(source.split("\n"), 1):
        match = re.match(r"\s*# ?(?!!)(.*)", line)
        if match is None:
            if text is not None:
                yield text
            text = None
            continue
        text = text or Text("C")
        text.add(match.group(1) + "\n", number)
    if text is not None:
        yield text


def texts_of(source, path):
    suffix = pathlib.PurePath(path).suffix
    if suffix == ".md":
        return markdown_texts(source, path)
    if suffix in CPP:
        return code_texts(source, path, CPP_TOKEN)
    if suffix == ".js":
        return code_texts(source, path, JS_TOKEN)
    if suffix in (".py", ".pyi"):
        return python_texts(source, path)
    if suffix in (".cmake", ".sh") or path.endswith("CMakeLists.txt") or source.startswith("#!"):
        return hash_texts(source, path)
    return ()


# -- findings ---------------------------------------------------------------------------------------------------------

CODE_SPAN = re.compile(r"``.*?``|`[^`\n]*`|`[^`]{1,80}`", re.S)
SENTENCE_END = re.compile(r"[.?!:;](?=\s|$)|\n\s*\n|\n {2,}|\n(?=[-*.<])")


def blank(match):
    """Replaces a code span by one word of the same length, so that offsets are unchanged."""
    text = match.group(0)
    return "".join("\n" if c == "\n" else "`" if 0 < i < len(text) - 1 else " " for i, c in enumerate(text))


def file_findings(source, path, terms):
    """Yields (area, line, phrase, remedy)."""
    lines = source.split("\n")

    def silenced(line, phrase):
        marks = re.findall(r"lint-ok: ([^*/<>-]+)", lines[line - 1])
        return any(word.strip().lower() in phrase.lower() for mark in marks for word in mark.split(","))

    for text in texts_of(source, path):
        prose = CODE_SPAN.sub(blank, re.sub(r"lint-ok: .*", lambda m: "." * len(m.group(0)), str(text)))
        if text.area == "M" and not re.search(r"\S\s+\S", prose.strip()):
            continue  # not a sentence, but an identifier, a key or a code
        flat = prose.replace("\n", " ")
        found = list(terms.find(flat, text.area, path))
        if text.area != "T":
            found += sentence_findings(prose)
        if text.area in "CH":
            first = re.match(r"\s*(Whether|Of)\b", flat)
            if first:
                found.append((first.start(1), first.end(1), "\"True if\", or the subject first"))
        for start, end, remedy in sorted(found):
            line, phrase = text.line_at(start), re.sub(r"\s+", " ", flat[start:end])
            if not silenced(line, phrase):
                yield text.area, line, phrase, remedy


def sentence_findings(prose):
    start = 0
    for end in [match.end() for match in SENTENCE_END.finditer(prose)] + [len(prose)]:
        sentence = prose[start:end]
        begin = start + len(sentence) - len(sentence.lstrip())
        words = [word for word in sentence.split() if re.search(r"[\w`{]", word)]
        if len(words) > MAX_WORDS:
            yield begin, begin + len(" ".join(sentence.split()[:4])), f"sentences of at most {MAX_WORDS} words"
        if re.match(r"(Is|Are|Has|Does) [^?]*, then\b[^?]*$", sentence.strip().replace("\n", " ")):
            yield begin, begin + len(" ".join(sentence.split()[:3])), "\"If ..., ...\""
        start = end


def repository_files(root):
    for folder, folders, names in os.walk(root):
        folders[:] = sorted(name for name in folders if not SKIPPED_FOLDERS.fullmatch(name))
        for name in sorted(names):
            path = pathlib.Path(folder, name)
            if not path.is_symlink():
                yield path.relative_to(root).as_posix()


def lint(root, paths, terms):
    """Yields all findings as (path, area, line, phrase, remedy)."""
    for path in paths:
        try:
            source = (root / path).read_text(encoding="utf-8")
        except UnicodeDecodeError:
            continue
        for finding in file_findings(source, path, terms):
            yield (path, *finding)


# -- baseline ---------------------------------------------------------------------------------------------------------


def read_baseline(file):
    baseline = {}
    for line in file.read_text().splitlines() if file.exists() else ():
        if line and not line.startswith("#"):
            area, count, path = line.split(maxsplit=2)
            baseline[path, area] = int(count)
    return baseline


def write_baseline(file, baseline):
    text = "# Findings of language_lint.py that are tolerated: area, number, file. Lower it with `language_lint.py --update`.\n"
    text += "".join(f"{area} {count} {path}\n" for (path, area), count in sorted(baseline.items()) if count)
    file.write_text(text)


def print_counts(findings):
    counts = collections.Counter()
    for path, area, *_ in findings:
        parts = path.split("/")
        counts[AREAS[area], "/".join(parts[:2]) if parts[0] in ("src", "tests") and len(parts) > 2 else parts[0]] += 1
    for area in AREAS.values():
        print(f"{sum(n for (a, _), n in counts.items() if a == area):6} {area}")
        for (_, folder), count in sorted(item for item in counts.items() if item[0][0] == area):
            print(f"{count:6}   {folder}")


def main(arguments, root=HERE.parent.parent, terms_file=HERE / "language_terms.txt",
         baseline_file=HERE / "language_baseline.txt"):
    parser = argparse.ArgumentParser(usage=__doc__.split("\n\n")[1].strip())
    for option in ("--all", "--count", "--update"):
        parser.add_argument(option, action="store_true")
    parser.add_argument("files", nargs="*")
    options = parser.parse_args(arguments)

    terms = Terms(terms_file.read_text().splitlines())
    paths = [pathlib.Path(os.path.abspath(file)).relative_to(root).as_posix() for file in options.files]
    findings = list(lint(root, paths or repository_files(root), terms))
    counts = collections.Counter((path, AREAS[area]) for path, area, *_ in findings)
    baseline = read_baseline(baseline_file)
    if options.count:
        print_counts(findings)
        return 0
    if options.update:
        if not baseline_file.exists():
            baseline = dict(counts)
        for key in [key for key in baseline if not paths or key[0] in paths]:
            baseline[key] = min(baseline[key], counts[key])
        write_baseline(baseline_file, baseline)

    risen = {key for key, count in counts.items() if count > baseline.get(key, 0)}
    for path, area, line, phrase, remedy in findings:
        if options.all or (path, AREAS[area]) in risen:
            print(f"{path}:{line}: {phrase}; write {remedy} instead")
    for path, area in sorted(risen):
        print(f"{path}: {counts[path, area]} findings in {area}s, {baseline.get((path, area), 0)} tolerated; "
              "reword the text, or add `lint-ok: WORD` to a line on which the word is right")
    lower = sorted(key for key in baseline if (not paths or key[0] in paths) and counts[key] < baseline[key])
    if lower and not risen:
        print(f"{len(lower)} numbers of the baseline are too high, first {lower[0][0]}; "
              "run tests/repository/language_lint.py --update")
    return 1 if risen else 0


if __name__ == "__main__":
    sys.exit(main(sys.argv[1:]))
