# SPDX-License-Identifier: BSD-3-Clause
"""One program for several kinds of processor: which instructions run is chosen at start, and told."""

import signal
import unittest

import h5py

from bagnold import CliTest, environment, read_series


class Levels(CliTest):
    def levels(self):
        line = next(line for line in self.bagnold("info").stdout.splitlines() if line.startswith("SIMD"))
        return line.replace("(also:", "").replace(")", "").replace(",", " ").split()[1:]

    def stamp(self, out):
        try:
            return (out / "checkpoint.h5").stat().st_mtime_ns
        except FileNotFoundError:  # between two names
            return None

    def test_each_runs_and_says_so(self):
        """The same flow but for rounding, from the same start."""
        start = self.run_new("start", disks__packing_fraction=0.8)
        path = self.scene(disks__packing_fraction=0.8, shear__strain=2.0**-6, output__sample_strain=2.0**-9,
                          start__kind="state", start__file=str(start / "state.h5"))
        series = []
        for level in self.levels():
            out = self.folder / level
            self.run_scene(path, out, "--quiet", env=environment(BAGNOLD_SIMD=level))
            with h5py.File(out / "result.h5") as file:
                self.assertEqual(file.attrs["simd"], level)
            series.append(read_series(out))
        for other in series[1:]:
            for name in ("p", "sigma", "Z"):
                for one, two in zip(series[0][name], other[name]):
                    self.assertAlmostEqual(one, two, delta=1e-8 * (1 + abs(one)))

    def test_another_is_refused(self):
        out = self.folder / "out"
        result = self.bagnold("run", self.scene(), "--out", out, env=environment(BAGNOLD_SIMD="mmx"))
        self.assert_clean_error(result, 2, "BAGNOLD_SIMD", "mmx", *self.levels())
        self.assertFalse(out.exists())

    def test_going_on_with_another_is_told(self):
        out = self.folder / "out"
        path = self.scene(shear__strain=1000.0, output__checkpoint_minutes=0.0005)
        process = self.start("run", path, "--out", out)
        self.wait_until((out / "checkpoint.h5").exists, process)
        process.send_signal(signal.SIGTERM)
        self.assertEqual(self.finish(process)[0], 143)
        first, *others = self.levels()
        for level in (first, *others):
            process = self.start("resume", out, env=environment(BAGNOLD_SIMD=level))
            seen = self.stamp(out)
            self.wait_until(lambda: self.stamp(out) not in (None, seen), process)
            process.send_signal(signal.SIGTERM)
            status, said = self.finish(process)
            self.assertEqual(status, 143, said)
            told = "goes on with" in said
            self.assertEqual(told, level != first, said)
            if told:
                self.assertIn(f"BAGNOLD_SIMD={first}", said)
            first = level


if __name__ == "__main__":
    unittest.main()
