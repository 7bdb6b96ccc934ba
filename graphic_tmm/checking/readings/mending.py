"""Readings by the names of their scene: what was typed otherwise is mended; poles and rows that stand twice."""

from __future__ import annotations

from collections.abc import Callable, Container, Iterable, Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import NamedTuple

from graphic_tmm.checking.cells import Cell, Key, pointed
from graphic_tmm.checking.readings.filling import listed
from graphic_tmm.checking.readings.layouts import UNNAMED
from graphic_tmm.checking.readings.letters import Letters, in_letters
from graphic_tmm.checking.readings.names import (
    SILENT,
    Aliases,
    Meant,
    meant,
    plan_meant,
    segment_meant,
    segments_of,
)
from graphic_tmm.checking.readings.position_names import position_meant
from graphic_tmm.checking.readings.writing import result_columns
from graphic_tmm.checking.records import Taken
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import Fault
from graphic_tmm.language.catalogue import Speech, speaking
from graphic_tmm.language.said import Said, joined, said
from graphic_tmm.readers.table import positions_of, scene_columns, scene_results
from graphic_tmm.scene.captions import view_name

LISTED = 4
"""So many lines are named where a note is of many."""
NEAR = 1.0
"""A pole that was read nearer to the origin than this is the origin, mm: a coordinate read off paper scatters
by 0.75 mm, and a shift by that would be put into all points of the plan."""


def from_poles(
    parts: Iterable[Taken],
    poles: Mapping[str, str],
    points: Mapping[str, Container[str]],
    speech: Speech,
) -> tuple[tuple[Taken, ...], tuple[str, ...]]:
    """Return readings without rows of poles, points counted from where these stand; a word on each shift.

    A row without position is of its plan in all positions.

    Parameters
    ----------
    parts : iterable of Taken
        By the names of their scene, each of one kind of figure.
    poles, points : mapping
        By plan the letter of its pole, and those of its points, of which readings may be.
    """
    kept: list[Taken] = []
    found: dict[tuple[str, str], Taken] = {}
    for part in parts:
        of_pole = poles.get(part.plan) == part.segment
        if not of_pole or part.segment in points.get(part.plan, ()):
            kept.append(part)
        elif part.pointed:
            found[part.plan, part.position] = part
        elif part.mm != 0.0:
            kept.append(part)
    far = {at: one for at, one in found.items() if abs(one.spot) > NEAR}
    shifted = tuple(_shifted(one, far) for one in kept)
    return shifted, tuple(_pole_texts(tuple(far.values()), speech))


def _shifted(part: Taken, poles: Mapping[tuple[str, str], Taken]) -> Taken:
    pole = poles.get((part.plan, part.position), poles.get((part.plan, "")))
    if pole is None or not part.pointed:
        return part
    spot = part.spot - pole.spot
    return part._replace(x=spot.real, y=spot.imag)


def _pole_texts(poles: Sequence[Taken], speech: Speech) -> Iterator[str]:
    """Yield a note on the poles of each plan that do not stand at 0: on many of them one note."""
    for plan in dict.fromkeys(one.plan for one in poles):
        its = [one for one in poles if one.plan == plan]
        if len(its) == 1:
            yield _pole_text(its[0], speech)
            continue
        some = ", ".join(str(one.line) for one in its[:LISTED])
        yield speech(
            said(
                "{plan}: {count} poles {pole} do not stand at 0 (lines {lines}); the points of each plan are "
                "counted from its own",
                plan=view_name(plan, speech.language),
                count=len(its),
                pole=its[0].segment,
                lines=f"{some}, …" if len(its) > LISTED else some,
            )
        )


def _pole_text(pole: Taken, speech: Speech) -> str:
    place = said(", position {position}", position=pole.position) if pole.position else ""
    return speech(
        said(
            "line {line}: the pole {pole} stands at x = {x:g}, y = {y:g}; the points of its plan are "
            "counted from there ({plan}{at})",
            line=pole.line,
            pole=pole.segment,
            x=pole.x,
            y=pole.y,
            plan=view_name(pole.plan, speech.language),
            at=place,
        )
    )


_KINDS = tuple((name, Taken._fields.index(name)) for name in ("mm", "value", "x"))


def twice(taken: Sequence[Taken], title: Callable[[str], str] = str) -> Iterator[Fault]:
    """Yield a fault for each reading that an earlier row has given already.

    ``title``: what the file calls a column.
    """
    seen: dict[tuple[str, str, str, str], int] = {}
    for one in taken:
        for name, field in _KINDS:
            if one[field] is None:
                continue
            earlier = seen.setdefault((*one[:3], name), one.line)
            if earlier != one.line:
                place = said(' at position "{position}"', position=one.position)
                says = said(
                    '"{segment}" of "{plan}"{place} stands in line {line} already; keep one of the '
                    "two",
                    segment=one.segment,
                    plan=one.plan,
                    place=place if one.position else "",
                    line=earlier,
                )
                yield Fault(title(name), one.line, says)


_HOW = {
    "turned": said('"{typed}" was read as {meant}, of the same length ({plan}; line {lines})'),
    "case": said('"{typed}" was read as {meant} ({plan}; line {lines})'),
    "look-alikes": said(
        '"{typed}" was read as {meant}: it has Cyrillic letters that look like others ({plan}; '
        "line {lines})"
    ),
    "lost": said(
        '"{typed}" was read as {meant}: letters were lost where the file was saved; save it as '
        "UTF-8 or xlsx ({plan}; line {lines})"
    ),
    "pole": said(
        '"{typed}" was read as {meant}: the pole of this plan is π ({plan}; line {lines})'
    ),
    "letters": said(
        '"{typed}" was read as {meant}, by the letters that were given ({plan}; line {lines})'
    ),
    "unnamed": said(
        '"{typed}": no plan is named, and only one has such a segment: {meant} ({plan}; line {lines})'
    ),
    "above": said(
        '"{typed}": its position was left out; that above was taken, {meant} ({plan}; line {lines})'
    ),
    "roman": said('position "{typed}" was read as {meant} ({plan}; line {lines})'),
    "angle": said('"{typed}" was read as position {meant}, by its angle ({plan}; line {lines})'),
    "rate": said(
        '"{typed}" is no length: its figures were taken as {meant} ({plan}; line {lines})'
    ),
}
"""What is said of a name that was mended, by how it was found."""


class Names(NamedTuple):
    """What a scene calls things: its plans, and by plan the segments, points, positions and pole (a letter).

    ``angles``: of its positions, as people may count them, degrees; ``units``: of the figures that are not
    drawn, by plan and segment; ``letters``: the scene's by the student's own.
    """

    plans: tuple[str, ...]
    segments: Mapping[str, Aliases]
    points: Mapping[str, Aliases]
    positions: Mapping[str, tuple[str, ...]]
    poles: Mapping[str, str]
    angles: Mapping[str, tuple[float, ...]]
    units: Mapping[tuple[str, str], str]
    letters: Letters


class Mend(NamedTuple):
    """A name that was mended: its plan, as it was typed, what it means, and how it was found."""

    plan: str
    typed: str
    meant: str
    how: str


def mended(
    made: DrawnScene,
    parts: Sequence[Taken],
    due: Mapping[Key, Cell],
    spots: Mapping[Key, complex],
    letters: Letters = MappingProxyType({}),
) -> tuple[tuple[Taken, ...], tuple[str, ...], tuple[Fault, ...]]:
    """Return readings by the names of their scene, notes on what was mended, and what may mean several things.

    Names that mean nothing stay as they were typed.

    Parameters
    ----------
    parts : sequence of Taken
        Each of one kind of figure: mm, a value, or x and y.
    due, spots : mapping
        The figures and the points of the scene, as `cells.cells` and `cells.points` find them.
    letters : mapping
        The scene's letters by the student's own.
    """
    if not letters and all(_as_named(part, due, spots) for part in parts):
        return tuple(parts), (), ()
    names = names_of(made, due, spots, letters)
    lines: dict[Mend, list[int]] = {}
    faults: list[Fault] = []
    found = []
    above = Taken("", "", "")
    for part in parts:
        one, mends, fault = _mended(part, names, above)
        above = part if part.position else above
        for mend in mends:
            lines.setdefault(mend, []).append(part.line)
        if fault:
            faults.append(Fault("", part.line, fault))
        found.append(one)
    speech = speaking(made.scene.language)
    kept, shifts = from_poles(found, names.poles, names.points, speech)
    faults += twice(found)
    notes = [_note(mend, at, speech) for mend, at in lines.items() if mend.how not in SILENT]
    return kept, (*notes, *shifts), tuple(faults)


def _as_named(part: Taken, due: Mapping[Key, Cell], spots: Mapping[Key, complex]) -> bool:
    if part.pointed:
        return part.key in spots
    return part.key in due and (part.mm is None or due[part.key].mm is not None)


def names_of(
    made: DrawnScene,
    due: Mapping[Key, Cell],
    spots: Mapping[Key, complex],
    letters: Letters = MappingProxyType({}),
) -> Names:
    """Return what a scene calls its figures and points; ``letters``: its letters by a student's own."""
    positions: dict[str, dict[str, None]] = {}
    for plan, _, name in (*due, *spots):
        positions.setdefault(plan, {})[name] = None
    poles, work = {}, made.mechanism
    for plan in pointed() if work is not None else ():
        view = work.construction.view(plan) if work is not None else None
        if view is not None and view.pole is not None:
            poles[plan] = view.pole.name
    of_points: dict[str, dict[str, frozenset[str]]] = {}
    for plan, letter, _ in spots:
        of_points.setdefault(plan, {})[letter] = frozenset()
    columns = (*scene_columns(made), *result_columns(scene_results(made)))
    there = {plan: tuple(names) for plan, names in positions.items()}
    drawn = {(plan, segment) for (plan, segment, _), cell in due.items() if cell.mm is not None}
    units = {(p, s): cell.unit for (p, s, _), cell in due.items() if (p, s) not in drawn}
    turns = _angles(made)
    return Names(tuple(there), segments_of(columns), of_points, there, poles, turns, units, letters)


def _angles(made: DrawnScene) -> dict[str, tuple[float, ...]]:
    """Return the angles of positions: of the crank from the x axis, and from the first position as it turns."""
    row = [(name, angle) for name, angle in positions_of(made) if angle is not None]
    if not row:
        return {}
    first = row[0][1]
    sense = -1.0 if len(row) > 1 and (row[1][1] - first) % 360.0 > 180.0 else 1.0
    return {name: (angle, sense * (angle - first)) for name, angle in row}


def _mended(part: Taken, names: Names, above: Taken) -> tuple[Taken, list[Mend], str]:
    """Return a reading by the names of its scene, how they were found, and what cannot be told, or "".

    ``above``: the last one before it that has a position.
    """
    plan = _unnamed(part, names) if part.plan == UNNAMED else plan_meant(part.plan, names.plans)
    if not plan.only:
        return part, [], _either(part.plan, plan, said("a plan")) if plan.names else ""
    typed = part.segment if part.plan == UNNAMED else part.plan
    one, mends = part._replace(plan=plan.only), _mends(typed, plan, plan.only)
    segment = _named(part, plan.only, names)
    if len(segment.names) > 1:
        return one, mends, _either(part.segment, segment, said("plan {plan}", plan=plan.only))
    if segment.only:
        one = one._replace(segment=segment.only)
        mends += _mends(part.segment, segment, plan.only)
    unit = names.units.get((one.plan, one.segment))
    if one.mm is not None and unit and not one.unit:
        one = one._replace(mm=None, value=one.mm, last=one.last._replace(value=one.last.mm, mm=0.0))
        mends.append(Mend(plan.only, part.segment, unit, "rate"))
    everywhere = tuple(dict.fromkeys(name for row in names.positions.values() for name in row))
    here = names.positions[plan.only]
    left_out = not part.position and "" not in here and not part.pointed
    if left_out and above.plan == part.plan and segment.names:
        part = part._replace(position=above.position)
        mends.append(Mend(plan.only, part.segment, above.position, "above"))
    position = position_meant(part.position, here, names.angles)
    if not position.names:
        position = position_meant(part.position, everywhere, names.angles)
    if len(position.names) > 1:
        return one, mends, _either(part.position, position, said("plan {plan}", plan=plan.only))
    if position.names:
        one = one._replace(position=position.only)
        mends += _mends(part.position, position, plan.only)
    return one, mends, ""


def _unnamed(part: Taken, names: Names) -> Meant:
    """Return the plan that has a segment of a name, where none is named: spelt rightly, or else at all."""
    found = {plan: _named(part, plan, names) for plan in names.plans}
    right = tuple(p for p, one in found.items() if one.names and one.how in ("", *SILENT))
    some = right or tuple(plan for plan, one in found.items() if one.names)
    return Meant(some, "unnamed")


def _named(part: Taken, plan: str, names: Names) -> Meant:
    """Return what is meant by a name, in the student's own letters if it has a meaning with them."""
    word = in_letters(part.segment, names.letters) if names.letters else part.segment
    if word != part.segment:
        found = _spelt(part._replace(segment=word), plan, names)
        if found.names:
            return found._replace(how="letters")
    return _spelt(part, plan, names)


def _spelt(part: Taken, plan: str, names: Names) -> Meant:
    """Return which segment, or which point, or which pole is meant."""
    pole = names.poles.get(plan)
    poles = {pole: frozenset(("0",) if pole == "O" else ())} if pole else {}
    if part.pointed:
        letters = names.points.get(plan, {})
        found = meant(part.segment, letters)
        return found if found.names else meant(part.segment, poles)
    found = segment_meant(part.segment, plan, names.segments.get(plan, {}))
    return found if found.names or part.mm != 0.0 else meant(part.segment, poles)


def _mends(typed: str, found: Meant, plan: str) -> list[Mend]:
    return [Mend(plan, typed, found.only, found.how)] if found.how else []


def _either(typed: str, found: Meant, where: Said) -> Said:
    listed = joined(said(" or "), found.names)
    return said(
        '"{typed}" may mean {listed} ({where}); write which',
        typed=typed,
        listed=listed,
        where=where,
    )


def _note(mend: Mend, lines: Sequence[int], speech: Speech) -> str:
    plan = view_name(mend.plan, speech.language)
    meant_by = plan if mend.how == "unnamed" else mend.meant
    at = listed(lines)
    return speech(_HOW[mend.how], typed=mend.typed, meant=meant_by, plan=plan, lines=at)
