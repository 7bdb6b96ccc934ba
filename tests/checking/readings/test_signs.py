"""Signs of readings: once a column bears a minus, a plus is a sign; a column without any is of magnitudes."""

from __future__ import annotations

from collections.abc import Mapping
from functools import cache

import pytest
from support import gallery
from support.gallery import CASES
from support.verdicts import Verdicts, verdicts

from graphic_tmm.checking.cells import cells
from graphic_tmm.checking.check import check
from graphic_tmm.checking.readings.signs import with_signs
from graphic_tmm.checking.records import MISTAKE, WRONG, Report, Taken
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

V, A, D = "velocities", "accelerations", "diagrams"
Figures = Mapping[str, float]


@cache
def made(name: str) -> DrawnScene:
    return make(read(CASES / "check" / f"{name}.toml"), exact=True)


def due(scene: DrawnScene, plan: str, segment: str, *, mm: bool) -> dict[str, float]:
    """Return what is due of a column, as a hand writes it, by position."""
    found = {
        position: cell.mm if mm else cell.value
        for (p, s, position), cell in cells(scene).items()
        if (p, s) == (plan, segment)
    }
    return {name: round(figure, 1 if mm else 3) for name, figure in found.items() if figure}


def rows(plan: str, segment: str, figures: Figures, *, mm: bool = False) -> list[Taken]:
    line = iter(range(2, 100))
    if mm:
        return [Taken(plan, at, segment, mm=f, line=next(line)) for at, f in figures.items()]
    unit = "1/s" if plan == V else "1/s^2"
    return [
        Taken(plan, at, segment, value=f, unit=unit, line=next(line)) for at, f in figures.items()
    ]


def judged(scene: DrawnScene, taken: list[Taken]) -> Verdicts:
    return next(verdicts(scene.scene, [("0", tuple(taken))], trials=100))


def wrong(found: Verdicts | Report) -> list[str]:
    return [one.taken.position for one in found.readings if one.verdict == WRONG]


def magnitudes(figures: Figures) -> dict[str, float]:
    return {at: abs(figure) for at, figure in figures.items()}


@pytest.mark.parametrize(("name", "plan", "rate"), [("sc", V, "omega2"), ("fb", A, "epsilon3")])
def test_a_plus_among_minuses_is_wrong_where_a_minus_is_due(
    name: str, plan: str, rate: str
) -> None:
    scene = made(name)
    right = due(scene, plan, rate, mm=False)
    below = [at for at, figure in right.items() if figure < -1.0]
    assert len(below) >= 2
    assert wrong(judged(scene, rows(plan, rate, right))) == []
    assert wrong(judged(scene, rows(plan, rate, magnitudes(right)))) == []
    one = {**right, below[0]: -right[below[0]]}
    assert wrong(judged(scene, rows(plan, rate, one))) == [below[0]]


def test_a_link_with_minuses_tells_that_signs_of_the_others_are_meant() -> None:
    """omega2 and omega3 of the six-bar are one column: ω."""
    scene = made("fb")
    second, third = (due(scene, V, rate, mm=False) for rate in ("omega2", "omega3"))
    below = [at for at, figure in third.items() if figure < -1.0]
    taken = rows(V, "omega2", second) + rows(V, "omega3", magnitudes(third))
    assert min(second.values()) < 0.0
    assert set(below) <= set(wrong(judged(scene, taken)))
    lengths = rows(V, "pb", due(scene, V, "pb", mm=True), mm=True)
    assert wrong(judged(scene, [*lengths, *rows(V, "omega3", magnitudes(third))])) == []


def test_a_nought_with_the_other_sign_is_none() -> None:
    """Where nothing turns the sign of what was measured is chance."""
    right = due(made("sc"), V, "omega2", mm=False)
    taken = rows(V, "omega2", {**right, "2": 0.1, "6": -0.1})
    assert wrong(judged(made("sc"), taken)) == []


@pytest.mark.parametrize("mm", [True, False])
def test_a_diagram_of_reversed_signs_is_named_as_that(mm: bool) -> None:
    scene = gallery.exact("slider-diagrams")
    taken = []
    for letter, sign in (("V", 1.0), ("a", -1.0)):
        right = due(scene, D, letter, mm=mm)
        unit = next(c.unit for (p, s, _), c in cells(scene).items() if (p, s) == (D, letter))
        some = rows(D, letter, {at: sign * f for at, f in right.items()}, mm=mm)
        taken += [one if mm else one._replace(unit=unit) for one in some]
    report = check(scene.scene, taken)
    assert {one.taken.segment for one in report.readings if one.verdict == WRONG} == {"a"}
    first = report.mistakes[0]
    assert (first.kind, first.plan, first.segment) == (MISTAKE, D, "a")
    assert "все знаки обратные" in first.says
    # a pole on the other side gives the same quantities
    assert first.chance > (0.8 if mm else 0.5)


def test_magnitudes_of_a_diagram_pass() -> None:
    scene = gallery.exact("slider-diagrams")
    taken = rows(D, "a", magnitudes(due(scene, D, "a", mm=True)), mm=True)
    assert wrong(judged(scene, taken)) == []


def test_points_have_no_signs_of_this_kind() -> None:
    point = Taken(V, "1", "b", x=-3.0, y=4.0)
    length = Taken(V, "1", "pb", mm=4.0)
    assert with_signs([point, length]) == (point, length)
    other = Taken(V, "2", "pb", mm=-4.0)
    assert [one.signed for one in with_signs([point, length, other])] == [False, True, True]
