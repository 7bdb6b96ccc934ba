"""Guides as sections name them, and which way along one a word for a side means."""

from __future__ import annotations

import cmath
import math
from collections.abc import Mapping

from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Guide as MechanismGuide
from graphic_tmm.scene import letters
from graphic_tmm.scene.mechanism import Guide

_SQUARE = 1e-6
"""A side whose direction has no more than this in common (cosine) with a guide lies on neither side of it."""
_WORDS = {"right": (1, 0), "left": (-1, 0), "above": (0, 1), "below": (0, -1)}
OTHER_WAY = {
    one: other
    for pair in (
        ("+", "-"),
        ("right", "left"),
        ("above", "below"),
        ("справа", "слева"),
        ("выше", "ниже"),
        ("left of", "right of"),
        ("слева от", "справа от"),
    )
    for one, other in (pair, pair[::-1])
}
"""Words for a side, each with that for the other."""


def direction(start: complex, end: complex) -> float:
    """Return the angle of the way from ``start`` to ``end``, degrees in [0, 360)."""
    way = end - start
    if way.imag == 0 or way.real == 0:
        quarter = (0 if way.real > 0 else 2) if way.imag == 0 else (1 if way.imag > 0 else 3)
        return 90.0 * quarter
    return math.degrees(cmath.phase(way)) % 360


def guide(name: str, points: Mapping[str, complex], guides: Mapping[str, Guide]) -> MechanismGuide:
    """Return the guide that ``along`` names on a link: one of its own, or the line of two letters.

    Parameters
    ----------
    name : str
        A guide's name, or two letters of the link, such as ``"BC"``.
    points : mapping of str to complex
        The link's points in its own axes, m.
    guides : mapping of str to GuideTable
        The link's guides.

    Returns
    -------
    Guide
        In the link's own axes, m and degrees.
    """
    if name in guides:
        return MechanismGuide(name, guides[name].through, guides[name].angle)
    pair = letters.split(name)
    if pair is None:
        raise ValueError(said('"{name}" is neither a guide nor two letters', name=name))
    start, end = (points[letter] for letter in pair)
    return MechanismGuide(name, start, direction(start, end))


def sense(word: str, line: MechanismGuide, *, fixed: bool) -> int:
    """Return the sign along a guide that a word for a side means.

    Parameters
    ----------
    word : str
        "+" or "-" along the guide; for a guide of the frame also "right", "left", "above", "below".
    line : Guide
        The guide, its angle in the axes of its link.
    fixed : bool
        Whether the guide belongs to the frame.

    Returns
    -------
    int
        +1 or -1.

    Raises
    ------
    ValueError
        If the word does not tell one sense of the guide from the other.
    """
    if word in ("+", "-"):
        return 1 if word == "+" else -1
    if not fixed:
        raise ValueError(
            said(
                '"{word}" tells nothing on a guide that moves; write "+" or "-": along {name}, or '
                "against it",
                word=word,
                name=line.name,
            )
        )
    along = cmath.rect(1, math.radians(line.angle))
    x, y = _WORDS[word]
    shared = along.real * x + along.imag * y
    if abs(shared) < _SQUARE:
        one, other = ("above", "below") if x else ("left", "right")
        raise ValueError(
            said(
                'the guide {name} lies square to "{word}"; write "{one}" or "{other}"',
                name=line.name,
                word=word,
                one=one,
                other=other,
            )
        )
    return 1 if shared > 0 else -1
