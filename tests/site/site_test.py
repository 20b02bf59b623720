# SPDX-License-Identifier: MIT
"""site_test.py GRAFVERIF: tests that the sources of the site are complete, and that each kind of error in them fails
the build.

The tests of the finished site need Sphinx with MyST and Furo; without them they are skipped with a message.
"""
import re
import shutil
import stat
import subprocess
import sys
import tempfile
import unittest
from pathlib import Path

ROOT = Path(__file__).resolve().parents[2]
PROGRAM = Path(sys.argv.pop()).resolve()


class Site(unittest.TestCase):
    def setUp(self):
        self.folder = tempfile.TemporaryDirectory()
        self.root = Path(self.folder.name) / "root"
        self.root.mkdir()
        shutil.copytree(ROOT / "docs", self.root / "docs")
        for name in ["src", "tests", "samples", "python", "README.md", "CONTRIBUTING.md"]:
            (self.root / name).symlink_to(ROOT / name)
        (self.root / "templates").mkdir()
        for name in ["lamp", "cylinder_5_3"]:
            shutil.copy(ROOT / f"templates/{name}.grafcet", self.root / "templates")

    def tearDown(self):
        self.folder.cleanup()

    def build(self, program=PROGRAM):
        """Returns (exit code, errors) of a build of `root`."""
        target = Path(self.folder.name) / "target"
        done = subprocess.run([sys.executable, "-B", self.root / "docs/site/build.py", program, target, "--root", self.root, "--quick"],
                              capture_output=True, text=True)
        return done.returncode, done.stderr

    def add_page(self, text):
        (self.root / "docs/new.md").write_text(text)
        index = self.root / "docs/index.md"
        index.write_text(index.read_text() + "- [New](new.md)\n")

    def assert_problem(self, expected, program=PROGRAM):
        code, errors = self.build(program)
        self.assertEqual(code, 1, errors)
        self.assertEqual(len(errors.splitlines()), 1, errors)
        self.assertIn(expected, errors)

    def test_repository_has_no_problems(self):
        shutil.rmtree(self.root / "templates")
        (self.root / "templates").symlink_to(ROOT / "templates")
        code, errors = self.build()
        self.assertEqual((code, errors), (0, ""))
        target = Path(self.folder.name) / "target"
        for page, text in [("cli", "\n## grafverif check\n"), ("diagnostics", "\n## unknown-variable\n"),
                           ("components", "\n| `G_IN` | input |"), ("python-api", "\n## Loop\n")]:
            self.assertTrue(text in (target / f"reference/{page}.md").read_text(), text)
        index = (target / "index.md").read_text()
        self.assertIn(" [closed loop](reference/glossary.md#closed-loop) ", index)
        self.assertNotIn("[](", index)

    def test_page_without_title(self):
        self.add_page("A page for readers.\n")
        self.assert_problem("docs/new.md:1: the page has no title")

    def test_title_inside_code_is_ignored(self):
        self.add_page("```text\n# Title\n```\n\nIt is for readers.\n")
        self.assert_problem("docs/new.md:1: the page has no title")

    def test_page_without_audience(self):
        self.add_page("# New\n\nThis page is new.\n")
        self.assert_problem("docs/new.md:1: the page does not state its audience")

    def test_redirection_to_missing_page(self):
        pages = self.root / "docs/site/pages.py"
        pages.write_text(pages.read_text().replace('"why": "explanation/why"', '"why": "explanation/missing"'))
        self.assert_problem("redirection from `why` to `explanation/missing`")

    def test_page_that_is_too_long(self):
        self.add_page("# New\n\nIt is for readers.\n" + "\n" * 250)
        self.assert_problem("docs/new.md:250: the page has more than 250 lines")

    def test_page_that_is_not_in_the_index(self):
        (self.root / "docs/new.md").write_text("# New\n\nIt is for readers.\n")
        self.assert_problem("`new.md` is not linked")

    def test_link_to_missing_file(self):
        self.add_page("# New\n\nIt is for readers. See [this](missing.md).\n")
        self.assert_problem("docs/new.md:3: broken link `missing.md`; no such file")

    def test_link_to_missing_heading(self):
        self.add_page("# New\n\nIt is for readers. See [this](index.md#missing).\n")
        self.assert_problem("docs/new.md:3: broken link `index.md#missing`; no such heading")

    def test_link_to_missing_diagnostic(self):
        self.add_page("# New\n\nIt is for readers. See [this](reference/diagnostics.md#missing).\n")
        self.assert_problem("broken link `reference/diagnostics.md#missing`; no such heading")

    def test_undocumented_option(self):
        program = Path(self.folder.name) / "program"
        page = ".SH OPTIONS\\n.TP\\n--new\\n"
        program.write_text(f"#!/bin/sh\n'{PROGRAM}' \"$@\"\n[ \"$*\" != 'manual fmt' ] || printf '{page}'\n")
        program.chmod(program.stat().st_mode | stat.S_IXUSR)
        self.assert_problem("grafverif fmt: undocumented option `--new`", program)

    def test_undocumented_diagnostic(self):
        (self.root / "src").unlink()
        shutil.copytree(ROOT / "src/support", self.root / "src/support")
        (self.root / "src/support/messages_new.cpp").write_text('Diagnostic f(Span s, std::string m) {\n    return error("new-code", s, m);\n}\n')
        self.assert_problem("undocumented diagnostic `new-code`")

    def test_undocumented_parameter(self):
        lamp = self.root / "templates/lamp.grafcet"
        lamp.write_text(lamp.read_text().replace("//   ON  input  order to turn on\n", ""))
        self.assert_problem("templates/lamp.grafcet: undocumented parameter `ON`")


def missing_for_sphinx():
    """Returns the reason why the finished site cannot be built, or an empty string."""
    missing = [name for name in ["sphinx", "myst_parser", "furo"]
               if subprocess.run(["/usr/bin/python3", "-c", f"import {name}"], capture_output=True).returncode]
    return f"not installed: {', '.join(missing)}" if missing else ""


@unittest.skipIf(missing_for_sphinx(), missing_for_sphinx())
class FinishedSite(unittest.TestCase):
    """Runs Sphinx as `./dev docs` does, on the sources without gallery and C++ API."""

    @classmethod
    def setUpClass(cls):
        cls.folder = tempfile.TemporaryDirectory()
        cls.source, cls.html = Path(cls.folder.name) / "source", Path(cls.folder.name) / "html"
        subprocess.run([sys.executable, "-B", ROOT / "docs/site/build.py", PROGRAM, cls.source, "--quick"], check=True)
        cls.code, cls.errors = cls.sphinx()

    @classmethod
    def tearDownClass(cls):
        cls.folder.cleanup()

    @classmethod
    def sphinx(cls):
        command = ["/usr/bin/python3", "-B", "-m", "sphinx", "-n", "-W", "--keep-going", "-q", "-c", ROOT / "docs", "-d",
                   Path(cls.folder.name) / "doctrees", cls.source, cls.html]
        done = subprocess.run(command, capture_output=True, text=True)
        return done.returncode, done.stderr

    def assert_warning(self, page, text, expected):
        path = self.source / page
        before = path.read_text()
        path.write_text(text(before))
        code, errors = self.sphinx()
        path.write_text(before)
        self.assertNotEqual(code, 0)
        self.assertIn(expected, errors)

    def test_pages_are_built_without_warnings(self):
        self.assertEqual((self.code, self.errors), (0, ""))
        for name in ["index", "reference/cli", "reference/diagnostics", "tutorials/first-check", "search"]:
            self.assertTrue((self.html / f"{name}.html").exists(), name)
        self.assertIn("glossary.html#closed-loop", (self.html / "index.html").read_text())
        self.assertTrue((self.html / "searchindex.js").exists())

    def test_former_pages_lead_to_their_successors(self):
        for name in ["checking", "trace", "why"]:
            page = (self.html / f"{name}.html").read_text()
            target = page.split("url=", 1)[1].split('"', 1)[0]
            self.assertTrue((self.html / target).exists(), target)

    def test_site_needs_no_network(self):
        for page in self.html.rglob("*.html"):
            for address in re.findall(r"<(?:script|img|iframe)[^>]* src=\"([^\"]*)\"|<link[^>]* rel=\"stylesheet\"[^>]* href=\"([^\"]*)\"", page.read_text()):
                self.assertNotRegex("".join(address), "^(https?:)?//", page.name)

    def test_broken_reference_fails_the_build(self):
        self.assert_warning("reference/versions.md", lambda text: text + "\n[missing](missing.md)\n", "missing")

    def test_page_without_title_fails_the_build(self):
        self.assert_warning("reference/versions.md", lambda text: text.replace("# Versions\n", ""), "Document headings start at H2")


if __name__ == "__main__":
    unittest.main(verbosity=2)
