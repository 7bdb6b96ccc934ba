"""Chains of dyads one on another: mechanisms as long as one likes, that can be drawn over the whole turn."""

from __future__ import annotations

import cmath

from graphic_tmm.mechanism.records import Drive, Link, Mechanism, Side

ROCKING = 0.3
"""The crank, m: so short beside links of 1 m that rockers swing a little and no dyad comes near its limit."""


def letters(place: int) -> tuple[str, str, str]:
    """The letters of a dyad: its inner pin, the pivot of its rocker, the pin of the next dyad."""
    return f"B{place}", f"C{place}", f"D{place}"


def chain(dyads: int) -> Mechanism:
    """A crank and so many dyads, each a coupler and a rocker that drives the next one: 2·dyads + 1 links.

    Couplers and rockers are as long as one another, at about a right angle. A third point of each rocker,
    near its pivot, drives the next dyad. Couplers have masses.
    """
    frame, links = {"O": 0j}, [Link(1, {"O": 0j, "A": complex(ROCKING, 0.0)})]
    pin, place = "A", 0j
    for k in range(dyads):
        inner, pivot, onward = letters(k + 1)
        centre = place + complex(1.0, 1.0)
        frame[pivot] = centre
        points = {pin: 0j, inner: 1 + 0j, f"S{2 * k + 2}": 0.5 + 0j}
        side = Side(1, (pivot, pin))
        coupler = Link(2 * k + 2, points, side=side, mass=2.0, inertia=0.1, centre=f"S{2 * k + 2}")
        rocker = Link(2 * k + 3, {pivot: 0j, inner: 1 + 0j, onward: cmath.rect(ROCKING, 2.0)})
        links += [coupler, rocker]
        pin, place = onward, centre
    return Mechanism(Link(0, frame), tuple(links), Drive(1, 10.0))
