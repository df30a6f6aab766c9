# SPDX-License-Identifier: BSD-3-Clause
"""What the numbers were taken with."""
import os
import re
import shlex
import statistics
import subprocess


def model():
    """The name of the processor."""
    try:
        with open("/proc/cpuinfo") as file:
            names = [line.split(":", 1)[1].strip() for line in file if line.startswith("model name")]
    except OSError:
        names = []
    return names[0] if names else "unknown processor"


def bagnold_info(program):
    """{name: value} of `bagnold info`."""
    lines = subprocess.run([program, "info"], check=True, capture_output=True, text=True).stdout
    return dict(line.split(None, 1) for line in lines.splitlines())


def lammps_version(program):
    done = subprocess.run([program, "-h"], capture_output=True, text=True)
    found = re.search(r"Simulator - (.+)", done.stdout)
    return f"LAMMPS {found[1]}" if found else "LAMMPS"


def preamble(program, lammps, rounds, quick, arguments):
    info = bagnold_info(program)
    clocks = [times["clock"] / 1e9 for once in rounds for times in once.values() if "clock" in times]
    clock = "clock unknown"
    if clocks:
        clock = f"{statistics.median(clocks):.2f} GHz ({min(clocks):.2f}-{max(clocks):.2f}) by dependent additions"
    command = shlex.join(["scripts/bench", *arguments])
    warning = "**Small systems and a thousandth of the strain: no measurement.** " if quick else ""
    return (f"{warning}{model()}, {os.cpu_count()} cores, {clock}; {info['compiler']}, Kokkos {info['Kokkos']}, "
            f"Bagnold {info['git']}, {lammps_version(lammps) if lammps else 'no LAMMPS'}. `{command}`: "
            f"rounds: {len(rounds)}, interleaved; median (least-most) over rounds, ratios within a round. "
            "Time is CPU time of one core, with several threads that of the wall.")
