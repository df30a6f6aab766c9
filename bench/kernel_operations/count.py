#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""count.py OBJECT: instructions and packed operations of each law's pair loop, for eight pairs.

OBJECT is what pairs.cpp compiles to (target bagnold_kernel_operations), for x86-64 or AArch64. The loop is
the innermost one of BlockForces::add, as objdump shows it: what runs once for a pack of pairs, eight
of AVX-512, four of AVX2, two of 128 bits; numbers are those of as many packs as eight pairs are. Loads and
stores of the disks are in it, force scatter too. Packed operations are arithmetic on whole packs. On the
stack: what finds no register.
"""

import re
import subprocess
import sys

ARITHMETIC = re.compile(r"v?(fn?m(add|sub)|add|sub|mul|div|max|min|sqrt|rsqrt14|rcp14)\w*pd$"
                        r"|f(add|sub|mul|div|mla|mls|max|min|sqrt)$")
PACKS = {8: re.compile(r"%zmm"), 4: re.compile(r"%ymm"), 2: re.compile(r"%xmm|v\d+[.]2d")}
STACK = re.compile(r"\(%r[sb]p|\[sp")
BACK = re.compile(r"j(?!mp)\w+$|b[.]\w+$|cbn?z$|tbn?z$")  # jumps that close a loop
AARCH64 = 183  # e_machine of ELF


def functions(path):
    """{name: [(address, operation, operands)]}"""
    with open(path, "rb") as file:
        machine = int.from_bytes(file.read(20)[18:], "little")
    objdump = "aarch64-linux-gnu-objdump" if machine == AARCH64 else "objdump"
    text = subprocess.run([objdump, "-d", "--no-show-raw-insn", "-C", path], check=True,
                          capture_output=True, text=True).stdout
    found, name = {}, None
    for line in text.splitlines():
        if header := re.match(r"[0-9a-f]+ <(.*)>:", line):
            name = header[1]
        elif name and (line_of := re.match(r"\s+([0-9a-f]+):\s+(\S+)\s*(.*)", line)):
            found.setdefault(name, []).append((int(line_of[1], 16), line_of[2], line_of[3]))
    return found


def largest_loop(code):
    """The instructions between the target of a conditional backward jump and the jump, most of them. Where
    the function returns in between, the jump leaves a loop for code that lies before it."""
    place = {address: k for k, (address, _, _) in enumerate(code)}
    loops = [[]]
    for k, (_, operation, operands) in enumerate(code):
        target = re.search(r"\b([0-9a-f]+) <", operands) if BACK.match(operation) else None
        start = place.get(int(target[1], 16)) if target else None
        if start is not None and start <= k:
            loop = code[start:k + 1]
            if not any(operation == "ret" for _, operation, _ in loop):
                loops.append(loop)
    return max(loops, key=len)


def packed(loop):
    """{pairs in a pack: operations}"""
    arithmetic = [operands for _, operation, operands in loop if ARITHMETIC.match(operation)]
    return {width: sum(bool(pack.search(operands)) for operands in arithmetic)
            for width, pack in PACKS.items()}


def main():
    loops = {}
    for name, code in functions(sys.argv[1]).items():
        # In the caller, where the compiler has put it there.
        law = re.search(r"BlockForces<bagnold::(\w+),.*::add<|PairLoop<bagnold::(\w+)>::run", name)
        if law:
            loops.setdefault(law[1] or law[2], []).append(largest_loop(code))
    print(f"{'law':<8} {'instructions':>12} {'packed operations':>18} {'on the stack':>13}")
    for law in sorted(loops):
        loop = max(loops[law], key=len)
        operations = packed(loop)
        width = max(width for width, found in operations.items() if found)
        stack = sum(bool(STACK.search(operands)) for _, _, operands in loop)
        numbers = (8 // width * n for n in (len(loop), operations[width], stack))
        print("{:<8} {:>12} {:>18} {:>13}".format(law, *numbers))


if __name__ == "__main__":
    main()
