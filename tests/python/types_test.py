# SPDX-License-Identifier: MIT
"""Checks with mypy in strict mode the types of the package, of its core, and of the examples in the documentation."""
import doctest
import pathlib
import subprocess
import sys

import grafverif

root = pathlib.Path(__file__).parents[2]
package = pathlib.Path(grafverif.__file__).parent


def mypy(tmp_path, *arguments):
    found = subprocess.run([sys.executable, "-m", "mypy", "--strict", "--ignore-missing-imports", "--cache-dir", tmp_path.parent / "cache",
                            *arguments], cwd=package.parent, capture_output=True, text=True, check=False)
    return found.stdout + found.stderr if found.returncode else ""


def test_the_package_is_typed_throughout(tmp_path):
    assert mypy(tmp_path, package) == ""


def test_examples_of_the_page_are_well_typed(tmp_path):
    page = (root / "docs/how-to/python.md").read_text()
    examples = tmp_path / "examples.py"
    examples.write_text("".join(each.source for each in doctest.DocTestParser().get_examples(page)))
    assert mypy(tmp_path, "--follow-imports", "silent", examples) == ""
    examples.write_text("import grafverif\ngrafverif.read(7).loop().check('P15')['P15'].verdict += 1\n")
    wrong = mypy(tmp_path, examples)
    assert "arg-type" in wrong and "operator" in wrong, "mypy checks the file"


def test_the_stub_of_the_core_is_that_of_the_core(tmp_path):
    # members of every pybind11 class: a metaclass, and an initializer that raises an exception
    (tmp_path / "allowed").write_text(r"grafverif\._core\.\w+(\.__init__)?" + "\n")
    found = subprocess.run([sys.executable, "-m", "mypy.stubtest", "grafverif._core", "--allowlist", tmp_path / "allowed"],
                           cwd=package.parent, capture_output=True, text=True, check=False)
    assert found.returncode == 0, found.stdout + found.stderr
