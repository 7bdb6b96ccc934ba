"""What a short template tells those who fill it in: what to measure, the scale factors, the axes of x and y."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence

from graphic_tmm.checking.cells import Cell, Key, pointed
from graphic_tmm.checking.judging.taken_marks import steps_of
from graphic_tmm.checking.records import Taken
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import Said, joined, said
from graphic_tmm.language.symbols import plain
from graphic_tmm.language.units import unit
from graphic_tmm.readers.table import scene_columns
from graphic_tmm.readers.text import column_name
from graphic_tmm.scene.captions import captions

_DIGITS = 4
"""So many digits of a scale factor are told."""


def explained(made: DrawnScene, rows: Sequence[Taken], due: Mapping[Key, Cell]) -> Iterator[str]:
    """Yield what is to be filled in, the scale factors, what is calculated, from where points are counted."""
    words = captions(made.scene.language)
    yield said("Readings of a drawing: {title}", title=made.scene.title)
    if any(not row.unit for row in rows):
        yield said("Measure on the plan and fill in the column mm; leave the other cells empty.")
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
