"""The row of positions: equal steps, numbers, extras and their names."""

from __future__ import annotations

import math

import numpy as np
import pytest
from support import drives
from support.boards import recorded
from support.gallery import SHEETS
from support.linkages import slider_crank
from support.rows import apart, places, project_of

import graphic_tmm as tmm
from graphic_tmm.errors import SceneError, StructureError
from graphic_tmm.mechanism.records import Extreme, Row
from graphic_tmm.scene.read import read


@pytest.mark.parametrize("first", [0, 1])
@pytest.mark.parametrize("speed", [1.0, -1.0])
def test_the_row_goes_with_the_crank_in_equal_steps(first: int, speed: float) -> None:
    project = project_of(
        slider_crank(0.045, 0.18, -0.018, drive=(speed, 0.0)), "B", "right", first=first
    )
    assert project.names == tuple(str(first + k) for k in range(12))
    for place, angle in enumerate(project.coordinates):
        assert apart(angle, project.coordinates[0] + speed * 30 * place) < 1e-9
        assert 0 <= angle < 360


def test_the_engine_keeps_an_exact_right_angle() -> None:
    project = recorded(read(SHEETS / "engine").mechanism, Row(12, 1, 0.0), plans=["positions"])
    assert project.coordinates[3] == 90.0
    assert project.names[3] == "4"


@pytest.mark.parametrize(
    ("speed", "first", "name"), [(1.0, 0, "6*"), (-1.0, 0, "5*"), (1.0, 1, "7*"), (-1.0, 1, "6*")]
)
def test_the_other_extreme_is_named_after_the_position_it_follows(
    speed: float, first: int, name: str
) -> None:
    project = project_of(
        slider_crank(0.1, 0.3, 0.05, drive=(speed, 0.0)), "B", "right", None, first=first
    )
    travelled = (speed * (project.coordinates[-1] - project.coordinates[0])) % 360
    assert project.names[-1] == name
    assert math.floor(travelled / 30) + first == int(name[:-1])


def test_an_extreme_exactly_on_a_position_is_named_after_it() -> None:
    project = project_of(slider_crank(0.3, 0.64), "B", "right", None)
    assert project.names[-1] == "6*"
    assert project.coordinates[-1] == pytest.approx(180.0, abs=1e-12)


def test_extra_angles_stand_as_given_outside_the_row() -> None:
    project = project_of(
        slider_crank(0.3, 0.64, drive=(-1.0, 0.0)), "B", "right", 105.0, None, -30.0
    )
    assert project.names[12:] == ("105°", "6*", "-30°")
    assert project.coordinates[12] == 105.0
    assert project.coordinates[14] == 330.0


def test_extra_angles_alone_are_drawn_at_those_angles() -> None:
    project = recorded(
        slider_crank(0.3, 0.64), Row(4, zero=10.0, extra=(77.5,)), plans=["positions"]
    )
    assert project.coordinates == (10.0, 100.0, 190.0, 280.0, 77.5)
    phi = math.radians(77.5)
    due = 0.3 * math.cos(phi) + math.sqrt(0.64**2 - (0.3 * math.sin(phi)) ** 2)
    assert abs(places(project, "B")[-1] - due) < 1e-15


@pytest.mark.parametrize("letter", ["O", "Q"])
def test_a_point_that_does_not_move_has_no_extreme(letter: str) -> None:
    with pytest.raises(StructureError, match=f"zero: {letter} is not a moving point.*A, B"):
        project_of(slider_crank(0.3, 0.64), letter, "left")


def test_an_acceleration_plan_for_a_position_that_is_not_there_is_refused() -> None:
    with pytest.raises(StructureError, match=r"no position 13; there are 0, 1"):
        recorded(slider_crank(0.3, 0.64), Row(12, accelerations=("13",)))


def test_a_trajectory_of_a_point_that_is_not_there_is_refused() -> None:
    with pytest.raises(StructureError, match="no point Q"):
        recorded(slider_crank(0.3, 0.64), Row(12), trajectories=["Q"])


@pytest.mark.parametrize(
    ("extra", "said"),
    [
        ((None, None), "B: left"),
        ((Extreme("B", "right"),), "B: right"),
        ((105.0, 20.0, 105.0), "105°"),
    ],
)
def test_an_extra_named_twice_is_refused(
    extra: tuple[float | Extreme | None, ...], said: str
) -> None:
    with pytest.raises(StructureError, match="named twice") as caught:
        project_of(slider_crank(0.3, 0.64), "B", "right", *extra)
    assert said in str(caught.value)


def test_an_extra_is_named_with_as_many_digits_as_tell_it() -> None:
    """From a rounder angle, and from its neighbours; rounding of radians makes no digits."""
    wanted = (
        30.0,
        29.999999999,
        29.9999999999,
        89.999,
        math.degrees(math.pi / 3),
        1.23456789012,
        105.5,
    )
    wanted = (*wanted, 5.7295779513, 5.72957795131)
    mechanism = read(SHEETS / "engine").mechanism
    project = recorded(mechanism, Row(12, 1, 0.0, wanted), plans=["positions"])
    assert project.names[12:] == (
        "30°",
        "29.999999999°",
        "29.9999999999°",
        "89.999°",
        "60°",
        "1.23456789°",
        "105.5°",
        "5.7295779513°",
        "5.72957795131°",
    )
    assert project.coordinates[13] == 29.999999999
    assert project.coordinates[14] == 29.9999999999


@pytest.mark.parametrize(
    ("text", "point"), [(drives.RACK, "A"), (drives.BOOM, "N"), (drives.SLIDER, "A")]
)
@pytest.mark.parametrize("key", ['zero = "20 deg"', 'zero = { point = "%s", at = "left" }'])
def test_a_row_of_lengths_takes_no_angle(text: str, point: str, key: str) -> None:
    kept = [line for line in text.splitlines() if not line.startswith(("from", "to ="))]
    scene = tmm.read("\n".join([*kept, key.replace("%s", point)]))
    assert scene.mechanism is not None
    with pytest.raises(StructureError, match=f"from one length .* and no {key.split()[0]}"):
        recorded(scene.mechanism, scene.row)


@pytest.mark.parametrize(
    ("row", "names"),
    [
        ('from = "600 mm"\nto = "850 mm"\npositions = 6', ("2*", "1*", "4*", "2**", "0*", "5*")),
        ('from = "850 mm"\nto = "600 mm"\npositions = 6', ("3*", "3**", "0*", "2*", "5*", "0**")),
        ('positions = ["600 mm", "0.7 m", "850 mm"]', ("1*", "0*", "1**", "1***", "0**", "2*")),
    ],
)
@pytest.mark.parametrize("first", [0, 1])
def test_lengths_outside_the_row_are_named_after_the_position_they_follow(
    row: str, names: tuple[str, ...], first: int
) -> None:
    lengths = (0.7, 0.655, 0.84, 0.705, 0.59, 0.86)
    extra = ", ".join(f'"{1000 * one:g} mm"' for one in lengths)
    text = drives.BOOM.replace('from = "600 mm"\nto = "850 mm"\npositions = 6', row)
    made = drives.scene(f"{text}extra = [{extra}]\nfirst = {first}\n")
    assert made.mechanism is not None
    project = recorded(made.mechanism, made.row, plans=["positions", "velocities"])
    count = made.row.count
    assert project.coordinates[count:] == pytest.approx(lengths, abs=1e-15)
    assert project.names[count:] == tuple(f"{int(one[0]) + first}{one[1:]}" for one in names)
    n = places(project, "N")
    assert np.abs(n[count:] - 0.4) == pytest.approx(lengths, abs=1e-15)


def test_a_length_outside_the_row_that_is_named_twice_is_refused() -> None:
    made = drives.scene(f'{drives.BOOM}extra = ["700 mm", "0.7 m"]\n')
    assert made.mechanism is not None
    with pytest.raises(StructureError, match=r"extra: 0.7 m is named twice"):
        recorded(made.mechanism, made.row)


STROKE = 'from = "600 mm"\nto = "850 mm"\npositions = 6'
UNORDERED = drives.BOOM.replace(STROKE, 'positions = ["700 mm", "0.6 m", "850 mm"]')


@pytest.mark.parametrize(
    ("text", "extra", "wanted"),
    [
        (drives.BOOM, '"90 deg"', 'a length is wanted, "200 mm": link 3 slides'),
        (drives.RACK, '"90 deg"', 'a length is wanted, "200 mm": the rack slides'),
        (drives.LEVER, '"90 mm"', 'an angle is wanted, "20 deg": link 1 turns'),
        (drives.BOOM, '{ point = "G", at = "top" }', '"G" stands on the frame'),
        (drives.BOOM, '{ point = "Q", at = "top" }', '"Q" is not a letter'),
        (drives.BOOM, '{ point = "C", at = "up" }', 'it is one of "left", "right"'),
        (drives.BOOM, '"other extreme"', "the other extreme of what"),
        (UNORDERED, '"640 mm"', "write these among them"),
    ],
)
def test_positions_outside_the_row_are_lengths_of_what_slides(
    text: str, extra: str, wanted: str
) -> None:
    with pytest.raises(SceneError) as caught:
        drives.scene(f"{text}extra = [{extra}]\n")
    assert "drive.extra" in str(caught.value)
    assert wanted in str(caught.value)


@pytest.mark.parametrize(
    ("text", "ends", "place", "unit", "load", "name"),
    [
        (drives.BOOM, (600.0, 850.0), 705.0, "mm", (1, "C"), "2*"),
        (drives.SLIDER, (250.0, 350.0), 311.0, "mm", (3, "A"), "3*"),
        (drives.LEVER, (20.0, 75.0), 33.5, "deg", (3, "B"), "33.5°"),
        (drives.RACK, (10.0, 120.0), 50.0, "mm", (3, "B"), "1*"),
    ],
)
@pytest.mark.slow
def test_a_position_outside_the_row_has_the_figures_of_one_in_a_list_of_places(
    text: str,
    ends: tuple[float, float],
    place: float,
    unit: str,
    load: tuple[int, str],
    name: str,
) -> None:
    text += drives.LOADS.format(link=load[0], point=load[1])
    plans = f'accelerations = [0, "{name}"]' if name.endswith("*") else "accelerations = [0]"
    outside = text.replace('accelerations = "all"', f'{plans}\nextra = ["{place} {unit}"]')
    places = sorted([*np.linspace(*ends, 6).tolist(), place])
    listed = ", ".join(f'"{one!r} {unit}"' for one in places)
    low, high = (f"{one:g} {unit}" for one in ends)
    within = text.replace(
        f'from = "{low}"\nto = "{high}"\npositions = 6', f"positions = [{listed}]"
    )
    assert within != text
    one, other = (tmm.draw(tmm.read(scene), exact=True) for scene in (outside, within))
    compared = 0
    for table in ("velocities", "accelerations", "forces"):
        for column in other.table(table):
            due = other.table(table)[column].value[0, places.index(place)]
            found = one.table(table)[column].value[0, 6]
            if table == "accelerations" and not name.endswith("*"):
                assert np.isnan(found)
                continue
            compared += 1
            assert found == pytest.approx(due, rel=1e-9, abs=1e-12), (table, column)
    assert compared >= 14
