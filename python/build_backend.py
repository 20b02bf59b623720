# SPDX-License-Identifier: MIT
"""Build backend of pyproject.toml (PEP 517): CMake builds the module, and this backend packs it as a wheel (PEP 427).

It uses the standard library only, so that `pip install .` needs no network. `--config-settings build-dir=DIR` builds in DIR
and keeps it; an already configured build tree is used unchanged.
"""

import base64
import hashlib
import os
import pathlib
import re
import subprocess
import sys
import sysconfig
import tempfile
import tomllib
import zipfile

ROOT = pathlib.Path(__file__).resolve().parents[1]
FILES = ("__init__.py", "_core.pyi", "py.typed")


def _version():
    return re.search(r"project\(grafverif VERSION ([\d.]+)", (ROOT / "CMakeLists.txt").read_text())[1]


def _metadata():
    project = tomllib.loads((ROOT / "pyproject.toml").read_text())["project"]
    lines = ["Metadata-Version: 2.1", f"Name: {project['name']}", f"Version: {_version()}",
             f"Summary: {project['description']}", f"Keywords: {','.join(project['keywords'])}",
             f"License: {project['license']['text']}", f"Requires-Python: {project['requires-python']}"]
    for extra, packages in project["optional-dependencies"].items():
        lines += [f"Provides-Extra: {extra}", *(f'Requires-Dist: {name}; extra == "{extra}"' for name in packages)]
    return "\n".join([*lines, "Description-Content-Type: text/markdown", "", (ROOT / project["readme"]).read_text()])


def _built(folder):
    """Builds the module in `folder` and returns its path."""
    if not (folder / "CMakeCache.txt").exists():
        subprocess.run(["cmake", "-S", ROOT, "-B", folder, "-DCMAKE_BUILD_TYPE=Release", "-DGRAFVERIF_TESTS=OFF",
                        f"-DPython_EXECUTABLE={sys.executable}"], check=True)
    subprocess.run(["cmake", "--build", folder, "--target", "grafverif_python", "--parallel", str(os.cpu_count())],
                   check=True)
    module = folder / "python/grafverif" / f"_core{sysconfig.get_config_var('EXT_SUFFIX')}"
    if not module.exists():
        raise SystemExit(f"{module} was not built; install pybind11-dev and the headers of this Python")
    return module


def _wheel(target, module):
    python, version = f"cp{sys.version_info.major}{sys.version_info.minor}", _version()
    platform = re.sub(r"[-.]", "_", sysconfig.get_platform())
    contents = {f"grafverif/{name}": (ROOT / "python/grafverif" / name).read_bytes() for name in FILES}
    contents[f"grafverif/{module.name}"] = module.read_bytes()
    info = f"grafverif-{version}.dist-info"
    contents[f"{info}/METADATA"] = _metadata().encode()
    contents[f"{info}/LICENSE"] = (ROOT / "LICENSE").read_bytes()
    contents[f"{info}/WHEEL"] = (f"Wheel-Version: 1.0\nGenerator: grafverif\nRoot-Is-Purelib: false\n"
                                 f"Tag: {python}-{python}-{platform}\n").encode()
    record = []
    for name, content in contents.items():
        digest = base64.urlsafe_b64encode(hashlib.sha256(content).digest()).rstrip(b"=").decode()
        record.append(f"{name},sha256={digest},{len(content)}\n")
    contents[f"{info}/RECORD"] = "".join([*record, f"{info}/RECORD,,\n"]).encode()
    name = f"grafverif-{version}-{python}-{python}-{platform}.whl"
    with zipfile.ZipFile(target / name, "w", zipfile.ZIP_DEFLATED) as wheel:
        for path, content in contents.items():
            entry = zipfile.ZipInfo(path)  # has the date 1980-01-01, so that wheels are reproducible
            entry.compress_type, entry.external_attr = zipfile.ZIP_DEFLATED, 0o644 << 16
            wheel.writestr(entry, content)
    return name


def build_wheel(wheel_directory, config_settings=None, metadata_directory=None):
    kept = (config_settings or {}).get("build-dir")
    if kept:
        return _wheel(pathlib.Path(wheel_directory), _built(pathlib.Path(kept).resolve()))
    with tempfile.TemporaryDirectory(prefix="grafverif-wheel-") as folder:
        return _wheel(pathlib.Path(wheel_directory), _built(pathlib.Path(folder)))


def build_sdist(sdist_directory, config_settings=None):
    raise NotImplementedError("source distributions are not supported; build a wheel from the repository")
