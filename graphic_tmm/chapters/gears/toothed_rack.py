"""The teeth of a rack that wheel 1 drives: three of them, the part of a flank that works, when it does."""

from __future__ import annotations

from dataclasses import dataclass

import numpy as np

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import in_si, to_board
from graphic_tmm.board.operations.instruments import (
    lay_off,
    measure_along,
    meet,
    parallel,
    place,
    square,
)
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.gears import words as why
from graphic_tmm.chapters.gears.contact import Engagement
from graphic_tmm.chapters.gears.dimensions import GearSizes
from graphic_tmm.chapters.gears.formulas import half_of, part_of, remainder
from graphic_tmm.chapters.gears.line import ActionLine
from graphic_tmm.chapters.gears.rolling import reflect
from graphic_tmm.chapters.gears.teeth import Rows

TEETH = 3
"""Teeth that are drawn, of which the middle one touches in the pitch point."""


@dataclass(frozen=True)
class RackSide:
    """One side of the teeth (rows): tip, end of the flank, centre of the root's rounding, its other end."""

    tip: Mark
    start: Mark
    centre: Mark
    root: Mark

    @property
    def marks(self) -> tuple[Mark, ...]:
        """What it is drawn by."""
        return self.tip, self.start, self.centre, self.root


@dataclass(frozen=True)
class RackTeeth:
    """The teeth: the flank through P (Line), rows of their axes, both sides; the left one is driven.

    ``working``: from where to where on the flank through P it is in contact. ``engaged``: lowest is the end of
    that at the root; entering and leaving are Lines, the arc is a piece of the rolling line.
    """

    flank: Mark
    axes: Mark
    left: RackSide
    right: RackSide
    working: tuple[Mark, Mark]
    engaged: Engagement


def draw_rack(draft: Draft, sizes: GearSizes, line: ActionLine, rows: Rows) -> RackTeeth | None:
    """Draw the teeth of the rack, if there is one; its flanks lean to the left, upwards."""
    if (rack := sizes.rack) is None or (lines := line.rack) is None:
        return None
    flank = draft.draw(square, "(E_{2})", line.pole, line.line, sense=1, why=why.RACK_FLANK)
    first = draft.draw(meet, "D_{2}", flank, lines.datum, why=why.RACK_FLANK)
    pitch, thick, offset, deep, rounding = (
        draft.draw(to_board, f"[{name}]_2", mark)
        for name, mark in (
            ("p", sizes.p), ("s", rack.s), ("e_{F}", rack.profile.offset), ("h_{f}", rack.h_f),
            ("ρ_{f}", rack.profile.rounding),
        )
    )  # fmt: skip
    number = draft.take(Number, "n", rows.row(np.arange(TEETH) - TEETH // 2))
    onward = draft.draw(part_of, "n·p", number, pitch, why=why.RACK_TOOTH)
    datum = draft.draw(parallel, "(D_{2})", first, lines.datum, why=why.RACK_TOOTH)
    feet = draft.draw(lay_off, "D_{2n}", datum, onward, why=why.RACK_TOOTH)
    flanks = draft.draw(parallel, "(E_{2n})", feet, flank, why=why.RACK_TOOTH)
    bases = draft.draw(parallel, "(D_{2n})", feet, datum, why=why.RACK_TOOTH)
    half = draft.draw(half_of, "[s]_2/2", thick)
    middles = draft.draw(lay_off, "M_{2}", bases, half, why=why.TOOTH_AXIS)
    axes = draft.draw(square, "(M_{2})", middles, bases, sense=1, why=why.TOOTH_AXIS)
    aside = draft.draw(remainder, "b_2", offset, half, why=why.RACK_ROOT)
    high = draft.draw(remainder, "d_2", deep, rounding, why=why.RACK_ROOT)
    left = RackSide(
        draft.draw(meet, "A_{2}", flanks, lines.tip, why=why.RACK_TOOTH),
        draft.draw(meet, "L_{2}", flanks, lines.straight, why=why.RACK_TOOTH),
        draft.draw(place, "C_{2}", bases, aside, high, why=why.RACK_ROOT),
        draft.draw(place, "K_{2}", bases, aside, deep, why=why.RACK_ROOT),
    )
    right = RackSide(*(draft.draw(reflect, f"{m.name}′", m, axes, free=True) for m in left.marks))
    draft.figure("tooth", "2", *left.marks, *right.marks)
    turned, crossings, working = [], [], []
    for end, name in zip(line.ends, "ab", strict=True):
        turned.append(draft.draw(parallel, f"(E_{{{name}2}})", end, flank, why=why.RACK_TURNED))
        letter = f"{'cd'['ab'.index(name)]}_{{2}}"
        crossings.append(draft.draw(meet, letter, turned[-1], lines.rolling, why=why.RACK_TURNED))
        level = draft.draw(parallel, f"({name}_{{2}})", end, lines.rolling, why=why.RACK_WORKING)
        working.append(draft.draw(meet, f"{name}_{{2}}", flank, level, why=why.RACK_WORKING))
    length = draft.draw(measure_along, "c_2d_2", *crossings, lines.rolling)
    real = draft.draw(in_si, "c_2d_2·μ", length, unit="m")
    engaged = Engagement(
        working[1], turned[0], turned[1], (crossings[0], crossings[1]), length, real
    )
    return RackTeeth(flank, axes, left, right, (working[0], working[1]), engaged)
