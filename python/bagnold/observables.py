# SPDX-License-Identifier: BSD-3-Clause
"""Measured means with their errors, from summary.json."""

from __future__ import annotations

import math
from dataclasses import dataclass, field
from typing import Any


@dataclass(frozen=True)
class Observable:
    """A measured quantity: mean and standard error over the measured windows."""

    name: str  #: as in summary.json
    mean: float  #: in `unit`; NaN where undefined
    error: float  #: standard error of the mean, in `unit`; NaN where it cannot be told
    correlation_strain: float = math.nan  #: integrated correlation time, in strain
    samples: int = 0  #: windows (or frames) averaged
    rough: bool = False  #: from 4 to 7 blocks only; Student's factor is in `error`
    unit: str = ""  #: in d_s, tau_e and m
    bias: float = math.nan  #: of scheme and time step, in `unit`; NaN where it was not measured (measure.bias)
    bias_error: float = math.nan  #: its standard error

    def __str__(self) -> str:
        """``B_p = 1.89(10)e+04``, the brackets being the error of the last digits; and the bias of the method, if known."""
        text = f"{self.name} = {rounded(self.mean, self.error)}{' ' + self.unit if self.unit not in ('', '1') else ''}"
        if not math.isfinite(self.bias) or not self.mean:
            return text
        bias = rounded(100 * self.bias / self.mean, 100 * self.bias_error / abs(self.mean))
        return f"{text}, method {'' if bias.startswith('-') else '+'}{bias}%"

    @property
    def total_error(self) -> float:
        """Error with the bias of the method: (error^2 + bias^2 + bias_error^2)^(1/2); the error alone where none is known."""
        if not math.isfinite(self.bias) or not math.isfinite(self.bias_error):
            return self.error
        return math.hypot(self.error, self.bias, self.bias_error)

    def __float__(self) -> float:
        return self.mean


def rounded(mean: float, error: float) -> str:
    """A mean with as many digits as its error allows: ``1.89(10)e+04``, ``0.5123(4)``, ``17.3(1.2)``."""
    if not math.isfinite(mean):
        return "undefined"
    if not (math.isfinite(error) and 0 < error):
        return f"{mean:.4g}"
    power = math.floor(math.log10(max(abs(mean), error)))
    power = 0 if -3 <= power <= 3 else power
    scale = 10.0**power
    shown = f"{error:.1e}"  # 0.0997 is 0.10
    digits = max(0, power - int(shown.split("e")[1]) + (shown[0] == "1"))
    last = round(error / scale * 10**digits)
    bracket = f"{error / scale:.{digits}f}" if digits and last >= 10**digits else str(last)
    return f"{mean / scale:.{digits}f}({bracket}){f'e{power:+03d}' if power else ''}"


@dataclass(frozen=True)
class Warning:  # noqa: A001  the program's word
    """A reason to doubt a result; docs/stability.md explains the names."""

    name: str
    reason: str
    remedy: str
    numbers: dict[str, float | None] = field(default_factory=dict)
    command: str = ""  #: that does it, DIR being the folder of the run; empty where there is none

    def __str__(self) -> str:
        return f"{self.name}: {self.reason}; {self.remedy}"


def number(value: Any) -> float:
    """A number of JSON; null is NaN."""
    return math.nan if value is None else float(value)


def observable(name: str, found: dict[str, Any], unit: str = "") -> Observable:
    """One entry of `observables` in summary.json."""
    return Observable(name, number(found.get("mean")), number(found.get("error")),
                      number(found.get("correlation_strain")), int(found.get("samples") or 0),
                      bool(found.get("rough", False)), unit, number(found.get("bias")), number(found.get("bias_error")))
