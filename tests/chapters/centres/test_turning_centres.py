"""The scheme of centres as it moves with the crank: where loops have the centres, and tied to marks."""

from __future__ import annotations

import math
import re
from functools import cache

import pytest
from support import gallery
from support.centres_by_hand import SIX_BAR, Student, meeting, six_bar

from graphic_tmm.chapters.centres.record import CENTRES_PLAN
from graphic_tmm.chapters.centres.task import CENTRES
from graphic_tmm.chapters.centres.turning import moving
from graphic_tmm.drawn import Drawn
from graphic_tmm.page.dense import Dense, dense
from graphic_tmm.page.strands import Moving, strands
from graphic_tmm.page.tied_pack import FigureTies
from graphic_tmm.page.trials import trials
from graphic_tmm.paper.drawing import Drawing, Stroke
from graphic_tmm.paper.expressions import Expressions

SCENE = "centres-of-six-bar"
NEAR = 1e-6
"""Between loops in doubles and the construction, mm."""
FAR_OFF = 1e4
"""Farther off than this, mm, lines are as good as parallel."""


@cache
def turned() -> Dense:
    found = dense(gallery.exact(SCENE).mechanism)  # type: ignore[arg-type]
    assert found is not None
    return found


def figure(drawn: Drawn) -> Moving:
    (found,) = moving(drawn)
    assert found.name == CENTRES
    return found


def by_loops(angle: float, mu: float) -> dict[str, complex]:
    """Where all centres but that of the guide are, mm."""
    at = {name: spot / mu for name, spot in six_bar(math.radians(angle)).items()}
    student = Student(0)
    for name, (a, b, c, d) in SIX_BAR.items():
        at[name] = meeting(student.line(at, a, b), student.line(at, c, d))
    return at


def numbers(drawing: Drawing) -> dict[str, complex]:
    """The numbers of the links of centres that are lettered, and where the points of the letters are."""
    found = {}
    for one in drawing.wanted:
        found |= {number: one.at for number in re.findall(r"P_\{(\d\d)\}", one.text)}
    return found


def apart(spot: complex, ends: list[complex]) -> float:
    way = ends[1] - ends[0]
    return abs(((spot - ends[0]).conjugate() * way).imag) / abs(way)


@pytest.mark.parametrize("angle", [7, 45, 95, 133, 200, 251, 300, 359])
def test_centres_stand_where_loops_have_them(angle: int) -> None:
    found = turned()
    mu = found.drawn.value(CENTRES_PLAN.on(found.drawn).mu)
    due, drawing = by_loops(angle, mu), figure(found.drawn).at(angle)
    arrows = {one.at for one in drawing.wanted if one.text.startswith("→")}
    lines = [
        [complex(x, y) for x, y, _ in one.path]
        for one in drawing.strokes
        if isinstance(one, Stroke) and one.pen == "thin" and not one.closed and len(one.of) == 1
    ]
    lines = [ends for ends in lines if len(ends) == 2]
    at = numbers(drawing)
    assert at.keys() >= due.keys()
    for number, spot in at.items():
        if number == "50":
            continue
        if spot in arrows:
            # the arrow is on a line that leads to the centre
            through = [ends for ends in lines if min(abs(end - spot) for end in ends) < NEAR]
            assert abs(due[number]) > 100.0
            assert (
                min(apart(due[number], ends) / abs(due[number] - spot) for ends in through) < 1e-8
            )
        else:
            assert abs(spot - due[number]) < NEAR * max(1.0, abs(spot) / FAR_OFF), number


def test_lines_that_are_one_lead_to_no_centre() -> None:
    """At 180° (AC) and (P_13 P_34) are one line: where P_14 is nobody can tell, nor what hangs on it."""
    there = numbers(figure(turned().drawn).at(180))
    assert {"14", "15", "25", "35"}.isdisjoint(there)
    assert {"20", "40", "34", "13", "10", "12", "23", "24", "30", "45"} <= there.keys()


def test_few_comparisons_are_traced() -> None:
    """What ink is tied by is tried in every case of a comparison: most of these are of the guide's hatching."""
    found, among = turned(), Expressions()
    first = trials(found, among)[0]
    scheme = figure(first.drawn)
    for angle in first.angles[:4]:
        among.begin()
        scheme.at(angle)
        assert len(among.guards) < 500


@pytest.mark.slow
def test_a_page_needs_no_rows_of_it() -> None:
    """All of it is tied to marks, so that it follows other lengths and costs the page some 20 kB."""
    found = turned()

    def figures(drawn: Drawn) -> list[Moving]:
        return [figure(drawn)]

    ties = FigureTies(found, figures, {CENTRES: strands(found, figure(found.drawn))})
    assert all(ties.ties[CENTRES].values())
    assert ties.whole[CENTRES] == ties.ties[CENTRES].keys()
