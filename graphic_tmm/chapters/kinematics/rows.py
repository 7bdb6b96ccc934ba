"""Rows of tables that are asked for by name: each is a step of its own, none where none is asked for."""

from __future__ import annotations

from collections.abc import Iterator
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.formula import formula
from graphic_tmm.board.operations.instruments import (
    bearing,
    join,
    measure,
    measure_along,
    parallel,
    square,
)
from graphic_tmm.board.operations.statics import STANDS
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number
from graphic_tmm.chapters.kinematics import words as why
from graphic_tmm.chapters.kinematics.bodies import Positions
from graphic_tmm.chapters.kinematics.closings import GuideLeg, legs_of
from graphic_tmm.chapters.kinematics.motion import Motion, PathPart, image_letter, reading_of
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, POSITIONS, VELOCITIES, Rows
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.passive import holds
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.mechanism.structure import Structure
from graphic_tmm.scene import letters


@formula(
    why=said(
        "The links turn against each other at the difference of their angular velocities, the sum of their "
        "sizes where they turn in opposite senses; at the pin's surface that is {radius} times as much."
    )
)
def rubbing(radius: Number, omega: Number, other: Number) -> Number:
    """{radius}·|{omega} − {other}|"""


@formula(
    why=said(
        "The other link does not turn: at the pin's surface the speed is {radius} times {omega}."
    )
)
def rubbing_on_fixed(radius: Number, omega: Number) -> Number:
    """{radius}·|{omega}|"""


@formula(
    holds=f"|{{normal}}| > {STANDS:.9f}·|{{segment}}|",
    fails="the normal acceleration reads 0: the path is straight there, ρ infinite or too large to read",
    why=said(
        "A point that goes along a curve at v has the normal acceleration v²/ρ towards its centre of "
        "curvature, so ρ is the square of {segment}·{mu_v} divided by {normal}·{mu_a}."
    ),
)
def path_radius(segment: Length, mu_v: Number, normal: Length, mu_a: Number) -> Number:
    """({segment}·{mu_v})²/(|{normal}|·{mu_a})"""


class Further(NamedTuple):
    """A row that is no segment of its plan: what machines call it, its letter, its unit, its mark."""

    plan: str
    name: str
    letter: str
    unit: str
    mark: Mark


class Ground(NamedTuple):
    """What the rows are read off; ``quarters``: by how many right angles velocities are turned back."""

    draft: Draft
    mechanism: Mechanism
    structure: Structure
    positions: Positions
    velocities: Motion | None
    accelerations: Motion | None
    quarters: int

    def place(self, letter: str) -> Mark:
        """Return a point on the plan of positions."""
        return self.positions.point(letter)

    def image(self, motion: Motion, letter: str) -> Mark:
        """Return the image of a point on a plan, as of the first link that has it."""
        link = next(one for one in self.mechanism.drawn if letter in one.points)
        return motion.images.by_letter[link.number][letter]


def draw_rows(ground: Ground, asked: Rows) -> tuple[Further, ...]:
    """Draw what the rows ask for; segments that are read stand in their plans, the rest is returned."""
    draft, found = ground.draft, list[Further]()
    draft.open(POSITIONS)
    for pair in asked.lengths:
        _length(ground, *_letters(pair))
    for pair in asked.angles:
        ends = [ground.place(letter) for letter in _letters(pair)]
        letter = f"φ_{{{pair}}}"
        mark = draft.draw(bearing, letter, *ends, unit="°", free=True, why=why.ANGLE_OF_LINK)
        found.append(Further(POSITIONS, f"phi{pair}", letter, "°", mark))
    if asked.pins:
        found += _pins(ground, asked)
    if ground.accelerations is not None:
        for pair in asked.relative:
            first, second = _letters(pair)
            ends = [ground.image(ground.accelerations, k) for k in (second, first)]
            draft.open(ACCELERATIONS)
            name = f"{image_letter(second)}{image_letter(first)}"
            draft.draw(measure, name, *ends, free=True, why=why.WHOLE_RELATIVE)
        for letter in asked.paths:
            found += _path(ground, ground.accelerations, letter)
    return tuple(found)


def _letters(pair: str) -> tuple[str, str]:
    found = letters.split(pair)
    assert found is not None
    return found


def _length(ground: Ground, first: str, second: str) -> None:
    """Measure a distance; along its guide where the second point is of a link that slides on one."""
    draft, ends = ground.draft, (ground.place(first), ground.place(second))
    for _, leg in legs_of(ground.positions.closings, "rows"):
        body = ground.positions.bodies[leg.link]
        if isinstance(leg, GuideLeg) and body.marks.get(second) == ends[1]:
            name = f"{first}{second}"
            draft.draw(measure_along, name, *ends, leg.line, free=True, why=why.ALONG_THE_GUIDE)
            return
    draft.draw(measure, f"{first}{second}", *ends, free=True)


def _pins(ground: Ground, asked: Rows) -> Iterator[Further]:
    """Calculate how fast pins rub: of a pin of more links, each against the link that bears it."""
    draft, motion = ground.draft, ground.velocities
    assert motion is not None
    draft.open(VELOCITIES)
    pairs = [*ground.structure.pairs, *(p for one in holds(ground.mechanism) for p in one.pins)]
    for letter, size in asked.pins.items():
        joined = [p for p in pairs if p.kind == "R" and p.name == letter]
        rates = [[motion.rates[n] for n in pair.links if n in motion.rates] for pair in joined]
        if not any(rates):
            says = said("no links turn against each other in {letter}", letter=letter)
            raise StructureError(says, f"rows.pins.{letter}", head="rows")
        radius = draft.take(Number, f"r_{{{letter}}}", size, "m")
        for pair, turning in zip(joined, rates, strict=True):
            if not turning:
                continue
            name = "".join((letter, *map(str, sorted(pair.links))))
            op = rubbing if len(turning) == 2 else rubbing_on_fixed
            value = draft.draw(op, f"v_{{{name}}}", radius, *turning, unit="m/s", free=True)
            yield Further(VELOCITIES, f"v{name}", f"v_{{{name}}}", "m/s", value)


def read_path(
    draft: Draft, plans: tuple[Motion, Motion], letter: str, images: tuple[Mark, Mark],
    quarters: int, *, tangential: bool = False,
) -> PathPart | None:  # fmt: skip
    """Read the acceleration of a point square to its path, and along it where that is wanted.

    ``plans``, ``images``: of velocities and of accelerations. None where the point stands still. What was read
    before is not read again.
    """
    (motion, gained), (image, end), small = plans, images, image_letter(letter)
    speed = reading_of(draft, motion, image)
    if speed is None or (end in gained.paths and not tangential):
        return gained.paths.get(end)
    draft.open(VELOCITIES)
    name, pole = f"(v_{{{letter}}})", gained.images.pole
    way = draft.draw(join, name, motion.images.pole, image, free=True, why=why.PATH_WAY)
    draft.open(ACCELERATIONS)
    across = (parallel, -quarters) if quarters else (square, 1)
    ways = [(f"n_{{{small}}}", *across, why.PATH_ACROSS, why.PATH_NORMAL)]
    if tangential:
        along = (square, quarters) if quarters else (parallel, 1)
        ways.insert(0, (f"t_{{{small}}}", *along, why.PATH_ALONG, why.PATH_TANGENTIAL))
    lines = [
        draft.draw(op, f"({name})", pole, way, sense=sense, free=True, why=because)
        for name, op, sense, because, _ in ways
    ]
    parts = [
        draft.draw(measure_along, name, pole, end, line, free=True, why=because)
        for (name, _, _, _, because), line in zip(ways, lines, strict=True)
    ]
    return gained.paths.setdefault(end, PathPart(speed, lines[-1], parts[-1]))


def _path(ground: Ground, gained: Motion, letter: str) -> Iterator[Further]:
    """Read the acceleration of a point along its path and square to it; calculate the radius of the path."""
    draft, motion = ground.draft, ground.velocities
    assert motion is not None
    images = ground.image(motion, letter), ground.image(gained, letter)
    path = read_path(draft, (motion, gained), letter, images, ground.quarters, tangential=True)
    if path is None:
        says = said("{letter} stands still: it has no path", letter=letter)
        raise StructureError(says, "rows.paths", head="rows")
    known = path.speed, path.part
    radius = draft.draw(path_radius, f"ρ_{{{letter}}}", *known, unit="m", free=True)
    yield Further(ACCELERATIONS, f"rho{letter}", f"ρ_{{{letter}}}", "m", radius)
