"""Rows of wheels outside a train, their numbers, and how they turn by each other.

Of a differential that is closed two members turn each other by such rows: with one shaft of both. Let that of
the first turn by 1, then the other turns by u, whatever drives.
"""

from __future__ import annotations

from collections.abc import Mapping, Sequence
from itertools import pairwise
from types import MappingProxyType
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.formula import formula
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Number
from graphic_tmm.chapters.trains import formulas as f
from graphic_tmm.chapters.trains.motion import Closing
from graphic_tmm.chapters.trains.task import PlanetaryTask, Scheme
from graphic_tmm.language.said import said


class Row(NamedTuple):
    """Wheels in mesh, from the shaft of the train outward: their numbers and teeth.

    ``rack``: the number of the rack that the only wheel of a row drives; "" of other rows.
    """

    names: tuple[str, ...]
    teeth: tuple[int, ...]
    rack: str = ""


@formula(
    holds="{own} ≠ 0",
    fails="a member has no radius",
    why=said(
        "Wheels join both members: so their angular velocities are as these turn, and velocities as they and "
        "the radii are."
    ),
)
def closed_velocity(trial: Length, ratio: Number, arm: Number, own: Number) -> Length:
    """{trial}·{ratio}·{arm}/{own}"""


@formula(
    holds="{read} ≠ 0",
    fails="what drives does not move in the trial",
    why=said(
        "Velocities of one train grow in proportion: the trial, times what that of the driving point is over "
        "what it is in the trial, is the true one (false position)."
    ),
)
def of_trial(trial: Length, due: Length, read: Length) -> Length:
    """{trial}·{due}/{read}"""


@formula(
    holds="{other} ≠ 0",
    fails="a wheel has no teeth",
    why=said(
        "Both rows stand on the same two shafts: the distance of these is one, so the module follows."
    ),
)
def module_of_row(m: Number, first: Number, other: Number) -> Number:
    """{m}·{first}/{other}"""


def rows_of(order: PlanetaryTask, scheme: Scheme, side: str) -> tuple[Row, ...]:
    """Return the rows "behind" or "before" a train or those that close it ("closed"), from it outward.

    Their numbers go on from its own. A rack is the last row behind.
    """
    number, found = len(scheme.wheels) + 1, []
    closing = tuple(teeth for _, teeth in order.closed)
    for name, all_teeth in (
        ("behind", order.behind),
        ("before", order.before),
        ("closed", closing),
    ):
        racks = (order.rack,) if name == "behind" and order.rack else ()
        for teeth in (*all_teeth, *((z,) for z in racks)):
            names = tuple(str(number + k) for k in range(len(teeth)))
            number += len(teeth)
            row = Row(names, teeth)
            if len(teeth) == 1:
                row, number = row._replace(rack=str(number)), number + 1
            if name == side:
                found.append(row)
    if side != "before":
        return tuple(found)
    return tuple(Row(row.names[::-1], row.teeth[::-1]) for row in reversed(found))


def draw_rolling(
    draft: Draft,
    rows: Sequence[Row],
    turns: Mark,
    teeth: Mapping[str, Mark],
    called: Mapping[str, str] = MappingProxyType({}),
) -> dict[str, Mark]:
    """Calculate how wheels turn from the first on, rows in the order in which power goes through them.

    ``called``: the member on whose shaft a wheel is.
    """
    found = dict[str, Mark]()
    for row in rows:
        found[row.names[0]] = turns
        for one, other in pairwise(row.names):
            letter = f"{turns.name[0]}_{index(called.get(other, other))}"
            turns = draft.draw(
                f.rate_back, letter, turns, teeth[one], teeth[other], unit=turns.unit
            )
            found[other] = turns
    return found


def index(name: str) -> str:
    """Return a wheel's number as it stands at a letter."""
    return name if len(name) == 1 else f"{{{name}}}"


def draw_teeth(draft: Draft, rows: Sequence[Row]) -> dict[str, Mark]:
    """Return the teeth of the wheels of rows, as they are given."""
    return {
        name: draft.take(Number, f"z_{index(name)}", float(z))
        for row in rows
        for name, z in zip(row.names, row.teeth, strict=True)
    }


def closing_rows(order: PlanetaryTask, scheme: Scheme, closing: Closing) -> tuple[Row, Row]:
    """Return the rows from the shaft of the first member that is closed to that of the other."""
    rows = dict(
        zip((name for name, _ in order.closed), rows_of(order, scheme, "closed"), strict=True)
    )
    first, last = rows[closing.joint], rows[closing.other]
    return first, Row(last.names[::-1], last.teeth[::-1])


def draw_closing(
    draft: Draft, rows: tuple[Row, Row], teeth: Mapping[str, Mark], closing: Closing, turns: Mark
) -> dict[str, Mark]:
    """Calculate how the wheels of both rows turn, and the other member, by the first one."""
    end = rows[1].names[-1]
    found = draw_rolling(draft, rows, turns, teeth, {end: closing.other})
    return found | {closing.joint: turns, closing.other: found[end]}
