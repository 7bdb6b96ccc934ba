"""Joints of scenes moved in the position drawn, and where letters stand when the scene is read anew."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator

import graphic_tmm
from graphic_tmm.mechanism.guides import turn
from graphic_tmm.mechanism.records import Mechanism
from support.sketched import Places, Standing

FAR = 5e-3
"""How far a joint is moved, m."""


def movable(one: Standing) -> Iterator[tuple[str, complex]]:
    """Every joint with a place 5 mm off; what a guide holds goes along it, its own before that of another."""
    for letter, at in one.places.items():
        if (one.mechanism.further or one.mechanism.meshes) and letter in one.mechanism.pins:
            continue  # a second drive, or a wheel, stands elsewhere as soon as the first does
        ways = [*_held(one.drawn, letter, own=True), *_held(one.drawn, letter, own=False)]
        yield letter, at + (ways[0] if ways else FAR * (0.6 + 0.8j))


def _held(drawn: Mechanism, letter: str, *, own: bool) -> Iterator[complex]:
    """The ways along guides on which a letter stands; not ``own``: of the link that has it."""
    for link in drawn.links:
        for slide in link.slides:
            on = drawn.by_number[slide.on]
            has = link.points if own else () if on is drawn.frame else on.points
            if letter in has:
                yield FAR * turn(slide.guide.angle)


def off(text: str, one: Standing, drawn: Mechanism, places: Places) -> float:
    """How far letters stand from their places, m, in a scene whose drive stands as it is drawn."""
    scene = graphic_tmm.read(text)
    assert scene.mechanism is not None
    found = graphic_tmm.motion(
        scene, [coordinate(one, drawn)], exact=True, plans=("positions",)
    ).places
    return max(abs(complex(z[0]) - places[letter]) for (letter, _), z in found.items())


def coordinate(one: Standing, drawn: Mechanism) -> float:
    """Where the drive of a mechanism that lies is: turned, or gone along, from where it was."""
    drive = one.mechanism.drive
    was, now = one.drawn.by_number[drive.link], drawn.by_number[drive.link]
    if not drive.slides:
        (a, b, *_), (c, d, *_) = was.points.values(), now.points.values()
        return one.at + math.degrees(cmath.phase((d - c) / (b - a)))
    slide = now.slides[0]
    way = turn(slide.guide.angle)
    (pin, *_), (start, *_) = now.points.values(), was.points.values()
    if slide.on == drawn.frame.number:
        return one.at + ((pin - start) / way).real
    (pivot, *_) = drawn.by_number[slide.on].points.values()
    (stood, *_) = one.drawn.by_number[slide.on].points.values()
    return one.at + ((pin - pivot) / way).real - ((start - stood) / way).real
