"""What a sheet shows of instantaneous centres: their scheme by positions, the polygon of links, tables."""

from __future__ import annotations

from collections.abc import Sequence
from itertools import combinations

from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale
from graphic_tmm.chapters.centres.ink import draw_scheme
from graphic_tmm.chapters.centres.ink_polygon import draw_polygon
from graphic_tmm.chapters.centres.network import LINES, PARALLEL, Centre
from graphic_tmm.chapters.centres.record import CENTRES_PLAN, Centres, PointSpeed, Rotation
from graphic_tmm.chapters.centres.task import CENTRES
from graphic_tmm.chapters.centres.words import WAYS
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.scales import reaches
from graphic_tmm.chapters.kinematics.task import VELOCITIES
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.subjects import subject, with_caption
from graphic_tmm.fitting.views import Views
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import fixed
from graphic_tmm.language.units import unit
from graphic_tmm.paper.drawing import Drawing, Stroke
from graphic_tmm.paper.formats import heights
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.ruled import ruled_table
from graphic_tmm.paper.traced import value_at
from graphic_tmm.paper.views import mu_text
from graphic_tmm.project import Project
from graphic_tmm.readers.columns import Crossed, Readings
from graphic_tmm.scene.captions import captions

NONE = "—"


def centre_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the scheme of each position, the polygon of links, tables; none where a scene asks for none."""
    made = CENTRES_PLAN.of(drawn)
    if made is None:
        return []
    words = captions(drawn.scene.language)
    places = [k for k in made.places if k not in drawn.undrawn]
    found, scale = list[Drawing](), Scale(made.mu.name, drawn.value(made.mu), made.mu.unit)
    for place in places:
        title = f"{words[CENTRES]}, {words['position']} {escape(drawn.names[place])}"
        on, view = subject(drawn, title, CENTRES), scheme(drawn, made, title, place)
        found.append(with_caption(view, on, lettered, mu_text(scale, on.language)))
    on = subject(drawn, words["centres polygon"], CENTRES, name="centres-polygon")
    found.append(with_caption(draw_polygon(on, made), on, lettered))
    return [*found, where(drawn, made, places), *(rates(drawn, made, k) for k in places)]


def scheme(drawn: Drawn, made: Centres, title: str, place: int) -> Drawing:
    """Return the scheme of centres in a position, its letters still wanted."""
    on = subject(drawn, title, CENTRES, name=f"{CENTRES}-{drawn.names[place]}")
    times = drawn.value(KINEMATICS_PLAN.on(drawn).mu_l) / drawn.value(made.mu)
    return draw_scheme(on, made, reaches(drawn), place, times)


def where(drawn: Drawn, made: Centres, places: Sequence[int]) -> Drawing:
    """Return the table of centres: number, name, by which lines, where in each position, mm."""
    language, words, rows = drawn.scene.language, captions(drawn.scene.language), []
    mm = unit("mm", language)
    for n, one in enumerate(made.centres, 1):
        cells = [cell for k in places for cell in _spot(drawn, one, k)]
        rows.append([str(n), one.name, lines_of(made, one, language), *cells])
    names = [f"({escape(drawn.names[k])})" if len(places) > 1 else "" for k in places]
    heads = [f"{axis}{name}, {mm}" for name in names for axis in "xy"]
    high = heights(drawn.scene, CENTRES)
    align = ["centre", "left", "left", *["number"] * len(heads)]
    return ruled_table(
        "table-centres", words["centres found"],
        ["N", words["centre"], words["centre of lines"], *heads], rows,
        size=high.number, title_size=high.title, align=align,
    )  # fmt: skip


def _spot(drawn: Drawn, one: Centre, place: int) -> tuple[str, str]:
    if one.far:
        return "∞", "∞"
    at = value_at(drawn.reading[one.mark], place)
    return _cell(at.real, 1, drawn), _cell(at.imag, 1, drawn)


def _cell(value: float, places: int, drawn: Drawn) -> str:
    return fixed(value, places, drawn.scene.language) if value == value else NONE


def lines_of(made: Centres, one: Centre, language: str) -> str:
    """Return by what a centre was found: its two lines, or a word."""
    if one.way not in (LINES, PARALLEL):
        return speaking(language)(WAYS[one.way])
    names = {frozenset(c.links): c.name for c in made.centres}
    i, j = one.links
    return " × ".join(f"{names[frozenset((i, k))]} {names[frozenset((k, j))]}" for k in one.over)


def rates(drawn: Drawn, made: Centres, place: int) -> Drawing:
    """Return the table of ω and v in a position, by the centres and by the plan of velocities."""
    words = captions(drawn.scene.language)
    mm = unit("mm", drawn.scene.language)
    rows = [row for one in made.rotations for row in _turning(drawn, made, one, place)]
    rows += [_moving(drawn, one, place) for one in made.speeds]
    title = f"{words['centres rates']}, {words['position']} {escape(drawn.names[place])}"
    heads = [words["value"], f"{words['distances']}, {mm}"]
    heads += [words[head] for head in ("by centres", "by plan", "unit")]
    high = heights(drawn.scene, CENTRES)
    return ruled_table(
        f"table-centres-{drawn.names[place]}", title,
        heads, rows,
        size=high.number, title_size=high.title, align=["left", *["centre"] * 3, "left"],
    )  # fmt: skip


def _figure(drawn: Drawn, mark: Mark | None, place: int) -> float:
    return float("nan") if mark is None else value_at(drawn.reading.figure(mark), place).real


def _turning(drawn: Drawn, made: Centres, one: Rotation, place: int) -> list[list[str]]:
    units, name = unit("1/s", drawn.scene.language), f"ω_{{{one.link}}}"
    if one.still:
        return [[name, NONE, "0", "0", units]]
    own, plan = (_figure(drawn, mark, place) for mark in (one.omega, one.plan))
    if one.alike:
        own *= KINEMATICS_PLAN.on(drawn).sense
    found = [_cell(own, 4, drawn), _cell(plan, 4, drawn), units]
    lengths = " : ".join(_cell(_figure(drawn, k, place), 1, drawn) for k in one.ends) or NONE
    if one.ratio is None:
        return [[name, lengths, *found]]
    ratio = _cell(_figure(drawn, one.ratio, place), 4, drawn)
    return [[f"u_{{{one.link}{made.driver}}}", lengths, ratio, NONE, NONE], [name, NONE, *found]]


def _moving(drawn: Drawn, one: PointSpeed, place: int) -> list[str]:
    plan = abs(_figure(drawn, one.plan, place)) * drawn.scales[VELOCITIES].value
    found = [_cell(v, 4, drawn) for v in (_figure(drawn, one.value, place), plan)]
    length = _cell(abs(_figure(drawn, one.distance, place)), 1, drawn)
    return [f"v_{{{escape(one.letter)}}}", length, *found, unit("m/s", drawn.scene.language)]


def plan_at(
    drawn: Drawn, plan: str, place: int, name: str, title: str, upon: Sequence[Stroke]
) -> Drawing:
    """Return the scheme in a position, whose letters keep off what is drawn ``upon`` it."""
    view = scheme(drawn, CENTRES_PLAN.on(drawn), title, place)
    return finished(view._replace(name=name, strokes=(*view.strokes, *upon)))


SHOWN = Views(draw={CENTRES: centre_views})


def figure_marks(project: Project) -> dict[tuple[str, str], Mark]:
    """Return the marks of ratios and velocities, by plan and the name that machines read."""
    made = CENTRES_PLAN.of(project)
    return {(CENTRES, name): mark for name, mark in (made.figures if made is not None else ())}


def crossings(project: Project) -> dict[Mark, tuple[Crossed, ...]]:
    """Return of each centre the pairs of Kennedy's lines that lead to it by centres that were there before."""
    made = CENTRES_PLAN.of(project)
    if made is None:
        return {}
    there, found = dict[frozenset[int], Centre](), dict[Mark, tuple[Crossed, ...]]()
    for one in made.centres:
        i, j = one.links
        lines = list[tuple[Mark, Mark]]()
        for k in made.links:
            ends = [there[pair] for pair in map(frozenset, ((i, k), (k, j))) if pair in there]
            ends.sort(key=lambda end: end.far)
            if len(ends) == 2 and not ends[0].far and ends[0].mark != ends[1].mark:
                lines.append((ends[0].mark, ends[1].mark))
        found[one.mark] = tuple(combinations(lines, 2))
        there[frozenset(one.links)] = one
    return found


READINGS = Readings(
    pointed=(CENTRES,), plan_at=plan_at, named_marks=figure_marks, crossings=crossings
)
