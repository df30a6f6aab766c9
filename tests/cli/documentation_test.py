# SPDX-License-Identifier: BSD-3-Clause
"""Every command of README.md and docs/*.md, in the order of the file, from a clean folder.

A command is a line of a code block that begins with a program (PROGRAMS). The folder has the repository's
docs/, inputs/ and scripts/ and, as scene.toml and sweep.toml, the README's own scene, alone and with its [sweep].
What is done otherwise than it stands there:

- The inputs are small stand-ins: strains, counts of disks and cycles are cut (`cut`), rates stay.
- `figure NAME` takes the quick version, unless it draws from tables (--data); of tables that the repository
  lacks the names are checked.
- Of lines with placeholders (in capitals: SCENE, KIND, DIR, PREFIX) the names are checked: subcommand and
  options against --help, presets of cmake, files of scripts/.
- So they are of programs that install, build, take hours or need a cluster (NAMES_ONLY).
"""

import json
import os
import re
import shlex
import shutil
import subprocess
import unittest

from bagnold import PROGRAM, SOURCE, CliTest, environment

PROGRAMS = ("bagnold", "build/openmp/bagnold", "cmake", "ctest", "python3", "sbatch")
NAMES_ONLY = ("cmake", "ctest", "sbatch")
PLACEHOLDER = re.compile(r"\b[A-Z]{3,}\b")
FILES = ["README.md", *sorted(f"docs/{path.name}" for path in (SOURCE / "docs").glob("*.md"))]


def blocks(text):
    """Code blocks: (language, lines)."""
    fenced = re.findall(r"^```(\w*)\n(.*?)^```$", text, re.M | re.S)
    rest = re.sub(r"^```.*?^```$", "", text, flags=re.M | re.S)
    indented = re.findall(r"(?:^    .*\n)+", rest, re.M)
    return [(language, body.splitlines()) for language, body in fenced] + [
        ("", [line[4:] for line in body.splitlines()]) for body in indented]


def is_program(word):
    return word in PROGRAMS or word.startswith("scripts/")


def commands(text):
    """(command as it stands, its words)."""
    found = []
    for language, lines in blocks(text):
        if language in ("toml", "cpp", "python"):
            continue
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
        toml = ["\n".join(lines) + "\n" for language, lines in blocks((SOURCE / "README.md").read_text())
                if language == "toml"]
        scene = cut(next(text for text in toml if "[disks]" in text))
        sweep = cut(next(text for text in toml if "[sweep]" in text))
        (self.folder / "scene.toml").write_text(scene)
        (self.folder / "sweep.toml").write_text(scene + sweep)

    def test_the_chain_of_the_readme(self):
        self.check_file("README.md")

    def test_docs(self):
        for name in FILES[1:]:
            with self.subTest(file=name):
                self.check_file(name)

    def test_commands_in_the_text(self):
        """`bagnold ...` in a sentence: the names are there."""
        for name in FILES:
            for line in re.findall(r"`((?:build/openmp/)?bagnold [^`]+)`", (SOURCE / name).read_text()):
                self.check_names(line.replace("...", ""), line.replace("...", "").split())

    def check_file(self, name):
        for line, words in commands((SOURCE / name).read_text()):
            with self.subTest(file=name, line=line):
                lacking = [word for word in words if word.startswith("docs/data/") and not (SOURCE / word).exists()]
                if (words[0] in NAMES_ONLY or words[0].startswith("scripts/") or PLACEHOLDER.search(line)
                        or lacking):
                    self.check_names(line, words)
                else:
                    self.run_line(words)

    def run_line(self, words):
        words = [PROGRAM if word in PROGRAMS[:2] else word for word in words]
        if words[1:2] == ["figure"] and len(words) > 2 and not {"--quick", "--data"} & set(words):
            listed = self.shell([PROGRAM, "figure"]).stdout
            if not re.search(rf"^{words[2]}\b.*--quick", listed, re.M):
                return self.assertRegex(listed, rf"(?m)^{words[2]}\b")
            words.append("--quick")
        result = self.shell(words)
        self.assertEqual(result.returncode, 0, result.stderr)

    def shell(self, words):
        return subprocess.run(words, cwd=self.folder, env=environment(), capture_output=True, text=True,
                              timeout=250, stdin=subprocess.DEVNULL)

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


if __name__ == "__main__":
    unittest.main()
