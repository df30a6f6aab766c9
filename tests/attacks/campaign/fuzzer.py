# SPDX-License-Identifier: BSD-3-Clause
"""A fuzzer of tests/attacks/fuzz as an attack. FUZZERS is the folder in which they are built; a corpus is
a list of inputs in JSON, their bytes as Latin-1."""

import json
import os
import pathlib
import re
import shutil
import subprocess

from target import TESTS

FUZZERS = pathlib.Path(os.environ.get("FUZZERS", TESTS.parent / "build/fuzz"))
PART = 20  # of a trial, [s]


class Fuzzer:
    def __init__(self, folder, random):
        self.random, self.folder = random, folder
        self.program = FUZZERS / f"fuzz_{self.kind}"
        self.why_not = "" if self.program.exists() else "the fuzzers are not built: scripts/attack builds them with clang"
        self.corpus = folder / "corpus"
        self.corpus.mkdir(parents=True)
        for file in sorted((TESTS.parent / "inputs").rglob("*.toml")):
            if ("[sweep]" in file.read_text()) == (self.kind == "sweep"):
                shutil.copy(file, self.corpus / file.name)
        packed = TESTS / f"attacks/fuzz/corpus/{self.kind}.json"
        for number, text in enumerate(json.loads(packed.read_text())):
            (self.corpus / f"{number:04}").write_bytes(text.encode("latin-1"))

    def trial(self):
        seed = self.random.randint(1, 2**31)
        result = subprocess.run(
            [self.program, f"-seed={seed}", f"-max_total_time={PART}", "-max_len=2048", "-timeout=25",
             "-print_final_stats=1", f"-artifact_prefix={self.folder}/", self.corpus],
            capture_output=True, text=True, errors="replace")
        runs = re.search(r"number_of_executed_units: (\d+)", result.stderr)
        wrong = "" if result.returncode == 0 else self.found(result.stderr)
        return f"seed {seed}", wrong, int(runs[1]) if runs else 1

    def found(self, stderr):
        """What is worth a word of a finding: what did not hold, and the input."""
        told = [line for line in stderr.splitlines() if line.startswith(("not so", "SUMMARY", "==", "ALARM"))]
        for file in sorted(self.folder.iterdir()):
            if file.is_file():
                told.append(f"{file.name}: {file.read_bytes()!r}")
                file.unlink()
        return "\n    ".join(told)

    def close(self):
        shutil.rmtree(self.folder, ignore_errors=True)
