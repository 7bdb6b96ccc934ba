"""Extreme positions: closed forms, brute force, and by which construction they are found."""

from __future__ import annotations

import cmath
import math
from pathlib import Path

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support import drives
from support.boards import recorded
from support.each import each
from support.examples import most
from support.gallery import SHEETS
from support.linkages import four_bar, slider_crank
from support.mechanisms import Sampled, mechanisms
from support.rows import apart, places, project_of

import graphic_tmm
from graphic_tmm.board.values import undefined
from graphic_tmm.chapters.kinematics.survey import survey
from graphic_tmm.errors import StructureError
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.mechanism.records import Drive, Extreme, Link, Mechanism, Row, Side
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.project import Project
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

WAYS = ("bottom", "left", "right", "top")


def operations(project: Project) -> list[str]:
    return [step.op.name for step in project.construction.steps if step.it.view == "extremes"]


def bearing(z: complex) -> float:
    return math.degrees(cmath.phase(z)) % 360


# closed forms, and the construction of the drawing board


@each("speed", [2.0, -2.0])
@each("sign", [1, -1])
@each("r, rod, e", [(0.3, 0.64, 0.0), (0.045, 0.18, -0.018), (0.1, 0.25, 0.1)])
def test_a_slider_is_extreme_where_crank_and_rod_are_in_line(
    r: float, rod: float, e: float, sign: int, speed: float
) -> None:
    far = complex(sign * math.sqrt((rod + r) ** 2 - e * e), e)
    near = complex(sign * math.sqrt((rod - r) ** 2 - e * e), e)
    ways = ("right", "left") if sign > 0 else ("left", "right")
    project = project_of(slider_crank(r, rod, e, sign=sign, drive=(speed, 0.0)), "B", ways[0], None)
    assert apart(project.coordinates[0], bearing(far)) < 1e-9
    assert apart(project.coordinates[-1], bearing(-near)) < 1e-9
    found = places(project, "B")
    assert abs(found[0] - far) < 1e-14
    assert abs(found[-1] - near) < 1e-14
    names = operations(project)
    assert names.count("total") == names.count("difference") == 1
    assert names.count("strike") == names.count("cut") == names.count("bearing") == 2
    assert "refine" not in names


def test_a_rod_shorter_than_the_crank_is_drawn_in_line_too() -> None:
    """The crank turns in part only; the slider's far position is on the line crank–rod all the same."""
    project = project_of(slider_crank(0.3, 0.2, 0.0), "B", "right")
    assert apart(project.coordinates[0], 0.0) < 1e-9
    assert "refine" not in operations(project)


@pytest.mark.slow
@each("speed", [2.0, -2.0])
@each("sign", [1, -1])
@each(
    "r, rod, s, c",
    [
        (0.02, 0.06, 0.045, 0.06 - 0.01j),
        (0.1, 0.35, 0.2, 0.4 + 0.05j),
        (0.1, 0.4, 0.3, -0.2 + 0.3j),
    ],
)
def test_a_rocker_is_extreme_where_crank_and_coupler_are_in_line(
    r: float, rod: float, s: float, c: complex, sign: int, speed: float
) -> None:
    mechanism = four_bar(r, rod, s, c, sign=sign, drive=(speed, 0.0))
    due = []
    for reach, away in ((rod + r, 1), (rod - r, -1)):
        # the triangle O C B: B to the left of O -> C for +1, as of A -> C
        cosine = (reach**2 + abs(c) ** 2 - s * s) / (2 * reach * abs(c))
        b = reach * cmath.rect(1.0, cmath.phase(c) + sign * math.acos(cosine))
        due.append((bearing(away * b), b))
    ways = sorted(WAYS)
    found = {}
    for way in ways:
        try:
            project = project_of(mechanism, "B", way)
        except StructureError as error:
            pytest.fail(f"{way}: {error}")
        if "refine" not in operations(project):
            found[way] = (project.coordinates[0], places(project, "B")[0])
            names = operations(project)
            assert names.count("strike") == 2
            assert names.count("cross") == 1
    assert len(found) >= 2
    for angle, place in found.values():
        assert any(apart(angle, a) < 1e-9 and abs(place - b) < 1e-13 for a, b in due)
    assert {min((0, 1), key=lambda k: apart(angle, due[k][0])) for angle, _ in found.values()} == {
        0,
        1,
    }


@pytest.mark.every
@pytest.mark.parametrize("speed", [1.0, -1.0])
@pytest.mark.parametrize(
    ("name", "r", "other"), [("windrower", None, "7*"), ("windrower-published", 0.1176, "6*")]
)
def test_the_rocker_of_the_windrower_is_extreme_where_the_crank_is_square_to_it(
    name: str, r: float | None, other: str, speed: float
) -> None:
    scene = read(SHEETS / name)
    mechanism = scene.mechanism
    turned = Mechanism(mechanism.frame, mechanism.links, Drive(1, speed * mechanism.drive.speed))
    project = recorded(turned, scene.row, plans=["positions"])
    half = math.asin((r or 0.48 * math.sin(math.radians(180 * 0.45 / 2.45) / 2)) / 0.48)
    assert apart(project.coordinates[0], -math.degrees(half)) < 1e-9
    assert apart(project.coordinates[-1], 180.0 + math.degrees(half)) < 1e-9
    names = operations(project)
    assert names.count("touch") == names.count("bearing") == 2
    assert "refine" not in names
    if speed > 0:
        assert project.names[-1] == other


# brute force


@pytest.mark.parametrize(
    ("name", "letter"),
    [("shaper", "D"), ("tangent-mechanism", "D"), ("toggle-press", "D"), ("crank-rocker", "E")],
)
@pytest.mark.parametrize("at", ["left", "right", "top", "bottom"])
def test_an_extreme_is_as_far_as_the_point_comes(name: str, letter: str, at: str) -> None:
    scene = read(SHEETS / name)
    tried = survey(scene.mechanism, dissect(scene.mechanism))
    mark = tried.positions.point(letter)
    angles, reading = tried.whole([mark])
    way = {"left": -1, "right": 1, "bottom": -1j, "top": 1j}[at]
    place = (np.ravel(reading[mark]) * np.conj(way)).real
    if np.ptp(place) < 1e-12:  # a slider does not move across its guide
        return
    project = project_of(scene.mechanism, letter, at)
    found = (places(project, letter)[0] * np.conj(way)).real
    assert found >= place.max() - 1e-13
    assert found <= place.max() + 1e-5 * np.ptp(place)
    # finer trial about the place found
    near = project.coordinates[0] + np.linspace(-0.2, 0.2, 4001)[None, :]
    fine = (np.ravel(tried.at(near, [mark])[mark]) * np.conj(way)).real
    assert abs(near[0, int(np.argmax(fine))] - project.coordinates[0]) < 2e-2
    assert found >= fine.max() - 1e-14 * (1 + np.abs(fine).max())
    assert angles.size > 1000


@pytest.mark.slow
@settings(max_examples=most(40), deadline=None)
@given(drawn=mechanisms(dyads=(1, 2)), at=st.sampled_from(WAYS))
def test_of_any_mechanism_the_extreme_is_as_far_as_the_point_comes(drawn: Sampled, at: str) -> None:
    letter = sorted(set(drawn.points) - set(drawn.mechanism.frame.points))[-1]
    try:
        project = project_of(drawn.mechanism, letter, at, count=1)
    except StructureError:
        return
    tried = survey(drawn.mechanism, dissect(drawn.mechanism))
    mark = tried.positions.point(letter)
    roots = [closing.root for closing in tried.positions.closings]
    _, reading = tried.whole([mark, *roots])
    whole = ~np.logical_or.reduce([undefined(reading[m])[0] for m in (mark, *roots)])
    way = {"left": -1, "right": 1, "bottom": -1j, "top": 1j}[at]
    place = np.where(whole, (np.ravel(reading[mark]) * np.conj(way)).real, -np.inf)
    found = (places(project, letter)[0] * np.conj(way)).real
    assert found >= place.max() - 1e-9 * np.nanmax(np.abs(reading[mark]))


def test_a_coupler_point_is_found_by_refining_and_says_so() -> None:
    project = project_of(
        four_bar(0.1, 0.35, 0.2, 0.4 + 0.05j, coupler={"E": 0.175 + 0.105j}), "E", "top"
    )
    assert operations(project) == ["refine", "advance"]
    (step,) = [s for s in project.construction.steps if s.op.name == "refine"]
    for language in ("en", "ru"):
        assert " E " in speaking(language)(step.op.sentence)
    # the closed loop at angles of its own: E is highest where no angle near it, nor any of a turn, is higher
    turn = np.radians(np.arange(0.0, 360.0, 0.02))
    a, c = 0.1 * np.exp(1j * turn), 0.4 + 0.05j
    away = np.abs(c - a)
    cosine = (0.35**2 + away**2 - 0.2**2) / (2 * 0.35 * away)
    along = (c - a) / away * (cosine + 1j * np.sqrt(1.0 - cosine**2))
    height = (a + (0.175 + 0.105j) * along).imag
    assert apart(project.coordinates[0], math.degrees(turn[int(np.argmax(height))])) < 0.02
    assert places(project, "E")[0].imag == pytest.approx(height.max(), abs=1e-7)


@pytest.mark.parametrize(("e", "at"), [(0.0, "top"), (-0.018, "top"), (-0.018, "bottom")])
def test_a_slider_on_a_level_guide_has_no_highest_position(e: float, at: str) -> None:
    with pytest.raises(StructureError, match="B moves neither up nor down"):
        project_of(slider_crank(0.045, 0.18, e), "B", at)


def test_a_link_that_stands_still_has_no_extreme_position() -> None:
    still = (Link(4, {"O": 0j, "D": 0.3 + 0j}), Link(5, {"C": 0j, "D": 0.3 + 0j, "E": 0.1 + 0.1j}))
    moving = four_bar(0.1, 0.35, 0.2, 0.4, coupler={"E": 0.175 + 0.105j})
    sided = Link(still[0].number, still[0].points, side=Side(1, ("O", "C")))
    mechanism = Mechanism(
        moving.frame,
        (*(replaced(link, "E", "F") for link in moving.links), sided, still[1]),
        moving.drive,
    )
    with pytest.raises(StructureError, match="E moves neither left nor right"):
        project_of(mechanism, "E", "left")


def replaced(link: Link, old: str, new: str) -> Link:
    """A link with one letter written otherwise."""
    points = {new if letter == old else letter: place for letter, place in link.points.items()}
    return Link(link.number, points, link.guides, link.slides, side=link.side)


def test_a_crank_that_does_not_turn_round_is_told_with_its_range(tmp_path: Path) -> None:
    """A rod shorter than the crank comes to sin φ = l/r, and the slider does not stand still there."""
    scene = tmp_path / "scene.toml"
    scene.write_text(
        """title = "T"
language = "en"
[frame]
O = [0, 0]
x = { through = [0, 0], angle = 0 }
[[link]]
number = 1
points = { O = [0, 0], A = [0.2, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.1, 0] }
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
[drive]
link = 1
speed = 5
zero = { point = "B", at = "left" }
""",
        encoding="utf-8",
    )
    with pytest.raises(StructureError) as refused:
        make(read(scene))
    told = str(refused.value)
    edge = math.degrees(math.asin(0.1 / 0.2))
    ranges = f"{180 - edge:.2f}° to {180 + edge:.2f}° and {360 - edge:.2f}° to {edge:.2f}°"
    assert f"group 2-3 assembles for crank angles {ranges} only" in told
    assert "B does not come to an extreme position at left" in told
    assert "change the lengths, or give zero as an angle" in told


def test_a_piston_that_nothing_moves_is_refused_without_a_warning() -> None:
    """A crank whose pin is so far off that the rod reaches the piston nowhere: the locomobile, O moved."""
    text = (SHEETS / "locomobile" / "scene.toml").read_text(encoding="utf-8")
    far = text.replace(
        'points = { O = [0, 0], A = ["R", 0] }', 'points = { O = [1e9, 0], A = ["R", 0] }'
    )
    assert far != text
    with pytest.raises(
        StructureError, match=r"B не приходит|B does not come to an extreme position"
    ):
        make(graphic_tmm.read(far))


# rows that are open: lengths, parts of a turn


def places_of(text: str, extra: str) -> tuple[Project, float]:
    """Return a scene as drawn with positions outside its row, and the coordinate of the last, m or degrees."""
    made = drives.scene(text.replace("[drive]", f"[drive]\nextra = {extra}"))
    assert made.mechanism is not None
    project = recorded(made.mechanism, made.row, plans=["positions", "velocities"])
    return project, project.coordinates[-1]


@pytest.mark.parametrize(
    ("text", "extra", "due"),
    [
        # the boom stands upright: GN² = OG² + ON²
        (drives.BOOM, '{ point = "C", at = "top" }', math.hypot(0.4, 0.5)),
        # the crank stands upright: OB² = AB² − OA²
        (drives.SLIDER, '{ point = "A", at = "bottom" }', math.sqrt(0.3**2 - 0.1**2)),
        # the piston of a rack: the crank has turned by s/40 mm
        (
            drives.RACK.replace('"120 mm"', '"220 mm"'),
            '{ point = "A", at = "left" }',
            0.04 * math.pi,
        ),
    ],
)
def test_an_extreme_between_two_lengths_is_where_its_closed_form_says(
    text: str, extra: str, due: float
) -> None:
    project, found = places_of(text, f"[{extra}]")
    assert abs(found - due) < 1e-12
    assert operations(project) == ["refine"]
    unit = [step.it.unit for step in project.construction.steps if step.op.name == "refine"]
    assert unit == ["m"]


def test_an_extreme_within_a_part_of_a_turn_is_the_one_of_that_part() -> None:
    project, found = places_of(drives.LEVER, '[{ point = "B", at = "right" }]')
    row = np.radians(np.linspace(20.0, 75.0, 200_001))
    a, c = 0.1 * np.exp(1j * row), 0.4
    reach = np.abs(c - a)
    turn = np.arccos((0.35**2 + reach**2 - 0.3**2) / (2 * 0.35 * reach))
    b = a + 0.35 * np.exp(1j * (np.angle(c - a) + turn))
    due = float(np.degrees(row[np.argmax(b.real)]))
    assert abs(found - due) < 1e-3
    assert 20.0 < found < 75.0
    assert project.names[-1] == "1*"


@pytest.mark.parametrize(
    ("text", "extra"),
    [
        (drives.BOOM, '{ point = "N", at = "right" }'),
        (drives.SLIDER, '{ point = "A", at = "top" }'),
        (drives.SLIDER, '{ point = "B", at = "right" }'),
        (drives.LEVER, '{ point = "A", at = "top" }'),
    ],
)
def test_a_point_that_goes_on_at_the_end_of_its_row_has_no_extreme_there(
    text: str, extra: str
) -> None:
    with pytest.raises(StructureError, match=r"extra: . does not turn back at .* goes on there"):
        places_of(text, f"[{extra}]")


def test_extremes_of_two_points_may_stand_in_one_interval() -> None:
    """Of the crank-slider's pin the top, of a point of its rod the top too: both between 3 and 4."""
    mechanism = slider_crank(0.1, 0.3)
    top, right = Extreme("A", "top"), Extreme("A", "right")
    project = recorded(mechanism, Row(4, 0, 10.0, (top, right, 95.0)), plans=["positions"])
    assert project.names == ("0", "1", "2", "3", "0*", "3*", "95°")
    assert project.coordinates[4:] == pytest.approx((90.0, 0.0, 95.0), abs=1e-9)
    both = recorded(mechanism, Row(2, 0, 10.0, (top, Extreme("A", "left"))), plans=["positions"])
    assert both.names == ("0", "1", "0*", "0**")
