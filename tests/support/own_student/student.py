"""A student who draws by his own scale factors, in his own places, and writes as he is used to.

Nothing here is taken from the package: plane geometry, numpy and a task sheet. ``student(machine, seed)`` is
one drawing, the same for the same seed; with a ``mistake`` it is wrong in one thing, and knows in which.
"""

from __future__ import annotations

from typing import NamedTuple

import numpy as np

from .hand import Exact, Hand, Ruler
from .loads import diagrams, forces
from .machines import Machine
from .measured import Figure, measured
from .mistakes import Kind, Truth, amiss
from .plans import Factors, draw
from .slotted_loads import slotted_forces
from .table import Manner, manner_of, text, written

PLAIN = 12.0
"""How far a mistake that a teacher could see moves all readings together (root of the sum of squares, mm)."""
PART = 0.01
"""Which part of a quantity counts as much as 1 mm."""
ROUND = (1, 1.2, 1.25, 1.5, 1.6, 2, 2.5, 3, 4, 5, 6, 8)


class Drawing(NamedTuple):
    """A drawing handed in: its table, the scale factors it was drawn by, and what is wrong with it."""

    machine: Machine
    seed: int
    mu: Factors
    manner: Manner
    ruler: Ruler
    csv: str
    truth: Truth | None

    @property
    def ratios(self) -> dict[str, float]:
        """The student's μ by the scene's, of each plan."""
        m = self.machine
        return {
            "positions": self.mu.l / m.mu_l,
            "velocities": self.mu.v / m.mu_v,
            "accelerations": self.mu.a / m.mu_a,
        }


def own(
    rng: np.random.Generator, due: float, least: float, most: float, first: float = 0.0
) -> float:
    """Return a scale factor: that of the task, a round one, or one that makes ``first`` round in mm."""
    pick = rng.random()
    if pick < 0.2:
        return due
    if pick < 0.8 or not first:
        choice = [
            r * 10.0**n for n in range(-5, 3) for r in ROUND if least <= r * 10.0**n / due <= most
        ]
        return float(rng.choice(choice))
    longs = [mm for mm in range(20, 250, 5) if least <= first / mm / due <= most]
    return first / float(rng.choice(longs))


def factors(rng: np.random.Generator, m: Machine) -> Factors:
    """Return scale factors of one's own: 0.5 to 2 times those of the task."""
    v, a = m.omega * m.OA, m.omega**2 * m.OA
    S = own(rng, 0.004, 0.5, 2)
    H = float(rng.choice([20, 25, 30, 40, 50]))
    V = S / (H * 0.0025)
    A = V / (float(rng.choice([15, 20, 25, 30])) * 0.0025)
    return Factors(
        own(rng, m.mu_l, 0.66, 1.5), own(rng, m.mu_v, 0.5, 2, v), own(rng, m.mu_a, 0.5, 2, a),
        own(rng, m.mu_F, 0.5, 2), S, V, A,
    )  # fmt: skip


def ruler_of(rng: np.random.Generator) -> Ruler:
    """Return a ruler of 0.1, 0.5 or 1 mm, with tenths written or not."""
    division = float(rng.choice([0.1, 0.5, 0.5, 1.0]))
    return Ruler(division, bool(rng.random() < 0.4))


def student(
    machine: Machine,
    seed: int,
    mistake: Kind | None = None,
    *,
    way: str | None = None,
    mu: Factors | None = None,
    mu_rows: bool = True,
) -> Drawing:
    """Return a drawing of a machine by chance; ``mu``: its scale factors, the student's own by default."""
    rng = np.random.default_rng([seed, sum(map(ord, machine.name))])
    chosen, manner = factors(rng, machine), manner_of(rng, way)
    mu = mu or (due_factors(machine) if mistake and mistake.scene_mu else chosen)
    ruler, whole = ruler_of(rng), bool(rng.random() < 0.7)
    manner = manner._replace(
        mu_rows=manner.mu_rows and mu_rows,
        signed=manner.signed or bool(mistake and mistake.family == "sign"),
    )
    hand = Hand(rng, ruler, eye={0.1: 0.5, 0.5: 0.6, 1.0: 0.75}[ruler.division])
    if mistake is None:
        figures = drawn(machine, mu, hand)
        if not whole:
            figures = some(
                figures, {*machine.at, *rng.choice(machine.count, 3, replace=False).tolist()}
            )
        rows = written(figures, manner, hand)
        return Drawing(machine, seed, mu, manner, ruler, text(rows, manner, mu), None)
    for _ in range(20):
        place = _place(machine, mistake, rng)
        figures = drawn(machine, mu, hand, mistake, place)
        if _shows(machine, mu, mistake, place, manner):
            break
    else:
        raise ValueError(f"{mistake.name} does not show on {machine.name}")
    truth = mistake.truth(place)
    if mistake.table:
        figures, truth = amiss(mistake, figures, rng, place)
    if not whole and mistake.plan in ("velocities", "accelerations") and truth.position is not None:
        figures = some(
            figures,
            {*machine.at, truth.position, *rng.choice(machine.count, 3, replace=False).tolist()},
        )
    rows = written(figures, manner, hand)
    return Drawing(machine, seed, mu, manner, ruler, text(rows, manner, mu), truth)


def due_factors(machine: Machine) -> Factors:
    """Return the scale factors of the task."""
    return Factors(machine.mu_l, machine.mu_v, machine.mu_a, machine.mu_F)


def some(figures: list[Figure], kept: set[int]) -> list[Figure]:
    """Return the figures of a few positions' plans alone."""
    return [
        one for one in figures if one.position in kept and one.plan not in ("forces", "diagrams")
    ]


def _place(machine: Machine, mistake: Kind, rng: np.random.Generator) -> int | None:
    """Return in which position a mistake is made, by chance; None: in all."""
    if not mistake.single:
        return None
    late = mistake.plan == "accelerations"
    allowed = [
        k for k in mistake.only or range(not late, machine.count) if not late or k in machine.at
    ]
    return int(rng.choice(allowed))


def drawn(
    machine: Machine, mu: Factors, hand: Hand, mistake: Kind | None = None, place: int | None = None
) -> list[Figure]:
    """Draw all plans, and return all that is read of them."""
    knobs = mistake.knobs if mistake else {}
    made = {k: knobs if place in (None, k) else {} for k in range(machine.count)}
    misread = {
        name[2:]: getattr(machine, name[2:]) * by
        for name, by in knobs.items()
        if name.startswith("m.")
    }
    machine = machine._replace(**misread)
    plans = [draw(machine, mu, hand, k, made[k]) for k in range(machine.count)]
    figures: list[Figure] = []
    for k, one in enumerate(plans):
        figures += measured(machine, mu, hand, k, one, plans[0])
    for k in machine.loads:
        found = forces if machine.kind == "slider" else slotted_forces
        figures += found(machine, mu, hand, k, plans[k], made[k])
    if machine.loads and machine.kind == "slider":
        figures += diagrams(machine, mu, hand, plans, knobs)
    return [
        one
        for one in figures
        if all(np.isfinite(x) for x in (one.mm, one.value, one.spot) if x is not None)
    ]


def _shows(machine: Machine, mu: Factors, mistake: Kind, place: int | None, manner: Manner) -> bool:
    """Whether a hand that is never off would write figures that differ plainly from the right ones."""
    if not mistake.knobs:
        return True
    right, wrong = (
        written(drawn(machine, mu, Exact(), one, place), manner, Exact()) for one in (None, mistake)
    )
    before = {(one.plan, one.position, one.segment, one.spot is None): one for one in right}
    total = 0.0
    for now in wrong:
        was = before.get((now.plan, now.position, now.segment, now.spot is None))
        if was is None:
            continue
        if now.spot is not None and was.spot is not None:
            total += abs(now.spot - was.spot) ** 2
        elif now.mm is not None and was.mm is not None:
            total += (now.mm - was.mm) ** 2
        else:
            least = PART * max(abs(was.value or 0), 1.0)
            total += min(abs((now.value or 0) - (was.value or 0)) / least, 20.0) ** 2
    return total > PLAIN**2
