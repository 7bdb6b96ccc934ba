"""A value of a scene as the field of a form: what its declaration tells a person who sets it."""

from __future__ import annotations

from dataclasses import MISSING
from typing import NamedTuple

from graphic_tmm.language.said import Said, joined
from graphic_tmm.scene.declare import Key, Kind, Path, Sort
from graphic_tmm.scene.document import default_text
from graphic_tmm.scene.quantities import noun_of


class Field(NamedTuple):
    """A value that may be set.

    ``path``: in the parsed document; ``key``: as people write it. ``text``: what the file has, "" where it has
    nothing (``written`` is False then); ``in_quotes``: it is a text there. ``unit``: what is wanted, in words.
    ``kind``: "quantity", "number", "switch", "choice" (one of ``choices``), "list", "text", or "other".
    ``default``: what holds where nothing is written, "" for none. ``wanted``: it has to be written.
    """

    path: Path
    key: str
    label: str
    text: str
    written: bool
    in_quotes: bool
    kind: str
    unit: Said | str = ""
    choices: tuple[str, ...] = ()
    default: str = ""
    says: str = ""
    wanted: bool = False


def blank(sort: Sort | None, declared: Key | None) -> Field:
    """Return a field in which nothing is written yet."""
    kind = sort if isinstance(sort, Kind) else None
    form, choices = _form_of(kind) if kind is not None else ("other", ())
    made = Field((), "", "", "", False, False, form, _unit(kind) if kind else "", choices)
    if declared is None:
        return made
    wanted = declared.default is MISSING
    default = "" if wanted else default_text(declared) or ""
    return made._replace(default=default.strip('"'), says=declared.says, wanted=wanted)


def _form_of(kind: Kind) -> tuple[str, tuple[str, ...]]:
    """Return what a field of a kind is, and what can be chosen in it."""
    told = kind.schema({})
    if "enum" in told:
        return "choice", tuple(told["enum"])
    shapes = {str(one.get("type")) for one in (told, *told.get("anyOf", ()))} - {"None"}
    if "boolean" in shapes:
        return "switch", ("true", "false")
    if "array" in shapes:
        return "list", ()
    if noun_of(kind.unit):
        return "quantity", ()
    if kind.bound is not None:
        return "number", ()
    return ("text" if shapes == {"string"} else "other"), ()


def _unit(kind: Kind) -> Said | str:
    """Return what is wanted, in words: a length; a whole number 1 to 12."""
    noun = noun_of(kind.unit)
    scale = kind.unit.startswith("scale")
    bound = kind.bound.wanted if kind.bound is not None and not scale else ""
    return joined(": ", tuple(filter(None, (noun, bound))))
