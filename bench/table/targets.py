# SPDX-License-Identifier: BSD-3-Clause
"""What is timed, and what it is held against."""
import re
from dataclasses import dataclass

SPEED = "disk_steps_per_second"
SECONDS = "seconds_per_strain"
CYCLES = "cycles_per_disk_step"
WALL = "wall_disk_steps_per_second"
LAMMPS = "lammps"  # the "engine" of runs by LAMMPS
LAMMPS_LONGEST = "lammps-longest"  # with the longest step whose bias is below 1% (bench/peers)
DEFAULT = "default"  # engine and scheme of a scene that names none


def state_of(row):
    """The state that a row (STATE, STATE/threads:T or STATE/side_by_side:T) starts from."""
    return row.split("/")[0]


def threads_of(row):
    """Of Kokkos."""
    match = re.search(r"/threads:(\d+)$", row)
    return int(match[1]) if match else 1


def benchmark_of(row, engine):
    """Its name in bagnold_bench."""
    state, *threads = row.split("/")
    return "/".join([state, engine, *threads])


ROWS = [
    "cd_rot82-1e-4-1024", "cd_rot82-1e-4-65536", "cd_rot82-1e-4-65536/threads:2",
    "cd_rot82-1e-4-1024x2", "cd_rot82-1e-4-1024x2/side_by_side:2",
    "cd_rot82-1e-4-16384", "cd_rot82-1e-4-1048576",
    "cd_n-q50-1e-4-1024", "cd_n-q50-1e-5-1024", "cd_n-q50-1e-6-1024",
    "cd_n-q50-1e-5-65536", "cd_n-q50-1e-6-65536", "cd_n-q1-1e-5-1024", "cd_rot76-1e-5-1024",
]
# Where LAMMPS runs too: with `steps` disk-steps, seconds on one core.
PEER_ROWS = {"cd_rot82-1e-4-1024": 4e7, "cd_rot82-1e-4-65536": 4e7, "cd_n-q50-1e-4-1024": 1.5e8,
             "cd_n-q50-1e-5-1024": 1.5e8, "cd_n-q50-1e-5-65536": 1e8}


@dataclass(frozen=True)
class Target:
    """A quantity of a row, or its ratio to another row's or engine's in the same round."""

    what: str
    quantity: str
    row: str
    limit: float
    at_least: bool = True
    other_row: str = ""
    other_engine: str = ""
    unit: float = 1.0  # the limit's, in that of the quantity

    def values(self, rounds, engine):
        """One for each round in which all that it needs was timed."""
        found = []
        for times in rounds:
            value = times.get((self.row, engine), {}).get(self.quantity)
            if self.other_row or self.other_engine:
                other = times.get((self.other_row or self.row, self.other_engine or engine), {})
                other = other.get(self.quantity)
                value = value / other if value and other else None
            if value:
                found.append(value / self.unit)
        return found

    def met(self, value):
        return value >= self.limit if self.at_least else value <= self.limit


def below(what, quantity, row, limit, **other):
    return Target(what, quantity, row, limit, at_least=False, **other)


ROT, DISKS, LARGE = "cd_rot82-1e-4-1024", "cd_n-q50-1e-4-1024", "cd_n-q50-1e-5-65536"

TARGETS = [
    Target("CD_rot 0.82, Q = 1, 1e-4, N = 1024: million disk-steps/s", SPEED, ROT, 60, unit=1e6),
    below("the same, cycles a disk-step", CYCLES, ROT, 40),
    Target("N = 65536: million disk-steps/s", SPEED, "cd_rot82-1e-4-65536", 50, unit=1e6),
    below("the same, cycles a disk-step", CYCLES, "cd_rot82-1e-4-65536", 48),
    below("the same over N = 1024", CYCLES, "cd_rot82-1e-4-65536", 1.15, other_row=ROT),
    below("CD_n 0.78, Q = 50, 1e-4, N = 1024: s of CPU per unit strain", SECONDS, DISKS, 0.5),
    below("1e-5 over 1e-4", SECONDS, "cd_n-q50-1e-5-1024", 1.5, other_row=DISKS),
    below("1e-6 over 1e-4", SECONDS, "cd_n-q50-1e-6-1024", 2, other_row=DISKS),
    below("1e-5, N = 65536: s of CPU per unit strain", SECONDS, LARGE, 50),
    below("1e-6, N = 65536: s of CPU per unit strain", SECONDS, "cd_n-q50-1e-6-65536", 50),
    below("1e-6 over 1e-5, N = 65536", SECONDS, "cd_n-q50-1e-6-65536", 1.3, other_row=LARGE),
    below("CD_n 0.78, Q = 1, 1e-5, N = 1024: s of CPU per unit strain", SECONDS, "cd_n-q1-1e-5-1024", 3),
    below("CD_rot 0.76, Q = 1, 1e-5, N = 1024: s of CPU per unit strain", SECONDS, "cd_rot76-1e-5-1024", 12),
    Target("CD_rot 0.82, N = 65536: two threads over one", WALL, "cd_rot82-1e-4-65536/threads:2", 1.85,
           other_row="cd_rot82-1e-4-65536"),
    Target("CD_rot 0.82, two replicas of N = 1024: two threads over one", WALL,
           "cd_rot82-1e-4-1024x2/side_by_side:2", 1.95, other_row="cd_rot82-1e-4-1024x2"),
    below("CD_rot 0.82: CPU time of a disk-step, N = 1048576 over 16384", CYCLES, "cd_rot82-1e-4-1048576",
          1.4, other_row="cd_rot82-1e-4-16384"),
    Target("CD_rot 0.82, N = 1024: speed over LAMMPS', per step", SPEED, ROT, 5, other_engine=LAMMPS),
    Target("N = 65536", SPEED, "cd_rot82-1e-4-65536", 5, other_engine=LAMMPS),
    Target("CD_n 0.78, Q = 50, 1e-4, N = 1024: speed over LAMMPS', per step", SPEED, DISKS, 20,
           other_engine=LAMMPS),
    Target("1e-5", SPEED, "cd_n-q50-1e-5-1024", 100, other_engine=LAMMPS),
]
