# SPDX-License-Identifier: BSD-3-Clause
"""Libraries, style and colours of all pictures, and how they are written."""

import io
import os

from ..errors import MissingLibrary
from ..files import replaced

try:
    import matplotlib
    from matplotlib import pyplot as plt
    from PIL import Image  # matplotlib's own
except ImportError as error:
    raise MissingLibrary(f"{error}; no picture (Debian: apt install python3-matplotlib, else pip install "
                         "matplotlib)") from error

# Okabe and Ito's palette: told apart by colour-blind eyes too.
BLUE, ORANGE, GREEN, VERMILION, SKY, PINK, OLIVE, GREY = (
    "#0072B2", "#E69F00", "#009E73", "#D55E00", "#56B4E9", "#CC79A7", "#B8A600", "#777777")
COLOURS = (BLUE, VERMILION, GREEN, ORANGE, SKY, PINK, "#555555", OLIVE)
MARKERS = "osD^v<>ph*"
DASHED, DOTTED = (0, (4, 2)), (0, (1, 2))

STYLE = {
    "font.size": 10, "axes.titlesize": 10.5, "axes.titlelocation": "left",
    "axes.spines.top": False, "axes.spines.right": False, "axes.linewidth": 0.8,
    "axes.edgecolor": "#444444", "xtick.color": "#444444", "ytick.color": "#444444",
    "legend.frameon": False, "legend.fontsize": 9, "legend.handlelength": 1.4,
    "pdf.fonttype": 42, "ps.fonttype": 42,  # TrueType, which journals take and editors change; Type 3 they do not
    "lines.linewidth": 1.1, "mathtext.fontset": "dejavusans", "axes.formatter.useoffset": False,
    "svg.hashsalt": "bagnold",  # the same picture, the same bytes
}
NO_DATE = {"svg": {"Date": None}, "pdf": {"CreationDate": None}}


def colour_of(k, count):
    """Colour of a curve: distinct colours for few curves, a sequence for many."""
    return COLOURS[k] if count <= len(COLOURS) else plt.cm.viridis(0.92 * k / (count - 1))


def save(figure, target, dpi=110, colours=None):
    """Saves a picture whole or not at all, so that an existing picture is complete. Its form is that of the name: .pdf,
    .svg, else PNG, which is small with few colours."""
    target = os.fspath(target)
    form = os.path.splitext(target)[1][1:].lower() or "png"
    picture = io.BytesIO()
    with plt.rc_context(STYLE):
        figure.savefig(picture, format=form, dpi=dpi, metadata=NO_DATE.get(form))
    if colours and form == "png":
        image = Image.open(picture).convert("RGB").quantize(colours)
        picture = io.BytesIO()
        image.save(picture, format="png", optimize=True, dpi=(dpi, dpi))
    with replaced(target) as part:
        part.write_bytes(picture.getvalue())

