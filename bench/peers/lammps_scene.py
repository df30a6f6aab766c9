#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Writes a Bagnold state and the parameters of its scene as LAMMPS data and input.

    lammps_scene.py state.h5 FOLDER --model CD_rot --elasticity 1 --rate 1e-4 --mass equal --check

Units are Bagnold's: d_s, tau_e, m, so k_e = 1 and k_d = 1/Q. LAMMPS calls them lj units.

The law in LAMMPS' words. `gran/hooke` has for two disks that touch (manual: pair_style gran/hooke)

    F_n = k_n (d_ij - r) n - m_eff gamma_n v_n        F_t = -m_eff gamma_t v_t, |F_t| <= xmu |F_n|

with m_eff = m_i m_j / (m_i + m_j). The papers' law (PRE 95, 052903 (2017), Eqs. 2-7) is that with
k_n = k_e / d_ij^2 and gamma_n = k_d / m_eff; CD_rot has gamma_t = gamma_n, CD_n gamma_t = 0. All of
them depend on the two types, and the coefficients of gran/hooke are global: so three of them under
`hybrid`. What stays different from the papers, for CD_rot only:
- the contact point lies at d_i/2 from the centre, in the papers at r d_i/(d_i + d_j) (P2 Eq. 6):
  a relative difference of the size of the overlap;
- xmu is at most 1e4 in LAMMPS, so a tangential force 1e4 times the normal one would be cut.
Model CD (dissipation with no lever) has no granular style.

Shear is `fix deform ... remap v`: nothing happens to a disk but a jump of gammadot L in v_x when it
crosses a face in y, and ghosts carry that jump: Lees-Edwards, momentum conserved. (`remap x` with
`nvt/sllod` would displace all disks affinely and needs a thermostat; that is another dynamics.)
"""
import argparse
import os
from dataclasses import dataclass

import h5py
import numpy as np

XMU = 1e4  # the most that gran/hooke accepts


@dataclass
class Scene:
    """The physics: what both programs must agree on."""

    model: str  # "CD_n" or "CD_rot"
    elasticity: float  # Q = 1/k_d
    rate: float  # gammadot [1/tau_e]
    mass: str  # "equal": m = 1; "area": m = (pi/2) d^2
    time_step: float = 0.05  # [tau_e]

    def masses(self, diameter):
        return np.ones_like(diameter) if self.mass == "equal" else 0.5 * np.pi * diameter**2


@dataclass
class Tuning:
    """What changes only the speed of LAMMPS."""

    style: str = "hybrid"  # "hybrid": three gran/hooke; "granular": the newer style;
    # "single": one gran/hooke, k_n wrong for two of three pairs: an upper bound, not the physics
    skin: float = 0.35  # [d_s]
    every: int = 10  # steps between looks at whether the list is still valid
    newton: str = "on"
    centred: bool = True  # y in (-L/2, L/2): half the largest speed, half the builds
    order: str = "rows"  # of the disks in the data file: "rows" or "blocks" of cells, or "given".
    # LAMMPS' own sorting is off: this version (atom.cpp, Atom::sort) bins the coordinates of a
    # leaning box while they are still fractions, and so leaves the disks as they were.


@dataclass
class State:
    position: np.ndarray  # [N][2]
    velocity: np.ndarray  # [N][2], in the laboratory
    spin: np.ndarray  # [N]
    diameter: np.ndarray  # [N]
    length: float  # L
    offset: float  # of the image above, in (-L/2, L/2]


def read_state(path, rate):
    """A state; its velocities scaled to the rate (P2 Eqs. 40-41), as Bagnold's start does it."""
    with h5py.File(path) as file:
        group = file["state"]
        at = group.attrs
        scale = rate / at.get("strain_rate", rate)
        length = float(at["box_length"])
        offset = float(at["offset"]) % length
        offset -= length if offset > length / 2 else 0.0
        spin = group["spin"][:] if "spin" in group else np.zeros(len(group["diameter"]))
        return State(group["position"][:], scale * group["velocity"][:], scale * spin,
                     group["diameter"][:], length, offset)


def wrapped(state, rate, centred):
    """The same state with y in the box, seen from the frame in which the box's middle or floor rests."""
    low = -0.5 * state.length if centred else 0.0
    shift = np.floor(state.position[:, 1] / state.length)
    x = state.position[:, 0] - shift * state.offset
    y = state.position[:, 1] - shift * state.length + low
    vx = state.velocity[:, 0] + (low - shift * state.length) * rate
    # The sides of the box lean: x + m L lies between tilt * (y - low) and that + L.
    lean = state.offset * (y - low) / state.length
    x = lean + (x - lean) % state.length
    return State(np.stack([x, y], 1), np.stack([vx, state.velocity[:, 1]], 1), state.spin,
                 state.diameter, state.length, state.offset)


def spatial_order(state, order):
    """Disks by cells of side 1, row after row or in nested blocks of 2 x 2 (Morton), so that
    neighbours are close in memory: worth a factor 2 to 3 at N = 65536."""
    if order == "given":
        return np.arange(len(state.diameter))
    low = state.position[:, 1].min()
    lean = state.offset * (state.position[:, 1] - low) / state.length
    column = ((state.position[:, 0] - lean) % state.length).astype(np.int64)
    row = (state.position[:, 1] - low).astype(np.int64)
    if order == "rows":
        return np.lexsort((column, row))
    key = np.zeros_like(row)
    for bit in range(16):
        key |= ((column >> bit) & 1) << (2 * bit) | ((row >> bit) & 1) << (2 * bit + 1)
    return np.argsort(key, kind="stable")


def write_data(path, state, scene, tuning):
    state = wrapped(state, scene.rate, tuning.centred)
    low = -0.5 * state.length if tuning.centred else 0.0
    big = state.diameter > 1.2
    density = scene.masses(state.diameter) / (np.pi / 6 * state.diameter**3)  # LAMMPS means a sphere
    with open(path, "w") as out:
        out.write(f"Bagnold state\n\n{len(big)} atoms\n2 atom types\n\n"
                  f"0 {state.length:.17g} xlo xhi\n{low:.17g} {low + state.length:.17g} ylo yhi\n"
                  f"-0.5 0.5 zlo zhi\n{state.offset:.17g} 0 0 xy xz yz\n\nAtoms # sphere\n\n")
        for i in spatial_order(state, tuning.order):
            x, y = state.position[i]
            out.write(f"{i + 1} {1 + big[i]} {state.diameter[i]:.17g} {density[i]:.17g} "
                      f"{x:.17g} {y:.17g} 0\n")
        out.write("\nVelocities\n\n")
        for i, (vx, vy) in enumerate(state.velocity):
            out.write(f"{i + 1} {vx:.17g} {vy:.17g} 0 0 0 {state.spin[i]:.17g}\n")


def pair_lines(scene, style):
    """pair_style and pair_coeff: type 1 small, type 2 big."""
    diameter = np.array([1.0, 1.4])
    mass = scene.masses(diameter)
    rotates = scene.model == "CD_rot"
    damping = 1 / scene.elasticity
    heads, coefficients = [], []
    for n, (i, j) in enumerate([(0, 0), (0, 1), (1, 1)]):
        contact_distance = 0.5 * (diameter[i] + diameter[j])
        reduced_mass = mass[i] * mass[j] / (mass[i] + mass[j])
        stiffness = 1 / contact_distance**2
        gamma = damping / reduced_mass
        pair = f"{i + 1} {j + 1}"
        if style == "granular":
            coefficients.append(
                f"pair_coeff {pair} hooke {stiffness:.17g} {damping:.17g} "
                f"tangential linear_nohistory {int(rotates)} 1e300 damping velocity")
        else:
            heads.append(f"gran/hooke {stiffness:.17g} 0 {gamma:.17g} "
                         f"{gamma if rotates else 0:.17g} {XMU:g} {int(rotates)}")
            coefficients.append(f"pair_coeff {pair} gran/hooke {n + 1}")
    if style == "granular":
        return ["pair_style granular"] + coefficients
    if style == "single":
        return ["pair_style " + heads[0], "pair_coeff * *"]
    return ["pair_style hybrid " + " ".join(heads)] + coefficients


def head_lines(scene, tuning):
    """Up to the physics; no computes, no output."""
    small, big = scene.masses(np.array([1.0, 1.4]))
    integrate = "nve/sphere disc" if scene.model == "CD_rot" else "nve"  # CD_n needs no spins
    return ["units lj", "dimension 2", "processors 1 1 1", f"newton {tuning.newton}",
            "boundary p p p", "atom_style sphere", "atom_modify sort 0 0",
            "comm_modify vel yes", "read_data scene.data", f"set type 1 mass {small:.17g}",
            f"set type 2 mass {big:.17g}", *pair_lines(scene, tuning.style),
            f"neighbor {tuning.skin:.17g} bin",
            f"neigh_modify delay 0 every {tuning.every} check yes",
            f"timestep {scene.time_step:.17g}", f"fix move all {integrate}",
            f"fix shear all deform 1 xy erate {scene.rate:.17g} remap v", "thermo_modify norm no"]


def write_scene(folder, state, scene, tuning, tail):
    """FOLDER/scene.data and FOLDER/in.scene, which ends with the lines of `tail`."""
    os.makedirs(folder, exist_ok=True)
    write_data(os.path.join(folder, "scene.data"), state, scene, tuning)
    with open(os.path.join(folder, "in.scene"), "w") as out:
        out.write("\n".join(head_lines(scene, tuning) + tail) + "\n")


def timed_tail(steps, warm_up):
    """An untimed run, then the timed one: no thermodynamic output but at its two ends."""
    return ["thermo 0", f"run {warm_up}", f"run {steps}"]


# The forces of step 0. Not `run 0`: fix deform takes the rate of the box from the length of the run,
# so with no step ghosts carry no jump.
FORCE_TAIL = ["dump force all custom 10 force.dump id fx fy tqz",
              "dump_modify force sort id format float %.17g", "run 1"]


def sample_tail(steps, every, samples=1):
    """Stress and contacts to stress.txt, a line every `every` steps: step, p_xx, p_yy, p_xy of the
    forces, contacts a disk, means of `samples` evenly spaced steps."""
    return ["compute stress all pressure NULL virial", "compute touch all contact/atom",
            "compute contacts all reduce ave c_touch",
            f"fix out all ave/time {every // samples} {samples} {every} c_stress[1] c_stress[2] "
            "c_stress[4] c_contacts file stress.txt format ' %.17g'", f"thermo {steps}", f"run {steps}"]


def all_pairs(state, scene, lammps_lever=False):
    """Forces and torques of the papers' law, all pairs, plain: [N][2], [N], and the sum of |f| a disk.

    P2 Eqs. 2-7; the lever of disk i is -n r d_i/(d_i + d_j), or -n d_i/2 as LAMMPS has it.
    """
    count = len(state.diameter)
    force, torque, size = np.zeros((count, 2)), np.zeros(count), np.zeros(count)
    for i in range(count):
        dr = state.position[i] - state.position
        rows = np.round(dr[:, 1] / state.length)
        dr[:, 1] -= rows * state.length
        dr[:, 0] -= rows * state.offset
        dr[:, 0] -= np.round(dr[:, 0] / state.length) * state.length
        dv = state.velocity[i] - state.velocity
        dv[:, 0] -= rows * scene.rate * state.length
        reach = 0.5 * (state.diameter[i] + state.diameter)
        r = np.hypot(dr[:, 0], dr[:, 1])
        touch = (r < reach) & (np.arange(count) != i)
        dr, dv, r, reach = dr[touch], dv[touch], r[touch], reach[touch]
        n = dr / r[:, None]
        normal_force = (1 - r / reach) / reach - np.sum(dv * n, 1) / scene.elasticity
        pair = normal_force[:, None] * n
        if scene.model == "CD_rot":
            stretch = 1.0 if lammps_lever else r / reach
            # v^C = v + spin z^ x lever; for i the lever is -n d_i/2, for j it is +n d_j/2
            turn = 0.5 * stretch * (state.spin[i] * state.diameter[i]
                                    + state.spin[touch] * state.diameter[touch])
            t = np.stack([-n[:, 1], n[:, 0]], 1)
            tangential = -(np.sum(dv * t, 1) - turn) / scene.elasticity
            pair = pair + tangential[:, None] * t
            torque[i] = np.sum(-0.5 * state.diameter[i] * stretch * tangential)
        force[i] = pair.sum(0)
        size[i] = np.hypot(pair[:, 0], pair[:, 1]).sum()
    return force, torque, size


def check_forces(folder, state, scene):
    """Compares force.dump with all pairs; prints the largest differences."""
    dump = np.loadtxt(os.path.join(folder, "force.dump"), skiprows=9)
    for name, lever in [("the papers' law", False), ("the papers' law with LAMMPS' lever", True)]:
        force, torque, size = all_pairs(state, scene, lever)
        touched = size > 0
        worst = np.max(np.abs(dump[:, 1:3] - force), 1)
        print(f"LAMMPS against {name}: force, largest difference "
              f"{worst.max() / np.abs(force).max():.1e} of the largest force, "
              f"{np.max(worst[touched] / size[touched]):.1e} of the disk's own contact forces; "
              f"not touched: {worst[~touched].max(initial=0):.1e}")
        if scene.model == "CD_rot":
            print(f"    torque: {np.abs(dump[:, 3] - torque).max() / np.abs(torque).max():.1e} "
                  "of the largest torque")


def add_scene_arguments(parser):
    parser.add_argument("--model", choices=["CD_n", "CD_rot"], required=True)
    parser.add_argument("--elasticity", type=float, required=True, help="Q")
    parser.add_argument("--rate", type=float, required=True, help="gammadot [1/tau_e]")
    parser.add_argument("--mass", choices=["equal", "area"], required=True)
    parser.add_argument("--time-step", type=float, default=0.05, help="[tau_e]")


def add_tuning_arguments(parser):
    parser.add_argument("--style", choices=["hybrid", "granular", "single"], default="hybrid")
    parser.add_argument("--skin", type=float, default=Tuning.skin, help="[d_s]")
    parser.add_argument("--every", type=int, default=Tuning.every)
    parser.add_argument("--newton", choices=["on", "off"], default=Tuning.newton)
    parser.add_argument("--floor", dest="centred", action="store_false",
                        help="y from 0 to L, not -L/2 to L/2")
    parser.add_argument("--order", choices=["rows", "blocks", "given"], default=Tuning.order)


def scene_of(options):
    return Scene(options.model, options.elasticity, options.rate, options.mass, options.time_step)


def tuning_of(options):
    return Tuning(options.style, options.skin, options.every, options.newton, options.centred,
                  options.order)


def main():
    parser = argparse.ArgumentParser(description=__doc__.splitlines()[0])
    parser.add_argument("state")
    parser.add_argument("folder")
    add_scene_arguments(parser)
    add_tuning_arguments(parser)
    parser.add_argument("--steps", type=int, default=10000)
    parser.add_argument("--warm-up", type=int, default=1000, help="untimed steps before")
    parser.add_argument("--sample", type=int, metavar="EVERY", help="write stress.txt")
    parser.add_argument("--check", action="store_true",
                        help="compare the forces of step 0 in LAMMPS with all pairs")
    parser.add_argument("--lammps", default="lmp")
    options = parser.parse_args()
    scene, tuning = scene_of(options), tuning_of(options)
    state = read_state(options.state, scene.rate)
    if options.check:
        import subprocess
        write_scene(options.folder, state, scene, tuning, FORCE_TAIL)
        subprocess.run([options.lammps, "-in", "in.scene", "-screen", "none"], cwd=options.folder,
                       check=True)
        check_forces(options.folder, state, scene)
        return
    tail = (sample_tail(options.steps, options.sample) if options.sample
            else timed_tail(options.steps, options.warm_up))
    write_scene(options.folder, state, scene, tuning, tail)


if __name__ == "__main__":
    main()
