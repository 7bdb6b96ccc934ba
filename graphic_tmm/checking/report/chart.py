"""The deviations of one plan as a small chart: SVG to stand inside a page, true mm, no references."""

from __future__ import annotations

import math
from collections.abc import Sequence
from html import escape

from graphic_tmm.checking.records import DOUBTFUL, FINE, VERDICTS, WRONG, Judged
from graphic_tmm.checking.report.rows import signed
from graphic_tmm.checking.report.words import WORDS, plan_name, shown
from graphic_tmm.language.words import number

WIDTH, HEIGHT = 180.0, 46.0
"""The chart, mm: as wide as an A4 page between its margins."""
LEFT, RIGHT, TOP, BOTTOM = 14.0, 178.0, 3.0, 39.0
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
    label = f"{plan_name(plan, language)}. {WORDS[language]['chart']}"
    parts = [
        f'<svg class="chart" role="img" aria-label="{escape(label)}" width="{WIDTH:g}mm" '
        f'height="{HEIGHT:g}mm" viewBox="0 0 {WIDTH:g} {HEIGHT:g}">',
        f"<title>{escape(label)}</title>",
        _rulings(limit, step, language),
        _positions(list(map(_place, drawn))),
        *(_marks(verdict, drawn, limit, language) for verdict in VERDICTS),
        "</svg>",
    ]
    return "\n".join(part for part in parts if part)


def axis(readings: Sequence[Judged]) -> tuple[float, float]:
    """Return the end of the axis of deviations and the step of its rulings, both in %."""
    most = max(abs(one.percent) for one in readings)
    others = max((abs(one.percent) for one in readings if one.verdict != WRONG), default=0.0)
    reach = min(max(min(most, ROOM * others) if others else most, LEAST), MOST)
    power = 10.0 ** math.floor(math.log10(reach / 2))
    step = next(k * power for k in (1, 2, 5, 10) if k * power >= reach / 2 * (1 - 1e-9))
    return math.ceil(reach / step * (1 - 1e-9)) * step, step


def _rulings(limit: float, step: float, language: str) -> str:
    count = round(limit / step)
    lines, texts = [], []
    for k in range(-count, count + 1):
        y = _y(k * step, limit)
        lines.append(f"M{LEFT:g} {y:.2f}H{RIGHT:g}")
        text = "0 %" if k == 0 else f"{'+' if k > 0 else ''}{number(k * step, language)}"
        texts.append(f'<text x="{LEFT - 1:g}" y="{y + 0.9:.2f}">{text}</text>')
    zero = f'<path d="{lines[count]}" stroke="#444" stroke-width="0.3"/>'
    ruled = f'<path d="{"".join(lines)}" stroke="#ccc" stroke-width="0.15"/>'
    return f'{ruled}{zero}<g font-size="2.6" text-anchor="end" fill="#333">{"".join(texts)}</g>'


def _positions(names: Sequence[str]) -> str:
    """Return the names of the positions under the field, and lines between them."""
    starts = [k for k, name in enumerate(names) if k == 0 or name != names[k - 1]]
    ends = [*starts[1:], len(names)]
    every = -(-len(starts) // LABELS)
    lines, texts = [], []
    for start, end in list(zip(starts, ends, strict=True))[::every]:
        lines.append(f"M{_x(start - 0.5, len(names)):.2f} {TOP:g}V{BOTTOM:g}")
        middle = _x((start + end - 1) / 2, len(names))
        text = escape(shown(names[start], 8))
        texts.append(f'<text x="{middle:.2f}" y="{BOTTOM + 4:g}">{text}</text>')
    ruled = f'<path d="{"".join(lines)}" stroke="#ccc" stroke-width="0.15"/>'
    return f'{ruled}<g font-size="2.6" text-anchor="middle" fill="#333">{"".join(texts)}</g>'


def _marks(verdict: str, readings: Sequence[Judged], limit: float, language: str) -> str:
    """Return the readings of one verdict: shapes that bear what they are as their titles."""
    parts = []
    for k, one in enumerate(readings):
        if one.verdict == verdict:
            percent = math.copysign(one.percent, one.deviation)
            at = f"M{_x(k, len(readings)):.2f} {_y(percent, limit):.2f}"
            beyond = abs(percent) > limit * (1 + 1e-9)
            arrow = f"{at}{ARROWS[1 if percent > 0 else -1]}" if beyond else ""
            told = escape(_told(one, percent, language))
            parts.append(f'<path d="{at}{SHAPES[verdict]}{arrow}"><title>{told}</title></path>')
    if not parts:
        return ""
    fill = "none" if verdict == WRONG else COLOURS[verdict]
    style = (
        f'fill="{fill}" stroke="{COLOURS[verdict]}" stroke-width="{0.5 if fill == "none" else 0.2}"'
    )
    return "\n".join([f'<g class="{verdict}" {style}>', *parts, "</g>"])


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
