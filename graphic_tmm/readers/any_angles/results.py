"""Results of `motion`: arrays along the angles, in SI, by point, link, reaction."""

from __future__ import annotations

from collections.abc import Iterable, Iterator, Mapping
from dataclasses import dataclass
from typing import Any

import numpy as np

from graphic_tmm.board.values import Complexes, Reals
from graphic_tmm.errors import ConstructionError, needed
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Sweep
from graphic_tmm.readers.any_angles.turn import Plan
from graphic_tmm.readers.writing import ANGLE, LENGTH

Points = Mapping[tuple[str, int], Complexes]
"""Of a letter on a link, x + iy in the frame's axes, (angle,)."""
OF_LINKS = ("omega", "epsilon", "forces", "balance", "columns", "profile", "centres", "analogues")
"""What is told of links, and of boards of their own."""
COMPONENTS = {"places": "", "velocities": "v", "accelerations": "a"}
"""Names of a point's components in a data frame: D.x, D.vx, D.ax."""
SHOWN = 6
"""Greatest number of names in the printed form of a motion."""


class NotAsked(Mapping[Any, Any]):
    """A quantity that was not computed: it is false, and raises an error that says how to get it when used."""

    def __init__(self, plan: Plan) -> None:
        self.plan = plan

    def __getitem__(self, key: object) -> Any:
        raise self._error()

    def __iter__(self) -> Iterator[Any]:
        raise self._error()

    def __len__(self) -> int:
        return 0

    def __repr__(self) -> str:
        return f"<{self._error()}>"

    def _error(self) -> ConstructionError:
        says = said(
            'motion: {plan} were not asked for: write plans=["{plan}"], or name it among others',
            plan=self.plan,
        )
        return ConstructionError(says)


@dataclass(frozen=True)
class PointMotion:
    """How a point of a link moves: x + iy in the frame's axes, along the angles."""

    letter: str
    link: int
    of: Motion

    @property
    def place(self) -> Complexes:
        """Where it is, m."""
        return self.of.places[self._key]

    @property
    def velocity(self) -> Complexes:
        """Its velocity, m/s."""
        return self.of.velocities[self._key]

    @property
    def acceleration(self) -> Complexes:
        """Its acceleration, m/s²."""
        return self.of.accelerations[self._key]

    @property
    def _key(self) -> tuple[str, int]:
        return self.letter, self.link

    def __repr__(self) -> str:
        return f"<point {self.letter} of link {self.link} at {self.of.at.size} {self.of.kind}>"


@dataclass(frozen=True, repr=False)
class Motion:
    """The motion of a mechanism where its drive stands; every array runs along these places, (angle,), in SI.

    NaN where nothing assembles. What is the same at all of them is an array of one number repeated, which takes
    no memory and cannot be written to; a point of two links that are pinned together is one array. ``k["D"]``
    is the point D: ``k["D"].place``, ``.velocity``, ``.acceleration``; ``k["D", 5]`` as a point of link 5.
    A quantity that was not computed raises, when it is used, an error that says how to get it.

    Attributes
    ----------
    at
        Where the drive stands, as passed: directions of the crank, degrees; of what slides, m.
    sweep
        What it goes through, and in which unit.
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
        Further drives by their links, by groups and by their own levers: ``P_bal_4``, ``P_bal_4_lever``.
    columns
        Of a cam, of a train, of a pair of gears, by the names of their tables, in SI, but pressure angles and
        angles of wheels in degrees, their speeds in rpm: ``S``, ``dS``, ``ddS`` by radians, ``v``, ``a`` or, of
        a lever, ``omega``, ``eps``, ``pressure``; ``n1``, ``planetary_n_H``; and how far wheels have turned,
        ``phi1``, ``planetary_phi_H``. Of centrodes P_20 of link 2 on the frame 0, m: ``x20``, ``y20`` from the
        first pivot along the axes of the frame, ``xi20``, ``eta20`` from the first of two points of the link,
        along and square to their line. Radii of curvature by points, m: ``rho_K``. NaN where there is none.
    profile
        Points of the cam, in axes that turn with it, from its centre, m, x + iy: ``K`` of its profile, ``B`` of
        the theoretical one, or of the follower on arcs.
    centres
        In the frame's axes, m, x + iy: instantaneous centres, ``P20``; of a link whose curvature is asked for
        ``P``, ``Π``, its pole of accelerations, ``K_0``, the centre of curvature of the path of K. NaN where
        they are infinitely far; those that always are are left out.
    analogues
        Of points of [hodograph], in the frame's axes, m, x + iy: ``dS_K`` and ``ddS_K``, the first and the
        second derivative of the place of K by the turn of the crank, radians in its own sense.
    """

    at: Reals
    sweep: Sweep
    places: Points
    velocities: Points
    accelerations: Points
    omega: Mapping[int, Reals]
    epsilon: Mapping[int, Reals]
    forces: Mapping[str, Complexes]
    balance: Mapping[str, Reals]
    columns: Mapping[str, Reals]
    profile: Mapping[str, Complexes]
    centres: Mapping[str, Complexes]
    analogues: Mapping[str, Complexes]

    @property
    def angles(self) -> Reals:
        """Directions of the crank as passed, degrees; NaN where the drive slides."""
        return self.at if self.sweep.turns else np.full(self.at.shape, np.nan)

    @property
    def kind(self) -> str:
        """What the places of the drive are: "angles" or "lengths"."""
        return "angles" if self.sweep.turns else "lengths"

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
        if not self._same_everywhere(point):
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

    def to_pandas(self) -> Any:
        """Return a data frame: a row an angle, a column a component, in SI.

        Returns
        -------
        pandas.DataFrame
            ``angle_deg``, or ``length_m`` where the drive slides; of points ``D.x``, ``D.y``, ``D.vx``,
            ``D.vy``, ``D.ax``, ``D.ay``, where links differ in theirs ``D(5).x``; ``omega3``, ``epsilon3``;
            ``R12.x``, ``R12.y``; the balance; ``P20.x``; ``dS_K.x``; of other chapters their columns.

        Raises
        ------
        MissingError
            If pandas is not installed.
        """
        found: dict[str, Reals] = {str(ANGLE if self.sweep.turns else LENGTH): self.at}
        for letter, link in self._points:
            name = letter if self._same_everywhere(letter) else f"{letter}({link})"
            for quantity, of in COMPONENTS.items():
                if values := getattr(self, quantity):
                    found |= _components(f"{name}.{of}", values[letter, link])
        found |= {f"omega{link}": row for link, row in self._of("omega").items()}
        found |= {f"epsilon{link}": row for link, row in self._of("epsilon").items()}
        for name, row in {**self._of("forces"), **self._own}.items():
            found |= _components(f"{name}.", row)
        found |= self.columns
        return needed("pandas", "pandas").DataFrame({**found, **self._of("balance")})

    def _of(self, quantity: str) -> Mapping[Any, Any]:
        """Return the arrays of a quantity; none if it was not computed."""
        return getattr(self, quantity) or {}

    @property
    def _own(self) -> Mapping[str, Complexes]:
        return {**self.profile, **self.centres, **self.analogues}

    @property
    def _points(self) -> dict[tuple[str, int], Any]:
        return dict.fromkeys(key for quantity in COMPONENTS for key in self._of(quantity))

    def _same_everywhere(self, letter: str) -> bool:
        """Whether the points of all links at a letter move as one."""
        first, *others = (key for key in self._points if key[0] == letter)
        plans = [self._of(quantity) for quantity in COMPONENTS]
        return all(plan.get(first) is plan.get(one) for plan in plans for one in others)

    def __repr__(self) -> str:
        there = {"points": _listed(letter for letter, _ in self._points)}
        for name in OF_LINKS:
            there[name] = _listed(getattr(self, name) or ())
        told = "; ".join(f"{name} {value}" for name, value in there.items() if value)
        return f"<motion at {self.at.size} {self.kind}: {told}>"


def _listed(names: Iterable[object]) -> str:
    """Return the first of some names, each once."""
    every = list(dict.fromkeys(map(str, names)))
    return ", ".join(every if len(every) <= SHOWN else [*every[: SHOWN - 1], "..."])


def _components(name: str, vector: Complexes) -> dict[str, Reals]:
    return {f"{name}x": np.real(vector), f"{name}y": np.imag(vector)}
