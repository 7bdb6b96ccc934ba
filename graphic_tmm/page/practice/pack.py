"""What the page packs for practice, and for a drawing of one's own: a log, its tasks, the limits of the hand.

Of a board the steps that its pointed plans need, as they stand in the log; what is given, by position; what is
told of a step, once. The page's program runs the log itself: with the functions that `program` writes down.
"""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence
from functools import cached_property
from typing import Any

from graphic_tmm.accuracy.geometrography import symbol
from graphic_tmm.board.record import Mark, Step
from graphic_tmm.board.script import Script
from graphic_tmm.board.source import defaults
from graphic_tmm.board.values import KINDS, Number, Side
from graphic_tmm.checking.cells import cells, longest, points
from graphic_tmm.checking.judging import slips
from graphic_tmm.checking.judging.equivalents import Limb, crossings, ways_of
from graphic_tmm.checking.judging.own_errors import parts_of
from graphic_tmm.drawn import DrawnScene
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import spoken, with_functions
from graphic_tmm.language.units import unit
from graphic_tmm.page.practice.limits import HAND, MANNERS, Named, manner, reader_of, sizes_for_page
from graphic_tmm.page.practice.tasks import (
    PoseRow,
    posed,
    readable,
    sheet_row,
    with_others,
    written,
)
from graphic_tmm.page.sentences import indexed, marked_up, runs
from graphic_tmm.page.tools import tools_sentence as instruments
from graphic_tmm.paper.drawing import Sheet
from graphic_tmm.paper.write.svg import ids
from graphic_tmm.readers.protocol import title_of
from graphic_tmm.readers.sentences import grounds, letters_of, phrase

GOAL = said("To be drawn: {title}, position {position}.")
SOUGHT = {
    "point": said("Mark {listed}."),
    "length": said("Measure {listed}."),
    "rate": said("Calculate {listed}."),
}
"""What is done with what a check reads of a plan, by what that is."""
Tables = Mapping[str, Mapping[str, Any]]
FROM = {"ARITHMETIC": "./arithmetic.js", "ROWS": "../live/rows.js"}
"""The modules of the page that do the arithmetic of the one that is written down."""


def written_module(script: Script, tables: Tables, logs: Mapping[str, str] | None = None) -> str:
    """Return the module that enters what is written down of the board; see `Script.program`."""
    program = script.program(tables, "enterBoard", logs)
    needs = "".join(f'import {{ {one} }} from "{FROM[one]}";\n' for one in script.needs.values())
    return f'{needs}import {{ enterBoard }} from "./board.js";\n{program}'


class Packing:
    """A row of positions while it is written down."""

    def __init__(
        self,
        made: DrawnScene,
        row: PoseRow,
        sheets: Sequence[Sheet],
        script: Script | None = None,
    ) -> None:
        self.made, self.row, self.sheets = made, row, sheets
        self.language = made.scene.language
        self.named: Named = {m: told for m, told in readable(made).items() if m.view in row.places}
        self.lines = {step.it: step for step in row.log.steps}
        self.script = Script() if script is None else script
        self.operations = written(self.script, row.steps)
        self.steps = [step for step in row.steps if step.op.name in self.operations]
        self.count = len(row.own[0].names if row.own else row.names)
        self.plans = list(dict.fromkeys(mark.view for mark in self.marks()))

    @cached_property
    def scales(self) -> frozenset[Mark]:
        """The scale factors of the views."""
        return frozenset(one.scale for one in self.row.log.views if one.scale is not None)

    @cached_property
    def crossings(self) -> Mapping[Mark, Sequence[tuple[Limb, Limb]]]:
        """By a point the other pairs of lines that meet there."""
        return crossings(self.row.work.project)

    def marks(self) -> list[Mark]:
        """Return all marks that the steps speak of, in the order of the log."""
        found = {m.slot: m for step in self.steps for m in (step.it, *step.uses)}
        return [found[slot] for slot in sorted(found)]

    @property
    def tables(self) -> Tables:
        """What the page's program has of the board: the operations, and how it judges, by their names."""
        judging = {function.__name__: function for function in slips.FUNCTIONS}
        return {"operations": self.operations, "slips": judging}

    def program(self) -> str:
        """Return the module of the page's program that has the operations."""
        return written_module(self.script, self.tables)

    def data(self, views: Sequence[Mapping[str, Any]]) -> dict[str, Any]:
        """Return the data; ``views``: those of the page."""
        row, practised = self.row, list(self.row.places)
        made = {step.it for step in self.steps}
        return {
            "hand": HAND,
            "names": list(row.names),
            "main": row.work.main,
            "plans": self.plans,
            "titles": [title_of(row.work.project, plan, self.language) for plan in self.plans],
            "at": [list(row.places.get(plan, ())) for plan in self.plans],
            "marks": {str(mark.slot): self.mark(mark) for mark in self.marks()},
            "given": {str(m.slot): self.numbers(m) for m in self.marks() if m not in made},
            "steps": [self.step(step) for step in self.steps],
            "tasks": [task for plan in practised for task in self.tasks(plan, views)],
            "reader": reader_of(self.made.scene),
            "manners": {
                name: manner(self.made.scene, row, self.named, name, self.plans, self.crossings)
                for name in MANNERS
            },
        }

    def mark(self, mark: Mark) -> dict[str, Any]:
        """Return what is said of a mark."""
        found: dict[str, Any] = {
            "l": marked_up(mark, self.language),
            "n": spoken(mark, self.language),
            "k": KINDS[mark.kind].lower(),
            "v": self.plans.index(mark.view),
        }
        if mark.kind is Number and mark.unit:
            found["u"] = unit(mark.unit, self.language)
        if mark in self.scales:
            found["s"] = 1
        return found

    def numbers(self, mark: Mark) -> Any:
        """Return the numbers of a mark: one alone where there is but one."""
        flat = [x if math.isfinite(x) else None for one in self.row.numbers(mark) for x in one]
        return flat[0] if len(flat) == 1 else flat

    def step(self, step: Step) -> dict[str, Any]:
        """Return a step."""
        found: dict[str, Any] = {
            "it": step.it.slot,
            "op": step.op.name,
            "uses": [mark.slot for mark in step.uses],
        }
        choice = defaults(step.op.run, dict(step.choice))
        if step.op.reads:
            found["measures"] = True
        if choice:
            found["choice"] = list(choice)
            found["choices"] = list(step.op.choices)
        if step.it.view in self.row.places:
            found |= self.step_text(step)
        if step.it in self.named:
            kind, plan, name, of = self.named[step.it]
            found["read"] = {"as": kind, "name": plan, "key": name, "unit": of}
            if kind == "point":
                found["parts"] = [[p.kind, p.by.it.slot, p.use] for p in parts_of(step, self.lines)]
                found |= self.ways(step)
        return found

    def ways(self, step: Step) -> dict[str, Any]:
        """Return the other ways in which the point of a step can be found, where there are any."""
        ways = [
            [[limb.kind, limb.centre.slot, *(mark.slot for mark in limb.of)] for limb in way]
            for way in (*ways_of(step, self.lines), *self.crossings.get(step.it, ()))
        ]
        return {"ways": ways} if ways else {}

    def step_text(self, step: Step) -> dict[str, Any]:
        """Return what is said of a step: what is done, why, by which formula, with which instruments."""
        reading, language = self.row.reading, self.language
        at = next((k for k in self.row.places[step.it.view] if self.row.there(step.it, k)), 0)
        found: dict[str, Any] = {
            "text": [*runs(phrase(step, language, reading, at), step, language)],
            "tool": instruments(step, language),
            "hand": symbol(step.op),
        }
        why = grounds(step, language, reading, at)
        if why is not None:
            found["why"] = [*runs(why, step, language)]
        if step.op.formula:
            letters = letters_of(step, lambda mark: spoken(mark, language))
            formula = with_functions(step.op.formula, language).format(**letters)
            found["formula"] = indexed(f"{letters['it']} = {formula}")
        if Side in step.op.takes or step.op.choices:
            found["sides"] = [speaking(language)(one) for one in step.op.sides]
        return found

    def tasks(self, plan: str, views: Sequence[Mapping[str, Any]]) -> Iterator[dict[str, Any]]:
        """Yield the tasks of a plan."""
        due = longest(cells(self.made), points(self.made))
        steps = [step for step in self.steps if step.it.view == plan]
        pole = self.row.log.view(plan)
        for at in self.row.places[plan]:
            there = [step for step in steps if self.row.there(step.it, at)]
            here = [step for step in there if step not in self.row.free]
            if not any(step.it in self.named for step in here):
                continue
            made = {step.it for step in here}
            used = dict.fromkeys(m for step in here for m in step.uses if m not in made)
            view, sheet, origin = self.seen(plan, at, views)
            yield {
                "plan": self.plans.index(plan),
                "at": at,
                "view": view,
                "sheet": sheet,
                "origin": origin,
                "goal": self.goal(plan, at, here),
                "steps": [step.it.slot for step in here],
                "shown": [mark.slot for mark in used],
                "pole": pole.pole.slot if pole is not None and pole.pole is not None else -1,
                "whole": sizes_for_page(
                    [due.get((plan, self.row.names[at]), self.reach(here, at))]
                )[0],
            } | self._more(there, at)

    def _more(self, there: Sequence[Step], at: int) -> dict[str, Any]:
        """Return what only some tasks have: lines that may be drawn besides, that it is a pose."""
        free = [step.it.slot for step in there if step in self.row.free]
        return ({"free": free} if free else {}) | ({"pose": True} if at >= self.count else {})

    def goal(self, plan: str, at: int, steps: Sequence[Step]) -> str:
        """Return what the task is, as mark-up: the plan, its position, what of it a check reads."""
        speech = speaking(self.language)
        title = title_of(self.row.work.project, plan, self.language)
        told = [speech(GOAL, title=title[:1].lower() + title[1:], position=self.row.names[at])]
        for kind, words in SOUGHT.items():
            letters = [s.it for s in steps if s.it in self.named and self.named[s.it][0] == kind]
            listed = ", ".join(dict.fromkeys(marked_up(one, self.language) for one in letters))
            told += [speech(words, listed=listed)] if listed else []
        return " ".join(told)

    def reach(self, steps: Sequence[Step], at: int) -> float:
        """Return the longest vector among steps in a position, mm."""
        found = [
            self.row.numbers(s.it) for s in steps if s.it in self.named and s.it.kind is not Number
        ]
        return max((math.hypot(*row[at if len(row) > 1 else 0]) for row in found), default=0.0)

    def seen(
        self, plan: str, at: int, views: Sequence[Mapping[str, Any]]
    ) -> tuple[int, int, list[float]]:
        """Return which view shows a plan in a position, on which sheet, its origin there; -1: none."""
        stands = {
            name: drawing
            for sheet in self.sheets
            for name, drawing in zip(ids(sheet), sheet.drawings, strict=True)
        }
        for k, view in enumerate(views):
            drawing = stands[view["id"]]
            here = at < self.count and self.row.names[at] in view["names"].values()
            if here and drawing.shows[-1] == plan:
                origin = drawing.origin(plan)
                high = self.sheets[view["sheet"]].height
                return k, view["sheet"], [round(origin.real, 3), round(high - origin.imag, 3)]
        return -1, -1, [0.0, 0.0]


def practice(
    made: DrawnScene,
    sheets: Sequence[Sheet],
    views: Sequence[Mapping[str, Any]],
    seed: int | None = None,
    script: Script | None = None,
) -> tuple[dict[str, Any], Tables] | None:
    """Return what is packed for practice, and the tables of its operations; None where nothing is practised.

    ``made``: drawn by the exact hand; ``views``: those of the page; ``seed``: of further poses, None for none;
    ``script``: which writes the operations down.
    """
    row = sheet_row(made)
    if row is None:
        return None
    others = None if seed is None else posed(row, seed)
    row = row if others is None else with_others(row, others)
    packing = Packing(made, row, sheets, script)
    return packing.data(views), packing.tables
