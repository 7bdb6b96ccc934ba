"""A cam that turns, and its follower, which rises and falls (or swings) as its diagram says.

They are drawn as the turn begins: the follower in its position 0.
"""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from graphic_tmm.board.scales import Scale
from graphic_tmm.board.values import Reals
from graphic_tmm.chapters.cam import moving_plate
from graphic_tmm.chapters.cam.flat_rocker import FaceLever
from graphic_tmm.chapters.cam.ink import (
    CROSS,
    PIN,
    ROD,
    TURN,
    face_lever,
    first_place,
    rod,
    shaft,
)
from graphic_tmm.chapters.cam.ink_rules import CamInk
from graphic_tmm.chapters.cam.ink_scheme import cam_body
from graphic_tmm.chapters.cam.plan import CAM_PLAN
from graphic_tmm.chapters.cam.profile import VIEW
from graphic_tmm.chapters.cam.rocker import Lever
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject
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
from graphic_tmm.paper.symbols.kinematic import fixed_pivot
from graphic_tmm.paper.views import mu_text
from graphic_tmm.readers.any_angles.motion import at_angles
from graphic_tmm.scene.captions import captions

BESIDE = 5.0
"""How far a face goes on behind its contacts, mm."""


def pictures(drawn: Drawn) -> Iterator[TurningPicture]:
    """Yield the cam with its follower."""
    cam = CAM_PLAN.of(drawn)
    if cam is not None and cam.order.slides:
        yield from moving_plate.pictures(drawn, cam)
    # a drum is drawn developed: what turns is not seen there
    if cam is None or cam.order.developed:
        return
    language = drawn.scene.language
    on = subject(drawn, captions(language)["cam scheme"], "cam")
    ink = CamInk(on, cam, VIEW)
    diagram = cam.diagrams.S
    high = at_angles(drawn, np.arange(float(WHOLE)))[diagram.reading][0]
    high = high * drawn.value(diagram.chart.mu)
    follower = _follower(ink, high)
    reach = ink.arc((cam.profile.outer or cam.profile.working).upper, 0)[1] + CROSS
    if follower is None or not math.isfinite(reach):
        return
    turning = RigidBody(tuple(cam_body(ink, 1 + 0j)), (Rotation(0j, float(cam.sense)),))
    low = TURN * cmath.rect(1.0, math.radians(-90 + cam.sense * 15))
    wanted = (
        Wanted(
            "O", 0j, ink.heights.point, 2.5, complex(-cam.sense, -1), (cam.profile.centre.slot,)
        ),
        Wanted("ω", low, ink.heights.number, 1.0, -1j),
    )
    axes = tuple(shaft(cam.profile.centre, reach, cam.sense))
    rocks, letter = cam.order.rocks, cam.order.letters["S"]
    told = np.degrees(high) if rocks else 1000.0 * high
    yield TurningPicture(
        on.title,
        mu_text(Scale("μ_l", drawn.value(cam.profile.mu), "m/mm"), language),
        Drawing(VIEW, on.title, axes, wanted=wanted),
        (turning, *follower),
        (
            TurningValue("φ", "°", 0, 1.0),
            TurningValue(letter, "°" if rocks else unit("mm", language), 1, row(told)),
        ),
    )


class _Placed(NamedTuple):
    """A follower as the turn begins: the place of its roller, edge or contact; how far it goes from there.

    ``far``: at every degree, m or radians.
    """

    start: complex
    far: Reals


def _follower(ink: CamInk, high: Reals) -> tuple[RigidBody, ...] | None:
    """Return the follower and what guides it; ``high``: at every degree, m or radians."""
    made = ink.cam.profile
    at = _Placed(
        first_place(ink, complex(ink.all((made.theoretical or made.working).points)[0])),
        high - high[0],
    )
    if not (cmath.isfinite(at.start) and np.isfinite(high).all()):
        return None
    path = ink.cam.path
    return _swinging(ink, path, at) if isinstance(path, Lever | FaceLever) else _upright(ink, at)


def _roller(ink: CamInk, start: complex) -> Iterator[Ink]:
    if ink.cam.profile.roller is not None:
        yield circle("main", start, ink.fixed_number(ink.cam.profile.roller))
        yield circle("joint", start, PIN)


def _swinging(ink: CamInk, path: Lever | FaceLever, at: _Placed) -> tuple[RigidBody, ...]:
    """The lever with its roller or face, and its pivot."""
    (lever,) = ink.figures("face lever" if isinstance(path, FaceLever) else "lever")
    pivot, foot = (first_place(ink, complex(ink.all(mark)[0])) for mark in lever.marks[:2])
    bar: Ink = line("main", pivot, at.start)
    if isinstance(path, FaceLever):
        bar, *_ = face_lever(ink, pivot, foot, at.start)
    angle = row(path.sense * np.degrees(at.far))
    moving = RigidBody((bar, *_roller(ink, at.start)), (Rotation(pivot, angle),))
    return moving, RigidBody(fixed_pivot(pivot))


def _upright(ink: CamInk, at: _Placed) -> tuple[RigidBody, ...]:
    """The rod with its roller, edge or face, and its guide, which the roller does not reach."""
    made, start = ink.cam.profile, at.start
    far = at.far / ink.fixed_number(made.mu)
    roller, strokes = [*_roller(ink, start)], list[Ink]()
    if made.theoretical is None:
        assert made.feet is not None
        feet, contacts = ink.all(made.feet), ink.all(made.working.points)
        half = float(np.nanmax(np.abs(contacts - feet))) + BESIDE
        start = first_place(ink, complex(feet[0]))
        strokes.append(line("main", start - half, start + half))
    radius = ink.fixed_number(made.roller) if made.roller is not None else 0.0
    edge, long = made.roller is None and made.theoretical is not None, ROD + float(np.ptp(far))
    bar, *guide = rod(start, radius, edge=edge, length=long)
    moving = RigidBody((*roller[:1], *strokes, bar, *roller[1:]), (Shift(1j, row(far)),))
    return RigidBody(tuple(guide)), moving


PICTURES = TurningPictures(pictures)
