"""Forces of the slider-crank, its lever, and the slider's diagrams by chords, as a student draws them."""

from __future__ import annotations

import numpy as np

from .hand import RIGHT, Hand, digits
from .machines import Machine
from .measured import Figure
from .plans import Factors, Knobs, Position

M2, M3, J2, F3, G = 3.0, 5.0, 0.04, 400.0, 9.81
DOWN = -1j


def moment(hand: Hand, about: complex, at: complex, force: complex, scale: float) -> float:
    """Return force times arm, N·m, positive counterclockwise; the arm is measured on paper."""
    if abs(force) < 1e-6:
        return 0.0
    arm = ((at - about).conjugate() * force).imag / abs(force)
    return float(np.sign(arm) * hand.measure(arm) * scale * abs(force))


def forces(m: Machine, mu: Factors, hand: Hand, k: int, drawn: Position, w: Knobs) -> list[Figure]:
    """Find reactions and the balancing force in a position, by a polygon and by the lever."""
    P, V = drawn.places.points, drawn.velocities.points
    assert drawn.accelerations is not None
    acc = drawn.accelerations.points
    along = -1.0 if w.get("f.along a") else 1.0
    mu_a = 1.0 if w.get("f.no mu") else mu.a
    mm2, mm3 = drawn.read["πs2"], drawn.read["πb"]
    size = {
        "G2": M2 * (1 if w.get("f.mass") else G), "G3": M3 * (1 if w.get("f.mass") else G),
        "Pi2": M2 * mm2 * mu_a * w.get("f.Pi2", 1.0), "Pi3": M3 * mm3 * mu_a * w.get("f.Pi3", 1.0), "F3": F3,
    }  # fmt: skip
    couple = -J2 * drawn.rates["epsilon2"] * w.get("f.Mi2", 1.0)
    rows = [Figure("forces", k, name, None, digits(one, 4), "N") for name, one in size.items()]
    rows.append(Figure("forces", k, "Mi2", None, digits(couple, 4), "N·m"))

    speed = V["b"] if abs(V["b"]) > 1 else 1
    vector = {
        "G2": DOWN * size["G2"] * w.get("f.G2", 1.0), "G3": DOWN * size["G3"] * w.get("f.G3", 1.0),
        "Pi2": -acc["s2"] / abs(acc["s2"]) * size["Pi2"] * along,
        "Pi3": -acc["b"] / abs(acc["b"]) * size["Pi3"] * along,
        "F3": -speed / abs(speed) * F3 * w.get("f.F3", 1.0),
    }  # fmt: skip
    moved = couple * w.get("f.couple", 1.0)
    link = P["B"] - P["A"]
    about = P["A"] if w.get("f.about A") else P["B"]
    arm_scale = 0.001 if w.get("f.arm no mu") else mu.l
    sum_b = moved + sum(
        moment(hand, about, P["S2"], vector[name], arm_scale) for name in ("G2", "Pi2")
    )
    across = -link / abs(link) * RIGHT
    turned = -sum_b / m.AB * w.get("f.Rt", 1.0)
    # the polygon: tangential part, then what is known, closed by the axial part and the guide's
    head = hand.lay(0, across * np.sign(turned), abs(turned) / mu.F)
    start = 0j
    for name in ("G2", "Pi2", "G3", "Pi3", "F3"):
        head = hand.lay(head, vector[name], abs(vector[name]) / mu.F)
        if name == "Pi2":
            middle = head
    corner = hand.meet(start, link, head, 1j)
    r12_vector = across * turned / mu.F - (
        corner - start
    )  # axial part's start to tangential part's end
    r12, r03 = hand.measure(r12_vector), hand.measure(corner - head)
    r23 = hand.measure(middle - corner)
    h = ((P["A"]).conjugate() * r12_vector).imag / abs(r12_vector)
    balance = float(np.sign(h) * hand.measure(h) * mu.l * r12 * mu.F / m.OA * w.get("f.bal", 1.0))
    at_crank = balance / mu.F * P["A"] * RIGHT / abs(P["A"])
    r01 = hand.measure(hand.lay(0, at_crank, abs(at_crank)) - r12_vector)
    lever = _lever(m, mu, hand, P, V, vector, couple, w)
    for name, mm in (("R12", r12), ("R03", r03), ("R23", r23), ("R01", r01)):
        rows.append(Figure("forces", k, name, mm, digits(mm * mu.F, 4), "N"))
    rows.append(Figure("forces", k, "P_bal_forces", None, digits(balance, 4), "N"))
    rows.append(Figure("forces", k, "P_bal_lever", None, digits(lever, 4), "N"))
    return rows


def _lever(
    m: Machine, mu: Factors, hand: Hand, P: dict[str, complex], V: dict[str, complex],
    vector: dict[str, complex], couple: float, w: Knobs,
) -> float:  # fmt: skip
    """Return the balancing force by Zhukovsky's lever: moments about the pole of the plan turned by 90°."""
    turn = 1 if w.get("l.unturned") else RIGHT
    end = {"G2": "s2", "Pi2": "s2", "G3": "b", "Pi3": "b", "F3": "b"}
    total = sum(
        moment(hand, 0, V[end[name]] * turn, force * w.get(f"l.{name}", 1.0), 1.0)
        for name, force in vector.items()
    )
    link, image = P["B"] - P["A"], V["b"] - V["a"]
    sense = np.sign((image * (link * RIGHT).conjugate()).real)
    total -= couple * hand.measure(image) / m.AB * sense * w.get("l.couple", 1.0)
    return float(total / hand.measure(V["a"]))


def _curve(middles: np.ndarray) -> np.ndarray:
    """Return a smooth closed curve through points in the middle of intervals, read at their ends."""
    n = len(middles)
    A = 4 * np.eye(n) + np.roll(np.eye(n), 1, 0) + np.roll(np.eye(n), -1, 0)
    bend = np.linalg.solve(A, 6 * (np.roll(middles, 1) - 2 * middles + np.roll(middles, -1)))
    after = (middles + np.roll(middles, -1)) / 2 - (bend + np.roll(bend, -1)) / 16
    return np.roll(after, 1)


def diagrams(
    m: Machine, mu: Factors, hand: Hand, all_drawn: list[Position], w: Knobs
) -> list[Figure]:
    """Draw S by the plan of positions, V and a by chords, each read at every position."""
    first = all_drawn[int(w.get("d.zero", 0))].places.points["B"].real
    S = np.array(
        [(one.places.points["B"].real - first) * mu.l / mu.S for one in all_drawn]
    ) * w.get("d.S", 1.0)
    S = S + hand.rng.normal(0, hand.prick, m.count)
    T = 2 * np.pi / m.omega
    step = T / m.count
    mu_t = 0.0025 * w.get("d.mu_t", 1.0)

    def chords(curve: np.ndarray, scale: float, under: float) -> np.ndarray:
        """Return what a pole distance of scale/(under·μ_t) mm cuts off, at every position, mm."""
        H = scale / (under * mu_t) * w.get("d.H", 1.0)
        slope = np.arctan2(np.roll(curve, -1) - curve, step / mu_t)
        cut = H * np.tan(slope + hand.rng.normal(0, hand.swing, m.count))
        if w.get("d.chord"):
            return np.asarray(cut)
        return _curve(cut)

    V = chords(S, mu.S, mu.V)
    A = chords(V, mu.V, mu.A)
    rows = []
    sign = w.get("d.sign", 1)
    for name, curve, scale, unit in (
        ("S", S, mu.S, "m"),
        ("V", V, mu.V, "m/s"),
        ("a", A, mu.A, "m/s²"),
    ):
        for k, y in enumerate(curve):
            mm = hand.measure(y) * (np.sign(y) or 1) * sign
            rows.append(Figure("diagrams", k, name, float(mm), digits(float(mm) * scale, 4), unit))
    return rows
