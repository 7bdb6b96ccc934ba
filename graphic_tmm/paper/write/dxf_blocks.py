"""Conventional signs as blocks: a pair, a support, a slider is one thing to pick and to change.

A block is what the strokes of a sign are about its own origin. Signs of one kind that look otherwise (a support
whose hatching a letter interrupts) are blocks of their own, numbered.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Mapping
from typing import Any, NamedTuple

from graphic_tmm.paper.drawing import Ink, Stroke, Symbol
from graphic_tmm.paper.pens import Pen
from graphic_tmm.paper.write.dxf_ink import DIGITS, Inker, spot, vertices, weight


class Sign(NamedTuple):
    """A sign on a drawing, its strokes, the uppermost of their pens, and the position that it belongs to."""

    symbol: Symbol
    strokes: tuple[Stroke, ...]
    pen: str
    position: int | None


def symbol_of(stroke: Ink) -> Symbol | None:
    """Return the sign of which a stroke is one; None for one that stands by itself."""
    return stroke.symbol if isinstance(stroke, Stroke) else None


def gathered(strokes: Iterable[Ink], pens: Mapping[str, Pen]) -> list[Sign]:
    """Return the signs among strokes, in the order in which they are met; what stands twice, once."""
    found: dict[tuple[Symbol, int | None], list[Stroke]] = {}
    for stroke in strokes:
        if isinstance(stroke, Stroke) and stroke.symbol is not None:
            found.setdefault((stroke.symbol, stroke.position), []).append(stroke)
    order = list(pens)
    return [
        Sign(symbol, tuple(some), max((s.pen for s in some), key=order.index), position)
        for (symbol, position), some in found.items()
    ]


class Blocks:
    """The blocks of a document, made when they are first needed."""

    def __init__(self, document: Any, pens: Mapping[str, Pen]) -> None:
        self.document, self.pens = document, pens
        self.names: dict[tuple[object, ...], str] = {}

    def insert(self, space: Any, sign: Sign, layer: str) -> None:
        """Put a sign into a space as a block."""
        turned = {"layer": layer, "rotation": round(sign.symbol.turn, DIGITS)}
        space.add_blockref(self.name(sign), spot(sign.symbol.at), dxfattribs=turned)

    def name(self, sign: Sign) -> str:
        """Return the name of the block that looks like a sign."""
        kind = sign.symbol.kind.upper()
        own = tuple(dict.fromkeys(_about_origin(stroke, sign.symbol) for stroke in sign.strokes))
        look = (kind, *((s.pen, s.path, s.closed, s.filled) for s in own))
        if look not in self.names:
            count = sum(known[0] == kind for known in self.names)
            self.names[look] = name = f"{kind}_{count + 1}" if count else kind
            ink = Inker(self.document.blocks.new(name), self.pens)
            order = list(self.pens)
            for stroke in sorted(own, key=lambda stroke: order.index(stroke.pen)):
                width = self.pens[stroke.pen].width
                ink.stroke(stroke, {"layer": "0", "lineweight": weight(width)})
        return self.names[look]


def _about_origin(stroke: Stroke, symbol: Symbol) -> Stroke:
    """Return a bare stroke as it would be drawn at the origin, not turned."""
    back = cmath.rect(1.0, -math.radians(symbol.turn))
    spots = [((complex(x, y) - symbol.at) * back, bulge) for x, y, bulge in stroke.path]
    path = tuple((z.real, z.imag, bulge) for z, bulge in spots)
    clean = tuple((x + 0.0, y + 0.0, bulge + 0.0) for x, y, bulge in vertices(path))
    return Stroke(stroke.pen, clean, stroke.closed, stroke.filled)
