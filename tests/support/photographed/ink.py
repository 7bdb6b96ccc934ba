"""The ink of a sheet's SVG with what every line is of: polylines, complex mm, y upward."""

from __future__ import annotations

import xml.etree.ElementTree as ET
from collections.abc import Iterator
from typing import NamedTuple

import numpy as np

from support.svg_ink import NS, polylines


class Inked(NamedTuple):
    """A line as it is drawn: its ``points``, pen, dashes (mm), the drawing it stands in.

    ``of``: the slots of the marks it comes from; ``at``: the position (index), None for all. ``pen`` is
    "letters" for a stroke of lettering, whose label is ``word``, numbered over the sheet.
    """

    points: np.ndarray
    pen: str
    drawing: str
    dashes: tuple[float, ...] = ()
    of: frozenset[int] = frozenset()
    at: int | None = None
    word: int = -1
    filled: bool = False


def inked(svg: str) -> tuple[float, float, list[Inked]]:
    """Return width and height of a sheet, mm, and its ink in the order in which it is drawn."""
    root = ET.fromstring(svg)
    width, height = (float(v) for v in root.get("viewBox", "").split()[2:])
    words = iter(range(1_000_000))
    found = []
    for group in root.iter(f"{NS}g"):
        if "drawing" in (group.get("class") or "").split():
            name = (group.get("class") or "").split()[1]
            for pen in group.findall(f"{NS}g"):
                kinds = (pen.get("class") or "").split()
                if kinds[0] == "lettering":
                    found += _letters(pen, name, height, words)
                else:
                    found += [
                        one
                        for p in pen.iter(f"{NS}path")
                        for one in _lines(p, kinds[1], name, height)
                    ]
    return width, height, found


def _letters(pen: ET.Element, name: str, height: float, words: Iterator[int]) -> Iterator[Inked]:
    for label in pen.findall(f"{NS}g"):
        word = next(words)
        for path in label.iter(f"{NS}path"):
            for one in _lines(path, "letters", name, height):
                yield one._replace(word=word, **_source(label))


def _lines(path: ET.Element, pen: str, name: str, height: float) -> Iterator[Inked]:
    dashes = tuple(float(v) for v in (path.get("stroke-dasharray") or "").split())
    filled = (path.get("fill") or "none") not in ("none", "white")
    for points in polylines(path.get("d", "")):
        pairs = np.array(points)
        whole = pairs[:, 0] + 1j * (height - pairs[:, 1])
        yield Inked(whole, pen, name, dashes, filled=filled, **_source(path))


def _source(element: ET.Element) -> dict[str, object]:
    at = element.get("data-at")
    return {
        "of": frozenset(int(v) for v in (element.get("data-of") or "").split()),
        "at": None if at is None else int(at),
    }
