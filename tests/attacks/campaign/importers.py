# SPDX-License-Identifier: BSD-3-Clause
"""Files of other programs: what is known, written in many dialects and spoiled now and then (tests/python/writers.py); and
the headers beside the fuzzers with bytes and words changed, by atheris where scripts/attack could install it too."""

import pathlib
import random as randomness
import re
import shutil
import signal
import subprocess
import sys
import traceback

from fuzzer import FUZZERS, PART
from target import TESTS

sys.path[:0] = [str(TESTS / "python"), str(TESTS / "attacks/fuzz")]

import import_target  # noqa: E402
import writers  # noqa: E402
from import_target import bagnold  # noqa: E402

MANY = 100  # files a trial
LIMIT = 20  # of one import, [s]
PYTHON = FUZZERS / "python/bin/python3"
#: Words that mean something to one importer or another.
TOKENS = [word.encode() for word in (
    "xy xz yz|pp pp pp|abc origin|xlo xhi|ITEM: TIMESTEP|ITEM: TIME|ITEM: ATOMS|ITEM: BOX BOUNDS|ITEM: NUMBER OF ATOMS|Atoms # sphere|"
    "Velocities|Masses|atoms|avec|Lattice=|Properties=|pbc=|Origin=|:R:3|:I:1|T T F|[True, False, True]|id|type|radius|diameter|vx vy|"
    "momenta|0|-1|1e999|nan|1.0D-3|1e-320|9999999999999999999|\n|\n\n|\t|\"|#|=|:|{|]").split("|")]


class Attack:
    def __init__(self, folder, random):
        self.folder, self.random = folder, random
        folder.mkdir(parents=True, exist_ok=True)
        self.corpus = import_target.corpus()
        self.atheris = PYTHON.exists() and subprocess.run([PYTHON, "-c", "import atheris"], capture_output=True).returncode == 0

    def trial(self):
        draw = self.random.random()
        if draw < 0.02 and self.atheris:
            return self.by_atheris()
        return self.many(self.written if draw < 0.5 else self.changed)

    def many(self, one):
        seed = self.random.randint(1, 2**31)
        for k in range(MANY):
            wrong = self.within_time(one, randomness.Random(seed + k))
            if wrong:
                return f"{one.__name__}, seed {seed + k}", wrong, k + 1
        return f"{one.__name__}, seed {seed}", "", MANY

    def within_time(self, one, random):
        def late(*_):
            raise TimeoutError(f"longer than {LIMIT} s")

        before = signal.signal(signal.SIGALRM, late)
        signal.alarm(LIMIT)
        try:
            return one(random)
        except Exception:
            return f"{traceback.format_exc()}\n{(self.folder / 'x.txt').read_bytes()!r}"
        finally:
            signal.alarm(0)
            signal.signal(signal.SIGALRM, before)

    def written(self, random):
        """Read as it was written, or refused where it is spoiled or may be another."""
        truth = writers.made(random)
        made = random.choice(writers.WRITERS)(random, truth)
        path = self.folder / "x.txt"
        path.write_bytes(made.data)
        try:
            state = bagnold.import_state(path, self.folder / "x.h5", format=random.choice((None, made.format)), tolerance=1e-4, **made.options)
        except bagnold.Error as error:
            return "" if made.spoiled or made.unclear else f"refused: {error}\n{made.data!r}"
        (read,) = bagnold.frames.read_states(state.path)
        wrong = f"{made.spoiled} and not refused" if made.spoiled else writers.wrong(truth, made, state, read)
        return wrong and f"{wrong}\n{made.data!r}\n{state}"

    def changed(self, random):
        import_target.attack(self.folder, mutated(random, self.corpus))
        return ""

    def by_atheris(self):
        seed = self.random.randint(1, 2**31)
        corpus = self.folder / "corpus"
        if not corpus.exists():
            corpus.mkdir()
            for k, data in enumerate(self.corpus):
                for how in (0, 1, 2, 3, 32, 64):
                    (corpus / f"{k}-{how}").write_bytes(bytes([how]) + data)
        result = subprocess.run(
            [PYTHON, TESTS / "attacks/fuzz/fuzz_import.py", corpus, f"-seed={seed}", f"-max_total_time={PART}", "-max_len=2048",
             f"-timeout={LIMIT}", f"-artifact_prefix={self.folder}/", "-print_final_stats=1"],
            capture_output=True, text=True, errors="replace")
        runs = re.search(r"number_of_executed_units: (\d+)", result.stderr)
        wrong = "" if result.returncode == 0 else result.stderr[-2000:]
        for file in self.folder.glob("crash-*"):
            wrong += f"\n{file.name}: {file.read_bytes()!r}"
            file.unlink()
        return f"atheris, seed {seed}", wrong, int(runs[1]) if runs else 1

    def close(self):
        shutil.rmtree(self.folder, ignore_errors=True)


def mutated(random, corpus):
    """A file of the corpus with a few changes, and the byte that says how it is imported."""
    data = bytearray(random.choice(corpus))
    for _ in range(random.choice((1, 1, 2, 3, 8))):
        kind = random.randrange(9)
        at = random.randrange(len(data) + 1)
        words = [match.span() for match in re.finditer(rb"\S+", data)]
        rows = bytes(data).splitlines(keepends=True)
        if kind == 0 and data:
            data[at % len(data)] = random.randrange(256)
        elif kind == 1:
            data[at:at] = random.choice(TOKENS)
        elif kind == 2:
            del data[at:at + random.choice((1, 1, 4, 64))]
        elif kind == 3 and words:  # another word, of this file or not
            begin, end = random.choice(words)
            first, last = random.choice(words)
            data[begin:end] = random.choice((data[first:last], random.choice(TOKENS)))
        elif kind == 4 and words:
            begin, end = random.choice(words)
            del data[begin:end]
        elif kind == 5 and rows:
            row = random.randrange(len(rows))
            rows.insert(random.randrange(len(rows) + 1), rows[row] if random.random() < 0.5 else rows.pop(row))
            data = bytearray(b"".join(rows))
        elif kind == 6:
            other = random.choice(corpus)
            data = data[:at] + bytearray(other[random.randrange(len(other)):])
        elif kind == 7:
            data = bytearray(bytes(data).replace(b"\n", random.choice((b"\r\n", b"\r", b" \n"))))
        elif kind == 8:
            data = bytearray(bytes(data).decode("utf-8", "replace").encode(random.choice(("utf-16", "utf-8-sig", "latin-1")), "replace"))
    return bytes([random.randrange(128)]) + bytes(data)
