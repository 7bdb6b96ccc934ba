"""What a task says in words: what is drawn on which sheet, with which scale factors, what is handed in."""

from __future__ import annotations

import re
from collections.abc import Iterable, Iterator, Mapping, Sequence
from typing import Any, NamedTuple

from graphic_tmm.fitting.sizes import all_sizes
from graphic_tmm.handout.words import indexed
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.numbers import decimal_sign, number
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import symbol
from graphic_tmm.language.units import unit
from graphic_tmm.paper.formats import AUTO
from graphic_tmm.paper.lettering.letters import escape
from graphic_tmm.paper.lettering.markup import markup
from graphic_tmm.readers.protocol import synthesis as read_synthesis
from graphic_tmm.readers.task_sheet import TaskSheet
from graphic_tmm.scene.captions import captions
from graphic_tmm.scene.chapter import chapters, places
from graphic_tmm.scene.declare import keys_of
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.units import plain_unit

Document = Mapping[str, Any]

SHEET = said("Sheet {number}, {format}.")
NAMED = said("Sheet {number}, {format}: {name}.")
ANY = said("a format of your choice")
SCALES = "scales"
FIXED = said("Given: {listed}.", context="scale factors")
FOUND = said("The lengths {listed} of the mechanism are found by the task.")
ONE_FOUND = said("The length {listed} of the mechanism is found by the task.")
CHOSEN = said("{listed} are chosen.", context="scale factors")
ONE_CHOSEN = said("{listed} is chosen.", context="scale factor")
OTHERS = said(
    "All other scale factors are chosen: μ = 1; 2; 2.5; 4; 5 (1.5; 7.5), multiplied by 10 to a whole power; "
    "scales of lengths by the standard row."
)
ALL = said(
    "The scale factors are chosen: μ = 1; 2; 2.5; 4; 5 (1.5; 7.5), multiplied by 10 to a whole power; scales "
    "of lengths by the standard row."
)
HANDED = said("Sheets: {listed}.")
NOTE = said("Explanatory note with the calculations.")
READINGS = said("Table of the lengths read off the drawing, for the check.")
BASE, HEIGHT = said("base {size}"), said("height {size}")
RATIO = said("scale {ratio}")
WORDS = {"base": BASE, "length": BASE, "height": HEIGHT}
"""Keys that are no letters."""
LETTERS = {
    "pi_a": "πa",
    "mu_theta": "μ_{θ}",
    "mu_phi": "μ_{φ}",
    "mu_dS": "μ_{S'}",
    "mu_ddS": "μ_{S''}",
}
"""Letters of keys, where these are not written as they are."""
KEPT = "\u00a0"
"""A space at which no line is broken."""
_QUANTITY = re.compile(r"\s*([+-]?[\d.,eE+-]+)\s*(.*)", re.DOTALL)
_RATIO = re.compile(r"\s*(\d+(?:[.,]\d+)?)\s*:\s*(\d+(?:[.,]\d+)?)\s*")


class Paragraphs(NamedTuple):
    """A heading (mark-up, "" for none) and the sentences below it, numbered on if they are to be."""

    heading: str
    sentences: tuple[str, ...]


def synthesis(scene: Scene) -> Iterator[Paragraphs]:
    """Yield which lengths are to be found, if the scene states a task that gives them."""
    found = read_synthesis(scene)
    if found is None:
        return
    names = [name for name, mark in found.lengths.items() if mark not in found.given]
    says = FOUND if len(names) > 1 else ONE_FOUND
    yield Paragraphs("", (speaking(scene.language)(says, listed=", ".join(map(indexed, names))),))


def orders(scene: Scene) -> Iterator[Paragraphs]:
    """Yield what is drawn, sheet by sheet; nothing is asked for twice."""
    _, known = speaking(scene.language), set[str]()
    for n, order in enumerate(scene.sheets, 1):
        told = [one for name in order.place for one in _asks(name, scene)]
        new = tuple(indexed(one) for one in dict.fromkeys(told) if one not in known)
        known.update(told)
        if not new:
            continue
        name = order.name or (scene.title_block.get("name", "") if len(scene.sheets) == 1 else "")
        form = _(ANY) if order.format == AUTO else order.format
        heading = _(NAMED if name else SHEET, number=n, format=form, name=name)
        yield Paragraphs(escape(heading), new)


def _asks(name: str, scene: Scene) -> Iterable[str]:
    """Return how a place is asked for: as its chapter does, as it says itself, as its parts, by its caption."""
    chapter, place = places()[name]
    language = scene.language
    wanted = TaskSheet.of(chapter).wanted.get(name)
    own = wanted(scene, language) if wanted else map(speaking(language), place.asks)
    told = [*own] or [one for part in place.together for one in _asks(part, scene)]
    if told or wanted or place.attends or name not in (words := captions(language)):
        return told
    return [f"{words[name]}."]


def conditions(scene: Scene) -> Iterator[str]:
    """Yield what the scene states besides (mark-up), nothing twice, but for what is asked anyway."""
    told = {one for order in scene.sheets for name in order.place for one in _asks(name, scene)}
    for chapter in chapters():
        for one in TaskSheet.of(chapter).stated(scene, scene.language):
            if one not in told:
                told.add(one)
                yield indexed(one)
    yield from map(indexed, scene.author.task)


def scales(scene: Scene, doc: Document) -> Iterator[str]:
    """Yield which scale factors are given, which lengths on the drawing, which are to be chosen (mark-up)."""
    _ = speaking(scene.language)
    words, found = captions(scene.language), dict[str, list[str]]()
    for section, name, value in _sizes(doc):
        found.setdefault(section, []).append(_sized(section, name, value, scene.language))
    for section, told in found.items():
        what = words.get(f"chapter {section}", words.get(section, ""))
        listed = "; ".join(told)
        own = what and section != SCALES
        yield f"{what}: {listed}." if own else _(FIXED, listed=listed)
    free = _free(scene, doc)
    if free:
        yield _(CHOSEN if len(free) > 1 else ONE_CHOSEN, listed=", ".join(free))
    yield _(OTHERS if found or free else ALL)


def _sizes(doc: Document) -> Iterator[tuple[str, str, object]]:
    """Yield the keys of a scene that fix how large something is drawn: section, key, value."""
    for section, table in doc.items():
        if not isinstance(table, Mapping):
            continue
        fixing = _fixing(section)
        for name, value in table.items():
            if name in fixing and isinstance(value, (str, int, float)):
                yield section, name, value


def _fixing(section: str) -> frozenset[str]:
    """Return the keys of a section that fix sizes of the drawing."""
    if section == SCALES:
        return frozenset(key for family in families().values() for key in family)
    found = (one for chapter in chapters() for one in chapter.sections if one.name == section)
    record = next((one.record for one in found), None)
    return frozenset(
        name
        for name, key in (keys_of(record) if record is not None else {}).items()
        if key.fixes == "size" or name.startswith("mu_")
    )


def _sized(section: str, name: str, value: object, language: str) -> str:
    """Return a size as a sheet tells it: μ_l = 0.0025 m/mm, H = 40 mm."""
    size = _quantity(value, language)
    if name == "mu_l" and _RATIO.fullmatch(str(value)):
        return speaking(language)(RATIO, ratio=size)
    if name in WORDS:
        return speaking(language)(WORDS[name], size=size)
    if section == SCALES and name == "mu_v" and not _QUANTITY.match(str(value)):
        return "μ_{v} = μ_{l}·ω_{1}"
    return f"{_letter(name, language)} = {size}".replace(" ", KEPT)


def _letter(name: str, language: str) -> str:
    if name in LETTERS:
        return LETTERS[name]
    stem = f"μ_{{{name[3:]}}}" if name.startswith("mu_") else name
    return markup(symbol(stem, language)) if "_" in stem else escape(stem)


def _quantity(value: object, language: str) -> str:
    """Return a value of a scene in the words of a language: "0.5 N*m/mm" as 0,5 Н·м/мм."""
    text = str(value)
    if ratio := _RATIO.fullmatch(text):
        return escape(f"{ratio[1]}:{ratio[2]}".replace(".", decimal_sign(language)))
    found = _QUANTITY.fullmatch(text)
    if found is None:
        return escape(text)
    try:
        size = number(float(found[1].replace(",", ".")), language, 6)
    except ValueError:
        return escape(text)
    own = plain_unit(found[2]).replace("*", "·").replace("^2", "²").replace("^3", "³")
    return escape(f"{size} {unit(own, language)}".strip())


def _free(scene: Scene, doc: Document) -> list[str]:
    """Return the scale factors of plans that the scene does not fix, as letters."""
    if scene.mechanism is None:
        return []
    table = doc.get(SCALES)
    told = table if isinstance(table, Mapping) else {}
    undrawn = () if scene.row.accelerations else ("accelerations",)
    return [
        _letter(family[0], scene.language)
        for plan, family in families().items()
        if plan not in undrawn and not any(key in told for key in family)
    ]


def families() -> dict[str, tuple[str, ...]]:
    """Return, by plan, the keys of [scales] of which one fixes its scale factor, that of μ first."""
    return {name: size.keys for name, size in all_sizes().items() if size.keys}


def handed(scene: Scene, *, readings: bool, drawn: bool) -> Iterator[str]:
    """Yield what is handed in (mark-up); ``drawn``: whether anything is calculated and measured for it."""
    _ = speaking(scene.language)
    formats = [_(ANY) if one.format == AUTO else one.format for one in scene.sheets]
    counted = [f"{formats.count(one)} × {one}" for one in dict.fromkeys(formats)]
    yield escape(_(HANDED, listed=", ".join(counted)))
    if drawn:
        yield _(NOTE)
    if drawn and readings:
        yield _(READINGS)


def numbered(some: Sequence[Paragraphs]) -> Iterator[Paragraphs]:
    """Yield the same, its sentences numbered from 1 on."""
    n = 0
    for one in some:
        lines = []
        for sentence in one.sentences:
            n += 1
            lines.append(f"{n}. {sentence}")
        yield Paragraphs(one.heading, tuple(lines))
