# SPDX-License-Identifier: BSD-3-Clause
"""scripts/bench levels: what each level of instructions takes over the best, with one program that has them all."""
import re
import statistics
import sys

import machine
import report
import targets

NAMES = ("avx512", "avx2", "baseline")  # best first
LIMITS = {"avx2": 1.35, "baseline": 3.0}  # over avx512
VARIABLE = "BAGNOLD_SIMD"  # of the environment, forces one
SHORTER = 2  # divides the strain of a row
TABLE = "scripts/bench levels"


def of_program(program):
    """Those that the program can take here, best first."""
    found = re.findall(r"\w+", machine.bagnold_info(program)["SIMD"].replace("also", ""))
    if len(found) < 2:
        sys.exit(f"error: {program} has the level {', '.join(found)} alone; configure with -DBAGNOLD_NATIVE=OFF, "
                 "as scripts/bench levels does without --build")
    return sorted(found, key=NAMES.index)


def over(rounds, row, level, best):
    """Time over that of the best level, round by round."""
    return targets.Target("", targets.SECONDS, row, 0, other_engine=best).values(rounds, level)


def target_table(rounds, rows, found):
    """The row that takes longest decides."""
    lines = []
    for level in found[1:]:
        if found[0] != "avx512":
            continue
        slowest = max((row for row in rows if over(rounds, row, level, found[0])),
                      key=lambda row: statistics.median(over(rounds, row, level, found[0])))
        ratios = over(rounds, slowest, level, found[0])
        met = statistics.median(ratios) <= LIMITS[level]
        lines.append([f"{level} over avx512, seconds of the row where that is most", f"at most {LIMITS[level]:g}",
                      f"{report.spread(ratios)}: {slowest}", "yes" if met else "**no**"])
    return report.table(["target", "", "measured", "met"], lines)


def row_table(rounds, rows, found):
    best = found[0]
    lines = []
    for row in rows:
        if seconds := report.values_of(rounds, row, best, targets.SECONDS):
            lines.append([row, report.spread(seconds),
                          *(report.spread(over(rounds, row, level, best)) for level in found[1:])])
    return report.table(["row", f"{best}: seconds a strain", *(f"{level} over {best}" for level in found[1:])], lines)


def text(rounds, rows, found, preamble):
    return "\n\n".join([preamble, target_table(rounds, rows, found), row_table(rounds, rows, found)])
