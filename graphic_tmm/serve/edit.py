"""Values of a scene set in its file: comments and layout stay, no fault is written in.

What is typed in a field of the form (`form.py`) becomes a value of TOML; the new text is read as any scene.
A fault that was not there before refuses the whole change, in the scene's own words.
"""

from __future__ import annotations

import codecs
import re
from collections.abc import Callable, Collection, Mapping
from pathlib import Path as File
from typing import NoReturn

from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.language.said import said
from graphic_tmm.scene.document import parsed, quoted
from graphic_tmm.scene.packaged import SCENE
from graphic_tmm.scene.read import judged
from graphic_tmm.scene.splice import Unplaced, literal, set_to
from graphic_tmm.scene.vary import path_of
from graphic_tmm.serve.form import Field, form

MOST = 200
"""So many values may be set at once."""
LONGEST_KEY = 60
_COMMA = re.compile(r"([+-]?[0-9]+),([0-9]+)")
_ROW = re.compile(r"[0-9]+\*?(?:\s*,\s*[0-9]+\*?)*")
_LONE = re.compile(r"[\ud800-\udfff]")
Missing = Callable[[str], str]


def edited(
    data: bytes, changes: Mapping[str, str], file: File, missing: Missing = lambda text: ""
) -> bytes:
    """Return what a scene's file holds with values set in it, all of them or none.

    Parameters
    ----------
    data : bytes
        What it holds.
    changes : mapping of str to str
        What was typed, by the field's key; "" takes a key out.
    file : Path
        Where it stands, for messages.
    missing : callable
        As for `scene.read.read`.

    Raises
    ------
    SceneError
        If the file is no TOML, or a change is refused.
    """
    mark = codecs.BOM_UTF8 if data.startswith(codecs.BOM_UTF8) else b""
    text, _ = parsed(data, file)
    if len(changes) > MOST:
        _refuse(file, "", said("too many values at once; {most} at most", most=MOST))
    fields = _fields(text, file)
    for key, typed in changes.items():
        before, text = text, _with(text, fields.get(key), key, typed, file)
        fields = fields if text == before else _fields(text, file)
    new = mark + text.encode("utf-8")
    if len(new) > SCENE.largest:
        _refuse(file, "", said("the file would become too large for a scene"))
    if new != data:
        _judge(data, new, changes, file, missing)
    return new


def _fields(text: str, file: File) -> dict[str, Field]:
    data = text.encode("utf-8")
    return {one.key: one for group in form(data, file) for one in group.fields}


def _with(text: str, field: Field | None, key: str, typed: str, file: File) -> str:
    """Return the text with one value set as it was typed; ``field``: that of its key, if it has one."""
    if _LONE.search(typed) or _LONE.search(key):
        _refuse(file, "", said("this text holds half of a character; type it again"))
    if field is not None and field.text == typed and (field.written or not typed):
        return text
    _, doc = parsed(text.encode(), file)
    path = field.path if field is not None else path_of(doc, key)
    out = field is not None and not typed.strip() and isinstance(path[-1], str)
    try:
        if out:
            assert field is not None
            return set_to(text, path, None) if field.written else text
        return set_to(text, path, source_of(typed, field, text))
    except Unplaced:
        _refuse(file, key, said("this cannot be set here; change it in the file itself"))


def source_of(typed: str, field: Field | None, text: str) -> str:
    """Return what was typed as TOML writes it: a text in quotes, or as it stands."""
    typed = typed.replace("\r\n", "\n").strip()
    if field is None:
        return typed if literal(typed) is not None else quoted(typed)
    if field.kind in ("text", "choice"):
        return quoted(typed)
    value = literal(typed)
    if field.kind == "switch":
        return typed if isinstance(value, bool) else quoted(typed)
    if field.kind == "list":
        newline = "\r\n" if "\r\n" in text else "\n"
        if _ROW.fullmatch(typed):
            names = (one.strip() for one in typed.split(","))
            return f"[{', '.join(one if one.isdigit() else quoted(one) for one in names)}]"
        return typed.replace("\n", newline) if isinstance(value, list) else quoted(typed)
    return _number(typed, value, field)


def _number(typed: str, value: object, field: Field) -> str:
    """Return a figure as TOML writes it; one that had a unit in the file keeps its quotes: it needs one."""
    if field.kind == "quantity" and field.in_quotes:
        return quoted(typed)
    if comma := _COMMA.fullmatch(typed):
        point = f"{comma[1]}.{comma[2]}"
        return point if literal(point) is not None else quoted(typed)
    plain = isinstance(value, (int, float)) and not isinstance(value, bool)
    return typed if plain else quoted(typed)


def _judge(
    before: bytes, after: bytes, changes: Mapping[str, str], file: File, missing: Missing
) -> None:
    """Refuse a text with a fault that was not there before, or with one at a key that was set."""
    new = new_faults(before, after, file, missing, changes)
    if new:
        raise SceneError(str(file), new)


def new_faults(
    before: bytes,
    after: bytes,
    file: File,
    missing: Missing = lambda text: "",
    changed: Collection[str] = (),
) -> tuple[Fault, ...]:
    """Return the faults that a text has, and another had not; ``changed``: those of these keys all the same."""
    had = {(fault.key, fault.message) for fault in _faults(before, file, missing)}
    return tuple(
        fault
        for fault in _faults(after, file, missing)
        if (fault.key or fault.line)
        and ((fault.key, fault.message) not in had or fault.key in changed)
    )


def _faults(data: bytes, file: File, missing: Missing) -> tuple[Fault, ...]:
    try:
        judged(data, file, missing=missing)
    except SceneError as error:
        return error.faults
    return ()


def _refuse(file: File, key: str, message: str) -> NoReturn:
    raise SceneError(str(file), (Fault(key[:LONGEST_KEY], 0, message),))
