"""What an examiner looks for on a plan of positions: numbers of links and positions, names, full lines."""

from __future__ import annotations

import cmath
import math
import re
import tomllib
from functools import cache
from pathlib import Path

import pytest
import shapely
from hypothesis import given
from hypothesis import strategies as st
from support.boards import drawn_of, in_usual_size
from support.gallery import NAMES, SHEETS, drawn

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.kinematics import views
from graphic_tmm.chapters.kinematics.figures import CONTENTS
from graphic_tmm.chapters.kinematics.ink_numbers import CLOSE, together
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Drawing, Label, Stroke
from graphic_tmm.paper.shapes import box, shape
from graphic_tmm.readers.equations import equations
from graphic_tmm.scene.read import read

pytestmark = pytest.mark.every

SLIDER = """
title = "Slider"
language = "en"
[frame]
O = [0, 0]
x = {{ through = [0, 0], angle = 0 }}
[[link]]
number = 1
points = {{ O = [0, 0], A = [0.1, 0] }}
[[link]]
number = 2
points = {{ A = [0, 0], B = [{rod}, 0] }}
[[link]]
number = 3
points = {{ B = [0, 0] }}
slides = {{ on = "frame", along = "x", side = "+" }}
[drive]
link = 1
speed = 10
positions = 8
accelerations = {at}
{more}
"""


@cache
def plan(name: str) -> Drawing:
    (view,) = views.position_views(drawn(name), True)
    return view


def spot(work: Drawn, mark: Mark, k: int) -> complex:
    row = work.reading[mark][0]
    return complex(row[k if row.size > 1 else 0])


def middle(label: Label) -> complex:
    return complex(*box(label).centroid.coords[0])


def rings(view: Drawing) -> list[Stroke]:
    return [s for s in view.strokes if s.part == "number" and isinstance(s, Stroke) and s.closed]


def centre(ring: Stroke) -> complex:
    (a, b, _), (c, d, _) = ring.path
    return complex(a + c, b + d) / 2


@pytest.mark.turns(4)
@pytest.mark.parametrize("name", NAMES)
def test_every_link_bears_its_number_in_a_circle_that_nothing_crosses(name: str) -> None:
    view, mechanism = plan(name), KINEMATICS_PLAN.on(drawn(name)).mechanism
    found = [ring for ring in rings(view) if ring.pen == "thin"]
    labels = [
        next(one for one in view.labels if abs(middle(one) - centre(ring)) < 0.3) for ring in found
    ]
    links = (mechanism.frame, *mechanism.drawn)
    due = sorted(str(link.number) for link in links)
    assert sorted(label.text for label in labels) == due
    for ring, own in zip(found, labels, strict=True):
        disc = shapely.Polygon(shape(ring).coords)
        for stroke in view.strokes:
            if stroke.part != "number" and stroke.pen in ("main", "rod", "body", "joint"):
                assert not shape(stroke).intersects(disc), (own.text, stroke.part)
        for other in view.labels:
            assert other is own or not box(other).intersects(disc), (own.text, other.text)


@pytest.mark.parametrize("name", NAMES)
def test_the_line_from_a_number_ends_on_its_link(name: str) -> None:
    work, view = drawn(name), plan(name)
    main, frame = work.main, KINEMATICS_PLAN.on(work).mechanism.frame.number
    lines = [s for s in view.strokes if s.part == "number" and not s.closed]
    for ring in (one for one in rings(view) if one.pen == "thin"):
        label = next(one for one in view.labels if abs(middle(one) - centre(ring)) < 0.3)
        if label.text == str(frame):
            continue
        own = [s for s in lines if s.of == ring.of]
        links = [
            s
            for s in view.strokes
            if s.part in ("link", "slider", "stone", "cylinder") and s.position == main
        ]
        mine = [s for s in links if set(s.of) & set(ring.of) and len(set(s.of) - set(ring.of)) == 0]
        # a wheel without a line of its own bears its number on its circle
        mine = mine or [s for s in view.strokes if s.part == "wheel" and set(s.of) & set(ring.of)]
        near = min(
            shape(s).distance(shapely.Point(stroke.path[0][:2])) for s in mine for stroke in own
        )
        assert near < 0.01, label.text


@pytest.mark.parametrize("name", NAMES)
def test_the_arrow_of_the_crank_bears_its_letter(name: str) -> None:
    made = KINEMATICS_PLAN.on(drawn(name))
    labels = [one for one in plan(name).labels if one.text.startswith(("ω", "v_"))]
    moving = [pair for pair in made.pairs if pair.drive.speed]
    turning = [bool(pair.arm_ends(made.positions)) for pair in moving]
    own = (
        f"ω_{pair.link}" if turns else pair.speed_letter
        for pair, turns in zip(moving, turning, strict=True)
    )
    assert sorted(label.text for label in labels) == sorted(own)
    if turning == [True]:
        pivot = spot(drawn(name), made.led[0], 0)
        assert shapely.Point(pivot.real, pivot.imag).distance(box(labels[0])) < 20.0


@pytest.mark.parametrize("name", NAMES)
def test_a_guide_is_called_on_the_plan_as_in_the_equations(name: str) -> None:
    log = drawn(name).construction
    told = [one.directions for p in ("velocities", "accelerations") for one in equations(log, p)]
    names = set(re.findall(r"(\w+)–\1", " ".join(told)))
    texts = [label.text for label in plan(name).labels if label.size == 3.5]
    for guide in names:
        axis = any(f.kind in CONTENTS and f.marks[1].name == f"({guide})" for f in log.figures)
        assert texts.count(guide) == (1 if axis else 2), (
            guide
        )  # the axis of a cylinder: behind its tube


@pytest.mark.parametrize("name", NAMES)
def test_extreme_positions_are_drawn_in_full_line_and_no_others(name: str) -> None:
    text = tomllib.loads((SHEETS / name / "scene.toml").read_text(encoding="utf-8"))["drive"]
    text = text[0] if isinstance(text, list) else text
    count = text.get("positions", 12)
    due = {0} if isinstance(text.get("zero"), dict) else set()
    due |= {count + k for k, one in enumerate(text.get("extra", ())) if one == "other extreme"}
    full = {s.position for s in plan(name).strokes if s.part == "link" and s.pen == "medium"}
    assert full == due


def bare(text: str) -> str:
    """Numbers that stand behind the letter of their point, without it."""
    return re.sub(r"^[A-Z]_\{(\d.*)\}$", r"\1", text)


def told_by(text: str) -> list[str]:
    """The numbers on a label: "3…5, 9", bare or as the index of a letter, tells of 3, 4, 5 and 9."""
    ends = (part.split("…") for part in bare(text).split(", "))
    return [
        number
        for first, *last in ends
        for number in (map(str, range(int(first), int(last[0]) + 1)) if last else [first])
    ]


@pytest.mark.parametrize("name", NAMES)
def test_every_slider_bears_the_numbers_of_its_positions_where_it_stands(name: str) -> None:
    work, view = drawn(name), plan(name)
    main = work.main
    for one in (f for f in work.construction.figures if f.kind == "slider"):
        mark = one.marks[0]
        told = [
            one for one in view.labels if one.of == (mark.slot,) and bare(one.text)[0].isdigit()
        ]
        numbers = [part for label in told for part in told_by(label.text)]
        assert len(numbers) == len(set(numbers))
        pin = KINEMATICS_PLAN.on(work).led[1]
        for k, number in enumerate(work.names):
            at = spot(work, mark, k)
            lone = all(
                abs(at - spot(work, mark, j)) > CLOSE for j in range(len(work.names)) if j != k
            )
            clear = abs(at - spot(work, mark, main)) > 12.0 and abs(at - spot(work, pin, k)) > 12.0
            if lone and clear:
                assert number in numbers
        for label in told:
            for part in told_by(label.text):
                at = spot(work, mark, work.names.index(part))
                assert box(label).distance(shapely.Point(at.real, at.imag)) < 22.0


@pytest.mark.parametrize("name", NAMES)
def test_a_number_beside_a_path_stands_at_its_own_tick(name: str) -> None:
    """Seen along the guide no other position is nearer to it than its own ones."""
    work, view = drawn(name), plan(name)
    for one in (f for f in work.construction.figures if f.kind == "slider"):
        mark = one.marks[0]
        spots = {number: spot(work, mark, k) for k, number in enumerate(work.names)}
        ends = [*spots.values()]
        way = max((b - a for a in ends for b in ends), key=abs)
        way /= abs(way)
        told = [
            one for one in view.labels if one.of == (mark.slot,) and bare(one.text)[0].isdigit()
        ]
        numbered = {part for label in told for part in told_by(label.text)}
        for label in told:
            own = told_by(label.text)
            off = {n: abs(((middle(label) - spots[n]) / way).real) for n in numbered}
            leads = any(s.part == "leader" and s.of == label.of for s in view.strokes)
            if not leads:
                assert min(off[n] for n in own) <= min(off.values()) + 0.5, label.text
            high = max(abs(spots[a] - spots[b]) for a in own for b in own)
            assert high <= label.size, label.text


CASES = Path(__file__).parents[2] / "cases" / "sheets"


@pytest.mark.parametrize(
    ("file", "behind"),
    [
        (CASES / "whitworth-pin-S.toml", True),
        (SHEETS / "shaper" / "scene.toml", True),
        (SHEETS / "engine" / "scene.toml", False),
        (SHEETS / "windrower" / "scene.toml", False),
    ],
)
def test_numbers_stand_behind_letters_where_two_rows_share_a_field(
    file: Path, *, behind: bool
) -> None:
    """A₃ and C₃ in one circle: two rows of 0 … 11 within each other say nothing."""
    work = in_usual_size(read(file), exact=True).mechanism
    assert work is not None
    (view,) = views.position_views(work, True)
    pin = KINEMATICS_PLAN.on(work).led[1]
    told = [one.text for one in view.labels if pin.slot in one.of and re.search(r"\d", one.text)]
    numbered = [text for text in told if text.startswith(f"{pin.name}_{{")]
    assert len(numbered) == (len(work.names) if behind else 0)


def test_a_number_is_never_taken_for_a_point_of_that_name(tmp_path: Path) -> None:
    """Where a point is called C1 there is no C₁ for position 1."""
    text = (SHEETS / "shaper" / "scene.toml").read_text(encoding="utf-8")
    called = re.sub(r"\bS3\b", "C1", text)
    assert called != text
    file = tmp_path / "scene.toml"
    file.write_text(called, encoding="utf-8")
    work = in_usual_size(read(file), exact=True).mechanism
    assert work is not None
    (view,) = views.position_views(work, True)
    texts = [one.text for one in view.labels]
    assert texts.count("C_{1}") == 1
    assert not [text for text in texts if text.startswith("A_{")]


@given(st.lists(st.complex_numbers(max_magnitude=30.0), min_size=1, max_size=14))
def test_positions_share_a_number_only_within_its_height(spots: list[complex]) -> None:
    groups = together(spots, 3.5)
    assert sorted(k for group in groups for k in group) == [*range(len(spots))]
    for group in groups:
        assert all(abs(spots[a] - spots[b]) <= 3.5 + 1e-6 for a in group for b in group)


def test_positions_that_lie_alike_share_numbers_alike() -> None:
    """Farther from the pivot of a rocker 1 and 11 part from 0, not from each other."""
    angles = (0.0, 0.040, 0.047, 0.2)
    for radius in (20.0, 40.0, 70.0, 85.0):
        groups = together([radius * cmath.exp(1j * angle) for angle in angles], 3.5)
        assert [1, 2] in groups or [0, 1, 2] in groups


def made(tmp_path: Path, **said: object) -> Drawn:
    path = tmp_path / "scene.toml"
    path.write_text(SLIDER.format(**{"rod": 0.35, "at": "[]", "more": "", **said}), "utf-8")
    return drawn_of(read(path))


@pytest.mark.parametrize("at", ["[]", "[0]", "[0, 4]", "[0, 1]", "[3, 4]"])
@pytest.mark.parametrize("rod", [0.15, 0.35, 1.0])
def test_the_main_position_is_no_dead_centre(at: str, rod: float, tmp_path: Path) -> None:
    work = made(tmp_path, at=at, rod=rod)
    k = work.main
    phi = math.radians(work.project.coordinates[k] or 0.0)

    def travel(angle: float) -> float:
        return (0.1 * cmath.exp(1j * angle)).real + math.sqrt(rod**2 - (0.1 * math.sin(angle)) ** 2)

    speed = abs(travel(phi + 1e-6) - travel(phi - 1e-6)) / 2e-6
    assert speed > 0.3 * 0.1
    if at in ("[0, 1]", "[3, 4]") and rod > 0.2:
        assert work.names[k] in at  # one of those with a plan of accelerations, if it will do


def test_a_scene_may_name_the_main_position_itself(tmp_path: Path) -> None:
    work = made(tmp_path, more='[plans]\nmain = "4"')
    assert work.names[work.main] == "4"
