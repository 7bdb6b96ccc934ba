"""Where the errors of a plan come from: shares by source, the step that brings most, its stop on the page."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from typing import Any

from graphic_tmm.accuracy.answer import Answer, Origin
from graphic_tmm.accuracy.answer_text import most, parts
from graphic_tmm.accuracy.quantities import Quantity, quantities
from graphic_tmm.accuracy.sources import Sources
from graphic_tmm.accuracy.words import WORDS
from graphic_tmm.board.record import Mark
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.numbers import number
from graphic_tmm.language.said import said
from graphic_tmm.page.sentences import indexed

ERRORS: dict[str, str] = {
    "accuracy": said("Accuracy"),
    "accuracy head": said("Accuracy of the constructions"),
    "error from": said("{quantity}: where the error comes from"),
    "error by student": said("{quantity}: where the error comes from by a student's hand"),
    "error step": said("Show this step"),
    "error figure": said("Error and work at the board; where the error comes from"),
}
"""What the page says of errors, by the names that its program has for it."""


def error_shares(
    answer: Answer, made: DrawnScene, views: Sequence[Mapping[str, Any]]
) -> list[dict[str, Any]]:
    """Return the shares of each quantity that a view shows, by the hand at the board, as data."""
    stops = _Stops(made, views)
    found = []
    for origin in answer.origins:
        if origin.hand != answer.own.way.hand:
            continue
        for quantity in quantities(origin.project):
            of = origin.of.get(quantity.name)
            if of is not None and (shown := stops.views_of(origin, quantity)):
                found.append(_as_data(answer, origin, quantity, of, stops) | {"views": shown})
    return found


def _as_data(
    answer: Answer, origin: Origin, quantity: Quantity, of: Sources, stops: _Stops
) -> dict[str, Any]:
    """Return what is told of a quantity: its name, its sources with their shares in %, the step."""
    language = answer.scene.language
    words = WORDS[language]
    told: dict[str, Any] = {
        "quantity": words[quantity.name],
        "shares": [
            [words[f"from {name}"], round(100.0 * share, 2), number(100.0 * share, language, 2)]
            for name, share in parts(of)
        ],
    }
    if answer.printed is not None:
        told["student"] = True
    if step := most(origin, of, language):
        told["most"] = marked_up(step)
        there = stops.of(origin, of.steps[0].step.it)
        if there:
            told["stop"] = min(there, key=lambda stop: (not stops.views[stop[0]]["main"], stop))
    return told


def marked_up(words: str) -> str:
    """Return words with the indices of their letters marked up, those of the ends of a segment by themselves.

    >>> marked_up("D_0–D = 3"), marked_up("h_R21")
    ('D_{0}–D = 3', 'h_{R21}')
    """
    return "–".join(map(indexed, words.split("–")))


class _Stops:
    """The stops of a page by what is drawn in them: marks of another log are known by their keys."""

    def __init__(self, made: DrawnScene, views: Sequence[Mapping[str, Any]]) -> None:
        self.views = views
        self._slots = {
            (drawn.board, step.it.key): step.it.slot
            for drawn in made.boards
            for step in drawn.construction.steps
        }
        self._at: dict[tuple[str, int], list[tuple[int, int]]] = {}
        for k, view in enumerate(views):
            for n, slot in _drawn(view):
                self._at.setdefault((view["board"], slot), []).append((k, n))

    def of(self, origin: Origin, mark: Mark) -> list[tuple[int, int]]:
        """Return the stops in which a mark is drawn: view and picture."""
        board = origin.project.board
        slot = self._slots.get((board, mark.key))
        return self._at.get((board, slot), []) if slot is not None else []

    def views_of(self, origin: Origin, quantity: Quantity) -> list[int]:
        """Return the views in which a quantity is drawn or read."""
        marks = [value.mark for value in quantity.values]
        return sorted({view for mark in marks for view, _ in self.of(origin, mark)})


def _drawn(view: Mapping[str, Any]) -> Iterator[tuple[int, int]]:
    """Yield the stops of a view with the slots of what is drawn in them."""
    for n, picture in enumerate(view["pictures"]):
        for line in picture["lines"]:
            if "it" in line:
                yield n, line["it"]
