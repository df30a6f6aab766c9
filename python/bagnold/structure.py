# SPDX-License-Identifier: BSD-3-Clause
"""Structure of configurations and contacts: g(r), S(q), non-affine motion, velocity correlations, and the contact
network. Functions take a frame or many (`r.frames[100:]`), contacts or many (`r.contacts`)."""

from __future__ import annotations

from collections.abc import Iterable, Iterator
from typing import Union

import numpy as np
from numpy.typing import NDArray

from .contacts import Contacts, pairs_within
from .errors import InputError
from .frames import Array, Frame, Integers

Configurations = Union[Frame, Iterable[Frame]]
Networks = Union[Contacts, Iterable[Contacts]]


def _frames(given: Configurations) -> Iterable[Frame]:
    return [given] if isinstance(given, Frame) else given


def _networks(given: Networks) -> Iterable[Contacts]:
    return [given] if isinstance(given, Contacts) else given


# ---------------------------------------------------------------------------------- configurations


def radial_distribution(frames: Configurations, r_max: float = 5.0, bins: int = 200,
                        species: tuple[int, int] | None = None) -> tuple[Array, Array]:
    """g(r): pairs at a distance r over what an ideal gas of the density has, averaged over frames.

    r_max: d_s, at most half the shorter side of the box. species: of pairs of these two alone, 0 small
    and 1 big. Returns the middles of the bins, [bins], d_s, and g, [bins]."""
    edges = np.linspace(0, r_max, bins + 1)
    total, expected = np.zeros(bins), np.zeros(bins)
    rings = np.pi * np.diff(edges**2)
    for frame in _frames(frames):
        _refuse_far(frame, r_max)
        i, j, away, _ = pairs_within(frame.position, frame.box, np.zeros(len(frame)), r_max)
        kind = frame.species
        a, b = (len(frame), len(frame)) if species is None else (np.sum(kind == species[0]), np.sum(kind == species[1]))
        if species is None:
            pairs, chosen = a * (a - 1) / 2, np.ones(len(i), dtype=bool)
        else:
            one, other = species
            chosen = ((kind[i] == one) & (kind[j] == other)) | ((kind[i] == other) & (kind[j] == one))
            pairs = a * (a - 1) / 2 if one == other else a * b
        total += np.histogram(np.hypot(*away[chosen].T), edges)[0]
        expected += pairs * rings / frame.box.area
    return (edges[1:] + edges[:-1]) / 2, total / expected


def _refuse_far(frame: Frame, r_max: float) -> None:
    half = min(frame.box.length, frame.box.height) / 2
    if r_max > half:
        raise InputError(f"r_max = {r_max:g} d_s (must be at most half the shorter side of the box, {half:g}); "
                         "take less, or a larger system")


def structure_factor(frames: Configurations, q_max: float = 10.0, bins: int = 100) -> tuple[Array, Array]:
    """Structure factor at the wave vectors that fit the sheared box, averaged over their directions and over frames.

        S(q) = |sum_j exp(-i q . r_j)|^2 / N

    q_max: 1/d_s. Returns the mean length of q in each bin and S, NaN in bins without a wave vector, [bins]."""
    edges = np.linspace(0, q_max, bins + 1)
    power, length, count = np.zeros(bins), np.zeros(bins), np.zeros(bins)
    for frame in _frames(frames):
        reciprocal = 2 * np.pi * np.linalg.inv(frame.box.matrix[:2, :2])  # columns: b_1, b_2
        most = [int(q_max * side / (2 * np.pi)) + 1 for side in
                (frame.box.length, np.hypot(frame.box.tilt, frame.box.height))]
        along, across = np.arange(most[0] + 1), np.arange(-most[1], most[1] + 1)
        q = along[:, None, None] * reciprocal[:, 0] + across[:, None] * reciprocal[:, 1]
        size = np.hypot(q[..., 0], q[..., 1])
        half = (along[:, None] > 0) | (across > 0)  # S(q) = S(-q)
        chosen = half & (size < q_max)
        s, size = _power(frame, along, across)[chosen] / len(frame), size[chosen]
        where = np.clip(np.searchsorted(edges, size, side="right") - 1, 0, bins - 1)
        power += np.bincount(where, s, minlength=bins)
        length += np.bincount(where, size, minlength=bins)
        count += np.bincount(where, minlength=bins)
    with np.errstate(invalid="ignore"):
        return length / count, power / count


KERNEL_WIDTH, KERNEL_EXPONENT = 12, 27.6  # of spreading: cells of the grid; 2.30 a cell, for errors of 1e-11


def _power(frame: Frame, along: Integers, across: Integers) -> Array:
    """|sum_j exp(-2 pi i (n_1 f_1j + n_2 f_2j))|^2 with f_j the place in units of the box's vectors, for all n_1 of `along`
    and n_2 of `across`. By a nonuniform FFT with the exponential of a semicircle as kernel (Barnett, Magland, af Klinteberg,
    SIAM J. Sci. Comput. 41, C479 (2019)): places are spread on a grid, of which an FFT is taken and divided by the kernel's
    own transform."""
    place = frame.position @ np.linalg.inv(frame.box.matrix[:2, :2])
    sizes = [max(4 * int(np.abs(n).max()) + 4, 2 * KERNEL_WIDTH) for n in (along, across)]
    grid = np.zeros(sizes[0] * sizes[1])
    for first in range(0, len(frame), 4096):
        (cells, share), (other_cells, other_share) = (
            _spread(place[first:first + 4096, axis] * size, size) for axis, size in enumerate(sizes))
        where = cells[:, :, None] * sizes[1] + other_cells[:, None, :]
        grid += np.bincount(where.ravel(), (share[:, :, None] * other_share[:, None, :]).ravel(), len(grid))
    total = np.fft.fft2(grid.reshape(sizes))[np.ix_(along % sizes[0], across % sizes[1])]
    total /= np.outer(_kernel_transform(along / sizes[0]), _kernel_transform(across / sizes[1]))
    return np.asarray(total.real**2 + total.imag**2)


def _kernel(z: Array) -> Array:
    """Kernel of spreading, z from -1 to 1 over its width."""
    return np.asarray(np.exp(KERNEL_EXPONENT * (np.sqrt(np.maximum(1 - z * z, 0)) - 1)))


def _spread(x: Array, size: int) -> tuple[Integers, Array]:
    """Cells of a periodic grid that places x, in cells, are spread on, and the share of each, [N, KERNEL_WIDTH]."""
    cells = np.ceil(x - KERNEL_WIDTH / 2).astype(int)[:, None] + np.arange(KERNEL_WIDTH)
    return cells % size, _kernel((cells - x[:, None]) / (KERNEL_WIDTH / 2))


def _kernel_transform(waves: Array) -> Array:
    """Fourier transform of the kernel at waves a cell."""
    z, step = np.linspace(-1, 1, 100, retstep=True)  # the kernel is 1e-12 at the ends
    half = KERNEL_WIDTH / 2
    return np.asarray(half * step * np.cos(2 * np.pi * half * np.outer(waves, z)) @ _kernel(z))


def unwrapped(frames: Iterable[Frame]) -> Array:
    """Positions without periodic images, [T, N, 2], d_s, from those in the first frame on: by `image` where frames have it,
    however far they lie apart. Of files without, between two frames each disk is taken to go the way nearest to the mean
    flow, which holds while its non-affine displacement stays below half the box."""
    frames = list(frames)
    if all(frame.image is not None for frame in frames):
        return _unwrapped_by_image(frames)
    rows: list[Array] = []
    last: Frame | None = None
    for frame in frames:
        if last is None:
            rows.append(frame.position.copy())
        else:
            strain = frame.strain - last.strain
            scale = frame.box.length / last.box.length  # a box that changes takes all places along
            before, above = scale * last.position, scale * (rows[-1] - last.position)
            flow = np.stack([strain * (frame.position[:, 1] + before[:, 1]) / 2,
                             np.zeros(len(frame))], axis=1)
            # to the image nearest to where the mean flow leads; a row higher it leads further by strain L_y/2
            away = frame.position - before
            up = np.rint(away[:, 1] / frame.box.height)
            away[:, 1] -= up * frame.box.height
            away[:, 0] -= up * frame.box.tilt
            flow[:, 0] -= strain * up * frame.box.height / 2
            off = away[:, 0] - flow[:, 0]
            away[:, 0] -= frame.box.length * np.rint(off / frame.box.length)
            away[:, 0] += strain * above[:, 1]  # whole boxes above the first image
            rows.append(np.asarray(before + above + away, dtype=np.float64))
        last = frame
    return np.stack(rows) if rows else np.zeros((0, 0, 2))


def _unwrapped_by_image(frames: list[Frame]) -> Array:
    out = [frame.unwrapped for frame in frames]
    for frame, place in zip(frames, out):  # back to the image that is in the box in the first frame, and moves with the flow
        first = frames[0]
        assert first.image is not None
        columns, rows = first.image.T
        shift = first.box.tilt * frame.box.length / first.box.length + (frame.strain - first.strain) * frame.box.height
        place -= np.stack([columns * frame.box.length + rows * shift, rows * frame.box.height], axis=1)
    return np.stack(out) if out else np.zeros((0, 0, 2))


def nonaffine_displacement(frames: Iterable[Frame]) -> tuple[Array, Array]:
    """Displacements since the first frame without the mean flow, sum of dr - dgamma y x_hat with y the
    mean of both ends of each interval; where the box changed (given pressure), without that change too. Returns strains since the first frame, [T], and displacements,
    [T, N, 2], d_s."""
    frames = list(frames)
    if not frames:
        raise InputError("no frame to take displacements of; take a slice that has some")
    if any(np.isnan(frame.strain) for frame in frames):
        raise InputError("the strain of a frame is not known; use a trajectory, whose frames tell it")
    place = unwrapped(frames)
    strain = np.array([frame.strain for frame in frames])
    length = np.array([frame.box.length for frame in frames])
    before = place[:-1] * (length[1:] / length[:-1])[:, None, None]  # taken along by the box
    step = place[1:] - before
    step[..., 0] -= np.diff(strain)[:, None] * (place[1:, :, 1] + before[..., 1]) / 2
    return strain - strain[0], np.concatenate([np.zeros((1, *place.shape[1:])), np.cumsum(step, axis=0)])


def d2_min(frames: Iterable[Frame], r_max: float = 2.5) -> tuple[Array, Array]:
    """D^2_min of each disk between the first frame and the last: what is left of the motion of its neighbours when the
    affine map that fits it best is taken off (Falk and Langer, Phys. Rev. E 57, 7192 (1998)):

        D^2_min,i = min_J sum_j |r_ij(last) - J r_ij(first)|^2 / n_i

    frames: two or more; those between help to unwrap disks where frames have no `image`. r_max: d_s, neighbours are those
    nearer in the first frame, n_i of them; 2.5 takes about 18 at phi = 0.82. Returns D^2_min, [N], d_s^2, and J, [N, 2, 2],
    with the mean flow (J_xy = dgamma) and the change of the box; NaN where neighbours do not span the plane. OVITO states n_i D^2_min."""
    frames = list(frames)
    if len(frames) < 2:
        raise InputError(f"d2_min: {len(frames)} frame (needs a first and a last one); take a slice of several")
    first, last = frames[0], frames[-1]
    _refuse_far(first, r_max)
    strain = last.strain - first.strain
    if np.isnan(strain):
        raise InputError("the strain of a frame is not known; use a trajectory, whose frames tell it")
    place = unwrapped(frames)
    scale = last.box.length / first.box.length
    start = scale * place[0]
    moved = place[-1] - start
    moved[:, 0] -= strain * start[:, 1]  # beside the mean flow and the box, which take a disk's images along
    i, j, away, _ = pairs_within(first.position, first.box, np.zeros(len(first)), r_max)
    i, j, away = np.concatenate([i, j]), np.concatenate([j, i]), np.concatenate([away, -away])
    apart = moved[i] - moved[j]

    def by_disk(a: Array, b: Array) -> Array:
        sums = [[np.bincount(i, a[:, k] * b[:, m], minlength=len(first)) for m in (0, 1)] for k in (0, 1)]
        return np.array(sums, dtype=np.float64).transpose(2, 0, 1)

    square, mixed, spread = by_disk(away, away), by_disk(apart, away), by_disk(apart, apart)
    spans = np.linalg.det(square) > 1e-9 * np.trace(square, axis1=1, axis2=2)**2
    inverse = np.full(square.shape, np.nan)
    inverse[spans] = np.linalg.inv(square[spans])
    fit = mixed @ inverse
    left = np.trace(spread, axis1=1, axis2=2) - np.sum(fit * mixed, axis=(1, 2))
    with np.errstate(invalid="ignore", divide="ignore"):
        d2 = np.maximum(left, 0) / np.bincount(i, minlength=len(first))
    return d2, fit + scale * np.array([[1.0, strain], [0.0, 1.0]])


def nonaffine_msd(frames: Iterable[Frame]) -> tuple[Array, Array]:
    """Mean square non-affine displacement at each lag of strain, over all pairs of frames so far apart.

    Returns the lags, [L], and the means over pairs and disks along x and y, [L, 2], d_s^2. Of T frames evenly spaced in
    strain lag k is that of k frames, and L = T; of others pairs whose lags differ by less than 1% are taken together.
    Each lag is the mean over its pairs. Raises InputError where strain does not grow from frame to frame."""
    strain, place = nonaffine_displacement(frames)
    if len(strain) > 1 and not np.diff(strain).min() > 0:
        at = int(np.argmin(np.diff(strain)))
        raise InputError(f"strain goes from {strain[at]:g} to {strain[at + 1]:g} since the first frame, from frame {at} to {at + 1} "
                         "(must grow: lags are of strain); take the frames in the order of the run, each once, and of one way alone "
                         "where the shear turns or stops")
    lags, squares = [np.zeros(1)], [np.zeros(2)]
    for i, j in _pairs_by_lag(strain):
        lags.append(np.mean(strain[j] - strain[i], keepdims=True))
        squares.append(np.mean((place[j] - place[i])**2, axis=(0, 1)))
    return np.concatenate(lags), np.stack(squares)


def _pairs_by_lag(strain: Array) -> Iterator[tuple[Integers, Integers]]:
    """Pairs of frames i < j, those of one lag together, shorter ones first."""
    count = len(strain)
    even = np.arange(count) * (strain[-1] / max(1, count - 1))
    if count < 3 or np.abs(strain - even).max() < even[1] / 8:  # frames come at the first step behind their strain
        for apart in range(1, count):
            first = np.arange(count - apart)
            yield first, first + apart
        return
    i, j = np.triu_indices(count, 1)
    lag = strain[j] - strain[i]
    order = np.argsort(lag, kind="stable")
    i, j, lag = i[order], j[order], lag[order]
    begin = 0
    while begin < len(lag):
        end = int(np.searchsorted(lag, 1.01 * lag[begin]))
        yield i[begin:end], j[begin:end]
        begin = end


def velocity_correlation(frames: Configurations, r_max: float = 10.0, bins: int = 100) -> tuple[Array, Array]:
    """<dv_i . dv_j>(r) / <dv^2> of the non-affine velocities dv = v - gammadot y x_hat, averaged over
    pairs and frames. Returns the middles of the bins, [bins], d_s, and the correlation, [bins]."""
    edges = np.linspace(0, r_max, bins + 1)
    total, count, square, disks = np.zeros(bins), np.zeros(bins), 0.0, 0
    for frame in _frames(frames):
        _refuse_far(frame, r_max)
        excess = frame.nonaffine_velocity
        i, j, away, _ = pairs_within(frame.position, frame.box, np.zeros(len(frame)), r_max)
        where = np.minimum((np.hypot(*away.T) / r_max * bins).astype(np.int64), bins - 1)
        total += np.bincount(where, np.sum(excess[i] * excess[j], axis=1), minlength=bins)
        count += np.bincount(where, minlength=bins)
        square += float(np.sum(excess**2))
        disks += len(frame)
    with np.errstate(invalid="ignore"):
        return (edges[1:] + edges[:-1]) / 2, total / count / (square / disks)


# ----------------------------------------------------------------------------------- contact network


def force_distribution(contacts: Networks, bins: int = 50, f_max: float = 5.0) -> tuple[Array, Array]:
    """Density of the elastic contact force over its mean. Returns the middles, [bins], and the density,
    [bins], which integrates to the share below f_max."""
    forces = np.concatenate([np.zeros(0), *(one.elastic_force for one in _networks(contacts))])
    if not len(forces):
        raise InputError("no frame has a contact; take other frames, or a denser scene")
    edges = np.linspace(0, f_max, bins + 1)
    number = np.histogram(forces / forces.mean(), edges)[0]
    return (edges[1:] + edges[:-1]) / 2, number / len(forces) / np.diff(edges)


def fabric_tensor(contacts: Networks) -> Array:
    """<n n> over contacts, [2, 2]: its trace is 1, its anisotropy the difference of its eigenvalues."""
    total, number = np.zeros((2, 2)), 0
    for one in _networks(contacts):
        total += one.normal.T @ one.normal
        number += len(one)
    return total / number if number else np.full((2, 2), np.nan)


def rattlers(contacts: Contacts, needed: int = 3) -> NDArray[np.bool_]:
    """Disks with fewer than `needed` contacts with disks that are not rattlers themselves, [N]. Three contacts hold a
    disk without friction in two dimensions."""
    held = np.ones(contacts.count, dtype=bool)
    while True:
        both = held[contacts.i] & held[contacts.j]
        degree = np.bincount(np.concatenate([contacts.i[both], contacts.j[both]]), minlength=contacts.count)
        loose = held & (degree < needed)
        if not loose.any():
            return ~held
        held &= ~loose


def clusters(contacts: Contacts) -> Integers:
    """Label of the cluster of each disk, [N]: the smallest index of a disk that is connected to it by contacts."""
    label = np.arange(contacts.count)
    while True:
        least = label.copy()
        np.minimum.at(least, contacts.i, label[contacts.j])
        np.minimum.at(least, contacts.j, label[contacts.i])
        least = least[least]
        if np.array_equal(least, label):
            return label
        label = least


def cluster_sizes(contacts: Contacts) -> Integers:
    """Disks of each cluster, the largest first; free disks are clusters of one."""
    return np.sort(np.unique(clusters(contacts), return_counts=True)[1])[::-1]


def percolates(contacts: Contacts) -> tuple[bool, bool]:
    """Two truth values: a connected cluster reaches its own image straight along x; and along y (with any displacement
    along x)."""
    steps = _Steps(contacts)
    place = np.full((contacts.count, 2), np.nan)
    along_x = along_y = False
    for start in range(contacts.count):
        if np.isnan(place[start, 0]):
            windings = steps.walk(start, place)
            along_y |= any(rows != 0 for _, rows in windings)
            along_x |= any(rows == 0 for _, rows in windings) or any(
                a[0] * b[1] != a[1] * b[0] for a in windings for b in windings)
    return along_x, along_y


class _Steps:
    """Steps from each disk to those that it touches."""

    def __init__(self, contacts: Contacts) -> None:
        away = contacts.separation[:, None] * contacts.normal
        ends = np.concatenate([contacts.i, contacts.j])
        order = np.argsort(ends, kind="stable")
        self.box = contacts.box
        self.first = np.searchsorted(ends[order], np.arange(contacts.count + 1))
        self.other = np.concatenate([contacts.j, contacts.i])[order]
        self.step = np.concatenate([-away, away])[order]

    def walk(self, start: int, place: Array) -> set[tuple[int, int]]:
        """Places the cluster of a disk, with that disk at the origin. Returns the (lengths, heights) by which disks are
        displaced from where they were placed already, (0, 0) left out."""
        place[start] = 0
        waiting, windings = [start], set()
        while waiting:
            disk = waiting.pop()
            for k in range(self.first[disk], self.first[disk + 1]):
                there, neighbour = place[disk] + self.step[k], int(self.other[k])
                if np.isnan(place[neighbour, 0]):
                    place[neighbour] = there
                    waiting.append(neighbour)
                    continue
                off = there - place[neighbour]
                rows = round(float(off[1]) / self.box.height)
                columns = round(float(off[0] - rows * self.box.tilt) / self.box.length)
                if rows or columns:
                    windings.add((columns, rows))
        return windings


__all__ = ["cluster_sizes", "clusters", "d2_min", "fabric_tensor", "force_distribution", "nonaffine_displacement",
           "nonaffine_msd", "percolates", "radial_distribution", "rattlers", "structure_factor", "unwrapped",
           "velocity_correlation"]
