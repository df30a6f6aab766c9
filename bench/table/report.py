# SPDX-License-Identifier: BSD-3-Clause
"""The tables of docs/performance.md."""
import os
import statistics

import targets
from measure import lammps
from targets import CYCLES, DEFAULT, LAMMPS, LAMMPS_LONGEST, SECONDS, SPEED

TABLE = "scripts/bench"
COUNTERS = {"pairs_per_disk_step": "pairs evaluated a disk-step", "prunings_per_strain": "prunings a strain",
            "builds_per_strain": "builds a strain", "share_in_lookahead": "share of steps done ahead"}


def number(value):
    """Three figures, without an exponent."""
    return f"{value:.0f}" if value >= 100 else f"{value:.3g}"


def spread(values):
    if not values:
        return "-"
    middle, low, high = (number(pick(values)) for pick in (statistics.median, min, max))
    return middle if low == high else f"{middle} ({low}-{high})"


def values_of(rounds, row, engine, quantity, unit=1.0):
    found = [times.get((row, engine), {}).get(quantity) for times in rounds]
    return [value / unit for value in found if value is not None]


def ratio(rounds, row, engine, to):
    return targets.Target("", SPEED, row, 0, other_engine=to).values(rounds, engine)


def table(heads, lines):
    return "\n".join(["| " + " | ".join(cells) + " |" for cells in [heads, ["---"] * len(heads), *lines]])


def target_table(rounds, engine):
    lines = []
    for target in targets.TARGETS:
        found = target.values(rounds, engine)
        limit = f"{'at least' if target.at_least else 'at most'} {target.limit:g}"
        verdict = "not measured"
        if found:
            verdict = "yes" if target.met(statistics.median(found)) else "**no**"
        lines.append([target.what, limit, spread(found), verdict])
    return table(["target", "", "measured", "met"], lines)


def row_table(rounds, rows, engines):
    """Speeds; those of Bagnold's engines over the reference's and LAMMPS', round by round."""
    lines = []
    for row in rows:
        for engine in [*engines, LAMMPS]:
            speeds = values_of(rounds, row, engine, SPEED, 1e6)
            if not speeds:
                continue
            over_lammps = ratio(rounds, row, engine, LAMMPS)
            lines.append([
                row, "LAMMPS" if engine == LAMMPS else engine,
                spread(values_of(rounds, row, engine, SECONDS)), spread(speeds),
                spread(values_of(rounds, row, engine, CYCLES)),
                spread(ratio(rounds, row, engine, "reference") if engine != "reference" else []),
                f"{spread(over_lammps)}; {number(2 * statistics.median(over_lammps))}"
                if over_lammps and engine != LAMMPS else "-"])
    return table(["row", "engine", "seconds a strain", "million disk-steps/s", "cycles a disk-step",
                  "over the reference", "over LAMMPS: a step; a force evaluation"], lines)


def peer_table(rounds, rows):
    """Seconds of CPU a unit of strain where both programs step as far as a bias of 1% lets them."""
    lines = []
    for row in rows:
        longest = [values_of(rounds, row, one, SECONDS) for one in (LAMMPS, LAMMPS_LONGEST, DEFAULT)]
        if not all(longest):
            continue
        ratios = targets.Target("", SECONDS, row, 0, other_engine=DEFAULT).values(rounds, LAMMPS_LONGEST)
        lines.append([row, spread(longest[0]), f"{lammps.LONGEST[row]:g}", spread(longest[1]),
                      spread(longest[2]), spread(ratios)])
    return table(["row", "LAMMPS, dt = 0.05", "its longest dt", "LAMMPS there", "Bagnold, two stages",
                  "LAMMPS there over Bagnold"], lines) if lines else ""


def counter_table(rounds, rows, engine):
    """Counters are those of the first round: the same in all."""
    lines = []
    for row in rows:
        times = rounds[0].get((row, engine)) if rounds else None
        if times:
            lines.append([row, *(number(times[name]) if name in times else "-" for name in COUNTERS)])
    return table(["row", *COUNTERS.values()], lines)


def text(rounds, rows, engines, preamble):
    first = engines[0]
    parts = [preamble, target_table(rounds, first), row_table(rounds, rows, engines)]
    if peers := peer_table(rounds, rows):
        parts += ["Seconds of CPU a unit of strain at equal bias: LAMMPS with the longest time step whose "
                  "bias is below 1%, Bagnold with its default scheme ([bench/peers]"
                  "(../bench/peers/README.md#the-longest-step)):", peers]
    parts += [f"Counters of the engine `{first}`:", counter_table(rounds, rows, first)]
    return "\n\n".join(parts)


def markers(table):
    return f"<!-- table: {table} -->", f"<!-- end of table: {table} -->"


def put_into(path, table, content):
    """Replaces what stands between the table's two markers in the file; all else stays."""
    begin, end = markers(table)
    with open(path) as file:
        old = file.read()
    if old.count(begin) != 1 or old.count(end) != 1 or old.index(end) < old.index(begin):
        raise SystemExit(f"error: {path} needs one line `{begin}` and after it one `{end}`")
    new = f"{old[:old.index(begin)]}{begin}\n{content}\n{old[old.index(end):]}"
    with open(path + ".tmp", "w") as file:
        file.write(new)
    os.replace(path + ".tmp", path)
