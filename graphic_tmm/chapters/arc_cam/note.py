"""The section of a cam given by arcs in a note: contour, reversed motion, diagrams; what follows."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.formulas import pole_distance, to_board
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.arc_cam import formulas as f
from graphic_tmm.chapters.arc_cam.contour import VIEW
from graphic_tmm.chapters.arc_cam.plan import ARC_CAM_PLAN, VIEWS, ArcCam
from graphic_tmm.chapters.arc_cam.record import BESIDE
from graphic_tmm.chapters.arc_cam.record import VIEW as CALCULATED
from graphic_tmm.chapters.arc_cam.table import arc_columns, results
from graphic_tmm.chapters.arc_cam.task import FLAT, ROCKER
from graphic_tmm.chapters.arc_cam.views import arc_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.note.bricks import columns, filled, greatest, heading, referred, result_number
from graphic_tmm.note.document import Block, Item, Listed, Number, Run, Runs, Source, Text
from graphic_tmm.note.figures import is_figure, picture, readable
from graphic_tmm.note.plans import Page
from graphic_tmm.note.section_chapter import Noted
from graphic_tmm.note.steps import NumberSource
from graphic_tmm.readers.columns import Column

CONTOUR, MOTION = said("Contour of the cam"), said("Displacements by reversed motion")
DIAGRAMS = said("Diagrams by chords, dS/dφ by the instant centre")
CIRCLES = said(
    "Where two arcs touch, their centres and that place lie in one line. So the centres of the flanks stand, "
    "and the roller's centre goes along circles about them, at these distances on the drawing:"
)
TANGENTS = said(
    "A straight flank is the common tangent of base circle and nose. The sizes on the drawing are:"
)
ROLLER_STEPS = (
    said(
        "the cam stands, and the frame is turned round it the other way: the rod's line is drawn for every "
        "position;"
    ),
    said(
        "as long as the roller is on one arc, its centre B keeps its distance from the arc's centre: the rod's "
        "line cuts the circle of that radius at B (on a straight flank, the parallel to it);"
    ),
    said("from the lowest place on the same line the displacement s is measured."),
)
FLAT_STEPS = (
    said(
        "the cam stands, and the frame is turned round it the other way: the rod's line is drawn for every "
        "position;"
    ),
    said(
        "through the centre of the arc that is touched the parallel to the rod is drawn, and the arc's radius "
        "laid off on it: there the face touches, square to the rod;"
    ),
    said(
        "where the face meets the rod's line, the displacement s is measured from the base circle."
    ),
)
ROCKER_STEPS = (
    said(
        "the cam stands, and the frame is turned round it the other way: the lever's pivot goes round in a "
        "circle;"
    ),
    said(
        "about the pivot a circle of the lever's length is struck: where it meets the path of the roller's "
        "centre is B;"
    ),
    said("the swing ψ is the angle of the lever from its place on the base circle."),
)
WORKED = said("In position {position} (φ = {angle}) it is {travel}.")
CHORDS = said(
    "The displacements are laid off over the angle of the cam; the diagram is differentiated twice by chords, "
    "with the pole distances"
)
INSTANT = said(
    "dS/dφ is found once more without differentiation: the normal through B and the line through O square to "
    "the rod meet in the instant centre P of cam and follower, whose distance from O it is. In position "
    "{position}:"
)
PIVOTS = said(
    "dψ/dφ is found once more without differentiation: the normal through B meets the line of the pivots in "
    "the instant centre P of cam and lever, whose distances from the pivots are as the angular velocities. In "
    "position {position}:"
)
SECOND = said(
    "d²S/dφ² is found once more without differentiation, by the arc that the follower is on: its centre is the "
    "crank's pin, the normal the rod of a linkage that moves the follower alike, whose accelerations are "
    "drawn. At a change of arcs it jumps: the index + is that of the arc behind the change."
)
APART = said(
    "By chords dS/dφ is {chords} in position {position}, by the instant centre {instant}: there they differ "
    "most."
)
STROKE = said("The cam lifts its follower by {stroke}.")
SHARPEST = said("The second derivative is largest in size in position {position}: {value}.")


def concludes(drawn: Drawn, language: str) -> Iterator[Runs]:
    """Yield what a cam given by arcs comes to."""
    if ARC_CAM_PLAN.of(drawn) is None:
        return
    _ = speaking(language)
    yield filled(
        _(STROKE), {"stroke": result_number(drawn, results(drawn), "arc_stroke", language)}
    )
    found = {one.segment: one for one in arc_columns(drawn)}
    chords, instant = (found[name].first_figures[1] for name in ("dS", "dS_P"))
    pairs = zip(chords, instant, strict=True)
    apart = [abs(a - b) if a is not None and b is not None else -1.0 for a, b in pairs]
    k = max(range(len(apart)), key=lambda at: (apart[at], -at))
    if apart[k] >= 0.0:
        put: dict[str, Run] = {
            "chords": _cell(drawn, found["dS"], k, language),
            "instant": _cell(drawn, found["dS_P"], k, language),
            "position": Text(drawn.names[k]),
        }
        yield filled(_(APART), put)
    sides = [greatest(drawn, found[name], language) for name in ("ddS_K", "ddS_K_after")]
    most = max(filter(None, sides), key=lambda one: abs(one[0].value), default=None)
    if most is not None:
        yield filled(_(SHARPEST), {"value": most[0], "position": Text(most[1])})


def _cell(drawn: Drawn, column: Column, k: int, language: str) -> Number:
    """Return the quantity that a column holds in a position."""
    value = column.first_figures[1][k]
    assert value is not None
    source = Source("column", drawn.board, f"{column.plan}/{column.segment}", k, "", 1)
    return Number(number(value, language, 3), column.unit, source, value)


def note(drawn: Drawn, language: str) -> Iterator[Block]:
    """Yield the section of a cam given by arcs."""
    made = ARC_CAM_PLAN.of(drawn)
    if made is not None:
        yield from _Page(drawn, made, language).blocks()


class _Page(Page):
    """A cam given by arcs, and the position that is worked: on the flank of the rise."""

    def __init__(self, drawn: Drawn, made: ArcCam, language: str) -> None:
        first, second, *_ = made.lie.changes
        at = max(1, round((second - first) / made.lie.work * made.order.parts / 2.0))
        super().__init__(drawn, language, at)
        self.made = made
        shown = [one for one in readable(drawn, arc_views) if is_figure(one)]
        self.contour, self.graphs = (picture(one, language) for one in shown)

    def blocks(self) -> Iterator[Block]:
        """Yield what is told: contour, follower, diagrams, the table."""
        order = self.made.order
        yield heading(self.speech(CONTOUR))
        straight = order.rise.radius is None and order.fall.radius is None
        yield self.says(TANGENTS if straight else CIRCLES)
        yield from self._formulas(VIEW, to_board)
        yield from self._formulas(VIEW, f.inside, f.outside)
        yield referred((self.contour,), self.language)
        yield self.contour
        yield heading(self.speech(MOTION))
        steps = {FLAT: FLAT_STEPS, ROCKER: ROCKER_STEPS}.get(order.follower, ROLLER_STEPS)
        yield Listed(tuple(Item("", (self.says(one),)) for one in steps))
        told = self._read(VIEW)
        put: dict[str, Run] = {
            "position": Text(self.drawn.names[self.at]),
            "angle": self._angle(),
            "travel": told.number(self.made.follower.travel, unit=True),
        }
        yield self.says(WORKED, put)
        yield from self._diagrams(told)
        yield from columns(self.drawn, arc_columns(self.drawn), self.language)

    def _diagrams(self, told: NumberSource) -> Iterator[Block]:
        yield heading(self.speech(DIAGRAMS))
        yield self.says(CHORDS)
        for view in (VIEWS["V"], VIEWS["A"]):
            yield from self._formulas(view, pole_distance)
        yield referred((self.graphs,), self.language)
        yield self.graphs
        rocks = self.made.order.follower == ROCKER
        where = {"position": Text(self.drawn.names[self.at])}
        yield self.says(PIVOTS if rocks else INSTANT, {**where})
        yield from self.worked_out(told, self.made.follower.rate)
        yield self.says(SECOND)
        beside, speeds = BESIDE.on(self.drawn), list[Mark]()
        if beside.velocity is not None and beside.acceleration is not None:
            speeds = [beside.velocity, beside.acceleration[0]]
        yield from self.worked_out(self._read(CALCULATED), beside.second[0], *speeds)

    def _angle(self) -> Number:
        """Return the angle of the cam in the position that is worked, as the table tells it."""
        steps = [step.it for step in self.drawn.construction.steps if step.op is f.part_of_work]
        return self._read(VIEW).number(next(mark for mark in steps if self._there(mark)))

    def _there(self, mark: Mark) -> bool:
        return math.isfinite(self._read(VIEW).value(mark))

    def _read(self, view: str) -> NumberSource:
        found = self.of(view)
        assert found is not None
        return found

    def _formulas(self, view: str, *ops: Operation) -> Iterator[Block]:
        steps = self.drawn.construction.steps
        marks: Sequence[Mark] = [s.it for s in steps if s.it.view == view and s.op in ops]
        yield from self.worked_out(self._read(view), *marks)


NOTE = Noted(section=note, concludes=concludes)
