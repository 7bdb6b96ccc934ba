"""From drawn boards to sheets: their views composed onto paper, each sheet in its frame."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from types import MappingProxyType
from typing import TYPE_CHECKING, NamedTuple

from graphic_tmm.board.scales import LENGTHS as STANDARD
from graphic_tmm.board.scales import Scale
from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.composition import Composition, Placed, distinct_names
from graphic_tmm.fitting.formats import oversized, room_on, views_of
from graphic_tmm.fitting.given import restored_sheets
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.language.units import millimetres, unit_name
from graphic_tmm.paper.compose import sheets
from graphic_tmm.paper.compose.units import Outline
from graphic_tmm.paper.drawing import Drawing, Sheet
from graphic_tmm.paper.formats import size_of
from graphic_tmm.paper.headings import headings
from graphic_tmm.paper.packing import Room, in_pieces
from graphic_tmm.paper.sheet_frame import frame
from graphic_tmm.scene.chapter import MECHANISM
from graphic_tmm.scene.designations import designation, documents
from graphic_tmm.scene.records import Scene, SheetOrder

if TYPE_CHECKING:
    from graphic_tmm.fitting.given import Laid

LENGTHS = "m/mm"
"""The unit of the scale factors of views in which lengths stand as they are, but for graphs."""


class Composed(NamedTuple):
    """The sheets of a scene, how they are composed as data, and what a person should know of it.

    There are none if a composition that was given is of no use. ``scales``: scale factors by view.
    """

    sheets: tuple[Sheet, ...]
    composition: Composition
    remarks: tuple[str, ...] = ()
    scales: Mapping[str, Scale] = MappingProxyType({})


def compose(scene: Scene, boards: Sequence[Drawn]) -> tuple[Sheet, ...]:
    """Return the sheets of a scene; see `composed`."""
    return composed(scene, boards).sheets


def composed(
    scene: Scene,
    boards: Sequence[Drawn],
    given: Composition | None = None,
    *,
    near: bool = False,
) -> Composed:
    """Return the sheets of a scene, each order followed by the sheets it spills onto; as ``given`` if it is.

    What is given and of no use comes to no sheets, and remarks that tell why; ``near``: all is composed anew
    then, no larger or smaller than it is drawn, and of what is given nothing is told.

    Raises
    ------
    ViewError
        If a view does not fit on an empty sheet.
    """
    wanted, there = _wanted(scene, boards)
    boxes = [outline for order in wanted for outline in order.outlines]
    names = distinct_names(view.name for view in there)
    laid, remarks = restored_sheets(wanted, names, given) if given is not None else (None, ())
    remarks = () if near else remarks
    if laid is None and given is not None and not near:
        return Composed((), given, remarks)
    if laid is None:
        laid = sheets.composed(wanted)
        written = [one for one in laid if not scene.sheets[one[0].order].chosen]
        remarks = (*oversized(wanted, written, scene.language), *_spared(wanted, laid))
    made = []
    papers = documents(scene)
    numbers = [papers[sheet.order] for sheet, _ in laid]
    for index, (sheet, places) in enumerate(laid):
        format = wanted[sheet.order].format
        own = numbers[: index + 1].count(numbers[index])
        edge = frame(
            format,
            language=scene.language,
            first=own == 1,
            number=own,
            count=numbers.count(numbers[index]),
            fields=_fields(scene, boards, sheet.order, [there[k] for k in sorted(places)]),
            check=scene.print_check,
        )
        name = f"sheet-{index + 1}" if len(laid) > 1 else "sheet"
        placed = [sheets.moved(there[k], boxes[k], at) for k, at in sorted(places.items())]
        drawings = (edge, *placed, *headings(placed))
        made.append(Sheet(name, scene.title, format, *size_of(format), drawings, scene.language))
    sizes = next((dict(one.sizes) for one in boards if one.board == MECHANISM), {})
    data = [
        Placed(s.order, wanted[s.order].format, {names[k]: at for k, at in sorted(places.items())})
        for s, places in laid
    ]
    scales = {
        view: scale._replace(unit=unit_name(scale.unit, scene.language))
        for one in boards
        for view, scale in one.scales.items()
    }
    return Composed(tuple(made), Composition(sizes, tuple(data)), remarks, scales)


def sheet_count(scene: Scene, boards: Sequence[Drawn]) -> int:
    """Return how many sheets the boards of a scene take.

    Raises
    ------
    ViewError
        If a view fits no sheet.
    """
    return len(sheets.shared(_wanted(scene, boards)[0], even=False))


def orders(scene: Scene) -> list[tuple[SheetOrder, tuple[Room, Room]]]:
    """Return the sheets ordered, each with the room of its first sheet and of those that follow it."""

    def room(order: SheetOrder, first: bool) -> Room:
        return room_on(order.format, scene.language, first)

    papers = documents(scene)
    return [
        (order, (room(order, papers.index(papers[k]) == k), room(order, False)))
        for k, order in enumerate(scene.sheets)
    ]


def _wanted(scene: Scene, boards: Sequence[Drawn]) -> tuple[list[sheets.Order], list[Drawing]]:
    """Return the orders of a scene's sheets as boxes, and the views of all of them in the same order."""
    found, there = list[sheets.Order](), list[Drawing]()
    for order, rooms in orders(scene):
        within = rooms[0].within
        own = [
            part
            for place in order.place
            for view in views_of(place, scene, boards, True)
            for part in in_pieces(view, within)
        ]
        outlines = tuple(Outline.of(view) for view in own)
        spared = bool(found) and len(order.place) > 1 and not (order.name or order.designation)
        found.append(sheets.Order(outlines, rooms, order.format, spared))
        there += own
    return found, there


def _spared(wanted: Sequence[sheets.Order], laid: Laid) -> Iterator[str]:
    """Yield what is told of sheets that are ordered and not there."""
    there = {sheet.order for sheet, _ in laid}
    for k, order in enumerate(wanted):
        if order.spared and order.outlines and k not in there:
            yield said(
                "sheet {number}: one small table is all that there is to show on it: it stands on another "
                "sheet",
                number=k + 1,
            )


def _fields(
    scene: Scene, boards: Sequence[Drawn], k: int, views: Sequence[Drawing]
) -> dict[str, str]:
    """Return what the title block of a sheet tells that was ordered as the ``k``-th, from 0.

    ``views``: that stand on it.
    """
    fields = dict(scene.title_block)
    fields["name"] = scene.sheets[k].name or fields.get("name") or scene.title
    fields["designation"] = designation(scene, k)
    reduction = _reduction(boards, views)
    if reduction is not None:
        fields.setdefault("scale", _ratio(reduction, scene.language))
    return fields


def _reduction(boards: Sequence[Drawn], views: Sequence[Drawing]) -> float | None:
    """Return how many mm a millimetre is on the leading view of a sheet, or else on all its views.

    None if they differ, or where that is no standard scale: the captions tell the scale factors.
    """
    graphs = {f.view for one in boards for f in one.construction.figures if f.kind == "axes"}
    scales = {
        view: millimetres(scale.value, one.scene.language)
        for one in boards
        for view, scale in one.scales.items()
        if scale.unit == LENGTHS and view not in graphs
    }
    leading = [view for view in views if view.stand.kind == "lead"]
    for among in (leading, views):
        found = {scales[shown] for view in among for shown in view.shows if shown in scales}
        if len(found) == 1:
            (mm,) = found
            return mm if any(math.isclose(mm, 1000.0 * mu) for mu in STANDARD) else None
    return None


def _ratio(reduction: float, language: str) -> str:
    """Return a scale as the title block writes it: 1:4, 2,5:1."""
    if reduction >= 1:
        return f"1:{number(reduction, language)}"
    return f"{number(1 / reduction, language)}:1"
