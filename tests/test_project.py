"""A whole project: part of the turn only, through change points, nothing but errors told to a person."""

from __future__ import annotations

import cmath
import math
import re
from collections.abc import Callable

import numpy as np
import pytest
from hypothesis import given, settings
from hypothesis import strategies as st
from support.assemblies import ranges
from support.boards import drawn_of, recorded
from support.examples import most
from support.linkages import coulisse, four_bar, slider_crank
from support.mechanisms import Sampled, mechanisms
from support.oracle import poses_from_points, solve_fast

from graphic_tmm.board.execute import execute
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.errors import StructureError, TmmError
from graphic_tmm.mechanism.records import Extreme, Mechanism, Row
from graphic_tmm.project import Project
from graphic_tmm.readers.findings import warnings
from graphic_tmm.scene.records import Scene, SheetOrder
from graphic_tmm.studio import sheets

Pose = tuple[float, float, float]


def places(project: Project, letter: str) -> np.ndarray:
    """Places (m) of a letter in all positions."""
    mark = KINEMATICS_PLAN.on(project).positions.point(letter)
    given_ = project.given | {KINEMATICS_PLAN.on(project).mu_l: 1.0}
    return np.ravel(execute(project.construction, given_, [mark])[mark])


def scene(mechanism: Mechanism, row: Row | None = None) -> Scene:
    return Scene(
        "", "Test", "en", mechanism, row or Row(12, accelerations=("1",)), sheets=(SheetOrder(),)
    )


# a part of the turn only


def test_the_drawable_positions_are_drawn_and_the_others_named() -> None:
    lengths = (0.3, 0.22, 0.25, 0.35)
    made = drawn_of(scene(four_bar(*lengths)), exact=True)
    low, high = ranges(*lengths)[0]
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
    whole, paper = sheets(scene(four_bar(0.3, 0.22, 0.25, 0.35)))
    made = whole.mechanism
    assert made is not None
    assert made.undrawn
    assert paper


def test_a_row_wholly_outside_the_range_is_an_error_with_the_range() -> None:
    mechanism = four_bar(0.3, 0.22, 0.25, 0.35)
    with pytest.raises(StructureError, match=r"none of the positions.*assembles for crank angles"):
        drawn_of(scene(mechanism, Row(1, zero=180.0, accelerations=("0",))))


# through change points


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
        lambda speed: four_bar(0.1, 0.3, 0.1, 0.3, flips=(0.0, 180.0), drive=(speed, 0.0)),
        25.0,
        id="parallelogram",
    ),
    pytest.param(
        lambda speed: slider_crank(0.1, 0.1, flips=(90.0, 270.0), drive=(speed, 0.0)),
        25.0,
        id="rod = r",
    ),
    pytest.param(
        lambda speed: coulisse(0.1, 0.1 + 0j, flips=(0.0,), drive=(speed, 0.0)),
        25.0,
        id="A over C at 0",
    ),
    pytest.param(
        lambda speed: coulisse(0.1, -0.1 + 0j, flips=(180.0,), drive=(speed, 0.0)),
        25.0,
        id="A over C at 180",
    ),
    pytest.param(
        lambda speed: coulisse(0.1, 0.1j, flips=(90.0,), drive=(speed, 0.0)),
        25.0,
        id="A over C at 90",
    ),
    pytest.param(
        lambda speed: four_bar(0.2, 0.5, 0.5, 0.2, flips=(0.0,), drive=(speed, 0.0)),
        25.0,
        id="kite",
    ),
]


@pytest.mark.turns(4)
@pytest.mark.slow
@pytest.mark.parametrize("speed", [1.0, -1.0])
@pytest.mark.parametrize(("make", "zero"), CARRIED)
def test_the_right_flips_follow_the_mechanism_through_its_change_points(
    make: Callable[[float], Mechanism], zero: float, speed: float
) -> None:
    mechanism = make(speed)
    project = recorded(mechanism, Row(12, zero=zero), plans=["positions"])
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


def test_no_flips_are_taken_at_their_word() -> None:
    project = recorded(slider_crank(0.1, 0.1, flips=()), Row(12, zero=15.0), plans=["positions"])
    phi = np.radians(15 + 30 * np.arange(12))
    due = 0.1 * (np.cos(phi) + np.abs(np.cos(phi)))
    assert np.abs(places(project, "B") - due).max() < 1e-12


# zero at an extreme of a mechanism that assembles in part


def test_an_extreme_within_the_range_is_found() -> None:
    mechanism = four_bar(0.3, 0.22, 0.25, 0.35)
    project = recorded(mechanism, Row(12, zero=Extreme("A", "right")), plans=["positions"])
    assert KINEMATICS_PLAN.on(project).assembly.ranges
    assert project.coordinates[0] == pytest.approx(0.0, abs=1e-9)


def test_the_end_of_the_range_is_no_extreme_position() -> None:
    mechanism = four_bar(0.3, 0.22, 0.25, 0.35)
    for way in ("left", "right", "top", "bottom"):
        for letter in ("A", "B"):
            row = Row(12, zero=Extreme(letter, way))
            try:
                project = recorded(mechanism, row, plans=["positions", "velocities"])
            except StructureError as error:
                assert "does not come to an extreme position" in str(error)  # noqa: PT017
                continue
            low, high = KINEMATICS_PLAN.on(project).assembly.ranges[0]
            angle = project.coordinates[0]
            assert any(low + 1e-3 < angle + turn < high - 1e-3 for turn in (0, 360)), (letter, way)


# whatever is drawn, nothing but a TmmError comes out


@pytest.mark.slow
@settings(max_examples=most(15), deadline=None)
@given(drawn=mechanisms(dyads=(1, 2)), way=st.sampled_from(["left", "right", "top", "bottom"]))
def test_a_drawn_mechanism_raises_nothing_but_errors_told_to_a_person(
    drawn: Sampled, way: str
) -> None:
    letter = sorted(set(drawn.points) - set(drawn.mechanism.frame.points))[-1]
    for row in (
        Row(6, zero=drawn.phi, accelerations=("all",)),
        Row(6, 1, Extreme(letter, way), (Extreme(letter, way).opposite, 105.0), ("all",)),
    ):
        try:
            made = drawn_of(scene(drawn.mechanism, row))
        except TmmError as error:
            assert str(error)  # noqa: PT017
            continue
        assert len(made.project.names) == 6 + len(row.extra)
        warnings(made)
        made.findings()


# a mechanism that comes back after two turns


def test_a_path_that_closes_after_two_turns_is_not_drawn_as_if_it_closed_after_one() -> None:
    over = coulisse(0.1, 0.1 + 0j, flips=(0.0,))
    with pytest.raises(StructureError, match=r"trajectories: .*group 2-3 flips an odd number"):
        recorded(over, Row(12, zero=15.0), trajectories=["D"])
    whole = coulisse(0.1, 0.1 + 0j, flips=())
    assert recorded(whole, Row(12, zero=15.0), trajectories=["D"]).names


def test_the_other_extreme_of_a_mechanism_that_comes_back_after_two_turns_is_refused() -> None:
    over = coulisse(0.1, 0.1 + 0j, flips=(0.0,))
    with pytest.raises(StructureError, match="may lie in the second turn"):
        recorded(over, Row(12, zero=Extreme("A", "left"), extra=(Extreme("A", "right"),)))
    project = recorded(over, Row(12, zero=Extreme("A", "left")), plans=["positions"])
    assert project.coordinates[0] == pytest.approx(180.0)
