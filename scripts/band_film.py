#!/usr/bin/env python3
# SPDX-License-Identifier: BSD-3-Clause
"""Films how shear bands form, docs/band.gif: scripts/band_film.py [DIR]

Runs inputs/band.toml into DIR (results/band; a minute or two of one core), or takes what is there. The box lies on
its side, disks by the strain rate of their slice, averaged over three frames.
"""

import argparse
import io
import pathlib
import subprocess
import sys

import numpy as np

ROOT = pathlib.Path(__file__).resolve().parent.parent
sys.path.insert(0, str(ROOT / "python"))

import bagnold  # noqa: E402
from bagnold.plots.packing_page import local_rate  # noqa: E402
from bagnold.plots.style import STYLE, plt  # noqa: E402
from matplotlib.collections import EllipseCollection  # noqa: E402
from matplotlib.colors import LogNorm  # noqa: E402
from PIL import Image  # noqa: E402

EVERY, MILLISECONDS, COLOURS, DPI = 2, 180, 32, 100
LINE = "#D55E00"


def frame_of(run, frames, number, strain, sigma):
    """One picture, as an image."""
    frame = frames[number]
    near = [frames[k] for k in range(max(0, number - 1), min(len(frames), number + 2))]
    rate = np.mean([local_rate(one) for one in near], axis=0)  # of a disk, which stays in its slice meanwhile
    place = frame.box.wrapped(frame.position)
    figure, (top, below) = plt.subplots(2, 1, figsize=(8.2, 2.8), layout="constrained", height_ratios=[1.25, 1])
    figure.get_layout_engine().set(h_pad=0.07)
    disks = EllipseCollection(frame.diameter, frame.diameter, 0, units="xy", cmap="viridis_r", lw=0, offsets=place[:, ::-1],
                              transOffset=top.transData, array=np.clip(rate, 1e-7, None), norm=LogNorm(3e-6, 2e-4))
    top.add_collection(disks)
    top.set(xlim=(0, frame.box.height), ylim=(0, frame.box.length), aspect="equal", xlabel="$y/d_s$", yticks=[],
            title=rf"CD_rot, $\phi = {run.scene['disks.packing_fraction']:g}$: strain $\gamma = {frame.strain:.1f}$")
    bar = figure.colorbar(disks, ax=top, pad=0.01, extend="both")
    bar.set_label(r"local $\dot\gamma\tau_e$", fontsize=8)
    below.semilogy(strain, sigma, lw=0.8)
    below.axvline(frame.strain, color=LINE, lw=1.5)
    below.set(xlabel=r"strain $\gamma$", ylabel=r"$\sigma$  $[m/\tau_e^2]$", xlim=(0, strain[-1]))
    picture = io.BytesIO()
    figure.savefig(picture, dpi=DPI)
    plt.close(figure)
    return Image.open(picture).convert("RGB")


def main():
    parser = argparse.ArgumentParser(description=__doc__, formatter_class=argparse.RawDescriptionHelpFormatter)
    parser.add_argument("folder", metavar="DIR", nargs="?", type=pathlib.Path, default=pathlib.Path("results/band"))
    folder = parser.parse_args().folder
    if not (folder / "summary.json").exists():
        program = ROOT / "build/openmp/bagnold"
        subprocess.run([program, "run", ROOT / "inputs/band.toml", "--out", folder], check=True)
    run = bagnold.load(folder)
    strain, sigma = run.series["strain"], np.abs(run.series["sigma"])
    with plt.rc_context({**STYLE, "font.size": 8, "axes.titlesize": 9}):
        frames = [run.frames[k] for k in range(len(run.frames))]
        images = [frame_of(run, frames, k, strain, sigma) for k in range(0, len(frames), EVERY)]
    palette = images[-1].quantize(COLOURS - 1)  # the line, a few pixels, would get no colour of its own
    palette.putpalette([*palette.getpalette()[:3 * (COLOURS - 1)], *bytes.fromhex(LINE[1:])])
    images = [one.quantize(palette=palette, dither=Image.Dither.NONE) for one in images]
    images[0].save(ROOT / "docs/band.gif", save_all=True, append_images=images[1:], duration=MILLISECONDS, loop=0, optimize=True)
    print(f"{len(images)} frames, {(ROOT / 'docs/band.gif').stat().st_size / 1e6:.2f} MB")


if __name__ == "__main__":
    main()
