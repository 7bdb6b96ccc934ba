"""Pressures by the parts of an indicator diagram: polytropic strokes, or straight lines between given points.

Which part a position stands on is a choice that is made before the log runs, like the side of an assembly: by
the piston's exact travel. The pressure itself is a step, by the travel as measured.
"""

from __future__ import annotations

from dataclasses import replace
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.execute import execute
from graphic_tmm.board.operations.energetics import between, polytropic, polytropic_at_shaft
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number, Reals
from graphic_tmm.chapters.indicator.task import Gas, Stretch
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said

SLACK = 1e-9
"""A share of the stroke that is over by less than this is on the stretch still."""


class Row(NamedTuple):
    """The positions: ``size`` of the row, so many ``extras`` behind it.

    ``turns``: of the cycle, from 0, in which each of them stands; ``out``: whether the piston goes from the
    cover.
    """

    size: int
    extras: int
    turns: tuple[int, ...]
    out: tuple[bool, ...]


def indexed(letter: str, sign: str, more: str = "") -> str:
    """Return a letter of a side of a piston: p_k, or p_{kB} of one of several pistons."""
    return f"{letter}_{sign}{more}" if len(sign) == 1 else f"{letter}_{{{sign}{more}}}"


def by_stretches(
    draft: Draft,
    sign: str,
    gas: Gas,
    row: Row,
    travel: Mark,
    stroke: Mark,
    *,
    at_shaft: bool = False,
) -> Mark:
    """Calculate the pressure of every position of the row by the stretch that it stands on.

    Positions behind the row have no pressure. ``at_shaft``: the volume is that on the side of the shaft, which
    is least at the far end of the stroke.

    Raises
    ------
    StructureError
        If a position stands on no stretch.
    """
    count, extras, turns, out = row
    shares = _shares(draft, travel, stroke)[:count]
    found = [_at(gas, float(shares[k]), turns[k], out=out[k]) for k in range(count)]

    def values(name: str) -> Reals:
        told = [float(getattr(stretch, name) or 0.0) for stretch in found]
        return np.array([*told, *[np.nan] * extras])[None, :]

    def take(letter: str, name: str, unit: str = "") -> Mark:
        return draft.take(Number, letter, values(name), unit)

    first, start = (
        take(indexed("p", sign, "0"), "pressure", "Pa"),
        take(indexed("x", sign, "0"), "start"),
    )
    if any(stretch.exponent is not None for stretch in gas.stretches):
        clearance = draft.take(Number, indexed("c", sign), gas.clearance)
        exponent = take(indexed("n", sign), "exponent")
        uses = (first, clearance, start, travel, stroke, exponent)
        formula = polytropic_at_shaft if at_shaft else polytropic
        return draft.draw(formula, indexed("p", sign), *uses, unit="Pa")
    last, end = take(indexed("p", sign, "1"), "last", "Pa"), take(indexed("x", sign, "1"), "end")
    uses = (first, last, start, end, travel, stroke)
    return draft.draw(between, indexed("p", sign), *uses, unit="Pa")


def _shares(draft: Draft, travel: Mark, stroke: Mark) -> Reals:
    """Return the exact travel of every position as a share of the stroke."""
    given = {**draft.given, draft.mu_l: 1.0}
    reading = execute(draft.board.construction(), given, [travel, stroke])
    return np.asarray(reading[travel][0] / reading[stroke][0, 0])


def _at(gas: Gas, share: float, turn: int, *, out: bool) -> Stretch:
    """Return the stretch on which a piston stands, at a share of its stroke.

    Where two meet it is the first one; at a jump the pressure is that behind it, all the way.
    """
    way = "out" if out else "back"
    there = [
        one
        for one in gas.stretches
        if (one.stroke, one.turn) == (way, turn)
        and min(one.start, one.end) - SLACK <= share <= max(one.start, one.end) + SLACK
    ]
    for one in there:
        if one.start == one.end:
            return replace(one, start=0.0, end=1.0, pressure=one.last)
    if there:
        return there[0]
    raise StructureError(
        said(
            "no part of the diagram stands over {share:.3f} of the stroke {way}: let its parts "
            "go from 0 to 1 and back",
            share=share,
            way=way,
        ),
        "indicator.cover_strokes",
        "indicator.shaft_strokes",
        head="indicator",
    )
