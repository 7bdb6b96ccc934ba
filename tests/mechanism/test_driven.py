"""What a drive drives, or why it drives nothing."""

from __future__ import annotations

import pytest
from support.driven_scenes import BOOM, OUT, ROCKER, SLIDER, scene

import graphic_tmm
from graphic_tmm.errors import TmmError
from graphic_tmm.mechanism.structure import dissect


def formula(text: str, drive: str) -> str:
    mechanism = scene(text, drive).mechanism
    assert mechanism is not None
    return dissect(mechanism).formula


@pytest.mark.parametrize(
    ("text", "drive", "due"),
    [
        (ROCKER, "speed = 1", "I(1) → II(2-3)"),
        (SLIDER, 'speed = "1 m/s"', "I(1) → II(2-3)"),
        (BOOM, OUT, "I(2-3) → II(1-2)"),
    ],
)
def test_a_drive_begins_the_formula_of_structure(text: str, drive: str, due: str) -> None:
    assert formula(text, drive) == due


def test_a_bare_number_drives_what_the_link_does() -> None:
    """0.5 of a slider is 0.5 m/s, of a crank 0.5 rad/s."""
    for text, slides in ((SLIDER, True), (ROCKER, False)):
        mechanism = scene(text, "speed = 0.5").mechanism
        assert mechanism is not None
        assert mechanism.drive.slides is slides


@pytest.mark.parametrize(
    ("old", "new", "says"),
    [
        ("N = [0, 0] }\nslides", "N = [0, 0], C = [0.5, 0] }\nslides", "rod and cylinder have each one pin"),
        ("through = [0, 0]", "through = [0, 0.02]", "they lie 20 mm off each other across it"),
        ('speed = "0.05 m/s"', 'speed = "5 rad/s"', 'write its speed, "0.2 m/s"'),
        ("link = 3\n", "link = 1\n", "link 1 slides on nothing"),
        ('from = "600 mm"', 'from = "20 deg"', "a length is wanted"),
        ('to = "850 mm"\n', "", "write from and to"),
    ],
)  # fmt: skip
def test_a_drive_that_drives_nothing_is_refused(old: str, new: str, says: str) -> None:
    text = BOOM.format(drive=OUT, loaded="")
    assert old in text
    with pytest.raises(TmmError, match=says):
        graphic_tmm.draw(graphic_tmm.read(text.replace(old, new))).table("velocities")


def test_two_drives_of_one_freedom_are_one_too_many() -> None:
    text = ROCKER.format(drive="speed = 1", loaded="").replace("[drive]", "[[drive]]")
    second = '\n[[drive]]\nlink = 3\nspeed = "1 rad/s"\n'
    with pytest.raises(TmmError, match="W = 3·3 − 2·4 = 1, but 2 drives are given"):
        graphic_tmm.draw(graphic_tmm.read(text + second)).table("velocities")
