"""The phases of a cam for its task: how far and over which angles the follower moves; the law is only named."""

from __future__ import annotations

from collections.abc import Iterator
from itertools import accumulate, pairwise

from graphic_tmm.chapters.cam.task import ASKED, CamTask, RockerFollower
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Bezier, Drawing, Ink, Wanted, line
from graphic_tmm.paper.figure import added
from graphic_tmm.paper.finish import finished
from graphic_tmm.paper.lettering.heights import HEIGHTS
from graphic_tmm.paper.symbols.dimensions import ARROW, Dimension, dimension
from graphic_tmm.paper.symbols.kinematic import arrowhead
from graphic_tmm.readers.task_sheet import Scheme
from graphic_tmm.scene.records import Scene

SIZE = HEIGHTS["A4"].point
TURN, WIDEST, BESIDE = 360.0, 130.0, 26.0
"""A turn, degrees; how wide it is drawn at most; what stands beside it, mm."""
HIGH, OVER = 26.0, 9.0
"""How high the stroke is drawn, how far axes go on, mm."""
ROWS = (8.0, 16.0)
"""How far below the axis the dimensions of wide phases and of narrow ones stand, mm."""
TITLE = said("Phases of the follower's motion", context="task")
LAW = said("the law of motion is given in the table")


def scheme(scene: Scene, room: complex) -> Scheme | None:
    """Return the phases of the cam within a width (of ``room``, complex, mm); None if there is no cam."""
    order = ASKED.of(scene)
    if order is None:
        return None
    wide = min(WIDEST, room.real - BESIDE)
    parts = list(_lines(order, wide))
    axes = (line("thin", 0j, complex(wide + OVER)), line("thin", 0j, 1j * (HIGH + OVER)))
    tips = ((complex(wide + OVER), 1 + 0j), (1j * (HIGH + OVER), 1j))
    strokes = [*added(axes, "axis")]
    for tip, way in tips:
        strokes += added(arrowhead(tip, way, pen="thin", length=ARROW), "axis")
    strokes += added(parts, "contour")
    labels = []
    for one in _sizes(order, wide):
        strokes += added(one.strokes, "dimension")
        labels.append(one.label)
    letters = ("ψ" if isinstance(order.follower, RockerFollower) else "S", "φ")
    wanted = (
        Wanted(letters[0], tips[1][0], SIZE, 1.0, -1 + 0j),
        Wanted(letters[1], tips[0][0], SIZE, 1.0, 1j),
    )
    _ = speaking(scene.language)
    view = Drawing("scheme", _(TITLE), tuple(strokes), tuple(labels), wanted=wanted)
    return Scheme(finished(view), 0.0, (_(LAW),))


def _ends(order: CamTask, wide: float) -> list[float]:
    """Return where the phases begin and end, mm."""
    phases = (order.rise, order.upper_dwell, order.fall, order.lower_dwell)
    return [0.0, *(wide * angle / TURN for angle in accumulate(phases))]


def _lines(order: CamTask, wide: float) -> Iterator[Ink]:
    """Yield the follower at rest above and below, and a bow of no law between."""
    levels = (0.0, HIGH, HIGH, 0.0, 0.0)
    spots = [complex(x, y) for x, y in zip(_ends(order, wide), levels, strict=True)]
    for start, end in pairwise(spots):
        if start.imag == end.imag:
            if start != end:
                yield line("main", start, end)
            continue
        half = complex((end - start).real / 2.0)
        yield Bezier("main", (start, start + half, end - half, end))


def _sizes(order: CamTask, wide: float) -> Iterator[Dimension]:
    """Yield the dimensions: the phases below the axis, the stroke beside it."""
    for number, (start, end) in enumerate(pairwise(_ends(order, wide)), 1):
        if end - start < 1e-6:
            continue
        narrow = end - start < 4.0 * ARROW
        below = -ROWS[1 if narrow else 0]
        yield dimension(complex(start), complex(end), below, f"φ_{{{number}}}", SIZE)
    letter = "β" if isinstance(order.follower, RockerFollower) else "h"
    yield dimension(0j, 1j * HIGH, OVER, letter, SIZE)
