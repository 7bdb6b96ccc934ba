"""The views of forces of a drawing, and of random loaded mechanisms on a scene of one position."""

from __future__ import annotations

from dataclasses import replace
from typing import Any

from graphic_tmm.chapters.forces.task import ASKED
from graphic_tmm.chapters.forces.views import force_views, lever_views
from graphic_tmm.drawn import Drawn
from graphic_tmm.paper.drawing import Drawing
from support.boards import drawn_of
from support.dynamics import Loaded
from support.figures_judge import scene_of
from support.gallery import NAMES, scene
from support.loaded import order_of
from support.mechanisms import Sampled

LOADED = [name for name in NAMES if ASKED.of(scene(name)) is not None]
"""Scenes of the package that ask for forces."""


def views_of(work: Drawn, place: int | None = None) -> list[Drawing]:
    """The groups, polygons, equations and levers, lettered; those of one position (index) if it is told."""
    views = [*force_views(work, True), *lever_views(work, True)]
    if place is None:
        return views
    return [view for view in views if view.name.endswith(f"-{work.names[place]}")]


def loaded_drawing(
    one: Loaded, drawn: Sampled, *, turned: bool, ruler: float | None = None, **options: Any
) -> Drawn:
    """A random loaded mechanism in the position in which it was put together."""
    order = order_of(one, gravity=True, inertia=True, **options)
    scene = replace(scene_of(one.mechanism, order, [drawn.phi]), turned=turned, ruler=ruler)
    return drawn_of(scene, exact=ruler is None)
