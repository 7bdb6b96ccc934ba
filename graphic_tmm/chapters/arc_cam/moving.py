"""A cam given by arcs that turns, and its follower, drawn on the arcs anew at every degree."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.arc_cam.contour import VIEW
from graphic_tmm.chapters.arc_cam.ink import (
    BEYOND,
    CROSS,
    PIN,
    ROD,
    ContourInk,
    contour_body,
    contour_ways,
    lever_face,
    rod,
)
from graphic_tmm.chapters.arc_cam.plan import ARC_CAM_PLAN, marks
from graphic_tmm.chapters.arc_cam.table import PLAN
from graphic_tmm.chapters.cam.ink import shaft
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.units import unit
from graphic_tmm.page.turning import (
    WHOLE,
    RigidBody,
    Rotation,
    Shift,
    TurningPicture,
    TurningPictures,
    TurningValue,
    row,
)
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, circle, line
from graphic_tmm.paper.seen import finite
from graphic_tmm.paper.symbols.kinematic import fixed_pivot
from graphic_tmm.paper.views import mu_text
from graphic_tmm.readers.any_angles.motion import at_angles


def pictures(drawn: Drawn) -> Iterator[TurningPicture]:
    """Yield the cam with its follower, as the follower begins to rise."""
    if (made := ARC_CAM_PLAN.of(drawn)) is None:
        return
    language, mu = drawn.scene.language, drawn.value(made.contour.mu)
    _ = speaking(language)
    on = subject(drawn, _("Cam with its follower"), PLAN)
    high = at_angles(drawn, np.arange(float(WHOLE)))[marks(made)["S"]][0]
    ink, high = ContourInk(on, made), high * drawn.value(made.charts["S"].mu)
    far = np.degrees(high) if made.order.rocks else high / mu
    if not (finite(complex(ink.points[0])) and np.isfinite(far).all()):
        return
    cam = (*contour_ways(ink), *contour_body(ink))
    reach = float(np.nanmax(np.abs(ink.points))) + CROSS
    free = complex(-made.sense)
    letter = Wanted("O", 0j, ink.heights.point, 2.5, 1j - free, (made.contour.origin.slot,))
    axes = tuple(shaft(made.contour.origin, reach, made.sense))
    rocks = made.order.rocks
    place = ("ψ", "°", 1, row(far)) if rocks else ("S", unit("mm", language), 1, row(1000.0 * high))
    yield TurningPicture(
        on.title,
        mu_text(Scale("μ_l", mu, "m/mm"), language),
        Drawing(VIEW, on.title, axes, wanted=(letter,)),
        (RigidBody(cam, (Rotation(0j, float(made.sense)),)), *_follower(ink, far)),
        (TurningValue("φ", "°", 0, 1.0), TurningValue(*place)),
    )


def _follower(ink: ContourInk, far: Reals) -> Iterator[RigidBody]:
    """The follower in its first position, what guides it."""
    made, start, flat = ink.made, complex(ink.points[0]), ink.made.order.flat
    roller: list[Ink] = []
    if ink.roller > 0.0 and not flat:
        roller = [circle("main", start, ink.roller), circle("joint", start, PIN)]
    if made.follower.pivots is not None:
        pivot = complex(ink.all(made.follower.pivots)[0])
        bar: list[Ink] = [line("main", pivot, start)]
        if flat and made.follower.contacts is not None:
            bar = _long_face(ink, made.follower.pivots, made.follower.contacts)
        sense = made.sense if made.order.same_sense else -made.sense
        yield RigidBody((*bar, *roller), (Rotation(pivot, row(sense * far)),))
        yield RigidBody(fixed_pivot(pivot))
        return
    face: list[Ink] = []
    if flat:
        wide = 0.5 * float(np.nanmax(np.abs(ink.points))) + BEYOND
        face = [line("main", start - wide, start + wide)]
    pointed, long = not flat and ink.roller <= 0.0, ROD + float(np.ptp(far))
    outline, *guide = rod(start, ink.roller, pointed=pointed, length=long)
    yield RigidBody(tuple(guide))
    yield RigidBody((*roller[:1], *face, outline, *roller[1:]), (Shift(1j, row(far)),))


def _long_face(ink: ContourInk, pivots: Mark, contacts: Mark) -> list[Ink]:
    """The face of a lever in its first position, as long as its farthest contact wants it."""
    pivot, start, contact = complex(ink.all(pivots)[0]), complex(ink.points[0]), ink.all(contacts)
    reach = np.abs(contact - ink.all(pivots))
    further = float(np.nanmax(reach) - reach[0]) * (start - pivot) / abs(start - pivot)
    return lever_face(pivot, start + further, complex(contact[0]) + further, "main")


PICTURES = TurningPictures(pictures)
