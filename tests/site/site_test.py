# SPDX-License-Identifier: MIT
"""site_test.py GRAFVERIF: the sources of the site are complete, and each kind of error in them fails the build."""
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
        """(exit code, errors) of a build of `root`."""
        target = Path(self.folder.name) / "target"
        done = subprocess.run([sys.executable, "-B", ROOT / "docs/site/build.py", program, target, "--root", self.root, "--quick"],
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
        self.add_page("A page.\n")
        self.assert_problem("docs/new.md:1: the page has no title")

    def test_title_inside_code_is_ignored(self):
        self.add_page("```text\n# Title\n```\n")
        self.assert_problem("docs/new.md:1: the page has no title")

    def test_page_that_is_too_long(self):
        self.add_page("# New\n" + "\n" * 250)
        self.assert_problem("docs/new.md:250: the page has more than 250 lines")

    def test_page_that_is_not_in_the_index(self):
        (self.root / "docs/new.md").write_text("# New\n")
        self.assert_problem("`new.md` is not linked")

    def test_link_to_missing_file(self):
        self.add_page("# New\n\nSee [this](missing.md).\n")
        self.assert_problem("docs/new.md:3: broken link `missing.md`; no such file")

    def test_link_to_missing_heading(self):
        self.add_page("# New\n\nSee [this](index.md#missing).\n")
        self.assert_problem("docs/new.md:3: broken link `index.md#missing`; no such heading")

    def test_link_to_missing_diagnostic(self):
        self.add_page("# New\n\nSee [this](reference/diagnostics.md#missing).\n")
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
        lamp.write_text(lamp.read_text().replace("//   ON  input  order: light\n", ""))
        self.assert_problem("templates/lamp.grafcet: undocumented parameter `ON`")


if __name__ == "__main__":
    unittest.main()
