"""Published problems of machines that no single crank drives, and of several cylinders, from their own figures.

Where a book prints a formula, or neglects what is not neglected here, it is said what was derived by hand.
"""

from __future__ import annotations

import cmath
import math
from typing import Any

import numpy as np
import pytest
from support.boards import drawn_of
from support.each import each
from support.stars import Star

import graphic_tmm
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN

G = 9.81
Told = dict[str, Any]
STANDS = {"title": "T", "language": "en"}


def pair(z: complex) -> list[float]:
    return [z.real, z.imag]


def link(number: int, points: dict[str, complex], **more: Any) -> Told:
    return {"number": number, "points": {k: pair(z) for k, z in points.items()}, **more}


def line(name: str) -> Told:
    return {name: {"through": [0.0, 0.0], "angle": "0 deg"}}


def slid(on: int | str, along: str, side: str = "+") -> Told:
    return {"on": on, "along": along, "side": side}


def rod(number: int, pin: str, at: str, guide: str) -> list[Told]:
    """A cylinder on a pin and the rod in it that ends in another."""
    cylinder = link(number, {pin: 0j}, guides=line(guide))
    return [cylinder, link(number + 1, {at: 0j}, slides=slid(number, guide))]


def first(scene: Told, name: str) -> float:
    """A figure of forces in the first position."""
    table = graphic_tmm.draw(graphic_tmm.read(scene), exact=True).table("forces")
    return float(table[name].value[0, 0])


@pytest.mark.slow
def test_the_cylinders_of_a_shovel() -> None:
    """Hibbeler, Statics, 14th ed., 6-91: EF pulls with 8.175 kN, AD pushes with 158 kN.

    The shovel weighs 1.25 t at 0.5 m from its pin H, EF lies at 1.5·sin 30° m from H, H at 2 m and 10° from
    C, AD at 0.25·cos 40° m from C.
    """
    h, d, e = cmath.rect(2.0, math.radians(10)), -0.25j, cmath.rect(1.5, math.radians(150))
    scene = {
        **STANDS,
        "frame": {"C": [0, 0], "A": pair(d - cmath.rect(1.2, math.radians(40)))},
        "link": [
            link(1, {"C": 0j, "D": d, "H": h, "F": h + e - 0.6}, side="left of CA"),
            *rod(2, "A", "D", "z"),
            link(4, {"H": 0j, "E": e, "T": 0.5 + 0j}, side="left of FH"),
            *rod(5, "F", "E", "w"),
        ],
        "drive": [
            {"link": 3, "speed": 0, "from": "1.2 m", "to": "1.25 m", "positions": 2},
            {"link": 6, "speed": 0, "at": "0.6 m"},
        ],
        "load": [{"link": 4, "point": "T", "force": 1250 * G, "direction": "-90 deg"}],
        "forces": {"positions": [0]},
    }
    assert first(scene, "P_bal_6") == pytest.approx(-8175, abs=0.5)
    for name in ("P_bal_forces", "P_bal_lever"):
        assert first(scene, name) == pytest.approx(158e3, abs=500)


def test_a_peg_on_a_hydraulic_cylinder() -> None:
    """Hibbeler, Dynamics, 16-48: the peg, 0.6 m off, goes up at 0.5 m/s; at 45° ω = 0.417, ε = −0.347 1/s²."""
    scene = {
        **STANDS,
        "frame": {"A": [0, 0], "x": {"through": [0.6, 0], "angle": "90 deg"}},
        "link": [
            link(1, {"B": 0j}, slides=slid("frame", "x")),
            link(2, {"B": 0j}, slides=slid(3, "z")),
            link(3, {"A": 0j}, guides=line("z")),
        ],
        "drive": {"link": 1, "speed": "0.5 m/s", "from": "0.3 m", "to": "0.9 m"},
    }
    found = graphic_tmm.motion(graphic_tmm.read(scene), [0.6], exact=True)
    assert found.omega[3][0] == pytest.approx(0.417, abs=5e-4)
    assert found.epsilon[3][0] == pytest.approx(-0.347, abs=5e-4)


@each("degrees", [20.0, 40.0, 65.0])
@pytest.mark.slow
def test_a_scissors_jack(degrees: float) -> None:
    """Hibbeler, Statics, virtual work: two crosses of links carry P, the screw along the floor 2P·cot θ."""
    size, turn = 0.5, math.radians(degrees)
    half, whole = {"M": size / 2 + 0j}, {"N": size / 2 + 0j}
    reach = f"{size * math.cos(turn)} m", f"{size * math.cos(turn + 0.1)} m"
    scene = {
        **STANDS,
        "frame": {"A": [0, 0], **line("x")},
        "link": [
            link(1, {"D": 0j}, slides=slid("frame", "x", "right")),
            link(2, {"A": 0j, **half, "E": size + 0j}, side="left of AD"),
            link(3, {"D": 0j, **half, "C": size + 0j}),
            link(4, {"C": 0j, **whole, "F": size + 0j}, side="left of CE"),
            link(5, {"E": 0j, **whole, "H": size + 0j}),
            link(6, {"F": 0j, "T": 0.1j - 0.2}, guides=line("z")),
            link(7, {"H": 0j}, slides=slid(6, "z", "-")),
        ],
        "drive": {"link": 1, "speed": 0, "from": reach[0], "to": reach[1], "positions": 2},
        "load": [{"link": 6, "point": "T", "force": 2000, "direction": "-90 deg"}],
        "forces": {"positions": [0]},
    }
    for name in ("P_bal_forces", "P_bal_lever"):
        assert abs(first(scene, name)) == pytest.approx(2 * 2000 / math.tan(turn), rel=1e-9)


@each("degrees", [15.0, 30.0, 50.0])
@pytest.mark.slow
def test_a_spring_holds_a_linkage(degrees: float) -> None:
    """Beer and Johnston, Statics, virtual work: two links l, a load W at their pin, a spring k that is free
    where they lie in line: (1 − cos θ)·tan θ = W/(4kl). Here upside down."""
    size, rate, turn = 0.3, 900.0, math.radians(degrees)
    weight = 4 * rate * size * (1 - math.cos(turn)) * math.tan(turn)
    scene = {
        **STANDS,
        "frame": {"O": [0, 0], **line("x")},
        "link": [
            link(1, {"O": 0j, "A": size + 0j}),
            link(2, {"A": 0j, "B": size + 0j}),
            link(3, {"B": 0j}, slides=slid("frame", "x", "right")),
        ],
        "drive": {"link": 1, "speed": 0, "from": f"{degrees} deg", "to": f"{degrees + 9} deg"},
        "load": [{"link": 1, "point": "A", "force": weight, "direction": "90 deg"}],
        "spring": [{"between": ["O", "B"], "rate": rate, "free": 2 * size}],
        "forces": {"positions": [0, 1], "balance": "moment"},
    }
    table = graphic_tmm.draw(graphic_tmm.read(scene), exact=True).table("forces")
    for name in ("M_bal_forces", "M_bal_lever"):
        holds, not_yet = table[name].value[0, :2]
        assert abs(holds) < 1e-12 * weight
        assert abs(not_yet) > 1e-3 * weight * size


def test_the_gripper_by_hand() -> None:
    """Derived: each link carries what turns its finger, 120 N on the finger's tip; the rod bears both."""
    k, b = 0.06 + 0.03j, 0.02 + 0j
    back, reach, arm = abs(0.072 + 0j), abs(k - b), abs(-0.01 + 0.03j)
    turn = math.acos((reach**2 + back**2 - arm**2) / (2 * reach * back))
    a = b + back * cmath.exp(1j * (cmath.phase(k - b) + turn))
    tip = k + (0.08 - 0.01j) * (a - k) / (-0.01 + 0.03j)
    along = (a - b) / back
    pushed = -120 * (tip - k).real / ((a - k).conjugate() * along).imag
    table = graphic_tmm.draw(graphic_tmm.read("gripper"), exact=True).table("forces")
    for name in ("P_bal_forces", "P_bal_lever"):
        assert table[name].value[0, 3] == pytest.approx(2 * pushed * along.real, rel=1e-9)


@each(
    "star, rpm, mass, turning, twice",
    [
        # Khurmi and Gupta, Theory of Machines, 22.14: 836 N; the primary m·r·ω² goes round
        (Star((135.0, 45.0), r=0.075, rod=0.3), 500, 11.5, 1.0, math.sqrt(2)),
        # three cylinders at 120° on one crank: by hand 1.5·m·r·ω², and as much of λ the other way round
        (Star((90.0, 210.0, 330.0), r=0.06, rod=0.24), 2400, 1.0, 1.5, 1.5),
        # four in line, cranks 0°, 180°, 180°, 0°: by hand none, and 4·m·r·ω²·λ
        (Star((90.0,) * 4, cranks=(0.0, 180.0, 180.0, 0.0)), 2000, 2.0, 0.0, 4.0),
        # opposed, cranks at 180°: nothing at all
        (Star((180.0, 0.0), cranks=(0.0, 180.0)), 3000, 0.5, 0.0, 0.0),
        # three in line, cranks at 120°: nothing of the first and the second
        (Star((90.0,) * 3, cranks=(0.0, 120.0, 240.0)), 3000, 0.5, 0.0, 0.0),
    ],
)
def test_what_shakes_engines(
    star: Star, rpm: int, mass: float, turning: float, twice: float
) -> None:
    text = star.text(
        f'speed = "{rpm} rpm"\n[effects]\ninertia = true\n[forces]\nbalance = "moment"\n'
    )
    scene = graphic_tmm.read(text.replace("mass = 1\n", f"mass = {mass}\n"))
    found = graphic_tmm.motion(scene, np.arange(0.0, 360.0, 5.0), plans=["forces"], exact=True)
    force = sum(value for name, value in found.forces.items() if name.startswith("R0"))
    ratio, unit = star.r / star.rod, mass * star.r * (rpm * math.pi / 30) ** 2
    # of exact accelerations; books take r/l alone
    exact = ratio + ratio**3 / 4 + 15 * ratio**5 / 128 + 35 * ratio**7 / 512
    parts = np.abs(np.fft.fft(force)) / force.size
    assert parts[1] + parts[-1] == pytest.approx(turning * unit, rel=1e-9, abs=1e-9 * unit)
    second = parts[2] + parts[-2]
    assert second == pytest.approx(twice * unit * exact, rel=1e-6, abs=1e-9 * unit)
    if turning == 1.0:
        assert second * ratio / exact == pytest.approx(836, abs=0.5)


def test_a_two_stage_compressor() -> None:
    """Derived: the work of a turn is 2·n/(n − 1)·p₁(V_a − V_d)·(r^((n−1)/2n) − 1), V_a − V_d: the air drawn in.

    Two stages of one pressure ratio, an ideal cooler between them, expansion by the same n.
    """
    low, high, n, bore, stroke, clear = 1.013e5, 7e5, 1.35, 0.2, 0.1, 0.05
    ratio = math.sqrt(high / low)
    more = ratio ** (1 / n)
    gas = ""
    for point, one in (("B", low), ("C", low * ratio)):
        gas += (
            f'[[indicator]]\npoint = "{point}"\nbore = {bore * math.sqrt(low / one)}\n'
            f"clearance = {clear}\ncover_strokes = [\n"
            f'{{ stroke = "out", to = {clear * (more - 1)}, p = {one * ratio}, n = {n} }},\n'
            f'{{ stroke = "out", to = 1.0, p = {one}, n = 0 }},\n'
            f'{{ stroke = "back", to = {(1 + clear) / more - clear}, p = {one}, n = {n} }},\n'
            f'{{ stroke = "back", to = 0.0, p = {one * ratio}, n = 0 }},\n]\n'
        )
    text = Star((0.0, 90.0)).text(
        f'speed = "300 rpm"\npositions = 360\n{gas}[flywheel]\nJ = 5\ntangents = "none"\n'
    )
    made = drawn_of(graphic_tmm.read(text), exact=True)
    work = 2 * math.pi * made.reading[FLYWHEEL_PLAN.on(made).moment][0].mean()
    drawn_in = math.pi / 4 * bore**2 * stroke * (1 - clear * (more - 1))
    due = 2 * n / (n - 1) * low * drawn_in * (ratio ** ((n - 1) / n) - 1)
    assert abs(work) == pytest.approx(due, rel=1e-3)
