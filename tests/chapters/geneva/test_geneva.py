"""A Geneva wheel as drawn: turned by its crank it never runs into pin or disc; entry, times, refusals."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from itertools import pairwise
from pathlib import Path

import numpy as np
import pytest
from shapely import LineString, Point, Polygon
from shapely.ops import polygonize, unary_union
from support.boards import in_usual_size

from graphic_tmm.chapters.geneva.ink import draw_wheel
from graphic_tmm.chapters.geneva.plan import GENEVA_PLAN
from graphic_tmm.chapters.geneva.table import results
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn, single
from graphic_tmm.errors import StructureError
from graphic_tmm.fitting.subjects import subject
from graphic_tmm.paper.drawing import Drawing, Stroke
from graphic_tmm.readers.findings import warnings
from graphic_tmm.scene.read import read

FINE = math.radians(0.5)
"""Arcs become chords of so much of their turn."""
SCENE = """title = "T"
language = "en"
units = "{units}"
[frame]
number = 4
O = [0, 0]
B = [{x}, {y}]
[[link]]
number = 1
points = {{ O = [0, 0], A = [{crank}, 0] }}
[[link]]
number = 2
points = {{ A = {pin} }}
slides = {{ on = 3, along = "BC", side = "+" }}
[[link]]
number = 3
points = {{ B = [0, 0], C = [0.1, 0] }}
[drive]
link = 1
{drive}
turns = "{turns}"
from = "{start} deg"
to = "{end} deg"
positions = 5
[geneva]
slots = {slots}
pins = {pins}
{more}
[[sheet]]
format = "A1"
"""


def wheel_of(
    folder: Path, slots: int, apart: complex, *, sense: int = 1, pins: int = 1, off: float = 1.0,
    beyond: float = 0.0, speed: float = 3.0, drive: str = "", pin: str = "[0, 0]", more: str = "",
    units: str = "SI",
) -> Drawn:  # fmt: skip
    """Draw a wheel; ``off``: the crank by its due length, ``beyond``: degrees more than the engagement."""
    half = 90.0 - 180.0 / slots + beyond
    middle = math.degrees(cmath.phase(apart))
    text = SCENE.format(
        x=repr(apart.real), y=repr(apart.imag), slots=slots, pins=pins, more=more, pin=pin,
        drive=drive or f'speed = "{speed!r} rad/s"', units=units,
        crank=repr(off * abs(apart) * math.sin(math.pi / slots)),
        turns="counterclockwise" if sense > 0 else "clockwise",
        start=repr(middle - sense * half), end=repr(middle + sense * half),
    )  # fmt: skip
    path = folder / "scene.toml"
    path.write_text(text, encoding="utf-8")
    (found,) = in_usual_size(read(path), exact=True).boards
    return found


def chords(stroke: Stroke) -> list[complex]:
    """The corners of a stroke, arcs as chords."""
    path = [*stroke.path, *stroke.path[:1]] if stroke.closed else stroke.path
    found = [complex(*path[0][:2])]
    for (x1, y1, bulge), (x2, y2, _) in pairwise(path):
        a, b = complex(x1, y1), complex(x2, y2)
        if bulge:
            turn = 4.0 * math.atan(bulge)
            centre = (b - a * cmath.exp(1j * turn)) / (1.0 - cmath.exp(1j * turn))
            count = math.ceil(abs(turn) / FINE)
            found += [
                centre + (a - centre) * cmath.rect(1.0, turn * k / count) for k in range(1, count)
            ]
        found.append(b)
    return found


def faces(view: Drawing, part: str) -> list[Polygon]:
    """What the heavy strokes of a part enclose, ends a thousandth of a mm apart joined."""
    lines = [
        LineString([(round(z.real, 3), round(z.imag, 3)) for z in chords(one)])
        for one in view.strokes
        if isinstance(one, Stroke) and one.part == part and one.pen == "main"
    ]
    return list(polygonize(unary_union(lines)))


def moved(shape: Polygon, about: complex, angle: float) -> Polygon:
    z = np.asarray(shape.exterior.coords) @ np.array([1.0, 1j])
    z = about + (z - about) * cmath.rect(1.0, angle)
    return Polygon(np.column_stack([z.real, z.imag]))


def turned_by(crank: complex, apart: complex) -> float:
    """The angle at which a pin stands, seen from the wheel's centre."""
    return cmath.phase(crank - apart)


CASES = [
    (3, 1, 1),
    (4, 1, 1),
    (4, 1, -1),
    (5, 1, 1),
    (6, 2, 1),
    (8, 1, -1),
    (12, 2, 1),
    (4, 3, 1),
    (18, 1, 1),
]


@pytest.mark.parametrize(("slots", "pins", "sense"), CASES)
def test_neither_pin_nor_disc_runs_into_the_wheel(
    tmp_path: Path, slots: int, pins: int, sense: int
) -> None:
    """Over a turn of the crank, the wheel turned by the pin as any slotted link, and standing between."""
    apart = cmath.rect(0.12, math.radians(25.0))
    drawn = wheel_of(tmp_path, slots, apart, pins=pins, sense=sense)
    wheel, has = GENEVA_PLAN.on(drawn), drawn.value
    view = draw_wheel(subject(drawn, ""), wheel)
    cross = max(faces(view, "wheel"), key=lambda one: one.area)
    centre = apart / abs(apart) * has(wheel.apart)
    crank, rim, size = has(wheel.crank), has(wheel.rim), has(wheel.pin)
    disc = faces(view, "disc")
    assert len(disc) == 1
    assert cross.area > 0.3 * math.pi * rim**2
    half = math.pi / 2.0 - math.pi / slots
    middle = cmath.phase(apart)
    entry = middle - sense * half
    seen = turned_by(cmath.rect(crank, entry), centre)
    # chords lie this far inside their arcs; rounded ends add their thousandth
    slack = max(crank, rim) * (1.0 - math.cos(FINE / 2.0)) + 2e-3
    for step in np.linspace(0.0, math.tau / pins, 181)[:-1]:
        angle = entry + sense * step
        pin = cmath.rect(crank, angle)
        carried = cmath.rect(crank, entry + sense * min(step, 2.0 * half))
        turned = turned_by(carried, centre) - seen
        at = moved(cross, centre, turned)
        spot = Point(pin.real, pin.imag).buffer(size - slack, 64)
        assert at.intersection(spot).area < 1e-9, step
        body = moved(disc[0], 0j, angle - entry).buffer(-slack)
        assert at.intersection(body).area < 1e-9, step
    pitch = -sense * math.tau / slots
    assert (turned - pitch + math.pi) % math.tau - math.pi == pytest.approx(0.0, abs=1e-6)


@pytest.mark.parametrize("sense", [1, -1])
@pytest.mark.parametrize(
    ("slots", "share", "fastest"), [(4, 0.25, 2.414), (6, 1 / 3, 1.0), (3, 1 / 6, 6.464)]
)
def test_known_wheels(tmp_path: Path, slots: int, share: float, fastest: float, sense: int) -> None:
    """The figures that books tabulate: share of motion (z − 2)/2z, sin/(1 − sin) of half a pitch."""
    drawn = wheel_of(tmp_path, slots, 0.1 + 0j, speed=math.tau, sense=sense)
    found = {name: value for name, (value, _) in single(results(drawn)).items()}
    assert found["geneva_share"] == pytest.approx(share, abs=1e-9)
    assert found["geneva_share_by_slots"] == pytest.approx(share, abs=1e-12)
    assert found["geneva_fastest"] == pytest.approx(fastest, abs=1e-3)
    assert found["geneva_engaged"] == pytest.approx(180.0 - 360.0 / slots, abs=1e-9)
    assert found["geneva_motion"] == pytest.approx(share, abs=1e-9)
    assert found["geneva_dwell"] == pytest.approx(1.0 - share, abs=1e-9)


def test_the_fastest_turning_is_that_of_the_plan(tmp_path: Path) -> None:
    """In the middle position the plan of velocities has the same ratio."""
    drawn = wheel_of(tmp_path, 5, 0.1 + 0.02j)
    speed = KINEMATICS_PLAN.on(drawn).velocities.rates[3]  # type: ignore[union-attr]
    ratio = abs(single(results(drawn))["geneva_fastest"][0])
    assert abs(drawn.reading.figure(speed)[0, 2]) / 3.0 == pytest.approx(ratio, rel=1e-9)


TIMES = {"geneva_motion", "geneva_dwell"}


@pytest.mark.parametrize(
    "drive", ['speed = "0 rad/s"', 'speed = "3 rad/s"\nacceleration = "2 rad/s2"']
)
def test_no_time_where_the_crank_turns_unevenly(tmp_path: Path, drive: str) -> None:
    found = results(wheel_of(tmp_path, 4, 0.1 + 0j, drive=drive))
    assert not TIMES & set(found)


@pytest.mark.parametrize(("slots", "pins"), [(3, 6), (4, 4), (4, 5), (6, 3), (10, 3)])
def test_no_dwell_where_pins_follow_each_other(tmp_path: Path, slots: int, pins: int) -> None:
    assert TIMES & set(results(wheel_of(tmp_path, slots, 0.1 + 0j, pins=pins))) == {"geneva_motion"}


@pytest.mark.parametrize(("slots", "pins"), [(3, 1), (4, 1), (6, 2), (12, 1)])
def test_the_disc_holds_the_wheel_in_the_dwell(tmp_path: Path, slots: int, pins: int) -> None:
    """While no pin is in a slot, the wheel cannot be turned by a degree either way but runs into the disc."""
    apart = 0.1 + 0.03j
    drawn = wheel_of(tmp_path, slots, apart, pins=pins)
    view = draw_wheel(subject(drawn, ""), GENEVA_PLAN.on(drawn))
    cross = max(faces(view, "wheel"), key=lambda shape: shape.area)
    (disc,) = faces(view, "disc")
    centre = apart / abs(apart) * drawn.value(GENEVA_PLAN.on(drawn).apart)
    engaged = math.pi - math.tau / slots
    # as drawn the pin enters, and the wheel stands as it did in the dwell before
    for share in (0.02, 0.5, 0.98):
        before = moved(disc, 0j, -share * (math.tau / pins - engaged))
        for side in (-1.0, 1.0):
            assert moved(cross, centre, side * math.radians(1.0)).intersection(before).area > 0.01


def said_of(drawn: Drawn) -> Iterator[str]:
    yield from (text for text in warnings(drawn, "en") if text.startswith("geneva"))


@pytest.mark.parametrize(
    ("case", "says"),
    [
        ({"off": 1.01}, "shock"),
        ({"pins": 5}, "before another has left"),
        ({"pins": 4}, "never stands"),
        ({"more": 'pin = "44 mm"\nlock = "40 mm"'}, "run into each other"),
        ({"more": 'lock = "20 mm"'}, "does not reach"),
        ({"more": 'pin = "50 mm"'}, "take a smaller pin, or give lock"),
        ({"more": 'pin = "120 mm"\nlock = "10 mm"'}, "wheel's centre"),
        ({"more": 'lock = "80 mm"'}, "change lock"),
    ],
)
def test_what_does_not_work_is_told(tmp_path: Path, case: dict[str, object], says: str) -> None:
    assert says in " ".join(said_of(wheel_of(tmp_path, 4, 0.1 + 0j, **case)))  # type: ignore[arg-type]


def test_a_disc_that_is_none_is_not_drawn(tmp_path: Path) -> None:
    for pin, drawn_disc in (("50 mm", False), ("10 mm", True)):
        drawn = wheel_of(tmp_path, 4, 0.1 + 0j, more=f'pin = "{pin}"')
        view = draw_wheel(subject(drawn, ""), GENEVA_PLAN.on(drawn))
        assert any(one.part == "disc" for one in view.strokes) is drawn_disc


def test_a_good_wheel_is_left_in_peace(tmp_path: Path) -> None:
    assert not list(said_of(wheel_of(tmp_path, 4, 0.1 + 0j)))


def test_sizes_are_printed_in_the_units_of_the_scene(tmp_path: Path) -> None:
    """A crank of 1.1·0.4·sin 45° m is 12.25 in."""
    drawn = wheel_of(tmp_path, 4, 0.4 + 0j, off=1.1, units="imperial")
    (shock,) = (text for text in warnings(drawn, "en-u-ms-ussystem") if "shock" in text)
    assert "12.25 in" in shock
    assert "11.14 in" in shock


def test_a_pin_at_the_side_of_its_slot_is_refused(tmp_path: Path) -> None:
    with pytest.raises(StructureError, match="middle of the slot"):
        wheel_of(tmp_path, 4, 0.1 + 0j, pin='[0, "8 mm"]')


def test_a_position_of_ones_own_beyond_the_engagement_is_told_by_its_key(tmp_path: Path) -> None:
    with pytest.raises(StructureError) as caught:
        wheel_of(tmp_path, 4, 0.1 + 0j, drive='speed = 3\nextra = ["60 deg"]')
    assert caught.value.keys == ("drive.extra",)
    assert "from =" not in str(caught.value)


def test_positions_beyond_the_engagement_are_refused(tmp_path: Path) -> None:
    """There the wheel stands, but a slotted link would turn back."""
    with pytest.raises(StructureError, match='from = "-45 deg", to = "45 deg"') as caught:
        wheel_of(tmp_path, 4, 0.1 + 0j, beyond=10.0)
    assert caught.value.keys == ("drive.from",)
