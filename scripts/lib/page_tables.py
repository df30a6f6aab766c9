# SPDX-License-Identifier: BSD-3-Clause
"""Tables of pages that scripts write: cells, rows, and the marks between which a page holds them."""

import math


def digits(value, count=3):
    """So many significant digits, without an exponent."""
    return f"{value:.{max(0, count - 1 - math.floor(math.log10(abs(value))))}f}"


def measured(value, error):
    """Value and, in brackets, the error in units of its last digit: one digit of it, two where the first is 1; an error
    of 20 and more as it is, "390 (30)". Without an error, of a run too short for one, three digits."""
    if not error > 0:
        return digits(value)
    place = math.floor(math.log10(error))
    if f"{error / 10**place:.0f}" == "1":
        place -= 1
    if place > 0:
        return f"{round(value, -place):.0f} ({round(error, -place):.0f})"
    return f"{value:.{-place}f} ({error / 10**place:.0f})"


def table(lines):
    """Rows of cells as Markdown."""
    return "".join("| " + " | ".join(line) + " |\n" for line in lines)


def marks(name, script):
    """Lines before and after a table of a page."""
    return f"<!-- table {name}: scripts/{script} -->\n", f"<!-- end of {name} -->\n"


def of_page(text, name, script):
    """A table as a page has it."""
    begin, end = marks(name, script)
    return text.split(begin)[1].split(end)[0]


def in_page(text, name, script, new):
    """The text of a page with another table between its marks."""
    begin, end = marks(name, script)
    before, rest = text.split(begin)
    return before + begin + new + end + rest.split(end)[1]
