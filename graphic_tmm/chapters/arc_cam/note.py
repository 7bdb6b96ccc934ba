"""The section of a cam given by arcs in a note: contour, reversed motion, diagrams; what follows."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence
from functools import cached_property

from graphic_tmm.board.operations.formulas import pole_distance, to_board
from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.arc_cam import formulas as f
from graphic_tmm.chapters.arc_cam.contour import VIEW
from graphic_tmm.chapters.arc_cam.linkage import ACCELERATIONS, VELOCITIES
from graphic_tmm.chapters.arc_cam.plan import VIEWS, ArcCam
from graphic_tmm.chapters.arc_cam.record import BESIDE
from graphic_tmm.chapters.arc_cam.task import FLAT, FLAT_ROCKER, ROCKER
from graphic_tmm.chapters.arc_cam.views import arc_views
from graphic_tmm.language.said import said
from graphic_tmm.note.document import Block, Number, Runs
from graphic_tmm.note.figures import readable
from graphic_tmm.note.page import COLUMNS, Page
from graphic_tmm.note.section_chapter import Noted
from graphic_tmm.paper.drawing import Drawing

CONTOUR, MOTION = said("Contour of the cam"), said("Displacements by reversed motion")
DIAGRAMS = said("Diagrams by chords, dS/dφ by the instant centre")
CIRCLES = said(
    "Where two arcs touch, their centres and that place lie in one line. So the centres of the flanks stand, "
    "and the roller's centre goes along circles about them, at these distances on the drawing:"
)
TANGENTS = said(
    "A straight flank is the common tangent of base circle and nose. The sizes on the drawing are:"
)
ROUND = said(
    "The contour is one circle, an eccentric: the roller's centre goes along a circle about the same centre. "
    "The sizes on the drawing are:"
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
FLAT_ROCKER_STEPS = (
    ROCKER_STEPS[0],
    said(
        "from the pivot the tangent is drawn to the circle about the centre of the arc that is touched, of the "
        "arc's radius and the face's distance from the pivot: it is the lever's line; square to it, through "
        "the arc's centre, the face touches;"
    ),
    ROCKER_STEPS[2],
)
STEPS = {FLAT: FLAT_STEPS, ROCKER: ROCKER_STEPS, FLAT_ROCKER: FLAT_ROCKER_STEPS}
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
    "Both derivatives are found once more without differentiation, by the linkage that replaces the cam on the "
    "arc that the follower is on: its crank leads to the arc's centre, the angular velocity of the cam is put "
    "to 1, and plans of velocities and accelerations are drawn, with directions taken from the contour. At a "
    "change of arcs d²S/dφ² jumps: the index + is that of the arc behind the change."
)
APART = said(
    "By chords dS/dφ is {chords} in position {position}, by the instant centre {instant}: there they differ "
    "most."
)
STROKE = said("The cam lifts its follower by {arc_stroke}.")
SHARPEST = said("The second derivative is largest in size in position {position}: {value}.")


class ArcCamPage(Page[ArcCam]):
    """A cam given by arcs, worked on the flank of the rise."""

    tables = (COLUMNS,)
    by_results = (STROKE,)

    @cached_property
    def at(self) -> int:
        """The position (index) in the middle of the rise's flank."""
        first, second, *_ = self.recorded.lie.changes
        return max(
            1, round((second - first) / self.recorded.lie.work * self.recorded.order.parts / 2.0)
        )

    def views(self) -> Sequence[Drawing]:
        """Return the contour and the diagrams."""
        return readable(self.drawn, lambda held: arc_views(held, True))

    def concludes(self) -> Iterator[Runs]:
        """Yield the stroke, how far dS/dφ is off, the greatest second derivative."""
        yield from super().concludes()
        pairs = [self.columns[name].first_figures[1] for name in ("dS", "dS_P")]
        apart = [
            abs(a - b) if a is not None and b is not None else -1.0
            for a, b in zip(*pairs, strict=True)
        ]
        k = max(range(len(apart)), key=lambda at: (apart[at], -at))
        if apart[k] >= 0.0:
            chords, instant = (self.quantity(name, k) for name in ("dS", "dS_P"))
            names = self.drawn.names
            yield self.sentence(APART, chords=chords, instant=instant, position=names[k])
        sides = filter(None, map(self.greatest, ("ddS_K", "ddS_K_after")))
        most = max(sides, key=lambda one: abs(one[0].value), default=None)
        if most is not None:
            yield self.sentence(SHARPEST, value=most[0], position=most[1])

    def blocks(self) -> Iterator[Block]:
        """Yield what is told: contour, follower, diagrams, the table."""
        order, plans = self.recorded.order, (VELOCITIES, ACCELERATIONS)
        contour, *graphs = [one for one in self.pictures if one not in plans]
        yield self.head(CONTOUR)
        straight = order.rise.radius is None and order.fall.radius is None
        yield self.says(ROUND if order.eccentric else TANGENTS if straight else CIRCLES)
        yield from self.formulas(VIEW, to_board)
        yield from self.formulas(VIEW, f.inside, f.outside)
        yield from self.leads(self.figures(contour))
        yield self.head(MOTION)
        yield self.steps(STEPS.get(order.follower, ROLLER_STEPS))
        travel = self.number(self.recorded.follower.travel)
        yield self.says(WORKED, angle=self._angle(), travel=travel)
        yield from self._diagrams(graphs)
        yield from self.tabled()

    def _diagrams(self, graphs: Sequence[str]) -> Iterator[Block]:
        yield self.head(DIAGRAMS)
        yield self.says(CHORDS)
        for view in (VIEWS["V"], VIEWS["A"]):
            yield from self.formulas(view, pole_distance)
        yield from self.leads(self.figures(*graphs))
        yield self.says(PIVOTS if self.recorded.order.rocks else INSTANT)
        yield from self.worked_out(self.recorded.follower.rate)
        yield self.says(SECOND)
        yield from self.leads(self.figures(VELOCITIES, ACCELERATIONS))
        beside, speeds = BESIDE.on(self.drawn), list[Mark]()
        if beside.velocity is not None and beside.acceleration is not None:
            speeds = [beside.velocity, beside.acceleration[0]]
        yield from self.worked_out(beside.plans.second[0], *speeds)

    def _angle(self) -> Number:
        """Return the angle of the cam in the position that is worked, as the table tells it."""
        steps = self.drawn.construction.steps
        angles = [self.number(step.it) for step in steps if step.op is f.part_of_work]
        return next(angle for angle in angles if math.isfinite(angle.value))


NOTE = Noted(ArcCamPage)
