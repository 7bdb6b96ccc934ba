"""A cam that slides, on the page: forth over half of a turn and back, its follower as its diagram says."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.operations.curve import bezier
from graphic_tmm.board.scales import Scale
from graphic_tmm.chapters.cam.ink import PIN, ROD, rod
from graphic_tmm.chapters.cam.ink_drum import ground, plate
from graphic_tmm.chapters.cam.ink_rules import CamInk
from graphic_tmm.chapters.cam.plan import Cam
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject
from graphic_tmm.language.units import unit
from graphic_tmm.page.turning import WHOLE, RigidBody, Shift, TurningPicture, TurningValue, row
from graphic_tmm.paper.clipping import points
from graphic_tmm.paper.drawing import Drawing, Ink, circle
from graphic_tmm.paper.views import mu_text
from graphic_tmm.scene.captions import captions

FINE = 32
"""So many points tell an arc of the diagram between two positions: as exactly as lines are broad."""


def pictures(drawn: Drawn, cam: Cam) -> Iterator[TurningPicture]:
    """Yield the cam with its follower."""
    language, made, chart = drawn.scene.language, cam.profile, cam.diagrams.S.chart
    on = subject(drawn, captions(language)["cam scheme"], "cam")
    ink, mu, mm = CamInk(on, cam, made.view), drawn.value(made.mu), unit("mm", language)
    runs = [run for curve in cam.diagrams.S.curves for run in bezier(ink.reading[curve])]
    if len(runs) < len(cam.diagrams.S.curves):
        return
    spots = np.concatenate([points(run.tolist(), FINE * (len(run) // 3) + 1) for run in runs])
    spots -= ink.point(cam.diagrams.S.axes.origin, 0)
    gone = cam.order.whole * (1.0 - np.abs(np.arange(WHOLE) / (WHOLE / 2) - 1.0))
    far = np.interp(gone / drawn.value(cam.diagrams.base.mu), spots.real, spots.imag)
    far *= drawn.value(chart.mu)
    start, long = 1j * far[0] / mu, cam.order.whole / mu
    radius = ink.fixed_number(made.roller) if made.roller is not None else 0.0
    bar, *guide = rod(start, radius, edge=radius == 0.0, length=ROD + float(np.ptp(far)) / mu)
    pins: list[Ink] = [circle("main", start, radius), circle("joint", start, PIN)]
    rises = Shift(1j, row((far - far[0]) / mu))
    yield TurningPicture(
        on.title,
        mu_text(Scale("μ_l", mu, "m/mm"), language),
        Drawing(made.view, on.title, tuple(ground(ink, cam, -long, long))),
        (
            RigidBody(tuple(plate(ink, cam, long)), (Shift(-1 + 0j, row(gone / mu)),)),
            RigidBody(tuple(guide)),
            RigidBody((pins[0], bar, pins[1]) if radius else (bar,), (rises,)),
        ),
        (
            TurningValue("s_{c}", mm, 1, row(1000.0 * gone)),
            TurningValue("S", mm, 1, row(1000.0 * far)),
        ),
    )
