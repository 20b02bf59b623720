#!/usr/bin/env python3
# SPDX-License-Identifier: MIT
"""Tests of language_lint.py: findings in incorrect texts, no findings in correct texts, and the baseline."""

import contextlib
import io
import pathlib
import tempfile
import unittest

import language_lint

TERMS = language_lint.Terms((language_lint.HERE / "language_terms.txt").read_text().splitlines())


def findings(path, source):
    return [(line, phrase) for _, line, phrase, _ in language_lint.file_findings(source, path, TERMS)]


LONG = " ".join(["word"] * 31)


class Findings(unittest.TestCase):
    def test_documents_are_checked_outside_code(self):
        self.assertEqual(
            findings("docs/a.md", "# Heading\n\nIt goes\non. `told` [x](told.md)\n\n```\ntold\n```\n| a | told |\n"),
            [(3, "goes on"), (9, "told")])

    def test_only_unreleased_changes_are_checked(self):
        self.assertEqual(findings("CHANGELOG.md", "## Unreleased\n- told\n## 0.1\n- told\n"), [(2, "told")])

    def test_string_literals_are_joined_and_located(self):
        source = 'auto a = error("told-code", {}, "the x is "\n    "none; a \\"y\\" anew");  // it\'s told\n'
        self.assertEqual(findings("src/a.cpp", source), [(1, "is none"), (2, "anew"), (2, "told")])

    def test_raw_literals_characters_and_digit_separators_are_parsed(self):
        source = "auto a = R\"(one\ntwo anew)\"; char b = '\"'; int c = 1'000'000;  // anew\n"
        self.assertEqual(findings("src/a.cpp", source), [(2, "anew"), (2, "anew")])

    def test_literals_of_tests_are_not_checked(self):
        self.assertEqual(findings("tests/a.cpp", 'auto a = "it is told";\n'), [])

    def test_comments_are_joined_across_lines(self):
        self.assertEqual(findings("include/a.hpp", "// It goes\n// on.\nint a;  ///< Whether b\n"),
                         [(1, "goes on"), (3, "Whether")])

    def test_test_names_are_split(self):
        self.assertEqual(findings("tests/a.cpp", "TEST(Suite, NobodyIsToldAnew) {}\n"),
                         [(1, "Nobody"), (1, "Told"), (1, "Anew")])
        self.assertEqual(findings("tests/a.py", "def test_result_is_told():\n    pass\n"), [(1, "told")])

    def test_scripts_are_checked_in_comment_lines(self):
        self.assertEqual(findings("tests/CMakeLists.txt", "# told\nset(a told)\n"), [(1, "told")])

    def test_javascript_is_parsed_with_regular_expressions_and_templates(self):
        source = "a.replace(/[\"'`]/g, \"\");\nb = `it is ${c}\ntold`;  // anew\n"
        self.assertEqual(findings("web/a.js", source), [(3, "told"), (3, "anew")])

    def test_python_literals_and_docstrings_are_checked(self):
        self.assertEqual(findings("python/a.py", 'def f():\n    """It is\n    told."""\n    # anew\n'),
                         [(3, "told"), (4, "anew")])

    def test_scope_and_exceptions_of_terms_apply(self):
        self.assertEqual(findings("docs/a.md", "complaints held against the house"),
                         [(1, "complaints"), (1, "house")])
        self.assertEqual(findings("src/a.cpp", 'auto a = "complaints held against the house";\n'), [])
        self.assertEqual(findings("docs/how-to/draw.md", "behind it"), [])

    def test_lint_ok_silences_a_word_on_its_line(self):
        self.assertEqual(findings("src/a.cpp", "int a;  // told anew lint-ok: told\n"), [(1, "anew")])
        self.assertEqual(findings("docs/a.md", "told anew <!-- lint-ok: told, anew -->\n"), [])

    def test_long_sentences_and_missing_conjunctions_are_reported(self):
        self.assertEqual(findings("docs/a.md", f"{LONG}.\n\nIs it so, then stop.\n\nIs it so, then?\n"),
                         [(1, "word word word word"), (3, "Is it so,")])

    def test_good_text_has_no_finding(self):
        self.assertEqual(findings("docs/a.md", "If the chart has a race, `check` reports it and exits with 1.\n"), [])
        self.assertEqual(findings("src/a.cpp", '// True if the chart is stable.\nauto a = "unknown step; add it";\n'), [])


class Baseline(unittest.TestCase):
    def run_lint(self, text, *arguments, baseline=None):
        with tempfile.TemporaryDirectory() as folder:
            root = pathlib.Path(folder)
            (root / "a.md").write_text(text)
            file = root / "baseline.txt"
            if baseline is not None:
                file.write_text(baseline)
            output = io.StringIO()
            with contextlib.redirect_stdout(output):
                status = language_lint.main(arguments, root, language_lint.HERE / "language_terms.txt", file)
            return status, output.getvalue(), file.read_text() if file.exists() else None

    def test_a_risen_count_fails_with_line_and_remedy(self):
        status, output, _ = self.run_lint("ok\ntold\n", baseline="")
        self.assertEqual(status, 1)
        self.assertIn("a.md:2: told; write reported; receives instead\n", output)
        self.assertIn("a.md: 1 findings in documents, 0 tolerated", output)

    def test_a_tolerated_count_passes(self):
        self.assertEqual(self.run_lint("told\n", baseline="document 1 a.md\n")[:2], (0, ""))

    def test_update_lowers_but_never_raises(self):
        self.assertIn("--update", self.run_lint("told\n", baseline="document 2 a.md\n")[1])
        self.assertTrue(self.run_lint("told\n", "--update", baseline="document 2 a.md\n")[2].endswith("\ndocument 1 a.md\n"))
        status, _, text = self.run_lint("told\ntold\n", "--update", baseline="document 1 a.md\n")
        self.assertEqual(status, 1)
        self.assertTrue(text.endswith("\ndocument 1 a.md\n"))


if __name__ == "__main__":
    unittest.main()
