"""What readings cannot show is said: a plan is told of if no drawing of it would have changed any reading."""

from __future__ import annotations

import numpy as np
from support.gallery import CASES

from graphic_tmm.checking.cells import cells, points
from graphic_tmm.checking.check import check
from graphic_tmm.checking.mutations.mistakes import Mistakes
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make


def note(*plans: str) -> str:
    """Return what is noted if only readings of some plans are given."""
    rows = read_readings(CASES / "check" / "honest_six_mm.csv")
    some = [one for one in rows if one.plan in plans]
    notes = check(read(CASES / "check" / "six.toml"), some, trials=50).notes
    return " ".join(one for one in notes if one.startswith("these readings do not show"))


def test_a_plan_without_readings_is_told() -> None:
    told = note("velocities")
    assert "Acceleration plan" in told
    assert "Velocity plan" not in told
    assert "Plan of positions" not in told, "velocities follow from positions"


def test_nothing_is_said_if_every_plan_shows() -> None:
    assert note("positions", "velocities", "accelerations") == ""


def test_accelerations_show_velocities_too() -> None:
    assert note("accelerations") == ""


def test_points_are_moved_alike_if_only_what_they_need_is_executed() -> None:
    made = make(read(CASES / "check" / "six.toml"), exact=True)
    board = Mistakes(made).boards[0]
    found = [at for at in points(made) if at not in cells(made)][::7]
    wanted = dict.fromkeys(((at, True) for at in found), 0.1)
    some = board.showing(found)
    assert "plain" not in board.__dict__
    assert len(some.base) < len(board.plain.base)
    less, whole = (dict(board.moved(wanted, beside)) for beside in (some, board.plain))
    assert less.keys() == whole.keys() == wanted.keys()
    assert all(np.array_equal(less[at], whole[at]) for at in wanted)
    assert board.showing(found) is board.plain


def test_a_slip_beside_a_mistake_is_not_explained_by_it_nor_the_only_thing_off() -> None:
    """n from the wrong end, and pb written without its decimal point in position 3 (line 25)."""
    rows = [
        one._replace(mm=455.0)
        if (one.plan, one.segment, one.position) == ("velocities", "pb", "3")
        else one
        for one in read_readings(CASES / "check" / "normal_from_the_wrong_end_sc.csv")
    ]
    report = check(read(CASES / "check" / "sc.toml"), rows)
    normal, slip = report.mistakes
    (line,) = (one.taken.line for one in report.readings if one.found == 455.0)
    assert line not in normal.lines
    wrong = {one.taken.line for one in report.readings if one.verdict == "wrong"}
    assert wrong == {*normal.lines, line}
    assert slip.lines == (line,)
    assert slip.says == "by itself pb (3) is off, too: its decimal point has perhaps slipped"
