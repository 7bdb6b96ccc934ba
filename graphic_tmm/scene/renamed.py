"""A scene's text whose letters or link numbers are others: wherever its declarations say that one stands."""

from __future__ import annotations

import tomllib
from collections.abc import Iterator
from contextlib import suppress
from itertools import count
from typing import Any, NamedTuple, NoReturn

from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.said import said
from graphic_tmm.scene import letters
from graphic_tmm.scene.declare import Kind, Path, Renaming, Sort, keys_of
from graphic_tmm.scene.document import Document, quoted
from graphic_tmm.scene.lines import layout
from graphic_tmm.scene.meaning import inner, shaped, sort_of
from graphic_tmm.scene.moved import MARK
from graphic_tmm.scene.references import MECHANISM, no_link, number_taken, outline, unknown_letters
from graphic_tmm.scene.sections import LENGTHS
from graphic_tmm.scene.splice import set_to, with_key
from graphic_tmm.scene.tables import DeclaredTable, Named, Several
from graphic_tmm.scene.values import LINK_NUMBER


class _Spot(NamedTuple):
    """A key or a value that names something; ``known``: what it is called now."""

    path: Path
    is_key: bool
    known: Any
    sort: Sort | None


def relettered(text: str, old: str, new: str) -> str:
    """Return a scene's text in which a point or a guide has another letter; comments and titles stay.

    Raises
    ------
    SceneError
        If there is no such letter, or the new one is none, is taken, or would be taken for another.
    Unplaced
        If the layout of the text cannot be followed.
    """
    doc = tomllib.loads(text.removeprefix(MARK))
    points, guides = _letters(doc)
    if unknown := list(unknown_letters((), (old[:20],), (*points, *guides), MECHANISM)):
        _refuse(*(one.message for one in unknown))
    if new == old:
        return text
    if fault := letters.letter_fault(new, pole=old in points):
        _refuse(fault)
    if new in (*points, *guides):
        _refuse(said('"{letter}" stands for something else already', letter=new))
    for other in points if old in points else ():
        if other != old and (fault := letters.clash(other, new)):
            _refuse(fault)
    return _renamed(text, {old: new})


def renumbered(text: str, old: int, new: int) -> str:
    """Return a scene's text in which a link, or the frame, has another number.

    Raises
    ------
    SceneError
        If there is no such link, or the new number is none or taken.
    Unplaced
        If the layout of the text cannot be followed.
    """
    names = outline(tomllib.loads(text.removeprefix(MARK)))
    if old not in names.bodies:
        _refuse(*(one.message for one in no_link((), old, names)))
    if new == old:
        return text
    try:
        LINK_NUMBER.read(new, {})
    except ValueError as error:
        _refuse(error.args[0])
    if new in names.bodies:
        _refuse(number_taken(new, names))
    return _renamed(text, {old: new})


def exchanged(text: str, one: int | str, other: int | str) -> str:
    """Return a scene's text in which two links have each other's numbers, or two points each other's letters.

    Where the text has one alone, that gets the other name, as `renumbered` and `relettered`; a text that has
    neither stays: they are of what is drawn and no scene yet.

    Raises
    ------
    SceneError, Unplaced
        As they do.
    """
    doc = tomllib.loads(text.removeprefix(MARK))
    points, guides = _letters(doc)
    there = outline(doc).bodies if isinstance(one, int) else (*points, *guides)
    if one not in there:
        one, other = other, one
    if one not in there:
        return text
    if isinstance(one, int):
        both = other in there
        return (
            _renamed(text, {one: other, other: one}) if both else renumbered(text, one, int(other))
        )
    if one == other or not (one in points and other in points):
        return relettered(text, one, str(other))
    # a table cannot have a key twice, not even for a moment
    free = next(
        letter for letter in map("Z{}".format, count(1)) if letter not in {*points, *guides}
    )
    for was, now in ((one, free), (other, one), (free, other)):
        text = _renamed(text, {was: now})
    return text


def _refuse(*messages: str) -> NoReturn:
    raise SceneError("", tuple(Fault("", 0, message) for message in messages))


def _renamed(text: str, names: Renaming) -> str:
    """Return a text with other names in values, then in keys, the innermost first."""
    if text.startswith(MARK):
        return MARK + _renamed(text.removeprefix(MARK), names)
    keys = list[tuple[Path, str]]()
    for spot in _spots(tomllib.loads(text)):
        new = spot.known
        with suppress(ValueError):
            if isinstance(spot.sort, Kind) and spot.sort.renamed is not None:
                new = spot.sort.renamed(spot.known, names)
            elif spot.is_key or isinstance(spot.sort, Named):
                new = letters.renamed(spot.known, names)
        if new == spot.known:
            continue
        if spot.is_key:
            keys.append((spot.path, new))
        else:
            text = _with_value(text, spot.path, spot.known, new)
    for path, key in sorted(keys, key=lambda one: -len(one[0])):
        text = with_key(text, path, key)
    return text


def _with_value(text: str, path: Path, old: Any, new: Any) -> str:
    """Return a text with another value, of a list with those of its items that are others, in their quotes."""
    if isinstance(old, list):
        for k, (was, will) in enumerate(zip(old, new, strict=True)):
            text = _with_value(text, (*path, k), was, will) if was != will else text
        return text
    begin, end = layout(text).values.get(path, (0, 0))
    source = text[begin:end]
    if isinstance(new, int):
        return set_to(text, path, str(new))
    plain = source[1:-1] == old
    return set_to(text, path, f"{source[0]}{new}{source[0]}" if plain else quoted(new))


def _spots(doc: Document) -> Iterator[_Spot]:
    """Yield the keys of a document that are letters or guides, and all values that are no tables."""
    for section, value in doc.items():
        sort = sort_of(section)
        if section != LENGTHS and sort is not None:
            yield from _within(sort, value, (section,))


def _within(sort: Sort | None, value: Any, path: Path) -> Iterator[_Spot]:
    sort = shaped(sort, value)
    if isinstance(value, dict):
        for key, one in value.items():
            if isinstance(sort, Named) or _is_free(sort, key):
                yield _Spot((*path, key), True, key, sort)
            yield from _within(inner(sort, value, key), one, (*path, key))
    elif isinstance(value, list) and (
        _is_of_names(sort) or any(isinstance(one, dict) for one in value)
    ):
        for k, one in enumerate(value):
            yield from _within(inner(sort, value, k), one, (*path, k))
    elif sort is not None:
        yield _Spot(path, False, value, sort)


def _is_of_names(sort: Sort | None) -> bool:
    """Whether a list is one of names, each a value of its own."""
    return (
        isinstance(sort, Several) and isinstance(sort.each, Kind) and sort.each.renamed is not None
    )


def _is_free(sort: Sort | None, key: str) -> bool:
    """Whether a key of a table is none that it declares, but a name."""
    named = isinstance(sort, DeclaredTable) and getattr(sort.record, "OTHERS", None) is not None
    return named and isinstance(sort, DeclaredTable) and key not in keys_of(sort.record)


def _letters(doc: Document) -> tuple[list[str], list[str]]:
    """Return the letters of points and the names of guides of a document."""
    names = outline(doc)
    listed = [
        letter
        for spot in _spots(doc)
        if isinstance(spot.sort, Named) and isinstance(spot.known, list)
        for letter in spot.known
    ]
    guides = [name for body in names.bodies.values() for name in body.guides]
    return list(dict.fromkeys([*names.letters, *listed, *doc.get("joints", {})])), guides
