"""An independent judge of kinetostatics: Newton's and Euler's equations of all links at once.

Unknown are the two components of the force in every turning pair, the normal force and the couple
in every sliding pair, and the balancing force or moment: three equations a moving link. Friction
makes them nonlinear, and Newton's method solves them. Nothing of the board or the plans is used:
only the records, the list of pairs, and the motion that the oracle found. SI units, forces complex
in the sheet's axes, moments counter-clockwise; inside, lengths are divided by the oracle's size.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Callable, Mapping, Sequence
from dataclasses import replace
from typing import Any, Literal, NamedTuple

import mpmath  # type: ignore[import-untyped]
import numpy as np
from hypothesis import strategies as st

from graphic_tmm.mechanism.groups import Pair
from graphic_tmm.mechanism.records import Link, Mechanism
from graphic_tmm.mechanism.structure import dissect
from support.oracle import Numbers, State
from support.wrenches import (
    Forces,
    Moments,
    Stage,
    StaticsError,
    Wrench,
    balancing,
    carried,
    loads_of,
    on_both,
    pressed,
    solved,
    stage_of,
)

Both = tuple[int, int]  # (i, j): of link i on link j


class Friction(NamedTuple):
    """Coefficients by the pair's name (guide or letter); radii of pins (m) by letter. Absent is 0."""

    f: Mapping[str, float]
    radius: Mapping[str, float] = {}


class Statics(NamedTuple):
    """What holds the links in equilibrium; in digits all numbers are mpmath's.

    ``reactions``: the whole force (N) of link i on link j, its friction included. ``couples``: of
    sliding pairs, the moment (N·m) of i on j about the letter ``at`` (else the guide's point);
    a force N along the normal acts at couple / N from there. ``rubs``: the part of a sliding pair's
    reaction that is friction (N); ``drags``: the friction couples of turning pairs (N·m).
    ``balance``: N or N·m. ``power``: of all loads (W), should be 0 against ``work``, what loads and
    reactions would do at the largest speed. ``condition``: of the last matrix (lengths in sizes).
    """

    reactions: Mapping[Both, complex]
    couples: Mapping[Both, float]
    rubs: Mapping[Both, complex]
    drags: Mapping[Both, float]
    balance: float
    power: float
    work: float
    condition: float


class _Rub(NamedTuple):
    """What friction adds for each newton of the length of the unknowns ``among``."""

    pair: Pair
    among: list[int]
    unit: list[Wrench]


def _rub(
    stage: Stage, pair: Pair, k: int, friction: Friction | None, at: Mapping[str, str]
) -> _Rub | None:
    """Friction of a pair whose unknowns are k and k + 1."""
    if friction is None or not friction.f.get(pair.name):
        return None
    i, j = pair.links
    f, nothing = stage.number(friction.f[pair.name]), stage.number(0)
    if pair.kind == "R":
        sense = stage.sign(stage.motion[j][1][1] - stage.motion[i][1][1])
        couple = -sense * f * stage.number(friction.radius.get(pair.name, 0)) / stage.size
        return _Rub(pair, [k, k + 1], on_both(i, j, nothing, nothing, couple))
    if pair.name not in at:
        raise StaticsError(f"friction on {pair.name} needs a letter")
    along, place = stage.guide(pair, at)
    slip = stage.velocity(i, place) - stage.velocity(j, place)
    force = -stage.sign((slip * along.conjugate()).real) * f * along
    return _Rub(pair, [k], on_both(j, i, force, place, nothing))


def _length(x: Numbers, rub: _Rub) -> Any:
    """|N| or |R|."""
    return abs(x[rub.among[0]] + (1j * x[rub.among[1]] if len(rub.among) > 1 else 0))


def _settled(
    matrix: Numbers, rubs: Sequence[tuple[_Rub, Numbers]], right: Numbers, eps: Any, start: Numbers
) -> tuple[Numbers, Numbers] | None:
    """Solve matrix x + Σ |x| column = right by Newton's method; None if it does not settle.

    All terms are homogeneous of degree 1, so a step of Newton's is to solve J(x) x' = right. The
    last step is one from where the residual is as small as that of a linear solution is.
    """
    x = start
    for _ in range(50):
        jacobian, left = matrix.copy(), matrix @ x
        for rub, column in rubs:
            length = _length(x, rub)
            left = left + column * length
            for k in rub.among if length else ():
                jacobian[:, k] += column * (x[k] / length)
        if max(abs(left - right)) <= 100 * len(x) * eps * max(abs(matrix) @ abs(x) + abs(right)):
            return solved(jacobian, right) if rubs else x, jacobian
        x = solved(jacobian, right)
    return None


def _rubbing(
    matrix: Numbers, rubs: Sequence[tuple[_Rub, Numbers]], right: Numbers, eps: Any
) -> tuple[Numbers, Numbers]:
    """The equilibrium found from that without friction, at once or by steps of the coefficients."""
    smooth = solved(matrix, right)
    for steps in (1, 8, 64):
        found: tuple[Numbers, Numbers] | None = (smooth, matrix)
        for step in range(1, steps + 1):
            part = [(rub, column * step / steps) for rub, column in rubs]
            found = _settled(matrix, part, right, eps, found[0]) if found else None
        if found is not None:
            return found
    raise StaticsError("no equilibrium with friction was found")


def statics(
    mechanism: Mechanism,
    state: State,
    forces: Forces,
    moments: Moments = (),
    *,
    gravity: bool,
    inertia: bool,
    balance: Literal["force", "moment"],
    friction: Friction | None = None,
    at: Mapping[str, str] = {},
    digits: bool = False,
    runs: Sequence[int] = (),
) -> Statics:
    """Solve the equilibrium of all links at once, in float64 or in the set precision of mpmath.

    ``forces`` act at a letter's place on a link, weights -m g and inertia forces -m a_S at the
    centres, couples -J ε on the links; none on the frame. The balancing force acts at the driving
    link's pin, positive along +90° from pivot → pin. Friction of a sliding pair acts on the slider
    against its slip, along the guide through the letter ``at[guide]``; that of a turning pair is
    the couple f·radius·|R|. Pairs at rest (1e-12 of the largest rate) have none. Teeth press wheels apart by
    tan α of their force along the common tangent; ``runs``: on which side of the centres the pulling run of
    each belt leaves its first wheel.
    """
    stage, structure = stage_of(mechanism, state, digits), dissect(mechanism)
    loads = loads_of(stage, forces, moments, gravity, inertia)
    units = [unit for pair in structure.pairs for unit in carried(stage, pair, at)]
    meshes = mechanism.meshes
    teeth = [pressed(stage, *one) for one in zip(meshes, runs or [1] * len(meshes), strict=True)]
    units += [across for across, _ in teeth]
    units.append(balancing(stage, structure, balance))
    found = [_rub(stage, pair, 2 * k, friction, at) for k, pair in enumerate(structure.pairs)]
    first = 2 * len(structure.pairs)
    found += [
        _Rub(Pair("K", "", mesh.links), [first + k], apart)
        for k, (mesh, (_, apart)) in enumerate(zip(mechanism.meshes, teeth, strict=True))
    ]
    rubs = [(rub, stage.column(rub.unit)) for rub in found if rub is not None]
    matrix = np.array([stage.column(unit) for unit in units]).T
    x, jacobian = _rubbing(
        matrix, rubs, -stage.column(loads), mpmath.eps if digits else np.finfo(float).eps
    )
    loads += [
        wrench._replace(force=size * wrench.force, couple=size * wrench.couple)
        for size, unit in [(x[-1], units[-1]), *((_length(x, rub), rub.unit) for rub, _ in rubs)]
        for wrench in unit
    ]
    powers = [stage.power(wrench) for wrench in loads]
    condition = float(np.linalg.cond(np.asarray(jacobian, dtype=float)))
    turned = x[-1] * (state.size if balance == "moment" else 1)
    forces_by, couples, slips, drags = _told(stage, structure.pairs, at, x, [r for r, _ in rubs])
    for k, (mesh, (across, apart)) in enumerate(zip(mechanism.meshes, teeth, strict=True), first):
        force = x[k] * across[0].force + abs(x[k]) * apart[0].force
        forces_by |= {mesh.links: force, mesh.links[::-1]: -force}
    size = sum(abs(wrench.force) + abs(wrench.couple) for wrench in loads) + sum(abs(x))
    total = (turned, sum(powers), size * stage.fastest * stage.size, condition)
    return Statics(forces_by, couples, slips, drags, *total)


def _told(
    stage: Stage, pairs: Sequence[Pair], at: Mapping[str, str], x: Numbers, rubs: Sequence[_Rub]
) -> tuple[dict[Both, Any], ...]:
    """Reactions, couples, rubs and drags by links, both ways."""
    reactions: dict[Both, Any] = {}
    couples, slips, drags = dict(reactions), dict(reactions), dict(reactions)
    by_pair = {rub.pair: rub for rub in rubs}
    for k, pair in enumerate(pairs):
        i, j = pair.links if pair.kind == "R" else pair.links[::-1]
        first, second = (unit[0] for unit in carried(stage, pair, at))
        reactions[i, j] = x[2 * k] * first.force + x[2 * k + 1] * second.force
        rub = by_pair.get(pair)
        extra = rub.unit[0] if rub else first._replace(force=0 * x[0], couple=0 * x[0])
        size = _length(x, rub) if rub else 0 * x[0]
        if pair.kind == "P":
            couples[i, j], slips[i, j] = x[2 * k + 1] * stage.size, size * extra.force
            reactions[i, j] = reactions[i, j] + slips[i, j]
        else:
            drags[i, j] = size * extra.couple * stage.size
    for table in (reactions, couples, slips, drags):
        table |= {(j, i): -value for (i, j), value in table.items()}
    return reactions, couples, slips, drags


class Loaded(NamedTuple):
    """A mechanism with masses on its links, and loads."""

    mechanism: Mechanism
    forces: Forces
    moments: Moments


def put_loads(pick: Callable[[int], int], mechanism: Mechanism) -> Loaded:
    """Put on masses, forces, moments by choices ``pick(n)`` of whole numbers 0 ... n.

    Masses (kg), forces (N) are 0 ... 1e3, J and moments so many sizes of the mechanism. A link may
    lack its mass, its J or its centre, and may bear no load.
    """
    size = max(abs(p) for link in mechanism.links for p in link.points.values())

    def amount() -> float:
        return float(pick(10) * 10.0 ** (pick(5) - 3))

    def weighed(link: Link) -> Link:
        mass, inertia = (amount() if pick(4) else None for _ in range(2))
        own = None if inertia is None else inertia * (0.3 * size) ** 2
        centre = ([*link.points, None])[pick(len(link.points))]
        return replace(link, mass=mass, inertia=own, centre=centre)

    def load(link: Link) -> tuple[int, str, complex]:
        letter = [*link.points][pick(len(link.points) - 1)]
        return link.number, letter, cmath.rect(amount(), math.radians(pick(3600) / 10))

    links = mechanism.links
    forces = [load(link) for link in links for _ in range(pick(2))]
    moments = [(link.number, (2 * pick(1) - 1) * amount() * size) for link in links if pick(1)]
    return Loaded(replace(mechanism, links=tuple(map(weighed, links))), forces, moments)


@st.composite
def loads(draw: st.DrawFn, mechanism: Mechanism) -> Loaded:
    """Strategy of masses, J and centres on the links, forces and moments, as `put_loads` does."""
    return put_loads(lambda most: draw(st.integers(0, most)), mechanism)
