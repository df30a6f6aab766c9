# SPDX-License-Identifier: BSD-3-Clause
"""Every command of the pages (PAGES), in the order of the page, from a clean folder; every file name, link and claim.

A command is a line of a code block that begins with a program (PROGRAMS). The folder has the repository's
docs/, inputs/ and scripts/. A block of TOML that begins with "# NAME.toml" is written there as that file when its
turn comes; scene.toml (README.md) and sweep.toml (docs/scenes.md) are there from the first. What is done otherwise
than it stands there:

- The inputs are small stand-ins: strains, counts of disks and cycles are cut (`cut`), rates stay.
- `figure NAME` takes the quick version, unless it draws from tables (--data); of tables that the repository
  lacks the names are checked.
- Of lines with placeholders (in capitals: SCENE, KIND, DIR, PREFIX) the names are checked: subcommand and
  options against --help, presets of cmake, files of the repository.
- So they are of programs that install, build, take hours or need a cluster (NAMES_ONLY).

A block of "text" behind commands shows what the last of them prints: these lines, in this order, of the scene in
its full length.

With BAGNOLD_DOCUMENTATION=full in the environment nothing is cut (minutes; the tests cli.readme_in_full and
cli.tutorial_in_full).
"""

import contextlib
import csv
import io
import json
import os
import re
import shlex
import shutil
import subprocess
import sys
import unittest

import numpy as np
from PIL import Image

from bagnold import PROGRAM, SOURCE, CliTest, environment, read_summary

sys.path.insert(0, str(SOURCE / "scripts/lib"))
from kept_numbers import can_be_compared  # noqa: E402

PROGRAMS = ("bagnold", "build/openmp/bagnold", "cmake", "ctest", "python3", "sbatch", "docker", "apptainer", "spack",
            "rattler-build", "apt-get")
NAMES_ONLY = PROGRAMS[2:4] + PROGRAMS[5:]
FULL = os.environ.get("BAGNOLD_DOCUMENTATION") == "full"
PLACEHOLDER = re.compile(r"\b[A-Z]{3,}\b")
PAGES = ["README.md", *sorted(f"docs/{path.name}" for path in (SOURCE / "docs").glob("*.md")), "packaging/README.md"]
TEXTS = PAGES + ["docs/data/reproduction/details.md", "docs/data/performance/tried.md", "docs/data/performance/open.md", "CONTRIBUTING.md", "CHANGELOG.md",
                 "bench/README.md", "bench/peers/README.md", "examples/own_law/README.md", "examples/workflows/README.md"]
COUNTED = [name for name in PAGES if name != "packaging/README.md"] + ["CONTRIBUTING.md"]
MOST_WORDS, LONGEST_MEAN = 40000, 20  # of all these pages; of the sentences of each
NO_END = "".join(rf"(?<!\b{word}\.)" for word in ("App", "Eq", "Eqs", "Fig", "Figs", "Phys", "Rev", "Sec"))
FOLDERS = "bench|cmake|docs|examples|inputs|kernels|packaging|python|scripts|src|tests"


def text_of(name):
    return (SOURCE / name).read_text()


def blocks(text):
    """Code blocks in their order: (language, lines)."""
    found = re.finditer(r"^```(\w*)\n(.*?)^```$|((?:^    [^\n]*\n)+)", text, re.M | re.S)
    return [(one[1], one[2].splitlines()) if one[3] is None else ("", [line[4:] for line in one[3].splitlines()])
            for one in found]


def toml_file(language, lines):
    """The name of the file that a block shows, or None."""
    name = re.match(r"# ([\w-]+\.toml)\b", lines[0]) if language == "toml" and lines else None
    return name and name[1]


def shown_file(page, name):
    return next("\n".join(lines) + "\n" for language, lines in blocks(text_of(page))
                if toml_file(language, lines) == name)


def prose(text):
    """The text without its code blocks."""
    return re.sub(r"^```.*?^```$|(?:^    [^\n]*\n)+", "", text, flags=re.M | re.S)


def shown_text(text):
    """What a reader reads: no code blocks, targets of links, tags or comments."""
    return re.sub(r"\]\([^)]*\)", "]", re.sub(r"<!--.*?-->|</?(?:details|summary)>", "", prose(text), flags=re.S))


def words_of(text):
    """Each has a letter or a digit."""
    return [word for word in text.replace("|", " ").split() if re.search(r"[^\W_]", word)]


def sentences(text):
    """Sentences outside tables and headings, as lists of words; items of lists begin one."""
    lines = [line for line in shown_text(text).splitlines() if not re.match(r"\s*\||#", line)]
    blocks = re.split(r"\n\s*\n|\n(?=\s*(?:[-*]|\d+\.)\s)", "\n".join(lines))
    found = sum((re.split(rf"(?<=[.!?]){NO_END}\s+|(?<=[.!?][)\]\"*`])\s+", block) for block in blocks), [])
    return list(filter(None, map(words_of, found)))


def anchors(text):
    """What a link to a heading may say, as GitHub makes it."""
    headings = re.findall(r"^#+ (.*)$", prose(text), re.M)
    return {re.sub(r"[^\w -]", "", heading.lower()).replace(" ", "-") for heading in headings}


def is_program(word):
    return word in PROGRAMS or word.startswith("scripts/")


def commands(language, lines):
    """(command as it stands, its words) of a block."""
    found = []
    if language in ("toml", "cpp", "python", "text"):
        return found
    for line in "\n".join(lines).replace("\\\n", " ").splitlines():
        line = re.sub(r"^job=\$\((.*)\)$", r"\1", re.sub(r"\s+# .*$", "", line))
        try:
            words = shlex.split(line)
        except ValueError:
            continue  # a formula
        if words and is_program(words[0]):
            found.append((line, words))
    return found


def cut(text):
    """A scene or sweep file that takes a second."""
    if FULL:
        return text

    def number(match):
        largest = {"strain": 0.5, "count": 64, "cycles": 1}[match[1]]
        return match[1] + match[2] + re.sub(
            r"[\d.]+(e-?\d+)?", lambda one: repr(min(type(largest)(float(one[0])), largest)), match[3])

    key = r'\b(strain|count|cycles)("?\s*=\s*)(\[[^\]]*\]|[\d.e-]+)'
    return re.sub(key, number, text)


class Documentation(CliTest):
    def setUp(self):
        super().setUp()
        shutil.copytree(SOURCE / "inputs", self.folder / "inputs")
        for path in (self.folder / "inputs").rglob("*.toml"):
            if path.name != "figures.toml":
                path.write_text(cut(path.read_text()))
        for name in ("scripts", "docs"):
            (self.folder / name).symlink_to(SOURCE / name)
        (self.folder / "build/openmp").mkdir(parents=True)
        (self.folder / "build/openmp/bagnold").symlink_to(PROGRAM)
        (self.folder / "scene.toml").write_text(cut(shown_file("README.md", "scene.toml")))
        (self.folder / "sweep.toml").write_text(cut(shown_file("docs/scenes.md", "sweep.toml")))

    def test_the_chain_of_the_readme(self):
        self.check_page("README.md")
        if FULL:
            self.check_place_of_the_readme()

    def check_place_of_the_readme(self):
        """Its sweep ends without a warning, at the Q* that stands beside it; and its figure without one."""
        text = text_of("README.md")
        sweep = self.folder / "results/sweep_elasticity"
        (figure,) = (self.folder / "results/figures/data").iterdir()
        for folder in (sweep, figure):
            with open(folder / "sweep.csv", newline="") as file:
                self.assertEqual({row["warnings"] for row in csv.DictReader(file)}, {""})
        self.assertNotIn("not found", next((self.folder / "results/figures").glob("*/stated.csv")).read_text())
        with open(sweep / "crossover.csv", newline="") as file:
            (row,) = csv.DictReader(file)
        found, error = float(row["Q_star"]), float(row["Q_star_error"])
        self.assertIn(f"Q* = {found:.1f}({10 * error:.0f})", text)
        self.assertEqual(row["failure"], "")

    def test_the_tutorial(self):
        self.check_page("docs/tutorial.md")

    def test_both_places_of_the_readme(self):
        """What its sweep finds, what the reproduction finds and what P1 states are one, within two errors."""
        text = text_of("README.md")
        own = re.search(r"Q\* = (\d+)\.(\d)\((\d)\)", text)
        ours = re.search(r"Q\* at φ = 0.78 is ([\d.]+) ± ([\d.]+) \(P1: about ([\d.]+)\)", text)
        value, error = float(f"{own[1]}.{own[2]}"), float(own[3]) / 10
        place, its_error, stated = map(float, ours.groups())
        self.assertLess(abs(value - place), 2 * np.hypot(error, its_error))
        self.assertLess(abs(value - stated), 2 * np.hypot(error, 0.05))
        self.assertLess(abs(place - stated), 2 * its_error)

    def test_docs(self):
        for name in PAGES[1:]:
            if name == "docs/tutorial.md":
                continue  # above
            with self.subTest(file=name):
                self.check_page(name)

    def test_commands_in_the_text(self):
        """`bagnold ...` in a sentence: the names are there."""
        for name in TEXTS:
            for line in re.findall(r"`((?:build/openmp/)?bagnold [^`]+)`", text_of(name)):
                self.check_names(line.replace("...", ""), line.replace("...", "").split())

    def check_page(self, name):
        found = blocks(text_of(name))
        for (language, lines), below in zip(found, [*found[1:], ("", [])]):
            if file := toml_file(language, lines):
                (self.folder / file).write_text(cut("\n".join(lines) + "\n"))
            called = commands(language, lines)
            for line, words in called:
                with self.subTest(file=name, line=line):
                    said = self.check_line(line, words)
                    if FULL and below[0] == "text" and (line, words) == called[-1]:
                        self.check_said(said, below[1])

    def test_runs_print_what_stands_below_them(self):
        """Of full length, in every case: they take seconds."""
        found = 0
        for name in PAGES:
            shown = blocks(text_of(name))
            for (language, lines), (below, said) in zip(shown, shown[1:]):
                if file := toml_file(language, lines):
                    (self.folder / file).write_text("\n".join(lines) + "\n")
                words = [words for _, words in commands(language, lines)][-1:]
                if below == "text" and words and words[0][1] == "run":
                    self.check_said(self.run_line([*words[0], "--set", "output.plot=false"]), said)
                    found += 1
        self.assertGreater(found, 0)

    def check_said(self, said, lines):
        """All of these lines, in their order. Other compilers and processors make other bits."""
        if not can_be_compared(PROGRAM):
            self.skipTest("numbers of another compiler or processor")
        rest = iter(line.rstrip() for line in said.splitlines())
        for line in lines:
            self.assertIn(line.rstrip(), rest, said)

    def check_line(self, line, words):
        lacking = [word for word in words if word.startswith("docs/data/") and not (SOURCE / word).exists()]
        if words[0] in NAMES_ONLY or words[0].startswith("scripts/") or PLACEHOLDER.search(line) or lacking:
            self.check_names(line, words)
        else:
            return self.run_line(words)
        return ""

    def run_line(self, words):
        words = [PROGRAM if word in PROGRAMS[:2] else word for word in words]
        if words[1:2] == ["figure"] and len(words) > 2 and not {"--quick", "--data"} & set(words):
            listed = self.shell([PROGRAM, "figure"]).stdout
            if not re.search(rf"^{words[2]}\b.*--quick", listed, re.M):
                return self.assertRegex(listed, rf"(?m)^{words[2]}\b")
            words.append("--quick")
        result = self.shell(words)
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def shell(self, words):
        return subprocess.run(words, cwd=self.folder, env=environment(), capture_output=True, text=True,
                              timeout=3000 if FULL else 250, stdin=subprocess.DEVNULL)

    def check_names(self, line, words):
        program, options = words[0], re.findall(r"(?<![\w-])--[a-z][a-z-]*", line)
        if program in PROGRAMS[:2]:
            command = [word for word in words[1:2] if not word.startswith("-")]
            said = self.shell([PROGRAM, *command, "--help"])
            self.assertEqual(said.returncode, 0, line)
            for option in options:
                self.assertRegex(said.stdout, rf"(?<![\w-]){option}\b", line)
        elif program.startswith("scripts/"):
            self.assertTrue(os.access(SOURCE / program, os.X_OK), line)
            text = (SOURCE / program).read_text()
            if "python" in text.splitlines()[0]:
                compile(text, program, "exec")
            else:
                self.assertEqual(self.shell(["bash", "-n", SOURCE / program]).returncode, 0)
        elif program == "cmake":
            presets = json.loads((SOURCE / "CMakePresets.json").read_text())["configurePresets"]
            for preset in re.findall(r"--preset (\w+)", line):
                self.assertIn(preset, [one["name"] for one in presets])
        elif program == "sbatch":
            for path in re.findall(r"results/\S+", line):
                self.assertTrue((self.folder / path).exists(), line)
        for path in words:
            if re.match(rf"({FOLDERS})/", path) and not PLACEHOLDER.search(path):
                self.assertTrue((SOURCE / path).exists(), line)


class Pages(CliTest):
    def test_links_lead_somewhere(self):
        for name in TEXTS:
            for target in re.findall(r"\]\((?!https?:|mailto:)([^)]+)\)", prose(text_of(name))):
                path, _, anchor = target.partition("#")
                file = (SOURCE / name).parent / path if path else SOURCE / name
                self.assertTrue(file.exists(), f"{name}: {target}")
                if anchor:
                    self.assertIn(anchor, anchors(file.read_text()), f"{name}: {target}")

    def test_files_that_are_named_are_there(self):
        """A path from the root, or a name of a source, in backquotes. Names in capitals stand for others."""
        sources = {path.name for folder in FOLDERS.split("|") for path in (SOURCE / folder).rglob("*")}
        for name in TEXTS:
            for word in re.findall(r"`([^`\s]+)`", prose(text_of(name))):
                if PLACEHOLDER.search(word.rsplit("/", 1)[-1].split(".")[0]) or re.search(r"[*:{]", word):
                    continue
                if re.match(rf"({FOLDERS})/", word):
                    self.assertTrue((SOURCE / word).exists(), f"{name}: {word}")
                elif re.fullmatch(r"[\w-]+\.(cpp|hpp|py|cmake|sh)", word):
                    self.assertIn(word, sources, name)

    def test_pictures_are_sharp(self):
        """SVG, or a PNG of 160 pixels an inch and more: twice what a page shows of letters of its size."""
        found = 0
        for name in TEXTS:
            for target in re.findall(r"!\[[^]]*\]\((?!https?:)([^)]+)\)", text_of(name)):
                path = (SOURCE / name).parent / target
                found += 1
                if path.suffix == ".svg":
                    continue
                with Image.open(path) as picture:
                    if path.suffix == ".gif":  # a film: as wide as a page, and not long in coming
                        self.assertGreaterEqual(picture.width, 800, target)
                        self.assertLess(path.stat().st_size, 3e6, target)
                        continue
                    self.assertGreater(min(picture.info.get("dpi", (0, 0))), 159, f"{name}: {target}")
        self.assertGreater(found, 50)

    def test_the_index_has_every_page(self):
        index = text_of("docs/index.md")
        for name in PAGES[1:]:
            if name != "docs/index.md":
                self.assertIn(f"]({os.path.relpath(name, 'docs')})", index)

    def test_the_readme_is_a_page(self):
        self.assertLessEqual(len(text_of("README.md").splitlines()), 80)

    def test_all_pages_are_read_in_a_day(self):
        self.assertLess(sum(len(words_of(shown_text(text_of(name)))) for name in COUNTED), MOST_WORDS)

    def test_sentences_are_short(self):
        """On average, on each page."""
        long = {name: round(np.mean([len(one) for one in sentences(text_of(name))]), 1) for name in COUNTED}
        self.assertEqual({name: mean for name, mean in long.items() if mean >= LONGEST_MEAN}, {})

    def test_words_and_sentences_are_counted(self):
        page = ("# A heading\n\nSee [this page](docs/no-word.md) and Fig. 3. Two (2) words! γ̇ = 0.2 τ_e.\n\n"
                "- one item\n- another item, of\n  two lines\n\n| a | b |\n| --- | --- |\n| 1.5 | - |\n\n    code\n")
        self.assertEqual(list(map(len, sentences(page))), [6, 3, 3, 2, 5])
        self.assertEqual(len(words_of(shown_text(page))), 2 + 6 + 3 + 3 + 2 + 5 + 3)

    def test_what_the_readme_claims_stands_in_docs(self):
        """Every number of a reason is in a page that it links to."""
        reasons = re.findall(r"^- (\*\*(?!P\d).*)$", text_of("README.md"), re.M)
        self.assertGreaterEqual(len(reasons), 6)
        for reason in reasons:
            links = re.findall(r"\]\((docs/[^)#]+)", reason)
            self.assertTrue(links, reason)
            pages = "\n".join(text_of(link) for link in links)
            numbers = re.findall(r"(?<![\w.])\d[\d.]*(?:e-\d+)?", re.sub(r"\]\([^)]*\)|`[^`]*`", "", reason))
            for number in map(lambda one: one.rstrip("."), numbers):
                self.assertTrue(re.search(rf"(?<![\w.]){re.escape(number)}(?!\d)", pages), f"{number}: {reason}")

    def test_warnings_are_as_many_as_the_readme_says(self):
        count = int(re.search(r"(\d+) warnings", text_of("README.md"))[1])
        table = re.findall(r"^\| `(\w+)` \|", text_of("docs/stability.md"), re.M)
        self.assertEqual(len(set(table) - {"name"}), count)

    def test_the_first_scene_ends_without_a_warning(self):
        """As it stands in the README, of its full length."""
        scene = self.folder / "scene.toml"
        scene.write_text(shown_file("README.md", "scene.toml"))
        result = self.run_scene(scene, self.folder / "out", "--set", "output.plot=false", timeout=250)
        self.assertEqual(read_summary(self.folder / "out")["warnings"], [])
        self.assertNotIn("warning", result.stderr)

    def test_python_prints_what_stands_below_it(self):
        found = 0
        for name in PAGES:
            shown = blocks(text_of(name))
            for (language, code), (behind, said) in zip(shown, shown[1:]):
                if (language, behind) == ("python", "text"):
                    output = io.StringIO()
                    with contextlib.redirect_stdout(output):
                        exec("\n".join(code), {})
                    self.assertEqual(output.getvalue().splitlines(), said, name)
                    found += 1
        self.assertGreater(found, 0)


if __name__ == "__main__":
    unittest.main()
