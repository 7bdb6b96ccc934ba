"""What is recorded of the curvature of paths: which link and points, which constructions; what that needs."""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.curvature.bobillier import (
    Holding,
    Path,
    draw_centre,
    draw_held,
    draw_holding,
    draw_path,
    known_paths,
)
from graphic_tmm.chapters.curvature.bresse import Bresse, draw_ball, draw_bresse
from graphic_tmm.chapters.curvature.link_figure import LinkFigure
from graphic_tmm.chapters.curvature.task import ASKED, BALL, BRESSE, CURVATURE, CurvatureTask
from graphic_tmm.chapters.kinematics.bodies import Body
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN, KinematicPlans, chosen
from graphic_tmm.chapters.kinematics.task import ACCELERATIONS, VELOCITIES
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.project import Bench, Plan
from graphic_tmm.scene.chapter import Recorded


@dataclass(frozen=True)
class Curvature:
    """What is drawn of the curvature of paths; ``places``: in which positions (indices).

    ``paths``: of the points asked for, as the plans tell them, ``centres``: of those that do not hold the link,
    by Bobillier; ``bresse``, ``ball``: None where they are not asked for.
    """

    places: tuple[int, ...]
    figure: LinkFigure
    holding: Holding
    paths: tuple[Path, ...]
    centres: tuple[Mark, ...]
    bresse: Bresse | None
    ball: LinkFigure | None

    @property
    def figures(self) -> tuple[LinkFigure, ...]:
        """The views in which the link is drawn."""
        circles = self.bresse.figure if self.bresse is not None else None
        return tuple(one for one in (self.figure, circles, self.ball) if one is not None)


CURVATURE_PLAN: Recorded[Curvature] = Recorded(CURVATURE)


def record(bench: Bench) -> Curvature | None:
    """Draw the centres of curvature that the scene asks for, and the circles of Bresse.

    Raises
    ------
    StructureError
        If the link is none whose points go on curves about several centres, or points are not its own.
    """
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    plans = KINEMATICS_PLAN.on(bench)
    body = _body(plans, order)
    places = chosen(order.positions, bench.names, CURVATURE)
    for view in (CURVATURE, BRESSE, BALL, ACCELERATIONS):
        bench.tell(view, places)
    number, quarters = body.link.number, plans.mechanism.drive.sense * bench.scene.turned
    figure = LinkFigure(bench.draft, plans, body, CURVATURE, f"l{number}")
    known = known_paths(figure)
    held_by = {*known.guides, *known.pivots}
    asked = order.points or tuple(k for k in body.link.points if k not in held_by)
    if straight := next((k for k in asked if k in known.guides), None):
        raise _fault(said(_STRAIGHT, letter=straight), "points")
    bases = known.bases(figure, asked)
    if len(bases) < 2:
        raise _fault(said(_ONE, n=number), "link")
    planned = [k for k in dict.fromkeys((*bases, *asked)) if k in asked or k not in held_by]
    paths = {k: draw_path(figure, k, quarters) for k in planned if k not in known.guides}
    if still := next((k for k, path in paths.items() if path is None), None):
        raise _fault(said("{letter} stands still: it has no path", letter=still), "points")
    drawn = {k: path for k, path in paths.items() if path is not None}
    held = [draw_held(figure, known, k, drawn.get(k)) for k in bases]
    holding = draw_holding(figure, held)
    own = tuple(drawn[k] for k in asked if k in drawn)
    centres = tuple(draw_centre(figure, holding, one) for one in own if one.point not in bases)
    figure.coordinates(holding.pole, *(one.centre for one in own))
    bresse = ball = None
    if order.circles or order.ball:
        circles = LinkFigure(bench.draft, plans, body, BRESSE, "W")
        bresse = draw_bresse(circles, holding, figure.mu)
        if order.ball and any(one.pivot is None for one in holding.held):
            raise _fault(_NO_BALL, "ball")
        if order.ball:
            ball = draw_ball(LinkFigure(bench.draft, plans, body, BALL, "U"), bresse)
    return Curvature(places, figure, holding, own, centres, bresse, ball)


def _body(plans: KinematicPlans, order: CurvatureTask) -> Body:
    """Find the link that is asked for, and refuse one whose paths need no construction."""
    bodies, frame = plans.positions.bodies, plans.mechanism.frame.number
    own = [n for n in bodies if n != frame and {*order.points} <= bodies[n].link.points.keys()]
    moving = own if order.link is None else [n for n in (order.link,) if n in own]
    if not moving:
        text = _NO_LINK if order.link is None else _NO_POINTS
        says = said(text, n=order.link or 0, listed=", ".join(order.points))
        raise _fault(says, "points" if order.points else "link")
    body, fixed = bodies[moving[0]], bodies[frame].marks
    if pivot := next((k for k in body.link.points if k in fixed), None):
        raise _fault(said(_PIVOTED, n=moving[0], letter=pivot), "link")
    if plans.accelerations is None:
        raise StructureError(_REST, "drive.speed", head=CURVATURE)
    if plans.velocities is None or moving[0] not in plans.velocities.rates:
        raise _fault(said(_LEVEL, n=moving[0]), "link")
    return body


_NO_LINK = said("no link has all of the points {listed}: ask for those of one link")
_NO_POINTS = said(
    "there is no moving link {n} with the points {listed}: write them in its [[link]]"
)
_REST = said("the mechanism stands still and has no plan of accelerations: write a speed, not 0")
_PIVOTED = said(
    "link {n} turns about {letter}: that is the centre of curvature of all its paths; take another link"
)
_LEVEL = said(
    "link {n} does not turn: all its points move alike, its instantaneous centre is infinitely far; take one "
    "that turns"
)
_STRAIGHT = said(
    "{letter} slides on a straight guide: its centre of curvature is infinitely far; take it out of points"
)
_ONE = said("link {n} has one point, and two have to be known: give it another in its [[link]]")
_NO_BALL = said(
    "Ball's point wants how curvatures change, known of two points that turn about pivots of the frame: leave "
    "ball out (a point that slides on a straight guide of the frame is Ball's point itself)"
)


def _fault(says: str, key: str) -> StructureError:
    return StructureError(says, f"{CURVATURE}.{key}", head=CURVATURE)


PLAN = Plan(needs=lambda scene: {VELOCITIES: True, ACCELERATIONS: True}, record=record)
