"""Mechanisms as they lie, and back: the same motion, whatever the position they are seen in."""

from __future__ import annotations

import cmath
import math
from dataclasses import replace

import pytest
from support import gallery
from support.each import each
from support.sketched import apart, standing

from graphic_tmm.mechanism.records import Guide, Link, Mechanism, Slide
from graphic_tmm.mechanism.sketch import built, lying, poses_of

NAMES = gallery.NAMES


@each("name", NAMES)
def test_a_mechanism_that_lies_somewhere_has_the_lengths_and_sides_of_its_scene(name: str) -> None:
    """Seen in three positions each time the same motion comes of it, also behind places where sides change."""
    for one in standing(name):
        turns = not one.mechanism.drive.slides and not one.mechanism.drive.rack
        found = built(one.drawn, one.at if turns else 0.0)
        at = [other.at for other in standing(name)]
        assert apart(one.scene, replace(one.scene, mechanism=found.mechanism), at) < 1e-12


def test_own_axes_go_from_the_first_letter_to_the_next() -> None:
    (one, *_) = standing("crank-rocker")
    turned = lying(one.mechanism, one.places)
    for link in built(turned).mechanism.links:
        first, second, *_ = link.points.values()
        assert first == 0
        assert second.imag == 0.0
        assert second.real > 0.0


def test_doubt_is_nothing_where_both_assemblies_meet() -> None:
    """Of the angle at the inner pin its sine tells."""
    frame = Link(0, {"O": 0j, "C": 0.4 + 0j})
    for angle in (0.0, 1.0, 30.0, 90.0):
        b = 0.2 + 0.1j
        a = b + cmath.rect(0.15, math.radians(200.0))
        c = b + cmath.rect(0.3, math.radians(20.0 + angle))
        frame = Link(0, {"O": a - 0.1j, "C": c})
        drawn = Mechanism(
            frame,
            (
                Link(1, {"O": a - 0.1j, "A": a}),
                Link(2, {"A": a, "B": b}),
                Link(3, {"C": c, "B": b}),
            ),
            _crank(),
        )
        assert built(drawn).doubt["2-3"] == pytest.approx(math.sin(math.radians(angle)), abs=1e-12)


def _crank():  # type: ignore[no-untyped-def]
    return gallery.scene("crank-rocker").mechanism.drive  # type: ignore[union-attr]


def test_what_nothing_holds_is_named() -> None:
    """A link none of whose letters has a place."""
    frame = Link(0, {"O": 0j})
    guide = Guide("z", 0j, 0.0)
    links = (
        Link(1, {"O": 0j, "A": 0.1 + 0j}),
        Link(2, {"A": 0j}, slides=(Slide(3, guide),)),
        Link(3, {"D": 0j}, guides=(guide,), slides=(Slide(4, guide),)),
        Link(4, {"E": 0j}, guides=(guide,)),
    )
    with pytest.raises(ValueError, match=r"^4$"):
        poses_of(Mechanism(frame, links, _crank()), {"O": 0j, "A": 0.1j, "D": 1j, "X": 2j})


def test_a_wheel_about_one_pin_lies_as_it_is() -> None:
    """It has one letter and nothing that slides: how it is turned cannot be seen."""
    links = (Link(1, {"O": 0j, "A": 0.1 + 0j}), Link(4, {"D": 0j}))
    places = {"O": 0j, "A": 0.1j, "D": 1 + 0j}
    poses = poses_of(Mechanism(Link(0, {"O": 0j, "D": 1 + 0j}), links, _crank()), places)
    assert (poses[4].origin, poses[4].angle) == (1 + 0j, 0.0)
