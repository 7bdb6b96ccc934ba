"""Lessons to be read back: a slider-crank by its vector loop, wrong readings, numbers out of sentences.

Nothing of the package calculates here: the mechanism is that of tests/cases/check/sc.toml.
"""

from __future__ import annotations

import cmath
import math
import re
from functools import cache
from typing import Any

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.judging.taken_marks import Reader, reader
from graphic_tmm.checking.lessons.lessons import Teacher
from graphic_tmm.checking.records import FINE, WRONG, Judged, Lesson, Likely, Taken
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make
from support.gallery import ROOT

CRANK, ROD, OMEGA = 0.1, 0.35, 20.0
MU_L, MU_V, MU_A = 0.002, 0.025, 0.5
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")


@cache
def slider_crank() -> DrawnScene:
    return make(read(ROOT / "tests" / "cases" / "check" / "sc.toml"), exact=True)


@cache
def teacher() -> Teacher:
    return Teacher(slider_crank())


def by(made: DrawnScene) -> Reader:
    return reader(made.scene, HANDS["student"], "paper")


def lessons(*rows: Judged, findings: tuple[Likely, ...] = ()) -> tuple[Lesson, ...]:
    return teacher().lessons(rows, findings, by(slider_crank()))


def row(plan: str, position: str, segment: str, due: float, step: str = "", **more: Any) -> Judged:
    """Return a reading in mm, or of a point ``at`` (complex, mm); wrong where it blames a step."""
    mm, at = more.pop("mm", None), more.pop("at", None)
    x, y = (at.real, at.imag) if at is not None else (None, None)
    taken = Taken(plan, position, segment, mm=mm, x=x, y=y, line=more.pop("line", 2))
    found = abs(at) if at is not None else mm
    verdict = WRONG if step else FINE
    return Judged(taken, found, due, found - due, 1.0, 0.0, verdict, step=step)


def plan_of_velocities(position: int) -> dict[str, complex]:
    """Return the vectors pa, pb, ab of the slider-crank in mm: the guide is the x axis."""
    phi = math.radians(45.0 * position)
    a = CRANK * cmath.exp(1j * phi)
    b = complex(a.real + math.sqrt(ROD**2 - a.imag**2), 0.0)
    v_a = 1j * OMEGA * a
    turn = -v_a.imag / (b - a).real  # the velocity of B has no y
    v_b = v_a + 1j * turn * (b - a)
    return {"pa": v_a / MU_V, "pb": v_b / MU_V, "ab": (v_b - v_a) / MU_V}


def points_of_positions(position: int) -> dict[str, complex]:
    phi = math.radians(45.0 * position)
    a = CRANK * cmath.exp(1j * phi)
    b = complex(a.real + math.sqrt(ROD**2 - a.imag**2), 0.0)
    return {"A": a / MU_L, "B": b / MU_L}


def sums(calculation: str) -> tuple[float, float]:
    """Return what the numbers of a printed calculation come to, and what is printed as its result."""
    *_, numbers, result = calculation.replace("\u00a0", " ").split(" = ")
    return _worth(numbers), _worth(re.match(r"[−\d.,]+(·10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?", result)[0])  # type: ignore[index]


def _worth(text: str) -> float:
    text = text.replace(",", ".").replace("−", "-").replace("²", "**2").replace("³", "**3")
    text = re.sub(r"·10([⁻⁰¹⁴-⁹]+)", lambda f: f"*1e{f[1].translate(_RAISED)}", text)
    text = text.replace("·", "*")
    assert re.fullmatch(r"[-\d.()*/+ e]+", text), text
    return float(eval(text))
