"""The text of a file that somebody saved: UTF-8, UTF-16 or Windows-1251, with or without a mark of order."""

from __future__ import annotations

import codecs
import re
from pathlib import Path
from typing import NoReturn

from graphic_tmm.errors import Fault, SceneError
from graphic_tmm.files import Kind, read
from graphic_tmm.language.said import said

READINGS = Kind(said("a file of readings"), said("name a CSV or xlsx file of readings"), 8_000_000)
_BOMS = (
    (codecs.BOM_UTF8, "utf-8"),
    (codecs.BOM_UTF32_LE, "utf-32-le"),  # before UTF-16, whose mark is its beginning
    (codecs.BOM_UTF32_BE, "utf-32-be"),
    (codecs.BOM_UTF16_LE, "utf-16-le"),
    (codecs.BOM_UTF16_BE, "utf-16-be"),
)
_CONTROL = re.compile("[\x00-\x08\x0e-\x1f\x7f]")
NO_BOOK = said("this is no xlsx workbook, or a damaged one; save the sheet as CSV or xlsx")
_NO_TEXT = said("this is not a text; save the table as CSV with the encoding UTF-8")


def text_of(file: Path) -> str:
    """Return the text of a file, its encoding found out.

    Raises
    ------
    SceneError
        If it cannot be read (as `files.read`), or is not a text.
    """
    return decoded(file, read(file, READINGS))


def decoded(file: Path, data: bytes) -> str:
    """Return the text of the bytes of a file; raises as `text_of` if they are none."""
    for encoding in _encodings(data):
        try:
            text = codecs.decode(data, encoding).lstrip("\ufeff").rstrip("\x1a")
        except UnicodeDecodeError:
            continue
        found = _CONTROL.search(text)
        if found is None:
            return text
        _refuse(file, _none(file), text.count("\n", 0, found.start()) + 1)
    _refuse(file, _none(file))


def _encodings(data: bytes) -> tuple[str, ...]:
    """Return the encodings that the bytes may be in, the likeliest first."""
    for mark, encoding in _BOMS:
        if data.startswith(mark):
            return (encoding,)
    if b"\0" in data:  # every Latin letter of UTF-16 has one, at the odd or at the even places
        little = data[1::2].count(0) > data[::2].count(0)
        return ("utf-16-le" if little else "utf-16-be",)
    return "utf-8", "cp1251"


def _none(file: Path) -> str:
    """Return what is told of a file that is neither a text nor a workbook."""
    return NO_BOOK if file.suffix.lower() == ".xlsx" else _NO_TEXT


def _refuse(file: Path, message: str, line: int = 0) -> NoReturn:
    raise SceneError(str(file), (Fault("", line, message),)) from None
