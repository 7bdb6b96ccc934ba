"""The pictures of a report as SVG: the chart of a plan's deviations, a small plan."""

from __future__ import annotations

import cmath
import math
from collections.abc import Iterable, Iterator, Sequence
from functools import cache, partial
from typing import TYPE_CHECKING, Any, NamedTuple

from graphic_tmm.checking.records import DOUBTFUL, FINE, VERDICTS, WRONG, Judged, PlanPicture
from graphic_tmm.checking.report.rows import WORDS, plan_name, printable_text, signed
from graphic_tmm.files import environment
from graphic_tmm.language.numbers import number
from graphic_tmm.paper.drawing import Bezier, Ink, line
from graphic_tmm.paper.lettering.letters import letter, svg_path
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.write.svg_path import path_data

if TYPE_CHECKING:
    from jinja2 import Environment
    from markupsafe import Markup


def render(template: str, **values: Any) -> Markup:
    """Return a template of the folder ``templates`` with values put in; it may be put into another as it is."""
    from markupsafe import Markup

    return Markup(_environment().get_template(template).render(values))


@cache
def _environment() -> Environment:
    """Return the templates of reports, with what they write figures and rows by."""
    made = environment("graphic_tmm.checking.report")
    made.filters |= {"mm": "{:.2f}".format, "zip": partial(zip, strict=True)}
    return made


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
        yield _x(start - 0.5, len(names)), middle, printable_text(names[start], 8)


def _marks(
    verdict: str, readings: Sequence[Judged], limit: float, language: str
) -> Iterator[tuple[float, float, str, str]]:
    """Yield the readings of one verdict: where each stands, the arrow of one beyond the axis, what it is."""
    for k, one in enumerate(readings):
        if one.verdict == verdict:
            percent = math.copysign(one.percent, one.deviation)
            beyond = abs(percent) > limit * (1 + 1e-9)
            arrow = ARROWS[1 if percent > 0 else -1] if beyond else ""
            yield _x(k, len(readings)), _y(percent, limit), arrow, _label(one, percent, language)


def _label(one: Judged, percent: float, language: str) -> str:
    where = " ".join(
        filter(None, (printable_text(one.taken.position), printable_text(one.taken.segment)))
    )
    return f"{where}: {signed(percent, 1, language)} %, {WORDS[language][one.verdict]}"


def _place(one: Judged) -> str:
    """Return what stands under a reading: its position, or its name where it is of no position."""
    return one.taken.position or one.taken.segment


def _x(place: float, count: int) -> float:
    return LEFT + (place + 0.5) * (RIGHT - LEFT) / count


def _y(percent: float, limit: float) -> float:
    share = min(max(percent / limit, -1.0), 1.0)
    return (TOP + BOTTOM) / 2 - share * (BOTTOM - TOP) / 2


PLAN_WIDTH, PLAN_HEIGHT = 90.0, 64.0
"""The picture is at most so wide and high, mm: half of a page between its margins, two lessons on a page."""
TOUCHING = 0.3
"""Letters whose boxes meet by more mm stand on each other."""
EDGE = 3.0
"""White about the plan, mm: a cross on its edge is whole."""
BEYOND = 0.5
"""What was found is shown as far as this share of the plan beyond it; what is farther runs out of the picture.
Chosen by eye."""
FAR = 5.0
"""What was found farther than so many times the plan's size is drawn as far, in its direction."""
LEAST_LETTER, LARGEST = 2.5, 3.5
"""Letters are as large as on the sheet, made smaller with the plan, but between these, mm (ГОСТ 2.304)."""
CROSS = 1.3
"""Half of the cross at the point that was found, mm."""
LEFT_OUT = frozenset({"guide", "hatching"})
"""Hatching is too fine for so small a picture."""


class _Page(NamedTuple):
    """How the plan stands in the picture: its left and lower edge, mm of the plan; how many times as large."""

    left: float
    low: float
    times: float
    height: float

    def at(self, z: complex) -> complex:
        """Return where a point of the plan stands, mm from the lower left corner, y upward."""
        return complex(EDGE, EDGE) + self.times * (z - complex(self.left, self.low))

    def scaled(self, one: Ink) -> Ink:
        """Return ink of the plan as it stands in the picture."""
        if isinstance(one, Bezier):
            return one._replace(controls=tuple(map(self.at, one.controls)))
        moved = ((self.at(complex(x, y)), bulge) for x, y, bulge in one.path)
        return one._replace(path=tuple((z.real, z.imag, bulge) for z, bulge in moved))


class Letter(NamedTuple):
    """A letter with its index: the data of its strokes, the width of the pen, the box of its ink."""

    data: str
    pen: str
    box: tuple[float, float, float, float]


def small_plan(picture: PlanPicture, label: str) -> Markup:
    """Return a plan as an SVG element: the plan grey, what is due green, what was found, or a mistake, red."""
    picture = _near(picture)
    left, low, right, top = _box(picture)
    room = (PLAN_WIDTH - 2 * EDGE) / (right - left), (PLAN_HEIGHT - 2 * EDGE) / (top - low)
    times = min(1.0, *room)
    width, height = ((b - a) * times + 2 * EDGE for a, b in ((left, right), (low, top)))
    page = _Page(left, low, times, height)
    ink = [one for one in picture.drawing.strokes if one.part not in LEFT_OUT]
    of = set(picture.of) if len(picture.due) < 2 else set()  # else the due segment is drawn itself
    meant = [not one.part and bool(set(one.of) & of) for one in ink]
    amiss = [one for one in picture.mistaken or () if one.part not in LEFT_OUT]
    letters = apart(list(_letters(page, picture)), picture)
    edges = [(0.0, 0.0, width, height), *(one.box for one in letters)]
    x, y = (min(edge[k] for edge in edges) for k in (0, 1))
    size = tuple(max(edge[k + 2] for edge in edges) - (x, y)[k] for k in (0, 1))
    return render(
        "plan.svg",
        label=printable_text(label),
        box=[f"{value:.2f}" for value in (x, y, *size)],
        due=COLOURS[FINE],
        found=COLOURS[WRONG],
        ink=_drawn(page, [one for one, its in zip(ink, meant, strict=True) if not its]),
        meant=_drawn(page, [one for one, its in zip(ink, meant, strict=True) if its]),
        amiss=_drawn(page, amiss),
        letters=letters,
        due_line=_line(page, picture.due),
        found_line=_line(page, picture.found),
        due_mark=_disc(page, picture.due),
        found_mark=_cross(page, picture.found),
    )


def _near(picture: PlanPicture) -> PlanPicture:
    """Return the picture with what was found so near that it can be drawn; what is no number is left out."""
    found = picture.found
    if not all(map(cmath.isfinite, (*found, *picture.due))):
        return picture._replace(due=(), found=())
    left, low, right, top = bounds(picture.drawing)
    most = FAR * max(right - left, top - low)
    start = found[0] if len(found) > 1 else complex(left + right, low + top) / 2
    near = (start + (z - start) * min(1.0, most / max(abs(z - start), most)) for z in found)
    return picture._replace(found=tuple(near))


def _box(picture: PlanPicture) -> tuple[float, float, float, float]:
    """Return what the picture shows of the plan's plane, mm: the plan, and what was found if it is not far."""
    left, low, right, top = bounds(picture.drawing)
    far = BEYOND * max(right - left, top - low)
    amiss = (one for one in picture.mistaken or () if one.part not in LEFT_OUT)
    spots = [z for one in amiss for z in _spots(one)]
    for z in (*picture.due, *picture.found, *spots):
        left, right = max(min(left, z.real), left - far), min(max(right, z.real), right + far)
        low, top = max(min(low, z.imag), low - far), min(max(top, z.imag), top + far)
    return left, low, max(right, left + 1.0), max(top, low + 1.0)


def _spots(one: Ink) -> Iterator[complex]:
    """Yield the points of a line, or of a curve its control points, mm."""
    if isinstance(one, Bezier):
        yield from one.controls
    else:
        yield from (complex(x, y) for x, y, _ in one.path)


def _drawn(page: _Page, ink: Iterable[Ink]) -> tuple[str, str]:
    """Return the data of the paths of lines, and of filled shapes (arrows)."""
    lines, filled = "", ""
    for one in map(page.scaled, ink):
        data = path_data(one, page.height)
        if not isinstance(one, Bezier) and one.filled:
            filled += data
        else:
            lines += data
    return lines, filled


def _letters(page: _Page, picture: PlanPicture) -> Iterator[Letter]:
    """Yield the letters: each stands to its point as it does on the sheet, by its own size."""
    labels = picture.drawing.labels
    for one, named in zip(labels, picture.named or [one.at for one in labels], strict=True):
        size = min(max(one.size * page.times, LEAST_LETTER), LARGEST)
        put = letter(one.text, size=size, inclined=one.inclined)
        at = page.at(named) + (one.at - named) * size / one.size
        x = at.real - {"start": 0.0, "middle": 0.5, "end": 1.0}[one.anchor] * put.width
        y = page.height - at.imag
        left, low, right, top = put.ink
        yield Letter(
            svg_path(put, x, y), f"{size / 10:.2f}", (x + left, y - top, x + right, y - low)
        )


def apart(letters: Sequence[Letter], picture: PlanPicture) -> list[Letter]:
    """Return letters without those that would stand on others, those nearest to what is shown first."""
    ends = picture.due or picture.found
    named = picture.named or [one.at for one in picture.drawing.labels]
    here = sum(ends) / len(ends) if ends else 0j
    order = sorted(range(len(letters)), key=lambda k: abs(named[k] - here) if ends else k)
    kept: list[Letter] = []
    for one in (letters[k] for k in order):
        if not any(_meet(one.box, other.box) for other in kept):
            kept.append(one)
    return kept


def _meet(one: Sequence[float], other: Sequence[float]) -> bool:
    """Whether two boxes (left, top, right, low, mm) meet by more than what letters may touch."""
    return all(min(one[k + 2], other[k + 2]) - max(one[k], other[k]) > TOUCHING for k in (0, 1))


def _line(page: _Page, ends: Sequence[complex]) -> str:
    return _path(page, *ends) if len(ends) == 2 else ""


def _disc(page: _Page, ends: Sequence[complex]) -> tuple[str, str] | None:
    """Return the middle of the circle about the due point; None if there is none."""
    if not ends:
        return None
    at = page.at(ends[-1])
    return f"{at.real:.2f}", f"{page.height - at.imag:.2f}"


def _cross(page: _Page, ends: Sequence[complex]) -> str:
    if not ends:
        return ""
    at, ways = ends[-1], (CROSS * (1 + 1j) / page.times, CROSS * (1 - 1j) / page.times)
    return "".join(_path(page, at - way, at + way) for way in ways)


def _path(page: _Page, start: complex, end: complex) -> str:
    return path_data(page.scaled(line("thin", start, end)), page.height)
