"""Pairs of wheels before and behind a planetary train in its kinematic scheme, with the module of the train.

The first wheel of a row stands on the shaft of the train, its last one below; the first of the next row is
on the shaft of that one. A wheel between the first and the last is an idler: it only turns the sense about.
"""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import dataclass
from itertools import count

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import pitch_radius, to_board
from graphic_tmm.board.operations.instruments import lay_off, parallel, square
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number
from graphic_tmm.chapters.trains import formulas as f
from graphic_tmm.chapters.trains.dimensions import Dimensions
from graphic_tmm.chapters.trains.motion import motion_of
from graphic_tmm.chapters.trains.pictures import Disc, EndView
from graphic_tmm.chapters.trains.rows import (
    Row,
    draw_rolling,
    draw_teeth,
    index,
    module_of_row,
    rows_of,
)
from graphic_tmm.chapters.trains.task import PlanetaryTask, Scheme

CONTACTS = "EFGKQRSTUV"
"""Letters of the points in which these wheels touch, row by row; then they begin anew with a prime."""


@dataclass(frozen=True)
class Outside:
    """Rows of wheels on one shaft of the train.

    ``member``: whose shaft; ``stations``: where each row stands along the axis (Length, given), the first from
    O, another from the row before; ``discs``: of every row its wheels by their numbers.
    """

    member: str
    stations: tuple[Mark, ...]
    discs: tuple[Mapping[str, Disc], ...]


@dataclass(frozen=True)
class Pairs:
    """All wheels outside the train: their ``ratio`` with it, without sign, None where none are.

    ``teeth``: by the wheel. ``before``: the angular velocities of the wheels before it, from that given on.
    """

    outside: tuple[Outside, ...]
    ratio: Mark | None
    teeth: Mapping[str, Mark]
    before: Mapping[str, Mark]


def draw_pairs(
    draft: Draft, order: PlanetaryTask, scheme: Scheme, sizes: Dimensions, end: EndView
) -> Pairs:
    """Draw the wheels before and behind the train; calculate the ratio of all."""
    motion = motion_of(order)
    letters = (letter + primes * "′" for primes in count() for letter in CONTACTS)
    sides = {side: rows_of(order, scheme, side) for side in ("behind", "before")}
    teeth, outside, ratio = dict[str, Mark](), list[Outside](), sizes.ratio
    for rows in sides.values():
        teeth |= draw_teeth(draft, rows)
    ends = [
        (row.names[0], row.names[-1]) if side == "behind" else (row.names[-1], row.names[0])
        for side, rows in sides.items()
        for row in rows
        if not row.rack
    ]
    for k, (first, last) in enumerate(ends, 1):
        letter = "U_0" if k == len(ends) else f"U_{{0{k}}}"
        assert ratio is not None
        ratio = draft.draw(f.overall_ratio, letter, ratio, teeth[last], teeth[first])
    module = draft.uses(sizes.radii["1"])[0]
    for side, member in (("behind", motion.driven), ("before", motion.first)):
        if sides[side]:
            outside.append(_draw_rows(draft, sides[side], member, teeth, module, end, letters))
    spans = list[float]()
    closed = zip(order.closed, rows_of(order, scheme, "closed"), strict=True)
    for (member, _), row in closed:
        teeth |= {name: sizes.outside[name] for name in row.names}
        spans.append(float(2 * sum(row.teeth) - row.teeth[0] - row.teeth[-1]))
        if spans[0] != spans[-1]:
            one, other = (
                draft.take(Number, f"Σ_{m}", s)
                for (m, _), s in zip(order.closed, spans, strict=True)
            )
            module = draft.draw(module_of_row, f"m_{member}", module, one, other, unit="m")
        outside.append(_draw_rows(draft, (row,), member, teeth, module, end, letters))
    before = dict[str, Mark]()
    if onward := [Row(row.names[::-1], row.teeth[::-1]) for row in reversed(sides["before"])]:
        assert isinstance(order.speed, float | int)
        first = f"ω_{index(onward[0].names[0])}"
        given = draft.take(Number, first, float(order.speed), "1/s")
        called = {onward[-1].names[-1]: motion.first}
        before = draw_rolling(draft, onward, given, teeth, called)
    return Pairs(tuple(outside), ratio if ends else None, teeth, before)


def _draw_rows(
    draft: Draft,
    rows: Sequence[Row],
    member: str,
    teeth: Mapping[str, Mark],
    module: Mark,
    end: EndView,
    letters: Iterator[str],
) -> Outside:
    shaft = end.axis
    stations, discs = list[Mark](), list[dict[str, Disc]]()
    for row in rows:
        letter = next(letters)
        radii = []
        for name in row.names:
            real = draft.draw(pitch_radius, f"r_{index(name)}", module, teeth[name], unit="m")
            radii.append(draft.draw(to_board, f"O_{index(name)}{letter}", real))
        if discs:
            before = [*discs[-1].values()][-1].centre
            shaft = draft.draw(parallel, f"({before.letter})", before, end.axis, sense=1)
        discs.append(_draw_row(draft, row, letter, radii, shaft, end.axis, stations))
    for some in discs:
        for wheel, disc in some.items():
            draft.figure("pair", wheel, *disc)
    return Outside(member, tuple(stations), tuple(discs))


def _draw_row(
    draft: Draft,
    row: Row,
    letter: str,
    radii: Sequence[Mark],
    shaft: Mark,
    axis: Mark,
    stations: list[Mark],
) -> dict[str, Disc]:
    """Draw wheels from a shaft downward, each below the one before; keep where the row stands."""
    first, *others = row.names
    stations.append(draft.ask(Length, f"x_{index(first)}", "mm"))
    own = draft.draw(lay_off, f"O_{index(first)}", shaft, stations[-1])
    down = draft.draw(square, f"(O_{index(first)}{letter})", own, axis, sense=-1)
    contact = draft.draw(lay_off, letter, down, radii[0])
    up = draft.draw(square, f"(O_{index(first)}{letter}_{index(first)})", own, axis, sense=1)
    above = draft.draw(lay_off, f"{letter}_{index(first)}", up, radii[0])
    discs = {first: Disc(contact, above, own)}
    for name, radius in zip(others, radii[1:], strict=True):
        onward = draft.draw(square, f"({contact.letter}O_{index(name)})", contact, axis, sense=-1)
        other = draft.draw(lay_off, f"O_{index(name)}", onward, radius)
        again = draft.draw(
            square, f"(O_{index(name)}{letter}_{index(name)})", other, axis, sense=-1
        )
        below = draft.draw(lay_off, f"{letter}_{index(name)}", again, radius)
        discs[name] = Disc(contact, below, other)
        contact = below
    return discs
