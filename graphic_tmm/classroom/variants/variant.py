"""A variant of a scene: its name and what it has instead of the scene's; and its own scene, as a text.

A variant is a text set into the text of the scene, so whatever a scene can say a variant can vary, and what is
wrong with it is told in the scene's own words, at the variant and the key that its author wrote.
"""

from __future__ import annotations

import re
from collections.abc import Callable
from pathlib import Path as File
from typing import NamedTuple

from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.scene.declare import Path
from graphic_tmm.scene.document import Document, document, quoted, spoken
from graphic_tmm.scene.lines import key_of
from graphic_tmm.scene.packaged import FILE, SCENE, scene_name
from graphic_tmm.scene.quantities import NUMBER
from graphic_tmm.scene.read import judged
from graphic_tmm.scene.records import Scene
from graphic_tmm.scene.splice import Unplaced, literal, set_to
from graphic_tmm.scene.units import UNITS, plain_unit
from graphic_tmm.scene.vary import place_of as place_in

LONGEST_NAME = 40
"""A variant's name has no more characters: files are called by it."""
_NAME = re.compile(rf"[\w][\w.-]{{0,{LONGEST_NAME - 1}}}")
_NUMBER = re.compile(rf"[+-]?{NUMBER}")
_WITH_UNIT = re.compile(rf"\s*{_NUMBER.pattern}(\s*\D.*)", re.DOTALL)


class Base(NamedTuple):
    """The scene that is varied: its file, its text, what that says."""

    file: File
    text: str
    doc: Document

    @property
    def name(self) -> str:
        """The name that its sheets bear."""
        return scene_name(str(self.file))


class Value(NamedTuple):
    """What a variant has at a key: as it was typed, in the ``unit`` of its column if that names one."""

    key: str
    typed: str
    unit: str = ""


class Variant(NamedTuple):
    """A variant: its name, its values, the line of the table that it stands in (0 if none)."""

    name: str
    values: tuple[Value, ...]
    line: int = 0


def base(place: File) -> Base:
    """Return the scene of a file, or of a folder that holds one, to be varied.

    Raises
    ------
    SceneError
        If it cannot be read, or is no TOML; whether it is a good scene is not asked.
    """
    file = place / FILE if place.is_dir() else place
    return Base(file, *document(file, SCENE))


def is_name(text: str) -> bool:
    """Whether a variant can be called so: letters, digits, ``_ . -``, as files are."""
    return _NAME.fullmatch(text) is not None


def source_of(of: Base, variant: Variant) -> File:
    """Return the file that a variant's scene would be: its sheets are called by it."""
    return of.file.with_name(f"{of.name}-{variant.name}.toml")


def place_of(of: Base, key: str) -> Path:
    """Return where a key of a table stands in the scene."""
    return place_in(of.doc, key)


def text_of(of: Base, variant: Variant, table: str = "") -> str:
    """Return the text of a variant's scene: that of the scene with its values set in it, its name in the title.

    ``table``: where the variant is from, for messages.

    Raises
    ------
    SceneError
        If a value cannot be set, or needs a unit that neither it nor the scene has there.
    """
    text, faults = of.text, list[Fault]()
    places = {value: place_of(of, value.key) for value in variant.values}
    first = {path: value for value, path in reversed(places.items())}
    for value, path in places.items():
        if first[path] is not value:
            says = said("this is the same key as {key}; keep one of them", key=first[path].key)
            faults.append(Fault(value.key, variant.line, says))
            continue
        try:
            text = set_to(text, path, _written(of, path, value))
        except Unplaced:
            says = said("the scene has no such key; write it as the scene does: OA, drive.speed")
            faults.append(Fault(value.key, variant.line, says))
        except ValueError as error:
            faults.append(Fault(value.key, variant.line, error.args[0]))
    if faults:
        raise SceneError(table or str(of.file), tuple(faults))
    if ("title",) in places.values() or not isinstance(of.doc.get("title"), str):
        return text
    says = said("{title}. Variant {name}", title=of.doc["title"], name=variant.name)
    titled = speaking(spoken(of.text))(says)
    return set_to(text, ("title",), quoted(titled))


def scene_of(
    of: Base,
    variant: Variant,
    table: str = "",
    *,
    missing: Callable[[str], str] = lambda text: "",
) -> Scene:
    """Return the scene of a variant; ``table`` as for `text_of`, ``missing`` as for `scene.read.read`.

    Raises
    ------
    SceneError
        If a value cannot be set, or the scene is not good then: every fault, at the variant's line of the table
        and the key that stands there, if it has one.
    """
    data = text_of(of, variant, table).encode("utf-8")
    try:
        return judged(data, source_of(of, variant), missing=missing)
    except SceneError as error:
        if not table:
            raise
        raise SceneError(table, tuple(_at(of, variant, one) for one in error.faults)) from None


def _at(of: Base, variant: Variant, fault: Fault) -> Fault:
    """Return a fault of a variant's scene as one of its table."""
    keys = {key_of(of.doc, place_of(of, one.key)): one.key for one in variant.values}
    key = keys.get(fault.key, fault.key)
    says = said("variant {name}: {says}", name=variant.name, says=fault.message)
    return Fault(key, variant.line, says)


def _written(of: Base, path: Path, value: Value) -> str:
    """Return a value as TOML writes it; ValueError tells why it is none."""
    typed = " ".join(value.typed.split())
    there = _there(of.doc, path)
    if not _NUMBER.fullmatch(typed):
        return typed if isinstance(literal(typed), (bool, list)) else quoted(typed)
    if value.unit:
        return quoted(f"{typed} {value.unit}")
    if isinstance(there, str):
        unit = _WITH_UNIT.fullmatch(there)
        if unit is None or plain_unit(unit[1]) not in UNITS:
            raise ValueError(
                said(
                    'the scene has "{text}" there: write the value with its unit, "110 mm"',
                    text=there,
                )
            )
        return quoted(f"{typed}{unit[1]}")
    point = typed.replace(",", ".")
    return point if literal(point) is not None else quoted(typed)


def _there(doc: Document, path: Path) -> object:
    """Return what stands at a path; None if nothing."""
    at: object = doc
    for part in path:
        try:
            at = at[part]  # type: ignore[index]
        except (KeyError, IndexError, TypeError):
            return None
    return at
