"""Givens misread in other manners: doubled, digits exchanged, a pivot elsewhere."""

from __future__ import annotations

from collections.abc import Iterator
from typing import Any

import numpy as np

from support.students.kinds import AtGiven, Kind, Variant, word
from support.students.tools import Tools

LENGTHS = ("OA", "AB", "CB", "BC", "CD", "AS2", "AE", "stroke", "r0", "e", "H_V", "H_a")


def said(name: str) -> str:
    """Return the words for a given; an angle of the cam may be said as Φ."""
    return word(name) + ("|Φ" if name in ("rise", "fall") else "")


def _doubled(given: dict[str, Any], rng: np.random.Generator, tools: Tools) -> Iterator[Variant]:
    """A diameter read as a radius, a stroke as a crank, a half as the whole."""
    for name in (*LENGTHS, "rise", "fall", "F", "J2"):
        if name in given:
            yield {name: given[name] * rng.choice([0.5, 2.0])}, (said(name),)


def _digits(given: dict[str, Any], rng: np.random.Generator, tools: Tools) -> Iterator[Variant]:
    """175 read as 157."""
    for name in (*LENGTHS, "omega"):
        number = given.get(name)
        shown = f"{number:g}" if isinstance(number, float) and number >= 10.0 else ""
        if "." not in shown and len(shown) > 1 and shown[-1] not in ("0", shown[-2]):
            words = word("omega1" if name == "omega" else name)
            yield {name: float(shown[:-2] + shown[-1] + shown[-2])}, (words,)


def _speed(given: dict[str, Any], rng: np.random.Generator, tools: Tools) -> Iterator[Variant]:
    if "omega" in given:
        yield {"omega": given["omega"] * rng.choice([0.8, 1.25])}, (word("omega1"),)


def _pivot(given: dict[str, Any], rng: np.random.Generator, tools: Tools) -> Iterator[Variant]:
    for name in ("B", "C"):
        if name in given:
            yield {name: given[name] * rng.choice([0.9, 1.1, 1.2])}, (rf"\b(O?{name}|{name}O)\b",)


def _other_side(given: dict[str, Any], rng: np.random.Generator, tools: Tools) -> Iterator[Variant]:
    for name in ("B", "C"):
        if name in given:
            yield {name: -given[name]}, (rf"\b(O?{name}|{name}O)\b",)


def _from_the_other_end(
    given: dict[str, Any], rng: np.random.Generator, tools: Tools
) -> Iterator[Variant]:
    for part, whole in (("AS2", "AB"), ("AE", "AB")):
        if part in given:
            off = complex(given[part]).conjugate() if part == "AE" else given[part]
            yield {part: given[whole] - off}, (rf"{word(part)}|S_?2|E|end",)


GIVENS: tuple[Kind, ...] = (
    AtGiven("given doubled or halved", ("given", "factor"), _doubled),
    AtGiven("digits of a given exchanged", ("given", "factor"), _digits),
    AtGiven("ω1 misread", ("given", "factor"), _speed),
    AtGiven("pivot misread", ("given",), _pivot),
    AtGiven("pivot on the other side", ("given", "mirrored", "sense"), _other_side),
    AtGiven("point of the rod from its other end", ("given", "wrong end"), _from_the_other_end),
)  # fmt: skip
