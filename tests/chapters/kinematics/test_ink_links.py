"""Links of random mechanisms as they are inked on a sheet, against their poses by the vector loops."""

from __future__ import annotations

import math
from collections.abc import Callable, Iterable
from dataclasses import replace
from pathlib import Path
from tempfile import TemporaryDirectory

import numpy as np
import pytest
from support import gallery
from support.boards import drawn_of
from support.each import each
from support.gallery import CASES
from support.mechanisms import Sampled, sample
from support.oracle import OracleError
from support.rewritten import relettered, text_of
from support.scenes import written
from support.seen import CLOSE, Seen, judge

from graphic_tmm.chapters.kinematics.given import given
from graphic_tmm.chapters.kinematics.ink_links import HELD, MAIN, THROUGH, WIDTHS, LinksInk
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.scales import reaches
from graphic_tmm.errors import SheetError
from graphic_tmm.paper.drawing import Stroke
from graphic_tmm.readers.table import columns_of
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import SheetOrder
from graphic_tmm.studio import sheets

COUNT = 6
TAIL = '[hand]\nruler = "exact"\n[[sheet]]\nformat = "A1"\nplace = ["positions"]\n'


def look(drawn: Sampled, seed: int, folder: Path) -> Seen | None:
    """Draw a mechanism as a sheet; None where no sheet can hold it (its plan is as large as it likes)."""
    path = folder / "scene.toml"
    mechanism = relettered(drawn.mechanism, seed)
    path.write_text(text_of(mechanism, drawn.phi, COUNT, TAIL), encoding="utf-8")
    made, paper = sheets(read(path))
    assert made.mechanism is not None
    return Seen(made.mechanism, paper)


FEW = (0, 3, 5, 8, 9)
"""Of the random mechanisms some that have all kinds of groups, one to three of them."""


def run(numbers: Iterable[int], seed: int, folder: Path) -> tuple[int, int]:
    """Judge these of many mechanisms; return how many plans and positions were seen."""
    plans = positions = 0
    drawn_ = sample(max(numbers := tuple(numbers)) + 1, seed=seed)
    for k, drawn in ((k, drawn_[k]) for k in numbers):
        try:
            seen = look(drawn, seed + k, folder)
            judge(seen)
        except SheetError:
            continue
        except (AssertionError, OracleError) as error:
            raise AssertionError(f"mechanism {k} of seed {seed}: {error}") from error
        plans, positions = plans + 1, positions + len(seen.places)
    return plans, positions


@pytest.mark.slow
def test_random_links_are_inked_as_what_they_are(
    tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    numbers = FEW if many(0, 1) else range(370)
    plans, positions = run(numbers, 7, tmp_path)
    assert plans >= 0.95 * len(numbers)
    assert positions >= 2 * plans


def case(name: str) -> Seen:
    """Draw the positions of a case with an exact ruler, so that the vector loops close on its marks."""
    scene = read(CASES / "sheets" / f"{name}.toml")
    order = replace(scene.sheets[0], place=("positions",))
    made, paper = sheets(replace(scene, ruler=None, sheets=(order,)))
    assert made.mechanism is not None
    return Seen(made.mechanism, paper)


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize(
    "name", ["bug-bell-crank-rocker", "hydraulic", "rotary", "whitworth-pin-S"]
)
def test_mechanisms_that_were_drawn_as_others_are_themselves(name: str) -> None:
    judge(case(name))


def bar_of(seen: Seen, number: int, way: complex) -> list[float]:
    """Where the guide of a link begins and ends, along a direction in the link's own axes (mm)."""
    found = [
        sorted((seen.own(number, z, seen.main) / way).real for z in ends)
        for ends, links in seen.heavy.items()
        if number in links
        and abs(
            (
                (seen.own(number, ends[1], seen.main) - seen.own(number, ends[0], seen.main)) / way
            ).imag
        )
        < CLOSE
    ]
    return max(found, key=lambda ends: ends[1] - ends[0])


def test_a_slotted_arm_is_as_long_as_the_path_of_its_stone() -> None:
    seen = case("bug-bell-crank-rocker")
    low, high = bar_of(seen, 3, 1 + 0j)
    assert low == pytest.approx(0.0, abs=CLOSE)  # it begins at B; A stands 200 to 400 mm from there
    assert high - 0.4 / seen.mu == pytest.approx(9.0, abs=CLOSE)


def test_the_whole_path_is_covered_when_one_position_is_drawn() -> None:
    text = (CASES / "sheets" / "bug-bell-crank-rocker.toml").read_text(encoding="utf-8")
    seen = look_at(text.replace("positions = 8", "positions = 1").replace('"A4"', '"A1"'))
    _, high = bar_of(seen, 3, 1 + 0j)
    assert seen.main == 0  # OA stands square to OB: A is 316 mm from B there
    assert high - 0.4 / seen.mu == pytest.approx(9.0, abs=CLOSE)


def look_at(text: str) -> Seen:
    with TemporaryDirectory() as folder:
        path = Path(folder) / "scene.toml"
        path.write_text(text + '\n[hand]\nruler = "exact"\n', encoding="utf-8")
        made, paper = sheets(read(path))
    assert made.mechanism is not None
    return Seen(made.mechanism, paper)


@pytest.mark.slow
def test_a_detached_group_holds_the_same_links(tmp_path: Path) -> None:
    text = (CASES / "sheets" / "hydraulic.toml").read_text(encoding="utf-8")
    some = text.replace('[forces]\npositions = "all"', "[forces]\npositions = [1, 4, 9]")
    scene = read(written(tmp_path, some.partition("[[sheet]]")[0]))
    order = SheetOrder("A1", ("positions", "forces"))
    made, paper = sheets(replace(scene, ruler=None, sheets=(order,)))
    assert made.mechanism is not None
    seen, lengths = Seen(made.mechanism, paper), []
    reach = bar_of(seen, 3, 1 + 0j)
    arm = abs(seen.mechanism.by_number[3].points["D"]) / seen.mu
    for view in (d for s in paper for d in s.drawings if d.name.startswith("group-2-3")):
        straight = [
            abs(complex(*s.path[1][:2]) - complex(*s.path[0][:2]))
            for s in view.strokes
            if isinstance(s, Stroke) and s.pen in ("rod", "main") and len(s.path) == 2
            if s.part != "centre"
        ]
        lengths.append(sorted(straight))
    assert len(lengths) == len({1, 4, 9} & {*seen.places}) == 2
    larger = seen.mu / made.mechanism.scales["group 2-3"].value  # a group has a scale of its own
    guide = (
        larger * (reach[1] - reach[0] - THROUGH) + THROUGH
    )  # one end stands so far behind the stone
    due = sorted([larger * arm, guide])
    for found in lengths:  # the guide and the arm CD, and no line to the stone
        assert found == pytest.approx(due, abs=CLOSE)


def test_the_point_of_the_driving_link_under_a_stone_has_its_vector_and_its_row() -> None:
    made, _ = sheets(replace(read(CASES / "sheets" / "rotary.toml"), ruler=None))
    assert made.mechanism is not None
    rows = {(c.plan, c.segment): c for c in columns_of(made.mechanism)}
    for place, degrees in enumerate(made.mechanism.project.coordinates):
        x = 120.0 * math.cos(math.radians(degrees))
        reach = x + math.sqrt(x * x - 120.0**2 + 300.0**2)  # of A along the cylinder, mm
        due = 10 * math.pi * reach / 1000
        assert rows["velocities", "pa1"].value[0, place] == pytest.approx(due, rel=1e-9)
    x = 120.0 * math.cos(math.radians(60.0))
    reach = x + math.sqrt(x * x - 120.0**2 + 300.0**2)
    found = rows["accelerations", "πa1"].value[0, 2]
    assert found == pytest.approx((10 * math.pi) ** 2 * reach / 1000, rel=1e-9)


def test_a_helping_point_never_takes_a_letter_of_the_scene() -> None:
    seen = look_at(YOKE)
    judge(seen)
    body = KINEMATICS_PLAN.on(seen.work).positions.bodies[3]
    apart = seen.work.reading[body.marks["B′"]] - seen.work.reading[body.marks["B"]]
    assert np.abs(apart) * seen.mu == pytest.approx(0.05, rel=1e-9)


YOKE = """
title = "Yoke whose slot lies beside its points"
language = "en"
[frame]
O = [0, 0]
x = { through = [0, 0], angle = 0 }
[[link]]
number = 1
points = { O = [0, 0], A = [0.1, 0] }
[[link]]
number = 2
points = { A = [0, 0] }
slides = { on = 3, along = "y" }
[[link]]
number = 3
points = { B = [0, 0], "B′" = [0.05, 0] }
guides = { y = { through = [0.2, 0], angle = 80 } }
slides = { on = "frame", along = "x" }
[drive]
link = 1
speed = 10
positions = 6
[[sheet]]
place = ["positions"]
"""


def test_a_small_offset_has_no_filled_corner_over_its_pivot() -> None:
    """The cylinder's guide runs 3 mm off its pivot: a filled corner would hide the pair."""
    work = gallery.drawn("oscillating-cylinder", exact=True)
    ink = LinksInk(work.project.construction, work.reading, reaches(work))
    assert not ink.corners("3", 0)
    wide = gallery.drawn("shaper", exact=True)
    ink = LinksInk(wide.project.construction, wide.reading, reaches(wide))
    offs = [abs(bar.holder - bar.foot) for name in ink.names for bar in ink.bars(name, 0)]
    corners = [one for name in ink.names for one in ink.corners(name, 0)]
    assert len(corners) == sum(off >= HELD for off in offs)


@each("name", ["shaper", "oscillating-cylinder"])
def test_a_notch_is_as_wide_as_what_slides(name: str) -> None:
    """A slider, a stone, a piston: in thin positions a line across the guide, through its middle."""
    work = gallery.drawn(name, exact=True)
    ink, widths = LinksInk(work.project.construction, work.reading, reaches(work)), []
    for number in ink.names:
        signs = [s for s in ink.symbols([number], 2) if isinstance(s, Stroke)]
        boxes = [s for s in signs if s.part in WIDTHS and s.closed and len(s.path) == 4]
        for notch, box in zip(ink.notches(number, 2), boxes, strict=True):
            assert isinstance(notch, Stroke)
            start, end = (complex(x, y) for x, y, _ in notch.path)
            own = [(complex(x, y) - start) / (end - start) for x, y, _ in box.path]
            assert [min(z.real for z in own), max(z.real for z in own)] == pytest.approx([0.0, 1.0])
            assert min(z.imag for z in own) == pytest.approx(-max(z.imag for z in own))
            widths.append(abs(end - start))
    assert widths


@pytest.mark.parametrize("index", [0, 3, 7])
def test_the_mass_centre_of_a_rack_stands_on_its_rod(index: int) -> None:
    """The rack has no line of its own but that between its slider and its mass centre."""
    work = gallery.drawn("tangent-mechanism", exact=True)
    ink = LinksInk(work.project.construction, work.reading, reaches(work))
    (rod,) = (
        s
        for s in ink.symbols(["5"], index)
        if isinstance(s, Stroke) and s.part == "centre" and not s.closed
    )
    spots = [*ink.spots("5", index), *(ink.at(f.marks[0], index) for f in ink.of("5", "centre"))]
    assert rod.pen == "main"
    assert [complex(x, y) for x, y, _ in rod.path] == pytest.approx(spots)


def corners_of(stroke: Stroke) -> list[complex]:
    return [complex(x, y) for x, y, _ in stroke.path]


def test_arms_are_lines_from_their_weld_and_no_plate(tmp_path: Path) -> None:
    text = """title = "T"
language = "en"
[frame]
O = [0, 0]
y = { through = [0, 0], angle = 0 }
[[link]]
number = 1
points = { O = [0, 0], A = [0.08, 0] }
[[link]]
number = 6
weld = { to = 1, angle = "120 deg" }
points = { O = [0, 0], C = [0.06, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.25, 0] }
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "y", side = "right" }
[drive]
link = 1
speed = "60 rpm"
zero = "20 deg"
"""
    drawn = drawn_of(read(written(tmp_path, text)), exact=True)
    ink = LinksInk(drawn.construction, drawn.reading, reaches(drawn))
    marks = KINEMATICS_PLAN.on(drawn).positions.bodies[1].marks
    o, a, c = (ink.at(marks[letter], 0) for letter in "OAC")
    ends = [corners_of(one) for one in ink.lines("1", 0, MAIN) if isinstance(one, Stroke)]
    assert sorted(map(len, ends)) == [2, 2]
    for tip in (a, c):
        assert any({o, tip} == set(one) for one in ends)
    (corner,) = ink.corners("1", 0)
    assert corner.filled
    assert o in corners_of(corner)
    sizes = [one.symbol for one in given(drawn.scene)]
    assert {"l_{OA}", "l_{OC}", "α_{AOC}"} < set(sizes)
    assert "l_{AC}" not in sizes


@each("place, corners", [('["2 m", "0.3 m"]', "HO"), ('["1.9 m", "0.72 m"]', "HB")])
def test_a_pin_inside_a_plate_is_held_by_two_lines(
    tmp_path: Path, place: str, corners: str
) -> None:
    """By one it would be a further link; by two that lie in one line with it, none of the plate."""
    text = (gallery.SHEETS / "excavator" / "scene.toml").read_text(encoding="utf-8")
    drawn = drawn_of(read(written(tmp_path, text.replace('["2 m", "0.3 m"]', place))), exact=True)
    ink = LinksInk(drawn.construction, drawn.reading, reaches(drawn))
    marks = KINEMATICS_PLAN.on(drawn).positions.bodies[1].marks
    for k in range(4):
        first, last = (ink.at(marks[letter], k) for letter in corners)
        edge, held = (one for one in ink.lines("1", k, MAIN) if isinstance(one, Stroke))
        assert corners_of(held) == pytest.approx([first, ink.at(marks["N"], k), last])
        assert {*corners_of(edge)} == {ink.at(marks[letter], k) for letter in "OHB"}
