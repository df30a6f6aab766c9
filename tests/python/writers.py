# SPDX-License-Identifier: BSD-3-Clause
"""Configurations that are known, written as many programs write them, and sometimes spoiled: what is imported is what was
written, or it is refused, or told that it may be another."""

import dataclasses

import numpy as np

SMALL, BIG = 0.5, 0.7  # radii


@dataclasses.dataclass
class Truth:
    """Disks that hardly touch in a tilted cell, lengths in d_s of the file; its lower left corner at the origin."""

    length: float
    height: float
    tilt: float
    place: np.ndarray  #: [N, 2], in the tilted cell
    velocity: np.ndarray  #: [N, 2]
    spin: np.ndarray  #: [N]
    radius: np.ndarray  #: [N]

    def in_rectangle(self):
        """The images in the rectangle of the lengths."""
        x = self.place[:, 0] % self.length
        return np.stack([x, self.place[:, 1]], axis=1)

    def scaled(self):
        """Shares of the cell's vectors."""
        y = self.place[:, 1] / self.height
        return np.stack([(self.place[:, 0] - y * self.tilt) / self.length, y], axis=1)


def made(random):
    """A jittered lattice."""
    columns, rows = random.choice((4, 6, 8)), random.choice((4, 6))
    spacing = 1.6
    length, height = columns * spacing, rows * spacing
    tilt = random.choice((0.0, 0.0, 1.6, -1.6, 2.4, -3.2, 0.8))
    share = np.array([[(i + 0.5 + 0.1 * random.uniform(-1, 1)) / columns, (j + 0.5 + 0.1 * random.uniform(-1, 1)) / rows]
                      for j in range(rows) for i in range(columns)])
    count = len(share)
    place = np.stack([share[:, 0] * length + share[:, 1] * tilt, share[:, 1] * height], axis=1)
    radius = np.array([SMALL, BIG] * (count // 2))
    number = lambda: round(random.uniform(-1, 1), 4)  # noqa: E731
    return Truth(length, height, tilt, np.round(place, 4), np.array([[number(), number()] for _ in range(count)]),
                 np.array([number() for _ in range(count)]), radius)


@dataclasses.dataclass
class Written:
    """A file, and what an import needs to be told."""

    data: bytes
    format: str
    options: dict
    has_velocity: bool
    has_spin: bool
    unclear: bool = False  #: bounds that LAMMPS would write of another cell: refused, or told
    spoiled: str = ""  #: how: it must be refused


def number(random):
    """A way to write numbers."""
    return random.choice((repr, lambda x: f"{x:.6g}", lambda x: f"{x:.8f}", lambda x: f"{x:.10e}",
                          lambda x: f"{x:.10e}".replace("e", "D"), lambda x: f"{x:+.6f}"))


def cased(random, names):
    """Names as they are, in capitals, or capitalized."""
    how = random.choice((str, str, str, str.upper, str.capitalize))
    return [how(name) for name in names]


def dump(random, truth):
    """A LAMMPS dump, or what passes for one."""
    f, kind = number(random), random.choice(("cell", "cell", "rectangle", "scaled", "unwrapped"))
    corner = np.array([random.choice((0.0, -3.0, 10.5)), random.choice((0.0, -4.0, 2.25))])
    names, place = {
        "cell": (("x", "y"), truth.place + corner), "rectangle": (("x", "y"), truth.in_rectangle() + corner),
        "scaled": (("xs", "ys"), truth.scaled()), "unwrapped": (("xu", "yu"), truth.place + corner)}[kind]
    if kind in ("cell", "rectangle"):
        names = random.choice((names, ("Position.X", "Position.Y"), ("PositionX", "PositionY")))
    order = random.sample(range(len(truth.radius)), len(truth.radius)) if random.random() < 0.5 else range(len(truth.radius))
    table = {"id": [str(k + 1) for k in range(len(place))], "type": ["1" if r == SMALL else "2" for r in truth.radius],
             names[0]: [f(x) for x in place[:, 0].tolist()], names[1]: [f(y) for y in place[:, 1].tolist()]}
    if random.random() < 0.5:
        table["z"] = ["0"] * len(place)
    size = random.choice(("radius", "diameter", "Radius"))
    table[size] = [f((2 if size == "diameter" else 1) * r) for r in truth.radius.tolist()]
    has_velocity, has_spin = random.random() < 0.7, random.random() < 0.4
    if has_velocity:
        for axis, name in enumerate(random.choice((("vx", "vy"), ("Velocity.X", "Velocity.Y"), ("vel_x", "vel_y")))):
            table[name] = [f(v) for v in truth.velocity[:, axis].tolist()]
    if has_spin:
        table[random.choice(("omegaz", "omega_z"))] = [f(w) for w in truth.spin.tolist()]
    for extra in ("fx", "c_1[2]", "ix", "type" if random.random() < 0.2 else "q"):
        if random.random() < 0.3:
            table.setdefault(extra, ["1.5"] * len(place))
    columns = list(table)
    if random.random() < 0.5:
        random.shuffle(columns)
    rows = [random.choice((" ", "\t", "  ")).join(table[name][k] for name in columns) for k in order]
    shown = columns if any("." in name or name[0].isupper() for name in columns) else cased(random, columns)
    low, high = corner[0], corner[0] + truth.length
    edges = bool(truth.tilt) and random.random() < 0.4
    if not edges:
        low, high = low + min(0.0, truth.tilt), high + max(0.0, truth.tilt)
    said, bounds = _bounds(random, f, truth, corner, low, high)
    step = random.choice(("0", "100", "2500", "0.5"))
    time = f"ITEM: TIME\n{f(2.5)}\n" if random.random() < 0.3 else ""
    units = "ITEM: UNITS\nlj\n" if random.random() < 0.3 else ""
    head = random.choice((f"{units}{time}ITEM: TIMESTEP\n{step}\n", f"ITEM: TIMESTEP\n{step}\n{units}{time}"))
    frame = (f"{head}ITEM: NUMBER OF ATOMS\n{len(place)}\nITEM: BOX BOUNDS {said}\n{bounds}"
             f"ITEM: ATOMS {' '.join(shown)}\n" + "".join(f"{row}\n" for row in rows))
    before = random.choice(("", "", frame.replace(" 1 ", " 2 ", 1)))
    return _finished(random, frame, before, rows,
                     Written(b"", "dump", {}, has_velocity, has_spin, edges or bool(truth.tilt and "xlo" in bounds)))


def _bounds(random, f, truth, corner, low, high):
    flags = random.choice(("pp pp pp", "p p p", "pp pp ff", "PP PP FF", ""))
    labels = random.choice(("", "", "", " xlo xhi| ylo yhi| zlo zhi")).split("|") * 3
    lines = [[low, high], [corner[1], corner[1] + truth.height], [-0.5, 0.5]]
    said = flags
    if truth.tilt or random.random() < 0.2:
        said = random.choice((f"xy xz yz {flags}", f"xy xz yz {flags}", flags, f"{flags} xy xz yz")).strip()
        for line, tilt in zip(lines, (truth.tilt, 0.0, 0.0)):
            line.append(tilt)
    return said, "".join(" ".join(f(one) for one in line) + label + "\n" for line, label in zip(lines, labels))


def extxyz(random, truth):
    """Extended XYZ."""
    f, flat = number(random), random.random() < 0.4
    corner = np.array([0.0, 0.0]) if random.random() < 0.5 else np.array([-3.0, 2.5])
    pad = [] if flat else ["0"]
    has_velocity, has_spin, momenta = random.random() < 0.7, random.random() < 0.4, random.random() < 0.4
    count = len(truth.radius)
    table = {random.choice(("species", "Species", "type")): ("S", [["H" if r == SMALL else "He"] for r in truth.radius]),
             random.choice(("pos", "Position", "positions", "POS")): ("R", [[f(x), f(y), *pad] for x, y in (truth.place + corner).tolist()])}
    size = random.choice(("radius", "Radius", "radii", "diameter"))
    table[size] = ("R", [[f((2 if size == "diameter" else 1) * r)] for r in truth.radius.tolist()])
    if has_velocity and momenta:
        table[random.choice(("masses", "mass", "Mass"))] = ("R", [[f(2.0)]] * count)
        table["momenta"] = ("R", [[f(2 * x), f(2 * y), *pad] for x, y in truth.velocity.tolist()])
    if has_velocity and (not momenta or random.random() < 0.5):
        table[random.choice(("velo", "Velocity", "velocities", "vel"))] = ("R", [[f(x), f(y), *pad] for x, y in truth.velocity.tolist()])
    if has_spin:
        table[random.choice(("spin", "omega", "AngularVelocity"))] = ("R", [[f(w)] for w in truth.spin.tolist()])
    order = list(range(count))
    if random.random() < 0.5:
        table[random.choice(("id", "ID", "ParticleIdentifier"))] = ("I", [[str(k + 1)] for k in range(count)])
        random.shuffle(order)
    if random.random() < 0.3:
        table["local_energy"] = ("R", [["0.25"]] * count)
    names = random.sample(list(table), len(table))
    rows = [" ".join(" ".join(table[name][1][k]) for name in names) for k in order]
    properties = ":".join(f"{name}:{table[name][0]}:{len(table[name][1][0])}" for name in names)
    l, h, t = f(truth.length), f(truth.height), f(truth.tilt)  # noqa: E741
    lattice = random.choice((f"{l} 0 0 {t} {h} 0 0 0 1", f"{l} 0.0 0.0 {t} {h} 0.0 0.0 0.0 1.0", f"{l} 0 {t} {h}", f"{l} 0 0 {t} {h} 0",
                             f"{l} {h} 1 {t} 0 0"))
    keys = [random.choice((f'Lattice="{lattice}"', f"Lattice=[{lattice.replace(' ', ', ')}]", f"lattice='{lattice}'")),
            f"Properties={properties}",
            random.choice(('pbc="T T F"', 'pbc="1 1 0"', "pbc=[T, T, F]", "pbc=[True, True, False]", "pbc=T,T,T", 'PBC="true true false"', ""))]
    if corner.any():
        keys.append(f'{random.choice(("Origin", "cell_origin"))}="{f(corner[0])} {f(corner[1])} 0"')
    keys += random.sample(["step=3", "time=2.5", 'config_type="a b"', "energy=-1.5e-3"], random.randrange(4))
    random.shuffle(keys)
    frame = f"{count}\n{' '.join(keys)}\n" + "".join(f"{row}\n" for row in rows)
    return _finished(random, frame, random.choice(("", frame)), rows, Written(b"", "extxyz", {}, has_velocity, has_spin))


def data(random, truth):
    """A LAMMPS data file."""
    f = number(random)
    count = len(truth.radius)
    corner = np.array([random.choice((0.0, -3.0)), random.choice((0.0, 2.25))])
    style = random.choice(("sphere", "atomic"))
    images = random.choice(("", " 0 0 0", " 1 -1 0"))
    order = random.sample(range(count), count)
    place = truth.place + corner
    rows = []
    for k in order:
        kind = "1" if truth.radius[k] == SMALL else "2"
        middle = f"{f(2 * truth.radius[k])} 1.0 " if style == "sphere" else ""
        rows.append(f"{k + 1} {kind} {middle}{f(place[k, 0])} {f(place[k, 1])} 0.0{images}")
    vectors = random.random() < 0.2
    box = (f"{f(truth.length)} 0 0 avec\n{f(truth.tilt)} {f(truth.height)} 0 bvec\n0 0 1 cvec\n{f(corner[0])} {f(corner[1])} -0.5 abc origin\n"
           if vectors else f"{f(corner[0])} {f(corner[0] + truth.length)} xlo xhi\n{f(corner[1])} {f(corner[1] + truth.height)} ylo yhi\n"
           "-0.5 0.5 zlo zhi\n" + (f"{f(truth.tilt)} 0 0 xy xz yz\n" if truth.tilt else ""))
    has_velocity = random.random() < 0.7
    has_spin = has_velocity and style == "sphere"
    velocity = "" if not has_velocity else "\nVelocities\n\n" + "".join(
        f"{k + 1} {f(truth.velocity[k, 0])} {f(truth.velocity[k, 1])} 0" + (f" 0 0 {f(truth.spin[k])}" if has_spin else "") + "\n"
        for k in random.sample(range(count), count))
    text = (f"LAMMPS data file via write_data, version 2 Aug 2023, timestep = 0\n\n{count} atoms\n2 atom types\n\n{box}\n"
            f"Atoms # {style}\n\n" + "".join(f"{row}\n" for row in rows) + velocity)
    options = {"diameters": {"1": 1.0, "2": 1.4}} if style == "atomic" else {}
    return _finished(random, text, "", rows, Written(b"", "lammps", options, has_velocity, has_spin))


def _finished(random, frame, before, rows, written):
    """The bytes, and what was spoiled in them."""
    draw = random.random()
    if draw < 0.06:
        frame, written.spoiled = frame[:-random.randint(1, len(frame) // 2)], "cut"
    elif draw < 0.12:
        row = random.choice(rows)
        frame, written.spoiled = frame.replace(row + "\n", row + random.choice((" 1", " 0.5 0.5", "\t7")) + "\n", 1), "a word more"
    elif draw < 0.18:
        row = random.choice(rows)
        frame, written.spoiled = frame.replace(row + "\n", row.rsplit(None, 1)[0] + "\n", 1), "a word less"
    elif draw < 0.22:
        row = random.choice(rows)
        frame, written.spoiled = frame.replace(row + "\n", "", 1), "a row less"
    text = before + frame
    if random.random() < 0.2:
        text = text.replace("\n", "\r\n")
    written.data = text.encode(random.choice(("utf-8", "utf-8", "utf-8", "utf-8-sig", "utf-16")))
    return written


WRITERS = (dump, extxyz, data)


def wrong(truth, written, made, state, rounding=2e-5):
    """What of an imported state is not as it was written; "" if nothing is, or if it is told that it may be another."""
    if written.unclear and "--bounds edges" in str(made):
        return ""
    box = state.box
    tilt = truth.tilt - truth.length * np.floor(truth.tilt / truth.length + 0.5)
    size = max(truth.length, truth.height) + 11
    off = np.array([box.length - truth.length, box.height - truth.height, (box.tilt - tilt + box.length / 2) % box.length - box.length / 2])
    if np.abs(off).max() > rounding * size:
        return f"box {box}"
    if len(state.position) != len(truth.place):
        return f"{len(state.position)} disks"
    if np.abs(state.diameter - 2 * truth.radius).max() > 1e-9:
        return "diameters"
    away = box.nearest(state.position - box.wrapped(truth.place))[0]
    away = box.nearest(away - away[0])[0]
    if np.abs(away).max() > 2 * rounding * size:
        return f"positions, by {np.abs(away).max():g}"
    if written.has_velocity:
        off = state.velocity - truth.velocity  # a mean may be taken off
        if np.ptp(off, axis=0).max() > 1e-4:
            return "velocities"
    elif np.ptp(state.velocity) != 0:
        return "velocities from nowhere"
    if written.has_spin != (state.spin is not None) or (written.has_spin and np.abs(state.spin - truth.spin).max() > 1e-4):
        return "spins"
    return ""
