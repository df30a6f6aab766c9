# SPDX-License-Identifier: BSD-3-Clause
"""The session of docs/python.md, and the notebooks in examples/: every block and cell runs."""

import contextlib
import importlib.util
import io
import json
import os
import re
import unittest
import warnings

from made import SOURCE, Folder, bagnold

import matplotlib  # noqa: E402

matplotlib.use("Agg")
NOTEBOOKS = sorted((SOURCE / "examples").glob("*.ipynb"))


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
        self.assertIn("disks.elasticity = -1 (must be", said.getvalue())
        self.assertTrue((self.folder / "first.pdf").read_bytes().startswith(b"%PDF"))
        for name in ("trajectory.lammpstrj", "trajectory.contacts.dump", "trajectory.xyz"):
            self.assertTrue((self.folder / "results/first" / name).exists(), name)

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

    def test_notebooks(self):
        self.assertEqual([path.name for path in NOTEBOOKS], ["first_look.ipynb", "p1_figure.ipynb"])
        for path in NOTEBOOKS:
            with self.subTest(notebook=path.name):
                self.run_notebook(path)

    def run_notebook(self, path):
        """By nbclient where a kernel is installed too, else its cells as they stand."""
        notebook = json.loads(path.read_text())
        cells = [cell for cell in notebook["cells"] if cell["cell_type"] == "code"]
        self.assertTrue(cells and not any(cell["outputs"] or cell["execution_count"] for cell in cells),
                        "kept without outputs")
        if all(importlib.util.find_spec(name) for name in ("nbclient", "nbformat", "ipykernel")):
            import nbclient
            import nbformat
            environment = {"PYTHONPATH": str(SOURCE / "python"), "BAGNOLD_SOURCE": str(SOURCE)}
            before = {name: os.environ.get(name) for name in environment}
            os.environ.update(environment)
            try:
                nbclient.NotebookClient(nbformat.read(path, as_version=4), timeout=120, kernel_name="python3",
                                        resources={"metadata": {"path": str(self.folder)}}).execute()
            finally:
                for name, value in before.items():
                    os.environ.pop(name) if value is None else os.environ.update({name: value})
            return
        os.environ["BAGNOLD_SOURCE"] = str(SOURCE)
        names = {}
        with warnings.catch_warnings(), contextlib.redirect_stdout(io.StringIO()), \
                contextlib.redirect_stderr(io.StringIO()):
            warnings.simplefilter("ignore")
            for number, cell in enumerate(cells):
                exec(compile("".join(cell["source"]), f"{path.name}, cell {number + 1}", "exec"), names)


if __name__ == "__main__":
    unittest.main()
