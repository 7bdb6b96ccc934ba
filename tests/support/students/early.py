"""Mistakes that students make, as published errata and one's own memory have them; the first two thirds."""

from __future__ import annotations

import re
from collections.abc import Iterator
from typing import Any

import numpy as np

from support.students.early_tables import TABLES
from support.students.kinds import (
    EVERYWHERE,
    KIND,
    POSITION,
    AtGiven,
    AtStep,
    Kind,
    Variant,
    lengths_of,
    letters_of,
    others,
    word,
)
from support.students.records import POLES, P, Step, V
from support.students.tools import Tools

HALF, TWICE = r"half|½|0\.5|factor|\b2\b", r"twice|doubl|\b2\b|diameter|factor"


# operands ----------------------------------------------------------------------------------------------------


def _link(step: Step, tools: Tools) -> Iterator[Variant]:
    for link in others(tools.machine.links, step.takes["link"]):
        if link in tools.given or (P, link) in tools.pages[step.position].lengths:
            yield {"link": link}, (word(link),)


def _speed(step: Step, tools: Tools) -> Iterator[Variant]:
    for name in others(lengths_of(tools, V, step.position), step.takes["of"]):
        yield {"of": name}, (word(name),)


def _segment(step: Step, tools: Tools) -> Iterator[Variant]:
    for name in others(lengths_of(tools, step.plan, step.position), step.takes["of"]):
        yield {"of": name}, (word(name),)


def _square_to_another(step: Step, tools: Tools) -> Iterator[Variant]:
    how, of = step.takes["way"]
    if how == "square":
        for link in others([name for name in tools.machine.links if len(name) == 2], of):
            yield {"way": (how, link)}, (word(link),)


def _crank_rate(step: Step, tools: Tools) -> Iterator[Variant]:
    yield {"rate": "omega1"}, (word("omega1"),)


def _mass(step: Step, tools: Tools) -> Iterator[Variant]:
    for name in others(("m2", "m3"), step.takes["mass"]):
        yield {"mass": name}, (word(name),)


def _acceleration(step: Step, tools: Tools) -> Iterator[Variant]:
    for name in others(("πa", "πb", "πs2"), step.takes["of"]):
        yield {"of": name}, (word(name),)


def _other_point(step: Step, tools: Tools) -> Iterator[Variant]:
    """Measure to the due point from another: a reading of the wrong segment."""
    for letter in others(letters_of(tools, step.plan, step.position), step.takes["start"]):
        if letter != step.takes["end"] and step.takes["start"] == POLES.get(step.plan):
            yield {"start": letter}, (word(letter),)


OPERANDS: tuple[Kind, ...] = (
    AtStep("normal component with another link", ("operand",), ("normal",), _link),
    AtStep("normal component with another speed", ("operand",), ("normal",), _speed),
    AtStep("rate from another segment", ("operand",), ("rate",), _segment),
    AtStep("rate with another link", ("operand",), ("rate",), _link),
    AtStep("crank's speed with another link", ("operand",), ("speed",), _link, (EVERYWHERE,)),
    AtStep("square to another link", ("operand", "direction"), ("ray",), _square_to_another),
    AtStep("Coriolis with the crank's rate", ("operand",), ("Coriolis",), _crank_rate),
    AtStep("Coriolis with another speed", ("operand",), ("Coriolis",), _speed),
    AtStep("mass of another link", ("operand",), ("weight", "inertia"), _mass),
    AtStep("inertia with another acceleration", ("operand",), ("inertia",), _acceleration),
    AtStep("measured from another point", ("operand", "table"), ("read",), _other_point),
)


# what is taken of an earlier position, or in another strength ------------------------------------------------


def taking(*words: str, **what: Any) -> Any:
    """Return variants that take other values wherever a step has operands of these names."""

    def variants(step: Step, tools: Tools) -> Iterator[Variant]:
        if all(step.takes.get(name, value) != value for name, value in what.items()):
            yield dict(what), words

    return variants


def _earlier(step: Step, tools: Tools) -> Iterator[Variant]:
    if step.takes["way"][1] not in ("x", "y") and step.position:
        yield {"ago": 1}, ()


def stem(name: str) -> str:
    """Return what a segment begins with; of one that ends in n or k of a component (an2, πn3), that letter."""
    part = re.search(r"([nk])\d+$", name)
    return part[1] if part else name


def laid(names: tuple[str, ...], **what: Any) -> Any:
    """Return variants of laying off segments whose names begin so."""

    def variants(step: Step, tools: Tools) -> Iterator[Variant]:
        if stem(step.name).startswith(names):
            yield dict(what), ()

    return variants


def _turned(names: tuple[str, ...]) -> Any:
    def variants(step: Step, tools: Tools) -> Iterator[Variant]:
        how, of = step.takes["way"]
        if stem(step.name).startswith(names):
            yield {"way": ("along" if how == "square" else "square", of)}, ()

    return variants


def _parallel(step: Step, tools: Tools) -> Iterator[Variant]:
    how, of = step.takes["way"]
    if how == "square":
        yield {"way": ("along", of)}, ()


def _mm_for_m(step: Step, tools: Tools) -> Iterator[Variant]:
    for by in (1000.0, 1e-3):
        yield {"factor": by}, ("1000|mm|10",)


STRENGTHS: tuple[Kind, ...] = (
    AtStep("direction of the position before", ("previous",), ("ray",), _earlier, (POSITION,)),
    AtStep("Coriolis without its 2", ("factor",), ("Coriolis",), taking(HALF, factor=1.0)),
    AtStep("diameter for radius", ("factor",), ("speed",), taking(TWICE, factor=2.0), (EVERYWHERE,)),
    AtStep("mm for m in a rate", ("factor", "scale", "table"), ("rate",), _mm_for_m, (EVERYWHERE, KIND)),
    AtStep("mass for weight", ("factor", "left out", "operand"), ("weight",), taking(g=1.0),
           (EVERYWHERE, KIND)),
    AtStep("v/l for v²/l", ("power",), ("normal",), taking(square=1), (EVERYWHERE, KIND)),
    AtStep("ω/r for ωr", ("power",), ("speed",), taking(power=-1), (EVERYWHERE,)),
    AtStep("ωr for ω²r", ("power",), ("speed",), taking(square=1), (EVERYWHERE,)),
    AtStep("rate times the link", ("power",), ("rate",), taking(power=1), (EVERYWHERE, KIND)),
    AtStep("normal component left out", ("left out",), ("laid",), laid(("n",), factor=0.0)),
    AtStep("Coriolis left out", ("left out",), ("laid",), laid(("k",), factor=0.0)),
    AtStep("couple left out of the moments", ("left out",), ("sum",), taking(couple=0.0)),
    AtStep("force left out of the polygon", ("left out",), ("link of polygon",), taking(left=True)),
    AtStep("parallel for square", ("direction",), ("ray",), _parallel),
    AtStep("Coriolis along the lever", ("direction",), ("laid",), _turned(("k",))),
)  # fmt: skip


# senses, ends, meetings, starts ------------------------------------------------------------------------------


def _mirrored(step: Step, tools: Tools) -> Iterator[Variant]:
    shape = complex(step.takes["shape"])
    if shape.imag:
        yield {"shape": shape.conjugate()}, ()


def _other_end(step: Step, tools: Tools) -> Iterator[Variant]:
    shape = complex(step.takes["shape"])
    if 0.0 < shape.real < 1.0 and step.takes["start"] not in POLES.values():
        yield {"start": step.takes["end"], "end": step.takes["start"]}, ()


def _other_start(step: Step, tools: Tools) -> Iterator[Variant]:
    letters = [*letters_of(tools, step.plan, step.position), POLES[step.plan]]
    for letter in others(letters, step.takes["start"]):
        if letter != step.takes["letter"] and _before(step, tools, letter):
            yield {"start": letter}, (word(letter),)


def _before(step: Step, tools: Tools, letter: str) -> bool:
    """Whether a point stands on the plan when a step is made."""
    letters = letters_of(tools, step.plan, step.position)
    if letter not in letters:
        return True
    return letters.index(letter) < letters.index(step.takes["letter"])


SENSES: tuple[Kind, ...] = (
    AtStep("crank's velocity the other way", ("sense",), ("laid",), laid(("p", "π"), sense=-1.0)),
    AtStep("inertia not reversed", ("sense",), ("inertia",), taking(sense=1.0), (EVERYWHERE, KIND)),
    AtStep("couple of inertia not reversed", ("sense",), ("couple",), taking(sense=1.0)),
    AtStep("Coriolis turned the other way", ("sense",), ("laid",), laid(("k",), sense=-1.0)),
    AtStep("rate with the other sign", ("sense", "table"), ("rate",), taking(sense=-1.0)),
    AtStep("normal component from the wrong end", ("wrong end", "sense"), ("laid",),
           laid(("n",), sense=-1.0)),
    AtStep("place counted from the other end", ("wrong end",), ("image", "place"), _other_end),
    AtStep("other meeting", ("meeting",), ("meeting",), taking(side=-1)),
    AtStep("mirrored similarity", ("mirrored",), ("image", "place"), _mirrored),
    AtStep("ray from a wrong point", ("start",), ("ray",), _other_start),
)  # fmt: skip


# the crank, what is given, scales ----------------------------------------------------------------------------


def _misread(given: dict[str, Any], rng: np.random.Generator, tools: Tools) -> Iterator[Variant]:
    for name in (
        "OA",
        "AB",
        "CB",
        "BC",
        "CD",
        "AE",
        "m2",
        "m3",
        "J2",
        "F",
        "H_V",
        "H_a",
        "r0",
        "stroke",
    ):
        if name in given:
            by = rng.choice([0.75, 0.85, 1.15, 1.3])
            yield {name: given[name] * by}, (word(name),)


def _exchanged(given: dict[str, Any], rng: np.random.Generator, tools: Tools) -> Iterator[Variant]:
    for a, b in (("AB", "CB"), ("BC", "CD"), ("H_V", "H_a"), ("m2", "m3"), ("rise", "fall")):
        if a in given and b in given and given[a] != given[b]:
            yield {a: given[b], b: given[a]}, (word(a), word(b))


ASSIGNMENT: tuple[Kind, ...] = (
    AtStep("crank turned the other way", ("crank",), ("crank",), taking(turn=-1), (EVERYWHERE,)),
    AtStep("counted from the other dead centre", ("crank", "direction"), ("crank",), taking(first=np.pi),
           (EVERYWHERE,)),
    AtGiven("given misread", ("given",), _misread),
    AtGiven("givens exchanged", ("exchanged", "given"), _exchanged),
)  # fmt: skip


EARLY = (*OPERANDS, *STRENGTHS, *SENSES, *ASSIGNMENT, *TABLES)
