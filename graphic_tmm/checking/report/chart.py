"""The deviations of one plan as a small chart: SVG to stand inside a page, true mm, no references."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from graphic_tmm.checking.records import DOUBTFUL, FINE, VERDICTS, WRONG, Judged
from graphic_tmm.checking.report.rendering import render
from graphic_tmm.checking.report.rows import signed
from graphic_tmm.checking.report.words import WORDS, plan_name, shown
from graphic_tmm.language.numbers import number

WIDTH, HEIGHT = 180, 46
"""The chart, mm: as wide as an A4 page between its margins."""
LEFT, RIGHT, TOP, BOTTOM = 14, 178, 3, 39
"""The field of the chart, mm from its upper left corner."""
COLOURS = {FINE: "#1b7837", DOUBTFUL: "#9a4a00", WRONG: "#b2001d"}
SHAPES = {
    FINE: "m-1 0a1 1 0 1 0 2 0a1 1 0 1 0 -2 0z",
    DOUBTFUL: "m0 -1.4l1.3 2.2h-2.6z",
    WRONG: "m-1.1 -1.1l2.2 2.2m0 -2.2l-2.2 2.2",
}
"""A disc, a triangle, a cross, about the point of the reading."""
ARROWS = {1: "m-0.8 -1.7l0.8 -1l0.8 1", -1: "m-0.8 1.7l0.8 1l0.8 -1"}
"""Stands by a reading beyond the axis."""
LEAST, MOST = 1.0, 1e6
"""The axis shows at least, and at most, so many % to either side."""
ROOM = 3.0
"""Wrong readings farther than so many times the largest of the others stand at the edge."""
LABELS = 24
"""So many positions are named along the axis."""


def chart(plan: str, readings: Sequence[Judged], language: str) -> str:
    """Return the deviations of a plan's readings in % of its longest vector; "" if fewer than two have any.

    A shape and a colour for each verdict; readings of a position stand together, positions in the order in
    which they come. What is said of a reading when it is pointed at is its title.
    """
    drawn = [one for one in readings if math.isfinite(one.percent)]
    if len(drawn) < 2:
        return ""
    order = {name: k for k, name in enumerate(dict.fromkeys(map(_place, drawn)))}
    drawn.sort(key=lambda one: order[_place(one)])
    limit, step = axis(drawn)
    return render(
        "chart.svg",
        label=f"{plan_name(plan, language)}. {WORDS[language]['chart']}",
        size=(WIDTH, HEIGHT),
        field=(LEFT, RIGHT, TOP, BOTTOM),
        rulings=list(_rulings(limit, step, language)),
        positions=list(_positions(list(map(_place, drawn)))),
        groups=[
            (SHAPES[v], v, COLOURS[v], list(_marks(v, drawn, limit, language))) for v in VERDICTS
        ],
    )


def axis(readings: Sequence[Judged]) -> tuple[float, float]:
    """Return the end of the axis of deviations and the step of its rulings, both in %."""
    most = max(abs(one.percent) for one in readings)
    others = max((abs(one.percent) for one in readings if one.verdict != WRONG), default=0.0)
    reach = min(max(min(most, ROOM * others) if others else most, LEAST), MOST)
    power = 10.0 ** math.floor(math.log10(reach / 2))
    step = next(k * power for k in (1, 2, 5, 10) if k * power >= reach / 2 * (1 - 1e-9))
    return math.ceil(reach / step * (1 - 1e-9)) * step, step


def _rulings(limit: float, step: float, language: str) -> Iterator[tuple[float, str]]:
    """Yield the height of each ruling, mm from above, and what stands beside it."""
    count = round(limit / step)
    for k in range(-count, count + 1):
        text = "0 %" if k == 0 else f"{'+' if k > 0 else ''}{number(k * step, language)}"
        yield _y(k * step, limit), text


def _positions(names: Sequence[str]) -> Iterator[tuple[float, float, str]]:
    """Yield where a position begins and has its middle, mm from the left, and its name; some only, of many."""
    starts = [k for k, name in enumerate(names) if k == 0 or name != names[k - 1]]
    ends = [*starts[1:], len(names)]
    every = -(-len(starts) // LABELS)
    for start, end in list(zip(starts, ends, strict=True))[::every]:
        middle = _x((start + end - 1) / 2, len(names))
        yield _x(start - 0.5, len(names)), middle, shown(names[start], 8)


def _marks(
    verdict: str, readings: Sequence[Judged], limit: float, language: str
) -> Iterator[tuple[float, float, str, str]]:
    """Yield the readings of one verdict: where each stands, the arrow of one beyond the axis, what it is."""
    for k, one in enumerate(readings):
        if one.verdict == verdict:
            percent = math.copysign(one.percent, one.deviation)
            beyond = abs(percent) > limit * (1 + 1e-9)
            arrow = ARROWS[1 if percent > 0 else -1] if beyond else ""
            yield _x(k, len(readings)), _y(percent, limit), arrow, _told(one, percent, language)


def _told(one: Judged, percent: float, language: str) -> str:
    where = " ".join(filter(None, (shown(one.taken.position), shown(one.taken.segment))))
    return f"{where}: {signed(percent, 1, language)} %, {WORDS[language][one.verdict]}"


def _place(one: Judged) -> str:
    """Return what stands under a reading: its position, or its name where it is of no position."""
    return one.taken.position or one.taken.segment


def _x(place: float, count: int) -> float:
    return LEFT + (place + 0.5) * (RIGHT - LEFT) / count


def _y(percent: float, limit: float) -> float:
    share = min(max(percent / limit, -1.0), 1.0)
    return (TOP + BOTTOM) / 2 - share * (BOTTOM - TOP) / 2
