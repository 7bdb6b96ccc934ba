"""Wheels before and behind a train: each pair rolls, wheels on one shaft turn as one."""

from __future__ import annotations

import math
import random
from collections.abc import Callable
from itertools import pairwise
from pathlib import Path

import pytest
from support.boards import in_usual_size, usual_part
from support.scenes import calling

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.trains.motion import motion_of
from graphic_tmm.chapters.trains.plan import PLANETARY_PLAN, draw_planetary
from graphic_tmm.chapters.trains.record import BESIDE
from graphic_tmm.chapters.trains.rows import rows_of
from graphic_tmm.chapters.trains.task import ASKED, SCHEMES, PlanetaryTask
from graphic_tmm.chapters.trains.task_sheet import scheme
from graphic_tmm.errors import SceneError
from graphic_tmm.paper.packing import bounds
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.read import read

HEAD = 'title = "T"\nlanguage = "en"\n'
TRAIN = '[planetary]\nscheme = "ring"\nmodule = "5 mm"\nspeed = "1440 rpm"\nteeth = [24, 24, 72]\n'


THREE = TRAIN.replace('"ring"', '"3K"').replace("[24, 24, 72]", "[24, 36, 96, 20, 80]")


def rolled(rows: tuple[tuple[int, ...], ...], omega: float) -> float:
    """The angular velocity of the last wheel: in each mesh both wheels have one speed, against each other."""
    for row in rows:
        for one, other in pairwise(row):
            omega = -omega * one / other
    return omega


def chain(draw: random.Random) -> tuple[tuple[int, ...], ...]:
    return tuple(
        tuple(draw.randint(12, 60) for _ in range(draw.choice((2, 2, 3, 4))))
        for _ in range(draw.randint(0, 3))
    )


def test_random_wheels_outside_roll(many: Callable[[int, int], int]) -> None:
    """Speeds through the rows before, the ratio of all; wheels touch, and rows share a shaft."""
    draw = random.Random("outside")
    for _ in range(many(120, 20)):
        before, behind = chain(draw), chain(draw)
        driving = draw.choice("1H")
        order = PlanetaryTask(
            "ring", 0.004, draw.uniform(-200.0, 200.0), driving, "3", teeth=(24, 24, 72),
            before=before, behind=behind,
        )  # fmt: skip
        draft = Draft()
        made = draw_planetary(draft, order)
        reading = execute(draft.board.construction(), draft.given)

        due = rolled(before, order.speed)  # type: ignore[arg-type]
        assert reading[made.rates.values[driving]].item() == pytest.approx(due, rel=1e-9)
        if made.pairs.ratio is None:
            assert not before
            assert not behind
            continue
        out = reading[made.rates.values[made.motion.driven]].item()
        whole = order.speed / rolled(behind, out)
        assert reading[made.pairs.ratio].item() == pytest.approx(abs(whole), rel=1e-9)
        mu = reading[made.mu].item()
        for view in made.pairs.outside:
            rows = rows_of(
                order, made.train.scheme, "before" if view.member == driving else "behind"
            )
            level = 0.0
            for row, discs in zip(rows, view.discs, strict=True):
                places = {name: [reading[m].item() for m in disc] for name, disc in discs.items()}
                radii = [z * 0.004 / 2 / mu for z in row.teeth]
                centres = [complex(places[name][2]) for name in row.names]
                assert centres[0].imag == pytest.approx(level, abs=1e-9)
                for k, radius in enumerate(radii):
                    near, far, centre = places[row.names[k]]
                    assert abs(near - centre) == pytest.approx(radius)
                    assert abs(far - centre) == pytest.approx(radius)
                    if k:
                        assert centres[k - 1] - centres[k] == pytest.approx(
                            1j * (radii[k - 1] + radius)
                        )
                level = centres[-1].imag


def test_the_last_wheel_turns_as_the_teeth_say(tmp_path: Path) -> None:
    """20/60, 24-24-72 and 15/25, 18/54 with an idler: 3·4·(5/3)·3 = 60, so 24 of 1440 rpm."""
    more = "before = [20, 60]\nbehind = [[15, 25], [18, 20, 54]]\n"
    file = calling(
        tmp_path, TRAIN + more + '[[sheet]]\nplace = ["planetary"]\n', sheet="", head=HEAD
    )
    drawn = usual_part("planetary", read(file))
    speed = BESIDE.on(drawn).speed
    assert speed is not None
    assert drawn.reading[speed].item() == pytest.approx(24.0, rel=1e-9)
    turns = {name: drawn.reading[mark].item() for name, mark in BESIDE.on(drawn).turns.items()}
    due = {"9": 1440, "10": -480, "1": -480, "2": 240, "H": -120, "4": -120, "5": 72, "6": 72}
    assert turns == pytest.approx(due | {"7": -64.8, "8": 24}, rel=1e-9)
    order = ASKED.of(drawn.scene)
    assert order is not None
    assert (order.before, order.behind) == (((20, 60),), ((15, 25), (18, 20, 54)))
    assert motion_of(order).driving["1"] == pytest.approx(-1440 / 3 * math.pi / 30)
    names = [row.names for row in rows_of(order, SCHEMES["ring"], "before")]
    assert names == [("10", "9")], "from the train outward"


def test_wheels_before_turn_as_given_whatever_the_ruler_reads(tmp_path: Path) -> None:
    """From 1000 rpm by 20/60 and 24-20-48 to −166.7 of the sun, which the plan gives as the ruler reads it."""
    more = 'before = [[20, 60], [24, 20, 48]]\n[[sheet]]\nplace = ["planetary"]\n'
    text = TRAIN.replace("1440", "1000") + more
    scene = read(calling(tmp_path, text, sheet="", head=HEAD))
    drawn = in_usual_size(scene).boards[0]
    turns = {name: drawn.reading[mark].item() for name, mark in BESIDE.on(drawn).turns.items()}
    due = {"4": 1000, "5": -1000 / 3, "6": -1000 / 3, "7": 400, "8": -1000 / 6}
    assert {name: turns[name] for name in due} == pytest.approx(due, rel=1e-12)
    assert turns["1"] == pytest.approx(-1000 / 6, rel=0.01)
    assert turns["1"] != pytest.approx(-1000 / 6, rel=1e-12)


@pytest.mark.parametrize("rows", [10, 11, 23])
def test_however_many_rows_are_drawn_and_called(rows: int, tmp_path: Path) -> None:
    """Each has its own point of contact; the last wheel turns (15/25)ⁿ times as fast as the carrier."""
    text = f'{TRAIN}behind = {[[15, 25]] * rows}\n[[sheet]]\nplace = ["planetary"]\n'
    drawn = usual_part("planetary", read(calling(tmp_path, text, sheet="", head=HEAD)))
    (outside,) = PLANETARY_PLAN.on(drawn).pairs.outside
    contacts = {next(iter(discs.values())).near.name for discs in outside.discs}
    assert len(contacts) == rows
    speed = BESIDE.on(drawn).speed
    assert speed is not None
    assert drawn.reading[speed].item() == pytest.approx(360.0 * 0.6**rows, rel=1e-9)
    assert captions("en")[f"planetary_n_{3 + 2 * rows}"] == f"n_{{{3 + 2 * rows}}}"


@pytest.mark.parametrize(
    ("more", "says"),
    [
        ("behind = [[15, 25], [18]]", "a pair has two wheels"),
        ("before = [20]", "a pair has two wheels"),
        ("before = [20, 0]", "pair that stands already"),
        ("before = [[20, 40], 3]", "pair that stands already"),
        (
            'driving = "3"\nfixed = "1"\nbefore = [20, 60]\nbehind = [15, 25]',
            "on one side of the train",
        ),
    ],
)
def test_what_is_no_pair_is_refused(more: str, says: str, tmp_path: Path) -> None:
    with pytest.raises(SceneError, match=says):
        read(calling(tmp_path, TRAIN + more + "\n", sheet="", head=HEAD))


@pytest.mark.parametrize("behind", ["[15, 25]", "[[15, 25], [18, 40]]", "[[15, 25], [18, 20, 40]]"])
@pytest.mark.parametrize(("train", "member"), [(TRAIN, "H"), (THREE, "5")])
def test_the_scheme_of_a_task_keeps_within_its_sheet(
    train: str, member: str, behind: str, tmp_path: Path
) -> None:
    text = f"{train}before = [20, 60]\nbehind = {behind}\n"
    scene = read(calling(tmp_path, text, sheet="", head=HEAD))
    room = complex(168.0, 92.0)
    shown = scheme(scene, room)
    assert shown is not None
    left, _, right, _ = bounds(shown.view)
    assert right - left <= 1.06 * room.real
    assert {"1", "2", member} <= {label.text for label in shown.view.labels}
