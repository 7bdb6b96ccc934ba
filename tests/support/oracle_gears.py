"""What the judge of the plans knows of wheels on links: they roll on each other, seen from their arm."""

from __future__ import annotations

from collections.abc import Callable, Mapping
from typing import Any, NamedTuple

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.mechanism.records import Mechanism

Numbers = NDArray[Any]


class OracleError(Exception):
    """The loops do not close, or closed somewhere else than the caller said."""


class Gears(NamedTuple):
    """Seen from links ``arm``, ``second`` turn ``share`` times as far as ``first``, from ``start``."""

    first: NDArray[np.intp]
    second: NDArray[np.intp]
    arm: NDArray[np.intp]
    share: Numbers
    start: Numbers

    def residual(self, t: Numbers) -> Numbers:
        """What is left of that at the angles of the links (rad)."""
        arm = t[self.arm]
        return np.asarray(t[self.second] - arm - self.share * (t[self.first] - arm) - self.start)

    def enter(self, jacobian: Numbers, row: int) -> None:
        """Write its derivatives down, from a row on."""
        rows = row + np.arange(len(self.first))
        jacobian[rows, 3 * self.second + 2] = 1
        jacobian[rows, 3 * self.first + 2] = -self.share
        jacobian[rows, 3 * self.arm + 2] += self.share - 1


def angles_of_wheels(mechanism: Mechanism, angles: Mapping[int, float]) -> dict[int, float]:
    """Return the angles (rad) of links with those of wheels that follow from the wheel they meet."""
    known = dict(angles)
    place = {number: i for i, number in enumerate(mechanism.by_number)}
    gears, numbers = gears_of(mechanism, place, np.array, np.pi), list(place)
    rows = zip(gears.first, gears.second, gears.arm, gears.share, gears.start, strict=True)
    for first, second, arm, share, start in rows:
        a, b, c = numbers[first], numbers[second], numbers[arm]
        if a in known and c in known:
            known.setdefault(b, known[c] + share * (known[a] - known[c]) + start)
    return known


def gears_of(
    mechanism: Mechanism, place: Mapping[int, int], numbers: Callable[[Any], Numbers], pi: Any
) -> Gears:
    """Return the wheels of a mechanism, links by their ``place``."""
    meshed, shares = [], []
    for mesh in mechanism.meshes:
        arm = next(
            n
            for n, one in mechanism.by_number.items()
            if n not in mesh.links and set(mesh.centres) <= one.points.keys()
        )
        meshed.append([place[n] for n in (*mesh.links, arm)])
        shares.append(
            (1.0 if mesh.internal or mesh.by in ("belt", "chain") else -1.0)
            * mesh.sizes[0]
            / mesh.sizes[1]
        )
    first, second, arms = np.array(meshed, dtype=np.intp).reshape(-1, 3).T
    starts = numbers([mesh.start for mesh in mechanism.meshes]) * (pi / 180)
    return Gears(first, second, arms, numbers(shares), starts)


def crank_letters(mechanism: Mechanism) -> tuple[str, str]:
    """Give the crank's fixed pivot and its driven letter; its angle is that from one to the other.

    Driven is the first other letter shared with a moving link; of a crank that shares none (it only
    carries a guide) the first other letter it has.
    """
    crank = mechanism.by_number[mechanism.drive.link]
    pivots = [letter for letter in crank.points if letter in mechanism.frame.points]
    others = [letter for letter in crank.points if letter not in mechanism.frame.points]
    if len(pivots) != 1 or not others:
        raise OracleError(f"link {crank.number} needs one letter of the frame and one of its own")
    rest = [link for link in mechanism.links if link is not crank]
    shared = [letter for letter in others if any(letter in link.points for link in rest)]
    return pivots[0], (shared or others)[0]
