"""Plates of which no leg turns: as many places as a search along an angle finds; refused where not held."""

from __future__ import annotations

import cmath
import math

import numpy as np
import pytest
from chapters.kinematics.test_branches import refused
from support.plates import Machine, machine
from support.turns import in_turn

import graphic_tmm as tmm
from graphic_tmm.errors import StructureError

PARTS = 20_000
"""So finely the plate is turned in the search."""
CASES = [(seed, slots) for seed in range(20) for slots in range(4)]


def plate_of(one: Machine) -> int:
    """Return the number of the plate: the last with a point B."""
    return next(link for letter, link in reversed(one.letters) if letter == "B")


def rows(one: Machine, turned: np.ndarray) -> list[np.ndarray]:
    """Return of each leg of a turned plate, whose place is (x, y), the numbers a, b, c of a·x + b·y + c = 0."""
    bodies, plate = one.bodies, plate_of(one)
    q, start = bodies.start(), bodies.poses[plate][1]
    found = []
    for guide in bodies.guides:
        if plate not in (guide.first, guide.second):
            # a pin of the plate, its leg slides: the pin keeps to the guide
            (pin,) = (pin for pin in bodies.pins if {guide.first, plate} == {*pin[::2]})
            own = pin.b if pin.second == plate else pin.a
            at, way = 0j, 0.0
            if guide.second:
                at, way = bodies.poses[guide.second]
            along = cmath.exp(1j * (way + guide.angle))
            through = at + guide.through * cmath.exp(1j * way)
            normal = 1j * along * np.ones_like(turned)
            off = own * turned - through
        else:
            # the leg is turned as the plate is, about its pivot
            leg = guide.first if guide.second == plate else guide.second
            (pin,) = (pin for pin in bodies.pins if leg in pin[::2] and plate not in pin[::2])
            own, held, body = (
                (pin.a, pin.b, pin.second) if pin.first == leg else (pin.b, pin.a, pin.first)
            )
            pivot = bodies.place(q, body, held) if body else held
            lean = cmath.exp(1j * (bodies.poses[leg][1] - start))
            base = pivot - own * turned * lean
            if guide.first == leg:
                normal = 1j * turned * cmath.exp(1j * guide.angle)
                off = guide.through * turned - base - guide.a * turned * lean
            else:
                normal = 1j * turned * lean * cmath.exp(1j * guide.angle)
                off = guide.a * turned - base - guide.through * turned * lean
        found.append(np.stack([normal.real, normal.imag, (np.conj(normal) * off).real], axis=-1))
    return found


def places(one: Machine) -> int:
    """Return in how many ways three slides hold a plate: where three lines for its place meet in one point."""
    turned = np.exp(2j * np.pi * np.arange(PARTS) / PARTS)
    off = np.sign(np.linalg.det(np.stack(rows(one, turned), axis=-2)))
    return int(np.sum(off != np.roll(off, -1)))


@pytest.mark.parametrize(("seed", "slots"), in_turn(CASES, 8))
def test_as_many_places_as_three_lines_meet_in(seed: int, slots: int) -> None:
    one = machine(seed, guides=3 - slots, slots=slots)
    turned = np.exp(1j * np.array([one.bodies.poses[plate_of(one)][1]]))
    assert abs(np.linalg.det(np.stack(rows(one, turned), axis=-2))[0]) < 1e-12
    assert f"can be assembled in {places(one)} ways" in refused(one)


HEAD = """
title = "Loose"
[frame]
O = [0, 0]
{frame}
[[link]]
number = 1
points = {{ O = [0, 0], A = [0.05, 0] }}
"""
DRIVE = "[drive]\nlink = 1\nspeed = 10\npositions = 6\n"


def on_guides(ways: list[float], pins: list[complex], through: list[complex]) -> str:
    """Return a plate whose pins are on three guides of the frame."""
    frame = [
        f'{name} = {{ through = [{z.real!r}, {z.imag!r}], angle = "{way} deg" }}'
        for name, way, z in zip("uvw", ways, through, strict=True)
    ]
    text = HEAD.format(frame="\n".join(frame))
    for number, letter, name in zip((2, 3, 4), "BCF", "uvw", strict=True):
        text += (
            f"[[link]]\nnumber = {number}\npoints = {{ {letter} = [0, 0] }}\n"
            f'slides = {{ on = "frame", along = "{name}" }}\n'
        )
    own = ", ".join(f"{k} = [{z.real!r}, {z.imag!r}]" for k, z in zip("BCF", pins, strict=True))
    return f"{text}[[link]]\nnumber = 5\npoints = {{ {own} }}\n{DRIVE}"


def past_pivots(ways: list[float], pivots: list[complex], through: list[complex]) -> str:
    """Return a plate whose three guides pass pivots of the frame, or the first the crank's pin."""
    letters = "ADE" if len(pivots) == 2 else "CDE"
    fixed = zip(letters[-len(pivots) :], pivots, strict=True)
    frame = "\n".join(f"{k} = [{z.real!r}, {z.imag!r}]" for k, z in fixed)
    text = HEAD.format(frame=frame)
    for number, letter, name in zip((2, 3, 4), letters, "uvw", strict=True):
        text += (
            f"[[link]]\nnumber = {number}\npoints = {{ {letter} = [0, 0] }}\n"
            f'slides = {{ on = 5, along = "{name}" }}\n'
        )
    guides = ", ".join(
        f'{name} = {{ through = [{z.real!r}, {z.imag!r}], angle = "{way} deg" }}'
        for name, way, z in zip("uvw", ways, through, strict=True)
    )
    plate = f"points = {{ B = [0, 0], S = [0.1, 0.01] }}\nguides = {{ {guides} }}\n"
    return f"{text}[[link]]\nnumber = 5\n{plate}{DRIVE}"


ROUND = [0.1 + 0.1 * cmath.exp(2j * math.radians(way)) for way in (0, 60, 120)]
"""Points on lines through O, at 0°, 60°, 120°, all on one circle with it."""
AT_O = [0j, 0j, 0j]
APART = [0.1 + 0.02j, 0.15 + 0.1j, 0.2 - 0.1j]
LOOSE = {
    "three parallel guides": on_guides([37, 37, 37], ROUND, APART),
    "one turned back": on_guides([37, 217, 37], ROUND, APART),
    "two points of it lead the third": on_guides([0, 60, 120], ROUND, AT_O),
    "no circle goes so": on_guides([0, 60, 120], ROUND, [0j, 0j, 0.03j]),
    "three parallel ones along it": past_pivots([20, 20, 20], [0.2 + 0.05j, 0.1 + 0.2j], APART),
    "it turns about a circle": past_pivots([0, 60, 120], ROUND, AT_O),
}
HELD = {
    "guides that cross": on_guides([37, 80, 120], ROUND, APART),
    "guides along it that cross": past_pivots([20, 80, 140], [0.2 + 0.05j, 0.1 + 0.2j], APART),
    "two of three are parallel": on_guides([37, 37, 120], ROUND, APART),
}


@pytest.mark.parametrize("kind", LOOSE)
def test_a_plate_that_no_slide_holds_is_refused_by_name(kind: str) -> None:
    with pytest.raises(StructureError, match=r"along u, v, w link 5 is free to move.*turn one of"):
        tmm.motion(tmm.read(LOOSE[kind]), [30.0])


@pytest.mark.parametrize("kind", HELD)
def test_a_plate_that_slides_hold_can_be_assembled(kind: str) -> None:
    with pytest.raises(StructureError, match="can be assembled in 2 ways"):
        tmm.motion(tmm.read(HELD[kind]), [30.0])


def test_a_plate_that_is_too_small_for_its_guides_is_not_reached() -> None:
    text = on_guides(
        [0, 60, 120], [0.01 * (z + 0.02j * abs(z)) for z in ROUND[:2]] + [0.01j], APART
    )
    with pytest.raises(StructureError, match="link 5 is not reached: change lengths"):
        tmm.motion(tmm.read(text), [30.0])
