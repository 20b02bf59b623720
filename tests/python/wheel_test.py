# SPDX-License-Identifier: MIT
"""Builds and installs a wheel with `pip` without network access; the compiled module comes from the build tree of the
tests."""
import os
import pathlib
import subprocess
import sys

import grafverif
import pytest

root = pathlib.Path(__file__).parents[2]
CMAKE = """#!/bin/sh
set -e
if [ "$1" = --build ]; then mkdir -p "$2/python/grafverif" && cp "$MODULE" "$2/python/grafverif/"; fi
echo "$@" >> "$CALLS"
"""


@pytest.fixture
def environment(tmp_path):
    programs = tmp_path / "programs"
    programs.mkdir()
    (programs / "cmake").write_text(CMAKE)
    (programs / "cmake").chmod(0o755)
    return {**os.environ, "PATH": f"{programs}:{os.environ['PATH']}", "MODULE": grafverif._core.__file__,
            "CALLS": str(tmp_path / "calls"), "PIP_NO_INDEX": "1", "PIP_DISABLE_PIP_VERSION_CHECK": "1",
            "PIP_NO_CACHE_DIR": "1", "HOME": str(tmp_path)}


def pip(environment, *arguments):
    found = subprocess.run([sys.executable, "-m", "pip", *arguments], env=environment, capture_output=True, text=True,
                           check=False)
    assert found.returncode == 0, found.stdout + found.stderr


def test_pip_installs_a_wheel_without_the_network(tmp_path, environment):
    if subprocess.run([sys.executable, "-m", "pip", "--version"], capture_output=True, check=False).returncode != 0:
        pytest.skip("no pip; apt-get install -y python3-pip")
    pip(environment, "wheel", "--no-deps", "--wheel-dir", str(tmp_path / "wheels"), str(root))
    (wheel,) = (tmp_path / "wheels").glob("*.whl")
    assert wheel.name.startswith(f"grafverif-{grafverif.__version__}-cp3")
    again = subprocess.run([sys.executable, "-c", f"import build_backend; print(build_backend.build_wheel({str(tmp_path)!r}))"],
                           env={**environment, "PYTHONPATH": str(root / "python")}, capture_output=True, text=True, check=True)
    assert again.stdout.split()[-1] == wheel.name and (tmp_path / wheel.name).read_bytes() == wheel.read_bytes()
    assert "--target grafverif_python" in (tmp_path / "calls").read_text()
    pip(environment, "install", "--target", str(tmp_path / "site"), str(wheel))
    code = ("import grafverif, importlib.metadata; print(grafverif.__file__, grafverif.__version__,"
            " importlib.metadata.version('grafverif'))")
    printed = subprocess.run([sys.executable, "-c", code], env={**environment, "PYTHONPATH": str(tmp_path / "site")},
                             capture_output=True, text=True, check=True).stdout.split()
    assert printed == [str(tmp_path / "site/grafverif/__init__.py"), grafverif.__version__, grafverif.__version__]
