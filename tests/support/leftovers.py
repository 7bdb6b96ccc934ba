"""What of one language is left over in a text of the other.

Of Russian in an English text: every word of Cyrillic letters. Of English in a Russian one: every word of the
package's English texts that no Russian text of it keeps and that is no key or choice of a scene, name of a
plan or command, sign of a function (tan); so letters of marks, units, SVG, SCENE are none. What the scene
itself says is its author's.
"""

from __future__ import annotations

import base64
import gzip
import json
import re
from collections.abc import Iterable, Iterator
from functools import cache
from html import unescape
from typing import Any
from xml.etree import ElementTree

from graphic_tmm.__main__ import main
from graphic_tmm.board.formula_text import FUNCTIONS
from graphic_tmm.language import catalogue
from graphic_tmm.language.catalogue import read_catalogue
from graphic_tmm.readers.protocol import plans
from graphic_tmm.scene.new import schema

RUSSIAN = re.compile("[А-Яа-яЁё]{2,}")
LATIN = re.compile(r"(?<![^\W\d_]|[\d_^{}\\./μ-])[A-Za-z]{3,}(?![\w}\\./(])")


def leftovers(text: str, language: str, own: str = "") -> list[str]:
    """The words of the other language in a text; ``own``: what the scene says, which may be in any."""
    authors = set(re.findall(r"[^\W\d_]+", own.casefold()))
    found = RUSSIAN.findall(text) if language == "en" else _english(text)
    return [word for word in found if word.casefold() not in authors]


def _english(text: str) -> Iterator[str]:
    known = english()
    return (word for word in LATIN.findall(text) if word.casefold() in known and not word.isupper())


@cache
def english() -> frozenset[str]:
    """The words that are English and nothing else here."""
    texts = read_catalogue(catalogue.FOLDER / "ru.po").texts
    words = _words(text for _, text in texts) - {"tab"}  # as a column is called, too: t_ab
    kept = _words(form for told in texts.values() for form in told)
    typed = {*_names(schema()), *plans(), *main.list_commands(None)}  # type: ignore[arg-type]
    return words - kept - _words(typed | set(FUNCTIONS))


def _words(texts: Iterable[str]) -> frozenset[str]:
    return frozenset(word.casefold() for text in texts for word in re.findall("[A-Za-z]{3,}", text))


def _names(part: Any) -> Iterator[str]:
    """Yield the keys and the choices of a schema."""
    if isinstance(part, dict):
        yield from part.get("properties", ())
        yield from (one for one in part.get("enum", ()) if isinstance(one, str))
        for one in part.values():
            yield from _names(one)
    elif isinstance(part, list):
        for one in part:
            yield from _names(one)


def of_svg(svg: str) -> str:
    """What a sheet says: its labels, the names of its parts."""
    root = ElementTree.fromstring(svg)
    told = [e.text or "" for e in root.iter()]
    names = [v for e in root.iter() for k, v in e.attrib.items() if k.endswith("label")]
    return "\n".join([*told, *names])


def data_of(page: str) -> Any:
    """What a page carries for its scripts; nothing if it has none."""
    scripts = re.findall(
        r'(?s)<script type="application/octet-stream" id="data">(.*?)</script>', page
    )
    return json.loads(gzip.decompress(base64.b64decode(scripts[0]))) if scripts else []


def of_page(page: str) -> str:
    """What a page says: its text, the texts in its data that are sentences."""
    data = data_of(page)
    plain = re.sub(r"(?s)<(style|script).*?</\1>|<title>.*?</title>", "", page)
    labels = re.findall(r'(?:label|alt|placeholder)="([^"]*)"', plain)
    text = unescape("\n".join([re.sub(r"<[^>]*>", "\n", plain), *labels]))
    return "\n".join([text, *(one for one in _texts(data) if " " in one)])


def _texts(part: Any) -> Iterator[str]:
    if isinstance(part, str):
        yield part
    elif isinstance(part, (dict, list)):
        for one in part.values() if isinstance(part, dict) else part:
            yield from _texts(one)
