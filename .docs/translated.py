"""Texts that the site has in more languages than the package: paragraph by paragraph, by a catalogue here.

The package shows none of them, so its own catalogue has them not. A paragraph that is not in the catalogue,
because it is new or was changed, ends the building: no page falls back to English.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path

from words import Language

from graphic_tmm import read
from graphic_tmm.language.catalogue import read_catalogue

_BREAK = re.compile(r"(\n\s*\n|\n(?=- ))")
_START = re.compile(r"\s*(?:- )?")


def paragraphs(text: str) -> list[str]:
    """Return the paragraphs of a text and the items of its lists, each as one line."""
    return [_line(part) for part in _BREAK.split(text)[::2]]


def translated(text: str, language: Language, source: str = "en") -> str:
    """Return a text in a language, its paragraphs, lists and indents as they were."""
    if language == source:
        return text
    known = catalogue(language)
    parts = _BREAK.split(text)
    for k in range(0, len(parts), 2):
        line = _line(parts[k])
        if line not in known:
            raise LookupError(f"{language}.po has no text for: {line}")
        parts[k] = _START.match(parts[k])[0] + known[line]  # type: ignore[index]
    return "".join(parts)


def titled(name: str, language: Language) -> str:
    """Return the title of a scene of the package."""
    scene = read(name)
    return translated(scene.title, language, scene.language)


@cache
def catalogue(language: Language) -> Mapping[str, str]:
    """Return the paragraphs of a language by those of the source."""
    texts = read_catalogue(Path(__file__).parent / f"{language}.po").texts
    return {original: forms[0] for (_, original), forms in texts.items()}


def _line(part: str) -> str:
    return re.sub(r"\s*\n\s*", " ", _START.sub("", part, count=1).rstrip())
