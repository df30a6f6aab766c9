# SPDX-License-Identifier: BSD-3-Clause
"""bagnold.report: a page that needs nothing else, sorted by a click; bagnold.watch: what stands in the terminal."""

import contextlib
import html.parser
import io
import os
import re
import shutil
import subprocess
import unittest
import warnings

from made import FOLDER, SCENE, SOURCE, Folder, bagnold, made, run

CHROMIUM = shutil.which("chromium")
GRID = {"disks.elasticity": [1, 10, 3]}


def many():
    """A sweep of three points."""
    with warnings.catch_warnings():
        warnings.simplefilter("ignore")
        return bagnold.sweep_file({**SCENE, "title": "of three", "sweep": {"grid": GRID}}, out=FOLDER / "three", jobs=2,
                                  progress=False)


class Page(html.parser.HTMLParser):
    """Tags that stand open, texts of cells, and what is loaded from elsewhere."""

    EMPTY = {"meta", "img", "path", "use", "rect", "br"}

    def __init__(self, text):
        super().__init__()
        self.open, self.cells, self.loaded, self.tags = [], [], [], []
        self.feed(text)
        self.close()

    def handle_starttag(self, tag, attributes):
        self.tags.append(tag)
        if tag not in self.EMPTY:
            self.open.append(tag)
        if tag == "td":
            self.cells.append("")
        self.loaded += [value for name, value in attributes if name in ("src", "href", "xlink:href") and value]

    def handle_startendtag(self, tag, attributes):
        self.tags.append(tag)
        self.loaded += [value for name, value in attributes if name in ("src", "href", "xlink:href") and value]

    def handle_endtag(self, tag):
        if tag not in self.EMPTY:
            assert self.open.pop() == tag, tag

    def handle_data(self, text):
        if self.open and self.open[-1] == "td":
            self.cells[-1] += text


class Reports(Folder):
    def page(self, source, out=None):
        path = bagnold.report(source, out)
        text = path.read_text()
        page = Page(text)
        self.assertEqual(page.open, [])
        for one in page.loaded:
            self.assertRegex(one, "^(#|data:image/png)")
        self.assertNotRegex(re.sub(r'xmlns(:\w+)?="[^"]*"', "", text), r"@import|url\((?!#)|https?://(?!www.w3.org)")
        return text, page

    def test_of_a_run(self):
        r = run({**SCENE, "title": "<mine> & yours"}, self.folder / "one")
        text, page = self.page(r.folder, self.folder / "mail.html")
        self.assertIn("<title>&lt;mine&gt; &amp; yours</title>", text)
        for name, one in r.observables.items():
            self.assertIn(name, page.cells)
        self.assertIn(str(r["Z"]).split(" = ")[1].split()[0], " ".join(page.cells))
        for note in (*r.notes, *r.warnings):
            self.assertIn(f" {note.name}</b>", text)
        self.assertIn("svg", page.tags)
        self.assertIn('model = &quot;CD_rot&quot;', text)
        self.assertIn(f"bagnold resume {r.folder} --strain 2 ", text)
        self.assertIn(str(r.about["git"]), page.cells)
        self.assertEqual(list(self.folder.glob("*.part")), [])

    def test_commands_can_be_taken(self):
        """Another start is of other systems; what does not go with a protocol is not advised."""
        text, _ = self.page(made(disks__replicas=3, disks__seed=4), self.folder / "three.html")
        self.assertIn("--set disks.seed=7 ", text)
        turned = {"protocol": "sequence", "pieces": [[2.0**-7, 0.5], [-2.0**-7, 0.5]]}
        r = run({"disks": SCENE["disks"], "shear": turned, "output": {"sample_strain": 0.125, "plot": False}}, self.folder / "turned")
        text, _ = self.page(r, self.folder / "turned.html")
        self.assertNotIn("check-limit", text)
        self.assertNotIn("[&#x27;p&#x27;]", text)

    def test_the_same_run_gives_the_same_page(self):
        r = made()
        one, other = (re.sub("(?<=[#\"])p[0-9a-f]{10}", "", bagnold.report(r, self.folder / name).read_text()) for name in "ab")
        self.assertTrue(one == other, "but for the names of clip paths, which matplotlib makes of addresses")

    def test_of_frames(self):
        text, page = self.page(made(measure__profiles=True, measure__contacts=True, measure__frame_strain=2.0**-3))
        self.assertEqual(text.count("<figure>"), 3)

    def test_of_a_sweep(self):
        s = many()
        text, page = self.page(s)
        self.assertEqual(text.count("<tr><td data-value"), 3)
        self.assertIn("class=sorts", text)
        self.assertTrue("elasticity = [1, 10, 3]" in text)
        self.assertTrue((s.folder / "report.html").exists())

    def test_of_a_cascade(self):
        rates = {"protocol": "cascade", "strain_rates": [2.0**-6, 2.0**-7], "strain": 0.25}
        text, page = self.page(run({**SCENE, "shear": rates}, self.folder / "cascade"))
        self.assertEqual(text.count("<tr><td data-value"), 2)
        self.assertIn(f"bagnold resume {self.folder}/cascade --strain S ", text)

    def test_what_is_not_complete_is_refused(self):
        run(SCENE, self.folder / "one")
        (self.folder / "one/summary.json").unlink()
        with self.assertRaisesRegex(bagnold.InputError, "not complete; `bagnold resume"):
            bagnold.report(self.folder / "one")
        with self.assertRaisesRegex(bagnold.FileError, "no folder of a run"):
            bagnold.report(self.folder / "none")
        with self.assertRaisesRegex(bagnold.FileError, "choose another --out"):
            bagnold.report(made(), self.folder / "none/report.html")

    def test_only_files_are_replaced(self):
        self.keeps_what_is_no_file(lambda path: bagnold.report(made(), path), ".html")

    def test_by_the_program(self):
        done = subprocess.run([os.environ["BAGNOLD_PROGRAM"], "report", made().folder, "--out", "mine.html"], cwd=self.folder,
                              capture_output=True, text=True, env={**os.environ, "BAGNOLD_PYTHON_PACKAGE": str(SOURCE / "python")})
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertEqual(done.stdout.strip(), str(self.folder / "mine.html"))
        self.assertTrue((self.folder / "mine.html").exists())

    def test_by_the_program_where_none_is_in_the_path(self):
        """It asks the program that called it how a run stands."""
        run(SCENE, self.folder / "one")
        (self.folder / "one/summary.json").unlink()
        environment = {name: value for name, value in os.environ.items() if name != "BAGNOLD_PROGRAM"}
        done = subprocess.run([os.environ["BAGNOLD_PROGRAM"], "report", self.folder / "one"], cwd=self.folder, capture_output=True,
                              text=True, env={**environment, "PATH": "/usr/bin:/bin", "BAGNOLD_PYTHON_PACKAGE": str(SOURCE / "python")})
        self.assertEqual(done.returncode, 2, done.stderr)
        self.assertIn("not complete; `bagnold resume", done.stderr)

    @unittest.skipUnless(CHROMIUM, "chromium is not installed")
    def test_a_click_sorts(self):
        """In a browser: up, down, and what has no number last."""
        text = bagnold.report(many(), self.folder / "page.html").read_text()
        column = re.findall(r"<th>(.*?)</th>", text).index("elasticity")
        for clicks, wanted in ((0, ["1", "10", "3"]), (1, ["1", "3", "10"]), (2, ["10", "3", "1"])):
            click = f"<script>for (let k = 0; k < {clicks}; ++k) document.querySelectorAll('.sorts th')[{column}].click()</script>"
            (self.folder / "clicked.html").write_text(text.replace("</body>", click + "</body>"))
            said = subprocess.run([CHROMIUM, "--headless", "--no-sandbox", "--disable-gpu", f"--user-data-dir={self.folder}/profile",
                                   "--dump-dom", f"file://{self.folder}/clicked.html"], capture_output=True, text=True, timeout=120)
            rows = re.findall(r"<tr><td data-value.*?</tr>", said.stdout)
            self.assertEqual([re.findall(r"<td.*?>(.*?)</td>", row)[column] for row in rows], wanted, said.stderr[-300:])


class Watching(Folder):
    def watched(self, *words, **options):
        said = io.StringIO()
        with contextlib.redirect_stdout(said):
            found = bagnold.watch(*words, **options)
        return found, said.getvalue()

    def test_what_is_done(self):
        r = made()
        found, said = self.watched(r.folder)
        self.assertEqual(found.state, "done")
        late = r.series["Z"][-10:].mean()
        self.assertIn(f"{r.folder}  done 100%  strain 1  p ", said)
        self.assertIn(f"Z {late:.4g}", said)

    def test_many(self):
        found, said = self.watched(many().folder)
        self.assertIn("3 points: 3 done; 100%", said)

    def test_a_cascade(self):
        rates = {"protocol": "cascade", "strain_rates": [2.0**-6, 2.0**-7], "strain": 0.25}
        found, said = self.watched(run({**SCENE, "shear": rates}, self.folder / "cascade").folder)
        first, second, last = said.splitlines()
        self.assertRegex(first, r"^1  done 100%  strain 0.25  p .*  sigma .*  Z ")
        self.assertRegex(last, "2 rates: 2 done; 100%")

    def test_until_it_ends(self):
        path = self.folder / "out"
        program = subprocess.Popen([os.environ["BAGNOLD_PROGRAM"], "run", self.scene_file(), "--out", path, "--quiet"])
        try:
            while not (path / "scene.toml").exists():
                self.assertIsNone(program.poll())
            found, said = self.watched(path, every=0.1)
        finally:
            program.wait()
        self.assertEqual(found.state, "done")
        self.assertTrue(said.splitlines()[-1].startswith(f"{path}  done 100%"))

    def scene_file(self):
        from bagnold.scene import toml_text
        path = self.folder / "scene.toml"
        path.write_text(toml_text({**SCENE, "shear": {**SCENE["shear"], "strain": 64.0}}))
        return path

    def test_by_the_program(self):
        done = subprocess.run([os.environ["BAGNOLD_PROGRAM"], "watch", made().folder, "--once"], capture_output=True, text=True,
                              env={**os.environ, "BAGNOLD_PYTHON_PACKAGE": str(SOURCE / "python")})
        self.assertEqual((done.returncode, done.stderr), (0, ""))
        self.assertIn("done 100%", done.stdout)
        done = subprocess.run([os.environ["BAGNOLD_PROGRAM"], "watch", self.folder], capture_output=True, text=True)
        self.assertEqual(done.returncode, 2)
        self.assertIn("holds no run", done.stderr)


if __name__ == "__main__":
    unittest.main()
