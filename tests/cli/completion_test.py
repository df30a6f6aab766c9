# SPDX-License-Identifier: BSD-3-Clause
"""What bash and zsh offer while a command of the program is typed, by packaging/completion."""

import re
import shutil
import subprocess
import unittest

from bagnold import PROGRAM, SOURCE, CliTest, environment

FILES = SOURCE / "packaging/completion"
# As in the source: add_check_limit makes the command check-limit.
LIST = re.search(r"all_commands\[\] = \{(.*?)\}", (SOURCE / "src/cli/commands.hpp").read_text(), re.S)[1]
COMMANDS = {name.replace("_", "-") for name in re.findall(r"\badd_(\w+)", LIST)}

BASH = """
source "$1"; shift
COMP_WORDS=("$@"); COMP_CWORD=$(($# - 1))
_bagnold
printf '%s\\n' "${COMPREPLY[@]}"
"""
# What the completion tells zsh is printed instead.
ZSH = """
file=$1; shift
words=("$@"); CURRENT=$#
compadd() { print -rl -- ${(P)2} }
_describe() { print -rl -- ${${(P)2}%%:*} }
_files() { print -r -- FILES }
. $file
"""


class Completion:
    """Of either shell: `offers` makes a set of words."""

    def test_every_command(self):
        self.assertEqual(self.offers(""), COMMANDS | {"help"})

    def test_commands_behind_help(self):
        self.assertLessEqual(COMMANDS, self.offers("help", ""))

    def test_options_are_those_of_the_command(self):
        for command in sorted(COMMANDS):
            said = self.bagnold(command, "--help").stdout
            wanted = set(re.findall(r"^  (?:-\w,)?(--[a-z-]+)", said, re.M))
            self.assertEqual(self.offers(command, "--"), wanted, command)
            self.assertIn("--help", wanted)

    def test_options_of_the_program(self):
        self.assertEqual(self.offers("--"), {"--help", "--version"})

    def test_values_in_the_help(self):
        self.assertEqual(self.offers("run", "scene.toml", "--backend", ""), {"serial", "openmp", "cuda"})

    def test_kinds_of_analysis(self):
        documented = set(re.findall(r"^### ([a-z-]+)$", (SOURCE / "docs/analysis.md").read_text(), re.M))
        self.assertEqual(self.offers("analyse", ""), documented)

    def test_names_of_figures(self):
        names = self.offers("figure", "")
        self.assertLessEqual({"P1-1", "P1-17", "P2-4", "P2-36"}, names)
        self.assertEqual(len(names), 51)  # docs/figures.md: P1 has 16, P2 35


class Bash(Completion, CliTest):
    def offers(self, *words):
        self.assertTrue((FILES / "bagnold.bash").exists())
        said = subprocess.run(["bash", "-c", BASH, "bash", FILES / "bagnold.bash", PROGRAM, *words], cwd=SOURCE,
                              env=environment(), capture_output=True, text=True, timeout=60)
        self.assertEqual((said.returncode, said.stderr), (0, ""))
        return set(said.stdout.split())

    def test_words_that_begin_so(self):
        self.assertEqual(self.offers("re"), {name for name in COMMANDS if name.startswith("re")})

    def test_files_elsewhere(self):
        self.assertEqual(self.offers("run", ""), set())  # then bash offers files
        self.assertIn("-o default", (FILES / "bagnold.bash").read_text())


@unittest.skipUnless(shutil.which("zsh"), "zsh is not installed")
class Zsh(Completion, CliTest):
    def offers(self, *words):
        said = subprocess.run(["zsh", "-f", "-c", ZSH, "zsh", FILES / "_bagnold", PROGRAM, *words], cwd=SOURCE,
                              env=environment(), capture_output=True, text=True, timeout=60)
        self.assertEqual(said.stderr, "")
        return set(said.stdout.split())

    def test_files_elsewhere(self):
        self.assertEqual(self.offers("run", ""), {"FILES"})


if __name__ == "__main__":
    unittest.main()
