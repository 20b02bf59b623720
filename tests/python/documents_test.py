# SPDX-License-Identifier: MIT
"""The page on Python says what happens."""
import doctest
import os
import pathlib

import pytest

root = pathlib.Path(__file__).parents[2]


def test_the_page_says_what_happens(monkeypatch, tmp_path):
    pytest.importorskip("pandas")
    matplotlib = pytest.importorskip("matplotlib")
    matplotlib.use("Agg")
    monkeypatch.chdir(root)
    monkeypatch.setenv("SWEEP", str(tmp_path / "sweep.png"))
    result = doctest.testfile(str(root / "docs/python.md"), module_relative=False, optionflags=doctest.ELLIPSIS,
                              globs={"os": os})
    assert result.attempted > 10 and result.failed == 0
    assert (tmp_path / "sweep.png").stat().st_size > 5000
