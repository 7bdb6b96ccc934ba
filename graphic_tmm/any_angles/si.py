"""What a reader does to a mark of a plan before it leaves the log: millimetres times μ, in SI.

These are steps of the loop that runs the log, so that a result is written once; they are no steps of the board.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import Any

from graphic_tmm.any_angles.turn import Told
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.record import Construction, Mark, Step
from graphic_tmm.board.values import Complexes, Kind, Number, Point, Reals, Vector

VIEW = "SI"


def _times(spot: Complexes, mu: Reals) -> Complexes:
    return spot * mu


def _placed(spot: Complexes, mu: Reals, origin: Complexes) -> Complexes:
    return spot * mu + origin


def _vector(start: Complexes, end: Complexes, mu: Reals) -> Complexes:
    return (end - start) * mu


def _reading(run: Any, *arguments: str) -> Operation:
    kinds = tuple(Number if name == "mu" else Point for name in arguments)
    # no pencil pricks it, and nothing is calculated with few digits
    return Operation(run.__name__, run, kinds, arguments, Vector, (), "")


READINGS = (
    _reading(_times, "spot", "mu"),
    _reading(_placed, "spot", "mu", "origin"),
    _reading(_vector, "start", "end", "mu"),
)
"""Of a vector from the pole, of a place from the origin, of a vector from elsewhere: none is of the board."""


def in_si(
    log: Construction, rows: Iterable[Told], given: Mapping[Mark, object]
) -> tuple[Construction, dict[Told, Mark], dict[Mark, complex]]:
    """Return the log that ends in SI, where it has each quantity, and what more is given in it.

    To a scale of 1 SI unit a millimetre a mark is in SI already; a mark of several links is told once.
    """
    times, placed, vector = READINGS
    steps, begun = list(log.steps), list(log.given)
    made: dict[tuple[Any, ...], Mark] = {}
    origins: dict[Mark, complex] = {}
    found: dict[Told, Mark] = {}
    size = log.size

    def mark(letter: str, kind: Kind) -> Mark:
        nonlocal size
        size += 1
        return Mark(size - 1, letter, kind, VIEW)

    for row in rows:
        drawn = row.mark
        if row.scale is None or (
            row.start is None and row.origin == 0 and given.get(row.scale) == 1.0
        ):
            found[row] = drawn
            continue
        key = (drawn.slot, row.start, row.scale, row.origin)
        if key not in made:
            op = times
            uses: tuple[Mark, ...] = (drawn, row.scale)
            if row.start is not None:
                op, uses = vector, (row.start, drawn, row.scale)
            elif row.origin != 0:
                origin = mark("O", Point)
                origins[origin] = row.origin
                begun.append(origin)
                op, uses = placed, (drawn, row.scale, origin)
            made[key] = mark(drawn.letter, Vector)
            steps.append(Step(op, made[key], uses, {}, ""))
        found[row] = made[key]
    return log._replace(given=tuple(begun), steps=tuple(steps), size=size), found, origins
