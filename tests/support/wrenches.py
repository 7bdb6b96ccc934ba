"""Forces and couples on the links of a mechanism that stands where the oracle found it.

Forces are complex (N) in the sheet's axes; lengths are divided by the oracle's size; float64 or
mpmath numbers in the precision that is set.
"""

from __future__ import annotations

import cmath
from collections.abc import Mapping, Sequence
from dataclasses import dataclass
from typing import Any, NamedTuple

import mpmath  # type: ignore[import-untyped]
import numpy as np

from graphic_tmm.mechanism.groups import Pair
from graphic_tmm.mechanism.records import Mechanism, Mesh
from graphic_tmm.mechanism.structure import Structure
from support.oracle import Numbers, OracleError, State

G = 9.81  # m/s²
Forces = Sequence[tuple[int, str, complex]]  # link, letter, N
Moments = Sequence[tuple[int, float]]  # link, N·m


class StaticsError(OracleError):
    """The equations are singular, friction has no equilibrium (jamming), or a letter is missing."""


class Wrench(NamedTuple):
    """A force (N) at a place (sizes) and a couple (N·size) on a link."""

    link: int
    force: Any
    place: Any
    couple: Any


def on_both(i: int, j: int, force: Any, place: Any, couple: Any) -> list[Wrench]:
    """A wrench of link i on link j, and its reaction."""
    return [Wrench(j, force, place, couple), Wrench(i, -force, place, -couple)]


@dataclass(frozen=True)
class Stage:
    """The mechanism where it stands, in one arithmetic; lengths in sizes."""

    mechanism: Mechanism
    size: float
    digits: bool
    motion: Mapping[int, tuple[tuple[Any, Any], ...]]  # origin and angle, their two derivatives

    def number(self, value: float) -> Any:
        return mpmath.mpf(value) if self.digits else float(value)

    def own(self, link: int, place: complex) -> Any:
        """A place given in a link's own axes (m)."""
        z, theta = self.motion[link][0]
        return z + (mpmath.mpc if self.digits else complex)(place) / self.size * self.unit(theta)

    def unit(self, angle: Any) -> Any:
        return mpmath.expj(angle) if self.digits else cmath.rect(1.0, angle)

    def place(self, letter: str, link: int) -> Any:
        """A letter's place, as its own link has it, else any."""
        links = [self.mechanism.by_number[link], *self.mechanism.by_number.values()]
        for owner in (owner for owner in links if letter in owner.points):
            return self.own(owner.number, owner.points[letter])
        raise StaticsError(f"{letter} is on no link")

    def velocity(self, link: int, place: Any) -> Any:
        (z, _), (dz, omega), _ = self.motion[link]
        return dz + 1j * omega * (place - z)

    def acceleration(self, link: int, place: Any) -> Any:
        (z, _), (_, omega), (ddz, epsilon) = self.motion[link]
        return ddz + (1j * epsilon - omega * omega) * (place - z)

    @property
    def fastest(self) -> Any:
        """The largest rate of a link: of its angle, or of its origin in sizes."""
        return max(abs(v) for _, rates, _ in self.motion.values() for v in rates)

    def sign(self, rate: Any) -> int:
        return 0 if abs(rate) <= 1e-12 * self.fastest else 1 if rate > 0 else -1

    def column(self, wrenches: Sequence[Wrench]) -> Numbers:
        """Their sums on the moving links: Fx, Fy and the moment about the first letter, (3n,)."""
        links = self.mechanism.links
        found = np.zeros((len(links), 3), dtype=object if self.digits else float)
        for row, link in zip(found, links, strict=True):
            about = self.own(link.number, next(iter(link.points.values()), 0j))
            for wrench in (wrench for wrench in wrenches if wrench.link == link.number):
                turning = ((wrench.place - about).conjugate() * wrench.force).imag
                row += [wrench.force.real, wrench.force.imag, turning + wrench.couple]
        return found.ravel()

    def power(self, wrench: Wrench) -> Any:
        _, (_, omega), _ = self.motion[wrench.link]
        speed = self.velocity(wrench.link, wrench.place)
        return ((wrench.force.conjugate() * speed).real + wrench.couple * omega) * self.size

    def guide(self, pair: Pair, at: Mapping[str, str]) -> tuple[Any, Any]:
        """A guide's unit vector, and the place its couple is about."""
        slider, owner = pair.links
        assert pair.slide is not None
        pi = mpmath.pi if self.digits else cmath.pi
        _, theta = self.motion[owner][0]
        along = self.unit(theta + self.number(pair.slide.guide.angle) * pi / 180)
        if pair.name in at:
            return along, self.place(at[pair.name], slider)
        return along, self.own(owner, pair.slide.guide.through)


def stage_of(mechanism: Mechanism, state: State, digits: bool) -> Stage:
    """The mechanism in the position of a state; only the kinematics are the state's."""
    real, plain = (mpmath.mpf, mpmath.mpc) if digits else (float, complex)
    rows = [[list(map(real, row)) for row in part.tolist()] for part in state.rates]
    motion = {
        link: tuple((plain(x, y), turn) for x, y, turn in seen)
        for link, *seen in zip(state.mechanism.by_number, *rows, strict=True)
    }
    return Stage(mechanism, state.size, digits, motion)


def loads_of(
    stage: Stage, forces: Forces, moments: Moments, gravity: bool, inertia: bool
) -> list[Wrench]:
    """All that acts on the links but reactions, friction and balance."""
    number, nothing = stage.number, stage.number(0)
    found = [Wrench(k, p + 0 * nothing, stage.place(at, k), nothing) for k, at, p in forces]
    found += [Wrench(k, nothing, nothing, number(m) / stage.size) for k, m in moments]
    for link in stage.mechanism.links:
        if inertia and link.inertia is not None:
            couple = -number(link.inertia) * stage.motion[link.number][2][1] / stage.size
            found.append(Wrench(link.number, nothing, nothing, couple))
        if link.mass is None or link.centre is None:
            continue
        centre, mass = stage.place(link.centre, link.number), number(link.mass)
        if gravity:
            found.append(Wrench(link.number, -1j * number(G) * mass, centre, nothing))
        if inertia:
            force = -mass * stage.acceleration(link.number, centre) * stage.size
            found.append(Wrench(link.number, force, centre, nothing))
    return found


def carried(stage: Stage, pair: Pair, at: Mapping[str, str]) -> list[list[Wrench]]:
    """The two unknowns of a pair, of size 1: of the first link on the second (owner on slider)."""
    nothing, one = stage.number(0), stage.number(1)
    if pair.kind == "R":
        place = stage.place(pair.name, pair.links[0])
        return [on_both(*pair.links, force, place, nothing) for force in (one, 1j * one)]
    along, place = stage.guide(pair, at)
    slider, owner = pair.links
    normal = on_both(owner, slider, 1j * along, place, nothing)
    return [normal, on_both(owner, slider, nothing, place, one)]


def pressed(stage: Stage, mesh: Mesh, side: int) -> tuple[list[Wrench], list[Wrench]]:
    """What teeth do, of the first wheel on the second: 1 along the tangent, and apart for each of that.

    Of a belt: 1 along the run that leaves the first wheel on this side of the way to the second; +1 is left.
    """
    start, end = (
        stage.place(letter, link) for letter, link in zip(mesh.centres, mesh.links, strict=True)
    )
    nothing, (first, second) = stage.number(0), map(stage.number, mesh.sizes)
    if mesh.by != "teeth":
        way, sense = (end - start) / abs(end - start), -1 if mesh.by == "crossed belt" else 1
        cos = (first - sense * second) / stage.number(stage.size) / abs(end - start)
        out = way * (cos + 1j * side * (1 - cos * cos) ** stage.number(0.5))
        leaves, comes = (
            at + out * radius / stage.number(stage.size)
            for at, radius in ((start, first), (end, sense * second))
        )
        run = (leaves - comes) / abs(leaves - comes)
        return on_both(*mesh.links, run, comes, nothing), on_both(
            *mesh.links, nothing, comes, nothing
        )
    share = first / (first - second) if mesh.internal else first / (first + second)
    pitch, way = start + (end - start) * share, (end - start) / abs(end - start)
    steep = mpmath.tan(stage.number(mesh.pressure) * mpmath.pi / 180)
    apart = (-way if mesh.internal else way) * (steep if stage.digits else float(steep))
    return on_both(*mesh.links, 1j * way, pitch, nothing), on_both(
        *mesh.links, apart, pitch, nothing
    )


def balancing(stage: Stage, structure: Structure, balance: str) -> list[Wrench]:
    """The balancing moment (N·size), or force at the pin, +90° from pivot → pin; of size 1."""
    crank, nothing = structure.first.link, stage.number(0)
    if balance == "moment":
        return [Wrench(crank, nothing, nothing, stage.number(1))]
    pivot, pin = (stage.place(letter, crank) for letter in (structure.origin, structure.first.pin))
    return [Wrench(crank, 1j * (pin - pivot) / abs(pin - pivot), pin, nothing)]


def solved(matrix: Numbers, right: Numbers) -> Numbers:
    """Solve linear equations; raises StaticsError where they are singular."""
    try:
        if matrix.dtype != object:
            return np.asarray(np.linalg.solve(matrix, right))
        found = mpmath.lu_solve(mpmath.matrix(matrix.tolist()), mpmath.matrix(right.tolist()))
        return np.array(list(found), dtype=object)
    except (np.linalg.LinAlgError, ZeroDivisionError) as error:
        raise StaticsError("the equations of equilibrium are singular") from error
