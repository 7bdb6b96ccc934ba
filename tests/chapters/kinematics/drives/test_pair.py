"""Drives together, drives whose speeds are listed, drives at rest: what they tell, and what they refuse."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from support.boards import drawn_of
from support.command import invoke
from support.drives import BOOM, LEVER, LOADS, RACK, SLIDER, rated
from support.each import each
from support.scenes import written
from support.words_of_drives import FIVE_BAR

import graphic_tmm as tmm
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.errors import TmmError

HEAD = 'title = "T"\nlanguage = "en"\n'
FIRST = '[[drive]]\nlink = 1\nspeed = "5 rad/s"\nzero = "60 deg"\npositions = 3\n'
SECOND = '[[drive]]\nlink = 4\nspeed = "10 rad/s"\nturns = "clockwise"\nat = "120 deg"\n'
SPEEDS = 'speed = ["5 rad/s", "4 rad/s", "3 rad/s"]'


@each(
    "old, new, says",
    [
        ('speed = "5 rad/s"', SPEEDS, "give the first one speed, not a list"),
        ('zero = "60 deg"', 'zero = { point = "B", at = "left" }', "give zero as an angle"),
        ('speed = "5 rad/s"', "speed = 0", "put one that goes first"),
    ],
)
def test_several_drives_whose_places_are_not_known_are_refused(
    old: str, new: str, says: str
) -> None:
    text = HEAD + FIVE_BAR + FIRST + SECOND
    assert old in text
    with pytest.raises(TmmError, match=says):
        drawn_of(tmm.read(text.replace(old, new, 1)))


def test_a_drive_at_rest_stays_where_it_is(tmp_path: Path) -> None:
    """A five-bar at rest: link 4 stays at 120°, and so the four-bar with C there moves as it does."""
    still = SECOND.replace('speed = "10 rad/s"\nturns = "clockwise"', "speed = 0")
    rest = HEAD + FIVE_BAR + FIRST.replace('"5 rad/s"', "0") + still
    c = 0.3 + 0.1 * np.exp(1j * np.radians(120.0))
    bar = FIVE_BAR[: FIVE_BAR.index("[[link]]\nnumber = 4")]
    bar = bar.replace("D = [0.3, 0]", f"C = [{float(c.real)!r}, {float(c.imag)!r}]")
    due = tmm.draw(tmm.read(HEAD + bar + FIRST.replace("[[drive]]", "[drive]")), exact=True)
    found = tmm.draw(tmm.read(rest), exact=True)
    for letter in ("omega2", "omega3"):
        own, other = (one.table("velocities")[letter].value for one in (found, due))
        np.testing.assert_allclose(own, other / 5.0, rtol=1e-9)


def test_a_list_of_zeros_is_at_rest() -> None:
    drive = BOOM.replace('speed = "0.05 m/s"\nacceleration = "0.3 m/s^2"', "speed = SPEED")
    one, other = (
        tmm.draw(tmm.read(drive.replace("SPEED", speed)), exact=True)
        .table("velocities")["omega1"]
        .value
        for speed in ("0", "[0, 0, 0, 0, 0, 0]")
    )
    assert np.all(one > 0.0)
    np.testing.assert_array_equal(one, other)


@each("text", [BOOM, SLIDER, LEVER, RACK])
def test_speeds_of_what_slides_and_of_what_turns_in_one_list_are_refused(text: str) -> None:
    unit, other = ("rad/s", "m/s") if text == LEVER else ("m/s", "rad/s")
    mixed = rated(text).replace(f'"0.3 {unit}"', f'"0.3 {other}"')
    with pytest.raises(TmmError, match=r"speeds of what slides and of what turns|a rack slides"):
        tmm.read(mixed)


@pytest.mark.slow
@each("text", [BOOM, SLIDER, LEVER, RACK])
def test_what_accuracy_costs_where_speeds_or_places_are_listed(text: str, tmp_path: Path) -> None:
    ends = next(line for line in text.splitlines() if line.startswith("from"))
    unit = ends.split()[-1]
    low, high = (
        line.split('"')[1].split()[0] for line in text.splitlines() if line[:2] in ("fr", "to")
    )
    there = ", ".join(f'"{x:g} {unit}' for x in np.linspace(float(low), float(high), 6))
    listed = text.replace("positions = 6", f"positions = [{there}]")
    listed = "\n".join(line for line in listed.splitlines() if line[:4] not in ("from", "to ="))
    for scene in (rated(text), listed):
        done = invoke("accuracy", written(tmp_path, scene), "--no-time")
        assert done.exit_code == 0, done.output
        assert "What accuracy costs" in done.output


def test_a_rack_is_no_crank_all_round() -> None:
    """A wheel that turns freely stands at both ends of its turn, and its row is not closed."""
    drive = '[drive]\nlink = 1\nspeed = "0.1 m/s"\nrack = "20 mm"\npositions = 5\n'
    crank = SLIDER.split("[[link]]\nnumber = 1")[0] + CRANK + drive
    ways = drawn_of(tmm.read(crank)).project.coordinates
    np.testing.assert_allclose(ways, 0.04 * np.pi * np.arange(5) / 4)
    loaded = LOADS.format(link=1, point="A")
    with pytest.raises(TmmError, match="a rack turns link 1"):
        drawn_of(tmm.read(f"{crank}{loaded}[flywheel]\ndelta = 0.05\n"))


CRANK = """[[link]]
number = 1
points = { O = [0, 0], A = [0.1, 0] }
[[link]]
number = 2
points = { A = [0, 0], B = [0.35, 0] }
[[link]]
number = 3
points = { B = [0, 0] }
slides = { on = "frame", along = "x", side = "right" }
"""


@each(
    "text, asked, says",
    [
        (SLIDER, 'OA = "50 mm"', "it has no crank as long as that; write mu_l"),
        (BOOM, 'OA = "50 mm"', "it has no crank as long as that; write mu_l"),
        (SLIDER, 'pi_a = "50 mm"', "the drive has no acceleration that long; write mu_a"),
        (RACK, 'mu_v = "mu_l*omega1"', "holds where a speed ω₁ is given; write mu_v"),
        (BOOM, 'mu_v = "mu_l*omega1"', "holds where a speed ω₁ is given; write mu_v"),
    ],
)
def test_a_length_in_mm_that_shows_nothing_of_the_drive_is_refused(
    text: str, asked: str, says: str
) -> None:
    with pytest.raises(TmmError, match=says):
        drawn_of(tmm.read(f"{text}[scales]\n{asked}\n"))


@each(
    "text, segment",
    [(SLIDER, "pb"), (LEVER, "pa"), (RACK, "pa"), (BOOM, "pk2")],
)
def test_the_segment_of_what_drives_is_as_long_as_the_scene_says(text: str, segment: str) -> None:
    made = tmm.draw(tmm.read(f'{text}[scales]\npa = "40 mm"\n'), exact=True)
    assert made.table("velocities")[segment].mm[0] == pytest.approx(40.0)


def test_a_crank_at_rest_has_its_velocities_to_the_scale_of_its_lengths() -> None:
    """μ_v = μ_l·ω₁ of the possible velocities, ω₁ = 1 1/s: pa = OA."""
    still = LEVER.replace('"2 rad/s"', "0")
    made = tmm.draw(tmm.read(f'{still}[scales]\nOA = "50 mm"\nmu_v = "mu_l*omega1"\n'), exact=True)
    assert made.table("velocities")["pa"].mm[0] == pytest.approx(50.0)


def test_drives_together_that_begin_clockwise_count_their_positions() -> None:
    first = FIRST.replace('zero = "60 deg"\n', 'turns = "clockwise"\n')
    made = drawn_of(tmm.read(HEAD + FIVE_BAR + first + SECOND))
    assert made.project.coordinates == (0.0, -120.0, -240.0)
    np.testing.assert_allclose(KINEMATICS_PLAN.on(made).numbers, [0.0, 1.0, 2.0])
