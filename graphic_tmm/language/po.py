"""Catalogues as gettext writes them (``.po``), read without a build step.

Only what a catalogue holds is read: context, text, its plural, the translations. Babel reads the same and more,
and takes five times as long to be imported as this takes for the whole catalogue; the tests hold one against
the other.
"""

from __future__ import annotations

import json
from collections.abc import Iterator, Mapping
from pathlib import Path
from typing import NamedTuple

Key = tuple[str, str]
"""Context ("" if none) and English text."""


class Catalogue(NamedTuple):
    """``texts``: the translations of each text, one for each plural form; ``plurals``: the header's rule."""

    texts: Mapping[Key, tuple[str, ...]]
    plurals: str


def read(path: Path) -> Catalogue:
    """Return the catalogue in a file; what is marked as fuzzy or not translated is left out."""
    texts: dict[Key, tuple[str, ...]] = {}
    plurals = "n != 1"
    for entry in _entries(path.read_text(encoding="utf-8")):
        told = tuple(text for field, text in entry.items() if field.startswith("msgstr"))
        if not entry["msgid"]:
            _, _, rule = told[0].partition("plural=")
            plurals = rule.partition(";")[0] or plurals
        elif all(told):
            texts[entry.get("msgctxt", ""), entry["msgid"]] = told
    return Catalogue(texts, plurals)


def _entries(text: str) -> Iterator[dict[str, str]]:
    """Yield the fields of every entry, an empty line behind each."""
    entry: dict[str, str] = {}
    field, fuzzy = "", False
    for line in (*text.splitlines(), ""):
        if not line:
            if entry and not fuzzy:
                yield entry
            entry, fuzzy = {}, False
        elif line.startswith("#"):
            fuzzy = fuzzy or (line.startswith("#,") and "fuzzy" in line)
        elif line.startswith('"'):
            entry[field] += _plain(line)
        else:
            field, _, quoted = line.partition(" ")
            entry[field] = _plain(quoted)


def _plain(quoted: str) -> str:
    return json.loads(quoted) if "\\" in quoted else quoted[1:-1]
