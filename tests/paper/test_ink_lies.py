"""Ink lies where the numbers are: judged by plain geometry, whatever rule drew it.

A rule that drew a wrong line for a step would still know its step; so the strokes of every step are held to
what the step left: on its line, on its arc, with an end in its point. Numbers are proven elsewhere.
"""

from __future__ import annotations

from collections.abc import Iterator
from pathlib import Path

import numpy as np
import pytest
from support import asked
from support.gallery import NAMES, drawn

from graphic_tmm.board.record import Step
from graphic_tmm.board.values import Arc, Line, Point
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.fit import fitted
from graphic_tmm.fitting.views import drawing_of
from graphic_tmm.paper.drawing import Drawing, Stroke
from graphic_tmm.scene.chapter import places
from graphic_tmm.scene.read import read

PLACES = ("positions", "velocities", "accelerations", "forces", "lever")
"""What is drawn in the coordinates of the board."""
NEAR = 1e-6
"""Strokes are computed from the same numbers, mm of some hundred: rounding is below 1e-9."""


def at(row: np.ndarray, k: int) -> complex:
    return complex(row[0, k if row.shape[1] > 1 else 0])


def own(work: Drawn, view: Drawing) -> list[Step]:
    """Return the steps that stand where the view has them: a detached group shows loads in its own size."""
    return [step for step in work.construction.steps if step.it.view in view.shows[:1]]


def astray(work: Drawn, view: Drawing) -> Iterator[str]:
    """Yield the steps of a view whose own strokes lie elsewhere."""
    steps = {step.it.slot: step for step in own(work, view)}
    for stroke in (*view.strokes, *view.rubbed):
        step = steps.get(stroke.of[0]) if len(stroke.of) == 1 and not stroke.part else None
        if step is None or not isinstance(stroke, Stroke) or stroke.filled:
            continue
        reading = work.of(step.it.view)
        assert reading is not None
        value, k = reading[step.it], stroke.position or 0
        spots = [complex(x, y) for x, y, _ in stroke.path]
        pricked = all(bulge for *_, bulge in stroke.path)
        if pricked and step.it.kind is not Arc:
            spots = [sum(spots) / len(spots)]
        if step.it.kind is Line:
            start, along = at(value.at, k), at(value.along, k)
            off = max(abs(((z - start) * along.conjugate()).imag) for z in spots)
        elif step.it.kind is Arc:
            centre, radius = at(value.centre, k), at(value.radius, k).real
            off = max(abs(abs(z - centre) - abs(radius)) for z in spots)
        elif step.it.kind is Point and pricked:
            off = abs(spots[0] - at(value, k))
        else:
            continue
        if not off < NEAR:
            yield f"{view.name}: {step.op.name} {step.it.letter} at {k}: {off:.3g} mm"


def ends(work: Drawn, view: Drawing) -> Iterator[str]:
    """Yield the points laid off or met in a view that none of their lines and letters' strokes reach."""
    for step in own(work, view):
        if step.op.name != "lay_off":
            continue
        reading = work.of(step.it.view)
        assert reading is not None
        left = [s for s in (*view.strokes, *view.rubbed) if step.it.slot in s.of and not s.part]
        for k in {stroke.position or 0 for stroke in left}:
            paths = [
                [complex(x, y) for x, y, _ in s.path]
                for s in left
                if isinstance(s, Stroke) and (s.position or 0) == k
            ]
            there = [z for path in paths for z in (*path, sum(path) / len(path))]  # pricks
            spot = at(reading[step.it], k)
            if there and not min(abs(z - spot) for z in there) < NEAR:
                yield f"{view.name}: {step.it.letter} at {k}"


def faults(work: Drawn) -> list[str]:
    known, found, seen = places(), list[str](), 0
    for place in PLACES:
        chapter = known[place][0]
        if chapter.name not in work.recorded:
            continue
        for view in drawing_of(place)(work, False):
            if view.shows:
                seen += 1
                found += [*astray(work, view), *ends(work, view)]
    assert seen
    return found


EVERY_DAY = ("windrower", "lever")


@pytest.mark.parametrize(
    "name", [n if n in EVERY_DAY else pytest.param(n, marks=pytest.mark.slow) for n in NAMES]
)
def test_strokes_of_a_step_lie_on_what_it_left(name: str) -> None:
    assert faults(drawn(name, exact=True)) == []


@pytest.mark.turns(1)
@pytest.mark.slow
@pytest.mark.parametrize("kind", asked.MECHANISMS)
def test_so_they_do_on_mechanisms_that_are_not_ours(kind: str, tmp_path: Path) -> None:
    path = tmp_path / "scene.toml"
    path.write_text(
        asked.mechanism(kind, 8, [("A1", ("positions", "velocities", "accelerations"))]), "utf-8"
    )
    assert faults(fitted(read(path), exact=True)) == []
