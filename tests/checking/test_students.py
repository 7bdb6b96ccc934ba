"""A student who is not the package: without a slip he draws what it draws, on seven mechanisms."""

from __future__ import annotations

import numpy as np
import pytest
from support.another_hand import MACHINES as HANDED
from support.another_hand import POSITIONS, Pencil, sheets
from support.gallery import CASES
from support.students.drawing import Student
from support.students.early import EARLY
from support.students.kinds import AtStep, Kind
from support.students.late import LATE
from support.students.outside import OUTSIDE
from support.students.planting import Planted, plant
from support.students.records import CAM, EXACT, D, Hand
from support.students.writing import ALL, rows_of, scale_of

from graphic_tmm.checking.cells import cells, points
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make


@pytest.mark.parametrize("name", HANDED)
def test_his_steps_are_the_other_hands(name: str) -> None:
    """Two scripts of the same mechanism agree without the package."""
    pen = Pencil(np.random.default_rng(0), 0.0, swing=0.0, slip=0.0, pointing=0.0)
    drawn = Student(ALL[name], EXACT, 0).draw()
    for k, sheet in sheets(name, pen).items():
        page = drawn.pages[k]
        assert page.lengths == pytest.approx(sheet.lengths, abs=1e-9)
        assert page.rates == pytest.approx(sheet.rates, abs=1e-9)
        assert page.points == pytest.approx(sheet.points, abs=1e-9)
    assert len(drawn.pages) == POSITIONS


@pytest.mark.turns(2)
@pytest.mark.parametrize("name", ALL)
def test_what_he_draws_is_due(name: str) -> None:
    """To a millionth; curves through points, which he draws by eye, to a quarter of a millimetre."""
    made = make(read(CASES / "check" / f"{name}.toml"), exact=True)
    due, spots = cells(made), points(made)
    drawn = Student(ALL[name], EXACT, 0).draw()
    told = 0
    for k, page in enumerate(drawn.pages):
        for (plan, segment), mm in page.lengths.items():
            cell = due[plan, segment, str(k)]
            wanted = cell.mm or 0.0
            by_eye = 0.25 if plan == D and segment != "S" else 1e-6
            assert mm == pytest.approx(wanted if plan in (D, CAM) else abs(wanted), abs=by_eye)
            if cell.value is not None:
                scale = (
                    abs(cell.value) / abs(cell.mm) if cell.mm else scale_of(drawn, plan, segment)
                )
                assert scale_of(drawn, plan, segment) == pytest.approx(scale)
            told += 1
        for (plan, rate), value in page.rates.items():
            assert value == pytest.approx(due[plan, rate, str(k)].value, abs=1e-6)
        for (plan, letter), spot in page.points.items():
            assert abs(spot - spots[plan, letter, str(k)]) < 1e-6
    assert told >= 24


def drawn(kind: Kind, count: int = 1) -> list[Planted]:
    """So many drawings of a kind that show it, on the mechanisms that have its step."""
    found = []
    for k, machine in enumerate((*ALL, *ALL)):
        one = plant(kind, machine, 700 + k, ("points", "both")[k % 2])
        if one is not None and one.truths[0].shown:
            found.append(one)
        if len(found) == count:
            return found
    return found


@pytest.mark.slow
def test_every_kind_of_mistake_shows_somewhere() -> None:
    """At least 45 kinds that a grammar may hold, and 10 that it may not, on seven mechanisms."""
    unseen = [kind.name for kind in (*EARLY, *LATE, *OUTSIDE) if not drawn(kind)]
    assert not unseen
    assert len({kind.name for kind in (*EARLY, *LATE)}) >= 45
    assert 3 * len(LATE) >= len({*EARLY, *LATE})
    assert len({kind.name for kind in OUTSIDE}) >= 10


@pytest.mark.parametrize("kind", EARLY[:4], ids=lambda kind: kind.name)
def test_before_a_mistake_everything_is_drawn_as_the_honest_student_does(kind: AtStep) -> None:
    """The same slips, wherever the two agree: what differs is the mistake, and what follows from it."""
    (one,) = drawn(kind)
    truth = one.truths[0]
    due = rows_of(Student(ALL[one.machine], Hand(ruler=one.ruler), one.seed).draw(), one.mode)
    assert due.keys() == one.rows.keys()
    differs = [key for key in due if due[key] != one.rows[key]]
    assert differs
    assert all(key[1] == truth.position for key in differs) or not truth.position
    order = list(due)
    own = [key for key in order if (key[0], key[2]) in truth.places and key in differs]
    assert order.index(own[0]) == order.index(differs[0])
