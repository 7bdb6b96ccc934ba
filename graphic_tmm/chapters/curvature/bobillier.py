"""Centres of curvature from the plans and by Bobillier's construction."""

from __future__ import annotations

from collections.abc import Iterable, Mapping
from typing import NamedTuple

from graphic_tmm.board.operations.instruments import (
    incline,
    lay_off,
    measure,
    meet,
    parallel,
    square,
)
from graphic_tmm.board.operations.supports import swung
from graphic_tmm.board.record import Mark, between
from graphic_tmm.chapters.curvature import formulas as f
from graphic_tmm.chapters.curvature import words as why
from graphic_tmm.chapters.curvature.link_figure import Held, LinkFigure
from graphic_tmm.chapters.kinematics.bodies import sliding_points
from graphic_tmm.chapters.kinematics.drives.slider import Slider
from graphic_tmm.chapters.kinematics.motion import component, image_letter
from graphic_tmm.chapters.kinematics.rows import path_radius, read_path


class Path(NamedTuple):
    """A point whose path is curved, as the plans tell it.

    ``radius``: ρ (m); ``normal``: the line from the point on which the ``centre`` was laid off.
    """

    point: str
    at: Mark
    radius: Mark
    normal: Mark
    centre: Mark


class Holding(NamedTuple):
    """The instantaneous centre P, the points by which the link is held, the axis of their rays, tangent t."""

    pole: Mark
    held: tuple[Held, Held]
    axis: Mark
    tangent: Mark


class Known(NamedTuple):
    """Letters of the link whose paths are known without plans: guides and pivots on the plan of positions."""

    guides: Mapping[str, Mark]
    pivots: Mapping[str, Mark]

    def bases(self, figure: LinkFigure, asked: Iterable[str]) -> list[str]:
        """Return the letters of two points by which the link is held: of known paths, else any."""
        spots, found = figure.body.link.points, list[str]()
        known = [k for k in spots if k in self.guides or k in self.pivots]
        for letter in (*known, *(k for k in spots if k not in (*known, *asked)), *asked):
            pivot = self.pivots.get(letter)
            if all(
                spots[letter] != spots[k] and (pivot is None or self.pivots.get(k) != pivot)
                for k in found
            ):
                found.append(letter)
        return found[:2]


def known_paths(figure: LinkFigure) -> Known:
    """Find the letters of a link that slide on the frame or turn about a pivot of it."""
    positions, own = figure.plans.positions, figure.body.link.points
    sliding = sliding_points(positions.closings, positions.bodies, figure.frame, figure.view)
    guides = {letter: leg.line for letter, leg in sliding if letter in own}
    for pair in figure.plans.pairs:
        if isinstance(pair, Slider):
            line = pair.path(positions, figure.draft.uses)
            guides |= {k: line for k in positions.bodies[pair.link].marks if k in own}
    pivots = {k: positions.pivot_of(k, figure.frame) for k in own if k not in guides}
    return Known(guides, {k: pivot for k, pivot in pivots.items() if pivot is not None})


def draw_path(figure: LinkFigure, letter: str, quarters: int) -> Path | None:
    """Find the radius of curvature of a path from the plans; None where the point stands still.

    ``quarters``: right angles by which the plan of velocities is turned.
    """
    draft, velocities, gained = figure.draft, figure.plans.velocities, figure.plans.accelerations
    assert velocities is not None
    assert gained is not None
    image, end = (one.images.by_letter[figure.number][letter] for one in (velocities, gained))
    read = read_path(draft, (velocities, gained), letter, (image, end), quarters)
    if read is None:
        return None
    speed, along, part = read
    component(draft, part, "n", image_letter(letter))
    at, name = figure.letters[letter], centre_letter(letter)
    radius = figure.put(
        path_radius, f"ρ_{{{letter}}}", speed, velocities.mu, part, gained.mu, unit="m"
    )
    normal = figure.put(parallel, f"({letter}{name})", at, along, sense=1, why=why.NORMAL)
    long = figure.put(f.radius_towards, f"{letter}{name}", radius, figure.mu, part)
    return Path(letter, at, radius, normal, figure.put(lay_off, name, normal, long, why=why.LAID))


def centre_letter(letter: str) -> str:
    """Return the letter of the centre of curvature of a point's path: K_0, S_{02} of S2."""
    return f"{letter}_0" if len(letter) == 1 else f"{letter[0]}_{{0{letter[1:]}}}"


def draw_held(figure: LinkFigure, known: Known, letter: str, path: Path | None) -> Held:
    """Draw the normal to the path of a point by which the link is held."""
    at, pivot = figure.letters[letter], known.pivots.get(letter)
    if letter in known.guides:
        guide = known.guides[letter]
        normal = figure.put(square, f"({letter}∞)", at, guide, sense=1, why=why.GUIDED)
        return Held(letter, at, None, normal, guide)
    if pivot is not None:
        centre = figure.point(pivot)
        return Held(letter, at, centre, figure.line(at, centre, why.NORMAL), pivot=pivot)
    assert path is not None
    return Held(letter, at, path.centre, path.normal)


def draw_holding(figure: LinkFigure, held: list[Held]) -> Holding:
    """Find P, the axis of the rays to both points and the common tangent of the centrodes."""
    a, b = figure.held = held if held[0].centre is not None else held[::-1]
    pole = figure.put(meet, "P", a.normal, b.normal, why=why.POLE)
    through = figure.line(a.at, b.at, why.CENTRES)
    if a.centre is None:
        axis, way = (
            figure.put(parallel, "(PQ)", pole, through, sense=1, why=why.AXIS_ENDLESS),
            (a.at, b.at),
        )
    else:
        name = f"({a.centre.letter}∞)"
        line = (
            figure.put(parallel, name, a.centre, b.normal, sense=1, why=why.ENDLESS)
            if b.centre is None
            else figure.line(a.centre, b.centre, why.CENTRES)
        )
        crossing = figure.put(meet, "Q", line, through, why=why.CENTRES)
        axis, way = figure.line(pole, crossing, why.AXIS), (pole, crossing)
    turn = figure.put(swung, "δ", *way, pole, a.at, unit="°", sense=1, why=why.EQUAL_ANGLE)
    tangent = figure.put(incline, "(t)", pole, b.normal, turn, why=why.EQUAL_ANGLE)
    return Holding(pole, (a, b), axis, tangent)


def draw_centre(figure: LinkFigure, holding: Holding, path: Path) -> Mark:
    """Find the centre of curvature of another point by the axis of its ray and the first one."""
    letter, at, pole, (a, b) = path.point, path.at, holding.pole, holding.held
    ends, index = (pole, b.at, pole, at), f"_{{{letter}}}"
    turn = figure.put(swung, f"δ{index}", *ends, unit="°", sense=1, why=why.TURN)
    own = figure.put(incline, f"(PQ{index})", pole, holding.axis, turn, why=why.NEXT_AXIS)
    meeting = figure.put(meet, f"Q{index}", own, figure.line(a.at, at), why=why.NEXT_AXIS)
    if a.centre is None:
        to = figure.put(parallel, f"(Q{index}∞)", meeting, a.normal, sense=1, why=why.ENDLESS)
    else:
        to = figure.line(meeting, a.centre, why.RAY)
    onto, name = figure.line(at, pole, why.RAY), f"{path.centre.letter}′"
    centre = figure.put(meet, name, to, onto, why=why.RAY)
    figure.put(measure, between(at, name), at, centre)
    return centre
