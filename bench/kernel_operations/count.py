#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""count.py OBJECT: instructions and packed operations of each law's pair loop, for eight pairs.

OBJECT is what pairs.cpp compiles to (target bagnold_kernel_operations). The loop is the innermost one
of BlockForces::add_class, as objdump shows it: what runs once for eight pairs. Loads and stores of the
disks are in it, force scatter too.
"""

import re
import subprocess
import sys

ARITHMETIC = re.compile(r"v(fn?m(add|sub)|add|sub|mul|div|max|min|sqrt|rsqrt14|rcp14)\w*pd$")
PACK = re.compile(r"%zmm")


def functions(path):
    """{name: [(address, operation, operands)]}"""
    text = subprocess.run(["objdump", "-d", "--no-show-raw-insn", "-C", path], check=True,
                          capture_output=True, text=True).stdout
    found, name = {}, None
    for line in text.splitlines():
        if header := re.match(r"[0-9a-f]+ <(.*)>:", line):
            name = header[1]
        elif name and (line_of := re.match(r"\s+([0-9a-f]+):\s+(\S+)\s*(.*)", line)):
            found.setdefault(name, []).append((int(line_of[1], 16), line_of[2], line_of[3]))
    return found


def largest_loop(code):
    """The instructions between the target of a backward jump and the jump, most of them."""
    place = {address: k for k, (address, _, _) in enumerate(code)}
    loops = []
    for k, (_, operation, operands) in enumerate(code):
        target = re.match(r"[0-9a-f]+", operands) if operation.startswith("j") else None
        start = place.get(int(target[0], 16)) if target else None
        if start is not None and start <= k:
            loops.append(code[start:k + 1])
    return max(loops, key=len)


def main():
    print(f"{'law':<8} {'instructions':>12} {'of them on packs of eight':>26}")
    for name, code in functions(sys.argv[1]).items():
        law = re.search(r"BlockForces<bagnold::(\w+),.*add_class", name)
        if law:
            loop = largest_loop(code)
            packs = sum(bool(ARITHMETIC.match(operation) and PACK.search(operands))
                        for _, operation, operands in loop)
            print(f"{law[1]:<8} {len(loop):>12} {packs:>26}")


if __name__ == "__main__":
    main()
