# SPDX-License-Identifier: BSD-3-Clause
"""Prints a row for each run: its elasticity, its pressure and the error of that."""

import sys

import bagnold

print("elasticity,p,p_error")
for path in sys.argv[1:]:
    r = bagnold.load(path)
    print(r.scene["disks.elasticity"], float(r["p"].mean), float(r["p"].error), sep=",")
