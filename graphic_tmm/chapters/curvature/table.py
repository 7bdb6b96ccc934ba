"""The columns of the constructions at their positions, and their plans in protocols."""

from __future__ import annotations

from collections.abc import Iterator

import numpy as np

from graphic_tmm.board.record import Mark, between, segment_name
from graphic_tmm.board.values import Length, Reals
from graphic_tmm.chapters.curvature.bobillier import Path
from graphic_tmm.chapters.curvature.record import CURVATURE_PLAN
from graphic_tmm.chapters.curvature.scales import readable_places
from graphic_tmm.chapters.curvature.task import CURVATURE
from graphic_tmm.chapters.curvature.words import OFF
from graphic_tmm.drawn import Drawn, Results
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Column, Tabled, empty, ordinates, row_of
from graphic_tmm.readers.protocol import Protocols


def curvature_columns(drawn: Drawn) -> Iterator[Column]:
    """Yield radii of curvature, then what is measured on the constructions, where these are drawn."""
    made, reading, count = CURVATURE_PLAN.on(drawn), drawn.reading, len(drawn.names)
    for figure in made.figures:
        there = drawn_places(drawn, figure.mu)
        gone = np.isin(np.arange(count), there, invert=True)[None]
        for one in made.paths if figure is made.figure else ():
            row = row_of(reading.figure(one.radius), drawn.all, count)
            of = (f"rho{one.point}", one.radius.name, "m", empty(count), row)
            yield Column(figure.view, *of).blank(gone)
        for step in drawn.construction.steps:
            if step.it.view == figure.view and step.it.kind is Length and step.op.reads:
                rows = ordinates(reading, step.it, figure.mu, count)
                segment = segment_name(step.it.letter)
                yield Column(figure.view, segment, step.it.name, "m", *rows).blank(gone)


def by_bobillier(path: Path) -> str:
    """Return what machines call the distance from a point to its centre of curvature by Bobillier."""
    return segment_name(between(path.at, f"{path.centre.letter}′"))


def off_name(path: Path) -> str:
    """Return the name of the result that tells how far both radii of curvature are apart."""
    return f"{OFF}{path.point}"


def _results(drawn: Drawn) -> Results:
    """Return by how much radii by Bobillier are off those by the plans, at the most, % of these."""
    made = CURVATURE_PLAN.of(drawn)
    if made is None:
        return {}
    found: dict[str, tuple[Reals, str]] = {}
    there, rows = drawn_places(drawn, made.figure.mu), {}
    for one in curvature_columns(drawn):
        rows[one.segment] = one.value[:, there]
    for path in made.paths:
        plans, drawn_ = rows[f"rho{path.point}"], rows.get(by_bobillier(path))
        if drawn_ is not None and np.isfinite(drawn_ - plans).any(axis=1).all():
            apart = 100.0 * np.abs(drawn_ - plans) / plans
            most = np.fmax.reduce(apart, axis=1)
            found[off_name(path)] = np.array(np.round(most, drawn.percent_decimals)), "%"
    return found


def drawn_places(drawn: Drawn, mu: Mark) -> list[int]:
    """Return the positions (indices) in which the construction of a μ is drawn."""
    return [k for k in readable_places(drawn, mu) if k not in drawn.undrawn]


def radius_marks(project: Project) -> dict[tuple[str, str], Mark]:
    """Return the radii of curvature (m) by plan and the name that machines read."""
    paths = CURVATURE_PLAN.on(project).paths
    return {(CURVATURE, f"rho{one.point}"): one.radius for one in paths}


TABLE = Tabled(columns=curvature_columns, results=_results)
PROTOCOL = Protocols(
    views=lambda project: {CURVATURE: [one.view for one in CURVATURE_PLAN.on(project).figures]}
)
