"""What a student asks for, on any format, is drawn: in a sensible number of sheets, each view in its frame."""

from __future__ import annotations

import random
import re
from collections.abc import Callable
from itertools import combinations, product
from pathlib import Path

import numpy as np
import pytest
from support import asked
from support.command import invoke
from support.gallery import CASES
from support.mechanisms import sample
from support.scenes import written

from graphic_tmm.board.values import Point
from graphic_tmm.chapters.flywheel.plan import FLYWHEEL_PLAN
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.errors import SheetError
from graphic_tmm.fitting.sizes import sizes_of, usual
from graphic_tmm.fitting.tried import Mechanism
from graphic_tmm.fitting.views import drawing_of
from graphic_tmm.mechanism.records import Row
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.packing import GAP, bounds
from graphic_tmm.paper.sheet_frame import drawing_area
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.studio import composed_sheets, make, sheets

FORMATS = ("A4", "A1")
ROWS = (1, 6, 8, 12, 24, 48)
LEAST = {"A4": 60.0, "A1": 100.0}
"""The plan of positions is no smaller, mm."""
MEASURABLE = {"A4": 13.0, "A1": 24.0}
"""The longest vector is no shorter, mm: of 53 and 100 the least step, 0.5, and the widest gap of μ, a half."""
ROUNDING = 1e-6


def drawn(text: str, folder: Path) -> tuple[DrawnScene, tuple[Sheet, ...]]:
    path = written(folder, text)
    return sheets(read(path))


def in_frames(made: DrawnScene, paper: tuple[Sheet, ...]) -> None:
    """Every view stands inside its frame, clear of the title block and of the others."""
    for index, sheet in enumerate(paper):
        area = drawing_area(sheet.format, made.scene.language, index == 0)
        boxes = [bounds(view) for view in sheet.drawings[1:]]
        assert boxes, f"sheet {index + 1} is empty"
        for box in boxes:
            assert box[0] >= area.inner.left - ROUNDING
            assert box[1] >= area.inner.bottom - ROUNDING
            assert box[2] <= area.inner.right + ROUNDING
            assert box[3] <= area.inner.top + ROUNDING
        for one, other in combinations([*boxes, *area.occupied], 2):
            across = min(one[2], other[2]) - max(one[0], other[0])
            along = min(one[3], other[3]) - max(one[1], other[1])
            assert min(across, along) <= ROUNDING


def sensible(made: DrawnScene, paper: tuple[Sheet, ...]) -> None:
    """A view more than half as wide and half as high as a sheet may have one to itself: four times its area.

    The last sheet of each order may hold next to nothing.
    """
    for format in {sheet.format for sheet in paper}:
        area = drawing_area(format, made.scene.language, False)
        room = (area.inner.right - area.inner.left) * (area.inner.top - area.inner.bottom)
        there = [sheet for sheet in paper if sheet.format == format]
        boxes = [bounds(view) for sheet in there for view in sheet.drawings[1:]]
        taken = sum((box[2] - box[0] + GAP) * (box[3] - box[1] + GAP) for box in boxes)
        ordered = sum(order.format == format for order in made.scene.sheets)
        assert len(there) <= ordered + 4 * taken / room


def measurable(made: DrawnScene, format: str) -> None:
    """Plans of velocities and accelerations of 40 mm at least, the plan of positions of 60 or 100 mm.

    Where that saves a sheet a plan of vectors gives way, to what can still be measured.
    """
    work = made.mechanism
    if work is None:
        return
    placed = made.scene.shown_places
    for plan in {"velocities", "accelerations"} & placed:
        assert asked.longest(work, plan) >= MEASURABLE[format]
    if "positions" in placed:
        log = work.project.construction
        marks = [s.it for s in log.steps if s.it.view == "positions" and s.it.kind is Point]
        spots = np.concatenate([work.reading[mark][0] for mark in marks])
        # the circle of the crank pin may reach farther than the pin in few positions
        structure = KINEMATICS_PLAN.on(work).structure
        crank = KINEMATICS_PLAN.on(work).positions.bodies[structure.first.link].marks
        pin, pivot = crank[structure.first.pin], crank[structure.origin]
        arm = abs(work.reading[pin][0][0] - work.reading[pivot][0][0])
        reach = max(np.ptp(spots.real), np.ptp(spots.imag)) + 2 * arm
        assert reach >= LEAST[format]


def held(text: str, format: str, folder: Path) -> None:
    made, paper = drawn(text, folder)
    in_frames(made, paper)
    sensible(made, paper)
    measurable(made, format)


def orders(kind: str, place: str, format: str) -> list[tuple[str, tuple[str, ...]]]:
    return [(format, (*asked.WITH.get(place, ()), place))]


Way = tuple[str, int, bool, str]
"""A mechanism, positions, whether there are extra ones, a format."""


def every(place: str) -> list[Way]:
    """Every way to ask for a place."""
    ways = product(asked.MECHANISMS, ROWS, (False, True), FORMATS)
    return [way for way in ways if asked.can(way[0], place, way[1])]


def ask(place: str, way: Way, folder: Path) -> None:
    kind, count, extra, format = way
    ordered, language = orders(kind, place, format), ("ru", "en")[extra]
    held(asked.mechanism(kind, count, ordered, extra=extra, language=language), format, folder)


SMALL = [(place, way) for place in asked.PLACES for way in every(place) if way[1] <= 6]


@pytest.mark.parametrize(("place", "way"), random.Random(12).sample(SMALL, 3))
def test_what_is_asked_for_is_drawn(place: str, way: Way, tmp_path: Path) -> None:
    ask(place, way, tmp_path)


def by_turns(k: int) -> list[Way]:
    """Two ways to ask for a place, the k-th: both formats, both mechanisms if they can, rows by turns."""
    can, found = every(asked.PLACES[k]), []
    kinds = list(dict.fromkeys(way[0] for way in can))
    for turn, format in enumerate((FORMATS[k % 2], FORMATS[1 - k % 2])):
        kind = kinds[turn % len(kinds)]
        rows = [count for count in ROWS if any(way[:2] == (kind, count) for way in can)]
        found.append((kind, rows[(k + turn) % len(rows)], bool((k // 2 + turn) % 2), format))
    return found


def test_by_turns_every_place_meets_all_mechanisms_and_formats_and_they_all_rows() -> None:
    met = {place: by_turns(k) for k, place in enumerate(asked.PLACES)}
    for place, ways in met.items():
        assert set(ways) <= set(every(place))
        assert {way[0] for way in ways} == {way[0] for way in every(place)}
        assert {way[3] for way in ways} == set(FORMATS)
    ways = [way for some in met.values() for way in some]
    assert {way[:2] for way in ways} == set(product(asked.MECHANISMS, ROWS))
    assert {way[2:] for way in ways} == set(product((False, True), FORMATS))


@pytest.mark.turns(4)
@pytest.mark.slow
@pytest.mark.parametrize("k", range(len(asked.PLACES)), ids=asked.PLACES)
def test_everything_that_can_be_asked_for_is_drawn(
    k: int, tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    """Each place in two ways by turns; in all when measured."""
    for way in every(asked.PLACES[k]) if many(1, 0) else by_turns(k):
        ask(asked.PLACES[k], way, tmp_path)


@pytest.mark.turns(1)
@pytest.mark.parametrize(
    ("format", "language"), [pytest.param("A4", "en", marks=pytest.mark.slow), ("A1", "ru")]
)
@pytest.mark.parametrize(
    "kind", [pytest.param(k, marks=pytest.mark.slow) if k == "gears" else k for k in asked.PARTS]
)
def test_parts_are_drawn_on_any_format(
    kind: str, format: str, language: str, tmp_path: Path
) -> None:
    held(asked.part(kind, format, language=language), format, tmp_path)


SEVERAL = {
    "kinematics on one A4": ([("A4", ("positions", "velocities", "accelerations"))], "own"),
    "a common pole on A4": ([("A4", ("positions", "velocities", "velocity table"))], "common"),
    "A4 beside A1": (
        [
            ("A4", ("positions",)),
            ("A1", ("velocities", "accelerations")),
            ("A4", ("diagrams", "lever")),
        ],
        "own",
    ),
    "a standing A1": ([("A1 portrait", ("positions", "velocities", "results"))], "own"),
}


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("name", SEVERAL)
def test_several_places_and_several_formats_go_together(name: str, tmp_path: Path) -> None:
    sheets_, pole = SEVERAL[name]
    made, paper = drawn(asked.mechanism("six", 6, sheets_, pole=pole, extra=True), tmp_path)
    in_frames(made, paper)
    sensible(made, paper)
    ordered = [order.format for order in made.scene.sheets]
    assert list(dict.fromkeys(sheet.format for sheet in paper)) == list(dict.fromkeys(ordered))


MOST = {
    "bug-bell-crank-rocker": 1,
    "fails-a4-diagram": 11,
    "fails-a4-diagram-12": 6,
    "fails-a4-forces": 19,
    "fails-a4-table": 11,
    "fails-a4-table-12": 5,
    "fails-mixed-a4-a1": 2,
    "hydraulic": 7,
}
"""Sheets that a case takes at most: its plans of 40 mm with titles of 5 mm, figures and blocks of tables."""


ALL = sorted(path.stem for path in (CASES / "sheets").glob("*.toml"))
SHORT = ("bug-bell-crank-rocker", "fails-a4-table-12")
FEWER = {
    "hydraulic": ('[forces]\npositions = "all"', "[forces]\npositions = [1]"),
    "fails-a4-forces": ("[forces]\npositions = [2, 7]", "[forces]\npositions = [2]"),
}
"""Of how many positions forces are drawn, and of how many unless measured."""


@pytest.mark.turns(3)
@pytest.mark.parametrize(
    "name", [n if n in SHORT else pytest.param(n, marks=pytest.mark.slow) for n in ALL]
)
def test_scenes_that_were_refused_are_drawn(
    name: str, tmp_path: Path, many: Callable[[int, int], int]
) -> None:
    old, new = FEWER.get(name, ("", ""))
    text = (CASES / "sheets" / f"{name}.toml").read_text("utf-8")
    assert old in text
    made, paper = drawn(text if many(1, 0) else text.replace(old, new), tmp_path)
    in_frames(made, paper)
    sensible(made, paper)
    assert len(paper) <= MOST.get(name, len(paper))


def randomly(count: int, seed: int, format: str) -> None:
    places = ("positions", "velocities", "accelerations", "equations", "results", "structure")
    for k, one in enumerate(sample(count, seed)):
        row = Row(8, zero=one.phi, accelerations=("0", "2"))
        order = (SheetOrder(format, places),)
        made, paper = sheets(
            Scene(f"{k}", "T", ("ru", "en")[k % 2], one.mechanism, row, sheets=order)
        )
        in_frames(made, paper)
        sensible(made, paper)


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize(("format", "seeds", "told"), [("A1", 3, 100), ("A4", 1, 60)])
def test_random_mechanisms_are_not_refused_for_size(
    format: str, seeds: int, told: int, many: Callable[[int, int], int]
) -> None:
    for seed in range(7, 7 + many(seeds, 1)):
        randomly(many(told, 1), seed, format)


def test_one_position_of_a_slider_crank_stands_on_a4(tmp_path: Path) -> None:
    text = asked.mechanism("slider", 1, [("A4", ("positions",))], language="en")
    made, paper = drawn(text, tmp_path)
    in_frames(made, paper)
    assert len(paper) == 1


FIXED = {
    "mu_l = 3": ("scales.mu_l", "too small to measure"),
    "mu_l = 0.0001": ("scales.mu_l", "does not fit on A4"),
    'OA = "900 mm"': ("scales.OA", "does not fit on A4"),
    "mu_v = 500": ("scales.mu_v", "too small to measure"),
    'pa = "400 mm"': ("scales.pa", "does not fit on A4"),
    'pi_a = "0.1 mm"': ("scales.pi_a", "too small to measure"),
    'mu_l = 0.0018\nmu_v = "mu_l*omega1"': ("scales.mu_l", "does not fit on A4"),
}


@pytest.mark.turns(2)
@pytest.mark.slow
@pytest.mark.parametrize("scales", FIXED)
def test_a_fixed_scale_that_no_sheet_holds_is_told_with_a_value_that_fits(
    scales: str, tmp_path: Path
) -> None:
    places = [("A4", ("positions", "velocities", "accelerations"))]

    def text(lines: str) -> str:
        return asked.mechanism("slider", 4, places, scales=f"[scales]\n{lines}")

    with pytest.raises(SheetError) as told:
        drawn(text(scales), tmp_path)
    assert all(word in str(told.value) for word in FIXED[scales])
    assert re.search(r"\d mm", str(told.value))
    # what it says to write does fit, and can be measured
    (written,) = re.findall(r"write (\w+ = \"[^\"]+\")", str(told.value))
    others = [line for line in scales.splitlines() if line.split()[0] != written.split()[0]]
    made, paper = drawn(text("\n".join([written, *others])), tmp_path)
    in_frames(made, paper)
    if not others:
        measurable(made, "A4")


@pytest.mark.slow
@pytest.mark.parametrize("command", ["table", "steps"])
def test_no_command_reads_a_plan_that_is_too_small(command: str, tmp_path: Path) -> None:
    text = asked.mechanism("slider", 8, [("A4", ("positions",))], scales="[scales]\nmu_l = 3")
    path = written(tmp_path, text)
    result = invoke(command, path)
    assert result.exit_code == 2
    assert "scales.mu_l" in result.stderr


@pytest.mark.turns(1, "lengths")
@pytest.mark.slow
def test_lengths_that_a_scene_writes_are_kept(tmp_path: Path) -> None:
    """The base of graphs gives way to a narrow sheet, but not one that the file itself writes."""
    text = asked.mechanism("six", 6, [("A4", ("flywheel",))])
    shorter = read_of(text, tmp_path)
    assert 60.0 < base(shorter) < 120.0
    told = text.replace('D_e = "0.5 m"', 'D_e = "0.5 m"\nbase = "110 mm"\nH = "25 mm"')
    assert base(read_of(told, tmp_path)) == 110.0
    with pytest.raises(SheetError, match=r"flywheel.base"):
        drawn(told.replace('"110 mm"', '"300 mm"'), tmp_path)


@pytest.mark.turns(1, "lengths")
@pytest.mark.slow
def test_a_sheet_is_turned_that_holds_a_view_only_so(tmp_path: Path) -> None:
    """Graphs on a base of 160 mm, which the file writes, are wider than an A4 that stands."""
    text = asked.mechanism("six", 6, [("A4", ("flywheel",)), ("A4", ("positions",))])
    wide = text.replace('D_e = "0.5 m"', 'D_e = "0.5 m"\nbase = "160 mm"')
    made, found = composed_sheets(read(written(tmp_path, wide)))
    in_frames(made, found.sheets)
    assert [order.format for order in made.scene.sheets] == ["A4 landscape", "A4"]
    assert made.mechanism is not None
    assert base(made.mechanism) == 160.0
    assert any("A4 landscape" in remark for remark in made.scene.remarks)
    # every reader takes the scale factors of the sheet that is drawn, and so does its composition
    assert made.mechanism.scales.items() <= read_of(wide, tmp_path).scales.items()
    again = composed_sheets(read(written(tmp_path, wide)), found.composition)[1]
    assert again.composition == found.composition


@pytest.mark.turns(3)
@pytest.mark.slow
@pytest.mark.parametrize("kind", asked.MECHANISMS)
@pytest.mark.parametrize("place", ["flywheel", "forces", "engine", "diagrams"])
def test_a_board_knows_every_size_that_its_views_depend_on(
    kind: str, place: str, tmp_path: Path
) -> None:
    """Else they are measured once and never again, however large they are drawn."""
    if not asked.can(kind, place, 6):
        return
    scene = read(written(tmp_path, asked.mechanism(kind, 6, [("A4", (place,))])))
    board = Mechanism(scene)
    views = drawing_of(place)(board.draw(usual(scene)), False)
    assert {n for view in views for n in sizes_of(place, view.name, scene)} <= set(board.sizes)


def read_of(text: str, folder: Path) -> Drawn:
    path = written(folder, text)
    work = make(read(path)).mechanism
    assert work is not None
    return work


def base(work: Drawn) -> float:
    flywheel = FLYWHEEL_PLAN.on(work)
    assert flywheel is not None
    return float(work.reading[flywheel.base.length][0, 0])


@pytest.mark.turns(1, "lengths")
@pytest.mark.slow
def test_a_plan_that_the_ruler_makes_larger_is_held_too() -> None:
    """Near a singular position readings of 0.1 mm make a plan of accelerations three times as large."""
    one = sample(19, 9)[18]
    row = Row(12, zero=one.phi, accelerations=("0", "2"))
    order = SheetOrder("A4 landscape", ("positions", "velocities", "accelerations"))
    made, paper = sheets(Scene("", "T", "ru", one.mechanism, row, sheets=(order,)))
    in_frames(made, paper)
    exact = make(made.scene, exact=True).mechanism
    assert exact is not None
    assert made.mechanism is not None
    assert exact.scales == made.mechanism.scales
    assert asked.longest(made.mechanism, "accelerations") > 1.5 * asked.longest(
        exact, "accelerations"
    )
