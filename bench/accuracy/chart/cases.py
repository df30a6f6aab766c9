# SPDX-License-Identifier: BSD-3-Clause
"""What scripts/accuracy looks at: states, schemes, time steps, and how long in each form."""
from dataclasses import dataclass

PAPERS, TWO_STAGE = "modified-velocity-verlet", "two-stage"
LEGEND = {  # in the order of pictures
    PAPERS: "papers' (2 evaluations)",
    "lagged-velocity-verlet": "lagged velocity",
    "groot-warren": "Groot-Warren 0.65",
    "pairwise-sweep": "pairwise sweep",
    "increment-sweep": "increment sweep",
    TWO_STAGE: "two-stage",
    "implicit-verlet": "implicit (costly)",
}
STEPS = (0.4, 0.3, 0.2, 0.1, 0.05, 0.02)


@dataclass(frozen=True)
class Case:
    """`state` is steady at the same phi and law, at rate 1e-4; Q and the rate may differ."""

    state: str
    model: str
    mass: str
    phi: float
    q: float
    shrink: float = 1  # time steps by this: what small Q needs

    @property
    def name(self):
        return f"{self.model} {self.phi:g} Q={self.q:g}"

    def options(self, rate):
        return ["--model", self.model, "--mass", self.mass, "--phi", self.phi, "--q", self.q,
                "--rate", rate]


CASES = [
    Case("cd_rot82-1e-4-1024", "CD_rot", "equal", 0.82, 1),
    Case("cd82-1e-4-1024", "CD", "equal", 0.82, 1),
    Case("cd_rot76-1e-4-1024", "CD_rot", "equal", 0.76, 1),
    Case("cd_n-q1-1e-4-1024", "CD_n", "area", 0.78, 0.1, 0.25),
    Case("cd_n-q1-1e-4-1024", "CD_n", "area", 0.78, 1),
    Case("cd_n-q50-1e-4-1024", "CD_n", "area", 0.78, 50),
    Case("cd_n-q50-1e-4-1024", "CD_n", "area", 0.78, 500),
]
PRECISION = [CASES[0], CASES[5]]


@dataclass(frozen=True)
class Form:
    """How much is done: --tiny for tests in seconds, --quick, or all of it."""

    rates: tuple
    starts: int
    stretch: float  # in tau_e
    discard: float  # strain at a new rate, in units that 1e-3 needs
    steps: tuple
    steady_strain: float
    steady_rates: tuple
    phases: int
    collision_steps: tuple
    map_points: int
    cases: int
    precision_rates: tuple
    rounds: int  # of seconds, by engine
    strain_factor: float  # of the strain that they are measured over


FORMS = {
    "tiny": Form((1e-3,), 2, 2, 0.01, (0.2, 0.1), 0.04, (1e-3,), 4, (0.2, 0.1), 5, 2, (1e-3,), 1, 0.005),
    "quick": Form((1e-3, 1e-4), 6, 20, 2, STEPS, 10, (1e-3,), 16,
                  (0.4, 0.3, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005), 41, 7, (1e-3, 1e-4, 1e-5, 1e-6), 1, 0.5),
    "full": Form((1e-3, 1e-4, 1e-5), 24, 40, 4, STEPS, 100, (1e-3, 1e-4), 64,
                 (0.4, 0.3, 0.2, 0.1, 0.05, 0.02, 0.01, 0.005), 61, 7, (1e-3, 1e-4, 1e-5, 1e-6), 5, 2),
}
