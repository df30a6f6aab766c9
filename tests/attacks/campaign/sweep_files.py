# SPDX-License-Identifier: BSD-3-Clause
"""Sweep files that libFuzzer invents."""

from fuzzer import Fuzzer


class Attack(Fuzzer):
    kind = "sweep"
