"""What things are called on sheets, in tables and protocols: the words of no chapter, and those of all.

A view, a plan, the letter of a column and a result have names for people by the names that code has for them. A
chapter declares those of its own, so that they go where it goes.
"""

from __future__ import annotations

from collections import ChainMap
from collections.abc import Callable, Iterable, Mapping
from dataclasses import dataclass, field
from typing import ClassVar

from graphic_tmm.language.catalogue import Speech, Words, speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain
from graphic_tmm.scene.chapter import Answer, chapters

COMMON: dict[str, str] = {
    "position": said("position"),
    "calculate": said("Calculate"),
    "continued": said("continued"),
    "of view": said(" of “{view}”"),
    "results": said("Results"),
    "segment": said("Segment"),
    "value": said("Quantity"),
    "unit": said("Unit"),
    "given": said("Given data"),
    "letter": said("Symbol"),
    "figure": said("Value"),
    "undrawn": said("cannot be drawn"),
    "why": said("Why"),
    "synthesis": said("Synthesis"),
    "scales": said("Scale factors"),
    "finer row": said("finer"),
    "off": said("off, %"),
}
"""The words that belong to no chapter."""


@dataclass(frozen=True)
class Named(Answer):
    """What a chapter calls things.

    ``captions``: its views, plans, letters of columns and results, English, by name; ``called``: a view whose
    name it makes up -> what that is called in a language; ``result``: likewise of a
    result. ``plans``: what protocols call its plans; ``rank``: where these stand among the plans of all
    chapters if not in the order of the book (ten a chapter).
    ``sources``: the books that it follows, as the note calls them; ``symbols``: its letters, what they stand
    for, their units.
    """

    stands: ClassVar[str] = "words.WORDS"
    captions: Mapping[str, str] = field(default_factory=dict)
    called: Callable[[str, Speech], str] = lambda view, speech: ""
    result: Callable[[str, Speech], str] = lambda name, speech: ""
    plans: tuple[str, ...] = ()
    rank: int = 0
    sources: tuple[str, ...] = ()
    symbols: tuple[tuple[str, str, str], ...] = ()


def captions(language: str) -> Words:
    """Return the words of the kernel and of all chapters in a language, by the names that code has for them."""
    declared = [dict(Named.of(one).captions) for one in chapters()]
    return Words(ChainMap(COMMON, *declared), speaking(language), _result)


def moving_or_not(words: Mapping[str, str], name: str, at_rest: bool) -> str:
    """Return what is called so, of a mechanism that stands by a name of its own if it has that."""
    return words.get(f"{name} at rest" if at_rest else name, words.get(name, name))


def _result(name: str, speech: Speech) -> str:
    told = (Named.of(one).result(name, speech) for one in chapters())
    return next((text for text in told if text), "")


def plans_named(plans: Iterable[str], language: str) -> str:
    """Return plans by both of their names, as a message lists them: forces (Force analysis)."""
    words = captions(language)
    return ", ".join(f"{plan} ({words.get(plan, plan)})" for plan in plans)


def view_name(view: str, language: str) -> str:
    """Return what a view is called, as plain text; as code calls it if nobody has a word for it."""
    speech, words = speaking(language), captions(language)
    told = (Named.of(one).called(view, speech) for one in chapters())
    made = next((name for name in told if name), "")
    return made or plain(words.get(f"view {view}", words.get(view, view))).strip()
