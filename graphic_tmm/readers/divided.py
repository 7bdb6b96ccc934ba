"""What the number of positions costs, in words: for the table of a sheet, for a note, for people."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.drawn import Drawn
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.language.units import unit
from graphic_tmm.readers.finer import SHARE, Finer, FinerRow, finer
from graphic_tmm.scene.captions import captions

ALIKE = 0.001
"""Results that are off by the same share, but for so much, are off for the same reason: the first is told."""
_SIDES = {
    -1: said("this is on the dangerous side"),
    1: said("this is on the safe side"),
}
_SAMPLED = said(
    "What acts is given at the positions only. Between them the curve that is drawn through them is all that "
    "is known, so more positions would tell nothing more."
)


def told_off(drawn: Drawn, language: str) -> tuple[str, ...]:
    """Return, as lettered, a line each, which results are far off for want of positions; none if none is."""
    found = finer(drawn)
    return tuple(_lines(drawn, found, language)) if found is not None and found.far else ()


def is_sampled(language: str) -> str:
    """Return that nothing is known between the positions."""
    return speaking(language)(_SAMPLED)


def _lines(drawn: Drawn, found: Finer, language: str) -> Iterator[str]:
    _, words, first = speaking(language), captions(language), found.far[0]
    figures = ", ".join(_figure(name, found, language) for name in _apart(found))
    first_line = _("with {own} positions: {figures}", own=found.own, figures=figures)
    yield first_line[:1].upper() + first_line[1:]
    due, of = found.due[first]
    yield _(
        "with {count} positions {name} = {due} {unit}",
        count=found.fine,
        name=words[first],
        due=number(due, language),
        unit=unit(of, language),
    )
    if side := _side(drawn, first, found.off[first]):
        yield _(_SIDES[side])
    share = number(100 * SHARE, language)
    if found.enough is None:
        yield _("no usual number of positions keeps within {share} %", share=share)
    else:
        yield _("within {share} % with {enough} positions", share=share, enough=found.enough)


def _apart(found: Finer) -> list[str]:
    """Return the results that are far off, of those that are alike the first."""
    kept: list[str] = []
    for name in found.far:
        if all(abs(found.off[name] - found.off[other]) > ALIKE for other in kept):
            kept.append(name)
    return kept


def _figure(name: str, found: Finer, language: str) -> str:
    share, _ = found.off[name], speaking(language)
    put = {
        "name": captions(language)[name],
        "percent": number(abs(100 * share), language, 2),
    }
    if share < 0.0:
        return _("{name} is too small by {percent} %", **put)
    return _("{name} is too large by {percent} %", **put)


def _side(drawn: Drawn, name: str, share: float) -> int:
    """Return -1 if it is dangerous that a result is off so, 1 if it is safe, 0 if it is neither."""
    sides = (FinerRow.of(one).by_positions.get(name, 0) for one in drawn.project.chapters)
    dangerous = next((side for side in sides if side), 0)
    return (-1 if share * dangerous > 0.0 else 1) if dangerous else 0
