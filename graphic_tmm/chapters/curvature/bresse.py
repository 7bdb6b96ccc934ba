"""The circles of Bresse, the pole of accelerations; Ball's point."""

from __future__ import annotations

from typing import NamedTuple

from graphic_tmm.board.operations.instruments import (
    lay_off,
    measure,
    meet,
    parallel,
    similar,
    square,
)
from graphic_tmm.board.record import Mark, between
from graphic_tmm.chapters.curvature import formulas as f
from graphic_tmm.chapters.curvature import words as why
from graphic_tmm.chapters.curvature.bobillier import Holding
from graphic_tmm.chapters.curvature.link_figure import Circle, Held, LinkFigure


class Bresse(NamedTuple):
    """The circles as drawn: points by which the link is held, P, the inflection circle; ``rest``: Π."""

    figure: LinkFigure
    held: tuple[Held, Held]
    pole: Mark
    inflection: Circle
    rest: Mark


def draw_bresse(figure: LinkFigure, holding: Holding, mu: Mark) -> Bresse:
    """Draw both circles; ``mu``: of the view in which P was found."""
    pole = figure.point(holding.pole, mu)
    held = a, b = figure.held = [_held(figure, one, mu) for one in holding.held]
    inflected = [_inflected(figure, pole, one) for one in held]
    lines = [
        figure.put(square, f"({mark.letter}J)", mark, one.normal, sense=1, why=why.FAR_END)
        for one, mark in zip(held, inflected, strict=True)
    ]
    end = figure.put(meet, "J", *lines, why=why.FAR_END)
    inflection = figure.circle(pole, end, "W", why.INFLECTION)
    gained = figure.plans.accelerations
    assert gained is not None
    images = [gained.images.by_letter[figure.number][one.point] for one in (a, b)]
    base = (a.at, b.at, *images, gained.images.pole)
    rest = figure.put(similar, "Π", *base, why=why.NO_ACCELERATION)
    normal = figure.line(pole, end, why.TANGENT)
    tangent = figure.put(square, "(t)", pole, normal, sense=1, why=why.TANGENT)
    joined = figure.line(pole, rest, why.SECOND_END)
    across = figure.put(square, "(ΠT)", rest, joined, sense=1, why=why.SECOND_END)
    far = figure.put(meet, "T", across, tangent, why=why.SECOND_END)
    figure.circle(pole, far, "V", why.SECOND)
    name = between(inflection.middle, rest.letter)
    figure.put(measure, name, inflection.middle, rest, why=why.CHECKED)
    figure.coordinates(rest)
    return Bresse(figure, (a, b), pole, inflection, rest)


def _held(figure: LinkFigure, one: Held, mu: Mark) -> Held:
    """Return a point by which the link is held, as it stands in the view of the circles."""
    at = figure.letters[one.point]
    if one.centre is None:
        normal = figure.put(parallel, f"({one.point}∞)", at, one.normal, sense=1, why=why.GUIDED)
        return one._replace(at=at, normal=normal)
    centre = figure.point(one.centre, mu) if one.pivot is None else figure.point(one.pivot)
    return one._replace(at=at, centre=centre, normal=figure.line(at, centre, why.NORMAL))


def _inflected(figure: LinkFigure, pole: Mark, one: Held) -> Mark:
    """Return where a ray meets the inflection circle: in the point itself, where its path is straight."""
    if one.centre is None:
        return one.at
    name = f"I_{{{one.point}}}"
    away = figure.put(measure, between(one.at, "P"), one.at, pole)
    radius = figure.put(measure, between(one.at, one.centre.letter), one.at, one.centre)
    long = figure.put(f.to_inflection, f"{one.point}{name}", away, radius)
    return figure.put(lay_off, name, one.normal, long)


def draw_ball(figure: LinkFigure, bresse: Bresse) -> LinkFigure:
    """Find Ball's point: where the inflection circle meets the cubic of stationary curvature again.

    A point of the cubic, at the distance r from P and seen under ψ from t, has 1/r = 1/(M·sin ψ) + 1/(N·cos ψ).
    The square on its ray cuts r/cos ψ off t and r/sin ψ off PJ: the corner of the rectangle over both lies on
    the line y/M + x/N = 1, which two points of circles about fixed pivots give. On the inflection circle
    r/sin ψ is its diameter.
    """
    pole, end = (
        figure.point(one, bresse.figure.mu) for one in (bresse.pole, bresse.inflection.end)
    )
    figure.held = [_held(figure, one, bresse.figure.mu) for one in bresse.held]
    figure.circle(pole, end, "W′", why.INFLECTION)
    normal = figure.line(pole, end, why.TANGENT)
    tangent = figure.put(square, "(t)", pole, normal, sense=1, why=why.TANGENT)
    corners = list[Mark]()
    for one in figure.held:
        k = one.point
        across = figure.put(square, f"({k}X)", one.at, one.normal, sense=1, why=why.CORNER)
        x = figure.put(meet, f"X_{{{k}}}", across, tangent, why=why.CORNER)
        y = figure.put(meet, f"Y_{{{k}}}", across, normal, why=why.CORNER)
        up = figure.put(parallel, f"(X_{{{k}}}G)", x, normal, sense=1, why=why.CORNER)
        over = figure.put(parallel, f"(Y_{{{k}}}G)", y, tangent, sense=1, why=why.CORNER)
        corners.append(figure.put(meet, f"G_{{{k}}}", up, over, why=why.CORNER))
    line = figure.line(corners[0], corners[1], why.CUBIC)
    level = figure.put(parallel, "(JG)", end, tangent, sense=1, why=why.BALL_POINT)
    corner = figure.put(meet, "G", line, level, why=why.BALL_POINT)
    down = figure.put(parallel, "(GX)", corner, normal, sense=1, why=why.BALL_POINT)
    foot = figure.put(meet, "X", down, tangent, why=why.BALL_POINT)
    chord = figure.line(end, foot, why.BALL_POINT)
    ray = figure.put(square, "(PU)", pole, chord, sense=1, why=why.BALL_POINT)
    figure.coordinates(figure.put(meet, "U", ray, chord, why=why.BALL_POINT))
    return figure
