"""The figure of a planetary train reads its log: every step leaves ink, pictures add up to the view."""

from __future__ import annotations

import random
from collections.abc import Callable
from dataclasses import replace
from itertools import combinations
from pathlib import Path

import pytest
from support import train_oracle as oracle
from support.figures import assert_pictures_make_the_view, without_ink, without_source
from support.gallery import exact
from support.scenes import calling

from graphic_tmm.board.bounds import TaskError
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.record import Construction
from graphic_tmm.chapters.trains.ink import TRACELESS, Captions, draw_planetary_ink
from graphic_tmm.chapters.trains.ink_bevel import draw_bevel_ink
from graphic_tmm.chapters.trains.plan import draw_planetary
from graphic_tmm.chapters.trains.task import SCHEMES, PlanetaryTask
from graphic_tmm.chapters.trains.views import planetary_views
from graphic_tmm.errors import SheetError, StructureError
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.figure import pictures
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject
from graphic_tmm.paper.shapes import box, shape
from graphic_tmm.scene.read import read
from graphic_tmm.studio import composed_sheets

NONE, CAPTIONS = (
    Captions(),
    Captions(
        ("Planetary train", "μ_l = 0.0025 m/mm"),
        ("Picture of linear velocities", "μ_v = 0.025 (m/s)/mm"),
        (
            "Plan of angular velocities",
            "μ_ω = 0.3 (1/s)/mm",
            *["U_{1H} = 1 + z_3/z_1 = 1 + 72/24 = 4"] * 4,
        ),
    ),
)


def drawn(order: PlanetaryTask, captions: Captions = NONE) -> tuple[Construction, Drawing]:
    draft = Draft()
    made = draw_planetary(draft, order)
    log = draft.board.construction()
    reading = execute(log, draft.given)
    draw = draw_bevel_ink if SCHEMES[order.scheme].bevel else draw_planetary_ink
    view = draw(Subject(log, reading, "X"), made, captions)
    return log, finished(view)


def assert_laws(log: Construction, view: Drawing) -> None:
    assert not without_ink(log, [view], TRACELESS)
    assert not without_source(view)
    assert_pictures_make_the_view(log, view)


def test_steps_of_the_scene_are_its_ink() -> None:
    found = [work for work in exact("planetary").boards if "planetary" in work.recorded]
    assert found
    for work in found:
        (view,) = (one for one in planetary_views(work, True) if one.shows)
        assert_laws(work.construction, view)


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("scheme", oracle.SENSES)
def test_steps_of_random_trains_are_their_ink(scheme: str) -> None:
    draw = random.Random(scheme)
    for k in range(6):
        order = oracle.valid(draw, scheme)
        pair = (draw.randint(12, 40), draw.randint(12, 60)) if k % 2 else ()
        assert_laws(*drawn(replace(order, behind=(pair,) if pair else ())))


@pytest.mark.parametrize(
    "order",
    [
        PlanetaryTask("external", 0.005, 10.0, "H", teeth=(36, 45), satellites=(1,)),
        PlanetaryTask("internal", 0.005, (10.0, -4.0), ("1", "H"), teeth=(60, 24)),
        PlanetaryTask(
            "3K",
            0.005,
            10.0,
            teeth=(24, 30, 84, 18, 72),
            behind=((15, 25), (18, 20, 30)),
            before=((20, 30),),
        ),
        PlanetaryTask("3K", 0.005, 10.0, "3", "5", teeth=(24, 30, 84, 18, 72)),
        PlanetaryTask("bevel", 0.005, (10.0, -4.0), ("1", "H"), teeth=(20, 12, 20)),
        PlanetaryTask("bevel", 0.005, 10.0, "3", "H", teeth=(40, 50, 30), satellites=(3,)),
        PlanetaryTask("bevel-double", 0.005, 10.0, teeth=(20, 18, 24, 36)),
        PlanetaryTask(
            "ring", 0.005, 10.0, teeth=(24, 24, 72), closed=(("H", (36, 24)), ("3", (40, 20)))
        ),
        PlanetaryTask(
            "ring", 0.005, 10.0, teeth=(24, 24, 72), closed=(("1", (20, 60)), ("3", (60, 20, 30)))
        ),
    ],
)
def test_steps_of_all_other_trains_are_their_ink(order: PlanetaryTask) -> None:
    assert_laws(*drawn(order))


def test_letters_of_random_trains_stand_clear(many: Callable[[int, int], int]) -> None:
    """Of every scheme, any member standing, with rows outside: no letter on another, no caption on a line."""
    draw = random.Random("letters")
    closing = random.Random("closing letters")
    heavy, captions = ("main", "rod", "joint"), {line for lines in CAPTIONS for line in lines}

    def rows() -> tuple[tuple[int, ...], ...]:
        return tuple(
            tuple(draw.randint(14, 50) for _ in range(draw.choice((2, 2, 3))))
            for _ in range(draw.choice((0, 1, 2)))
        )

    done = 0
    while done < many(140, 14):
        scheme = [*SCHEMES][done % len(SCHEMES)]
        driving, fixed = draw.sample(SCHEMES[scheme].members, 2)
        if SCHEMES[scheme].bevel:
            z1, *rims = (draw.randint(14, 40) for _ in range(3))
            double = (z1, *rims, z1 + rims[1])
            teeth = double if scheme == "bevel-double" else (z1, rims[0], z1)
        else:
            teeth = oracle.random_teeth(draw, scheme)
        satellites = (draw.randint(1, 4),)
        order = PlanetaryTask(
            scheme, 0.005, 100.0, driving, fixed, teeth=teeth, satellites=satellites
        )
        order = replace(order, behind=rows(), before=rows())
        if scheme in oracle.SENSES and closing.random() < 0.5:
            pair = [
                (member, tuple(closing.randint(14, 50) for _ in range(closing.choice((2, 2, 3)))))
                for member in closing.sample(SCHEMES[scheme].members, 2)
            ]
            order = replace(order, fixed=None, behind=(), before=(), closed=tuple(pair))
        try:
            _, view = drawn(order, CAPTIONS)
        except (TaskError, StructureError):  # a shaft stands, or is no place for them
            continue
        done += 1
        boxes = [box(label) for label in view.labels]
        assert all(one.disjoint(other) for one, other in combinations(boxes, 2)), order
        for stroke in view.strokes:
            for label, one in zip(view.labels, boxes, strict=True):
                if stroke.pen in (*heavy, *["medium"] * (label.text in captions)):
                    assert one.disjoint(shape(stroke)), (order, label.text)


def test_a_plan_that_cannot_be_drawn_is_told_to_be_too_large(tmp_path: Path) -> None:
    """Velocities metres long: in some size points of the plan of rates stand nowhere."""
    text = (
        '[planetary]\nscheme = "ring"\nmodule = "5 mm"\nspeed = "100 rpm"\nteeth = [24, 24, 72]\n'
        'mu_v = "0.0001 (m/s)/mm"\npole = "2 mm"\n[[sheet]]\nformat = "auto"\nplace = ["planetary"]\n'
    )
    head = 'title = "T"\nlanguage = "en"\n'
    with pytest.raises(SheetError, match="does not fit on A1"):
        composed_sheets(read(calling(tmp_path, text, sheet="", head=head)))


def test_a_sheet_too_small_for_a_train_names_the_smallest_that_holds_it(tmp_path: Path) -> None:
    """On A4 wheels of 80 mm would be 8 mm large; on the A3 that is named they are not."""
    text = (
        '[planetary]\nscheme = "bevel"\nmodule = "4 mm"\nspeed = "200 rpm"\nteeth = [20, 20, 20]\n'
        'fixed = "H"\n[[sheet]]\nplace = ["planetary", "planetary given"]\nformat = '
    )
    head = 'title = "T"\nlanguage = "ru"\n'
    with pytest.raises(SheetError, match='a further sheet with format = "A3" for it'):
        composed_sheets(read(calling(tmp_path, text + '"A4"\n', sheet="", head=head)))
    made, _ = composed_sheets(read(calling(tmp_path, text + '"A3"\n', sheet="", head=head)))
    (board,) = made.boards
    assert 0.08 / board.scales["planetary"].value > 25.0


def test_the_train_is_drawn_step_by_step() -> None:
    log, view = drawn(PlanetaryTask("ring", 0.008, 302.4, teeth=(25, 32, 89), behind=((15, 25),)))
    made = pictures(log, view)
    order = [label.text for picture in made for label in picture.letters]
    assert order.index("A") < order.index("a") < order.index("P")
    again = [picture for picture in made if picture.again]
    assert {picture.position for picture in again} == {1, 2}, "the other satellites are repeated"
