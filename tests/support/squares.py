"""Random mechanisms with two plates that two links join (class IV), as scenes, and all places of the plates.

Their motion is judged by the constraints of single bodies (`plates.Bodies`), their forces by Newton's and
Euler's equations of all links (`free_forces`). Nothing is known here of groups or special points.
"""

from __future__ import annotations

import math
import re
from typing import NamedTuple

import numpy as np

from support.plates import Assembly, Machine, Reals


class Square(NamedTuple):
    """A mechanism with two plates: the plates, the links that join them, the numbers of all four."""

    machine: Machine
    plates: tuple[int, int]
    joining: tuple[int, int]

    @property
    def text(self) -> str:
        return self.machine.text

    def place(self, poses: Reals, near: int = 0) -> str:
        """Return the scene for poses of all bodies; ``near``: of which plate it says near which place it is."""
        plate = self.plates[near]
        degrees = math.degrees(float(poses[3 * plate - 1])) % 360
        bare = re.sub(r"^near(_at)? = .*\n", "", self.text, flags=re.MULTILINE)
        head, table, rest = bare.partition(f"[[link]]\nnumber = {plate}\n")
        at = math.degrees(self.machine.phi)
        return f'{head}{table}near = "{degrees:.9f} deg"\nnear_at = "{at:.12f} deg"\n{rest}'

    def places(self, tries: int = 200) -> list[Reals]:
        """Return all places that the four links were found in, as poses of all bodies: the laid one first."""
        bodies, phi = self.machine.bodies, self.machine.phi
        found, chance = [bodies.start()], np.random.default_rng(7)
        moved = [3 * k - 1 for k in (*self.plates, *self.joining)]
        still = [k for k in range(found[0].size) if k // 3 + 1 not in (*self.plates, *self.joining)]
        for _ in range(tries):
            q = bodies.start()
            for k in moved:
                q[k] += chance.uniform(-math.pi, math.pi)
                q[k - 2 : k] += chance.uniform(-0.2, 0.2, 2)
            reached = bodies.settle(q, phi)
            if reached is None or np.abs(reached[still] - found[0][still]).max() > 1e-9:
                continue
            if all(_apart(reached, one, moved) > 1e-6 for one in found):
                found.append(reached)
        return found


def _apart(first: Reals, second: Reals, angles: list[int]) -> float:
    return float(np.abs(np.exp(1j * (first[angles] - second[angles])) - 1).max())


def square(
    seed: int, *, before: bool = False, behind: bool = False, loaded: bool = False
) -> Square:
    """Return a random mechanism with two plates on a crank and the frame, laid at some angle of the crank.

    ``before``: one plate is held by a dyad on the crank, the other by the crank; ``behind``: a dyad hangs on
    the other; ``loaded``: links have masses and loads, and forces are asked for.
    """
    one = Assembly(seed)
    if before:
        one.before()
    (first, on), *rest = reversed(one.held)
    second, under = rest[0] if rest else ("D", 0)
    _stand(one, first, "" if before else second)
    order = [first + "BE", second + "CF", "BC", "EF"]
    one.chance.shuffle(order)
    angles = {name: 2 * math.pi * one.some(0, 1) for name in order if len(name) == 3}
    number = {
        name: one.link(one.world[name[0]], angles[name], name) if name in angles else one.rod(*name)
        for name in order
    }
    plates = tuple(number[name] for name in angles)
    one.near(plates[0], angles[next(iter(angles))])
    for plate, under_it in ((first + "BE", on), (second + "CF", under)):
        one.pin(plate[0], number[plate], under_it)
    for rod in ("BC", "EF"):
        one.pin(rod[0], number[rod], number[first + "BE"])
        one.pin(rod[1], number[rod], number[second + "CF"])
    if behind:
        one.mark("L", number[second + "CF"], one.world["F"] + one.polar(0.03, 0.06))
        one.dyad("L", number[second + "CF"], "K", "M", (0.1, 0.2))
    if loaded:
        _load(one)
    return Square(one.machine("Square"), (plates[0], plates[1]), (number["BC"], number["EF"]))


def _stand(one: Assembly, first: str, fixed: str) -> None:
    """Stand the pins of both plates about a letter; ``fixed``: a new pivot of the second plate."""
    world = one.world
    for letter in "BE":
        world[letter] = world[first] + one.polar(0.08, 0.2)
    for letter, pin in zip("CF", "BE", strict=True):
        world[letter] = world[pin] + one.polar(0.1, 0.25)
    if fixed:
        one.fix(fixed, (world["C"] + world["F"]) / 2 + one.polar(0.08, 0.2))


def _load(one: Assembly) -> None:
    """Give every link but the crank a mass, a centre, a moment of inertia; forces and couples to some."""
    for number in sorted(one.bodies.poses):
        if number == 1:
            continue
        centre = f"S{number}"
        one.mark(centre, number, one.bodies.poses[number][0] + one.polar(0.02, 0.1))
        mass = one.some(0.3, 3.0)
        one.lines.setdefault(number, []).extend(
            [
                f'mass = "{mass!r} kg"',
                f'centre = "{centre}"',
                f"J = {mass * one.some(1e-3, 4e-3)!r}",
            ]
        )
        if one.some(0, 1) < 0.7:
            force, way = one.some(10, 90), one.some(0, 360)
            one.tables.append(
                f'[[load]]\nlink = {number}\npoint = "{centre}"\nforce = "{force!r} N"\n'
                f'direction = "{way!r} deg"\n'
            )
        if one.some(0, 1) < 0.5:
            one.tables.append(f'[[load]]\nlink = {number}\nmoment = "{one.some(-6, 6)!r} N*m"\n')
    one.tables.append("[effects]\ngravity = true\ninertia = true\n[forces]\npositions = [0]\n")
