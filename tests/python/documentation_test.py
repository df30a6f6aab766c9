# SPDX-License-Identifier: BSD-3-Clause
"""The session of docs/python.md, and the notebooks in examples/: every block and cell runs."""

import base64
import contextlib
import importlib.machinery
import importlib.util
import io
import json
import os
import re
import sys
import tomllib
import unittest
import warnings

from made import SOURCE, Folder, bagnold, with_frames

import h5py  # noqa: E402
import matplotlib  # noqa: E402
import matplotlib.figure  # noqa: E402
import numpy as np  # noqa: E402

matplotlib.use("Agg")
NOTEBOOKS = sorted((SOURCE / "examples").glob("*.ipynb"))
LOADER = importlib.machinery.SourceFileLoader("notebooks", str(SOURCE / "scripts/notebooks"))
SCRIPT = importlib.util.module_from_spec(importlib.util.spec_from_loader("notebooks", LOADER))
LOADER.exec_module(SCRIPT)


class Documentation(Folder):
    def setUp(self):
        super().setUp()
        self.addCleanup(os.chdir, os.getcwd())
        os.chdir(self.folder)

    def test_manual(self):
        text = (SOURCE / "docs/python.md").read_text()
        blocks = re.findall(r"^```python\n(.*?)^```$", text, re.M | re.S)
        self.assertGreaterEqual(len(blocks), 7)
        names, said = {}, io.StringIO()
        with warnings.catch_warnings(), contextlib.redirect_stdout(said), contextlib.redirect_stderr(io.StringIO()):
            warnings.simplefilter("ignore")
            for block in blocks:
                exec(compile(block, "docs/python.md", "exec"), names)
        shown = re.search(r"print\(error\) +# (.*) \.\.\.", text)[1]
        self.assertIn(shown, said.getvalue())
        self.assertTrue((self.folder / "first.pdf").read_bytes().startswith(b"%PDF"))
        for name in ("trajectory.lammpstrj", "trajectory.contacts.dump", "trajectory.xyz"):
            self.assertTrue((self.folder / "results/first" / name).exists(), name)

    def test_the_scene_beside_lammps(self):
        """Both inputs of docs/lammps.md say one physics: the scene's is what bench/peers writes for LAMMPS."""
        sys.path.insert(0, str(SOURCE / "bench/peers"))
        import lammps_scene
        text = (SOURCE / "docs/lammps.md").read_text()
        theirs, = re.findall(r"^```text\n(units lj\n.*?)^```$", text, re.M | re.S)
        ours = tomllib.loads(re.findall(r"^```toml\n(.*?)^```$", text, re.M | re.S)[0])
        scene = lammps_scene.Scene(ours["disks"]["model"], ours["disks"]["elasticity"], ours["shear"]["strain_rate"],
                                   ours["disks"]["mass"])
        wanted = lammps_scene.head_lines(scene, lammps_scene.Tuning(centred=False))
        self.assertEqual(theirs.splitlines()[:len(wanted)], wanted)
        steps = int(re.search(r"^run (\d+)$", theirs, re.M)[1])
        self.assertAlmostEqual(steps * scene.time_step * scene.rate, ours["shear"]["strain"])

    @unittest.skipUnless(importlib.util.find_spec("gsd"), "needs gsd")
    def test_the_way_back_from_gsd(self):
        """What docs/hoomd.md writes of an exported trajectory is imported as the state that it was, in single precision."""
        block, = re.findall(r"^```python\n(.*?)^```$", (SOURCE / "docs/hoomd.md").read_text(), re.M | re.S)
        names = {}
        exec(compile(block, "docs/hoomd.md", "exec"), names)
        r = with_frames()
        path, = bagnold.export(r, "gsd", self.folder / "made.gsd")
        names["to_extxyz"](path, self.folder / "made.xyz")
        state = bagnold.import_state(self.folder / "made.xyz", self.folder / "state.h5", strain_rate=r.frames[-1].strain_rate)
        self.assertEqual(state.scene["disks"]["count"], len(r.frames[-1]))
        self.assertAlmostEqual(state.scene["disks"]["packing_fraction"], r.scene["disks.packing_fraction"], places=6)
        with h5py.File(self.folder / "state.h5") as file:
            away, _ = r.frames[-1].box.nearest(file["state/position"][:] - r.frames[-1].position)
        self.assertLess(np.abs(away).max(), 1e-5)

    def test_names_in_the_text(self):
        """What is called by its name in a sentence is there."""
        text = re.sub(r"^```.*?^```$", "", (SOURCE / "docs/python.md").read_text(), flags=re.M | re.S)
        for name in re.findall(r"`bagnold\.(\w+)", text):
            self.assertTrue(hasattr(bagnold, name) or name == "plots", name)
        for name in re.findall(r"`plots\.(\w+)", text):
            import bagnold.plots as plots
            self.assertTrue(callable(getattr(plots, name)), name)
        for name in re.findall(r"`r\.(\w+)", text):
            self.assertTrue(hasattr(bagnold.Run, name), name)
        for path in re.findall(r"\]\((\.\./[^)#]+)", text):
            self.assertTrue((SOURCE / "docs" / path).exists(), path)

    def test_extras(self):
        """Those of pyproject.toml are what one is told to install."""
        project = tomllib.loads((SOURCE / "python/pyproject.toml").read_text())["project"]
        for page in ("docs/python.md", "python/README.md"):
            told = re.search(r"pip install '\./python\[([a-z,]+)\]'", (SOURCE / page).read_text())
            self.assertEqual(told and told[1].split(","), list(project["optional-dependencies"]), page)

    def test_notebooks(self):
        self.assertEqual([path.name for path in NOTEBOOKS], ["first_look.ipynb", "p1_figure.ipynb"])
        for path in NOTEBOOKS:
            with self.subTest(notebook=path.name):
                self.run_notebook(path)

    def run_notebook(self, path):
        """By nbclient where a kernel is installed too, as scripts/notebooks does, else its cells as they stand: what is
        kept in the notebook comes out."""
        notebook = json.loads(path.read_text())
        shown, numbers = SCRIPT.shown(notebook), SCRIPT.kept_numbers.can_be_compared(os.environ["BAGNOLD_PROGRAM"])
        self.assertTrue(any(shown), "kept with outputs")
        if all(importlib.util.find_spec(name) for name in ("nbclient", "nbformat", "ipykernel")):
            self.assertEqual(SCRIPT.differences(notebook, SCRIPT.run(path, os.environ["BAGNOLD"]), numbers), [])
            return
        os.environ["BAGNOLD_SOURCE"] = str(SOURCE)
        names = {}
        cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
        for number, (cell, outputs) in enumerate(zip(cells, shown), 1):
            said = io.StringIO()
            with warnings.catch_warnings(), contextlib.redirect_stdout(said), contextlib.redirect_stderr(io.StringIO()):
                warnings.simplefilter("ignore")
                exec(compile("".join(cell["source"]), f"{path.name}, cell {number}", "exec"), names)
            words = str if numbers else SCRIPT.kept_numbers.without
            kept = "".join(text for text in outputs if not text.startswith("<Figure"))
            self.assertEqual(words(said.getvalue()), words(kept))

    def test_what_is_kept_is_compared(self):
        """Another text, another size of a picture, and an output that is gone are told."""
        text, picture = {"output_type": "stream", "name": "stdout", "text": "p = 1.0\n"}, io.BytesIO()
        matplotlib.figure.Figure((2, 1), dpi=100).savefig(picture, dpi=100)
        drawn = {"output_type": "display_data", "data": {
            "text/plain": "<Figure>", "image/png": base64.b64encode(picture.getvalue()).decode()}}

        def notebook(*outputs):
            return {"cells": [{"cell_type": "code", "outputs": [SCRIPT.kept(output) for output in outputs]}]}

        one = notebook(text, drawn)
        self.assertEqual(SCRIPT.shown(one), [["p = 1.0\n", "<Figure> 200 x 100 pixels"]])
        self.assertEqual(SCRIPT.differences(one, json.loads(json.dumps(one))), [])
        for other in (notebook(text), notebook(text | {"text": "p = 1.1\n"}, drawn), notebook(drawn, text)):
            self.assertEqual(len(SCRIPT.differences(one, other)), 1)

    def test_numbers_of_another_processor(self):
        def notebook(text):
            output = {"output_type": "stream", "name": "stdout", "text": text}
            return {"cells": [{"cell_type": "code", "outputs": [SCRIPT.kept(output)]}]}

        one = notebook("p = 1.30(6)e-03 m/tau_e^2\n")
        self.assertEqual(SCRIPT.differences(one, notebook("p = 0.00141 m/tau_e^2\n"), numbers=False), [])
        self.assertEqual(len(SCRIPT.differences(one, notebook("sigma = 1.30(6)e-03 m/tau_e^2\n"), numbers=False)), 1)


if __name__ == "__main__":
    unittest.main()
