# SPDX-License-Identifier: MIT
# Configuration of Sphinx. `./dev docs` writes the sources of the site into build/docs/source and runs sphinx-build there.
import os
import re
from pathlib import Path

root = Path(__file__).resolve().parent.parent
project = "grafverif"
author = "the grafverif authors"
version = release = re.search(r"VERSION ([\d.]+)", (root / "CMakeLists.txt").read_text().split("project(", 1)[1])[1]
html_show_copyright = False

extensions = ["myst_parser"]
if "GRAFVERIF_DOXYGEN_XML" in os.environ:
    extensions.append("breathe")
    breathe_projects = {"grafverif": os.environ["GRAFVERIF_DOXYGEN_XML"]}
    breathe_default_project = "grafverif"
    breathe_default_members = ("members",)
myst_heading_anchors = 4
nitpicky = True
# The C++ API refers to types of the standard library and to types of Doxygen, which this site does not describe.
nitpick_ignore_regex = [(r"cpp:.*", r".*")]
suppress_warnings = ["duplicate_declaration.cpp"]
highlight_language = "text"

html_theme = "furo"
html_title = f"grafverif {version}"
html_static_path = [str(Path(__file__).resolve().parent / "site" / "static")]
html_css_files = ["site.css"]
html_js_files = ["site.js"]
html_copy_source = False
html_show_sourcelink = False


def setup(app):
    app.connect("config-inited", lambda app, config: config.html_extra_path.append(os.path.join(app.srcdir, "redirections")))
