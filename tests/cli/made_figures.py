# SPDX-License-Identifier: BSD-3-Clause
"""Tables as docs/data/figures has them for every data set of the figures, of the states that its sweep
file names, made by laws of known content: nothing is run."""

import csv
import itertools
import json
import tomllib

import numpy as np

from sweep_table import crossover, q_star

PHI_J = 0.8433
LOW, HIGH = 0.7891, 0.8053  # the coexistence region of the bands, at any rate
FAST, SLOW = (0.788, 6.2e-5), (0.809, 4e-6)  # phi and gammadot in the middle of the bands
ERRORS = {"mu": 0.001}  # relative; 0.01 where none is named
FIT_SHARPNESS, FIT_POWER = 3.0, 1.3


def p1_q_star(phi):
    return q_star(phi, 1.89, 0.05, 0.84335, 1.65)


def cd_q_c(phi):
    """Of the drop of CD."""
    return q_star(phi, 1.2, 1.1, PHI_J, 1.1)


def rot_q_c(phi):
    """Where Z/gammadot of CD_rot leaves its value at large Q."""
    return {0.80: 20.0, 0.81: 28.0, 0.82: 50.0, 0.83: 95.0}.get(round(phi, 4), 5 + 40 * (phi - 0.65))


def rot_phi_c(elasticity):
    """Of the step of CD_rot, and of the peak of the rotation's variance."""
    return 0.797 + 0.0002 * elasticity


def stresses(out, rate, elasticity, **parts):
    """p_el, sigma_el, ... with their sums, Bagnold coefficients and viscosities."""
    for stress in ("p", "sigma", "delta_p"):
        out[stress] = 0.0
        for part in ("el", "dis", "kin"):
            value = parts.get(f"{stress}_{part}", 0.0)
            out[f"{stress}_{part}"] = value
            out[stress] += value
    for name in [key for key in out if key.startswith(("p", "sigma"))]:
        out[f"B_{name}"] = out[name] / rate**2
        out[f"eta_{name}"] = elasticity * out[name] / rate
    out["mu"] = out["sigma"] / out["p"]
    out["I"] = rate / np.sqrt(out["p"])
    out["sigma_dev"] = np.hypot(out["sigma"], out["delta_p"])


def contacts(out, rate, z):
    out["Z"] = z
    out["tau_dur"] = 4.0 + z
    out["nu_coll"] = z / 2 / out["tau_dur"]


def cd_n(phi, q, rate):
    out = {}
    b = crossover(q, p1_q_star(phi), c=0.02 * (0.84335 - phi) ** -3, s=FIT_SHARPNESS, power=FIT_POWER)
    drift = (rate / 1e-5) ** 0.05  # tells the curves of other rates from that of 1e-5
    stresses(out, rate, q, p_el=drift * b * rate**2, p_kin=drift**2 * 0.2 * (1 - phi) * b * rate**2,
             sigma_el=drift * 0.4 * b**0.9 * rate**2, sigma_kin=drift**2 * (0.82 - phi) * rate**2 * b**0.9,
             p_dis=drift * 1e-3 * phi * rate**2, sigma_dis=0.02 * phi * rate**3,
             delta_p_el=0.02 * b * rate**2, delta_p_kin=0.01 * b * rate**2)
    contacts(out, rate, rate * (200 * (1 + phi) + q + 100 / q * (1e-3 / rate) ** 0.2))
    return out


def cd(phi, q, rate):
    out = {}
    newton = q < cd_q_c(phi)
    p = (0.01 * (PHI_J - phi + 0.01) ** -2 * rate / q if newton
         else 0.3 * q * (PHI_J - phi + 0.01) ** -1.5 * rate**2)
    stresses(out, rate, q, p_el=p, sigma_el=0.3 * p)
    contacts(out, rate, 3.0 + phi if newton else 100 * rate * (1 + phi))
    out["v_T_rms"] = 2 * rate if newton else 0.2 * q * rate
    out["v_N_rms"] = 0.03 * out["v_T_rms"] if newton else 0.9 * out["v_T_rms"]
    return out


def cd_rot(phi, q, rate):
    out = {}
    excess = max(0.0, phi - rot_phi_c(q))
    b = 30 * (1 + phi) * (1 + q) + 5e6 * excess * (1e-5 / rate) + (100 if excess else 0) * phi
    stresses(out, rate, q, p_el=b * rate**2, sigma_el=0.3 * b * rate**2)
    z = rate * (200 + 6000 * max(0.0, np.log(rot_q_c(phi) / q)) * (1e-5 / rate) ** 0.5)
    contacts(out, rate, z)
    out["spin_mean"] = -0.5 - 0.001 * q / 50
    out["spin_var"] = 4 - 500 * (phi - rot_phi_c(q)) ** 2
    out["R_v"] = 1.1
    return out


def bands(phi, q, rate):
    out = {}
    p = 9e3 * rate**2 * np.exp(20 * (phi - 0.77) + 120 * np.clip(phi - LOW, 0, HIGH - LOW))
    mu = 0.4 - 2.7 * (phi - 0.77) + 5.7 * np.clip(phi - LOW, 0, HIGH - LOW) - 0.002 * np.log(rate)
    stresses(out, rate, q, p_el=p, sigma_el=0.85 * mu * p, sigma_dis=0.15 * mu * p)
    out["R_v"] = 20.0 if LOW < phi < HIGH else 1.1
    for name, (local_phi, local_rate) in (("fast", FAST), ("slow", SLOW)):
        out |= {f"band_phi_{name}": local_phi, f"band_gammadot_{name}": local_rate}
    return out


def crossing(_, q, rate):
    """Two kinks in ln sigma against ln gammadot."""
    out = {}
    x = np.log(rate)
    sigma = np.exp(2 * x - 1.5 * max(0, x - np.log(1.1e-5)) + 0.6 * max(0, x - np.log(6e-5)))
    stresses(out, rate, q, p_el=3 * sigma, sigma_el=sigma)
    return out


def law_of(data):
    for start, law in (("bands_crossing", crossing), ("bands", bands), ("ramps", bands), ("cd_n", cd_n),
                       ("cd_rot", cd_rot), ("cd", cd)):
        if data.startswith(start):
            return law
    raise ValueError(data)


def states_of(path):
    """(phi, Q, seed, rate, kappa, N, L_y / L_x) of the points of a sweep file."""
    scene = tomllib.loads(path.read_text())
    sweep = scene["sweep"]
    grid, rows = sweep.get("grid", {}), sweep.get("zip", {})
    lines = [dict(zip(rows, values)) for values in zip(*rows.values())] or [{}]
    for line, values in itertools.product(lines, itertools.product(*grid.values())):
        own = line | dict(zip(grid, values))
        get = lambda key: own.get(key, scene.get(key.split(".")[0], {}).get(key.split(".")[1]))
        rates = get("shear.strain_rates") or [get("shear.strain_rate")]
        for rate in rates:
            yield (get("disks.packing_fraction"), get("disks.elasticity"), get("disks.seed") or 1, rate,
                   get("shear.ramp_rate"), get("disks.count"), get("disks.box_aspect") or 1.0)


def angles(q):
    """Made histogram: 100 bins; its value at 90 degrees tells Q."""
    middle = np.linspace(-178.2, 178.2, 100)
    return list(1 + np.cos(np.radians(middle)) / 2 + 1 / q)


def rest_of(data, phi, q, rate):
    """What panels show other than averages."""
    y = np.linspace(0, 100, 80)
    if data.startswith("bands"):
        of_slow = (1 + np.cos(2 * np.pi * y / 100)) / 2
        (fast_phi, fast_rate), (slow_phi, slow_rate) = FAST, SLOW
        profile = {"phi": fast_phi + (slow_phi - fast_phi) * of_slow,
                   "gammadot": fast_rate + (slow_rate - fast_rate) * of_slow, "v_x": rate * y - 50 * rate}
        fields = {"x": [10.0, 60.0], "y": [20.0, 70.0], "diameter": [1.0, 1.4], "phi": [0.79, 0.81],
                  "gammadot": [6e-5, 4e-6]}
        return {"samples/fields": fields, "samples/fields_frame": {"box_length": [100.0]}} | {
            f"profiles/{name}_aligned": {"y": list(y), "value": list(value),
                                   "error": list(0 * value + 1e-7)}
            for name, value in profile.items()}
    if data.startswith("cd_rot_velocities"):
        spread = np.linspace(-1, 1, 200)
        other = np.roll(spread, 77)
        return {"samples/contact_velocities": {
            "V_R": list(spread), "V_T": list(-spread + 0.01 * other), "V_C_T": list(0.01 * other),
            "V_N": list(np.roll(0.02 * other, 31))}}
    if data.startswith("ramps"):
        up = np.geomspace(3e-6, 1e-3, 40)
        rates = np.concatenate([up, up[::-1]])
        return {"series/strain_rate": list(rates), "series/sigma": list(100 * rates**2),
                "series/direction": [1.0] * 40 + [-1.0] * 40}
    return {"histograms/theta": {"range": [-180.0, 180.0], "density": angles(q)}}


def write_tables(figures, target):
    """NAME.csv and NAME.json of every sweep file beside figures.toml; what was made: {NAME: [state]},
    a state being keys and values."""
    made = {}
    for path in sorted(figures.parent.glob("*.toml")):
        if path == figures:
            continue
        rows, stored = [], []
        for phi, q, seed, rate, ramp, count, aspect in states_of(path):
            keys = {"disks.packing_fraction": phi, "disks.elasticity": q, "disks.seed": seed,
                    "shear.strain_rate": rate, "disks.count": count}
            keys |= {"shear.ramp_rate": ramp} if ramp else {}
            keys |= {"disks.box_aspect": aspect} if aspect != 1 else {}
            values = law_of(path.stem)(phi, q, rate)
            rows.append(keys | values)
            stored.append({"scene": keys} | rest_of(path.stem, phi, q, rate))
        made[path.stem] = rows
        names = [name for name in rows[0] if "." not in name]
        with open(target / f"{path.stem}.csv", "w", newline="", encoding="utf-8") as file:
            table = csv.writer(file)
            table.writerow(list(keys) + [n + e for n in names for e in ("", "_error")])
            for row in rows:
                table.writerow([row[k] for k in keys] +
                               [v for n in names for v in (repr(float(row[n])), abs(row[n]) * ERRORS.get(n, 0.01))])
        (target / f"{path.stem}.json").write_text(json.dumps({"points": stored}))
    return made
