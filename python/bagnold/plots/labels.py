# SPDX-License-Identifier: BSD-3-Clause
"""Words of the pictures: units, numbers, ticks, and the line that says what scene a picture is of."""

import numpy as np

from .style import GREY, matplotlib

UNITS = {"1": "", "": "", "tau_e": r"\tau_e", "1/tau_e": r"\tau_e^{-1}", "d_s": "d_s", "d_s/tau_e": r"d_s/\tau_e",
         "m/tau_e^2": r"m/\tau_e^2", "m d_s^2/tau_e^2": r"m\,d_s^2/\tau_e^2"}
KEYS = {"disks.count": "N", "disks.packing_fraction": r"\phi", "disks.elasticity": "Q",
        "shear.strain_rate": r"\dot\gamma\tau_e"}
FEW_DECADES = {"x": 1.2, "y": 2.2}  # below, ticks of a logarithmic axis are written at 1, 2, 5 too
LINEAR = 3.0  # largest over smallest value, below which an axis needs no logarithm


def with_unit(symbol, unit):
    """"$T_g$  $[m d_s^2/tau_e^2]$", of no unit the symbol alone."""
    known = UNITS.get(unit, rf"\mathrm{{{unit}}}")
    return f"{symbol}  $[{known}]$" if known else symbol


def power_of_ten(value):
    """$2\\times 10^{-5}$."""
    power = int(np.floor(np.log10(abs(value)))) if value else 0
    digits = f"{value / 10.0**power:.4g}"
    return f"$10^{{{power}}}$" if digits == "1" else rf"${digits}\times 10^{{{power}}}$"


def short_power(value, _=None):
    """2e-5 as a tick label."""
    if value == 0 or 1e-3 <= abs(value) < 1e4:
        return f"{value:.4g}"
    return power_of_ten(value)


def plain_ticks(axis):
    """Numbers as they are said."""
    axis.set_major_formatter(matplotlib.ticker.FuncFormatter(short_power))


def scaled_ticks(axis, symbol, unit):
    """Sets numbers and label of a linear axis, once its limits are set: "$p$  $[10^{-4} m/\\tau_e^2]$" for small ones."""
    scale_ticks(axis, symbol, UNITS.get(unit, rf"\mathrm{{{unit}}}"))


def scale_ticks(axis, symbol, unit):
    """The same, for a unit as it is set in a formula."""
    largest = np.abs(axis.get_view_interval()).max()
    power = int(np.floor(np.log10(largest))) if largest > 0 else 0
    power = 0 if -3 < power < 4 else power
    axis.set_major_formatter(matplotlib.ticker.FuncFormatter(lambda value, _: f"{value / 10.0**power:.5g}"))
    factor = rf"10^{{{power}}}\," if power else ""
    axis.set_label_text(f"{symbol}  $[{factor}{unit}]$" if factor or unit else symbol)


def is_plain(axis):
    """Linear, with plain_ticks."""
    return axis.get_scale() == "linear" and getattr(axis.get_major_formatter(), "func", None) is short_power


def steps_of(decades, across):
    """Numbers below 10 to be written on so many decades; across: beside each other, so fewer."""
    if decades > (0.7 if across else 1.0):
        return 1, 2, 5
    if decades > 0.5:
        return (1, 2, 3, 5) if across else (1, 1.5, 2, 3, 5, 7)
    return (1, 1.5, 2, 2.5, 3, 4, 5, 7) if across else (1, 1.2, 1.5, 2, 2.5, 3, 3.5, 4, 4.5, 5, 6, 7, 8, 9)


def log_ticks(axis):
    """Sets ticks of a logarithmic axis, once its limits are set: at least two numbers."""
    low, high = np.log10(axis.get_view_interval())
    if high - low < FEW_DECADES[axis.axis_name]:
        axis.set_major_locator(matplotlib.ticker.LogLocator(subs=steps_of(high - low, axis.axis_name == "x")))
        plain_ticks(axis)
        axis.set_minor_formatter(matplotlib.ticker.NullFormatter())


def scale_of(values):
    """"log" where positive values differ much, else "linear"."""
    values = np.asarray(values, dtype=float)
    values = values[np.isfinite(values)]
    return "log" if len(values) and values.min() > 0 and values.max() > LINEAR * values.min() else "linear"


def symbol_of(key, value):
    """$\\phi = 0.8$; `value` a number or a text."""
    if key == "shear.strain_rate" and np.isfinite(value):
        return rf"$\dot\gamma\tau_e = ${power_of_ten(value)}"
    shown = f"{value:.5g}" if isinstance(value, (int, float, np.number)) else str(value)
    return f"${KEYS[key]} = {shown}$" if key in KEYS else f"{key.rpartition('.')[2].replace('_', ' ')} {shown}"


def scene_line(about, strain=None, replicas=1, rate=None):
    """Model, N, phi, Q, rate, strain, replicas and masses, what is known of them. about: attributes of result.h5.
    rate: a text instead of the rate."""
    parts = [f"model {about['model']}"] if about.get("model") else []
    for name, key in (("count", "disks.count"), ("packing_fraction", "disks.packing_fraction"),
                      ("elasticity", "disks.elasticity")):
        if name in about:
            parts.append(symbol_of(key, float(about[name])))
    if rate is not None:
        parts.append(rate)
    elif np.isfinite(float(about.get("strain_rate", np.nan))):
        parts.append(symbol_of("shear.strain_rate", float(about["strain_rate"])))
    if strain is not None:
        parts.append(f"strain {strain:.4g}")
    if replicas > 1:
        parts.append(f"{replicas} replicas")
    mass = {"equal": "equal masses", "area": "mass by area"}.get(about.get("mass"))
    return "    ".join(parts + ([mass] if mass else []))


def title_of(about):
    """The scene's title, as text."""
    return str(about.get("title", "")).replace("$", r"\$")


def add_heading(figure, about, parameters, note="", left=0.075, height=10.0):
    """Title, version, the line of the scene, and a note at its end. height: of the figure, in inches."""
    top, line = 1 - 0.4 / height, 1 - 0.75 / height
    figure.text(left, top, title_of(about), fontsize=15, weight="bold", va="center")
    figure.text(left, line, parameters, fontsize=11.5, va="center")
    version = " ".join(str(about[key]) for key in ("version", "bagnold_version", "git") if about.get(key))
    figure.text(0.985, top, f"bagnold {version}", fontsize=9, color=GREY, ha="right", va="center")
    if note:
        figure.text(0.985, line, note, fontsize=8.5, color=GREY, ha="right", va="center")
