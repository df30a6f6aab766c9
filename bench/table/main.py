# SPDX-License-Identifier: BSD-3-Clause
"""scripts/bench: times every row of docs/performance.md and writes its table.

Rows start from steady states, which `scripts/bench states` makes once. `scripts/bench levels` times half
of each row with each level of instructions that one program has. Only a run of all rows, at full length, writes
into docs/performance.md; others print what they find.
"""
import argparse
import os
import re
import shutil
import sys

import levels
import machine
import measure
import report
import states
import targets

ROOT = os.path.abspath(os.path.join(os.path.dirname(os.path.abspath(__file__)), "..", ".."))
QUICK_SHORTER = 1000


def arguments():
    parser = argparse.ArgumentParser(prog="scripts/bench", description=__doc__,
                                     formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("command", nargs="?", choices=["states", "levels"],
                        help="states: make these, time nothing; levels: of instructions, one over the other")
    parser.add_argument("--quick", action="store_true",
                        help="small systems, a thousandth of the strain: does it work? no times worth having")
    parser.add_argument("--repeats", type=int, default=5, metavar="K", help="rounds (default: %(default)s)")
    parser.add_argument("--states", metavar="DIR",
                        help="folder of states (default: results/bench-states; with --quick "
                             "results/bench-states-quick, filled as needed)")
    parser.add_argument("--rows", default="", metavar="PATTERN", help="rows that match a regular expression")
    parser.add_argument("--engines", default="auto,reference",
                        help="of auto, reference, few-contacts, many-contacts, lookahead; the first is held against "
                             "the targets (default: %(default)s)")
    parser.add_argument("--lammps", default="lmp", metavar="PROGRAM", help="left out where there is none")
    parser.add_argument("--build", metavar="DIR", help="use the programs there as they are (default: build/openmp, "
                                                       "with levels build/package)")
    parser.add_argument("--into", metavar="FILE", help="write the table between the markers of this file")
    parser.add_argument("--list", action="store_true", help="the rows")
    options = parser.parse_args()
    if options.repeats < 1:
        parser.error(f"--repeats = {options.repeats} (must be at least 1)")
    unknown = set(options.engines.split(",")) - {"auto", "reference", "few-contacts", "many-contacts", "lookahead"}
    if unknown:
        parser.error(f"--engines: no such engine: {', '.join(sorted(unknown))}")
    try:
        options.chosen = [row for row in targets.ROWS if re.search(options.rows, row)]
    except re.error as error:
        parser.error(f"--rows = {options.rows} (is no regular expression: {error})")
    if not options.chosen:
        parser.error(f"--rows = {options.rows} matches no row; see --list")
    options.build = os.path.abspath(
        options.build or os.path.join(ROOT, "build", "package" if options.command == "levels" else "openmp"))
    quick = "-quick" if options.quick else ""
    options.states = os.path.abspath(options.states or os.path.join(ROOT, "results/bench-states" + quick))
    if not options.into and not options.quick and options.chosen == targets.ROWS:
        options.into = os.path.join(ROOT, "docs/performance.md")
    return options


def main():
    options = arguments()
    if options.list:
        print("\n".join(options.chosen))
        return
    bagnold, benchmark = (os.path.join(options.build, name) for name in ("bagnold", "bagnold_bench"))
    for program in (bagnold, benchmark):
        if not os.path.exists(program):
            sys.exit(f"error: {program} is missing; run scripts/bench without --build, which builds it")
    if options.quick or options.command == "states":
        names = {targets.state_of(row): None for row in options.chosen}  # in this order, once each
        states.make(bagnold, options.states, names, options.quick, measure.say)
    if options.command == "states":
        return
    by_level = options.command == "levels"
    lammps = "" if by_level else shutil.which(options.lammps) or ""
    if not lammps and not by_level:
        measure.say(f"skipped: LAMMPS: there is no program {options.lammps}; apt-get install lammps")
    shorter = QUICK_SHORTER if options.quick else levels.SHORTER if by_level else 1
    setup = measure.Setup(benchmark, options.states, os.path.join(options.states, "lammps"), shorter, lammps)
    engines = levels.of_program(bagnold) if by_level else options.engines.split(",")
    runs = measure.runs_of(setup, options.chosen, engines)
    if not runs:
        sys.exit("error: no row can be timed (see above)")
    rounds = measure.rounds(setup, runs, options.repeats)
    command = ["levels"] if by_level else []
    command += ["--repeats", str(options.repeats)]
    command += [] if by_level else ["--engines", options.engines]
    command += ["--rows", options.rows] if options.rows else []
    preamble = machine.preamble(bagnold, lammps, rounds, options.quick, command)
    write = levels.text if by_level else report.text
    found = write(rounds, options.chosen, engines, preamble)
    print(found)
    if options.into:
        report.put_into(options.into, levels.TABLE if by_level else report.TABLE, found)
        measure.say(f"written into {options.into}")


if __name__ == "__main__":
    main()
