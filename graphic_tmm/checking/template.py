"""Files of readings to be filled in: all that can be measured, or the main segments of one position.

Main is what is measured on the paper, or what a teacher marks; a picture of the plans shows its letters.
"""

from __future__ import annotations

from collections import Counter
from collections.abc import Iterable, Iterator, Mapping, Sequence
from pathlib import Path
from typing import NamedTuple

from graphic_tmm.checking.cells import RESULTS, Cell, Key, cells, pointed, points, position_names
from graphic_tmm.checking.congruence.congruence import Congruence
from graphic_tmm.checking.judging.taken_marks import steps_of
from graphic_tmm.checking.pictures import plan_view
from graphic_tmm.checking.readings.mending import Names, names_of
from graphic_tmm.checking.readings.names import Meant, plan_meant, segment_meant
from graphic_tmm.checking.readings.position_names import position_meant
from graphic_tmm.checking.readings.writing import empty_rows, file_of, result_columns
from graphic_tmm.checking.records import Taken
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import SheetError, printable
from graphic_tmm.fitting.composition import Composition
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import Said, joined, said
from graphic_tmm.language.symbols import plain
from graphic_tmm.language.units import unit
from graphic_tmm.paper.drawing import Drawing, Sheet
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.views import captioned
from graphic_tmm.readers.table import scene_columns, scene_results
from graphic_tmm.readers.text import column_name
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.records import Scene
from graphic_tmm.studio import make

_DIGITS = 4
"""So many digits of a scale factor are told."""


def explained(made: DrawnScene, rows: Sequence[Taken], due: Mapping[Key, Cell]) -> Iterator[str]:
    """Yield what is to be filled in, the scale factors, what is calculated, from where points are counted."""
    words = captions(made.scene.language)
    yield said("Readings of a drawing: {title}", title=made.scene.title)
    if any(not row.unit for row in rows):
        yield said("Measure on the plan and fill in the column mm; leave the other cells empty.")
    yield said("If you draw in a scale factor of your own, write it into the row of μ of its plan.")
    if any(row.unit for row in rows):
        yield said("Where a unit stands fill in the value that you have calculated.")
    for plan, place in dict.fromkeys((row.plan, row.position) for row in rows):
        at = said(", position {position}", position=place) if place else ""
        yield said(
            "{called} ({plan}{at}): {scales}",
            called=plain(words.get(plan, plan)),
            plan=plan,
            at=at,
            scales=_scales(made, plan, rows, due),
        )
        if laid := _calculated(made, plan, place, rows, due):
            yield said("Calculated there, not measured: {segments}", segments=laid)
    yield from _counted(made, rows)


def _scales(made: DrawnScene, plan: str, rows: Sequence[Taken], due: Mapping[Key, Cell]) -> Said:
    """Return what a millimetre of a plan stands for; segment by segment if that differs."""
    language, asked = made.scene.language, {row.segment for row in rows if row.plan == plan}
    found: dict[tuple[float, str], dict[str, None]] = {}
    for (p, segment, _), cell in due.items():
        if p == plan and segment in asked and cell.mm and cell.value:
            mu = float(f"{abs(cell.value / cell.mm):.{_DIGITS}g}")
            found.setdefault((mu, cell.unit), {})[segment] = None
    told = [
        said(
            "μ: 1 mm stands for {mu} {unit}{segments}",
            mu=number(mu, language, _DIGITS),
            unit=unit(of, language),
            segments="" if len(found) == 1 else f" ({', '.join(segments)})",
        )
        for (mu, of), segments in found.items()
    ]
    return joined("; ", told) if told else said("no scale factor")


def _calculated(
    made: DrawnScene, plan: str, place: str, rows: Sequence[Taken], due: Mapping[Key, Cell]
) -> str:
    """Return the segments and rates of a plan that are not asked for because they are calculated."""
    asked = {row.segment for row in rows if row.plan == plan}
    steps, language = steps_of(made.mechanism), made.scene.language
    found = []
    for column in scene_columns(made):
        name, step = column.segment, steps.get((plan, column.segment))
        if column.plan != plan or name in asked or (plan, name, place) not in due:
            continue
        if step is not None and not step.op.reads:
            shown = plain(column_name(column, language))
            found.append(name if shown == name else f"{name} ({shown})")
    return ", ".join(found)


def _counted(made: DrawnScene, rows: Sequence[Taken]) -> Iterator[Said]:
    """Yield from where x and y are counted."""
    work, plans = made.mechanism, dict.fromkeys(row.plan for row in rows if row.plan in pointed())
    views = [(plan, work.construction.view(plan)) for plan in plans] if work is not None else []
    poles = [f"{plan}: {view.pole.name}" for plan, view in views if view and view.pole]
    if poles:
        yield said(
            "A point may be read instead of a segment: its letter in the column of segments, x and y in mm "
            "from the pole of its plan ({poles}), x to the right and y up as the plan stands on the sheet. "
            "A row for the pole itself tells where it is if the origin is elsewhere.",
            poles=", ".join(poles),
        )


GAP = 12.0
"""Between plans, and about them, mm: the letters at their rims stand clear. Chosen by eye."""
APART = 10.0
"""Points so far apart, mm, have room for their letters."""
FORMAT = "A4"
"""The format whose pens and letters the picture has."""


def letters_sheet(made: DrawnScene, places: Mapping[str, str]) -> Sheet | None:
    """Return the plans side by side, each in one position; None where no plan has letters.

    ``places``: the position that is asked for, by plan.
    """
    language = made.scene.language
    words, there = captions(language), points(made)
    views = []
    for plan, place in places.items():
        clear: dict[str, float] = {}
        for name in dict.fromkeys(name for p, _, name in there if p == plan):
            clear[name] = _clear(
                [0j, *(z for (p, _, n), z in there.items() if (p, n) == (plan, name))]
            )
        if plan not in pointed() or not clear:
            continue
        name = max(clear, key=lambda name: (name != place, clear[name]))
        title = f"{words.get(plan, plan)}, {words['position']} {escape(name)}"
        views.append(captioned(plan_view(made, plan, name, (), title), title))
    return _side_by_side(views, made.scene.title, language) if views else None


def _clear(spots: Sequence[complex]) -> float:
    """Return how clear of one another points stand: their distances to the nearest, `APART` at most, mm."""
    far = [
        min((abs(one - two) for j, two in enumerate(spots) if j != k), default=0.0)
        for k, one in enumerate(spots)
    ]
    return sum(min(one, APART) for one in far)


def _side_by_side(views: list[Drawing], title: str, language: str) -> Sheet:
    """Return a paper as large as views side by side are."""
    moved, right, high = [], GAP, 0.0
    for view in views:
        left, low, end, top = bounds(view)
        moved.append(view.moved(complex(right - left, GAP - low)))
        right += end - left + GAP
        high = max(high, top - low)
    return Sheet("letters", title, FORMAT, right, high + 2.0 * GAP, tuple(moved), language)


SEEN = 2.0
"""A shorter segment is no good task for a ruler of half millimetres, mm: its reading is a quarter off."""


class Short(NamedTuple):
    """What a short template asks for: its rows, what explains them, the position of each of its plans."""

    rows: tuple[Taken, ...]
    told: tuple[str, ...]
    places: Mapping[str, str]


def short(made: DrawnScene, only: Sequence[str] = (), position: str = "") -> Short:
    """Return a short template of a scene.

    Parameters
    ----------
    only : sequence of str
        What is asked for, each "plan" or "plan:segment,segment", as people spell it; points by their letters.
        Empty: what is measured on the plans of the mechanism, or else whatever is drawn.
    position : str
        Of what; "": that at which the most plans are drawn, and the most segments that can be seen.

    Raises
    ------
    SheetError
        If the scene does not have what is asked for.
    """
    due, spots = cells(made), points(made)
    names = names_of(made, due, spots)
    place = _position(position, due, names)
    wanted = [_marked(one, names) for one in only] or _main(made, due)
    rows: dict[Key, Taken] = {}
    for plan, segments in wanted:
        for segment in segments:
            for key in _there(plan, segment, place, due, spots, bool(position)):
                rows.setdefault(key, _row(key, due))
    if not rows:
        says = said("nothing that is asked for is drawn at position {position}", position=place)
        raise SheetError(says)
    places = {row.plan: row.position for row in rows.values()}
    speech = speaking(made.scene.language)
    told = tuple(map(speech, explained(made, list(rows.values()), due)))
    return Short(tuple(rows.values()), told, places)


def _position(typed: str, due: Mapping[Key, Cell], names: Names) -> str:
    """Return the position that is meant, or at which most plans, and most segments of them, are drawn."""
    there: dict[str, set[str]] = {}
    long: Counter[str] = Counter()
    for (plan, _, name), cell in due.items():
        there.setdefault(name, set()).add(plan)
        long[name] += abs(cell.mm or 0.0) > SEEN
    there.pop("", None)
    if typed:
        found = position_meant(typed, tuple(there))
        if not found.only:
            raise SheetError(_unknown("--position", typed, found, there))
        return found.only
    plans = set(pointed()) & names.segments.keys()
    return max(there, key=lambda name: (len(there[name] & plans), long[name]), default="")


def _marked(typed: str, names: Names) -> tuple[str, tuple[str, ...]]:
    """Return the plan and the segments, or points, that somebody has marked."""
    plan_typed, sign, rest = typed.partition(":")
    plan = plan_meant(plan_typed.strip(), names.plans)
    if not plan.only:
        raise SheetError(_unknown("--only", plan_typed, plan, names.plans))
    known = {**names.points.get(plan.only, {}), **names.segments.get(plan.only, {})}
    if not sign:
        return plan.only, tuple(names.segments.get(plan.only, {})) or tuple(known)
    found = []
    for one in filter(None, (part.strip() for part in rest.split(","))):
        segment = segment_meant(one, plan.only, known)
        if not segment.only:
            raise SheetError(_unknown("--only", one, segment, known))
        found.append(segment.only)
    return plan.only, tuple(found)


def _unknown(option: str, typed: str, found: Meant, known: Iterable[str]) -> Said:
    listed = joined(", ", found.names or tuple(known))
    typed = printable(typed)[:30]
    return said(
        '{option}: what is "{typed}"? There are {known}', option=option, typed=typed, known=listed
    )


def _main(made: DrawnScene, due: Mapping[Key, Cell]) -> list[tuple[str, tuple[str, ...]]]:
    """Return what is measured on the plans of the mechanism; of a scene without, all that is drawn."""
    steps = steps_of(made.mechanism)
    measured: dict[str, dict[str, None]] = {}
    drawn: dict[str, dict[str, None]] = {}
    for (plan, segment, _), cell in due.items():
        if cell.mm is None:
            continue
        drawn.setdefault(plan, {})[segment] = None
        step = steps.get((plan, segment))
        if plan in pointed() and step is not None and step.op.reads:
            measured.setdefault(plan, {})[segment] = None
    found = measured or drawn
    return [(plan, tuple(segments)) for plan, segments in found.items()]


def _there(
    plan: str,
    segment: str,
    place: str,
    due: Mapping[Key, Cell],
    spots: Mapping[Key, complex],
    strict: bool,
) -> Iterator[Key]:
    """Yield the figure of a segment, or the point, at a position; of a plan with others at its first."""
    own = [name for p, s, name in (*due, *spots) if (p, s) == (plan, segment)]
    if place in own:
        yield plan, segment, place
    elif own and (plan == RESULTS or not strict) and plan not in pointed():
        yield plan, segment, own[0]


def _row(key: Key, due: Mapping[Key, Cell]) -> Taken:
    plan, segment, position = key
    cell = due.get(key)
    calculated = cell is not None and cell.mm is None
    return Taken(plan, position, segment, unit=(cell.unit or "1") if cell and calculated else "")


def template_of(scene: Scene, name: str = "template.csv") -> str | bytes:
    """Return the file of all that can be measured of a scene, to be filled in.

    ``name``: of the file; a workbook for ``.xlsx``, else CSV.
    """
    return file_of(name, rows_of(scene), language=scene.language)


def short_of(
    scene: Scene,
    name: str = "template.csv",
    only: Sequence[str] = (),
    position: str = "",
    *,
    pictured: bool = True,
    given: Composition | None = None,
) -> dict[str, str | bytes]:
    """Return the file of the main segments of one position, or of what is marked, and a picture of the letters.

    ``only``, ``position``: as `short` has them; ``name``: as `template_of`; ``pictured``: whether there is
    a picture; ``given``: the composition of the sheets, as for `make`. Files by name; the picture has the name
    of the first.

    Raises
    ------
    SheetError
        If the scene does not have what is asked for.
    """
    from graphic_tmm.paper.write.svg import svg

    made = make(scene, exact=True, given=given)
    asked_for = short(made, only, position)
    told, picture = asked_for.told, letters_sheet(made, asked_for.places) if pictured else None
    beside = f"{Path(name).stem}.svg"
    if picture is not None:
        shows = said("The letters of the plans are shown in {file}.", file=beside)
        told = (*told, speaking(scene.language)(shows))
    rows = _with_scales(made, asked_for.rows)
    files = {name: file_of(name, rows, language=scene.language, told=told)}
    return files if picture is None else {**files, beside: svg(picture)}


def rows_of(scene: Scene) -> list[Taken]:
    """Return a row for all that can be measured of a scene, its figures empty."""
    made = make(scene, exact=True)
    columns = [*scene_columns(made), *result_columns(scene_results(made))]
    letters = dict.fromkeys((plan, letter) for plan, letter, _ in points(made))
    return _with_scales(made, empty_rows(columns, position_names(made), tuple(letters)))


def _with_scales(made: DrawnScene, rows: Iterable[Taken]) -> list[Taken]:
    """Return rows, those of each plan behind its scale factors: a student writes his own there."""
    scales: dict[str, list[Taken]] = {}
    for one in Congruence(made).stated_rows():
        scales.setdefault(one.plan, []).append(one)
    found: list[Taken] = []
    for row in rows:
        found += scales.pop(row.plan, [])
        found.append(row)
    return found
