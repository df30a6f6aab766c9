# SPDX-License-Identifier: BSD-3-Clause
"""Tables of numbers, each a CSV file, from calls of the program bagnold_accuracy."""
import csv
import io
import os
import subprocess
from concurrent.futures import ThreadPoolExecutor

import auto
import engines
import implicit
import quasi_static
from cases import CASES, FORMS, LEGEND, PAPERS, PRECISION, TWO_STAGE

REFERENCE = 0.2 / 64  # time step that stretches are held against, [tau_e]


class Tables:
    def __init__(self, program, states, folder, form, jobs, say):
        self.program, self.states, self.folder = program, states, folder
        self.of_runs = os.path.join(os.path.dirname(program), "bagnold")
        self.form, self.jobs, self.say = form, jobs, say

    def call(self, *arguments):
        done = subprocess.run([self.program, *map(str, arguments)], capture_output=True, text=True,
                              env={**os.environ, "OMP_NUM_THREADS": "1"})
        if done.returncode != 0:
            raise SystemExit(f"{' '.join(map(str, arguments))}\n{done.stderr.strip()}")
        return list(csv.reader(io.StringIO(done.stdout)))

    def write(self, name, calls):
        """One table of all calls: each prints the same header."""
        self.say(f"{name}: {len(calls)} calls")
        os.makedirs(self.folder, exist_ok=True)
        with ThreadPoolExecutor(self.jobs) as pool, \
                open(os.path.join(self.folder, name), "w", newline="") as file:
            out = csv.writer(file, lineterminator="\n")
            for number, table in enumerate(pool.map(lambda call: self.call(*call), calls)):
                out.writerows(table if number == 0 else table[1:])
                file.flush()  # what is done is kept if the rest is stopped

    def state(self, case):
        return ["--state", os.path.join(self.states, case.state, "state.h5")]

    def collision(self):
        steps = ",".join(map(str, self.form.collision_steps))
        self.write("collision.csv", [
            ("collision", "--models", model, "--phases", self.form.phases, "--dt", steps)
            for model in ("CD", "CD_n", "CD_rot")])

    def stability(self):
        self.write("stability_contact.csv", [("stability", "--models", model, "--points", self.form.map_points)
                                         for model in ("CD", "CD_n", "CD_rot")])
        schemes = ",".join([*LEGEND, "increment-sweep+packs+blocks=8"])
        self.write("stability_packing.csv", [
            ("packing", *self.state(CASES[0]), "--model", model, "--phi", CASES[0].phi, "--schemes", schemes)
            for model in ("CD", "CD_n", "CD_rot")])

    def stretches(self):
        """Means over a short time from common starts."""
        self.write("stretch.csv", [
            self.stretch(case, rate, [f"{scheme}:{case.shrink * step:g}" for scheme in LEGEND
                                      for step in self.form.steps])
            for case in CASES[:self.form.cases] for rate in self.form.rates])

    def precision(self):
        self.write("precision.csv", [
            self.stretch(case, rate, [f"{scheme}:{step}:{precision}" for scheme, step in
                                      ((TWO_STAGE, 0.2), (PAPERS, 0.05))
                                      for precision in ("double", "float-pairs", "float")])
            for case in PRECISION for rate in self.form.precision_rates])

    def stretch(self, case, rate, methods):
        discard = self.form.discard * min(1, rate / 1e-3)
        length = rate * self.form.stretch
        guide = "two-stage" if case.model != "CD_n" else "increment-sweep"
        return ("stretch", *self.state(case), *case.options(rate), "--methods", ",".join(methods),
                "--reference", f"{PAPERS}:{case.shrink * REFERENCE:g}", "--starts", self.form.starts,
                "--length", f"{length:g}", "--between", f"{3 * length:g}", "--discard", f"{discard:g}",
                "--guide", f"{guide}:{0.1 * case.shrink:g}")

    def steady(self):
        self.write("steady.csv", [
            ("steady", *self.state(case), *case.options(rate), "--method", f"{scheme}:{case.shrink * step:g}",
             "--strain", self.form.steady_strain, "--discard", self.form.discard)
            for case in CASES[:self.form.cases] for rate in self.form.steady_rates
            for scheme, step in ((TWO_STAGE, 0.2), ("increment-sweep", 0.4), (PAPERS, 0.05))])

    def engines(self):
        """Seconds, one run after the other."""
        self.write_rows("engines.csv", engines.COLUMNS, engines.measure(
            self.of_runs, self.states, self.form.rounds, self.form.strain_factor, self.say))

    def implicit(self):
        """Long steps in dense flow."""
        self.write_rows("implicit.csv", implicit.COLUMNS, implicit.measure(
            self.of_runs, self.states, self.form is FORMS["tiny"], self.jobs, self.say))

    def auto(self):
        """What the choice of schemes does."""
        self.write_rows("auto.csv", auto.COLUMNS, auto.measure(
            self.of_runs, self.states, self.form is FORMS["tiny"], self.jobs, self.say))

    def quasi_static(self):
        """Steps of a strain in flows that creep, one run after the other."""
        self.write_rows("quasi_static.csv", quasi_static.COLUMNS, quasi_static.measure(
            self.of_runs, self.states, self.form is FORMS["tiny"], self.say))

    def write_rows(self, name, columns, parts):
        """A table of what runs of the program itself tell, part by part."""
        os.makedirs(self.folder, exist_ok=True)
        with open(os.path.join(self.folder, name), "w", newline="") as file:
            out = csv.writer(file, lineterminator="\n")
            out.writerow(columns)
            for rows in parts:
                out.writerows(rows)
                file.flush()
