# SPDX-License-Identifier: BSD-3-Clause
"""scripts/accuracy: tables of what schemes and time steps cost and how wrong they are, and pictures.

Systems start from the steady states of scripts/bench, made where they are missing.
"""
import argparse
import os
import sys
from dataclasses import replace

HERE = os.path.dirname(os.path.abspath(__file__))
ROOT = os.path.dirname(os.path.dirname(os.path.dirname(HERE)))
sys.path.insert(0, os.path.join(ROOT, "bench/table"))

import engines  # noqa: E402
import pictures  # noqa: E402
import states  # noqa: E402
from cases import CASES, FORMS  # noqa: E402
from tables import Tables  # noqa: E402

states.STATES.update((state.name, state) for state in states.chain(
    "cd82", {**states.NEWTONIAN, "model": "CD", "count": 1024}, "1024", ("1e-3", 5), ("1e-4", 5)))
TABLES = ("collision", "stability", "stretches", "precision", "steady", "engines", "implicit", "auto",
          "quasi_static")


def read_arguments():
    parser = argparse.ArgumentParser(prog="scripts/accuracy", description=__doc__)
    form = parser.add_mutually_exclusive_group()
    form.add_argument("--quick", action="store_const", const="quick", dest="form", default="full",
                      help="less of everything: minutes")
    form.add_argument("--tiny", action="store_const", const="tiny", dest="form",
                      help="64 disks, seconds: does everything run?")
    parser.add_argument("--only", nargs="+", choices=(*TABLES, "pictures"), default=(*TABLES, "pictures"))
    parser.add_argument("--states", default="results/bench-states", help="as for scripts/bench")
    parser.add_argument("--data", default=os.path.join(ROOT, "docs/data/accuracy"), help="of the tables")
    parser.add_argument("--pictures", default=os.path.join(ROOT, "docs/accuracy"))
    parser.add_argument("--rounds", type=int, help="of seconds by engine (quick: 1, else 5)")
    parser.add_argument("--jobs", type=int, default=len(os.sched_getaffinity(0)))
    parser.add_argument("--build", default=os.path.join(ROOT, "build/openmp"), help="where the programs are")
    return parser.parse_args()


def main():
    arguments = read_arguments()
    say = lambda text: print("==", text, file=sys.stderr, flush=True)
    form = FORMS[arguments.form]
    if arguments.rounds:
        form = replace(form, rounds=arguments.rounds)
    if set(arguments.only) - {"collision", "pictures", "implicit", "auto", "quasi_static"}:
        wanted = [case.state for case in CASES]
        if "engines" in arguments.only:
            wanted += [row.state for row in engines.ROWS]
        states.make(os.path.join(arguments.build, "bagnold"), arguments.states, dict.fromkeys(wanted),
                    arguments.form == "tiny", say)
    tables = Tables(os.path.join(arguments.build, "bagnold_accuracy"), arguments.states, arguments.data,
                    form, arguments.jobs, say)
    for name in TABLES:
        if name in arguments.only:
            getattr(tables, name)()
    if "pictures" in arguments.only:
        say("pictures")
        pictures.draw(arguments.data, arguments.pictures)


if __name__ == "__main__":
    main()
