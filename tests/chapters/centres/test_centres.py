"""Instantaneous centres of known mechanisms: published figures, infinity, hard places, what is refused."""

from __future__ import annotations

import cmath
import math
import warnings
from pathlib import Path
from typing import Any

import numpy as np
import pytest

import graphic_tmm as tmm
from graphic_tmm.chapters.centres.ink import letters_of_arrows
from graphic_tmm.chapters.centres.network import GUIDE, IMAGE, LINES, NORMALS, PARALLEL, PIN, RATES
from graphic_tmm.chapters.centres.record import CENTRES_PLAN, Centres
from graphic_tmm.chapters.centres.views import centre_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.errors import TmmError
from graphic_tmm.paper.drawing import Stroke, Wanted
from graphic_tmm.scene.captions import captions
from graphic_tmm.studio import make

Scene = dict[str, Any]


def drive(speed: str = "10 rad/s", zero: str = "60 deg", positions: int = 6, **more: Any) -> Scene:
    told = {"link": 1, "speed": speed, "turns": "counterclockwise", "positions": positions}
    return {**told, "zero": zero, "first": 1, **more}


def four_bar(crank: float, coupler: float, rocker: float, frame: float, **more: Any) -> Scene:
    """A four-bar linkage, lengths in m."""
    return {
        "title": "T",
        "language": "en",
        "frame": {"O": [0, 0], "D": [frame, 0]},
        "link": [
            {"number": 1, "points": {"O": [0, 0], "A": [crank, 0]}},
            {"number": 2, "points": {"A": [0, 0], "B": [coupler, 0]}},
            {"number": 3, "points": {"D": [0, 0], "B": [rocker, 0]}, "side": "left of AD"},
        ],
        "drive": drive(),
        "hand": {"ruler": "exact"},
        "centres": {"positions": [1]},
        "sheet": [{"format": "A2", "place": ["centres"]}],
        **more,
    }


def parallelogram() -> Scene:
    """Equal cranks that pass their dead places without turning inside out."""
    told = four_bar(0.1, 0.3, 0.1, 0.3)
    told["link"][2]["flips_at"] = ["0 deg", "180 deg"]
    return told


def slider_crank(crank: float, rod: float, **more: Any) -> Scene:
    """A slider-crank in line, lengths in m."""
    told = four_bar(crank, rod, 1.0, 1.0, **more)
    told["frame"] = {"O": [0, 0], "x": {"through": [0, 0], "angle": "0 deg"}}
    slide = {"on": "frame", "along": "x", "side": "right"}
    told["link"][2] = {"number": 3, "points": {"B": [0, 0]}, "slides": slide}
    return told


def drawn_of(scene: Scene) -> tuple[Drawn, Centres]:
    with warnings.catch_warnings():
        warnings.simplefilter("error")
        (found,) = make(tmm.read(scene)).boards
    return found, CENTRES_PLAN.on(found)


def place_of(found: Drawn, name: str, at: int = 0) -> complex:
    """Where a centre is, m."""
    one = next(k for k in CENTRES_PLAN.on(found).centres if k.name == name)
    value = found.reading[one.mark][0]
    return complex(value[at if value.size > 1 else 0]) * found.value(CENTRES_PLAN.on(found).mu)


def figure_of(found: Drawn, letter: str, at: int = 0) -> float:
    marks = [k.omega for k in CENTRES_PLAN.on(found).rotations] + [
        k.value for k in CENTRES_PLAN.on(found).speeds
    ]
    mark = next(one for one in marks if one is not None and one.name == letter)
    value = found.reading[mark][0]
    return float(value[at if value.size > 1 else 0])


def test_the_four_bar_of_the_survey() -> None:
    """Field survey, acceptance (7)."""
    found, made = drawn_of(four_bar(0.1, 0.28, 0.2, 0.3))
    assert [one.way for one in made.centres] == [PIN] * 4 + [LINES] * 2
    assert abs(place_of(found, "P_{20}") - (0.316596 + 0.548361j)) < 1e-6
    assert abs(place_of(found, "P_{13}") + 0.145706) < 1e-6
    assert figure_of(found, "ω_2") == pytest.approx(-1.875494, abs=1e-6)
    assert figure_of(found, "ω_3") == pytest.approx(3.269100, abs=1e-6)


def test_a_published_four_bar() -> None:
    """Khurmi and Gupta, Theory of Machines, example 6.1: P_20 B is measured as 500 mm, ω_2 = 6.282 rad/s.

    The task stands so at askfilo.com and github.com/carnot/logj/wiki/Chapter-6; the readings are from memory.
    """
    scene = four_bar(0.3, 0.36, 0.36, 0.6, drive=drive("100 rpm", turns="clockwise"))
    found, _ = drawn_of(scene)
    away = abs(place_of(found, "P_{20}") - cmath.rect(0.3, math.radians(60)))
    assert away == pytest.approx(0.5, abs=0.005)
    assert abs(figure_of(found, "ω_2")) == pytest.approx(6.282, rel=0.01)


def test_a_published_slider_crank() -> None:
    """The same, example 6.2: distances of 560 and 460 mm, the slider at 0.82 m/s, the rod at 1.78 rad/s."""
    found, made = drawn_of(slider_crank(0.1, 0.4, drive=drive(zero="45 deg", turns="clockwise")))
    pole, pin = place_of(found, "P_{20}"), cmath.rect(0.1, math.radians(45))
    assert abs(pole - pin) == pytest.approx(0.56, abs=0.01)
    assert abs(pole.imag) == pytest.approx(0.46, abs=0.01)
    assert figure_of(found, "ω_2") == pytest.approx(1.78, rel=0.015)
    assert figure_of(found, "v_B") == pytest.approx(0.82, rel=0.02)
    rotation = next(one for one in made.rotations if one.link == 3)
    assert rotation.still
    assert next(one for one in made.centres if one.name == "P_{30}").way == GUIDE


def test_the_coupler_of_a_parallelogram_translates() -> None:
    found, made = drawn_of(parallelogram())
    own = next(one for one in made.centres if one.name == "P_{20}")
    common = next(one for one in made.centres if one.name == "P_{13}")
    assert (own.far, own.way, common.far) == (True, PARALLEL, True)
    turning = {one.link: one for one in made.rotations}
    assert turning[2].still
    assert turning[3].alike
    assert figure_of(found, "v_B") == pytest.approx(1.0)


@pytest.mark.parametrize("scene", [parallelogram(), slider_crank(0.1, 0.3)], ids=["4", "s"])
def test_dead_places_leave_nothing_or_what_is_right(scene: Scene) -> None:
    """All links in one line, where a parallelogram may turn inside out: no figure, or that of the plan."""
    scene = {**scene, "drive": drive(zero="0 deg"), "centres": {"positions": "all"}}
    found, made = drawn_of(scene)
    for one in made.rotations:
        if one.omega is not None and one.plan is not None and not one.alike:
            own, due = (
                np.broadcast_to(found.reading.figure(k)[0], (6,)) for k in (one.omega, one.plan)
            )
            both = np.isfinite(own) & np.isfinite(due)
            np.testing.assert_allclose(own[both], due[both], atol=1e-6)


def test_lines_that_are_parallel_in_a_position_are_told() -> None:
    """Where crank and rocker are parallel P_20 lies at infinity: no figure, and a finding that names it."""
    scene = four_bar(0.1, 0.4, 0.2, 0.4, drive=drive(zero="0 deg", extra=["90 deg"]))
    # O = 0, A = 0.1j, D = 0.4: B is upright over D where AB = sqrt(0.4² + 0.1²)
    scene["link"][1]["points"]["B"] = [math.hypot(0.4, 0.1), 0]
    scene["centres"] = {"positions": "all"}
    found, _ = drawn_of(scene)
    at = len(found.names) - 1
    assert math.isnan(abs(place_of(found, "P_{20}", at)))
    assert math.isnan(figure_of(found, "ω_2", at))
    told = [one for one in found.findings() if at in one.positions]
    assert any(one.step.it.name == "P_{20}" for one in told)


def test_a_slider_drives() -> None:
    """Field survey, acceptance (3) turned round: the crank by the centre of slider and crank."""
    scene = slider_crank(0.1, 0.28)
    scene["frame"] = {"O": [0, 0], "x": {"through": [0, 0], "angle": "0 deg"}}
    scene["link"][2]["slides"] = {"on": "frame", "along": "x"}
    scene["link"][0]["side"] = "left of OB"
    scene["drive"] = {
        "link": 3,
        "speed": "0.5 m/s",
        "from": "330 mm",
        "to": "250 mm",
        "positions": 5,
    }
    found, made = drawn_of(scene)
    assert made.driver == 3
    for one in made.rotations:
        if one.omega is not None and one.plan is not None:
            np.testing.assert_allclose(found.reading[one.omega], found.reading[one.plan], rtol=1e-9)
    assert {one.link for one in made.rotations if one.omega is not None} == {1, 2}


@pytest.mark.parametrize("turned", [False, True])
def test_several_drives_by_normals_to_velocities(turned: bool) -> None:
    scene = four_bar(0.1, 0.25, 0.25, 0.3)
    scene["link"] = [
        scene["link"][0],
        scene["link"][1],
        {"number": 3, "points": {"B": [0, 0], "C": [0.25, 0]}, "side": "left of AC"},
        {"number": 4, "points": {"D": [0, 0], "C": [0.12, 0]}},
    ]
    scene["drive"] = [
        {**drive(zero="60 deg"), "from": "60 deg", "to": "90 deg"},
        {"link": 4, "speed": "4 rad/s", "turns": "clockwise", "at": "80 deg"},
    ]
    del scene["drive"][0]["zero"]
    scene["plans"] = {"velocities": "turned" if turned else "direct"}
    found, made = drawn_of(scene)
    ways = {one.name: one.way for one in made.centres}
    assert NORMALS in ways.values()
    assert not made.lost
    assert made.driver == 0
    for one in made.rotations:
        if one.omega is not None and one.plan is not None:
            own, due = found.reading[one.omega], found.reading[one.plan]
            np.testing.assert_allclose(own, due, rtol=1e-9)


def test_ways_have_words() -> None:
    from graphic_tmm.chapters.centres.words import WAYS

    assert {*WAYS} == {PIN, GUIDE, "wheel", NORMALS, IMAGE, RATES}


@pytest.mark.parametrize("language", ["en", "ru"])
def test_a_sheet_shows_scheme_polygon_and_tables(language: str) -> None:
    scene = four_bar(0.1, 0.28, 0.2, 0.3, language=language)
    found, made = drawn_of(scene)
    views = centre_views(found, True)
    assert [one.name for one in views] == [
        "centres-1", "centres-polygon", "table-centres", "table-centres-1"
    ]  # fmt: skip
    texts = [label.text for label in views[0].labels]
    assert any("P_{20}" in text for text in texts)
    strokes = [one for one in views[1].strokes if isinstance(one, Stroke)]
    sides = [one for one in strokes if len(one.path) == 2 and not one.closed]
    assert len(sides) == len(made.centres) == 6
    assert captions(language)["centres polygon"] in views[1].title


def test_arrows_to_one_centre_share_the_letter_with_most_room() -> None:
    """Two arrows 3 mm apart, one of them close to another's."""
    every = [
        Wanted(text, at, 3.5)
        for text, at in (("P50", 0j), ("P20", 4 + 0j), ("P20", 7 + 0j), ("P20", 40j))
    ]
    assert [(one.text, one.at) for one in letters_of_arrows(every)] == [
        ("P50", 0j), ("P20", 7 + 0j), ("P20", 40j)
    ]  # fmt: skip


def test_the_scale_can_be_given(tmp_path: Path) -> None:
    scene = four_bar(0.1, 0.28, 0.2, 0.3)
    scene["centres"] = {"positions": [1], "mu_l": "0.004 m/mm"}
    found, made = drawn_of(scene)
    assert found.value(made.mu) == 0.004


def test_a_position_that_is_none_is_refused() -> None:
    scene = four_bar(0.1, 0.28, 0.2, 0.3)
    scene["centres"] = {"positions": [19]}
    with pytest.raises(TmmError, match=r"centres.*no position 19"):
        drawn_of(scene)


def test_centres_at_any_angle() -> None:
    """With and without the section; the middle of three angles is that of the survey."""
    for scene in (
        four_bar(0.1, 0.28, 0.2, 0.3),
        {**four_bar(0.1, 0.28, 0.2, 0.3), "centres": None},
    ):
        told = {key: value for key, value in scene.items() if value is not None}
        if "centres" not in told:
            told["sheet"] = [{"format": "A2", "place": ["positions"]}]
        found = tmm.motion(told, [50.0, 60.0, 70.0], plans="centres", exact=True)
        assert abs(found.centres["P20"][1] - (0.316596 + 0.548361j)) < 1e-6
        assert sorted(found.centres) == ["P10", "P12", "P13", "P20", "P23", "P30"]
        assert not found.forces
