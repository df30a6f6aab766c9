# SPDX-License-Identifier: BSD-3-Clause
"""Imports under atheris, which follows what of the importers is reached: fuzz_import.py CORPUS [options of libFuzzer]."""

import pathlib
import sys
import tempfile

import atheris

with atheris.instrument_imports(include=["bagnold.imports"]):
    import import_target

FOLDER = tempfile.TemporaryDirectory(prefix="bagnold-fuzz-")


def one(data):
    import_target.attack(pathlib.Path(FOLDER.name), data)


if __name__ == "__main__":
    atheris.Setup(sys.argv, one)
    atheris.Fuzz()
