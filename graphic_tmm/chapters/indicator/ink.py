"""The indicator diagram in ink."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.record import Construction
from graphic_tmm.chapters.indicator.plan import VIEW as INDICATOR
from graphic_tmm.chapters.indicator.plan import Indicator
from graphic_tmm.paper.axes import (
    NUMBER,
    OVER,
    SIZE,
    Spots,
    axes,
    finished,
    largest,
)
from graphic_tmm.paper.drawing import Bezier, Drawing, Stroke, Wanted, line


def draw_indicator_ink(
    construction: Construction,
    reading: Reading,
    made: Indicator,
    names: Sequence[str],
    title: str,
    *,
    lettered: bool = True,
) -> Drawing:
    """Return the indicator diagram with the division of its base; ``names``: of the positions of the row."""
    ink = Spots(construction, reading, len(names))
    origin, end, feet = ink.one(made.origin), ink.one(made.end), ink.all(made.feet)
    spots = ink.all(made.divisions)
    strokes: list[Stroke | Bezier] = list(ink.lines(spots, feet))
    far = complex(spots[int(np.argmax(np.nan_to_num(np.abs(spots - origin))))])
    if np.isfinite(far) and far != origin:
        strokes.append(line("thin", origin, far + 4.0 * (far - origin) / abs(far - origin)))
    high = 0.0
    for side in made.sides:
        points = ink.all(side.points)
        high = max(high, largest(points.imag))
        strokes += ink.lines(feet, points)
    strokes += axes(0.0, end.real, 0.0, high)
    for side in made.sides:
        strokes += ink.curve(side.curve)
        strokes += ink.dots(side.points)
    wanted = [
        Wanted("p", complex(0, high + OVER), SIZE, 1.5, -1 + 0j),
        Wanted("S", complex(end.real + OVER, 0), SIZE, 1.5, -1j),
    ]
    groups: list[tuple[complex, list[str]]] = []
    for name, foot in zip(names, feet, strict=True):
        if not np.isfinite(foot):
            continue
        near = next((texts for spot, texts in groups if abs(spot - foot) < 1.0), None)
        if near is None:
            groups.append((complex(foot), [name]))
        else:
            near.append(name)
    wanted += [Wanted(", ".join(texts), spot, NUMBER, 1.0, -1j) for spot, texts in groups]
    cell = (0.0, -largest(-spots.imag), end.real, high)
    return finished(INDICATOR, title, strokes, wanted, lettered, cell)
