# SPDX-License-Identifier: BSD-3-Clause
"""A packing with its contact forces, right at the images: the drawing of one frame, alone or in a film."""

import numpy as np

from .style import plt
from ..contacts import Contacts, contacts_of
from ..errors import InputError
from ..frames import Frame
from ..results import Run

from matplotlib.collections import EllipseCollection, LineCollection

WIDEST = 2.6  # points, of a contact with thrice the mean force, where disks are as large as in INCHES
INCHES = 5.0
SLICE = 2.0  # d_s, of the profile that a local rate is the slope of
# Colours of disks: name in a legend, unit, colours, whether they are about 0
KINDS = {
    "velocity": (r"$(v_x - \dot\gamma y)/(\dot\gamma d_s)$", "PuOr", True),
    "speed": (r"$|v - \dot\gamma y\hat x|/(\dot\gamma d_s)$", "magma_r", False),
    "rate": (r"local rate $/\dot\gamma$", "YlOrRd", False),
    "spin": (r"$\dot\theta/\dot\gamma$", "PuOr", True),
    "contacts": ("contacts of the disk", "viridis", False),
    "size": ("", "Greys", False),
}


def values_of(frame: Frame, color, contacts: Contacts):
    """Values that colour the disks, [N]."""
    rate = frame.strain_rate or 1.0
    if not isinstance(color, str):
        values = np.asarray(color, dtype=float)
        if values.shape != (len(frame),):
            raise InputError(f"color has the shape {values.shape} (must be ({len(frame)},): a number for each disk), or is one of "
                             f"{', '.join(KINDS)}")
        return values
    if color == "velocity":
        return frame.nonaffine_velocity[:, 0] / rate
    if color == "speed":
        return np.hypot(*frame.nonaffine_velocity.T) / abs(rate)
    if color == "rate":
        return local_rate(frame) / rate
    if color == "spin":
        if frame.spin is None:
            raise InputError("color = 'spin' (this frame has no spins, for its law does not rotate disks); use 'velocity'")
        return frame.spin / rate
    if color == "contacts":
        return contacts.degree.astype(float)
    if color == "size":
        return (frame.diameter > 1.2) * 0.35 + 0.15
    raise InputError(f"color = {color!r} (must be a number for each disk, or one of {', '.join(KINDS)})")


def local_rate(frame: Frame):
    """Slope of the mean v_x of slices at each disk, [N], 1/tau_e."""
    place = frame.box.wrapped(frame.position)
    height = frame.box.height
    slices = max(4, int(height / SLICE))
    excess = frame.velocity[:, 0] - frame.strain_rate * frame.position[:, 1]  # the same at all images
    which = np.minimum((place[:, 1] / height * slices).astype(int), slices - 1)
    mean = np.bincount(which, excess, minlength=slices) / np.maximum(np.bincount(which, minlength=slices), 1)
    slope = (np.roll(mean, -1) - np.roll(mean, 1)) * slices / (2 * height)
    return frame.strain_rate + slope[which]


def with_images(place, radius, box):
    """Indices and positions of all disks visible in the rectangle, images too."""
    found = []
    for row in (-1, 0, 1):
        for column in (-2, -1, 0, 1, 2):
            moved = place + [column * box.length + row * box.tilt, row * box.height]
            shows = (moved > -radius[:, None]).all(1) & (moved < np.array([box.length, box.height]) + radius[:, None]).all(1)
            found.append((np.flatnonzero(shows), moved[shows]))
    return np.concatenate([index for index, _ in found]), np.concatenate([moved for _, moved in found])


class Packing:
    """Axes that show a frame, and then others of the same disks."""

    def __init__(self, axes, frame, contacts, color="velocity", forces=True):
        self.axes, self.color, self.forces = axes, color, forces
        axes.set(aspect="equal", xticks=[], yticks=[])
        for spine in axes.spines.values():
            spine.set_visible(True)
        values = values_of(frame, color, contacts)
        name, colours, about_zero = KINDS.get(color, ("", "viridis", False)) if isinstance(color, str) else ("", "viridis", False)
        if about_zero:
            high = np.percentile(np.abs(values), 97) or 1.0
            self.limits = (-high, high)
        else:
            self.limits = (0.0, 1.0) if isinstance(color, str) and color == "size" else tuple(np.percentile(values, [2, 98]))
        self.colours, self.name = colours, name
        self.disks = self.lines = None
        self.show(frame, contacts)

    def show(self, frame, contacts):
        """This frame in place of the last one."""
        for old in (self.disks, self.lines):
            if old is not None:
                old.remove()
        box = frame.box  # which a held pressure changes
        self.axes.set(xlim=(0, box.length), ylim=(0, box.height))
        place = box.wrapped(frame.position)
        index, places = with_images(place, frame.diameter / 2, box)
        size = frame.diameter[index]
        self.disks = EllipseCollection(size, size, 0, units="xy", offsets=places, transOffset=self.axes.transData,
                                       array=values_of(frame, self.color, contacts)[index], cmap=self.colours, ec="#333333",
                                       lw=0.3 if len(frame) <= 3000 else 0.0, clim=self.limits)
        self.axes.add_collection(self.disks)
        self.lines = None
        force = contacts.normal_force if np.isfinite(contacts.normal_force).all() else contacts.elastic_force
        force = np.abs(force)
        if self.forces and len(contacts) and force.mean() > 0:
            away = contacts.separation[:, None] * contacts.normal
            ends = np.concatenate([np.stack([place[contacts.i], place[contacts.i] - away], 1),
                                   np.stack([place[contacts.j] + away, place[contacts.j]], 1)])  # from either disk
            ends, which = self._shown(ends, box)
            width = np.minimum(np.tile(force / force.mean(), 2)[which] / 3, 1.5) * WIDEST
            width *= min(1.0, 25 / max(box.length, box.height))
            self.lines = LineCollection(ends, linewidths=width, colors="black", capstyle="round", zorder=3)
            self.axes.add_collection(self.lines)

    @staticmethod
    def _shown(ends, box):
        """Lines that cross the rectangle, images too, and their indices."""
        found = []
        for row in (-1, 0, 1):
            for column in (-1, 0, 1):
                moved = ends + [column * box.length + row * box.tilt, row * box.height]
                low, high = moved.min(1), moved.max(1)
                shows = (high > 0).all(1) & (low < [box.length, box.height]).all(1)
                found.append((moved[shows], np.flatnonzero(shows)))
        return np.concatenate([one for one, _ in found]), np.concatenate([one for _, one in found])

    def add_legend(self, figure):
        """A bar of the colours, where they have a name."""
        if self.name:
            bar = figure.colorbar(self.disks, ax=self.axes, shrink=0.75, pad=0.02, extend="both" if self.limits[0] < 0 else "max")
            bar.set_label(self.name)
            bar.outline.set_linewidth(0.5)


def frame_of(source, which=-1):
    """A frame and its contacts: of a run frame `which` of its trajectory, else its last state."""
    if isinstance(source, Frame):
        disks = {"model": "", "elasticity": 1.0, "force_exponent": 2.0}  # of no known law: the elastic force
        return source, contacts_of(source, {"disks": disks})
    run = source if isinstance(source, Run) else Run(source)
    if (run.folder / "trajectory.h5md").exists() or float(run.scene.get(f"output.{run.frame_spacing}", 0)) > 0:
        return run.frames[which], run.contacts[which]
    frame = run.state
    return frame, contacts_of(frame, run.scene)


def draw(source, which=-1, color="velocity", forces=True, axes=None):
    """The figure of one frame."""
    frame, contacts = frame_of(source, which)
    if isinstance(forces, Contacts):
        contacts, forces = forces, True
    if axes is None:
        shape = frame.box.height / frame.box.length
        _, axes = plt.subplots(figsize=(INCHES + 1.0, float(np.clip(INCHES * shape, 1.5, 9))), layout="constrained")
    made = Packing(axes, frame, contacts, color, forces)
    made.add_legend(axes.figure)
    if np.isfinite(frame.strain):
        axes.set_title(rf"$\gamma$ = {frame.strain:.3g}, $\dot\gamma\tau_e$ = {frame.strain_rate:.3g}, Z = {contacts.Z:.2f}")
    return axes.figure


class Film:
    """Frames one after the other in one figure: the packing, and below it a series with the place of the frame."""

    def __init__(self, run, frames, color="velocity", forces=True, series=""):
        self.run, self.frames, self.contacts = run, frames, type(run.contacts)(frames, run.scene)
        first = frames[0]
        shape = float(np.clip(first.box.height / first.box.length, 0.2, 2))
        self.figure, (top, self.below) = plt.subplots(2, 1, figsize=(INCHES + 0.8, INCHES * shape + 1.6), layout="constrained",
                                                      height_ratios=[INCHES * shape, 1.3])
        self.packing = Packing(top, first, self.contacts[0], color, forces)
        self.packing.limits = self._limits(color)
        self.packing.show(first, self.contacts[0])
        self.packing.add_legend(self.figure)
        self.title = top.set_title("")
        ramp = run.scene.get("shear.protocol", "steady") == "ramp"
        self.strain, values, name, log = self._series(series, ramp)
        self.below.plot(self.strain, values, color="#0072B2", lw=0.9)
        self.below.set(xlabel=r"strain $\gamma$", ylabel=name, yscale="log" if log else "linear",
                       xlim=(self.strain.min(), self.strain.max()))
        self.mark = self.below.axvline(first.strain, color="#D55E00", lw=1.5)

    def _limits(self, color):
        """Limits from a dozen frames, so that colours mean the same in all."""
        few = range(0, len(self.frames), max(1, len(self.frames) // 12))
        values = np.concatenate([values_of(self.frames[k], color, self.contacts[k]) for k in few])
        if self.packing.limits[0] < 0:
            high = np.percentile(np.abs(values), 97) or 1.0
            return (-high, high)
        return self.packing.limits if color == "size" else tuple(np.percentile(values, [2, 98]))

    def _series(self, name, ramp):
        series = self.run.series
        if ramp and not name and "strain_rate" not in series:
            return (np.array([frame.strain for frame in self.frames]), np.array([frame.strain_rate for frame in self.frames]),
                    r"$\dot\gamma\tau_e$", True)
        name = name or ("strain_rate" if ramp else "sigma")
        if name not in series:
            raise InputError(f"series = {name!r} (must be one of {', '.join(series)})")
        strain, values = np.atleast_2d(series["strain"])[0], np.atleast_2d(series[name])[0]
        known = np.isfinite(strain)  # of a run that goes on the first replica may be behind
        strain, values = strain[known], values[known]
        return strain, values, name, bool((values > 0).all() and values.max() > 20 * values.min())

    def show(self, number):
        """Frame `number` of those chosen."""
        frame, contacts = self.frames[number], self.contacts[number]
        self.packing.show(frame, contacts)
        self.title.set_text(rf"$\gamma$ = {frame.strain:.2f}, $\dot\gamma\tau_e$ = {frame.strain_rate:.3g}, Z = {contacts.Z:.2f}")
        self.mark.set_xdata([frame.strain, frame.strain])

    def close(self):
        """Closes the figure."""
        plt.close(self.figure)
