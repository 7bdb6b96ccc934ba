"""Units of what is typed bare beside a scheme: that which the field has, else the usual one."""

from __future__ import annotations

import re

from graphic_tmm.language.units import unit
from graphic_tmm.scene.declare import Path
from graphic_tmm.scene.document import Document, as_table
from graphic_tmm.scene.quantities import NUMBER, PAPER, spoken
from graphic_tmm.scene.sections import LENGTHS
from graphic_tmm.scene.units import UNITS, plain_unit, si_unit
from graphic_tmm.serve.form import Field

_BARE = re.compile(rf"[+-]?{NUMBER}")
_WITH_UNIT = re.compile(rf"[+-]?{NUMBER}(.*)", re.DOTALL)
_USUAL = {"length": "mm", PAPER: "mm"}
"""What is meant where nothing but a 0 or a name is written, if not SI."""
_SLID = {"angular speed": "speed", "angle": "length"}
"""What a quantity of a drive is where its link slides."""


def own_unit(text: str) -> str:
    """Return the unit of a text that is a number with one, as it is spelled there; "" of any other."""
    found = _WITH_UNIT.fullmatch(spoken(text))
    return found[1].strip() if found and plain_unit(found[1]) in UNITS else ""


def unit_of_field(field: Field, doc: Document) -> str:
    """Return the unit that a bare number has in a field: its own, that of the name there, SI, or the usual one.

    "" where it needs none. A number that the file has without a unit is in SI.
    """
    named = as_table(doc.get(LENGTHS)).get(field.text, field.text)
    if own := own_unit(str(named)):
        return own
    dimension = field.dimension
    if _is_of_slider(field.path, doc):
        dimension = _SLID.get(dimension, dimension)
    si = not field.in_quotes and _BARE.fullmatch(field.text) and float(field.text) != 0
    return ("" if si else _USUAL.get(dimension, "")) or si_unit(dimension)


def unit_shown(field: Field, doc: Document, language: str) -> str:
    """Return the unit that stands beside a field: that of a bare number, where its text has none."""
    if own_unit(field.text):
        return ""
    meant = unit_of_field(field, doc)
    return "°" if meant == "deg" else unit(plain_unit(meant), language)


def is_bare(typed: str) -> bool:
    """Whether a text is a number without a unit."""
    return bool(_BARE.fullmatch(spoken(typed)))


def with_unit(typed: str, field: Field, doc: Document) -> str:
    """Return what was typed, a bare number with the unit that it has in this field."""
    if field.kind != "quantity" or not is_bare(typed):
        return typed
    return f"{spoken(typed)} {unit_of_field(field, doc)}".strip()


def _is_of_slider(path: Path, doc: Document) -> bool:
    """Whether a field is of a drive whose link slides."""
    match path, doc.get("drive"):
        case ("drive", int(k), _), list(drives):
            number = as_table(drives[k]).get("link")
        case ("drive", _), dict(drive):
            number = drive.get("link")
        case _:
            return False
    links = (as_table(one) for one in doc.get("link", ()))
    return any("slides" in one for one in links if one.get("number") == number)
