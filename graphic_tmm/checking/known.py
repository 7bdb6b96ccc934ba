"""What readings name: whether a scene has it, and whether its figure is sure enough to be judged by."""

from __future__ import annotations

from collections.abc import Mapping, Sequence

from graphic_tmm.checking.cells import RESULTS, Cell, Key, cells, points
from graphic_tmm.checking.readings.mending import mended
from graphic_tmm.checking.readings.read import TOLD
from graphic_tmm.checking.readings.units import taken_figure
from graphic_tmm.checking.records import Taken
from graphic_tmm.checking.report.words import WORDS
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.said import said


def known(
    made: DrawnScene, readings: Sequence[Taken], source: str
) -> tuple[tuple[Taken, ...], tuple[str, ...]]:
    """Return the readings whose figures are known, by the names of the scene, and notes.

    Of names that were typed otherwise what is meant is told, and each reading whose figure is not known.

    Raises
    ------
    SceneError
        If readings name what the scene does not have; the first 20 of them at once.
    """
    due, spots = cells(made), points(made)
    rows = [part for taken in readings for part in taken.parts()]
    named, told, unclear = mended(made, rows, due, spots)
    faults, notes = list(unclear), dict.fromkeys(told)
    doubted = {fault.line for fault in unclear}
    kept = []
    for taken in named:
        if _lost(taken, due, spots):
            words = WORDS[made.scene.language]["not sure"]
            place = f" ({taken.position})" if taken.position else ""
            notes[words.format(line=taken.line, segment=f"{taken.segment}{place}")] = None
            continue
        there = taken.line in doubted or (taken.pointed and taken.key in spots)
        if says := "" if there else _unknown(taken, due):
            faults.append(Fault("", taken.line, says))
        kept.append(taken)
    if faults:
        raise SceneError(source, tuple(faults[:TOLD]))
    return tuple(kept), tuple(notes)


def _lost(taken: Taken, due: Mapping[Key, Cell], spots: Mapping[Key, complex]) -> bool:
    """Whether a figure is null though its plan is drawn at that position, and it is there at others."""
    plan, segment, position = taken.key
    if taken.pointed:
        return False
    if _figure(due.get(taken.key), taken) is not None:
        return False
    if plan == RESULTS:
        return taken.key in due and taken.mm is None
    here = any((p, n) == (plan, position) for p, _, n in due)
    there = (_figure(cell, taken) for (p, s, _), cell in due.items() if (p, s) == (plan, segment))
    return here and any(figure is not None for figure in there)


def _figure(cell: Cell | None, taken: Taken) -> float | None:
    if cell is None:
        return None
    return cell.mm if taken.mm is not None else cell.value


def _unknown(taken: Taken, due: Mapping[Key, Cell]) -> str:
    """Return what is wrong with the name of a reading; empty if nothing."""
    plan, segment, position = taken.key
    if taken.key in due:
        cell = due[taken.key]
        if taken.mm is not None and cell.mm is None:
            return said("{segment} is not drawn in mm; give its value and unit", segment=segment)
        if taken.pointed:
            return said(
                "points are compared on plans of positions, velocities and accelerations, not "
                "{segment}",
                segment=segment,
            )
        try:
            taken_figure(taken, cell)
        except ValueError as error:
            return error.args[0]  # type: ignore[no-any-return]
        return ""
    there = sorted({plan for plan, _, _ in due})
    if plan not in there:
        return said(
            'there is no plan "{plan}"; there are {known}', plan=plan[:30], known=", ".join(there)
        )
    segments = sorted({s for p, s, _ in due if p == plan})
    if segment not in segments:
        return said(
            'plan {plan} has no segment "{segment}"; it has {known}',
            plan=plan,
            segment=segment[:30],
            known=", ".join(segments),
        )
    places = [n for p, s, n in due if (p, s) == (plan, segment)]
    return said(
        '{segment} has no figure at position "{position}"; it has some at {known}',
        segment=segment,
        position=position[:20],
        known=", ".join(places),
    )
