"""Values that were changed in a scene's page, written into its file: what they leave alone stays as it is."""

from __future__ import annotations

import tomllib
from collections.abc import Mapping
from pathlib import Path as File
from typing import Any

from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.said import Said, said
from graphic_tmm.scene.document import as_table
from graphic_tmm.scene.moved import rewritten
from graphic_tmm.scene.splice import Unplaced
from graphic_tmm.scene.units import UNITS, plain_unit
from graphic_tmm.serve.edit import edited
from graphic_tmm.serve.scheme.units import own_unit

OF_MECHANISM = ("frame", "link", "drive")
"""Sections that say how a mechanism is put together: changed as a whole."""
SCALARS = ("speed", "mass", "J")
"""What a page tells in SI, whatever unit the file has."""


def with_own_values(text: str, told: str, file: File) -> str:
    """Return a scene's text with the values that its page tells as TOML.

    Raises
    ------
    SceneError
        If that is no such TOML, or the text cannot take it.
    """
    doc = tomllib.loads(text)
    try:
        own = tomllib.loads(told)
        text = rewritten(text, _tables(doc, own))
        others = {
            f"{name}.{key}": str(value)
            for name, table in own.items()
            if name not in OF_MECHANISM
            for key, value in table.items()
        }
        return edited(text.encode(), others, file).decode() if others else text
    except (Unplaced, RecursionError, LookupError, AttributeError, TypeError, ValueError) as error:
        says = said("this cannot be set here; change it in the file itself")
        raise SceneError(str(file), (Fault("", 0, _lies(doc) or says),)) from error


def _tables(doc: Mapping[str, Any], own: Mapping[str, Any]) -> dict[str, Any]:
    """Return the tables of a scene with what is told of them."""
    links = {one["number"]: one for one in own.get("link", ())}
    tables: dict[str, Any] = {}
    if "frame" in own:
        tables["frame"] = {**doc["frame"], **own["frame"]}
    if links:
        tables["link"] = [_merged(one, links.get(one.get("number"), {})) for one in doc["link"]]
    if "drive" in own:
        drive = doc["drive"]
        first, more = (drive[0], drive[1:]) if isinstance(drive, list) else (drive, [])
        merged = _merged(first, own["drive"])
        tables["drive"] = [merged, *more] if isinstance(drive, list) else merged
    return tables


def _merged(there: Mapping[str, Any], own: Mapping[str, Any]) -> dict[str, Any]:
    made = {**there, **own}
    for key in own.keys() & set(SCALARS):
        made[key] = _as_there(own[key], there.get(key))
    if "points" in own:
        made["points"] = {**there["points"], **own["points"]}
    return made


def _as_there(value: Any, there: Any) -> Any:
    """Return a number in SI in the unit that the file has; a mass stays one where a weight stood."""
    unit, own = own_unit(str(there)), own_unit(str(value))
    known = UNITS.get(plain_unit(unit))
    if known is None or (own and UNITS[plain_unit(own)].dimension != known.dimension):
        return value
    return f"{float(str(value).split()[0]) / float(known.factor):.12g} {unit}"


def _lies(doc: Mapping[str, Any]) -> Said | None:
    """Return what is said of lengths that follow from places; None where they stand themselves."""
    by_place = any(isinstance(as_table(one).get("points"), list) for one in doc.get("link", ()))
    if not by_place:
        return None
    return said("lengths follow from [joints] here: move the pins in the scheme instead")
