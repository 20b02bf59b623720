# SPDX-License-Identifier: MIT
"""Runs the examples of the documents without changes, in an empty namespace."""
import doctest
import pathlib

import pytest

root = pathlib.Path(__file__).parents[2]
pages = sorted(page for page in [root / "README.md", *root.glob("docs/**/*.md")] if "```python" in page.read_text())


@pytest.mark.parametrize("page", pages, ids=lambda page: page.stem)
def test_examples_run_as_pasted(page, monkeypatch, tmp_path):
    pytest.importorskip("pandas")
    pytest.importorskip("matplotlib")
    monkeypatch.setenv("MPLBACKEND", "Agg")
    (tmp_path / "samples").symlink_to(root / "samples")
    monkeypatch.chdir(tmp_path)
    result = doctest.testfile(str(page), module_relative=False, optionflags=doctest.ELLIPSIS, globs={})
    assert result.attempted > 10 and result.failed == 0
    assert (tmp_path / "sweep.png").stat().st_size > 5000


def test_there_is_a_page():
    assert root / "docs/how-to/python.md" in pages
