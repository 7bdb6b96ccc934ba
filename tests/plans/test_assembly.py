"""Whether lengths assemble, over which part of the turn, and where a side cannot hold."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from mechanisms import Drawn, mechanisms
from oracle import poses_from_points, solve_fast

from graphic_tmm.board.execute import execute
from graphic_tmm.errors import StructureError, TmmError
from graphic_tmm.mechanism.records import (
    Drive,
    Extreme,
    Guide,
    Link,
    Mechanism,
    Row,
    Side,
    Slide,
)
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.plans.assembly import Assembly, check_assembly
from graphic_tmm.plans.project import Project, draw_project
from graphic_tmm.plans.survey import survey
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.studio import sheets, warnings, work

Flips = tuple[float, ...] | None
Pose = tuple[float, float, float]


def four_bar(
    r: float,
    l: float,
    s: float,
    d: float,
    *,
    sign: int = 1,
    flips: Flips = None,
    speed: float = 1.0,
) -> Mechanism:
    """Crank r, coupler l, rocker s, frame d along x; B to the left of AC for +1."""
    return Mechanism(
        Link(0, {"O": 0j, "C": complex(d, 0)}),
        (
            Link(1, {"O": 0j, "A": complex(r, 0)}),
            Link(2, {"A": 0j, "B": complex(l, 0)}, side=Side(sign, ("A", "C"), flips)),
            Link(3, {"C": 0j, "B": complex(s, 0)}),
        ),
        Drive(1, speed),
    )


def slider_crank(
    r: float, l: float, e: float = 0.0, *, sign: int = 1, flips: Flips = None, speed: float = 1.0
) -> Mechanism:
    guide = Guide("x", complex(0, e), 0.0)
    return Mechanism(
        Link(0, {"O": 0j}, (guide,)),
        (
            Link(1, {"O": 0j, "A": complex(r, 0)}),
            Link(2, {"A": 0j, "B": complex(l, 0)}),
            Link(3, {"B": 0j}, slides=(Slide(0, guide, side=Side(sign, flips_at=flips)),)),
        ),
        Drive(1, speed),
    )


def coulisse(
    r: float, c: complex, h: float = 0.0, *, sign: int = 1, flips: Flips = None, speed: float = 1.0
) -> Mechanism:
    """Crank r, rocker about c, its guide h off the pivot."""
    guide = Guide("z", complex(0, h), 0.0)
    return Mechanism(
        Link(0, {"O": 0j, "C": c}),
        (
            Link(1, {"O": 0j, "A": complex(r, 0)}),
            Link(2, {"A": 0j}, slides=(Slide(3, guide, side=Side(sign, flips_at=flips)),)),
            Link(3, {"C": 0j, "D": 0.5 + 0.1j}, (guide,)),
        ),
        Drive(1, speed),
    )


def assembly(mechanism: Mechanism) -> Assembly:
    return check_assembly(survey(mechanism, dissect(mechanism)))


def message(mechanism: Mechanism) -> str:
    with pytest.raises(StructureError) as caught:
        assembly(mechanism)
    return str(caught.value)


def places(project: Project, letter: str) -> np.ndarray:
    """Places (m) of a letter in all positions."""
    mark = project.positions.point(letter)
    given_ = project.given | {project.mu_l: 1.0}
    return np.ravel(execute(project.construction, given_, [mark])[mark])


def scene(mechanism: Mechanism, row: Row | None = None) -> Scene:
    return Scene(
        "", "Test", "en", mechanism, row or Row(12, accelerations=("1",)), sheets=(SheetOrder(),)
    )


# lengths that never assemble


def _named(text: str) -> tuple[float, float]:
    """The mm that are short, and the crank angle, in a message."""
    found = re.search(r"short by ([\d.e+-]+) mm at the best crank angle, ([\d.e+-]+)°", text)
    assert found is not None, text
    return float(found[1]), float(found[2])


def test_a_coupler_and_rocker_too_short_are_named_with_what_is_short() -> None:
    # C off the x axis, so that the best angle lies between the angles tried
    mechanism = four_bar(0.1, 0.15, 0.12, 0.5)
    frame = Link(0, {"O": 0j, "C": cmath.rect(0.5, math.radians(20.1234))})
    text = message(Mechanism(frame, mechanism.links, mechanism.drive))
    assert "group 2-3 never assembles" in text
    assert "together are too short" in text
    assert "AB (link 2) or CB (link 3)" in text
    turn = np.radians(np.linspace(0, 360, 360001))
    short = np.min(np.abs(frame.points["C"] - 0.1 * np.exp(1j * turn))) - 0.27
    assert _named(text)[0] == pytest.approx(short * 1000, rel=1e-3)
    assert _named(text)[1] == pytest.approx(20.1234, abs=6e-3)


def test_a_coupler_too_long_is_named_with_what_differs() -> None:
    text = message(four_bar(0.1, 0.9, 0.12, 0.5))
    assert "group 2-3 never assembles" in text
    assert "differ too much" in text
    short = (0.9 - 0.12) - (0.5 + 0.1)
    assert _named(text)[0] == pytest.approx(short * 1000, rel=1e-3)


def test_a_rod_too_short_for_its_guide_names_rod_and_guide() -> None:
    text = message(slider_crank(0.05, 0.1, 0.3))
    assert "group 2-3 never assembles" in text
    assert "AB (link 2) or the guide x (link 0)" in text
    assert _named(text) == pytest.approx((150.0, 90.0), rel=1e-3)


def test_a_stone_too_near_its_rockers_pivot_is_named() -> None:
    text = message(coulisse(0.1, 0.3 + 0j, 0.5))
    assert "group 2-3 never assembles" in text
    assert "guide z" in text
    assert _named(text)[0] == pytest.approx(100.0, rel=1e-3)


def test_the_second_group_is_named_where_the_first_one_assembles() -> None:
    first = four_bar(0.1, 0.4, 0.3, 0.45)
    guide = Guide("y", 3 + 0j, 90.0)
    text = message(
        Mechanism(
            Link(0, first.frame.points, (guide,)),
            (
                *first.links,
                Link(4, {"B": 0j, "D": 0.2 + 0j}),
                Link(5, {"D": 0j}, slides=(Slide(0, guide, side=Side(1)),)),
            ),
            first.drive,
        )
    )
    assert "group 4-5 never assembles" in text
    assert "BD (link 4)" in text


@settings(max_examples=40, deadline=None)
@given(st.floats(0.05, 0.3), st.floats(0.05, 0.3), st.floats(0.05, 0.3), st.floats(0.31, 1.0))
def test_what_is_short_equals_brute_force(r: float, l: float, s: float, d: float) -> None:
    mechanism = four_bar(r, l, s, d)
    reach = (d - r, d + r)
    short = max(reach[0] - (l + s), abs(l - s) - reach[1])
    if short > 1e-6:
        assert _named(message(mechanism))[0] == pytest.approx(short * 1000, rel=1e-3)
    elif short < -1e-6:
        try:
            assembly(mechanism)
        except StructureError as error:
            assert "change point" in str(error)  # noqa: PT017


# lengths that assemble over a part of the turn


def _brute(
    mechanism: Mechanism, r: float, l: float, s: float, d: float
) -> list[tuple[float, float]]:
    """The ranges of a four-bar's crank by law of cosines: cos φ between two bounds."""
    far = (r * r + d * d - (l + s) ** 2) / (2 * r * d)
    near = (r * r + d * d - (l - s) ** 2) / (2 * r * d)
    low = 0.0 if near >= 1 else math.degrees(math.acos(near))
    high = 180.0 if far <= -1 else math.degrees(math.acos(far))
    if low == 0.0:
        return [(360 - high, 360 + high)]
    if high == 180.0:
        return [(low, 360 - low)]
    return [(low, high), (360 - high, 360 - low)]


@pytest.mark.parametrize(
    "lengths",
    [
        (0.3, 0.22, 0.25, 0.35),
        (0.3, 0.5, 0.15, 0.4),
        (0.4, 0.35, 0.2, 0.3),
        (0.5, 0.25, 0.35, 0.3),
        (0.3, 0.25, 0.36, 0.8),
    ],
)
def test_the_range_of_the_crank_is_right_to_a_hundredth_of_a_degree(
    lengths: tuple[float, float, float, float],
) -> None:
    mechanism = four_bar(*lengths)
    found = assembly(mechanism)
    due = _brute(mechanism, *lengths)
    assert found.groups == ("2-3",)
    assert len(found.ranges) == len(due)
    for ours, theirs in zip(sorted(found.ranges), sorted(due), strict=True):
        assert ours == pytest.approx(theirs, abs=1e-6)


def test_an_offset_slider_with_a_short_rod_names_its_two_ranges() -> None:
    found = assembly(slider_crank(0.1, 0.08, 0.01))
    up = math.degrees(math.asin(0.09 / 0.1))
    down = math.degrees(math.asin(0.07 / 0.1))
    assert sorted(found.ranges) == [
        pytest.approx((180 - up, 180 + down), abs=1e-6),
        pytest.approx((360 - down, 360 + up), abs=1e-6),
    ]


def test_a_range_narrower_than_the_angles_tried_is_found() -> None:
    r, l, s = 0.1, 0.2, 0.15
    d = r + l + s - 1e-8
    mechanism = four_bar(r, l, s, d)
    turned = Link(0, {"O": 0j, "C": cmath.rect(d, math.radians(33.1))})
    found = assembly(Mechanism(turned, mechanism.links, mechanism.drive))
    half = _brute(mechanism, r, l, s, d)[0][1] - 360.0
    assert half < 0.125
    assert len(found.ranges) == 1
    assert found.ranges[0] == pytest.approx((33.1 - half, 33.1 + half), abs=1e-5)


def test_a_gap_narrower_than_the_angles_tried_is_found() -> None:
    r, l, s = 0.1, 0.2, 0.25
    d = l + s - r + 1e-8
    mechanism = four_bar(r, l, s, d)
    turned = Link(0, {"O": 0j, "C": cmath.rect(d, math.radians(33.1))})
    found = assembly(Mechanism(turned, mechanism.links, mechanism.drive))
    assert found.groups == ("2-3",)
    half = 180.0 - _brute(mechanism, r, l, s, d)[0][1] % 360.0
    assert 0 < half < 0.125
    assert found.ranges[0] == pytest.approx((213.1 + half, 573.1 - half), abs=1e-5)


def test_the_drawable_positions_are_drawn_and_the_others_named() -> None:
    lengths = (0.3, 0.22, 0.25, 0.35)
    made = work(scene(four_bar(*lengths)), exact=True)
    low, high = _brute(made.scene.mechanism, *lengths)[0]
    inside = {str(k) for k in range(12) if any(low <= 30 * k + turn <= high for turn in (0, 360))}
    assert {made.project.names[i] for i in made.undrawn} == {str(k) for k in range(12)} - inside
    text = warnings(made)[0]
    for name in {str(k) for k in range(12)} - inside:
        assert re.search(rf"\b{name}\b", text)
    assert "group 2-3" in text
    assert f"{low % 360:.2f}° to {high % 360:.2f}°" in text
    drawn = np.flatnonzero(np.isfinite(places(made.project, "B")))
    assert {str(k) for k in drawn} == inside


def test_the_sheet_of_a_mechanism_that_assembles_in_part_is_inked() -> None:
    made, paper = sheets(scene(four_bar(0.3, 0.22, 0.25, 0.35)))
    assert made.undrawn
    assert paper


def test_a_row_wholly_outside_the_range_is_an_error_with_the_range() -> None:
    mechanism = four_bar(0.3, 0.22, 0.25, 0.35)
    with pytest.raises(StructureError, match=r"none of the positions.*assembles for crank angles"):
        work(scene(mechanism, Row(1, zero=180.0, accelerations=("0",))))


# change points


def test_a_parallelogram_must_say_where_its_side_flips() -> None:
    text = message(four_bar(0.1, 0.3, 0.1, 0.3))
    assert "group 2-3" in text
    assert 'flips_at = ["0 deg", "180 deg"]' in text


@pytest.mark.parametrize(
    ("mechanism", "angles"),
    [
        (slider_crank(0.1, 0.1), ("90", "270")),
        (slider_crank(0.1, 0.12, 0.02), ("270",)),
        (coulisse(0.1, 0.1 + 0j), ("0",)),
        (coulisse(0.1, -0.1 + 0j), ("180",)),
        (coulisse(0.1, 0.3 + 0j, 0.2), ("0",)),
        (four_bar(0.2, 0.5, 0.5, 0.2), ("0",)),
        (four_bar(0.1, 0.2, 0.25, 0.35), ("180",)),
        (four_bar(0.1, 0.2, 0.2, 0.1), ("0",)),
    ],
)
def test_a_change_point_is_named_with_its_angle(
    mechanism: Mechanism, angles: tuple[str, ...]
) -> None:
    text = message(mechanism)
    assert "flips_at = [" + ", ".join(f'"{angle} deg"' for angle in angles) + "]" in text


def test_a_change_point_between_the_angles_tried_is_named() -> None:
    mechanism = coulisse(0.1, cmath.rect(0.1, math.radians(47.1234)))
    assert '"47.1234 deg"' in message(mechanism)


def track(
    mechanism: Mechanism, start: dict[str, complex], angles: list[float]
) -> list[dict[int, Pose]]:
    """Follow the mechanism through its change points in small steps: the poses carry on evenly."""
    fine = 0.37
    poses = [poses_from_points(mechanism, angles[0], start)]
    phis = [angles[0]]
    found = []
    for target in angles:
        while abs(target - phis[-1]) > 1e-12:
            step = math.copysign(min(fine, abs(target - phis[-1])), target - phis[-1])
            nearer = poses[-1]
            if len(poses) > 1 and abs(phis[-1] - phis[-2]) > 1e-12:
                share = step / (phis[-1] - phis[-2])
                nearer = {
                    number: tuple(
                        now + share * (now - then)
                        for now, then in zip(pose, poses[-2][number], strict=True)
                    )
                    for number, pose in poses[-1].items()
                }
            phi = phis[-1] + step
            poses.append(
                {k: v for k, v in solve_fast(mechanism, phi, nearer).pose.items() if k in nearer}
            )
            phis.append(phi)
        found.append(poses[-1])
    return found


CARRIED = [
    pytest.param(
        lambda speed: four_bar(0.1, 0.3, 0.1, 0.3, flips=(0.0, 180.0), speed=speed),
        25.0,
        id="parallelogram",
    ),
    pytest.param(
        lambda speed: slider_crank(0.1, 0.1, flips=(90.0, 270.0), speed=speed), 25.0, id="l = r"
    ),
    pytest.param(
        lambda speed: coulisse(0.1, 0.1 + 0j, flips=(0.0,), speed=speed), 25.0, id="A over C at 0"
    ),
    pytest.param(
        lambda speed: coulisse(0.1, -0.1 + 0j, flips=(180.0,), speed=speed),
        25.0,
        id="A over C at 180",
    ),
    pytest.param(
        lambda speed: coulisse(0.1, 0.1j, flips=(90.0,), speed=speed), 25.0, id="A over C at 90"
    ),
    pytest.param(
        lambda speed: four_bar(0.2, 0.5, 0.5, 0.2, flips=(0.0,), speed=speed), 25.0, id="kite"
    ),
]


@pytest.mark.parametrize("speed", [1.0, -1.0])
@pytest.mark.parametrize(("make", "zero"), CARRIED)
def test_the_right_flips_follow_the_mechanism_through_its_change_points(
    make: Callable[[float], Mechanism], zero: float, speed: float
) -> None:
    mechanism = make(speed)
    project = draw_project(mechanism, Row(12, zero=zero), plans=["positions"])
    letters = sorted({letter for link in mechanism.links for letter in link.points})
    drawn = {letter: places(project, letter) for letter in letters}
    start = {letter: complex(np.resize(row, 12)[0]) for letter, row in drawn.items()}
    angles = [zero + speed * 30.0 * k for k in range(12)]
    for place, poses in enumerate(track(mechanism, start, angles)):
        for link in mechanism.links:
            x, y, turn = poses[link.number]
            for letter, own in link.points.items():
                due = complex(x, y) + own * cmath.rect(1.0, turn)
                assert abs(np.resize(drawn[letter], 12)[place] - due) < 1e-8, (place, letter)


def test_a_flip_where_the_assemblies_do_not_meet_is_refused() -> None:
    text = message(slider_crank(0.1, 0.1, flips=(90.0, 200.0)))
    assert "group 2-3" in text
    assert "200°" in text
    assert "leave it out" in text
    assert "0.1°" in message(slider_crank(0.1, 0.3, flips=(0.1,)))


def test_a_flip_that_is_a_little_off_is_refused() -> None:
    assert "90.05°" in message(slider_crank(0.1, 0.1, flips=(90.05, 270.0)))


def test_an_odd_number_of_flips_is_refused_where_an_even_one_is_due() -> None:
    for mechanism in (
        slider_crank(0.1, 0.1, flips=(90.0,)),
        four_bar(0.1, 0.3, 0.1, 0.3, flips=(180.0,)),
    ):
        text = message(mechanism)
        assert "even number" in text
        assert "other side" in text


def test_a_flip_named_twice_is_refused() -> None:
    assert "twice" in message(slider_crank(0.1, 0.1, flips=(90.0, 90.0, 270.0, 270.0)))


def test_no_flips_are_taken_at_their_word() -> None:
    project = draw_project(
        slider_crank(0.1, 0.1, flips=()), Row(12, zero=15.0), plans=["positions"]
    )
    phi = np.radians(15 + 30 * np.arange(12))
    due = 0.1 * (np.cos(phi) + np.abs(np.cos(phi)))
    assert np.abs(places(project, "B") - due).max() < 1e-12


@pytest.mark.parametrize("off", [1e-6, 3e-8])
def test_a_mechanism_near_a_change_point_is_not_refused(off: float) -> None:
    for mechanism in (
        slider_crank(0.1, 0.1 * (1 + off)),
        four_bar(0.1, 0.3 * (1 + off), 0.1, 0.3),
        four_bar(0.1, 0.3, 0.1 * (1 + off), 0.3),
        coulisse(0.1, 0.1 * (1 + off) + 0j),
        coulisse(0.1, 0.3 + 0j, 0.2 * (1 - off)),
    ):
        try:
            found = assembly(mechanism)
        except StructureError as error:
            pytest.fail(str(error))
        assert all(high - low > 359 for low, high in found.ranges)


# sides


@pytest.mark.parametrize(
    ("mechanism", "remedy"),
    [
        (four_bar(0.1, 0.4, 0.3, 0.45), 'link 2 or 3 side = "left of AC"'),
        (slider_crank(0.1, 0.4), 'slides of link 3 side = "+" or "-"'),
        (coulisse(0.1, 0.3 + 0j), 'slides of link 2 side = "+" or "-"'),
    ],
)
def test_a_missing_side_is_asked_for_by_its_key(mechanism: Mechanism, remedy: str) -> None:
    bare = tuple(
        Link(
            link.number,
            link.points,
            link.guides,
            tuple(Slide(s.on, s.guide, s.offset, s.angle) for s in link.slides),
        )
        for link in mechanism.links
    )
    text = message(Mechanism(mechanism.frame, bare, mechanism.drive))
    assert "group 2-3 can be assembled in two ways" in text
    assert remedy in text


# zero at an extreme of a mechanism that assembles in part


def test_an_extreme_within_the_range_is_found() -> None:
    mechanism = four_bar(0.3, 0.22, 0.25, 0.35)
    project = draw_project(mechanism, Row(12, zero=Extreme("A", "right")), plans=["positions"])
    assert project.assembly.ranges
    assert project.angles[0] == pytest.approx(0.0, abs=1e-9)


def test_the_end_of_the_range_is_no_extreme_position() -> None:
    mechanism = four_bar(0.3, 0.22, 0.25, 0.35)
    for way in ("left", "right", "top", "bottom"):
        for letter in ("A", "B"):
            row = Row(12, zero=Extreme(letter, way))
            try:
                project = draw_project(mechanism, row, plans=["positions", "velocities"])
            except StructureError as error:
                assert "does not stand still" in str(error)  # noqa: PT017
                continue
            low, high = project.assembly.ranges[0]
            angle = project.angles[0]
            assert any(low + 1e-3 < angle + turn < high - 1e-3 for turn in (0, 360)), (letter, way)


# whatever is drawn, nothing but a TmmError comes out


@settings(max_examples=40, deadline=None)
@given(drawn=mechanisms(dyads=(1, 2)), way=st.sampled_from(["left", "right", "top", "bottom"]))
def test_a_drawn_mechanism_raises_nothing_but_errors_told_to_a_person(
    drawn: Drawn, way: str
) -> None:
    letter = sorted(set(drawn.points) - set(drawn.mechanism.frame.points))[-1]
    for row in (
        Row(6, zero=drawn.phi, accelerations=("all",)),
        Row(6, 1, Extreme(letter, way), ("other extreme", 105.0), ("all",)),
    ):
        try:
            made = work(scene(drawn.mechanism, row))
        except TmmError as error:
            assert str(error)  # noqa: PT017
            continue
        assert len(made.project.names) == 6 + len(row.extra)
        warnings(made)
        made.findings()
