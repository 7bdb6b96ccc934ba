"""Rows asked for by name against vector loops by hand: derivatives to 40 digits, curvature from the path.

The judge knows the mechanism as numbers only: it closes its loops by trigonometry and differentiates them by
mpmath.
"""

from __future__ import annotations

import random
from collections.abc import Callable
from pathlib import Path

import mpmath as mp  # type: ignore[import-untyped]
import numpy as np
import pytest
from support.boards import drawn_of

from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.readers.table import columns_of
from graphic_tmm.scene.read import read

TEXT = """
title = "Rows"
language = "en"
[frame]
O = [0, 0]
C = [{c!r}, {lift!r}]
y = {{ through = [0, {y!r}], angle = "0 deg" }}
[[link]]
number = 1
points = {{ O = [0, 0], A = [{r!r}, 0] }}
[[link]]
number = 2
points = {{ A = [0, 0], B = [{rod!r}, 0], K = [{kx!r}, {ky!r}] }}
side = "left of AC"
[[link]]
number = 3
points = {{ C = [0, 0], B = [{rocker!r}, 0] }}
[[link]]
number = 4
points = {{ B = [0, 0], D = [{long!r}, 0] }}
[[link]]
number = 5
points = {{ D = [0, 0] }}
slides = {{ on = "frame", along = "y", side = "right" }}
[drive]
link = 1
speed = {speed!r}
acceleration = {gain!r}
turns = "{turns}"
positions = 5
zero = {zero!r}
accelerations = "all"
[plans]
velocities = "{plan}"
{rows}
[hand]
ruler = "exact"
[[sheet]]
format = "A1"
place = ["positions", "velocities", "accelerations"]
"""
ROWS = """[rows]
lengths = ["OD", "OB"]
angles = ["AB", "CB"]
relative = ["BA", "KB"]
paths = ["K", "B", "A"]
pins = { O = "30 mm", A = "10 mm", B = "12 mm", C = "8 mm" }
"""


class Case:
    """A crank-rocker with a point K on its coupler and a slider D."""

    def __init__(self, seed: int, plan: str = "direct", rows: str = ROWS) -> None:
        pick = random.Random(seed)
        r = pick.uniform(0.05, 0.1)
        self.v = {
            "r": r, "c": 4.0 * r, "lift": pick.uniform(-0.5, 0.5) * r, "y": pick.uniform(0.0, 0.5) * r,
            "rod": pick.uniform(3.6, 4.4) * r, "rocker": pick.uniform(2.2, 2.6) * r,
            "kx": pick.uniform(-1.0, 4.0) * r, "ky": pick.uniform(-2.0, 2.0) * r, "long": 6.0 * r,
            "speed": pick.uniform(3.0, 30.0), "gain": pick.choice((0.0, pick.uniform(-50.0, 50.0))),
            "zero": pick.uniform(0.0, 360.0),
        }  # fmt: skip
        self.sense = pick.choice((1, -1))
        turns = "counterclockwise" if self.sense > 0 else "clockwise"
        self.text = TEXT.format(**self.v, turns=turns, plan=plan, rows=rows)

    def drawn(self, folder: Path) -> Drawn:
        """Draw it with the exact hand."""
        path = folder / "scene.toml"
        path.write_text(self.text, encoding="utf-8")
        found: Drawn = drawn_of(read(path), exact=True)
        return found

    def place(self, letter: str, phi: mp.mpf) -> mp.matrix:
        """Return where a point is (x, y) at an angle of the crank, by trigonometry."""
        v = {k: mp.mpf(value) for k, value in self.v.items()}
        a = (v["r"] * mp.cos(phi), v["r"] * mp.sin(phi))
        base = (v["c"] - a[0], v["lift"] - a[1])
        d = mp.sqrt(base[0] ** 2 + base[1] ** 2)
        foot = (d**2 + v["rod"] ** 2 - v["rocker"] ** 2) / (2 * d)
        high = mp.sqrt(v["rod"] ** 2 - foot**2)
        u = (base[0] / d, base[1] / d)
        b = (a[0] + foot * u[0] - high * u[1], a[1] + foot * u[1] + high * u[0])
        w = ((b[0] - a[0]) / v["rod"], (b[1] - a[1]) / v["rod"])
        k = (a[0] + v["kx"] * w[0] - v["ky"] * w[1], a[1] + v["kx"] * w[1] + v["ky"] * w[0])
        x = b[0] + mp.sqrt(v["long"] ** 2 - (v["y"] - b[1]) ** 2)
        there = {"O": (0, 0), "A": a, "B": b, "K": k, "C": (v["c"], v["lift"]), "D": (x, v["y"])}
        return there[letter]

    def rates(self, letter: str, angle: float) -> tuple[complex, complex, complex]:
        """Return place, velocity and acceleration of a point (m, s)."""
        omega, gain = self.sense * self.v["speed"], self.sense * self.v["gain"]
        with mp.workdps(40):
            phi = mp.radians(mp.mpf(angle))
            found = []
            for axis in (0, 1):
                terms = [
                    mp.diff(lambda p, i=axis: self.place(letter, p)[i], phi, n) for n in (0, 1, 2)
                ]
                found.append((terms[0], terms[1] * omega, terms[2] * omega**2 + terms[1] * gain))
            z, v, a = (complex(float(x), float(y)) for x, y in zip(*found, strict=True))
        return z, v, a

    def omega(self, first: str, second: str, angle: float) -> float:
        """Return how fast the line of two points of a link turns."""
        (z, v, _), (w, u, _) = self.rates(first, angle), self.rates(second, angle)
        return float(((u - v) / (w - z)).imag)


@pytest.mark.parametrize(
    ("seed", "plan"), [(1, "direct"), (2, "turned"), (3, "turned"), (4, "direct")]
)
@pytest.mark.slow
def test_rows_are_those_of_the_vector_loops(seed: int, plan: str, tmp_path: Path) -> None:
    case = Case(seed, plan)
    drawn = case.drawn(tmp_path)
    told = {(c.plan, c.segment): c.value[0] for c in columns_of(drawn)}
    p, v, a = "positions", "velocities", "accelerations"
    due: dict[tuple[str, str], Callable[[float], float]] = {
        (p, "OD"): lambda t: abs(case.rates("D", t)[0].real),
        (p, "OB"): lambda t: abs(case.rates("B", t)[0]),
        (p, "phiAB"): lambda t: _angle(case.rates("B", t)[0] - case.rates("A", t)[0]),
        (p, "phiCB"): lambda t: _angle(case.rates("B", t)[0] - case.rates("C", t)[0]),
        (a, "ab"): lambda t: abs(case.rates("B", t)[2] - case.rates("A", t)[2]),
        (a, "bk"): lambda t: abs(case.rates("K", t)[2] - case.rates("B", t)[2]),
        (v, "vO01"): lambda t: 0.03 * abs(case.omega("O", "A", t)),
        (v, "vA12"): lambda t: 0.01 * abs(case.omega("O", "A", t) - case.omega("A", "B", t)),
        (v, "vB23"): lambda t: 0.012 * abs(case.omega("A", "B", t) - case.omega("C", "B", t)),
        (v, "vB24"): lambda t: 0.012 * abs(case.omega("A", "B", t) - case.omega("B", "D", t)),
        (v, "vC03"): lambda t: 0.008 * abs(case.omega("C", "B", t)),
    }
    for letter in "KB":
        small = letter.lower()
        due[a, f"t{small}"] = lambda t, k=letter: abs(_parts(*case.rates(k, t)[1:])[0])
        due[a, f"n{small}"] = lambda t, k=letter: abs(_parts(*case.rates(k, t)[1:])[1])
    for letter in "KBA":
        due[a, f"rho{letter}"] = lambda t, k=letter: _radius(*case.rates(k, t)[1:])
    angles = [float(one or 0.0) for one in drawn.project.coordinates]
    for key, of in due.items():
        found, wanted = told[key], np.array([of(angle) for angle in angles])
        off = (
            (found - wanted + 180.0) % 360.0 - 180.0 if key[1].startswith("phi") else found - wanted
        )
        assert np.abs(off).max() <= 1e-9 * np.abs(wanted).max(), key


def test_a_row_that_is_not_asked_for_records_no_step(tmp_path: Path) -> None:
    logs = [Case(1, rows=rows).drawn(tmp_path).construction for rows in ("", "[rows]\n", ROWS)]
    bare, empty, full = ([(s.op.name, s.it.name, s.it.view) for s in log.steps] for log in logs)
    assert bare == empty
    assert len(full) > len(bare)
    single = Case(1, rows='[rows]\nlengths = ["OB"]\n').drawn(tmp_path).construction
    assert len(single.steps) == len(bare) + 1


def test_a_straight_path_has_no_radius_and_says_so(tmp_path: Path) -> None:
    drawn = Case(1, rows='[rows]\npaths = ["D"]\n').drawn(tmp_path)
    assert np.isnan(next(c for c in columns_of(drawn) if c.segment == "rhoD").value).all()
    (row,) = KINEMATICS_PLAN.on(drawn).rows
    said = [f for f in drawn.findings() if row.mark in (f.step.it, *f.marks)]
    assert {place for one in said for place in one.positions} == set(range(5))


def test_a_point_at_rest_has_no_path_there(tmp_path: Path) -> None:
    """A slider-crank in line, at both dead centres: v_B = 0 has no direction."""
    path = tmp_path / "scene.toml"
    path.write_text(REST, encoding="utf-8")
    drawn = drawn_of(read(path))
    told = {c.segment: c.value[0] for c in columns_of(drawn)}
    for segment in ("rhoM", "rhoB"):
        assert np.isnan(told[segment][[0, 2]]).all() == (segment == "rhoB")
    assert np.isfinite(told["rhoM"]).all()
    named = {(f.step.it.name, f.positions) for f in drawn.findings()}
    assert ("(v_{B})", (0, 2)) in named


REST = """
title = "Rest"
language = "en"
[frame]
O = [0, 0]
x = { through = [0, 0], angle = "0 deg" }
[[link]]
number = 1
points = { O = [0, 0], A = [0.1, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.3, 0], M = [0.15, 0] }
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
[drive]
link = 1
speed = 10
positions = 4
accelerations = "all"
[rows]
paths = ["M", "B"]
[[sheet]]
format = "A3"
place = ["positions", "velocities", "accelerations"]
"""


@pytest.mark.parametrize(
    ("rows", "says"),
    [
        ('[rows]\nlengths = ["OX"]\n', '"X" is no point'),
        ('[rows]\nangles = ["A"]\n', '"A" is not two letters'),
        ('[rows]\npaths = ["O"]\n', '"O" .*fixed|stands still|is no point of a moving link'),
        ('[rows]\npins = { Q = "10 mm" }\n', '"Q" is no point'),
        ('[rows]\npins = { K = "10 mm" }\n', "no links turn against each other in K"),
    ],
)
def test_what_cannot_be_told_is_refused(rows: str, says: str, tmp_path: Path) -> None:
    with pytest.raises((SceneError, StructureError), match=says):
        Case(1, rows=rows).drawn(tmp_path)


def test_accelerations_have_to_be_drawn_for_them(tmp_path: Path) -> None:
    case = Case(1)
    case.text = case.text.replace('accelerations = "all"\n', "")
    with pytest.raises(SceneError, match="it is read off acceleration plans"):
        case.drawn(tmp_path)


def _angle(way: complex) -> float:
    return float(np.degrees(np.angle(way)))


def _parts(velocity: complex, acceleration: complex) -> tuple[float, float]:
    own = acceleration * velocity.conjugate() / abs(velocity)
    return own.real, own.imag


def _radius(velocity: complex, acceleration: complex) -> float:
    return abs(velocity) ** 2 / abs(_parts(velocity, acceleration)[1])
