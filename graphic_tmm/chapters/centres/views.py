"""What a sheet shows of instantaneous centres: their scheme by positions, the polygon of links, tables."""

from __future__ import annotations

from collections.abc import Sequence

from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import Scale
from graphic_tmm.chapters.centres.ink import draw_scheme
from graphic_tmm.chapters.centres.ink_polygon import draw_polygon
from graphic_tmm.chapters.centres.network import LINES, PARALLEL, Centre
from graphic_tmm.chapters.centres.plan import CENTRES_PLAN, Centres, PointSpeed, Rotation
from graphic_tmm.chapters.centres.task import CENTRES
from graphic_tmm.chapters.centres.words import WAYS
from graphic_tmm.chapters.kinematics.plan import KINEMATICS_PLAN
from graphic_tmm.chapters.kinematics.scales import reaches
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
from graphic_tmm.paper.views import mu_text
from graphic_tmm.readers.columns import Readings
from graphic_tmm.scene.captions import captions

NONE = "—"


def centre_views(drawn: Drawn, lettered: bool) -> list[Drawing]:
    """Return the scheme of each position, the polygon of links, tables; none where a scene asks for none."""
    made = CENTRES_PLAN.of(drawn)
    if made is None:
        return []
    words = captions(drawn.scene.language)
    places = [k for k in made.places if k not in drawn.undrawn]
    found = list[Drawing]()
    for place in places:
        name = drawn.names[place]
        title = f"{words[CENTRES]}, {words['position']} {escape(name)}"
        on = subject(drawn, title, CENTRES, name=f"{CENTRES}-{name}")
        view = scheme(drawn, made, on.title, place)
        found.append(with_caption(view, on, lettered, scale_text(drawn, made)))
    on = subject(drawn, words["centres polygon"], CENTRES, name="centres-polygon")
    found.append(with_caption(draw_polygon(on, made), on, lettered))
    return [*found, where(drawn, made, places), *(rates(drawn, made, k) for k in places)]


def scale_text(drawn: Drawn, made: Centres) -> str:
    """Return the scale factor of the scheme."""
    return mu_text(Scale(made.mu.name, drawn.value(made.mu), made.mu.unit), drawn.scene.language)


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
    many = len(places) > 1
    heads = [
        f"{axis}{f'({escape(drawn.names[k])})' if many else ''}, {mm}"
        for k in places
        for axis in "xy"
    ]
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
    value = drawn.reading[one.mark][0]
    at = complex(value[place if value.size > 1 else 0])
    if at != at:
        return NONE, NONE
    language = drawn.scene.language
    return fixed(at.real, 1, language), fixed(at.imag, 1, language)


def lines_of(made: Centres, one: Centre, language: str) -> str:
    """Return by what a centre was found: its two lines, or a word."""
    if one.way not in (LINES, PARALLEL):
        return speaking(language)(WAYS[one.way])
    names = {c.links: c.name for c in made.centres}
    i, j = one.links

    def name(first: int, second: int) -> str:
        return names.get((first, second)) or names[second, first]

    return " × ".join(f"{name(i, k)} {name(k, j)}" for k in one.over)


def rates(drawn: Drawn, made: Centres, place: int) -> Drawing:
    """Return the table of ω and v in a position, by the centres and by the plan of velocities."""
    words = captions(drawn.scene.language)
    rows = [row for one in made.rotations for row in _turning(drawn, made, one, place)]
    rows += [row for one in made.speeds for row in _moving(drawn, one, place)]
    title = f"{words['centres rates']}, {words['position']} {escape(drawn.names[place])}"
    high = heights(drawn.scene, CENTRES)
    return ruled_table(
        f"table-centres-{drawn.names[place]}", title,
        [words["value"], "mm", words["by centres"], words["by plan"], words["unit"]], rows,
        size=high.number, title_size=high.title, align=["left", *["centre"] * 3, "left"],
    )  # fmt: skip


def _figure(drawn: Drawn, mark: Mark | None, place: int, times: float = 1.0) -> float:
    if mark is None:
        return float("nan")
    row = drawn.reading.figure(mark)[0]
    return float(row[place if row.size > 1 else 0]) * times


def _rounded(value: float, places: int, language: str) -> str:
    return fixed(value, places, language) if value == value else NONE


def _turning(drawn: Drawn, made: Centres, one: Rotation, place: int) -> list[list[str]]:
    language, units = drawn.scene.language, unit("1/s", drawn.scene.language)
    plan = _figure(drawn, one.plan, place)
    if one.still:
        return [[f"ω_{{{one.link}}}", NONE, "0", "0", units]]
    lengths = " : ".join(_rounded(_figure(drawn, k, place), 1, language) for k in one.ends) or NONE
    rows = []
    if one.ratio is not None:
        ratio = _rounded(_figure(drawn, one.ratio, place), 4, language)
        rows.append([f"u_{{{one.link}{made.driver}}}", lengths, ratio, NONE, NONE])
        lengths = NONE
    times = float(KINEMATICS_PLAN.on(drawn).sense) if one.alike else 1.0
    plan = abs(plan) if one.by_point else plan
    figures = [_figure(drawn, one.omega, place, times), plan]
    told = [_rounded(value, 4, language) for value in figures]
    return [*rows, [f"ω_{{{one.link}}}", lengths, *told, units]]


def _moving(drawn: Drawn, one: PointSpeed, place: int) -> list[list[str]]:
    language = drawn.scene.language
    mu = KINEMATICS_PLAN.on(drawn).velocities
    assert mu is not None
    plan = abs(_figure(drawn, one.plan, place, drawn.value(mu.mu)))
    told = [_rounded(v, 4, language) for v in (_figure(drawn, one.value, place), plan)]
    length = _rounded(_figure(drawn, one.distance, place), 1, language)
    return [[f"v_{{{escape(one.letter)}}}", length, *told, unit("m/s", language)]]


def plan_at(
    drawn: Drawn, plan: str, place: int, name: str, title: str, upon: Sequence[Stroke]
) -> Drawing:
    """Return the scheme in a position, whose letters keep off what is drawn ``upon`` it."""
    view = scheme(drawn, CENTRES_PLAN.on(drawn), title, place)
    return finished(view._replace(name=name, strokes=(*view.strokes, *upon)))


SHOWN = Views(draw={CENTRES: centre_views})
READINGS = Readings(pointed=(CENTRES,), plan_at=plan_at)
