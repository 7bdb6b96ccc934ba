"""What motion found: arrays along the angles asked for, in SI, by point, link, reaction."""

from __future__ import annotations

from collections.abc import Mapping
from dataclasses import dataclass, fields
from typing import Any

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.errors import ConstructionError
from graphic_tmm.language.said import said

Points = Mapping[tuple[str, int], Complexes]
"""Of a letter on a link, x + iy in the frame's axes, (angle,)."""
OF_LINKS = 4
"""Behind the angles and what is told of points."""


@dataclass(frozen=True)
class PointMotion:
    """How a point of a link moves: x + iy in the frame's axes, along the angles."""

    letter: str
    link: int
    of: Motion

    @property
    def place(self) -> Complexes:
        """Where it is, m."""
        return self._told(self.of.places, "positions")

    @property
    def velocity(self) -> Complexes:
        """Its velocity, m/s."""
        return self._told(self.of.velocities, "velocities")

    @property
    def acceleration(self) -> Complexes:
        """Its acceleration, m/s²."""
        return self._told(self.of.accelerations, "accelerations")

    def _told(self, values: Points, plan: str) -> Complexes:
        if not values:
            raise ConstructionError(
                said("motion: {plan} were not asked for: name them among plans", plan=plan)
            )
        return values[self._key]

    @property
    def _key(self) -> tuple[str, int]:
        return self.letter, self.link

    def __repr__(self) -> str:
        return f"<point {self.letter} of link {self.link} at {self.of.angles.size} angles>"


@dataclass(frozen=True, repr=False)
class Motion:
    """The motion of a mechanism at angles of its crank; every array runs along them, (angle,), in SI.

    NaN where nothing assembles. What is the same at all angles is an array of one number repeated, which takes
    no memory and cannot be written to; a point of two links that are pinned together is one array. ``k["D"]``
    is the point D: ``k["D"].place``, ``.velocity``, ``.acceleration``; ``k["D", 5]`` as a point of link 5.

    Attributes
    ----------
    angles
        Directions of the crank as asked for, degrees.
    places, velocities, accelerations
        By (letter, link): x + iy in the frame's axes, complex; m, m/s, m/s².
    omega, epsilon
        By the number of a link that can turn: rad/s, rad/s²; counter-clockwise positive.
    forces
        Reactions by the name of their column: ``R12`` is the force of link 1 on link 2, x + iy, N.
    balance
        What balances the crank, by the name of its column: ``P_bal_forces`` (by Assur groups) and
        ``P_bal_lever`` (by Zhukovsky's lever), a force at the crank's pin, N, positive where it is the arm
        turned by +90°; or ``M_bal_forces`` and ``M_bal_lever``, moments, N·m, counter-clockwise positive.
    """

    angles: Reals
    places: Points
    velocities: Points
    accelerations: Points
    omega: Mapping[int, Reals]
    epsilon: Mapping[int, Reals]
    forces: Mapping[str, Complexes]
    balance: Mapping[str, Reals]

    def __getitem__(self, point: str | tuple[str, int]) -> PointMotion:
        """Return how a point moves, by its letter, or by (letter, link) where links differ in it.

        Raises
        ------
        ConstructionError
            If there is no such point, or points of several links lie at the letter and move differently.
        """
        if not isinstance(point, str):
            if point not in self._points:
                known = ", ".join(f"{(letter, n)}" for letter, n in self._points)
                raise ConstructionError(
                    said(
                        "motion: there is no point {point}; there are {known}",
                        point=str(point),
                        known=known,
                    )
                )
            return PointMotion(*point, self)
        keys = [key for key in self._points if key[0] == point]
        if not keys:
            known = ", ".join(dict.fromkeys(letter for letter, _ in self._points))
            raise ConstructionError(
                said(
                    "motion: there is no point {point}; there are {known}", point=point, known=known
                )
            )
        if any(not self._same(keys[0], key) for key in keys[1:]):
            known = ", ".join(f"{key}" for key in keys)
            raise ConstructionError(
                said(
                    "motion: links differ in their point at {point}: say of which it is, {known}",
                    point=point,
                    known=known,
                )
            )
        return PointMotion(*keys[0], self)

    def __contains__(self, point: object) -> bool:
        """Whether there is a point of that letter, or of that (letter, link)."""
        return any(point in (key, key[0]) for key in self._points)

    @property
    def _points(self) -> dict[tuple[str, int], Any]:
        return dict.fromkeys((*self.places, *self.velocities, *self.accelerations))

    def _same(self, one: tuple[str, int], other: tuple[str, int]) -> bool:
        plans = (self.places, self.velocities, self.accelerations)
        return all(plan.get(one) is plan.get(other) for plan in plans)

    def __repr__(self) -> str:
        letters = ", ".join(dict.fromkeys(letter for letter, _ in self._points))
        there = {"points": letters}
        for one in fields(self)[OF_LINKS:]:
            there[one.name] = ", ".join(map(str, getattr(self, one.name)))
        told = "; ".join(f"{name} {value}" for name, value in there.items() if value)
        return f"<motion at {self.angles.size} angles: {told}>"
