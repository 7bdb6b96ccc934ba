"""Whatever is wrong in whatever scene, by whatever amount: it is told in every form, without a fault."""

from __future__ import annotations

import math
import random

import pytest
from support.gallery import exact
from support.lessons_told import by
from support.reports import FORMS

from graphic_tmm.board.findings import step_number
from graphic_tmm.checking.cells import cells, points
from graphic_tmm.checking.lessons.lessons import Teacher
from graphic_tmm.checking.records import MISTAKE, UNKNOWN, WRONG, Judged, Likely, Report, Taken
from graphic_tmm.drawn import DrawnScene

TIMES = (0.0, -1.0, 0.3, 1.5, 10.0, 1e-9, 1e12, -1e300)
SCENES = ("engine", "windrower", "gear-pair", "planetary", "cam", "four-stroke", "scotch-yoke")


def any_reading(made: DrawnScene, chance: random.Random, line: int) -> Judged:
    """Return a wrong reading of any figure or point, blamed on any step of its plan or on none."""
    times, spots, due = chance.choice(TIMES), points(made), cells(made)
    key = chance.choice([*spots, *due])
    plan, segment, position = key
    step = ""
    if chance.random() < 0.6 and made.mechanism is not None:
        log = made.mechanism.construction
        some = [one for one in log.steps if one.it.view == plan] or list(log.steps)
        one = chance.choice(some)
        step = f"{step_number(log, one)} {one.it.name}"
    if key in spots and (key not in due or chance.random() < 0.5):
        at = spots[key] * times + complex(7.0, -3.0)
        taken, found, whole = Taken(*_in_turn(key), x=at.real, y=at.imag), abs(at), abs(spots[key])
        unit = "mm"
    else:
        cell = due[key]
        whole = cell.mm if cell.mm is not None else cell.value or 0.0
        unit, found = "mm" if cell.mm is not None else cell.unit, whole * times
        taken = Taken(plan, position, segment)
        more = {"mm": found} if cell.mm is not None else {"value": found, "unit": unit}
        taken = taken._replace(**more)
    off = found - whole
    own = chance.choice([None, off, math.nan])
    return Judged(taken._replace(line=line), found, whole, off, 1.0, 0.0, WRONG, unit, step, own)


def _in_turn(key: tuple[str, str, str]) -> tuple[str, str, str]:
    return key[0], key[2], key[1]


@pytest.mark.slow
@pytest.mark.parametrize("name", SCENES)
def test_anything_is_told(name: str) -> None:
    made, chance = exact(name), random.Random(name)
    teacher = Teacher(made)
    for _ in range(6):
        rows = tuple(any_reading(made, chance, line) for line in range(2, 10))
        log = chance.choice(made.boards).construction
        mark = chance.choice(log.steps).it
        finding = Likely("n", "it was", (3, 4), 8, 0.0, kind=chance.choice([MISTAKE, UNKNOWN]))
        finding = finding._replace(
            plan=mark.view, step=mark.letter, position=rows[0].taken.position
        )
        lessons = teacher.lessons(rows, (finding,), by(made))
        assert sum(one.names == (0,) for one in lessons) == 1
        scene = made.scene
        report = Report(name, scene.title, scene.language, "student", rows, (finding,), (), lessons)
        for form in FORMS:
            assert not {"nan", "inf", "-inf", "nan."} & set(form(report).split())
