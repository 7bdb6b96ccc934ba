"""The columns and tables of a planetary train: what was measured, the conditions, trains to choose from."""

from __future__ import annotations

import math
import operator
from collections.abc import Callable, Iterable, Iterator, Mapping
from dataclasses import replace
from types import MappingProxyType
from typing import Any

import numpy as np
from numpy.typing import NDArray

from graphic_tmm.board.execute import Reading
from graphic_tmm.board.operations.formulas import turns_a_minute
from graphic_tmm.board.record import Construction, Mark
from graphic_tmm.board.values import Angle, Length
from graphic_tmm.chapters.trains.dimensions import Condition
from graphic_tmm.chapters.trains.plan import PLANETARY_PLAN, Planetary
from graphic_tmm.chapters.trains.rates import RATES
from graphic_tmm.chapters.trains.record import BESIDE, locks
from graphic_tmm.chapters.trains.tooth_search import Solutions, search
from graphic_tmm.drawn import Drawn, Results, results_of
from graphic_tmm.language.catalogue import Tongues
from graphic_tmm.language.numbers import fixed, number
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain
from graphic_tmm.language.units import unit
from graphic_tmm.paper.blocks import breakable
from graphic_tmm.paper.drawing import Drawing
from graphic_tmm.paper.formats import Heights
from graphic_tmm.paper.lettering.letters import letter
from graphic_tmm.paper.ruled import PADDING, ruled_table
from graphic_tmm.paper.views import wrapped
from graphic_tmm.readers.columns import Column, Tabled, listed, measured_columns
from graphic_tmm.readers.rounding import rounded_figures
from graphic_tmm.scene.captions import captions


def train_results(drawn: Drawn) -> Results:
    """Return the results of a train, with the ratios of its meshes and how many satellites have room."""
    beside = BESIDE.on(drawn)
    found = dict(PLANETARY_PLAN.on(drawn).results)
    found |= {f"planetary_mesh_{k}": mark for k, mark in enumerate(beside.stopped, 1)}
    if beside.rack is not None:
        found["planetary_v_rack"] = beside.rack
    if beside.most is not None:
        found["planetary_most"] = beside.most
    found |= {f"planetary_n_{body}": mark for body, mark in beside.turns.items()}
    if not locks(drawn):
        found |= {f"planetary_M_{member}": mark for member, mark in beside.torques.items()}
        found |= {f"planetary_N_{member}": mark for member, mark in beside.powers.items()}
        if beside.efficiency is not None:
            found["planetary_efficiency"] = beside.efficiency
        if beside.circulates is not None and drawn.value(beside.circulates) > LITTLE:
            found["planetary_circulating"] = beside.circulates
    return results_of(drawn, found)


LITTLE = 1e-3
"""No less a share of the power put in is told to circulate: of none a ruler leaves so much."""
SLANT = 1.0
"""How far inclined letters lean over the width of a text, mm."""
CHOICE = 12
"""So many trains are shown to choose from."""
WORDS = Tongues(
    {
        "conditions": said("Conditions on the tooth numbers"),
        "condition": said("Condition"),
        "check": said("Check"),
        "ratio": said("ratio"),
        "coaxial": said("common axis"),
        "neighbours": said("neighbours"),
        "assembly": said("assembly"),
        "undercut": said("no undercut"),
        "interference": said("no interference"),
        "whole": said("whole"),
        "not whole": said("not whole"),
        "rates": said("Angular velocities from the plan"),
        "body": said("Link"),
        "segment": said("Segment"),
        "trains": said("Trains, the smallest first"),
        "size": said("size"),
    }
)


def condition_table(
    construction: Construction, reading: Reading, made: Planetary, language: str, heights: Heights
) -> Drawing:
    """Return the table of conditions, each with its formula and its numbers."""
    words, log, size = WORDS[language], _Log(construction, reading, language), heights.number
    texts = [(words[c.name], text) for c in made.sizes.conditions for text in log.condition(c)]
    found = list(dict.fromkeys(texts))

    def within_lines(most: float) -> Drawing:
        rows = [
            ["" if k else name, line]
            for name, text in found
            for k, line in enumerate(wrapped(text, size, most))
        ]
        heads, align = [words["condition"], words["check"]], ["left", "left"]
        return ruled_table(
            "table-planetary",
            words["conditions"],
            heads,
            rows,
            size=size,
            title_size=heights.title,
            align=align,
        )

    names = max(letter(name, size=size).width for name, _ in found)
    beside = names + 4 * (max(PADDING, size / 2) + SLANT)
    return within_lines(math.inf)._replace(
        apart=lambda within: [within_lines(within.width - beside)]
    )


def rate_table(
    construction: Construction, reading: Reading, made: Planetary, language: str, heights: Heights
) -> Drawing:
    """Return the table of segments and angular velocities, 1/s and rpm."""
    words, log, rates = WORDS[language], _Log(construction, reading, language), made.rates
    block = ", ".join(made.train.scheme.rims)
    lengths = [np.array([log.value(segment)]) for segment in rates.segments.values()]
    omegas = [np.array([log.value(rates.values[body])]) for body in rates.segments]
    minute = [turns_a_minute.run(omega) for omega in omegas]
    columns = [
        listed("", "", symbol, of, row, tuple(rates.segments), lengths)
        for symbol, of, row in (("ω", "1/s", omegas), ("n", "rpm", minute))
    ]
    figures, by_minute = rounded_figures(columns)
    rows = []
    for k, (body, segment) in enumerate(rates.segments.items()):
        mm = fixed(figures.mm[k], figures.mm_places, language)
        omega = fixed(figures.value[k], figures.places, language)
        n = fixed(by_minute.value[k], by_minute.places, language)
        rows.append([block if body == "2" else body, segment.name, mm, omega, n])
    heads = [
        words["body"],
        words["segment"],
        unit("mm", language),
        f"ω, {unit('1/s', language)}",
        f"n, {unit('rpm', language)}",
    ]
    return breakable(
        "table-planetary-rates",
        words["rates"],
        heads,
        rows,
        again=captions(language)["continued"],
        size=heights.number,
        title_size=heights.title,
        lead=1,
    )


def ratio_lines(
    construction: Construction, reading: Reading, made: Planetary, language: str
) -> tuple[str, ...]:
    """Return, as mark-up, the ratio by Willis, that measured, if any could be, and how far they differ."""

    def leads_to(mark: Mark) -> Iterator[Mark]:
        """What it is calculated from, and itself."""
        step = construction.step(mark)
        if step is not None and step.op.formula:
            for used in step.uses:
                yield from leads_to(used)
            yield mark

    measured = (made.rates.drawn, made.rates.difference)
    shown = (mark for mark in measured if mark is not None and np.isfinite(reading[mark]).all())
    marks = [*leads_to(made.rates.due), *shown]
    return calculated_lines(construction, reading, marks, language)


def calculated_lines(
    construction: Construction, reading: Reading, marks: Iterable[Mark], language: str
) -> tuple[str, ...]:
    """Return, as mark-up, how marks are calculated, in letters and numbers, a line each."""
    log = _Log(construction, reading, language)
    return tuple(log.calculated(mark) for mark in marks)


def trains_wanted(made: Planetary) -> Solutions | None:
    """Return the trains that fulfil an order; None if it orders one of given teeth."""
    return None if made.order.ratio is None else search(replace(made.order, teeth=()))


def train_table(
    found: Solutions, language: str, heights: Heights, *, rows: int = CHOICE
) -> Drawing:
    """Return the table of the first ``rows`` trains that fulfil an order; the size in mm."""
    words = WORDS[language]
    heads = [f"z_{wheel}" for wheel in found.scheme.wheels]
    heads += ["k", "U", f"{words['size']}, {unit('mm', language)}"]
    body = []
    for rank in range(min(rows, len(found))):
        cells = [str(int(z)) for z in found.teeth[rank]] + [str(int(found.satellites[rank]))]
        cells.append(fixed(float(found.ratio[rank]), 3, language))
        body.append([*cells, fixed(1000.0 * float(found.size[rank]), 1, language)])
    return breakable(
        "table-trains",
        words["trains"],
        heads,
        body,
        again=captions(language)["continued"],
        size=heights.number,
        title_size=heights.title,
        lead=1,
    )


RELATIONS: Mapping[str, tuple[Callable[[float, float], bool], str]] = MappingProxyType(
    {">": (operator.gt, "≤"), "≥": (operator.ge, "<"), "≤": (operator.le, ">")}
)
"""What a relation says of two numbers, and the one that holds where it does not."""


class _Log:
    """The log with its numbers while its formulas are written out as mark-up."""

    def __init__(self, construction: Construction, reading: Reading, language: str) -> None:
        self.steps = {step.it: step for step in construction.steps}
        self.reading, self.language = reading, language

    def value(self, mark: Mark) -> float:
        return float(self.reading[mark].ravel()[0])

    def figure(self, mark: Mark) -> str:
        """The number of a mark with its unit."""
        name = "mm" if mark.kind is Length else mark.unit
        if name == "%":
            return f"{fixed(self.value(mark), 2, self.language)} %"
        text = number(self.value(mark), self.language)
        if mark.kind is Angle:
            return f"{text}°"
        return f"{text} {unit(name, self.language)}".rstrip()

    def put(self, mark: Mark) -> str:
        """The number of a mark as it is put into a formula."""
        text = number(self.value(mark), self.language)
        text += "°" if mark.kind is Angle else ""
        return f"({text})" if text.startswith("−") else text

    def calculated(self, mark: Mark) -> str:
        """A calculated mark: its letter, the formula in letters and in numbers, its number."""
        step = self.steps.get(mark)
        if step is None or not step.op.formula:
            return f"{mark.name} = {self.figure(mark)}"
        names = step.op.arguments
        letters = {name: used.name for name, used in zip(names, step.uses, strict=True)}
        numbers = {name: self.put(used) for name, used in zip(names, step.uses, strict=True)}
        formula = step.op.formula
        parts = (mark.name, formula.format(**letters), formula.format(**numbers))
        return " = ".join([*parts, self.figure(mark)])

    def condition(self, condition: Condition) -> tuple[str, ...]:
        """A condition: what is calculated, the relation, what it is compared with; an equality in two lines.

        Of one that is broken the relation is the one that is there.
        """
        left, right = self.calculated(condition.left), condition.right
        if right is None:
            value = self.value(condition.left)
            word = "whole" if value == round(value) else "not whole"
            return (f"{left} – {WORDS[self.language][word]}",)
        if condition.relation in ("=", "≠"):
            return left, f"{self.calculated(right)} {condition.relation} {condition.left.name}"
        holds, broken = RELATIONS[condition.relation]
        there = condition.relation if holds(*map(self.value, (condition.left, right))) else broken
        return (f"{left} {there} {right.name} = {self.figure(right)}",)


CONDITIONS, TRAINS = "planetary-conditions", "planetary-trains"
"""The plans of the tables of a train."""


def planetary_columns(drawn: Drawn) -> tuple[Column, ...]:
    """Return what was measured, turns a minute, both sides of each condition, trains of the order by rank."""
    turns = BESIDE.on(drawn).turns
    figures = [drawn.reading.figure(mark)[:, 0] for mark in turns.values()]
    minute = listed(RATES, "n", "n", "rpm", figures, tuple(turns))
    return (*measured_columns(drawn), minute, *_conditions(drawn), *_trains(drawn))


def _conditions(drawn: Drawn) -> Iterator[Column]:
    found: dict[str, Mark] = {}
    for condition in PLANETARY_PLAN.on(drawn).sizes.conditions:
        for mark in (condition.left, condition.right):
            if mark is not None:
                found.setdefault(plain(mark.name), mark)
    for name, mark in found.items():
        unit = "°" if mark.kind is Angle else mark.unit
        yield listed(CONDITIONS, name, mark.name, unit, [drawn.reading.figure(mark)[:, 0]], ())


def _trains(drawn: Drawn) -> Iterator[Column]:
    trains = trains_wanted(PLANETARY_PLAN.on(drawn))
    if trains is None:
        return
    most = min(CHOICE, len(trains))
    heads = [str(rank + 1) for rank in range(most)]
    wheels = enumerate(trains.scheme.wheels)
    rows: list[tuple[str, str, str, NDArray[Any]]] = [
        *((f"z{wheel}", f"z_{{{wheel}}}", "", trains.teeth[:, k]) for k, wheel in wheels),
        ("k", "k", "", trains.satellites),
        ("U", "U", "", trains.ratio),
        ("size", "train size", "m", trains.size),
    ]
    for segment, symbol, si, row in rows:
        figures = list(row[:most, None].astype(np.float64))
        yield listed(TRAINS, segment, symbol, si, figures, heads)


TABLE = Tabled(columns=planetary_columns, results=train_results)
