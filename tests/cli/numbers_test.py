# SPDX-License-Identifier: BSD-3-Clause
"""Numbers of README and docs against where they come from: docs/data, other tables of the pages, inputs/ and the program.

A number on a page is its source's value to the digits shown, and so is the error beside it. What is said of many
numbers ("0.3 to 0.5%", "within 1%") is their least and greatest. A phrase that changes has to be changed here too.
"""

import csv
import itertools
import math
import re
import subprocess
import sys
import tomllib
import unittest
from decimal import Decimal

import h5py
import numpy as np

from bagnold import SOURCE, CliTest

sys.path.insert(0, str(SOURCE / "python/bagnold"))  # the module alone, as `bagnold` is that of these tests
from observables import rounded as with_error  # noqa: E402

NUMBER = r"[-+]?\d+(?:\.\d+)?(?:e[-+]?\d+)?"
PAPERS, DEFAULT, IMPLICIT = "modified-velocity-verlet", "two-stage-leapfrog", "implicit-damping"
KEYS = ("p", "sigma", "Z", "T_g")
EVIDENCE = "docs/data/accuracy/tried.md"


def text_of(page):
    return (SOURCE / page).read_text().replace("−", "-")


def table_of(page, header):
    """The cells of the table whose header begins so, row after row."""
    below = text_of(page).split(f"\n| {header}", 1)[1].split("\n")[2:]
    lines = itertools.takewhile(lambda line: line.startswith("|"), below)
    return [[cell.strip() for cell in re.split(r"(?<!\\)\|", line)[1:-1]] for line in lines]


def data(name):
    """Rows of docs/data/NAME.csv, numbers as such."""
    with open(SOURCE / f"docs/data/{name}.csv", newline="") as file:
        rows = list(csv.DictReader(line for line in file if not line.startswith("#")))
    return [{key: float(text) if re.fullmatch(NUMBER, text) else text for key, text in row.items()} for row in rows]


def where(rows, **wanted):
    return [row for row in rows if all(row[key] == value for key, value in wanted.items())]


def is_shown(text, value):
    """Tables are rounded too: half a unit of the last digit still counts."""
    unit = 10.0 ** Decimal(text).as_tuple().exponent
    return abs(float(text) - value) <= unit * (0.5 + 1e-6)


def rounded(value, digits=3):
    return float(f"{value:.{digits}g}")


def with_errors(row, keys=KEYS, error="{}_err", factor=1):
    return [factor * row[name] for key in keys for name in (key, error.format(key))]


def state_of(cell):
    """Model, phi, Q and rate of "CD_n 0.78, Q = 50, 1e-4"; Q is 1 where it is not told."""
    model, phi, q, rate = re.match(r"(CD\w*) ([\d.]+)(?:,? Q ?= ?([\d.]+))?(?:,? ([\d.e-]+))?$", cell).groups()
    return model, float(phi), float(q or 1), rate and float(rate)


def name_of(cell):
    """The same as the tables of long steps call it."""
    return "{} {:g} Q={:g} {:g}".format(*state_of(cell))


class Shown(CliTest):
    def compare(self, text, values, about=""):
        """All numbers of a text, in their order."""
        found = re.findall(NUMBER, text)
        self.assertEqual(len(found), len(values), f"{about}: {text}: {values}")
        for number, value in zip(found, values):
            self.assertTrue(is_shown(number, value), f"{about}: {text}: {number} is {value:.6g}")

    def says(self, page, phrase, *values):
        """The page has the phrase once, with these numbers for {}."""
        pattern = f"({NUMBER})".join(map(re.escape, phrase.split("{}")))
        found = [match.groups() for match in re.finditer(rf"(?<![\w.]){pattern}(?!\w)", text_of(page))]
        self.assertEqual(len(found), 1, f"{page}: {phrase}")
        self.compare(" ".join(found[0]), values, f"{page}: {phrase}")


class Accuracy(Shown):
    page = "docs/accuracy.md"

    def test_gain(self):
        rows = {(row["state"], row["engine"], row["scheme"]): row for row in data("accuracy/engines")}
        table = table_of(self.page, "state | step of the papers")
        gains = []
        for state, *cells in table:
            model, phi, q, _ = state_of(state)
            rate = state.split()[-1]
            name = f"cd_n-q{q:g}-{rate}-1024" if model == "CD_n" else f"{model.lower()}{100 * phi:.0f}-{rate}-1024"
            papers, default = rows[name, "steps", PAPERS], rows[name, "steps", DEFAULT]
            gains.append(papers["seconds"] / default["seconds"])
            others = [rows.get((name, engine, DEFAULT), {}).get("seconds")
                      for engine in ("few-contacts", "many-contacts", "lookahead", "reference")]
            self.assertEqual([cell == "-" for cell in cells[4:]], [value is None for value in others], state)
            self.compare(" ".join(cell for cell in cells if cell != "-"), [
                papers["time_step"], papers["seconds"], default["seconds"], gains[-1], *filter(None, others)], state)
        self.assertEqual(len(table), len({state for state, *_ in rows}))
        self.assertEqual(table[np.argmin(gains)][0], "CD_n 0.78, Q = 1, 1e-5")
        self.says(self.page, "In Newtonian CD_rot a step of two stages costs {} steps", 0.2 / 0.05 / gains[0])
        self.says("docs/scenes.md", "it takes {}, {} and {} s of one core at γ̇ = 1e-4, 1e-5 and 1e-6", *(
            rows[f"cd_n-q50-{rate}-1024", "steps", DEFAULT]["seconds"] for rate in ("1e-4", "1e-5", "1e-6")))

    def test_one_collision(self):
        rows = [row for row in data("accuracy/collision") if row["Q"] >= 1]

        def percent(key, **wanted):
            return [100 * row[key] for row in where(rows, **wanted)]

        expected = [[max(map(abs, percent("loss_error", scheme="two-stage", dt=0.2))), 1, 500]]
        for scheme, dt, sign in (("two-stage", 0.3, -1), ("two-stage", 0.4, -1), (PAPERS, 0.05, 1), (PAPERS, 0.2, 1)):
            lost = [sign * loss for loss in percent("loss_error", scheme=scheme, dt=dt, Q=500)]
            expected.append([min(lost), max(lost)])
        for (_, dt, cell), wanted in zip(table_of(self.page, "scheme | dt | energy lost"), expected, strict=True):
            self.compare(cell, wanted, dt)
        short = [-error for error in percent("duration_error", scheme="two-stage", dt=0.2)]
        self.says(self.page, "Durations are {} to {}% short at 0.2; {}% is that of equal masses at Q = 1", min(short), max(short),
                  *{-error for error in percent("duration_error", scheme="two-stage", dt=0.2, Q=1, mass="equal")})
        self.says("docs/data/performance/open.md", "They are {} to {}% short", min(short), max(short))
        short = [-error for q in (50, 500) for error in percent("duration_error", scheme="two-stage", dt=0.2, Q=q, model="CD_n")]
        self.says("docs/physics.md", "dt = 0.2 makes τ_dur {} to {}% short at these Q", min(short), max(short))

    def test_short_stretches(self):
        rows = data("accuracy/stretch")
        for state, scheme, dt, *cells in table_of(self.page, "state | scheme | dt | p, 1e-3"):
            model, phi, q, _ = state_of(state)
            pairs = [(row, key) for rate in (1e-3, 1e-4) for row in where(
                rows, model=model, phi=phi, Q=q, scheme=scheme.replace(" ", "-"), dt=float(dt), rate=rate) for key in KEYS]
            for cell, (row, key) in zip(cells, pairs, strict=True):
                values = with_errors(row, [key], "{}_error", 100)
                if "(" not in cell:  # no error that the digits show
                    self.assertLess(values.pop(), 0.005, (state, key, cell))
                self.compare(cell, values, f"{state}, {scheme}, {key}")

        def percent(*keys, **wanted):
            return [100 * row[key] for row in where(rows, **wanted) for key in keys]

        low = [-value for value in percent("sigma", model="CD_rot", phi=0.82, dt=0.2, scheme="pairwise-sweep")]
        self.says(self.page, "CD_rot at φ = 0.82, Q = 1 by {} to {}% (`pairwise-sweep`)", min(low), max(low))
        sweep = percent("sigma", model="CD_rot", phi=0.82, dt=0.4, scheme="increment-sweep")
        self.assertLess(max(map(abs, sweep)), float(re.search(r"is right to ([\d.]+)% even at 0.4", text_of(self.page))[1]))
        papers = where(rows, scheme=PAPERS, dt=0.1)
        self.says(self.page, "at dt = 0.1 its bias is within {}% in all of them but CD_n at Q = 0.1",
                  max(100 * abs(row[key]) for row in papers if row["Q"] != 0.1 for key in KEYS))
        low = [[-value for value in percent("p_el", model="CD_n", Q=0.1, scheme="two-stage", dt=dt)] for dt in (0.1, 0.05)]
        self.says(self.page, "its elastic share is {} to {}% low at dt = 0.1, and {}% at 0.05", min(low[0]), max(low[0]), max(low[1]))
        dense = [value for model in ("CD", "CD_rot") for value in percent(
            "p", "sigma", "Z", model=model, phi=0.82, dt=0.2, scheme="two-stage")]
        self.says("docs/scenes.md", "in Newtonian flow by {}%", max(map(abs, dense)))

    def test_steady_states(self):
        rows = data("accuracy/steady")
        names = {"two stages": "two-stage", "papers'": PAPERS}
        for state, scheme, *cells in table_of(self.page, "state | scheme, dt | B_p | B_sigma"):
            name, dt = scheme.rsplit(" ", 1)
            model, phi, q, _ = state_of(state)
            row, = where(rows, model=model, phi=phi, Q=q, rate=1e-4, scheme=names[name], dt=float(dt))
            self.compare(" ".join(cells), [*with_errors(row, ("B_p", "B_sigma", "Z"), "{}_error"), 100 * row["gap"]], state)
        papers = where(rows, rate=1e-3, scheme=PAPERS)
        self.assertEqual(len(papers), 7)  # "in seven states": within 1%, and two errors where both are known
        for one in papers:
            for other in where(rows, rate=1e-3, scheme="two-stage", model=one["model"], phi=one["phi"], Q=one["Q"]):
                for key in ("B_p", "B_sigma", "Z"):
                    error = np.hypot(float(one[f"{key}_error"]), float(other[f"{key}_error"]))
                    self.assertLess(abs(other[key] - one[key]), min(0.01 * one[key], 2 * np.nan_to_num(error, nan=np.inf)))
        three = [where(rows, model="CD", rate=1e-3, scheme=scheme)[0] for scheme in (PAPERS, "two-stage", "increment-sweep")]
        self.says(self.page, "CD at φ = 0.82 gave {} ({}), {} ({}) and {} ({}) in three runs",
                  *(value for row in three for value in with_errors(row, ["B_p"], "{}_error")))

    def test_deviations_are_counted(self):
        """Of the tables on the page itself, whose sweeps take half an hour."""
        cells = [cell for row in table_of(self.page, "state | rate | B_p") for cell in row[2:]]
        pairs = [tuple(map(float, re.findall(NUMBER, cell))) for cell in cells]
        self.assertEqual(len(pairs), 45)
        self.assertEqual(sum(abs(value) > 2 * error for value, error in pairs), 4)
        self.assertIn("Four of these 45 deviations exceed two standard errors", text_of(self.page))
        found = [cell for row in table_of(EVIDENCE, "| B_p | B_sigma | Z | R_v") if "beyond 2" in row[0] for cell in row[1:]]
        self.says(EVIDENCE, "Of {} deviations {} are within 2", 72, 72 - len(list(filter(None, found))))

    def test_exact_contacts(self):
        rows = {}
        for state, engine, duration, gap, _ in table_of(self.page, "φ, rate | engine | τ_dur"):
            key = state or key
            value, digits = re.match(r"([\d.]+)\((\d+)\)", duration).groups()
            rows[key, engine] = float(value), float(digits) * 10 ** -len(value.split(".")[1]), float(gap.rstrip("%"))
        shown = []
        for key in ("0.78, 1e-5", "0.60, 1e-4"):
            (steps, error, _), (exact, other, _) = rows[key, "steps"], rows[key, "events"]
            shown += [100 * (exact - steps) / exact, 1e4 * np.hypot(error, other) / exact]
        self.says(self.page, "durations are {}% ({}) and {}% ({}) short", *shown)
        gaps = [gap for (_, engine), (*_, gap) in rows.items() if engine == "steps"]
        self.says(self.page, "They dissipate {} to {}% less than the shear puts in", min(gaps), max(gaps))

    def test_precision(self):
        rows = data("accuracy/precision")

        def percent(key, precision, scheme, *rates, model="CD_rot"):
            return [100 * row[key] for rate in rates for row in where(
                rows, model=model, precision=precision, scheme=scheme, rate=rate)]

        pairs = {key: [max(map(abs, percent(key, "float-pairs", "two-stage", *rates) + percent(key, "float-pairs", PAPERS, *rates)))
                       for rates in ((1e-3, 1e-4, 1e-5), (1e-6,))] for key in ("p", "Z")}
        table = [row[2] for row in table_of(self.page, "arithmetic | rate | deviation")]
        self.compare(table[0], [pairs["p"][0], pairs["Z"][0]])
        self.compare(table[1], [pairs["p"][1], pairs["Z"][1]])
        for cell, scheme in zip(table[3:], ("two-stage", PAPERS), strict=True):
            heat = percent("T_g", "float", scheme, 1e-4, 1e-5, 1e-6)
            self.compare(cell, [heat[0], *percent("T_g_error", "float", scheme, 1e-4), *heat[1:]], scheme)
        late = percent("p", "float", "two-stage", 1e-5) + percent("p", "float", PAPERS, 1e-5)
        self.says(self.page, "p is within {}% at 1e-5 after 20 τ_e", max(late))
        scatter = [percent("p_error", "float", scheme, 1e-5, model="CD_n")[0] for scheme in ("two-stage", PAPERS)]
        self.says(self.page, "collisions scatter (p ± {} to {}% at 1e-5)", *scatter)


class Stability(Shown):
    page = "docs/stability.md"

    def test_packing(self):
        rows = data("accuracy/stability_packing")
        dt = {}
        for scheme, *cells in table_of(self.page, "scheme | CD | CD_n | CD_rot | bound"):
            arrangement = "packs 8x8" if "8 x 8" in scheme else "index"
            for name in re.findall(r"`([\w-]+)`", scheme):
                for cell, model in zip(cells, ("CD", "CD_n", "CD_rot")):
                    row, = where(rows, scheme=name, model=model, arrangement=arrangement)
                    dt[name, model] = row["largest_dt_over_Q"]
                    if cell == "∞":
                        self.assertEqual(dt[name, model], "inf")
                    else:
                        self.compare(cell, [dt[name, model]], f"{scheme}, {model}")
        table = {row[0]: row[1:] for row in table_of(self.page, "| CD_rot | CD, CD_n")}
        factors = []
        for name, scheme, bound in (("two stages", "two-stage", 7), ("papers' scheme", PAPERS, 2)):
            self.compare(table[name][0].split("= ")[-1], [bound / 36])
            self.compare(table[name][1], [bound / 12])
            factors += [dt[scheme, "CD_rot"] * 36 / bound, *(dt[scheme, model] * 12 / bound for model in ("CD", "CD_n"))]
        self.says(self.page, "takes n = 6, a factor {} to {} from what the packing bears", min(factors), max(factors))
        self.says(self.page, "and the edge at {}", dt["two-stage", "CD_rot"])
        self.says(self.page, "`contact_network` warns from {} on", dt["two-stage", "CD_rot"])
        rates = re.findall(r"constexpr double \w+ = ([\d.]+);", text_of("src/config/contact_rates.cpp"))
        self.says(self.page, "has a rate of {}/Q for CD_rot, {}/Q for CD, {}/Q for CD_n", *map(float, rates))
        self.says(self.page, "the rate is {} k_t + {} max{0, k_n - k_t}", float(rates[0]), float(rates[2]))

    def test_thresholds_of_warnings(self):
        """Of src/run/warnings, and of scheme = "auto"."""
        def limit(file, name, folder="src/run/warnings"):
            return float(re.search(rf"\b{name} = ([\de.-]+)", text_of(f"{folder}/{file}"))[1])

        errors = limit("checks.hpp", "standard_errors")
        power, gap, creep = limit("rotation_balance.cpp", "most_power"), limit("energy_balance.cpp", "most_gap"), limit(
            "quasi_static_inertia.cpp", "most_gap_of_creep")
        drift = [limit("steady_state.cpp", name) for name in ("least_drift", "most_if_settled", "most_if_not", "least_without_error")]
        durations = {limit("contact_durations.cpp", name) for name in ("longest_share", "largest_gap")}
        for phrase, *values in (
                ("where B or η is {}% less than hard disks'", 100 * limit("hard_core_limit.cpp", "most_off")),
                ("above {}%: the deepest overlaps", 100 * limit("large_overlap.cpp", "most_overlap")),
                ("beyond {}%, {} standard errors and the change of kinetic and elastic energy: the step", 100 * gap, errors),
                ("beyond {}%, {} standard errors and the change of kinetic and elastic energy: long steps", 100 * creep, errors),
                ("beyond {}%, {} standard errors and the change of rotational energy", 100 * power, errors),
                ("beyond {}% and {} standard errors; [what", 100 * limit("dissipative_pressure.cpp", "small_share"), errors),
                ("beyond {}%. The defaults come to", 100 * limit("collision_loss.cpp", "most_off")),
                ("up to {}: inertia has a part", limit("ladder.hpp", "most_kinetic", "src/config")),
                ("above {} γ_0(G'² + G''²)^(1/2): D is fitted", limit("stress_drift.cpp", "most_drift")),
                ("a change above {}% that is {} standard errors, or {} where MSER-5 would cut off over a quarter; without a known error "
                 "above {}%", 100 * drift[0], *drift[1:3], 100 * drift[3]),
                ("a ratio above {}: replicas", limit("error_bar.cpp", "most_scatter")),
                ("above {}% of p_kin; with a drive above {}/N", 100 * limit("net_momentum.cpp", "most"), limit("net_momentum.cpp", "many")),
                ("from R_v above {} and", limit("box_size.cpp", "most_anisotropy")),
                ("above {} γ̇L_y", limit("box_size.cpp", "least_of_bands")),
                ("either length below {} d_s", limit("box_size.cpp", "least_length")),
                ("Where p_kin is above {}% of p", 100 * limit("box_size.cpp", "worth_a_word")),
                ("either above {}, or no contact ended", *durations)):
            self.says(self.page, phrase, *values)


class LongSteps(Shown):
    page = "docs/long_steps.md"

    def test_implicit_damping(self):
        rows = where(data("accuracy/implicit"), scheme=IMPLICIT)
        table = table_of(EVIDENCE, "state | dt | p_kin/p | p | σ | Z | T_g | larger dt")
        states = {row["state"] for row in rows}
        large = {state for state in states if "N=" in state}
        self.assertEqual({name_of(row[0]) for row in table}, states - large)
        self.assertEqual(len(large), 4)  # "and four states of 16384 disks"
        self.says(self.page, "([{} states](data/accuracy/tried.md#implicit-damping))", len(states - large))
        for state, dt, *cells, larger in table:
            row, = where(rows, state=name_of(state), time_step=float(dt))
            self.compare(" ".join(cells), [row["p_kin_share"], *with_errors(row)], state)
            if larger:
                row, = where(rows, state=name_of(state), time_step=float(larger.split(":")[0]))
                self.compare(larger.split(":")[1], with_errors(row, ["T_g"])[:1 + ("(" in larger)], state)
        rule = [row for row in rows if not re.match(r"CD_n |CD_rot 0.(76|8) |CD 0.82 Q=50", row["state"])
                for model, _, q, _ in [state_of(row["state"].split(" N=")[0])]
                if abs(row["time_step"] - {"CD": 1.6 * max(1, q) ** -0.3, "CD_rot": 1.8 * max(1, q) ** (-1 / 3), "CD_nt": 1.4}[model]) < 0.04]

        def worst_of(rows):
            return max(abs(row[key]) for row in rows for key in ("p", "sigma"))

        worst = worst_of(row for row in rule if row["p_kin_share"] < 3e-4)
        self.says(self.page, "At the rule's step p and σ are within {}% in Newtonian flows", worst)
        self.says(self.page, "({}% where p_kin/p is above 3e-4)", worst_of(rule))
        self.says("docs/scenes.md", "p and σ within {}% ([where", worst)
        low = {large: -min(row["Z"] for row in rule if (" 0.001 N=" in row["state"]) == large) for large in (False, True)}
        self.says(self.page, "Z is {}% low ({}% at 1e-3, N = 16384)", low[False], low[True])
        heat = [-row["T_g"] for row in rule if row["state"].startswith("CD_")]
        self.says(self.page, "T_g is up to {}% low where disks roll, and {}% in CD_rot at Q = 0.1", *sorted(heat)[-2:])

    def test_bias_where_inertia_has_a_part(self):
        """Beside what other schemes do there."""
        rows = data("accuracy/implicit_without_lift")
        cells = {row[0]: row[2] for row in table_of(EVIDENCE, "state, dt | θ = 1/2 | θ = 1")}
        at = {name: where(rows, state=name, time_step=0.8)[0] for name in ("CD_rot 0.8 Q=1 0.0001", "CD_n 0.84 Q=1 0.0001")}
        self.compare(cells["CD_rot 0.80, 1e-4, 0.8"], with_errors(at["CD_rot 0.8 Q=1 0.0001"], ["T_g"]))
        self.compare(cells["CD_n 0.84, 0.8"], with_errors(at["CD_n 0.84 Q=1 0.0001"], ["p"]))
        for name, dt in (("CD and CD_rot 0.82, Q = 1, 1e-4, 0.8", 0.8), ("the same, 1.2", 1.2), ("the same, 1.6", 1.6)):
            both = [where(rows, state=f"{model} 0.82 Q=1 0.0001", time_step=dt)[0] for model in ("CD", "CD_rot")]
            p, sigma, z, heat = (max(abs(row[key]) for row in both) for key in KEYS)
            self.compare(cells[name], [max(p, sigma), z, heat], name)

    def test_auto(self):
        rows = data("accuracy/auto")
        table = table_of(self.page, "state | takes | pairs")

        def name(cell):
            state, _, count = cell.partition(", N = ")
            return name_of(state) + f" N={count}" * bool(count)

        for state, takes, *cells in table:
            row, = where(rows, state=name(state))
            deviations = [row[name] for key in KEYS for name in (key, f"{key}_err") if row[name] != ""]
            self.compare(" ".join(cells), [row["pairs"], row["p_kin_share"], row["gain"], *deviations], state)
            named = row["methods"].replace("implicit-damping", "implicit").replace("two-stage-leapfrog", "two stages").replace(
                "backward-euler", "quasi-static")
            self.assertEqual(takes, named, state)
        others = [row for row in rows if row["state"] not in {name(row[0]) for row in table}]
        self.assertEqual({(row["pairs"], row["share"]) for row in others}, {(0, 0)})
        self.assertGreaterEqual(min(row["gain"] for row in others), 0.97)

    def test_quasi_static(self):
        rows = data("accuracy/quasi_static")
        for state, step, *cells in table_of(self.page, "state | step, strain | p"):
            model, rate = state.split()
            name = f"{model} 0.82 Q=1 {float(rate):g}"
            row, = where(rows, state=name, method="quasi-static", step_strain=float(step))
            other, = where(rows, state=name, method=IMPLICIT)
            self.compare(" ".join(cells), [*with_errors(row), row["newton_iterations"], row["seconds_per_strain"],
                                           other["seconds_per_strain"]], f"{state} {step}")

        def seconds(model, rate, method="quasi-static", **more):
            return where(rows, state=f"{model} 0.82 Q=1 {rate:g}", method=method, **more)[0]["seconds_per_strain"]

        pays = []
        for model in ("CD", "CD_rot"):  # where the curves of both cross
            ratios = np.log([seconds(model, rate) / seconds(model, rate, IMPLICIT) for rate in (1e-6, 1e-5)])
            pays.append(1e-6 * 10 ** (ratios[0] / (ratios[0] - ratios[1])))
        self.says(self.page, "against implicit damping below {} (CD) and {} (CD_rot)", *pays)
        z = [np.log10(where(rows, state=f"{model} 0.82 Q=1 1e-06", step_strain=1e-3)[0]["Z"]
                      / where(rows, state=f"{model} 0.82 Q=1 1e-06", step_strain=1e-4)[0]["Z"]) for model in ("CD", "CD_rot")]
        self.says(self.page, "but Z as h^{} (CD) and h^{} (CD_rot)", *z)


class Performance(Shown):
    page = "docs/performance.md"

    def median(self, row, column, engine="auto"):
        """Of the table of rows that scripts/bench writes."""
        cells, = (cells for cells in table_of(self.page, "row | engine | seconds") if cells[:2] == [row, engine])
        return float(cells[column].split()[0])

    def test_seconds_to_an_error(self):
        """An error falls with the root of the strain; that of a law is the root mean square of both schemes'."""
        for law, *cells in table_of(self.page, "law | strain | two stages | the default"):
            two, auto = (where(data("performance/seconds"), model=law, scheme=scheme)[0] for scheme in (DEFAULT, "auto"))
            longer = (two["sigma_error_percent"] ** 2 + auto["sigma_error_percent"] ** 2) / 2
            seconds = [row["seconds"] / row["starts"] * longer for row in (two, auto)]
            self.compare(" ".join(cells), [two["strain"] * longer, *seconds, seconds[0] / seconds[1]], law)

    def test_tables_of_scripts_bench(self):
        targets = {row[0]: float(row[2].split()[0]) for row in table_of(self.page, "target |  | measured")}
        self.says(self.page, "one at 1e-4. It costs {} times as much", targets["1e-6 over 1e-4"])
        dilute = [self.median(f"cd_n-q50-{rate}-1024", 3, "LAMMPS") for rate in ("1e-4", "1e-5")]
        self.says(self.page, "of LAMMPS in the dilute state; it does {} to {} here", *dilute)
        self.says(self.page, "(table: {})", targets["CD_rot 0.82: CPU time of a disk-step, N = 1048576 over 16384"])
        equal = {row[0]: (row[4].split()[0], row[5].split()[0]) for row in table_of(self.page, "row | LAMMPS, dt = 0.05")}
        self.says("README.md", "γ̇ = 1e-5) takes {} s of one core. LAMMPS with its longest step of equal bias takes {} times as long, "
                  "{} times at N = 65536", *map(float, (*equal["cd_n-q50-1e-5-1024"], equal["cd_n-q50-1e-5-65536"][1])))
        core = [1024 / (1e-4 * 0.2) / float(equal[f"{row}-1e-4-1024"][0]) / 1e6 for row in ("cd_rot82", "cd_n-q50")]
        self.says("docs/cuda.md", "(performance.md#measured-by-scriptsbench)) | {} | {}, more at lower rates", *map(rounded, core))
        card = [max(row["million_disk_steps_per_second"] for row in where(data("performance/device"), model=model, every=10))
                for model in ("CD_rot", "CD_n")]
        for page, phrase in (("docs/cuda.md", "the card is at best {} cores in dense flow, and {} in a dilute one at this rate"),
                             (self.page, "One H200 is at best {} cores in dense flow, and {} in a dilute one at 1e-4")):
            self.says(page, phrase, *np.divide(card, core))

    def test_large_systems(self):
        ratios = [float(re.match(NUMBER, row[-1])[0]) for row in table_of(self.page, "| 16384 | 10^6 | ratio")]
        self.says("docs/data/performance/open.md", "A disk-step costs {} to {} times that of 16384 disks", min(ratios), max(ratios))

    def test_events(self):
        rows = table_of(self.page, "φ, Q | γ̇ | hard disks")
        ratios = rows[1][4].split(", ")
        self.says("README.md", "costs {} times that of a compact code of hard disks at γ̇ = 1e-5. At 1e-7 it is {} times, at 1e-8 {} times",
                  *map(float, (ratios[0], *ratios[2:])))
        gains = [float(row[3].split()[0]) for row in table_of(self.page, "law, rate, N | two stages | implicit")]
        self.says("docs/scenes.md", "steps of 1.6 to 1.8 τ_e, {} to {} times less time", rounded(min(gains), 1), rounded(max(gains), 1))
        seconds = rows[1][3].split(", ")
        self.says(self.page, "A unit of strain at 1e-8 costs {} times one at 1e-5", float(seconds[3]) / float(seconds[0]))

    def test_run_time(self):
        rows = data("run_time")
        ratios = {row["scene"]: row["estimate_over_run"] for row in rows}
        table = table_of("docs/run_time.md", "scene | estimate over run")
        for scene, cell in table[1:-1]:
            name = next(name for name in ratios if name.startswith(scene.split(":")[0]) and name.endswith(scene.split(", ")[-1]))
            self.compare(cell, [ratios.pop(name)], scene)
        self.compare(" ".join(table[0]), [len(ratios), len(rows), min(ratios.values()), max(ratios.values())])
        slow, = where(rows, scene="CD_n 0.78, Q = 50, 1e-6")
        bounds = [float(bound) / slow["run_s"] for bound in slow["by_steps_alone_s"].split(" to ")]
        self.compare(table[-1][1], [rounded(bound, 2) for bound in bounds])
        self.says("docs/run_time.md", "The {} scenes have all four laws", len(rows))


class Cuda(Shown):
    page = "docs/cuda.md"

    def speeds(self, **wanted):
        """Million disk-steps/s of both laws, three digits."""
        rows = where(data("performance/device"), **{"scheme": DEFAULT, "every": 10, **wanted})
        return [[rounded(row["million_disk_steps_per_second"]) for row in where(rows, model=model)] for model in ("CD_rot", "CD_n")]

    def test_speed(self):
        def both(*wanted):
            return [[value for one in wanted for value in self.speeds(**one)[law]] for law in (0, 1)]

        expected = {"N = 65536, any order of disks": [[min(one), max(one)] for one in self.speeds(disks=65536)],
                    "the same without samples": self.speeds(disks=65536, every=1e6),
                    "N = 1048576, in order; shuffled": [one[:2] for one in self.speeds(disks=1048576)],
                    "the same without samples (1048576)": self.speeds(disks=1048576, every=1e6),
                    "1 system of 1024": self.speeds(disks=1024, replicas=1, engine="ensemble"),
                    "16": self.speeds(replicas=16), "132": self.speeds(replicas=132),
                    "528; 2112": both({"replicas": 528}, {"replicas": 2112}),
                    "528 without samples": self.speeds(replicas=528, every=1e6)}
        table = table_of(self.page, "| CD_rot, φ = 0.82, Q = 1 | CD_n, φ = 0.78, Q = 50 |")
        for (name, *cells), (wanted, values) in zip(table, expected.items()):
            self.assertEqual(name, wanted.split(" (")[0])
            self.compare(" ".join(cells), sum(values, []), name)
        implicit = self.speeds(disks=1048576, order="start", scheme=IMPLICIT)[0][0]
        self.says(self.page, "| implicit damping, N = 1048576, a step of 1.4 | {} |", implicit)

    def test_last_row_of_the_log(self):
        name, *cells = table_of("docs/data/performance/tried.md", "idea | N = 1024 | 65536 | 65536, shuffled")[-1]
        rotating = [self.speeds(disks=disks, engine="reference", **more)[0][0] for disks, more in (
            (1024, {}), (65536, {}), (65536, {"order": "shuffled"}), (1048576, {}), (1048576, {"order": "shuffled"}),
            (1048576, {"every": 1e6}))]
        self.compare(" ".join(cells), [rounded(rotating[0], 2), *rotating[1:]], name)

    def test_contacts(self):
        rows = data("performance/device_contacts")
        table = text_of(self.page).split("us a step without and with it")[1]
        for disks in (65536, 1048576):
            cells = re.search(rf"^\| N = {disks} \| (.*) \| (.*) \|$", table, re.M).groups()
            for cell, model in zip(cells, ("CD_rot", "CD_n")):
                self.compare(cell, [rounded(row["us_per_step"], 3 if row["us_per_step"] < 1000 else 4)
                                    for row in where(rows, disks=disks, model=model)], model)


class Pages(Shown):
    def test_figures(self):
        """The list of docs/figures.md is that of inputs/figures."""
        with open(SOURCE / "inputs/figures/figures.toml", "rb") as file:
            figures = tomllib.load(file)
        listed = [[name, one["title"].rsplit(", CD", 1)[0], f"{one['hours']:g}" + "+" * ("quick" in one)] for name, one in figures.items()]
        self.assertEqual(table_of("docs/figures.md", "figure | shows | hours"), listed)
        self.assertIn("`--quick` draws twelve figures", text_of("docs/figures.md"))
        self.assertEqual(sum("quick" in one for one in figures.values()), 12)
        for page, phrase in (("docs/reproduction.md", "P1 and P2 have {} figures with data"), ("docs/gallery.md", "some of the {}, drawn")):
            self.says(page, phrase, len(figures))

    def test_kinetic_share(self):
        """P1 Fig. 4 at 0.60, means over five seeds."""
        rows = where(data("figures/cd_n"), **{"disks.packing_fraction": 0.6, "shear.strain_rate": 1e-5})
        share = {}
        for q in {row["disks.elasticity"] for row in rows}:
            sums = {key: np.mean([row[key] for row in where(rows, **{"disks.elasticity": q})])
                    for key in ("B_p", "B_p_kin", "B_sigma", "B_sigma_kin")}
            share[q] = sums["B_p_kin"] / sums["B_p"], sums["B_sigma_kin"] / sums["B_sigma"]
        low, high = ([share[q][0] for q in share if least <= q <= most] for least, most in ((0, 2), (50, 500)))
        for value in high:
            self.says("docs/figures.md", "Our runs (1e-5) have {} from Q = 50 to 500 and {} at Q = 10", value, share[10][0])
        self.says("docs/figures.md", "For Q of 2 and below they have {} to {}", min(low), max(low))
        sigma = [one for _, one in share.values()]
        self.says("docs/figures.md", "The share of σ goes from {} to {}", max(sigma), min(sigma))

    def test_bands(self):
        """States of P2 Fig. 28 of P2's own size."""
        rows = where(data("figures/bands_profiles_large"), **{"disks.count": 65536})
        loose, = where(rows, **{"disks.packing_fraction": 0.7984})
        dense, = where(rows, **{"disks.packing_fraction": 0.802})
        self.says("docs/physics.md", "So μ = σ/p is {}, while σ/p_el, without it, is {}({})", loose["sigma"] / loose["p"],
                  loose["sigma/p_el"], 1e4 * loose["sigma/p_el_error"])
        narrow, = where(data("figures/bands_profiles"), **{"disks.packing_fraction": 0.792, "shear.strain_rate": 5e-5})
        self.says("docs/long_steps.md", "| bands: p | {}({})e-5 |", 1e5 * narrow["p"], 1e6 * narrow["p_error"])
        self.says("docs/long_steps.md", "| bands: μ | {}({}) |", narrow["mu"], 1e3 * narrow["mu_error"])
        self.says("docs/reproduction.md", "p includes the flow of the bands; p_el is {}({})e-5", 1e5 * dense["p_el"], 1e7 * dense["p_el_error"])

    def test_tangential_damping(self):
        """Tables of the page are those of its script."""
        subprocess.run([sys.executable, SOURCE / "scripts/tangential_page.py", "--check"], check=True)
        page, found = "docs/results/tangential_damping.md", table_of("docs/results/tangential_damping.md", "φ | B_0")
        ratio = {float(row[0]): float(row[3].split("(")[0]) for row in found}
        self.says(page, "the pressure is {} times that without", ratio[0.74] / 1e-3)
        middle = [value for phi, value in ratio.items() if 0.78 <= phi <= 0.82]
        self.says(page, "the same pressure: {} to {} from 0.78 to 0.82", min(middle), max(middle))
        run = where(data("results/tangential_methods"), **{"integration.scheme": DEFAULT, "disks.packing_fraction": 0.82, "disks.count": 1024.0})
        self.assertLess(max(abs(row["p_bias"]) + row["p_bias_error"] for row in run if row["p_bias"] != ""), 1e-3)
        self.assertEqual(len(run), 2)

        found = {}
        for row in data("results/tangential"):
            if row["p"] < 1e-3 and row["disks.damping_tangential"] > 0:
                ratio = row["shear.strain_rate"] / row["disks.damping_tangential"]
                by_k = found.setdefault((row["disks.packing_fraction"], float(f"{ratio:.2g}")), {})
                by_k.setdefault(row["disks.damping_tangential"], []).append(row["p"] / row["shear.strain_rate"] / row["disks.damping_tangential"])

        def spread(low, high, least=0):
            means = [[np.mean(each) for each in of.values()] for (phi, ratio), of in found.items() if low <= phi <= high and ratio >= least]
            return max(max(one) / min(one) for one in means if len(one) > 1)

        self.says(page, "within a factor of {}; at 0.74 and 0.78 of {}, where γ̇/k_t is {} or more", spread(0.80, 0.82), spread(0.74, 0.78, 0.01), 0.01)

    def test_oscillation(self):
        rows = data("results/oscillation")
        names = ("disks.model", "disks.packing_fraction", "shear.amplitude")
        at, small = ({tuple(row[name] for name in names): row for row in where(rows, **{"disks.count": count})} for count in (1024, 256))
        amplitudes = (1e-4, 1e-3, 0.01, 0.03, 0.1, 0.3)
        kinds = list(itertools.product(("CD", "CD_rot"), (0.84, 0.845, 0.85, 0.86)))
        expected = [[f"{model}, {phi}", *("; ".join(with_error(1e3 * at[model, phi, one][name], 1e3 * at[model, phi, one][name + "_error"])
                                                    for name in ("G_storage", "G_loss")) for one in amplitudes)] for model, phi in kinds]
        self.assertEqual(table_of("docs/results/oscillation.md", "model, φ"), expected)
        loose = list(itertools.product(("CD", "CD_rot"), (0.8, 0.82)))
        expected = [[f"{model}, {phi}", *("; ".join(f"{float(format(1e6 * at[model, phi, one][name], '.2g')):g}" for name in ("G_storage", "G_loss"))
                                          for one in amplitudes[2:])] for model, phi in loose]
        self.assertEqual(table_of("docs/results/oscillation.md", "model, φ below"), expected)
        for row in (at[model, phi, one] for model, phi in loose for one in amplitudes[:2]):
            self.assertLess(max(row["G_storage"], row["G_loss"]), 5e-8)
        self.says("docs/results/oscillation.md", "A packing's is {} m/τ_e²", at["CD", 0.85, 1e-3]["G_storage"])
        fluid = [at[model, phi, 0.3]["G_loss"] / at[model, phi, 0.3]["G_storage"] for model, phi in kinds]
        self.says("docs/results/oscillation.md", "G'' is {} to {} times G'", min(fluid), max(fluid))
        more = [at["CD", phi, one]["G_loss"] / at["CD_rot", phi, one]["G_loss"] for phi in (0.84, 0.845, 0.85, 0.86) for one in (0.03, 0.1, 0.3)]
        self.says("docs/results/oscillation.md", "CD dissipates {} to {} times as much", min(more), max(more))
        apart = {key: (at[key][name] - small[key][name]) / math.hypot(at[key][name + "_error"], small[key][name + "_error"])
                 for key in at if key in small for name in ("G_storage",)}
        beyond = {key for key, errors in apart.items() if abs(errors) > 2}
        self.says("docs/results/oscillation.md", "{} of {} values of G' of 256 disks", float(len(beyond)), float(len(apart)))
        less = [100 * (1 - at[key]["G_storage"] / small[key]["G_storage"]) for key in itertools.product(("CD", "CD_rot"), (0.84, 0.845), (0.03,))]
        self.says("docs/results/oscillation.md", "{}% to {}% larger", *(100 / (1 - one / 100) - 100 for one in (min(less), max(less))))

    def test_bubbles(self):
        rows = data("results/bubbles_inertia")
        drags = (2, 1, 0.5, 0.2, 0.1, 0.05, 0.02)
        at = {(row["disks.packing_fraction"], rounded(row["drive.drag"] * row["shear.strain_rate"]), row["drive.drag"]): row for row in rows}
        expected = [[f"{phi}, 1e-{power}", *(with_error(1e5 * at[place]["p"], 1e5 * at[place]["p_error"])
                                            if (place := (phi, float(f"1e-{power}"), drag)) in at else "" for drag in drags)]
                    for phi, power in itertools.product((0.75, 0.82), (4, 5))]
        self.assertEqual(table_of("docs/results/bubbles.md", "φ, γ̇ζ |"), expected)
        share = {place: row["p_kin"] / row["p"] for place, row in at.items()}
        by_power = [share[place] / (at[place]["mu"] * at[place]["shear.strain_rate"] / 2 / place[2]) - 1 for place in at if share[place] < 6e-4]
        self.says("docs/results/bubbles.md", "within {}% where it is below", 100 * max(map(abs, by_power)))
        alike = [(phi, rate, drag) for phi, rate, drag in at if share[phi, rate, drag] < 3e-4]
        apart = [abs(at[one]["p"] - at[other]["p"]) / np.hypot(at[one]["p_error"], at[other]["p_error"])
                 for one, other in itertools.combinations(alike, 2) if one[:2] == other[:2]]
        self.says("docs/results/bubbles.md", "larger drags to {} errors of the difference", max(apart))
        excess = {place: 100 * (at[place]["p"] / at[*place[:2], 1]["p"] - 1) for place in at if place[1] == 1e-4}
        told = [number for place in ((0.82, 1e-4, 0.1), (0.82, 1e-4, 0.05), (0.75, 1e-4, 0.05)) for number in (excess[place], share[place])]
        self.says("docs/results/bubbles.md", "at 0.82 p is {}% too large at {}, and {}% at {}; at 0.75 it is {}% too large at {}", *told)
        limit = re.search(r"most_kinetic_in_drag = ([\d.e-]+)", (SOURCE / "src/run/warnings/drag_inertia.cpp").read_text())[1]
        self.says("docs/results/bubbles.md", "Above {} the note", float(limit))
        factor = np.sqrt(0.3 / 2 / float(limit))
        self.says("docs/results/bubbles.md", "ζ = {} (mγ̇ζ)^(1/2): {} at γ̇ζ = {}, {} at {}", factor, factor * 1e-2, 1e-4, factor * 10**-2.5, 1e-5)

    def test_viscosity_of_bubbles(self):
        at = {(row["disks.packing_fraction"], row["shear.strain_rate"]): row for row in data("results/bubbles")}
        rates, jamming = (1e-3, 3e-4, 1e-4, 3e-5), 0.84347
        fractions = sorted({phi for phi, _ in at})

        def exponent(looser, phi):
            far, near = (at[one, 3e-5] for one in (looser, phi))
            decades = np.log((jamming - looser) / (jamming - phi))
            return np.log(near["p"] / far["p"]) / decades, np.hypot(*(row["p_error"] / row["p"] for row in (near, far))) / decades

        beta = {phi: exponent(looser, phi) for looser, phi in zip(fractions, fractions[1:]) if phi < 0.835}
        expected = [[f"{phi:.2f}", *(with_error(at[phi, rate]["p"] / rate, at[phi, rate]["p_error"] / rate) for rate in rates),
                     with_error(*beta[phi]) if phi in beta else ""] for phi in fractions]
        self.assertEqual(table_of("docs/results/bubbles.md", "φ | 1e-3"), expected)
        soft = [abs(at[phi, 1e-4]["p"] * 0.3 / at[phi, 3e-5]["p"] - 1) for phi in fractions if phi <= 0.80]
        self.says("docs/results/bubbles.md", "reached within {}% from 1e-4 on", np.ceil(100 * max(soft)))
        between = [beta[phi][0] for phi in (0.74, 0.78, 0.80)]
        self.assertTrue(2.2 < min(between) and max(between) < 2.95)
        self.says("docs/results/bubbles.md", "lie between {} and {}; they", min(between), max(between))

    def test_coexistence(self):
        page, rows = "docs/results/coexistence.md", data("results/coexistence")
        order = lambda row: (-row["value"], row["way"] == "up")
        of = lambda held, count: sorted((row for row in rows if (row["held"], row["disks.count"]) == (held, count)), key=order)
        shown = lambda row: [f"{1e5 * row['value']:.3g}", row["way"], f"{row['sigma'] / row['value']:.2f}", f"{1e5 * row['strain_rate']:.3g}", f"{1e5 * row['p']:.3g}",
                             f"{row['mu']:.3f}", f"{row['Z']:.2f}", f"{row['R_v']:.3g}"]
        at_stress = of("stress", 8192)
        self.assertEqual(table_of(page, "σ | way"), [shown(row) for row in at_stress])
        squares = of("stress", 65536) + of("stress", 16384)
        self.assertEqual(table_of(page, "N | σ | way"), [[f"{row['disks.count']:.0f}", *shown(row)] for row in squares])
        self.assertEqual(table_of(page, "p, 1e-5"), [
            [f"{1e5 * row['value']:.3g}", row["way"], f"{row['packing_fraction']:.4f}", f"{1e5 * row['sigma']:.3g}", f"{row['mu']:.3f}",
             f"{row['Z']:.2f}", f"{row['R_v']:.3g}"] for row in of("pressure", 8192)])
        self.assertEqual(table_of(page, "held | seed"), [
            [row["held"], f"{row['disks.seed']:.0f}", f"{row['strain']:.3g}", f"{row['strain_to_bands']:.2g}" if row["strain_to_bands"] else "none", f"{row['R_v']:.3g}"]
            for row in data("results/coexistence_waiting")])
        rate = {(row["value"], row["way"]): row["strain_rate"] for row in at_stress}
        over = lambda stress: rate[stress, "down"] / rate[stress, "up"]
        self.says(page, "it is {} times that of the way up at σ = 3e-6, and {} times at 4e-5", over(3e-6), over(4e-5))
        self.says(page, "meet at 7e-6 ({} and {})", rate[7e-6, "down"], rate[7e-6, "up"])
        self.says(page, "grows by a factor of {} (down) and {} (up)", *(rate[2e-5, way] / rate[5e-6, way] for way in ("down", "up")))
        self.says(page, "larger at 1e-5 than at 1.4e-5, by a factor of {}", rate[1e-5, "down"] / rate[1.4e-5, "down"])
        below = {(row["value"], row["disks.count"]): 100 * (1 - row["sigma"] / row["value"]) for row in at_stress + squares if row["way"] == "down"}
        self.says(page, "at 1.4e-5 the mean σ was {}% below", below[1.4e-5, 8192])
        self.says(page, "as the mean σ was {}% below it", below[7e-6, 65536])
        self.assertGreater(min(row["R_v"] for row in at_stress if (row["value"], row["way"]) != (4e-5, "down")), 15)
        phi = [row["packing_fraction"] for row in of("pressure", 8192) if row["way"] == "down"]
        self.says(page, "φ falls by {} while p falls by a factor of 20", phi[0] - phi[-1])
        at = {(row["value"], row["way"]): row for row in of("pressure", 8192)}
        up, down = at[5e-6, "up"], at[5e-6, "down"]
        self.says(page, "R_v is {} there, {} on the way down, and σ is {} times", up["R_v"], down["R_v"], up["sigma"] / down["sigma"])
        square = {(row["value"], row["way"], row["disks.count"]): row["strain_rate"] for row in squares}
        beside = [square[stress, "down", 16384] / rate[stress, "down"] for stress in (4e-5, 1.4e-5, 7e-6, 3e-6)]
        self.says(page, "16384 disks flow at {} to {} times the rate of the narrow box", min(beside), max(beside))
        self.says(page, "Down over up is {} at 3e-6 and {} at 4e-5",
                  *(square[stress, "down", 16384] / square[stress, "up", 16384] for stress in (3e-6, 4e-5)))
        large = {row["value"]: row for row in of("stress", 65536)}
        self.says(page, "With 65536 disks the rate is {} times", large[4e-5]["strain_rate"] / rate[4e-5, "down"])
        self.says(page, "none yet at 1.4e-5 (R_v {} after a strain of about 3), and flowed at {} times the rate",
                  large[1.4e-5]["R_v"], large[1.4e-5]["strain_rate"] / rate[1.4e-5, "down"])
        self.says(page, "the rate is {} times as large at half the stress", large[7e-6]["strain_rate"] / large[1.4e-5]["strain_rate"])

    def test_what_is_held(self):
        page, rows = "docs/results/held.md", data("results/held")
        flow = lambda row: tuple(row[name] for name in ("disks.model", "disks.packing_fraction", "disks.count"))
        flows, factors = [], {}
        for at_rate in (row for row in rows if row["held"] == "rate"):
            rate, phi = at_rate["shear.strain_rate"], at_rate["disks.packing_fraction"]
            for row in (row for row in rows if flow(row) == flow(at_rate) and row is not at_rate):
                by_stress = row["held"] == "stress"
                found = (f"{100 * (row['found'] / rate - 1):+.2f}({100 * row['found_error'] / rate:.2f})%" if by_stress
                         else f"{row['found'] - phi:+.5f}({row['found_error']:.5f})")
                factor = row["inertia"] if by_stress else row["response"] / 10
                factors.setdefault((flow(at_rate), factor), {})[row["held"]] = found
                given = "sigma" if by_stress else "p"
                off = abs(row["found"] / rate - 1) if by_stress else 0
                self.assertLess(off, 2 * np.hypot(row["found_error"] / rate, at_rate[given + "_error"] / at_rate[given]) if by_stress else 1)
            if at_rate["disks.count"] == 1024:
                here = factors[flow(at_rate), 1]
                flows.append([f"{at_rate['disks.model']} {phi:g}, Q = {at_rate['disks.elasticity']:g}, {rate:g}",
                              f"{100 * at_rate['sigma_error'] / at_rate['sigma']:.2f}%", here.get("stress", "-"),
                              f"{100 * at_rate['p_error'] / at_rate['p']:.2f}%", here.get("pressure", "-")])
        self.assertEqual(table_of(page, "flow | error of σ"), flows)
        self.assertEqual(table_of(page, "factor |"), [
            [f"{factor:g}", found.get("stress", "-"), found.get("pressure", "-")]
            for (of, factor), found in sorted(factors.items()) if of[2] == 256])
        self.assertEqual(table_of(page, "N | σ at given"), [[f"{value:g}" if value != "" else "-" for value in row.values()]
                                                           for row in data("results/held_fluctuations")])

    def test_crossover_a_decade_slower(self):
        found = {}
        for rate, table in (("1e-5", "figures/cd_n"), ("1e-6", "physics/cd_n_slow")):
            out = self.folder / rate
            self.bagnold("analyse", "crossover", SOURCE / f"docs/data/{table}.csv", "--by", "disks.packing_fraction",
                         "--where", f"shear.strain_rate={rate}", "--out", out)
            with open(f"{out}.csv", newline="") as file:
                found[rate] = [(float(row["Q_star"]), float(row["Q_star_error"])) for row in csv.DictReader(file)]
        rows = table_of("docs/physics.md", "φ | 0.60 | 0.66 | 0.70")
        self.assertEqual([row[0] for row in rows], list(found))
        for rate, *cells in rows:
            self.assertEqual(cells, [with_error(*one) for one in found[rate]], rate)
        far = sum((b - a)**2 / (e**2 + f**2) for (a, e), (b, f) in zip(*found.values(), strict=True))
        self.says("docs/physics.md", "They agree: χ² = {} of 11", far)

    def test_what_is_said_of_the_contact_number(self):
        lines = text_of("docs/physics.md").split("<!-- table contact_number")[1].split("\n")
        q, eta = ([float(cell.split()[0]) for cell in lines[row].split("|")[2:-1]] for row in (1, 5))
        eta = dict(zip(q, eta, strict=True))
        flat = [value for at, value in eta.items() if 3 <= at <= 60]
        self.says("docs/physics.md", "η_p is constant within {}% from Q = 3 to 60. At Q = 1 it is {}% less",
                  100 * max(abs(value / np.mean(flat) - 1) for value in flat), 100 * (1 - eta[1] / np.mean(flat)))

    def test_coverage(self):
        """Of the tables of docs/statistics.md, whose runs take hours: scripts/coverage and tests/statistics."""
        made = [float(row[3].rstrip("%")) for row in table_of("docs/statistics.md", "series | target | replicas | off by")]
        self.assertLess(max(made), float(re.search(r"In less than (\d+)% of runs means are off", text_of("docs/scenes.md"))[1]))
        flow = table_of("docs/statistics.md", "discarded | replicas | runs | off")
        self.says("README.md", "Of {} runs with a target error {}% were off by more than 2 errors", float(flow[0][2]),
                  float(flow[0][3].rstrip("%")))

    def test_attacks(self):
        trials = {row[0]: row[3] for row in table_of("docs/reliability.md", "attack | a trial")}
        self.says("README.md", "{} runs were stopped or killed (`kill -9`) 1 to 4 times each", float(re.match(r"\d+", trials["`kills`"])[0]))

    def test_the_tutorial(self):
        """What its sentences say of the run stands in the table of the run."""
        page = text_of("docs/tutorial.md")
        shown = re.findall(r"^```text\n(.*?)^```$", page, re.M | re.S)[0]
        told = re.findall(r"[\d.]+\(\d+\)", re.sub(r"^```.*?^```$", "", page, flags=re.M | re.S))
        self.assertTrue(told)
        for number in told:
            self.assertIn(f" {number} ", shown)
        value, error = re.match(r"([\d.]+)\((\d+)\)", told[0]).groups()
        self.says("docs/tutorial.md", "is {} ± {}. Two errors", float(value), float(error) / 10)


class Program(Shown):
    """What `bagnold` says in a second."""

    def validated(self, **keys):
        """The remarks and keys of a scene with table__key=value."""
        scene = self.scene(disks__count=64, shear__strain=0.125, integration__time_step=None, **keys)
        result = self.bagnold("validate", scene, "--allow-unstable")
        self.assertEqual(result.returncode, 0, result.stderr)
        return result.stdout

    def step(self, model, q, **keys):
        mass = "area" if model == "CD_n" else "equal"
        text = self.validated(disks__model=model, disks__elasticity=float(q), disks__mass=mass, **keys)
        return float(re.search(r"^time_step = (\S+)$", text, re.M)[1])

    def test_time_steps(self):
        for model, told, default, papers, evaluations in table_of("docs/accuracy.md", "law | Q | two-stage | the papers"):
            low, *high = re.findall(NUMBER, told)
            steps = [(self.step(model, q), self.step(model, q, integration__scheme=PAPERS)) for q in (low, *high)]
            self.compare(default, [steps[0][0]], f"{model} {told}")
            self.assertEqual(len({step for step, _ in steps}), 1)
            found = [step for _, step in steps]
            shown = sorted({float(one) for one in re.findall(NUMBER, papers)})
            self.assertEqual([shown[0], shown[-1]], [rounded(min(found)), rounded(max(found))], f"{model} {told}")
            rate = [rounded(2 / step) for step in found]
            self.compare(evaluations, [1 / steps[0][0], *sorted(set(rate))], f"{model} {told}")
        for page in ("docs/accuracy.md", "docs/scenes.md"):
            self.assertRegex(text_of(page), r"min{0.2, 0.5 Q}")
        for model, wanted in (("CD", 1.6), ("CD_rot", 1.8), ("CD_n", 0.2)):
            self.assertEqual(self.step(model, 1, integration__scheme=IMPLICIT), wanted)
        self.says("docs/long_steps.md", "The step is {} τ_e, {} where disks roll, times Q^{} and Q^{} above Q = 1; 1.4 for 1.8 in CD_nt with `damping_tangential` below `damping_normal`. For CD_n it is {}", 1.6, 1.8,
                  *(np.log10(self.step(model, 10, integration__scheme=IMPLICIT) / step) for model, step in (("CD", 1.6), ("CD_rot", 1.8))), 0.2)

    def test_starts(self):
        """Iterations of small ones. Other compilers and processors make other bits."""
        if not re.search(r"^compiler +g\+\+ 12\b(?s:.*)^SIMD +avx", self.bagnold("info").stdout, re.M):
            self.skipTest("numbers of another compiler or processor")
        for phi, few, _ in table_of("docs/run_time.md", "φ | iterations at N = 1024")[:2]:
            scene = self.scene(disks__count=1024, disks__packing_fraction=float(phi), integration__time_step=None,
                               output__sample_strain=0.01, shear__strain=0.02, shear__strain_rate=1e-2)
            self.run_scene(scene, self.folder / phi)
            with h5py.File(self.folder / phi / "result.h5") as file:
                self.compare(few, [file.attrs["start_iterations"]], phi)

    def test_stable_steps(self):
        """A sufficient bound, and what a packing bears, in units of Q."""
        table = {row[0]: row[1:] for row in table_of("docs/stability.md", "| CD_rot | CD, CD_n")}
        for name, scheme in (("two stages", DEFAULT), ("papers' scheme", PAPERS)):
            for model, cell in zip(("CD_rot", "CD", "CD_n"), (table[name][0].split("= ")[-1], table[name][1], table[name][1])):
                text = self.validated(disks__model=model, disks__elasticity=0.01, disks__mass="equal", integration__scheme=scheme)
                self.compare(cell, [rounded(100 * float(re.search(r"^# stable +up to (\S+)", text, re.M)[1]))], f"{name}, {model}")

    def test_defaults(self):
        """Of options of `analyse` and of keys, where pages name them."""
        helped = self.bagnold("analyse", "--help").stdout
        told = re.findall(r"`(--[a-z-]+)` \((\d+)\)", text_of("docs/analysis.md"))
        self.assertEqual(len(told), 3)
        for option, default in told:
            self.assertRegex(helped, rf"\n +{option} [^\n]*(?:\n {{20,}}[^\n]*)? \[{default}\]", option)
        ramp = self.validated(shear__protocol="ramp", shear__ramp_rate=1e-4, shear__strain_rate_high=1e-2, shear__discard=None,
                              output__sample_strain=None)
        for page, phrase, key in (("docs/scenes.md", "Ramps** change the rate every `ramp_every` = {} τ_e", "ramp_every"),
                                  ("docs/engines.md", "The outer list, of reach d_ij + {}, lives", "skin")):
            self.says(page, phrase, float(re.search(rf"^{key} = (\S+)$", ramp, re.M)[1]))

    def test_sweeps_have_as_many_points_as_the_pages_say(self):
        flow = next(block for block in re.findall(r"^```toml\n(.*?)^```$", text_of("docs/tutorial.md"), re.M | re.S) if "[sweep]" in block)
        (self.folder / "flow.toml").write_text(flow)
        for page, path, words, told in (("docs/tutorial.md", self.folder / "flow.toml", "ten points in two chains", "10 in 2 chains"),
                                        ("README.md", SOURCE / "inputs/sweep_elasticity.toml", "twenty scenes", "20 in 20 chains")):
            self.assertIn(words, text_of(page))
            self.assertRegex(self.bagnold("validate", path).stdout, f"# points +{told}")


if __name__ == "__main__":
    unittest.main()
