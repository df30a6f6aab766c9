# SPDX-License-Identifier: BSD-3-Clause
"""Scenes that libFuzzer invents, from the files in inputs/ and the corpus beside this."""

from fuzzer import Fuzzer


class Attack(Fuzzer):
    kind = "scene"
