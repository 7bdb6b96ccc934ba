"""What a task gives of a mechanism, for the panel beside its scheme: lengths, then the rest."""

from __future__ import annotations

import re
from collections.abc import Iterator, Mapping
from pathlib import Path as File
from typing import Any

from graphic_tmm.language.catalogue import Speech
from graphic_tmm.language.said import said
from graphic_tmm.scene.declare import Path
from graphic_tmm.scene.document import Document, as_table
from graphic_tmm.scene.moved import uses
from graphic_tmm.scene.quantities import in_si
from graphic_tmm.scene.sections import LENGTHS
from graphic_tmm.serve.form import Field, choices_in, form
from graphic_tmm.serve.plainly import clause
from graphic_tmm.serve.scheme.drives import tables_of_drives
from graphic_tmm.serve.scheme.effects import effect_fields
from graphic_tmm.serve.scheme.units import unit_shown

OF_LINKS = ("name", "mass", "J")
OF_DRIVE = ("speed", "turns", "from", "to", "at", "positions", "accelerations")
"""What a task gives besides lengths, and nothing can be drawn without, or is drawn otherwise."""
OF_ITS_LINK = ("speed", "turns")
"""Of these it is said whose they are: the link that is driven."""
ZERO = re.compile(r"[+-]?0(?:\.0*)?(?:\s.*)?")


def scheme_fields(data: bytes, doc: Document, file: File, speech: Speech) -> list[dict[str, Any]]:
    """Return the fields of a scheme as JSON takes them; ``name``: of a length that stands elsewhere, too."""
    text = data.decode()
    fields = [one for group in form(data, file) for one in group.fields]
    found = [
        *(_json(one, "length", label, text, doc, speech) for one, label in _lengths(fields, doc)),
        *(
            _json(one, "given", label, text, doc, speech)
            for one, label in _given(fields, doc, speech)
        ),
        *(
            _json(one, "given", speech(label), text, doc, speech)
            for one, label in effect_fields(fields, doc)
        ),
    ]
    return found


def _json(
    field: Field, kind: str, label: str, text: str, doc: Document, speech: Speech
) -> dict[str, Any]:
    place = field.path[:2]
    link = doc["link"][place[1]].get("number") if place[0] == "link" else None
    if place[0] == "drive" and isinstance(doc.get("drive"), list):
        link = tables_of_drives(doc)[int(place[1])].get("link")
    choices = choices_in(field, speech.language)
    named = field.text in as_table(doc.get(LENGTHS)) and len(uses(text, field.path)) > 1
    return {
        "key": field.key,
        "kind": kind,
        "label": label,
        "text": field.text or _holding(field, choices),
        "link": link,
        "name": f"{LENGTHS}.{field.text}" if named else "",
        "choices": choices,
        "placeholder": field.default,
        "unit": unit_shown(field, doc, speech.language),
        "says": speech(field.says),
    }


def _holding(field: Field, choices: list[str]) -> str:
    """Return the choice that holds where none is written: the default, in a language the first."""
    return field.default if field.default in choices else next(iter(choices), "")


def _lengths(fields: list[Field], doc: Document) -> Iterator[tuple[Field, str]]:
    """Yield named lengths, those of links, then what places points and guides of the frame."""
    yield from ((one, str(one.path[1])) for one in fields if one.path[0] == LENGTHS)
    for field in fields:
        match field.path:
            case ("link", int(k), "points", str(letter), int(axis)):
                points = doc["link"][k]["points"]
                if not ZERO.fullmatch(field.text):
                    yield field, _of_point(points, letter, axis)
            case ("link", int(k), "slides" | "weld", *_) if field.written and field.path[-1] in (
                "offset",
                "angle",
            ):
                label = "∠" if "weld" in field.path else field.label
                yield field, f"{doc['link'][k].get('number')}: {label}"
    for field in fields:
        match field.path:
            case ("frame" | "joints", str(letter), int(axis)):
                if not ZERO.fullmatch(field.text):
                    yield field, f"{'XY'[axis]} {letter}"
            case ("frame", str(name), "through", int(axis)) if not (
                ZERO.fullmatch(field.text) or _is_along(doc["frame"][name], axis)
            ):
                yield field, f"{name}-{name}: {'XY'[axis]}"
            case ("frame", str(name), "angle"):
                yield field, f"{name}-{name}: ∠"


def _of_point(points: Mapping[str, Any], letter: str, axis: int) -> str:
    """Return what a coordinate of a link's point is called: a length from letter to letter where it is one."""
    zero = [one for one, place in points.items() if _is_zero(place, 0) and _is_zero(place, 1)]
    if axis == 0 and _is_zero(points[letter], 1) and zero:
        return f"{zero[0]}{letter}"
    return f"{letter}, {'xy'[axis]}"


def _is_along(guide: Mapping[str, Any], axis: int) -> bool:
    """Whether a guide lies along an axis of the paper: where on that it begins is nothing to it."""
    try:
        return in_si(str(guide.get("angle")), "angle") % 180.0 == (0.0, 90.0)[axis]
    except ValueError:
        return False


def _is_zero(place: Any, axis: int) -> bool:
    return bool(ZERO.fullmatch(str(place[axis])))


def _given(fields: list[Field], doc: Document, speech: Speech) -> Iterator[tuple[Field, str]]:
    """Yield what is given of the drive, then of links."""
    drives = tables_of_drives(doc)
    for field in fields:
        if _is_of_drive(field.path, drives[0]):
            whose = len(drives) > 1 or field.path[-1] in OF_ITS_LINK
            yield (
                field,
                _of_link(field, drives, "link", speech) if whose else clause(speech(field.says)),
            )
    for field in fields:
        match field.path:
            case ("link", int(_), str(key)) if key in OF_LINKS:
                yield field, _of_link(field, doc["link"], "number", speech)


def _of_link(field: Field, tables: list[Document], key: str, speech: Speech) -> str:
    """Return what a field is, with the link whose it is: that of its table, at a key."""
    at = field.path[1]
    number = tables[at if isinstance(at, int) else 0].get(key)
    return speech(said("link {number}: {what}", number=number, what=clause(speech(field.says))))


def _is_of_drive(path: Path, first: Document) -> bool:
    slides = "from" in first
    match path:
        case ("drive", str(key)) | ("drive", int(_), str(key)):
            return key in OF_DRIVE and (key not in ("from", "to") or slides)
    return False
