"""Four-bars and slider-cranks with masses, drawn at random, and what shakes their frame by vector loops."""

from __future__ import annotations

import cmath
import math
import random
from dataclasses import replace
from pathlib import Path
from typing import NamedTuple

import numpy as np

from graphic_tmm.chapters.balance.plan import BALANCE_PLAN, Whole
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.drawn import Drawn
from graphic_tmm.mechanism.records import Link, Mechanism
from graphic_tmm.scene.read import read
from support.boards import drawn_of
from support.oracle import State, solve_from_points
from support.scenes import written

HEAD = 'title = "T"\nlanguage = "en"\n'


class Put(NamedTuple):
    """A mass (kg) on a link, at a place in the link's own axes (m)."""

    link: int
    mass: float
    at: complex


def link_text(number: int, points: dict[str, complex], mass: float, inertia: float = 0.0) -> str:
    """Return the section of a link whose mass centre is S and its number."""
    told = ", ".join(f"{k} = [{z.real!r}, {z.imag!r}]" for k, z in points.items())
    text = f"[[link]]\nnumber = {number}\npoints = {{ {told} }}\nmass = {mass!r}\n"
    text += f'centre = "S{number}"\n'
    return text + (f"J = {inertia!r}\n" if inertia else "")


def four_bar_text(pick: random.Random, *, in_line: bool = False) -> str:
    """Return the scene of a crank-rocker, mass centres anywhere or ``in_line`` with the pins."""
    frame = complex(pick.uniform(0.25, 0.35), pick.uniform(-0.05, 0.05))
    r, rod, s = pick.uniform(0.05, 0.1), pick.uniform(0.28, 0.34), pick.uniform(0.2, 0.26)

    def centre(length: float) -> complex:
        off = 0.0 if in_line else pick.uniform(-0.3, 0.3)
        return length * complex(pick.uniform(0.1, 0.9), off)

    masses = [pick.uniform(0.5, 3.0) for _ in range(3)]
    text = f"{HEAD}[frame]\nO = [0, 0]\nC = [{frame.real!r}, {frame.imag!r}]\n"
    text += link_text(1, {"O": 0j, "A": complex(r), "S1": centre(r)}, masses[0])
    text += link_text(2, {"A": 0j, "B": complex(rod), "S2": centre(rod)}, masses[1], 0.02)
    text += f'side = "{pick.choice(("left", "right"))} of AC"\n'
    text += link_text(3, {"C": 0j, "B": complex(s), "S3": centre(s)}, masses[2], 0.015)
    return text + drive_text(pick)


def slider_crank_text(pick: random.Random, *, in_line: bool = False) -> str:
    """Return the scene of a slider-crank, offset and with an inclined guide."""
    r = pick.uniform(0.04, 0.1)
    rod = r * pick.uniform(3.0, 5.0)
    off, angle = r * pick.uniform(-0.6, 0.6), pick.uniform(-180.0, 180.0)
    through = off * 1j * cmath.rect(1.0, math.radians(angle))
    side = 0.0 if in_line else pick.uniform(-0.2, 0.2)
    masses = [pick.uniform(0.5, 3.0) for _ in range(3)]
    text = f"{HEAD}[frame]\nO = [0, 0]\n"
    text += f"x = {{ through = [{through.real!r}, {through.imag!r}], angle = {angle!r} }}\n"
    text += link_text(1, {"O": 0j, "A": complex(r), "S1": r * complex(0.3, side)}, masses[0])
    text += link_text(
        2, {"A": 0j, "B": complex(rod), "S2": rod * complex(0.35, side)}, masses[1], 0.01
    )
    text += link_text(3, {"B": 0j, "S3": complex(0.02, 0.0)}, masses[2])
    text += 'slides = { on = "frame", along = "x", side = "+" }\n'
    return text + drive_text(pick)


def drive_text(pick: random.Random) -> str:
    """Return the section of the drive, either way round, with or without an angular acceleration."""
    turns = pick.choice(("counterclockwise", "clockwise"))
    more = pick.choice(("", 'acceleration = "300 rad/s^2"\n'))
    speed = f'speed = "{pick.randint(100, 900)} rpm"'
    return f'[drive]\nlink = 1\n{speed}\nturns = "{turns}"\npositions = 8\n{more}'


def counterweight_text(one: Put, arm: complex) -> str:
    """Return the section of a counterweight; ``arm``: from the pivot to the pin, in the link's own axes."""
    angle = math.degrees(cmath.phase(one.at / arm))
    told = f"link = {one.link}\nmass = {one.mass!r}\nradius = {abs(one.at)!r}\nangle = {angle!r}\n"
    return f"[[counterweight]]\n{told}"


def drawn(folder: Path, text: str) -> Drawn:
    """Return the mechanism of a scene, drawn and read exactly."""
    return drawn_of(read(written(folder, text)), exact=True)


def states(made: Drawn) -> list[State]:
    """Return every position by vector loops; what was drawn only says which assembly is meant."""
    plans = KINEMATICS_PLAN.on(made)
    mechanism, mu = plans.mechanism, made.value(plans.mu_l)
    letters = sorted({k for link in mechanism.by_number.values() for k in link.points})
    origin = mechanism.frame.points[plans.structure.origin]
    found = []
    for k, angle in enumerate(made.project.coordinates):
        assert angle is not None
        places = {}
        for letter in letters:
            row = np.broadcast_to(made.reading[plans.positions.point(letter)][0], len(made.names))
            places[letter] = complex(row[k]) * mu + origin
        found.append(solve_from_points(mechanism, angle, places))
    return found


def masses_of(mechanism: Mechanism) -> list[Put]:
    """Return the masses of the links at their centres."""
    return [
        Put(link.number, link.mass, link.points[link.centre])
        for link in mechanism.links
        if link.mass and link.centre
    ]


def shaken(state: State, put: list[Put], about: str, inertia: bool = True) -> tuple[complex, float]:
    """Return the sum of −m·a, N, and its moment about a point of the frame with the couples −J·ε, N·m."""
    total, turning = 0j, 0.0
    fixed = state.points[about, state.mechanism.frame.number].r
    for link, mass, at in put:
        first = next(iter(state.mechanism.by_number[link].points))
        own = state.mechanism.by_number[link].points[first]
        motion, angle = state.points[first, link], state.pose[link][2]
        arm = (at - own) * cmath.rect(1.0, angle)
        gain = motion.a + (1j * state.epsilon[link] - state.omega[link] ** 2) * arm
        total += -mass * gain
        turning += ((motion.r + arm - fixed).conjugate() * (-mass * gain)).imag
    for one in state.mechanism.links if inertia else ():
        turning -= (one.inertia or 0.0) * state.epsilon[one.number]
    return total, turning


def vectors(made: Drawn, whole: Whole) -> tuple[np.ndarray, np.ndarray]:
    """Return the shaking force (complex, N) and its moment (N·m) in all positions, as drawn."""
    mu = made.value(BALANCE_PLAN.on(made).mu)
    count = len(made.names)
    force = np.broadcast_to(made.reading[whole.end][0], count) * mu
    return force, np.broadcast_to(made.reading[whole.moment][0], count)


def with_weights(mechanism: Mechanism, put: list[Put]) -> Mechanism:
    """Return the mechanism with further masses as parts of its links."""

    def heavier(link: Link) -> Link:
        own = [one for one in (*masses_of(mechanism), *put) if one.link == link.number]
        mass = sum(one.mass for one in own)
        if not mass:
            return link
        centre = sum(one.mass * one.at for one in own) / mass
        return replace(
            link,
            points={**link.points, f"Z{link.number}": centre},
            mass=mass,
            centre=f"Z{link.number}",
        )

    return replace(mechanism, links=tuple(map(heavier, mechanism.links)))
