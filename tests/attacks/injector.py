# SPDX-License-Identifier: BSD-3-Clause
"""The environment in which file calls of a program fail: see fault_injector.c."""

import collections
import os

INJECTOR = os.environ.get("FAULT_INJECTOR", "build/openmp/tests/attacks/fault_injector.so")


def injected(prefix, log=None, call=None, at=None, times=1, error="EIO"):
    """Variables that make calls `at` to `at + times - 1` of a name fail; without `at` they are logged."""
    variables = {"LD_PRELOAD": os.path.abspath(INJECTOR), "FAULT_PREFIX": str(prefix)}
    if log is not None:
        variables["FAULT_LOG"] = str(log)
    if at is not None:
        variables |= {"FAULT_CALL": call, "FAULT_AT": str(at), "FAULT_TIMES": str(times),
                      "FAULT_ERROR": error}
    return variables


def logged(log):
    """[(call, number, file)] in order."""
    lines = [line.split(" ", 2) for line in log.read_text().splitlines()] if log.exists() else []
    return [(call, int(number), path) for call, number, path in lines]


def counted(log):
    """How often each call was made."""
    return collections.Counter(call for call, _, _ in logged(log))
