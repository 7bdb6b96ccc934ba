"""Mistakes that were thought of last, when the grammar that is to name them stood already."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from support.another_hand import Rows
from support.students.early import HALF, TWICE, laid, stem, taking
from support.students.early_tables import moved, number_in, picked, row_of, segments
from support.students.kinds import (
    EVERYWHERE,
    KIND,
    POSITION,
    AtGiven,
    AtStep,
    AtTable,
    Kind,
    Variant,
    Written,
    letters_of,
    others,
    word,
)
from support.students.records import POLES, A, Step, V
from support.students.tools import Tools

# operands, the position before --------------------------------------------------------------------------------


def _arm_of_another(step: Step, tools: Tools) -> Iterator[Variant]:
    for letter in others(("A", "B", "S2", "O"), step.takes["about"]):
        yield {"about": letter}, (word(letter),)


def _parallel_to_another(step: Step, tools: Tools) -> Iterator[Variant]:
    how, of = step.takes["way"]
    links = [name for name in tools.machine.links if len(name) == 2]
    if how == "along":
        for link in others(links, of):
            yield {"way": (how, link)}, (word(link),)


def _image_from_the_pole(step: Step, tools: Tools) -> Iterator[Variant]:
    if step.plan in (V, A) and step.takes["start"] != POLES[step.plan]:
        yield {"start": POLES[step.plan]}, ()


def _another_pole_distance(step: Step, tools: Tools) -> Iterator[Variant]:
    for name in others(("H_V", "H_a"), step.takes["pole"]):
        yield {"pole": name}, (word(name),)


def _laid_before(step: Step, tools: Tools) -> Iterator[Variant]:
    if step.takes["way"][1] not in ("x", "y") and step.position:
        yield {"ago": 1}, ()


def _laid_from(step: Step, tools: Tools) -> Iterator[Variant]:
    due = letters_of(tools, step.plan, step.position)
    for letter in (POLES[step.plan], "a"):
        if letter != step.takes["start"] and stem(step.name)[0] in "nk" and "a" in due:
            yield {"start": letter}, (word(letter),)


OPERANDS: tuple[Kind, ...] = (
    AtStep("arm about another point", ("operand",), ("arm",), _arm_of_another),
    AtStep("parallel to another link", ("operand",), ("ray",), _parallel_to_another),
    AtStep("image from the pole", ("start", "operand"), ("image",), _image_from_the_pole),
    AtStep("pole distance of the other diagram", ("operand", "given", "exchanged"), ("chord",),
           _another_pole_distance, (EVERYWHERE,)),
    AtStep("pressure angle by the second derivative", ("operand",), ("pressure",), taking(of="ddS"),
           (EVERYWHERE,)),
    AtStep("speed of the position before", ("previous",), ("normal",), taking(ago=1), (POSITION,)),
    AtStep("laid off by the direction before", ("previous",), ("laid",), _laid_before, (POSITION,)),
    AtStep("chord of the interval before", ("previous", "table"), ("chord",), taking(ago=1),
           (EVERYWHERE,)),
    AtStep("component laid off from a wrong point", ("start",), ("laid",), _laid_from),
)  # fmt: skip

# factors, powers, what is left out ---------------------------------------------------------------------------

STRENGTHS: tuple[Kind, ...] = (
    AtStep("Coriolis with 4", ("factor",), ("Coriolis",), taking(TWICE, factor=4.0)),
    AtStep("normal component halved", ("factor",), ("normal",), taking(HALF, factor=0.5)),
    AtStep("couple halved", ("factor", "given"), ("couple",), taking(HALF, factor=0.5)),
    AtStep("π forgotten in ω1", ("factor",), ("speed",), taking("π|factor", factor=1 / np.pi),
           (EVERYWHERE, KIND)),
    AtStep("chord's rise twice", ("factor", "given"), ("chord",), taking(TWICE, factor=2.0),
           (EVERYWHERE,)),
    AtStep("v²·l for v²/l", ("power",), ("normal",), taking(power=1), (EVERYWHERE, KIND)),
    AtStep("derivative by another power", ("power",), ("derivative",), taking(power=3),
           (EVERYWHERE,)),
    AtStep("arm left out", ("left out",), ("arm", "arm of the lever"), taking(left=True)),
    AtStep("path left out of the radius", ("left out",), ("pressure",), taking(path=0.0),
           (EVERYWHERE,)),
    AtStep("offset left out", ("left out", "given", "factor"), ("pressure",), taking(offset=0.0),
           (EVERYWHERE,)),
    AtStep("couple left out of the lever", ("left out",), ("couple on the lever",),
           taking(factor=0.0)),
)  # fmt: skip

# directions and senses ----------------------------------------------------------------------------------------


def _square_for_parallel(step: Step, tools: Tools) -> Iterator[Variant]:
    how, of = step.takes["way"]
    if how == "along" and step.name[0] not in "πp":
        yield {"way": ("square", of)}, ()


def _other_square(step: Step, tools: Tools) -> Iterator[Variant]:
    how, of = step.takes["way"]
    yield {"way": ("along" if how == "square" else "square", of)}, ()


SENSES: tuple[Kind, ...] = (
    AtStep("component square for parallel", ("direction",), ("laid", "ray"), _square_for_parallel),
    AtStep("reaction parallel for square", ("direction",), ("ray of polygon",), _other_square),
    AtStep("lever not turned", ("direction",), ("arm of the lever",), taking(turn=0.0),
           (EVERYWHERE, KIND)),
    AtStep("load along the velocity", ("sense",), ("load",), taking(sense=1.0)),
    AtStep("reaction not reversed", ("sense",), ("reaction",), taking(sense=1.0)),
    AtStep("tangential component the other way", ("sense",), ("tangential",), taking(sense=-1.0)),
    AtStep("force of the polygon the other way", ("sense",), ("link of polygon",), taking(sense=-1.0)),
    AtStep("derivative with the other sign", ("sense", "table"), ("derivative",), taking(sense=-1.0),
           (EVERYWHERE,)),
    AtStep("πa away from the centre", ("sense",), ("laid",), laid(("π",), sense=-1.0), (POSITION,)),
)  # fmt: skip

# scales, the crank, the givens --------------------------------------------------------------------------------


def _another_scale(step: Step, tools: Tools) -> Iterator[Variant]:
    for plan in others((V, A), step.takes["mu"]):
        if plan in tools.mu:
            yield {"mu": plan}, ()


def _counted_on(step: Step, tools: Tools) -> Iterator[Variant]:
    for by in (1, -1):
        yield {"first": by * 2 * np.pi / tools.machine.positions}, ()


def _misplaced(step: Step, tools: Tools) -> Iterator[Variant]:
    for degrees in (15.0, -20.0):
        yield {"first": np.radians(degrees)}, ()


def _tenfold_given(
    given: dict[str, Any], rng: np.random.Generator, tools: Tools
) -> Iterator[Variant]:
    for name in ("m2", "m3", "J2", "F", "e"):
        if name in given:
            yield {name: given[name] * rng.choice([0.1, 10.0])}, (word(name),)


ASSIGNMENT: tuple[Kind, ...] = (
    AtStep("scale of another plan", ("scale",), ("speed", "normal", "rate"), _another_scale,
           (EVERYWHERE,)),
    AtStep("crank counted one on", ("crank", "table"), ("crank",), _counted_on, (EVERYWHERE,)),
    AtStep("crank put amiss", ("crank", "meeting"), ("crank",), _misplaced, (POSITION,)),
    AtStep("crank counted from the vertical", ("crank",), ("crank",), taking(first=np.pi / 2),
           (EVERYWHERE,)),
    AtGiven("given tenfold", ("given", "factor", "table"), _tenfold_given),
)  # fmt: skip

# written down ------------------------------------------------------------------------------------------------


def _reversed(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    """Write a row of the table from its other end."""
    plan, name = picked(rng, segments(rows))
    keys = row_of(rows, (plan, name))
    return moved(rows, keys, keys[::-1], plan, frozenset({name}), "")


def _columns(rows: Rows, rng: np.random.Generator, change: str) -> Written | None:
    """Exchange two neighbouring positions of a plan, or copy one into the next."""
    plan, name = picked(rng, segments(rows))
    places = [key[1] for key in row_of(rows, (plan, name))]
    k = int(rng.integers(len(places) - 1))
    one, two = places[k], places[k + 1]
    both = [(key, (plan, two, key[2])) for key in rows
            if key[:2] == (plan, one) and (plan, two, key[2]) in rows]  # fmt: skip
    both = [(a, b) for a, b in both if number_in(rows[a]) is not None]
    into, of = [b for _, b in both], [a for a, _ in both]
    names = frozenset(key[2] for key in into)
    if change == "copied":
        return moved(rows, into, of, plan, names, two)
    return moved(rows, [*into, *of], [*of, *into], plan, names, "")


def _exchanged(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    return _columns(rows, rng, "exchanged")


def _copied(rows: Rows, rng: np.random.Generator, tools: Tools) -> Written | None:
    return _columns(rows, rng, "copied")


TABLES: tuple[Kind, ...] = (
    AtTable("row reversed", ("table",), _reversed),
    AtTable(
        "positions exchanged", ("table", "exchanged"), _exchanged, ("mm", "quantities", "both")
    ),
    AtTable("position copied", ("table", "previous"), _copied, ("mm", "quantities", "both")),
)
LATE = (*OPERANDS, *STRENGTHS, *SENSES, *ASSIGNMENT, *TABLES)
