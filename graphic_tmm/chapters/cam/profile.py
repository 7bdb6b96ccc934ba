"""The profile of a cam by inversion: the cam stands, the follower goes round it against the cam's sense.

The theoretical profile runs through the roller's centre, the working profile touches the rollers: it is as far
from the theoretical one as the roller's radius. A flat face draws its working profile directly.
"""

from __future__ import annotations

from collections.abc import Sequence
from dataclasses import dataclass
from typing import NamedTuple

from graphic_tmm.board.draft import Draft
from graphic_tmm.board.operations.formulas import advance, to_board, total
from graphic_tmm.board.operations.instruments import lay_off, measure, parallel, ray, square, strike
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Line, Point
from graphic_tmm.chapters.cam import formulas as f
from graphic_tmm.chapters.cam import formulas_drum, words_drum
from graphic_tmm.chapters.cam import words as why
from graphic_tmm.chapters.cam.centre import Centre, Convexity, Path
from graphic_tmm.chapters.cam.diagrams import Diagrams
from graphic_tmm.chapters.cam.operations import inward_normal, phase_end, slew, swept_profile
from graphic_tmm.chapters.cam.rocker import Lever

VIEW = "cam profile"
THEORETICAL, WORKING, OUTER = "theoretical", "working", "outer"
"""What contours are called as bodies of the plan."""


@dataclass(frozen=True)
class Contour:
    """A closed profile: a curve for every stretch, the circles of the upper and of the lower dwell (Arc).

    Of a developed drum lines stand for the circles.

    ``points``: through which it runs. Its stretches and dwells follow each other in the sense ``sense`` (1
    counter- clockwise about the centre), against that of the cam.
    """

    points: Mark
    curves: tuple[Mark, ...]
    upper: Mark
    lower: Mark
    sense: int


@dataclass(frozen=True)
class Profile:
    """The profiles as drawn: centre O, the guides in their inverted places, both contours.

    ``theoretical``: of a roller, of a knife edge the working one too; ``guides``: lines of the path or of the
    face; ``feet``: where the guides touch the circle of the offset, or the pivots of the lever, or the middles
    of the face; ``normals``; ``roller``: its radius (Length); ``outer``: the other flank of a groove.
    """

    view: str
    mu: Mark
    centre: Mark
    feet: Mark | None
    guides: Mark
    normals: Mark
    roller: Mark | None
    theoretical: Contour | None
    working: Contour
    outer: Contour | None = None


class _Inverted(NamedTuple):
    """The follower in its inverted places: its points, its guides, the directions of its motion."""

    feet: Mark | None
    guides: Mark
    paths: Mark
    points: Mark


def draw_profile(
    draft: Draft,
    diagrams: Diagrams,
    centre: Centre,
    path: Path | Lever,
    roller: Mark | None,
    sense: int,
    *,
    groove: bool = False,
) -> Profile:
    """Draw both profiles of a cam with a roller; ``roller``: its radius (Number, m).

    A knife edge has none: its point draws the working profile, which is the theoretical one.
    """
    origin = begin_profile(draft, centre.mu)
    if isinstance(path, Lever):
        placed = _rocker(draft, diagrams, centre, path, origin, sense)
    else:
        placed = _translating(draft, diagrams, centre, path, origin, sense)
    normals = draft.draw(
        inward_normal, "(n)", placed.points, placed.paths, centre.pressure, sense=sense
    )
    paces = [centre.pace] * len(diagrams.stretches)
    name = WORKING if roller is None else THEORETICAL
    theoretical = draw_contour(
        draft, name, diagrams, origin, (placed.points, normals), paces, sense
    )
    stands = (VIEW, centre.mu, origin, placed.feet, placed.guides, normals)
    if roller is None:
        draft.figure("guide", "", *(() if placed.feet is None else (placed.feet,)), placed.points)
        return Profile(*stands, None, theoretical, theoretical)
    radius = draft.draw(to_board, "R_r", roller)
    draft.figure("roller", "", placed.points, radius)
    if isinstance(path, Lever):
        assert placed.feet is not None
        draft.figure("lever", "", placed.feet, placed.points)
    else:
        draft.figure("guide", "", *(() if placed.feet is None else (placed.feet,)), placed.points)
    flanks = draw_flanks(
        draft, diagrams, centre, origin, (placed.points, normals), radius, sense, groove=groove
    )
    return Profile(*stands, radius, theoretical, *flanks)


def draw_flanks(
    draft: Draft,
    diagrams: Diagrams,
    centre: Centre,
    origin: Mark,
    on: tuple[Mark, Mark],
    radius: Mark,
    sense: int,
    *,
    groove: bool = True,
) -> tuple[Contour, Contour | None]:
    """Draw the working profile, and of a ``groove`` the outer flank, on the other side of the roller.

    ``on``: the roller's centres and the inward normals there; ``radius`` of the roller (Length).
    """
    points, normals = on
    contacts = draft.draw(lay_off, "K", normals, radius, why=why.CONTACT)
    paces = [
        draft.draw(f.equidistant_pace, "p", centre.pace, radius, turning)
        for turning in centre.turning
    ]
    working = draw_contour(draft, WORKING, diagrams, origin, (contacts, normals), paces, sense)
    if not groove:
        return working, None
    outward = draft.draw(parallel, "(n′)", points, normals, sense=-1)
    contacts = draft.draw(lay_off, "K′", outward, radius, why=words_drum.FLANK)
    paces = [
        draft.draw(formulas_drum.outer_pace, "p′", centre.pace, radius, turning)
        for turning in centre.turning
    ]
    outer = draw_contour(draft, OUTER, diagrams, origin, (contacts, normals), paces, sense)
    return working, outer


def draw_flat_profile(draft: Draft, diagrams: Diagrams, of: Convexity, sense: int) -> Profile:
    """Draw the profile of a cam with a flat face."""
    origin = begin_profile(draft, of.mu)
    along = draft.draw(ray, "(y)", origin, draft.direction(90.0), why=why.FOLLOWER_LINE)
    paths = draft.draw(slew, "(B)", origin, along, diagrams.angle, sense=-sense, why=why.INVERTED)
    reach = draft.draw(total, "r_0+S", of.radius, of.motion.S, why=why.REACH)
    middles = draft.draw(lay_off, "B", paths, reach, why=why.PROFILE_POINT)
    faces = draft.draw(square, "(f)", middles, paths, sense=-sense)
    velocity = of.motion.V
    contacts = draft.draw(lay_off, "K", faces, velocity, why=why.CONTACT)
    normals = draft.draw(parallel, "(n)", contacts, paths, sense=-1)
    paces = [draft.draw(f.convex, "p", radius) for radius in of.radii]
    draft.figure("face", "", middles, contacts)
    working = draw_contour(draft, WORKING, diagrams, origin, (contacts, normals), paces, sense)
    return Profile(VIEW, of.mu, origin, middles, faces, normals, None, None, working)


def begin_profile(draft: Draft, mu: Mark) -> Mark:
    """Open the view of the profile, to the scale ``mu``; return the centre of the cam."""
    draft.open(VIEW)
    draft.lay_out(None, mu)
    return draft.take(Point, "O", 0j)


def _translating(
    draft: Draft, diagrams: Diagrams, centre: Centre, path: Path, origin: Mark, sense: int
) -> _Inverted:
    """Turn the guide back by the angle of the cam; lay the displacement off on it."""
    reach = draft.draw(total, "s_0+S", path.s0, centre.displacement, why=why.REACH)
    if path.offset is None:
        up = draft.draw(ray, "(y)", origin, draft.direction(90.0), why=why.FOLLOWER_LINE)
        guides = draft.draw(slew, "(B)", origin, up, diagrams.angle, sense=-sense, why=why.INVERTED)
        return _Inverted(
            None, guides, guides, draft.draw(lay_off, "B", guides, reach, why=why.PROFILE_POINT)
        )
    side = draft.draw(ray, "(x)", origin, draft.direction(0.0 if sense > 0 else 180.0))
    arms = draft.draw(slew, "(E)", origin, side, diagrams.angle, sense=-sense, why=why.INVERTED)
    feet = draft.draw(lay_off, "E", arms, path.offset)
    guides = draft.draw(square, "(B)", feet, arms, sense=sense)
    return _Inverted(
        feet, guides, guides, draft.draw(lay_off, "B", guides, reach, why=why.PROFILE_POINT)
    )


def _rocker(
    draft: Draft, diagrams: Diagrams, centre: Centre, of: Lever, origin: Mark, sense: int
) -> _Inverted:
    """Turn the line of centres back by the angle of the cam; lay off the lever's angle and its length."""
    begin = draft.draw(parallel, "(OO_1)", origin, of.line, sense=-1)
    centres = draft.draw(
        slew, "(O_1)", origin, begin, diagrams.angle, sense=-sense, why=why.INVERTED
    )
    pivots = draft.draw(lay_off, "O_1", centres, of.centres)
    back = draft.draw(parallel, "(O)", pivots, centres, sense=-1)
    angle = draft.draw(advance, "ψ_0+ψ", of.start, of.swing)
    levers = draft.draw(slew, "(l)", pivots, back, angle, sense=of.sense)
    points = draft.draw(lay_off, "B", levers, of.lever, why=why.PROFILE_POINT)
    paths = draft.draw(square, "(t)", points, levers, sense=of.sense)
    return _Inverted(pivots, levers, paths, points)


def draw_contour(
    draft: Draft,
    name: str,
    diagrams: Diagrams,
    origin: Mark,
    on: tuple[Mark, Mark],
    paces: Sequence[Mark],
    sense: int,
) -> Contour:
    """Draw the profile of every stretch and the circles of the dwells; tell them as a body in their order.

    ``origin``: the centre of the circles, or the line to which dwells are parallel on a development; ``on``:
    the points through which it runs and the normals there.
    """
    turn, (points, normals) = diagrams.turn, on
    curves = []
    for pace, (phase, first, last) in zip(paces, diagrams.stretches, strict=True):
        step = diagrams.steps[turn.phases.index(phase)]
        letter = f"({points.letter}–{points.letter})"
        uses = (points, normals, pace, step)
        curves.append(draft.draw(swept_profile, letter, *uses, first=first, last=last, sense=sense))
    order, levels = list(curves), dict[float, Mark]()
    most = max(max(phase.ends) for phase in turn.phases)
    for phase in turn.phases:
        high = phase.ends[1]
        if not (turn.rest(phase) or high in (0.0, most)):
            continue
        end = draft.draw(phase_end, f"{points.letter}_e", points, at=phase.last, free=True)
        if origin.kind is Line:
            circle = draft.draw(parallel, f"({end.name})", end, origin, why=words_drum.DWELL)
        else:
            far = draft.draw(measure, f"O{end.name}", origin, end, why=why.DWELL)
            circle = draft.draw(strike, f"(O{end.name})", origin, far, why=why.DWELL)
        behind = max(k for k, row in enumerate(diagrams.stretches) if row[0] is phase)
        order.insert(order.index(curves[behind]) + 1, circle)
        levels.setdefault(high, circle)
    draft.figure("contour", name, *order)
    return Contour(points, tuple(curves), levels[most], levels.get(0.0, levels[most]), -sense)
