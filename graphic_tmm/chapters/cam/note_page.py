"""What the section of a cam in a note is built of: sentences, lists, formulas and figures of one position."""

from __future__ import annotations

import math
import re
from collections.abc import Iterator, Sequence

from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.record import Step
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.chapters.cam.table import cam_columns
from graphic_tmm.chapters.cam.views import cam_views, scheme_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import referred
from graphic_tmm.note.document import (
    Block,
    Display,
    Formula,
    Item,
    Listed,
    Number,
    Picture,
    Run,
    Source,
    Symbol,
)
from graphic_tmm.note.figures import is_figure, picture, readable
from graphic_tmm.note.plans import Page, section_table
from graphic_tmm.note.protocol import Known
from graphic_tmm.note.steps import NumberSource, calculated
from graphic_tmm.readers.rounding import rounded_figures as as_told

LAW, CENTRES = said("Diagrams of the motion"), said("Least radius, region of centres")
LIMITS, PROFILE = said("Pressure angle and curvature"), said("Profile by reversed motion")
CHECKS = said("Limits kept, motion of the follower")
BASE = said(
    "Along the base the cam's turn is laid off, 360°; each phase takes its share and is divided into equal "
    "parts. Ordinates are taken to scale from the stroke:"
)
RADIANS = said("Derivatives are taken by the angle in radians; the phases are")
LAWS = {
    "sine": said(
        "The law is a sine. For S a semicircle of the radius R = h/(2π) is struck about the outer end of the "
        "phase and divided into as many parts as half of the phase; its points are carried to the axis there, "
        "from it parallel to the chord of the phase to the ordinates of the divisions. For dS/dφ and d²S/dφ² "
        "the semicircles have the radii below; their points are carried straight across."
    ),
    "cosine": said(
        "The law is a cosine. For S a semicircle over the stroke, of the radius R = h/2, is divided into as "
        "many parts as the phase, and its points are carried across to the ordinates of the divisions. For "
        "dS/dφ and d²S/dφ² the semicircles have the radii below."
    ),
    "constant acceleration": said(
        "The acceleration is constant over each half of the phase. S consists of two parabolas, drawn by rays "
        "to equal divisions of the ordinate over the middle; dS/dφ of two straight lines to the peak below; "
        "d²S/dφ² of two level lines."
    ),
    "3-4-5": said(
        "The law is a polynomial of the fifth degree; its ordinates are calculated by the share u of the phase:"
    ),
    "diagram": said(
        "The law is given by its acceleration diagram, which is integrated twice against a pole; the scale "
        "follows from the stroke."
    ),
}
READ = said(
    "At φ = {angle} (position {position}) the ordinates are S = {S}, dS/dφ = {dS}, d²S/dφ² = {ddS}, that is "
    "{travel}, {speed} and {rate}."
)
ROLLER = (
    said(
        "on the path of the roller's centre its places B are marked by S from the lowest one, {B0};"
    ),
    said(
        "from B, square to the path, dS/dφ is laid off to the same scale, to the side to which the velocity "
        "points when it is turned by 90° as the cam turns; its end is Q;"
    ),
    said(
        "seen from a centre O of the cam, Q lies in the direction of the normal: the angle of OQ with the path "
        "is the pressure angle, wherever O stands;"
    ),
    said(
        "tangents inclined to the path by the allowed pressure angle are drawn to the curve of the rise and to "
        "that of the return; below both of them every centre will do;"
    ),
    said(
        "the line of the centres meets them at {O1} and {O2}; the lower one gives the least radius."
    ),
)
LEAST = said("The least radius is measured from there to {B0}:")
APEX = said(
    "The least of all radii, with the guide set off the centre to the region's apex O*, would be"
)
CHOSEN = said("Taken is {r0}, on the drawing")
ANGLE = said(
    "With this centre the pressure angle in position {position} is {angle}, read between OQ and the path."
)
EXTREMES = said(
    "The pressure angles of all positions are laid off over the turn. The largest on the rise and on the "
    "return are read with the angles of the cam at which they stand:"
)
CURVATURE = said(
    "The curvature of the theoretical profile follows from how its normal turns; in position {position}:"
)
SHARPEST = said("Where it is largest, the radius of curvature is least:")
ALLOWED = said("The roller may be as large as the smaller of two limits allows:")
TAKEN = said("Taken is a roller of the radius {radius}.")
REVERSED = (
    said("everything is given the angular velocity −ω: the cam stands, the guide goes round it;"),
    said(
        "from the centre O the line of the follower is drawn for every position, turned back by the angle φ;"
    ),
    said(
        "on it the roller's centre B is marked, as far off as the least radius and S together tell;"
    ),
    said(
        "a smooth curve through the points B is the theoretical profile; over the dwells it is a circle;"
    ),
    said(
        "rollers are drawn about the points B; the curve that touches all of them, at the distance of the "
        "roller's radius along the normals, is the working profile."
    ),
)
REACH = said("In position {position} the roller's centre stands off by")
LEFT = said("What is left up to the limits:")
MOVING = said("The cam turns at {speed}. In position {position} the follower moves with")


_PLACE = re.compile(r"Source\([^)]*\)|value=[^),]*")
"""Where a number was read: calculations that are the same in two places are told once."""


LETTERS: dict[str, Run] = {
    "B0": Symbol("B_{0}"),
    "O1": Symbol("O_{1}"),
    "O2": Symbol("O_{2}"),
}
"""Letters of the drawing that sentences name."""


class CamPage(Page):
    """A cam, and the position that is worked: a quarter of the rise, where all of its motion is there."""

    lettered = LETTERS

    def __init__(self, drawn: Drawn, made: Cam, language: str) -> None:
        rise = made.diagrams.turn.rise
        super().__init__(drawn, language, rise.first + max(1, round(rise.parts / 4)))
        self.made = made
        self.known: Known = set()
        self.position = drawn.names[self.at]
        found = cam_columns(drawn)
        written = zip(found, as_told(found), strict=True)
        self.columns = {one.segment: (one, figures) for one, figures in written}
        drawings = [*readable(drawn, scheme_views), *readable(drawn, cam_views)]
        shown = [one for one in drawings if is_figure(one)]
        self.figures = {one.name: picture(one, language) for one in shown}

    def steps(self, told: Sequence[str]) -> Listed:
        """Return what is done, step by step."""
        return Listed(tuple(Item("", (self.says(one),)) for one in told))

    def formulas(self, view: str, *ops: Operation, first: bool = False) -> Iterator[Block]:
        """Yield the calculations of a view by some operations, each once; ``first``: only that of the first.

        One that is not there in the position that is worked (the return's) is told where it first is.
        """
        there: dict[str, Formula] = {}
        for told, step in self._steps_of(view, ops):
            formula = calculated(told, step)
            if formula is not None:
                there.setdefault(_PLACE.sub("", repr(formula)), formula)
        found = tuple(there.values())[: 1 if first else None]
        if found:
            yield Display(found)

    def _steps_of(self, view: str, ops: Sequence[Operation]) -> Iterator[tuple[NumberSource, Step]]:
        for step in self.drawn.construction.steps:
            if step.it.view != view or step.op not in ops:
                continue
            for at in (self.at, *range(len(self.drawn.names))):
                told = self.of(view, at)
                if told is not None and math.isfinite(told.value(step.it)):
                    yield told, step
                    break

    def drawn_as(self, name: str) -> Iterator[Block]:
        """Yield a figure, and the sentence that leads to it."""
        shown = self.taken(name)
        if shown:
            yield referred(shown, self.language)
        yield from shown

    def taken(self, name: str) -> tuple[Picture, ...]:
        """Return a figure by the name of its view, which is not told again."""
        found = self.figures.pop(name, None)
        return () if found is None else (found,)

    def from_log(self, view: str, at: int, shown: Sequence[Picture] = ()) -> Iterator[Block]:
        """Yield a view as the log tells it, step by step."""
        yield from section_table(self.drawn, view, at, self.language, shown, known=self.known)

    def cell(self, segment: str, factor: int) -> Number:
        """Return what a column holds in the position that is worked: in mm (0), or the quantity (1)."""
        column, figures = self.columns[segment]
        value = column.first_figures[factor][self.at]
        assert value is not None
        row, places = (figures.value, figures.places) if factor else (figures.mm, figures.mm_places)
        source = Source("column", self.drawn.board, f"{column.plan}/{segment}", self.at, "", factor)
        written = fixed(row[self.at], places, self.language)
        return Number(written, column.unit if factor else "mm", source, value)

    def angle(self) -> Number:
        """Return the angle of the cam in the position that is worked."""
        mark = self.made.diagrams.angle
        told = self.of(mark.view)
        assert told is not None
        found = told.number(mark)
        return found._replace(text=number(found.value, self.language))
