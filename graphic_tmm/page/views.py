"""The views that the page plays: where they stand on the sheets, their stops, the mechanism beside a plan."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from graphic_tmm.board.operations.instruments import measure_along
from graphic_tmm.board.record import Mark
from graphic_tmm.board.values import Length, Line, Point
from graphic_tmm.drawn import Drawn, DrawnScene
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain as plainly
from graphic_tmm.language.symbols import spoken, symbol
from graphic_tmm.page.sentences import head_of, indexed, line_of, sum_of
from graphic_tmm.page.stops import Played, StepLine, Stop
from graphic_tmm.page.tools import Desk
from graphic_tmm.page.values import Values
from graphic_tmm.paper.drawing import Drawing, Sheet
from graphic_tmm.paper.lettering.letters import plain
from graphic_tmm.paper.packing import bounds
from graphic_tmm.paper.seen import Seen, finite
from graphic_tmm.paper.write.svg import clean, ids
from graphic_tmm.readers.equations import called, polygon
from graphic_tmm.readers.protocol import Protocols, title_of

JOINTS = ("pair", "pivot")
"""Parts of ink that stand on joints: their letters are always there."""


def with_mechanisms(
    views: Sequence[Played], told: list[dict[str, Any]], high: Sequence[float]
) -> None:
    """Tell of each view which one shows its mechanism, and of that one where its points stand.

    A view that leads its sheet shows the mechanism of its board, to itself too, if it shows a position of the
    view. ``high``: of the sheets of the views, mm.
    """
    leading = [k for k, view in enumerate(views) if view.drawing.stand.kind == "lead"]
    for data in told:
        for k in leading:
            lead = told[k]
            shown = {data["position"]} if data["position"] else {*data["names"].values()}
            if data["board"] == lead["board"] and not shown.isdisjoint(lead["names"].values()):
                data["mechanism"] = k
                if "joints" not in lead:
                    lead["joints"], lead["joined"] = joints(views[k], high[k])
                break


def joints(view: Played, high: float) -> tuple[list[list[Any]], Mapping[str, list[int]]]:
    """Return the points of a mechanism and which of them its lines join.

    Of a point: slot, letter, whether the letter is always there, its places by position, sheet mm, y downward
    (0, 0 if it is not there). By the slot of a line or of a distance: the points on it, at least two.
    """
    name = view.drawing.shows[-1]
    reading = view.drawn.of(name)
    assert reading is not None
    seen, origin = (
        Seen(view.log, reading, (name,), range(reading.positions)),
        view.drawing.origin(name),
    )
    always = {of for ink in view.drawing.strokes if ink.part in JOINTS for of in ink.of}
    found = {}
    for mark in (*view.log.given, *(step.it for step in seen.steps)):
        if mark.kind is Point and mark.view == name:
            places: list[float] = []
            for k in range(max(view.places) + 1):
                own = view.place_in(name, k)
                at = seen.point(mark, own) + origin if own is not None else complex("nan")
                places += [round(at.real, 2), round(high - at.imag, 2)] if finite(at) else [0, 0]
            letter = spoken(mark, view.language)
            found[mark] = [mark.slot, letter, mark.slot in always, *places]
    joined = {}
    for step in seen.steps:
        if step.it.kind in (Line, Length):
            later = (one.it for one in seen.uses.get(step.it, ()))
            on: dict[Mark, None] = dict.fromkeys(
                mark for mark in (*step.uses, *later) if mark in found
            )
            if len(on) > 1:
                joined[str(step.it.slot)] = [mark.slot for mark in on]
    return list(found.values()), joined


EDGE = 6.0
"""White about a view, mm."""
_POSITION = said("position")
_MISSING = said("Not there in this position: {listed}.")
_AGAIN = ("it", "calc", "row", "read", "sign")
"""What is told of a step that is done again in another position."""
_AGAINST = said("The sign is minus: it points against its line.")


def played(made: DrawnScene, sheets: Sequence[Sheet]) -> list[dict[str, Any]]:
    """Return the views of the sheets that have steps, in the order of the sheets, as data."""
    values = {drawn.board: Values(drawn, made.scene.language) for drawn in made.boards}
    found, taken = [], set()
    plays = list(plays_of(made, sheets))
    for number, name, view in plays:
        place = _placed(view.drawing, name, sheets[number], number)
        told = place | _View(view, values[view.drawn.board], sheets[number].height).data()
        if (told["plan"], told["position"]) in taken:
            told["plan"] = view.drawing.name
        taken.add((told["plan"], told["position"]))
        found.append(told)
    with_mechanisms([view for *_, view in plays], found, [sheets[n].height for n, *_ in plays])
    return found


def plays_of(made: DrawnScene, sheets: Sequence[Sheet]) -> Iterator[tuple[int, str, Played]]:
    """Yield the views of the sheets that have steps: number of the sheet, name there, how it is played."""
    found = []
    for number, sheet in enumerate(sheets):
        for name, drawing in zip(ids(sheet), sheet.drawings, strict=True):
            drawn = board_of(made, drawing)
            if drawn is not None:
                view = Played(drawn, drawing, made.scene.language)
                found.append((number, name, view))
    for number, name, view in found:
        view.others = tuple(other for _, _, other in found if other is not view)
        if len(view.shown) > 1:
            yield number, name, view


def board_of(made: DrawnScene, drawing: Drawing) -> Drawn | None:
    """Return the board whose log a view is the picture of; None of tables, frames, texts."""
    for drawn in made.boards:
        views = {view.name for view in drawn.construction.views}
        if not views.isdisjoint(drawing.shows):
            return drawn
    return None


def _placed(drawing: Drawing, name: str, sheet: Sheet, number: int) -> dict[str, Any]:
    """Return where a view stands, as data."""
    left, low, right, top = bounds(drawing)
    wide, high = right - left + 2 * EDGE, top - low + 2 * EDGE
    box = (left - EDGE, sheet.height - top - EDGE, wide, high)
    return {"id": name, "sheet": number, "box": [round(x, 3) for x in box]}


class _View:
    """A view while it is written down."""

    def __init__(self, played: Played, values: Values, height: float) -> None:
        self.played, self.values, self.height = played, values, height
        self.drawn, self.drawing, self.language = played.drawn, played.drawing, played.language
        self.desks: dict[str, Desk] = {}
        self.made: dict[int, int] = {}
        for n, stop in enumerate(played.stops):
            for told in stop.told:
                self.made.setdefault(told.slot, n)

    def data(self) -> dict[str, Any]:
        """Return the view as data."""
        played, drawing = self.played, self.drawing
        names, places, first = _names(self.drawn, drawing), played.places, played.first
        single = len(places) == 1 and len(names) > 1
        return {
            "plan": drawing.shows[-1],
            "family": _family(drawing, self.language, single=single),
            "title": clean(plain(drawing.title)),
            "board": self.drawn.board,
            "names": {str(k): names[k] for k in places if k < len(names)},
            "position": names[first] if single else "",
            "first": first,
            "main": played.position(first) == self.drawn.main,
            "pictures": list(self.stops()),
            "values": {str(k): self.rows(k) for k in places},
        }

    def rows(self, place: int) -> list[list[Any]]:
        """Return the small table of a position."""
        return list(self.values.rows(self.played.views, self.played.position(place)))

    def stops(self) -> Iterator[dict[str, Any]]:
        """Yield the stops: what appears (`data-of` @ `data-at`), the position, what is told."""
        view = ""
        several = len(self.played.views) > 1
        for stop in self.played.stops:
            found: dict[str, Any] = {"keys": _keys(stop), "at": stop.place, "lines": []}
            if stop.picture is not None:
                found["marks"] = list(stop.picture.marks)
                if stop.picture.again:
                    found["again"] = True
            for told in stop.told:
                if told.view != view and not found.get("again"):
                    found["lines"] += self.begun(told, title=several)
                    view = told.view
                found["lines"] += self.line(told, stop, again="again" in found)
            if stop.missing:
                found["lines"].append(self.missing(stop))
            yield found

    def begun(self, told: StepLine, *, title: bool) -> Iterator[dict[str, Any]]:
        """Yield what stands above the steps of a plan: its name, the equation of its polygon."""
        if title:
            name = title_of(self.drawn.project, told.view, self.language)
            yield {"head": True, "text": [indexed(name)]}
        equations = [
            text
            for chapter in self.drawn.project.chapters
            for text in Protocols.of(chapter).equations(self.drawn, told.view, self.language)
        ]
        terms = called(polygon(self.played.log, told.view), equations)
        if terms and all(term.line is None or term.line.slot in self.made for term in terms):
            yield sum_of(terms, self.made, self.language)

    def line(self, told: StepLine, stop: Stop, *, again: bool) -> Iterator[dict[str, Any]]:
        """Yield what is told of a step: its heads, its sentence with its calculation or its reading."""
        if not again:
            yield from (head_of(head, self.made, self.language) for head in told.heads)
        step, reading = told.line.step, self.drawn.of(told.view)
        assert step is not None
        assert reading is not None
        found = line_of(told.line, reading, self.language)
        row = self.values.row(step.it, self.played.position(stop.place))
        if step.op.reads and row is not None:
            found.pop("calc", None)
            found["row"] = row
            mm = reading.figure(step.it)[0]
            against = mm[told.line.place if mm.size > 1 else 0] < 0 and "−" not in row[2]
            if against and step.op is measure_along:
                found |= {"read": f"−{row[2]}", "sign": speaking(self.language)(_AGAINST)}
        if not step.op.formula:
            kind, words, *numbers = self.desk(told.view).hint(step, told.line.place)
            found["tool"] = [kind, indexed(words), *numbers]
        if again and told.slot in self.made:
            found = {key: found[key] for key in _AGAIN if key in found}
        yield found

    def desk(self, view: str) -> Desk:
        """Return where the instruments of a view of the log are laid."""
        if view not in self.desks:
            reading = self.drawn.of(view)
            assert reading is not None
            seen = Seen(self.played.log, reading, (view,), range(reading.positions))
            origin = self.drawing.origin(view)
            self.desks[view] = Desk(seen, origin, self.height, self.language)
        return self.desks[view]

    def missing(self, stop: Stop) -> dict[str, Any]:
        """Return the remark that tells what is not there in a position."""
        names = dict.fromkeys(plainly(symbol(mark.name, self.language)) for mark in stop.missing)
        listed = ", ".join(name for name in names if name)
        return {"text": [indexed(speaking(self.language)(_MISSING, listed=listed))]}


def _keys(stop: Stop) -> list[str]:
    if stop.picture is None:
        return []
    parts = (*stop.picture.ink, *stop.picture.letters)
    return list(dict.fromkeys(key(part.of, part.position) for part in parts))


def _family(drawing: Drawing, language: str, *, single: bool) -> str:
    """Return what a view is called together with those of other positions."""
    title = clean(plain(drawing.title))
    return title.partition(f", {speaking(language)(_POSITION)} ")[0] if single else title


def _names(drawn: Drawn, drawing: Drawing) -> list[str]:
    """Return what the positions are called, by their index in the numbers of a view."""
    row = drawn.row(drawing.shows[-1])
    return [drawn.names[k] for k in row]


def key(of: Sequence[int], position: int | None) -> str:
    """Return by what an element of a sheet is known again: its marks and its position.

    >>> key((3, 4), None), key((5,), 2)
    ('3 4@', '5@2')
    """
    return f"{' '.join(map(str, of))}@{'' if position is None else position}"
