"""One wide satellite between wheels that differ by a few teeth: Ferguson's paradox, by teeth and by rolling."""

from __future__ import annotations

import random
from collections.abc import Callable
from fractions import Fraction as F
from pathlib import Path

import mpmath as mp  # type: ignore[import-untyped]
import pytest
from support.scenes import calling

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.trains.plan import draw_planetary
from graphic_tmm.chapters.trains.table import condition_table
from graphic_tmm.chapters.trains.task import PlanetaryTask
from graphic_tmm.chapters.trains.tooth_search import choose
from graphic_tmm.chapters.trains.tooth_verdicts import check
from graphic_tmm.errors import StructureError
from graphic_tmm.paper.formats import HEIGHTS
from graphic_tmm.readers.findings import warnings
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

NAME = "external-external"


def turned(order: PlanetaryTask) -> tuple[dict[str, float], float]:
    draft = Draft()
    made = draw_planetary(draft, order)
    reading = execute(draft.board.construction(), draft.given)
    values = {body: reading[mark].item() for body, mark in made.rates.values.items()}
    return values, reading[made.rates.due].item()


@pytest.mark.parametrize(("teeth", "due"), [(99, F(-100, 99)), (101, F(100, 101))])
def test_the_paradox_of_the_books(teeth: int, due: F) -> None:
    """Wheel 1 of 100 teeth stands, the arm turns at 100 rpm: 99 teeth creep back, 101 forward (Norton, 9.9)."""
    order = PlanetaryTask(NAME, 0.004, 100.0, "H", "1", teeth=(100, 20, 20, teeth), satellites=(1,))
    values, ratio = turned(order)
    assert values["4"] == pytest.approx(float(due), rel=1e-6)
    assert values["2"] == pytest.approx(600.0, rel=1e-9)
    assert ratio == pytest.approx(float(100 / due), rel=1e-9)


def clearance_taken(z1: int, z2: int, z4: int) -> mp.mpf:
    """x_Σ − y in modules, of 20°: α_w by the base circles, x_Σ by the thickness of teeth that fill the gaps."""
    with mp.workdps(30):
        alpha, axes, bases = (
            mp.radians(20),
            mp.mpf(z1 + z2) / 2,
            (z4 + z2) * mp.cos(mp.radians(20)) / 2,
        )
        if bases > axes:
            return mp.inf
        working = mp.acos(bases / axes)

        def left(shift: mp.mpf) -> mp.mpf:
            """What both teeth leave of the pitch on the circles that roll, in half modules there."""
            inv = mp.tan(working) - working - mp.tan(alpha) + alpha
            own = [(mp.pi / 2 + 2 * x * mp.tan(alpha)) / z - inv for z, x in ((z4, shift), (z2, 0))]
            return 2 * mp.pi - sum(2 * z * one for z, one in zip((z4, z2), own, strict=True))

        shift = mp.findroot(left, 0)
        return shift - (axes - mp.mpf(z4 + z2) / 2)


def test_random_wide_satellites_mesh_tooth_by_tooth(many: Callable[[int, int], int]) -> None:
    """Past the arm as many teeth of each wheel go by as of the satellite; refused where tips have no room."""
    draw, refused = random.Random("wide"), 0
    for _ in range(many(100, 20)):
        z1, z2 = draw.randint(30, 120), draw.randint(12, 40)
        z4 = z1 + draw.choice((-5, -4, -3, -2, -1, 1, 2, 3, 4, 5))
        driving, fixed = draw.sample(["1", "4", "H"], 2)
        order = PlanetaryTask(
            NAME, 0.003, 50.0, driving, fixed, teeth=(z1, z2, z2, z4), satellites=(1,)
        )
        if not 0 <= clearance_taken(z1, z2, z4) <= 0.25:
            refused += 1
            with pytest.raises(StructureError, match="another distance of the axes"):
                choose(order)
            continue
        values, _ = turned(order)
        omega = {"1": 0.0, "4": 0.0, "H": 0.0} | values
        passed = {name: omega[name] - omega["H"] for name in ("1", "2", "4")}
        most = max(abs(z * passed[name]) for name, z in (("1", z1), ("2", z2), ("4", z4)))
        assert z1 * passed["1"] == pytest.approx(-z2 * passed["2"], abs=1e-7 * most)
        assert z4 * passed["4"] == pytest.approx(-z2 * passed["2"], abs=1e-7 * most)
    assert 0 < refused < many(100, 20)


def test_the_shift_is_told_and_the_train_drawn(tmp_path: Path) -> None:
    section = (
        f'[planetary]\nscheme = "{NAME}"\nmodule = "4 mm"\nspeed = "100 rpm"\ndriving = "H"\n'
        'fixed = "1"\nteeth = [100, 20, 20, 99]\nsatellites = 1\n'
    )
    scene = read(calling(tmp_path, section, sheet="", head='title = "T"\nlanguage = "en"\n'))
    (board,) = make(scene, exact=True).boards
    (only,) = [str(one) for one in warnings(board)]
    assert "99 + 20 = 119: wheel 4 is cut with a shift" in only
    made = board.recorded["planetary"]
    assert all(one.holds for one in check(made.order, made.train))
    view = condition_table(board.construction, board.reading, made, "en", HEIGHTS["A1"])
    assert any("≠ a_w" in label.text for label in view.labels)


@pytest.mark.parametrize(
    "teeth",
    [
        (100, 20, 20, 95),
        (100, 20, 20, 104),
        (100, 20, 20, 70),
        (100, 20, 20, 140),
        (100, 20, 21, 97),
        (30, 20, 21, 28),
    ],
)
def test_what_no_shift_makes_up_for_is_refused(teeth: tuple[int, ...]) -> None:
    order = PlanetaryTask(NAME, 0.004, 100.0, "H", "1", teeth=teeth, satellites=(1,))
    with pytest.raises(StructureError, match="another distance of the axes"):
        choose(order)
