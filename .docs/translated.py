"""Texts that the site has in more languages than the package: paragraph by paragraph, by a catalogue here.

The package shows none of them, so its own catalogue has them not. A paragraph that is not in the catalogue,
because it is new or was changed, ends the building: no page falls back to English. What a text has indented is
its formulas or its code; code may have its comments translated, and stays as it is else.
"""

from __future__ import annotations

import re
from collections.abc import Mapping
from functools import cache
from pathlib import Path
from textwrap import dedent, indent

from words import Language

from graphic_tmm import read
from graphic_tmm.language.catalogue import read_catalogue

_BREAK = re.compile(r"(\n\s*\n|\n(?=- |\|))")
"""Between paragraphs, items of a list, rows of a table."""
_START = re.compile(r"\s*(?:- |#+ )?")
_INDENT = "    "


def paragraphs(text: str, *, code: bool = False) -> dict[str, bool]:
    """Return the paragraphs of a text, each as one line, and whether every language must have its own.

    With ``code`` what is indented is code.
    """
    parts = _BREAK.split(text)[::2]
    keys = {_key(part): not (code and part.startswith(_INDENT)) for part in parts}
    return {key: due for key, due in keys.items() if re.search(r"[^\W\d_]", key)}


def translated(text: str, language: Language, source: str = "en", *, code: bool = False) -> str:
    """Return a text in a language, its paragraphs, lists and indents as they were."""
    if language == source:
        return text
    known = catalogue(language)
    for one, due in paragraphs(text, code=code).items():
        if due and one not in known:
            raise LookupError(f"{language}.po has no text for: {one}")
    parts = _BREAK.split(text)
    for k in range(0, len(parts), 2):
        key = _key(parts[k])
        if parts[k].startswith(_INDENT):
            parts[k] = indent(known.get(key, key), _INDENT)
        else:
            parts[k] = parts[k][: len(parts[k]) - len(_START.sub("", parts[k], count=1))]
            parts[k] += known.get(key, key)
    return "".join(parts)


def _key(part: str) -> str:
    if part.startswith(_INDENT):
        return dedent(part).rstrip()
    return re.sub(r"\s*\n\s*", " ", _START.sub("", part, count=1).rstrip())


def titled(name: str, language: Language) -> str:
    """Return the title of a scene of the package."""
    scene = read(name)
    return translated(scene.title, language, scene.language)


@cache
def catalogue(language: Language) -> Mapping[str, str]:
    """Return the paragraphs of a language by those of the source."""
    texts = read_catalogue(Path(__file__).parent / f"{language}.po").texts
    return {original: forms[0] for (_, original), forms in texts.items()}
