# SPDX-License-Identifier: BSD-3-Clause
"""Whether numbers that runs print may be held against those that pages and notebooks keep: chaos makes other digits of
other bits, and those are of compiler and processor."""

import re
import subprocess


def can_be_compared(program):
    """True with the compiler and the registers that the kept numbers were made with."""
    said = subprocess.run([program, "info"], capture_output=True, text=True, check=True).stdout
    return bool(re.search(r"^compiler +g\+\+ 12\b(?s:.*)^SIMD +avx512", said, re.M))


def without(text):
    """The text with # for each number: its digits, sign, power of ten and error."""
    return re.sub(r"[-+]?\d+(\.\d+)?(\(\d+\))?(e[-+]?\d+)?", "#", text)
