# SPDX-License-Identifier: BSD-3-Clause
"""Makes the Python package of this tree importable as `bagnold_package`: these tests have a module
`bagnold` of their own."""

import importlib.util
import sys

from bagnold import SOURCE

FOLDER = SOURCE / "python/bagnold"

if "bagnold_package" not in sys.modules:
    spec = importlib.util.spec_from_file_location("bagnold_package", FOLDER / "__init__.py",
                                                  submodule_search_locations=[str(FOLDER)])
    package = importlib.util.module_from_spec(spec)
    sys.modules["bagnold_package"] = package
    spec.loader.exec_module(package)
