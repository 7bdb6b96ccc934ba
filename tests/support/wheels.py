"""Random mechanisms with wheels on their links: one or two, each with a dyad of turning pairs hung on it.

A wheel is put on a pin of any link that shares another letter with a third one, which is the other wheel's: the
frame, the crank, a coupler, a rocker may be each of them. Angles, ratios and the sense of the mesh are free.
"""

from __future__ import annotations

import cmath
import math
import random
from dataclasses import replace

from graphic_tmm.chapters.kinematics.wheels import Wheels, Winding, Wound
from graphic_tmm.mechanism.records import Link, Mechanism, Mesh, Side
from support.mechanisms import KINDS, Pose, Sampled, assemble

FREE = "QWXYZVUTRNMLJHGF"


def geared(seed: int, wheels: int = 1, *, belted: bool = False) -> Sampled:
    """Draw one of a seed; its poses are those in which it was drawn. ``belted``: by belts, not teeth."""
    source = random.Random(seed)
    while True:
        drawn = assemble(lambda most: source.randint(0, most), (1, 2), KINDS[:3])
        crank = drawn.mechanism.by_number[1].points
        x, y, _ = drawn.poses[1]
        turned = math.radians(drawn.phi) - cmath.phase(crank["A"] - crank["O"])
        # whole turns count: the crank's angle is the one that is given, not that less a turn
        drawn = drawn._replace(poses={**drawn.poses, 1: (x, y, turned)})
        try:
            for _ in range(wheels):
                drawn = _with_wheel(drawn, source, belted)
        except IndexError:
            continue
        return drawn


def near(drawn: Sampled) -> Wound:
    """Return how angles go on: about those in which the mechanism was drawn."""

    def wound(number: int, wheels: Wheels) -> Winding:
        turned = math.degrees(drawn.poses[number][2])
        return Winding(0, turned + wheels.bodies[number].angle)

    return wound


def _with_wheel(drawn: Sampled, source: random.Random, belted: bool) -> Sampled:
    mechanism, places = drawn.mechanism, dict(drawn.points)
    poses: dict[int, Pose] = {mechanism.frame.number: (0.0, 0.0, 0.0), **drawn.poses}
    bodies = mechanism.by_number
    choices = [
        (arm, other, on, pin)
        for arm, one in bodies.items()
        for other in one.points
        for on, body in bodies.items()
        if on != arm and other in body.points
        for pin in one.points
        if pin not in (other, *body.points) and abs(places[pin] - places[other]) > 1e-9
    ]
    arm, other, on, pin = source.choice(choices)
    apart = abs(places[pin] - places[other])
    number = max(bodies) + 1
    turned = source.uniform(-math.pi, math.pi)
    sizes = source.uniform(0.3, 3.0), 1.0
    internal, by = source.random() < 0.5, "teeth"
    ratio = (1.0 if internal else -1.0) * sizes[0] / sizes[1]
    if belted:  # an open belt keeps the sense, as a ring does; its wheels stand apart
        room = source.uniform(0.05, 0.95) * apart / sum(sizes)
        sizes, by = (sizes[0] * room, room), "belt" if internal else "crossed belt"
        internal = False
    start = turned - poses[arm][2] - ratio * (poses[on][2] - poses[arm][2])
    mesh = Mesh((on, number), (other, pin), sizes, False, internal, math.degrees(start), by=by)
    if source.random() < 0.5:  # told the other way round
        back = math.degrees(-start / ratio)
        mesh = Mesh((number, on), (pin, other), sizes[::-1], False, internal, back, by=by)
    free = iter(letter for letter in FREE if letter not in places)
    end, fixed, middle = (next(free) for _ in range(3))
    way = cmath.rect(apart * source.uniform(0.3, 1.5), source.uniform(-math.pi, math.pi))
    places[end] = places[pin] + way * cmath.rect(1.0, turned)
    places[fixed] = places[end] + cmath.rect(apart, source.uniform(-math.pi, math.pi))
    base = places[fixed] - places[end]
    sign = source.choice((1, -1))
    arch = cmath.rect(source.uniform(0.4, 1.0), sign * source.uniform(0.5, 2.0))
    places[middle] = places[end] + base * arch
    poses[number] = (places[pin].real, places[pin].imag, turned)
    rod, rocker = number + 1, number + 2
    links = [Link(number, {pin: 0j, end: way})]
    for k, first in ((rod, end), (rocker, fixed)):
        span = places[middle] - places[first]
        poses[k] = (places[first].real, places[first].imag, cmath.phase(span))
        links.append(Link(k, {first: 0j, middle: abs(span) + 0j}))
    above = ((places[middle] - places[end]) * base.conjugate()).imag > 0
    links[1] = replace(links[1], side=Side(1 if above else -1, (end, fixed)))
    frame = replace(mechanism.frame, points={**mechanism.frame.points, fixed: places[fixed]})
    whole = Mechanism(
        frame,
        (*mechanism.links, *links),
        mechanism.drive,
        meshes=(*mechanism.meshes, mesh),
    )
    return Sampled(whole, drawn.phi, places, poses, (*drawn.kinds, "RRR"))
