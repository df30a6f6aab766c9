# SPDX-License-Identifier: BSD-3-Clause
"""How Sphinx makes the site. scripts/site gathers the source and calls it."""

import os
import pathlib
import re
import sys

ROOT = pathlib.Path(os.environ["BAGNOLD_SOURCE"])
sys.path.insert(0, str(ROOT / "python"))

project = "Bagnold"
author = "The Bagnold authors"
version = re.search(r"project\(Bagnold VERSION (\S+)", (ROOT / "CMakeLists.txt").read_text())[1]
html_title = f"Bagnold {version}"
html_theme = "furo"
html_show_copyright = False

extensions = ["myst_nb", "sphinx.ext.autodoc"]
myst_heading_anchors = 4
highlight_language = "text"
default_role = "code"

autodoc_member_order = "bysource"
autodoc_typehints = "signature"
autodoc_preserve_defaults = True

nb_execution_mode = os.environ.get("BAGNOLD_SITE_NOTEBOOKS", "force")
nb_execution_timeout = 300
nb_execution_raise_on_error = True
nb_execution_in_temp = True
nb_merge_streams = True
nb_output_stderr = "remove"


def with_literal_blocks(lines):
    """Docstrings mark what stands as it is by its indentation alone; reStructuredText wants a :: before it."""
    made = []
    for before, line in zip(["", *lines], lines):
        indented = line.startswith("    ") and not before.strip()
        last = next((one for one in reversed(made) if one.strip()), "")
        if indented and last and not last.startswith(" ") and not last.endswith("::"):
            made += ["::", ""]
        made.append(line)
    return made


def process(_app, _what, _name, _object, _options, lines):
    lines[:] = with_literal_blocks(lines)


def setup(app):
    app.connect("autodoc-process-docstring", process)
