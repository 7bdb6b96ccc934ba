"""The own error of a step: nothing on a perfect drawing, and nothing for what only follows from a slip."""

from __future__ import annotations

import math
from dataclasses import replace

import pytest
from support.gallery import SHEETS, exact
from support.trials import blamed, cells_and_points, readings
from support.verdicts import verdicts

from graphic_tmm.board.hand import HANDS
from graphic_tmm.checking.cells import cells, points
from graphic_tmm.checking.check import check
from graphic_tmm.checking.judging import judge
from graphic_tmm.checking.judging.comparison import Comparison
from graphic_tmm.checking.judging.scatter import Limits
from graphic_tmm.checking.judging.yardstick import Yardsticks
from graphic_tmm.checking.records import FINE, WRONG, Taken
from graphic_tmm.scene.read import read

SCENES = ("engine", "crank-rocker", "shaper", "offset-slider", "accelerating-crank", "lever")


@pytest.mark.slow
@pytest.mark.parametrize("name", SCENES)
@pytest.mark.parametrize("pointed", [False, True])
def test_a_perfect_drawing_has_no_error(name: str, pointed: bool) -> None:
    due = cells_and_points(exact(name)) if pointed else cells(exact(name))
    rows = readings(due, due)
    by = Yardsticks(exact(name), HANDS["student"]._replace(trials=2), Limits()).of(rows)
    own = Comparison(exact(name), rows, by)
    drawn = [t for t in rows if t.plan == "velocities" and (t.pointed or t.mm is not None)]
    assert all(own.errors(taken) for taken in drawn)
    assert max(abs(error) for taken in rows for _, error, _ in own.errors(taken)) < 1e-9


@pytest.mark.slow
def test_a_ray_turned_by_four_degrees_is_blamed() -> None:
    """Nine in ten, less two sigma of so many drawings."""
    found = [blamed(name, 5) for name in ("engine", "crank-rocker", "offset-slider")]
    drawings = sum(one.drawings for one in found)
    assert drawings >= 400
    share = 0.9 - 2.0 * math.sqrt(0.9 * 0.1 / drawings)
    assert sum(one.ray for one in found) >= share * drawings


@pytest.mark.slow
def test_a_ray_that_slipped_is_blamed() -> None:
    """Point b stands on the line pb, off the line ab: that line was drawn wrong."""
    spots = points(exact("engine"))
    a, b = spots["velocities", "a", "3"], spots["velocities", "b", "3"]
    wrong = b * (1.0 - 7.0 / abs(b))
    rows = [
        Taken("velocities", "3", "a", x=a.real, y=a.imag, line=2),
        Taken("velocities", "3", "b", x=wrong.real, y=wrong.imag, line=3),
    ]
    report = check(read(SHEETS / "engine"), rows, trials=80)
    one = next(o for o in report.readings if o.taken.segment == "b")
    assert one.verdict != FINE
    assert "(ab)" in one.step


@pytest.mark.slow
def test_what_follows_from_a_slip_is_not_punished() -> None:
    """ab is read 6 mm too long; the normal component calculated from it is right for that reading."""
    name = "engine"
    due = cells(exact(name))
    ab, pb = due["velocities", "ab", "2"].mm, due["velocities", "pb", "2"].mm
    an2 = due["accelerations", "an2", "2"].mm
    assert ab is not None
    assert pb is not None
    assert an2 is not None
    found = abs(ab) - 12.0
    rows = [
        Taken("velocities", "2", "ab", mm=found, line=2),
        Taken("velocities", "2", "pb", mm=pb, line=3),
        Taken("accelerations", "2", "an2", mm=abs(an2) * (found / abs(ab)) ** 2, line=4),
    ]
    report = check(read(SHEETS / name), rows, trials=80)
    told = {one.taken.segment: one.verdict for one in report.readings}
    assert told == {"ab": WRONG, "pb": FINE, "an2": FINE}


@pytest.mark.slow
def test_by_a_hand_that_hardly_slips_a_deviation_of_a_thousandth_is_wrong() -> None:
    """0.05 of 60 mm, drawn by a machine and read to 0.001, is an error; 0.004 is none."""
    due = cells(exact("engine"))["velocities", "pb", "2"].mm
    assert due is not None
    scene = replace(read(SHEETS / "engine"), ruler=0.001)
    rows = [
        (f"{off}", (Taken("velocities", "2", "pb", mm=round(abs(due) + off, 3), line=2),))
        for off in (0.05, 0.004)
    ]
    told = verdicts(scene, rows, hand="cad", trials=40)
    assert [one.verdict for report in told for one in report.readings] == [WRONG, FINE]


class Carrying:
    """A drawing in which two earlier readings bring so many mm of what a later one is off."""

    def __init__(self, *brings: float) -> None:
        self.brings = brings

    def sources(self, taken: Taken) -> tuple[Taken, ...]:
        return tuple(Taken("velocities", "2", f"s{k}") for k, _ in enumerate(self.brings))

    def carried(self, taken: Taken, source: Taken) -> float:
        return self.brings[int(source.segment[1:])]

    def step(self, taken: Taken) -> None:
        return None


@pytest.mark.parametrize(
    ("brings", "source"),
    [((0.9, 5.0), "s1"), ((3.6, 3.5), "s0"), ((3.2, 2.0), None), ((), None), ((-1.0, 3.4), "s1")],
)
def test_a_deviation_of_10_mm_follows_from_what_brings_a_third_of_it(
    brings: tuple[float, ...], source: str | None
) -> None:
    later, off = Taken("accelerations", "2", "pb", mm=50.0), judge._Off(50.0, 60.0, -10.0, 0.0, 0.0)
    found = judge._follows(Carrying(*brings), later, off)  # type: ignore[arg-type]
    assert (found.segment if found else None) == source
