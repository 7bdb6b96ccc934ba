"""Forces of the swath header's drive, a stone in a lever and a rod to the knife, and its lever of Zhukovsky."""

from __future__ import annotations

import numpy as np

from .hand import RIGHT, Hand, digits
from .loads import DOWN, G, moment
from .machines import Machine
from .measured import Figure
from .plans import Factors, Knobs, Position

MASS = {"1": 8.0, "3": 25.0, "5": 38.0}
J3, F5 = 0.323, 190.0
AT = {"1": "s1", "3": "s3", "5": "d"}


def slotted_forces(
    m: Machine, mu: Factors, hand: Hand, k: int, drawn: Position, w: Knobs
) -> list[Figure]:
    """Find reactions and the balancing force in a position, by polygons and by the lever."""
    P, V = drawn.places.points, drawn.velocities.points
    assert drawn.accelerations is not None
    acc = drawn.accelerations.points
    mu_a = 1.0 if w.get("f.no mu") else mu.a
    along = 1.0 if w.get("f.along a") else -1.0
    sizes, vector = {}, {}
    for link, mass in MASS.items():
        sizes[f"G{link}"] = mass * (1 if w.get("f.mass") else G)
        vector[f"G{link}"] = DOWN * sizes[f"G{link}"] * w.get("f.G", 1.0)
        a = acc[AT[link]]
        sizes[f"Pi{link}"] = mass * drawn.read[f"π{AT[link]}"] * mu_a
        vector[f"Pi{link}"] = along * a / abs(a) * sizes[f"Pi{link}"]
    sizes["F5"], vector["F5"] = F5, -V["d"] / abs(V["d"]) * F5 * w.get("f.F3", 1.0)
    couple = -J3 * drawn.rates["epsilon3"]
    rows = [Figure("forces", k, name, None, digits(one, 4), "N") for name, one in sizes.items()]
    rows.append(Figure("forces", k, "Mi3", None, digits(couple, 4), "N·m"))

    def polygon(names: list[str], scale: float, head: complex = 0j) -> complex:
        for name in names:
            head = hand.lay(head, vector[name], abs(vector[name]) / scale)
        return head

    # knife and rod: the rod pulls along itself, the guide presses across
    head = polygon(["G5", "Pi5", "F5"], mu.F)
    corner = hand.meet(0, P["D"] - P["C"], head, 1j)
    r45, r65 = hand.measure(corner), hand.measure(corner - head)
    vector["R43"] = corner / abs(corner) * r45 * mu.F
    # lever and stone: moments about B give the stone's force
    total = couple * w.get("f.couple", 1.0)
    total += sum(moment(hand, P["B"], P["C"], vector[name], mu.l) for name in ("R43", "G3", "Pi3"))
    lever = P["A"] - P["B"]
    vector["R23"] = -lever / abs(lever) * RIGHT * total / (drawn.read["BA"] * mu.l)
    end = polygon(["R43", "G3", "Pi3"], mu.F)
    r23, r63 = abs(vector["R23"]) / mu.F, hand.measure(polygon(["R23"], mu.F, end))
    # crank
    vector["R21"] = -vector["R23"]
    turned = sum(
        moment(hand, 0, P[at], vector[name], mu.l) for name, at in (("R21", "A"), ("G1", "S1"))
    )
    balance = -turned / m.OA * w.get("f.bal", 1.0)
    vector["P"] = P["A"] / abs(P["A"]) * RIGHT * balance
    r61 = hand.measure(polygon(["R21", "G1", "Pi1", "P"], mu.F))
    for name, mm, scale in (
        ("R34", r45, mu.F), ("R65", r65, mu.F), ("R45", r45, mu.F), ("R12", r23, mu.F), ("R63", r63, mu.F),
        ("R23", r23, mu.F), ("R61", r61, mu.F),
    ):  # fmt: skip
        rows.append(Figure("forces", k, name, round(mm, 1), digits(mm * scale, 4), "N"))
    rows.append(Figure("forces", k, "P_bal_forces", None, digits(balance, 4), "N"))
    lever_force = _lever(
        hand, V, vector, couple * drawn.rates["omega3"] * w.get("l.couple", 1.0) / mu.v, w
    )
    rows.append(Figure("forces", k, "P_bal_lever", None, digits(lever_force, 4), "N"))
    return rows


def _lever(
    hand: Hand, V: dict[str, complex], vector: dict[str, complex], couple: float, w: Knobs
) -> float:
    """Return the balancing force by moments about the pole of the plan turned by 90°."""
    turn = 1 if w.get("l.unturned") else RIGHT
    total = -couple
    for link, end in AT.items():
        for name in (f"G{link}", f"Pi{link}", *(["F5"] if link == "5" else [])):
            left = w.get("l.F3", 1.0) if name == "F5" else 1.0
            total += moment(hand, 0, V[end] * turn, vector[name] * left, 1.0)
    return float(np.real(total / hand.measure(V["a"])))
