"""Rows for the poles of plans: no readings; they tell from where x and y of points were counted."""

from __future__ import annotations

from collections.abc import Container, Iterable, Mapping

from graphic_tmm.checking.records import Taken
from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.scene.captions import view_name

NEAR = 1.0
"""A pole that was read nearer to the origin than this is the origin, mm: a coordinate read off paper scatters
by 0.75 mm, and a shift by that would be put into all points of the plan."""


def from_poles(
    parts: Iterable[Taken],
    poles: Mapping[str, str],
    points: Mapping[str, Container[str]],
    speech: Speech,
) -> tuple[tuple[Taken, ...], tuple[str, ...]]:
    """Return readings without rows of poles, points counted from where these stand; a word on each shift.

    A row without position is of its plan in all positions.

    Parameters
    ----------
    parts : iterable of Taken
        By the names of their scene, each of one kind of figure.
    poles, points : mapping
        By plan the letter of its pole, and those of its points, of which readings may be.
    """
    kept: list[Taken] = []
    found: dict[tuple[str, str], Taken] = {}
    for part in parts:
        of_pole = poles.get(part.plan) == part.segment
        if not of_pole or part.segment in points.get(part.plan, ()):
            kept.append(part)
        elif part.pointed:
            found[part.plan, part.position] = part
        elif part.mm != 0.0:
            kept.append(part)
    far = {at: one for at, one in found.items() if abs(one.spot) > NEAR}
    shifted = tuple(_shifted(one, far) for one in kept)
    return shifted, tuple(_told(one, speech) for one in far.values())


def _shifted(part: Taken, poles: Mapping[tuple[str, str], Taken]) -> Taken:
    pole = poles.get((part.plan, part.position), poles.get((part.plan, "")))
    if pole is None or not part.pointed:
        return part
    spot = part.spot - pole.spot
    return part._replace(x=spot.real, y=spot.imag)


def _told(pole: Taken, speech: Speech) -> str:
    place = said(", position {position}", position=pole.position) if pole.position else ""
    return speech(
        said(
            "line {line}: the pole {pole} stands at x = {x:g}, y = {y:g}; the points of its plan are "
            "counted from there ({plan}{at})",
            line=pole.line,
            pole=pole.segment,
            x=pole.x,
            y=pole.y,
            plan=view_name(pole.plan, speech.language),
            at=place,
        )
    )
