"""No drive is called or drawn as another: all that scenes of every drive say, read in both languages."""

from __future__ import annotations

import re
from pathlib import Path

import pytest
from support.boards import drawn_of
from support.each import each
from support.words_of_drives import SCENES, told, wrong

from graphic_tmm.chapters.kinematics.views import position_views
from graphic_tmm.paper.drawing import Stroke
from graphic_tmm.scene.read import read


@pytest.mark.slow
@pytest.mark.parametrize("language", ["en", "ru"])
@pytest.mark.parametrize("name", SCENES)
def test_a_drive_is_told_in_its_own_words(name: str, language: str, tmp_path: Path) -> None:
    scene = SCENES[name]
    says = {
        where: amiss
        for where, text in told(scene, language, tmp_path)
        if (amiss := wrong(scene, where, text))
    }
    assert not says


@each(
    "name, where, text",
    [
        ("slider", "note", "The Cranks turn"),
        ("slider", "note", "оба КРИВОШИПА"),
        ("slider", "csv", "velocities,0,0.25,omega1,,0.15,1/s"),
        ("slider", "page", '["ω_{1}", 37]'),
        ("slider", "sheet Velocities from the plans", "v_B\nω₁"),
        ("crank and slider", "note", "ε_4 = 0"),
        ("cylinder", "task sheet", "l_ON\nω₃"),
        ("cylinder", "task sheet", "20…75\n°"),
        ("cylinder", "protocol", "From G draw the ray at 30° to GN."),
        ("cylinder", "json", '"angle_deg": 30'),
        ("slider and crank", "csv", "angle_deg"),
        ("two cranks", "note", "Each Cylinder, the rods run out"),
        ("two cranks", "note", "v_A = v_A + v_C"),
        ("rack", "note", "цилиндры"),
    ],
)
def test_words_of_another_drive_are_seen(name: str, where: str, text: str) -> None:
    assert wrong(SCENES[name], where, text)


@each("name", SCENES)
@pytest.mark.slow
def test_a_drive_is_drawn_with_its_own_arrows_and_circles(name: str, tmp_path: Path) -> None:
    """A circle and a round arrow for each link that turns about a pivot, a straight one for what slides."""
    scene, file = SCENES[name], tmp_path / "scene.toml"
    file.write_text(scene.text("en"), encoding="utf-8")
    views = position_views(drawn_of(read(file)), True)
    inked = [one for view in views for one in view.strokes if isinstance(one, Stroke)]
    of = {part: {one.of for one in inked if one.part == part} for part in ("circle", *WAYS)}
    ways = [WAYS[0] if drive in TURNING else WAYS[1] for _, drive in scene.driven]
    assert len(of["circle"]) == ways.count("turning")
    going = [] if scene.rests else ways
    assert {way: len(of[way]) for way in WAYS} == {way: going.count(way) for way in WAYS}
    letters = [label.text for view in views for label in view.labels if label.text[0] in "ωεva"]
    several = len(scene.driven) > 1
    due = [SPEEDS[drive, several].format(link) for link, drive in scene.driven if not scene.rests]
    if "gaining" in name:
        due.insert(1, due[0].replace("v", "a", 1))
    assert len(letters) == len(due)
    assert all(map(re.fullmatch, due, letters)), letters


WAYS = ("turning", "sliding")
TURNING = ("crank", "rack")
SPEEDS = {
    **{(drive, many): "ω_{}" for drive in TURNING for many in (False, True)},
    **{("slider", many): "v_[BC]" for many in (False, True)},
    ("rod", False): "v_r",
    ("rod", True): r"v_\{{r{}\}}",
}
"""The letter beside the arrow of a drive, by its link; where there are several drives, too."""
