"""Cylinders that swing as they are inked, on mechanisms drawn at random; their names."""

from __future__ import annotations

import cmath
import random
from itertools import combinations
from pathlib import Path

import numpy as np
import pytest
import shapely
from support.boards import drawn_of

from graphic_tmm.chapters.kinematics.ink_links import MAIN, LinksInk
from graphic_tmm.chapters.kinematics.scales import reaches
from graphic_tmm.chapters.kinematics.views import position_views, warned
from graphic_tmm.chapters.structure.table import link_name
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import SceneError
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.paper.drawing import Stroke
from graphic_tmm.paper.shapes import box
from graphic_tmm.readers.protocol import protocol
from graphic_tmm.readers.table import columns_of
from graphic_tmm.scene.read import read

TEXT = """
title = "Drawn at random"
language = "{language}"
[frame]
O = [0, 0]
C = [{x!r}, {y!r}]
[[link]]
number = 1
points = {{ O = [0, 0], A = [{r!r}, 0] }}
[[link]]
number = 2
points = {{ A = [0, {b!r}], S2 = [{s!r}, {b!r}] }}
slides = {{ on = 3, along = "z", side = "{side}", angle = {turn!r}{cylinder} }}
mass = 1.5
centre = "S2"
J = 0.01
[[link]]
number = 3
points = {{ C = [0, 0] }}
guides = {{ z = {{ through = [0, {h!r}], angle = 0 }} }}
[drive]
link = 1
speed = 7
positions = 7
accelerations = [1]
zero = {zero!r}
[[sheet]]
format = "A3"
place = ["positions", "velocities", "accelerations"]
"""


class Case:
    """A crank of r about O, a cylinder that swings about C, its axis h to the left of C, the pin on it."""

    def __init__(self, seed: int, cylinder: str, language: str = "en") -> None:
        pick = random.Random(seed)
        self.r = pick.uniform(0.03, 0.08)
        self.c = cmath.rect(self.r * pick.uniform(1.4, 6.0), pick.uniform(0.0, 2 * np.pi))
        self.h = pick.choice((0.0, pick.uniform(-0.4, 0.4) * (abs(self.c) - self.r)))
        self.side = pick.choice("+-")
        self.zero = pick.uniform(0.0, 360.0)
        turn = 0.0 if self.side == "-" else 180.0
        self.text = TEXT.format(
            language=language, x=self.c.real, y=self.c.imag, r=self.r, b=0.0, s=0.6 * self.r,
            h=self.h, side=self.side, turn=turn, zero=self.zero, cylinder=cylinder,
        )  # fmt: skip

    def drawn(self, folder: Path) -> Drawn:
        """Draw it."""
        path = folder / "scene.toml"
        path.write_text(self.text, encoding="utf-8")
        found: Drawn = drawn_of(read(path))
        return found

    def axis(self, k: int) -> tuple[complex, complex]:
        """Return the pin and the way from it to the cylinder at position ``k``, by trigonometry."""
        pin = cmath.rect(self.r, np.radians(self.zero + 360.0 * k / 7))
        to_pin = pin - self.c
        lean = np.arcsin(self.h / abs(to_pin))
        # the axis passes C at h to its left: pin − C = s·u + i·h·u, s of the sign of the side
        sign = 1.0 if self.side == "+" else -1.0
        u = to_pin / (sign * np.cos(lean) * abs(to_pin) + 1j * self.h)
        return pin, complex(-sign * u / abs(u))


@pytest.mark.parametrize("seed", range(12))
def test_the_piston_stays_in_its_tube_on_the_rod(seed: int, tmp_path: Path) -> None:
    case = Case(seed, ', cylinder = "gas"')
    drawn = case.drawn(tmp_path)
    mu = drawn.scales["positions"].value
    ink = LinksInk(drawn.construction, drawn.reading, reaches(drawn))
    long, rods = set[float](), set[float]()
    for k in range(7):
        heavy = [s for name in ink.names for s in ink.lines(name, k, MAIN)]
        heavy += ink.symbols(ink.names, k)
        (tube,) = (_corners(s) for s in heavy if s.part == "cylinder" and _count(s) == 4)
        (piston,) = (_corners(s) for s in heavy if s.part == "piston")
        (pin, way), first, last = case.axis(k), (tube[0] + tube[3]) / 2, (tube[1] + tube[2]) / 2
        pin, pivot = pin / mu, case.c / mu
        for end in (first, last):
            assert ((end - pin) / way).imag == pytest.approx(0.0, abs=1e-6)
        assert ((pin - pivot) / way).imag == pytest.approx(
            case.h / mu * (-1 if case.side == "+" else 1), abs=1e-6
        )
        assert 0.0 < ((first - pin) / way).real < ((last - pin) / way).real
        (rod,) = (
            s for s in heavy
            if isinstance(s, Stroke) and s.pen == "rod" and abs(_ends(s)[0] - pin) < 1e-6
            and abs(((_ends(s)[1] - pin) / way).imag) < 1e-6
            and ((_ends(s)[1] - pin) / way).real > 0
        )  # fmt: skip
        middle = sum(piston) / 4
        assert shapely.LineString(_xy(_ends(rod))).distance(shapely.Polygon(_xy(piston))) < 1e-6
        assert shapely.Polygon(_xy(tube)).contains(shapely.Polygon(_xy(piston)))
        assert ((middle - pin) / way).imag == pytest.approx(0.0, abs=1e-6)
        long.add(round(abs(last - first), 6))
        rods.add(round(abs(middle - pin), 6))
    assert len(long) == len(rods) == 1
    far = [abs(case.axis(k)[0] - case.c) for k in range(7)]
    stroke = (max(far) - min(far)) / mu
    assert min(long) > stroke


@pytest.mark.parametrize("seed", range(4))
def test_no_letter_stands_on_another_or_on_the_tube(seed: int, tmp_path: Path) -> None:
    drawn = Case(seed, ', cylinder = "oil"').drawn(tmp_path)
    (view,) = position_views(drawn, lettered=True)
    boxes = [box(label) for label in view.labels]
    for one, other in combinations(boxes, 2):
        assert one.intersection(other).area < 1e-9
    parts = {s.part for s in view.strokes}
    assert {"cylinder", "piston"} <= parts
    assert not parts & {"stone", "slider"}


def test_numbers_are_those_of_the_same_scene_with_a_stone(tmp_path: Path) -> None:
    both = [Case(3, text).drawn(tmp_path) for text in ("", ', cylinder = "oil"')]
    one, other = (
        [(c.segment, c.mm.tobytes(), c.value.tobytes()) for c in columns_of(d)] for d in both
    )
    assert one == other


@pytest.mark.parametrize(
    ("language", "names", "others"),
    [
        ("en", ("crank", "piston with rod", "cylinder"), ("rocker", "stone", "block")),
        ("ru", ("кривошип", "поршень со штоком", "цилиндр"), ("кулис", "камень", "камн")),
    ],
)
def test_links_are_called_what_they_are(
    language: str, names: tuple[str, ...], others: tuple[str, ...], tmp_path: Path
) -> None:
    for seed in range(4):  # an axis through the pivot, and one that passes it
        drawn = Case(seed, ', cylinder = "oil"', language).drawn(tmp_path)
        mechanism = drawn.scene.mechanism
        assert mechanism is not None
        structure = dissect(mechanism)
        called = [link_name(mechanism, structure, one, language) for one in mechanism.links]
        assert tuple(called) == names
        plans = [plan for plan in ("positions", "velocities", "accelerations") if drawn.of(plan)]
        told = " ".join(protocol(drawn, plans, None, language, why=True)).lower()
        assert told
        assert not [word for word in others if word in told]


def test_a_mass_centre_behind_the_pin_is_told(tmp_path: Path) -> None:
    case = Case(5, ', cylinder = "oil"')
    assert not list(warned(case.drawn(tmp_path), "en"))
    case.text = case.text.replace("S2 = [", "S2 = [-")
    (says,) = warned(case.drawn(tmp_path), "en")
    assert "its mass centre S2 lies behind the pin A" in says


def test_a_cylinder_is_a_link_that_moves(tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    text = Case(0, ', cylinder = "oil"').text.replace("on = 3", 'on = "frame"')
    path.write_text(text.replace('along = "z"', 'along = "OC"'), encoding="utf-8")
    with pytest.raises(SceneError, match="a cylinder is a link that moves"):
        read(path)


def _ends(stroke: Stroke) -> tuple[complex, complex]:
    (x, y, _), (a, b, _) = stroke.path[0], stroke.path[-1]
    return complex(x, y), complex(a, b)


def _count(stroke: object) -> int:
    return len(stroke.path) if isinstance(stroke, Stroke) and stroke.closed else 0


def _corners(stroke: object) -> list[complex]:
    assert isinstance(stroke, Stroke)
    return [complex(x, y) for x, y, _ in stroke.path]


def _xy(points: object) -> list[tuple[float, float]]:
    return [(z.real, z.imag) for z in points]  # type: ignore[attr-defined]
