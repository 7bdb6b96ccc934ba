"""The views that the page plays: where they stand on the sheets, their pictures, the sentences to each."""

from __future__ import annotations

from collections.abc import Iterator, Sequence
from typing import Any

from graphic_tmm.chapter import MECHANISM
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.page.told import line_of
from graphic_tmm.paper.drawing import Drawing, Sheet
from graphic_tmm.paper.figure import Picture, pictures
from graphic_tmm.paper.lettering.letters import plain
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.write.svg import clean, ids
from graphic_tmm.readers.covering import covering
from graphic_tmm.readers.narration import protocol

EDGE = 6.0
"""White about a view, mm."""
ALL = -1
"""The place of what belongs to all positions."""


def played(made: DrawnScene, sheets: Sequence[Sheet]) -> list[dict[str, Any]]:
    """Return the views of the sheets that have steps, in the order of the sheets, as data."""
    found: list[dict[str, Any]] = []
    taken = set()
    for number, sheet in enumerate(sheets):
        for name, drawing in zip(ids(sheet), sheet.drawings, strict=True):
            drawn = board_of(made, drawing)
            if drawn is None:
                continue
            shown = pictures(drawn.construction, drawing)
            if len(shown) > 1:
                view = _view(drawn, drawing, shown, made.scene.language, name, sheet, number)
                if (view["plan"], view["position"]) in taken:
                    view["plan"] = drawing.name
                taken.add((view["plan"], view["position"]))
                found.append(view)
    return found


def board_of(made: DrawnScene, drawing: Drawing) -> Drawn | None:
    """Return the board whose log a view is the picture of; None of tables, frames, texts."""
    for drawn in made.boards:
        views = {view.name for view in drawn.construction.views}
        if not views.isdisjoint(drawing.shows):
            return drawn
    return None


def _view(
    drawn: Drawn,
    drawing: Drawing,
    shown: Sequence[Picture],
    language: str,
    name: str,
    sheet: Sheet,
    number: int,
) -> dict[str, Any]:
    names = _names(drawn, drawing)
    first = next((one.position for one in shown if one.position is not None), None)
    if first is None:
        first = drawing.numbers[0][0] if drawing.numbers else 0
    places = sorted({first, *(one.position for one in shown if one.position is not None)})
    left, low, right, top = bounds(drawing)
    single = len(places) == 1 and len(names) > 1
    return {
        "id": name,
        "plan": drawing.shows[-1],
        "family": _family(drawing, language, single=single),
        "title": clean(plain(drawing.title)),
        "board": drawn.board,
        "sheet": number,
        "box": [
            round(x, 3)
            for x in (
                left - EDGE,
                sheet.height - top - EDGE,
                right - left + 2 * EDGE,
                top - low + 2 * EDGE,
            )
        ],
        "names": {str(k): names[k] for k in places if k < len(names)},
        "position": names[first] if single else "",
        "first": first,
        "lines": {str(k): list(_lines(drawn, drawing, k, language)) for k in places},
        "pictures": [_picture(one, first) for one in shown],
    }


def _family(drawing: Drawing, language: str, *, single: bool) -> str:
    """Return what a view is called together with those of other positions."""
    title = clean(plain(drawing.title))
    return title.partition(f", {speaking(language)(_POSITION)} ")[0] if single else title


_POSITION = said("position")


def _names(drawn: Drawn, drawing: Drawing) -> list[str]:
    """Return what the positions are called, by their index in the numbers of a view."""
    row = drawn.row(drawing.shows[-1])
    return [drawn.names[k] for k in row]


def _picture(one: Picture, first: int) -> dict[str, Any]:
    """Return a picture as data: what appears in it (`data-of` @ `data-at`), its steps, its position."""
    keys = dict.fromkeys(key(part.of, part.position) for part in (*one.ink, *one.letters))
    found: dict[str, Any] = {"keys": list(keys), "marks": list(one.marks)}
    found["at"] = first if one.position is None else one.position
    if one.again:
        found["again"] = True
    return found


def key(of: Sequence[int], position: int | None) -> str:
    """Return by what an element of a sheet is known again: its marks and its position.

    >>> key((3, 4), None), key((5,), 2)
    ('3 4@', '5@2')
    """
    return f"{' '.join(map(str, of))}@{'' if position is None else position}"


def _lines(drawn: Drawn, drawing: Drawing, place: int, language: str) -> Iterator[dict[str, Any]]:
    """Yield the lines of the protocol of a view in a position, in the order of the log."""
    turned = drawn.scene.turned and drawn.board == MECHANISM
    for view in drawing.shows:
        reading = drawn.of(view)
        if reading is None:
            continue
        own = place
        if drawn.board == MECHANISM:
            told = protocol(drawn.construction, view, reading, own, language, turned=turned)
        else:
            marks = [step.it for step in drawn.construction.steps if step.it.view == view]
            others = [(k, drawn.names[k]) for k in covering(reading, marks, [own])]
            told = protocol(drawn.construction, view, reading, own, language, elsewhere=others)
        yield from (line_of(line, reading, language) for line in told)
