"""Pens as data: widths, dashes and colours of the lines of a sheet (ГОСТ 2.303).

The main line is s = 0.8 mm on A1 and 0.6 mm on A4 (ГОСТ 2.303 allows 0.5 ... 1.4 mm); every thin
line is s/3, the lines of vectors are s/2, never finer than 0.2 mm. A dash-dot line begins and ends
with a stroke: `fitted` stretches its pattern a little for that.
"""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from types import MappingProxyType
from typing import NamedTuple

from graphic_tmm.errors import SheetError
from graphic_tmm.language.said import said
from graphic_tmm.paper.formats import FORMATS

DASHED = (5.0, 1.5)
"""Stroke and gap, mm (ГОСТ 2.303: 2…8 and 1…2)."""
CENTRE = (12.0, 1.5, 1.0, 1.5)
"""Stroke, gap, dot, gap, mm (ГОСТ 2.303: strokes of 5…30, 3…5 between two of them)."""
SHORTEST = 5.0
"""The shortest stroke of a dash-dot line, mm."""
PHANTOM = (12.0, 1.5, 1.0, 1.5, 1.0, 1.5)
"""The same with two dots."""

KINDS = MappingProxyType(
    {
        "thin": said("thin lines"),
        "dashed": said("dashed lines"),
        "centre": said("centre lines"),
        "phantom": said("phantom lines"),
        "medium": said("vectors"),
        "main": said("main lines"),
        "thick": said("thick lines"),
        "body": said("sliders"),
        "outline": said("sliders drawn before"),
        "rod": said("rods over sliders"),
        "over": said("vectors over sliders"),
        "paper": said("paper under figures"),
        "pin": said("turning pairs drawn before"),
        "joint": said("turning pairs"),
    }
)
"""What the layer of a pen is called in a drawing program."""
LETTERING = said("lettering")
"""What a layer of letters is called there."""


class Pen(NamedTuple):
    """A pen: width in mm, dash pattern (stroke, gap, ... in mm), colour, colour of its filling.

    ``fill`` is "none" for a line; a pen that hides what lies under its closed strokes fills with
    "white".
    """

    width: float
    dashes: tuple[float, ...] = ()
    colour: str = "black"
    fill: str = "none"


def pens(format: str) -> Mapping[str, Pen]:
    """Return the pens for a ``format`` ("A1", "A4"), in the order in which they are laid on it.

    "thin" (construction, dimension and hatching lines), "dashed", "centre" (dash-dot), "phantom"
    (dash and two dots), "medium" (vectors of plans), "main", "thick" (open section line, 1.5 s),
    "body" (a slider: a main line round the paper's white, hides its guide), "outline" (the same, thin),
    "rod" (a main line that runs over a slider to its pin), "over" (a medium line that does), "paper" (hides
    what lies under it, draws no line), "joint" (a main line round white: pins, uppermost), "pin" (the same,
    thin).
    """
    if format not in FORMATS:
        known = ", ".join(FORMATS)
        raise SheetError(f"no pens for the format {format!r}: choose one of {known}")
    s = FORMATS[format].main
    thin = max(0.2, round(s / 3, 2))
    return MappingProxyType(
        {
            "thin": Pen(thin),
            "dashed": Pen(thin, DASHED),
            "centre": Pen(thin, CENTRE),
            "phantom": Pen(thin, PHANTOM),
            "medium": Pen(round(s / 2, 2)),
            "main": Pen(s),
            "thick": Pen(round(1.5 * s, 2)),
            "body": Pen(s, (), "black", "white"),
            "outline": Pen(thin, (), "black", "white"),
            "rod": Pen(s),
            "over": Pen(round(s / 2, 2)),
            "paper": Pen(0.0, (), "none", "white"),
            "pin": Pen(thin, (), "black", "white"),
            "joint": Pen(s, (), "black", "white"),
        }
    )


def refuse_unknown(used: Iterable[str], box: Mapping[str, Pen], where: str) -> None:
    """Raise SheetError for pens that are not in the box; ``where``: the name of what is drawn with them."""
    if unknown := set(used) - set(box):
        raise SheetError(f"{where}: no such pen: {', '.join(sorted(unknown))}")


def tracing(box: Mapping[str, Pen], colour: str) -> Mapping[str, Pen]:
    """Return the pens as on tracing paper: all of them thin and of one colour, and hiding nothing."""
    width = box["thin"].width
    pen = {key: Pen(width if pen.width else 0.0, pen.dashes, colour) for key, pen in box.items()}
    hidden = {key: pen[key]._replace(colour="none") for key in box if not box[key].width}
    return MappingProxyType(pen | hidden)


def stretched(
    dashes: tuple[float, ...], length: float, *, closed: bool = False
) -> tuple[float, ...]:
    """Return the pattern stretched so that a line of ``length`` mm begins and ends with a stroke.

    A dash-dot line has a stroke in its middle too, where it crosses another in the middle of a
    circle. A closed line gets a whole number of periods. A line too short for strokes of `SHORTEST`
    is drawn solid: ().
    """
    if not dashes:
        return ()
    period, first = sum(dashes), dashes[0]
    tail = 0.0 if closed else first
    count = round((length - tail) / period)
    if not closed and len(dashes) > 2:
        count = 2 * round((length - tail) / period / 2)
        if count == 0 and length * first >= SHORTEST * (2 * period + first):
            count = 2
    if count < 1:
        return ()
    stretch = length / (count * period + tail)
    return tuple(stretch * dash for dash in dashes)
