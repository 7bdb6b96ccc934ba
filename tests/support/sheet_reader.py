"""A sheet read back from its SVG by somebody who has nothing else: strokes with what they tell, and words.

Nothing of the package is used. Millimetres, y upward, the origin in the upper left corner of the sheet.
"""

from __future__ import annotations

import math
import re
from collections.abc import Collection, Iterator, Mapping
from typing import NamedTuple
from xml.etree import ElementTree

SVG = "{http://www.w3.org/2000/svg}"
_NUMBER = re.compile(r"-?\d+(?:\.\d+)?(?:e-?\d+)?")
_LOWERED = str.maketrans("₀₁₂₃₄₅₆₇₈₉", "0123456789")
_RAISED = str.maketrans("⁰¹²³⁴⁵⁶⁷⁸⁹⁻", "0123456789-")


class Told(NamedTuple):
    """A stroke that tells something: its pen, where it begins and ends, its data- attributes."""

    pen: str
    start: complex
    end: complex
    data: Mapping[str, str]

    @property
    def way(self) -> complex:
        """Its direction."""
        return (self.end - self.start) / abs(self.end - self.start)

    def number(self, key: str) -> float:
        """A number that it tells."""
        return float(self.data[key])


class View(NamedTuple):
    """A view of a sheet: its strokes that tell something, its words in the order written."""

    strokes: tuple[Told, ...]
    words: tuple[str, ...]

    def named(self, segment: str) -> Told:
        """The stroke of a segment."""
        return next(one for one in self.strokes if one.data.get("segment") == segment)


def views(svg: str) -> dict[str, View]:
    """The views of a sheet by name."""
    found = {}
    for group in ElementTree.fromstring(svg).iter(f"{SVG}g"):
        kind, _, name = group.get("class", "").partition(" ")
        if kind == "drawing":
            words = [g.get("aria-label", "") for g in group.iter(f"{SVG}g") if g.get("aria-label")]
            found[name] = View(tuple(_strokes(group)), tuple(words))
    return found


def _strokes(group: ElementTree.Element) -> Iterator[Told]:
    for pen in group.iter(f"{SVG}g"):
        kind, _, name = pen.get("class", "").partition(" ")
        if kind != "pen":
            continue
        for path in pen.iter(f"{SVG}path"):
            data = {k.removeprefix("data-"): v for k, v in path.items() if k.startswith("data-")}
            if "segment" in data:
                *_, x, y = numbers = [float(n) for n in _NUMBER.findall(path.get("d", ""))]
                start = complex(numbers[0], -numbers[1])
                yield Told(name, start, complex(x, -y), data)


def plain(word: str) -> str:
    """A letter as machines name it: R₁₂^t -> R12^t."""
    return word.translate(_LOWERED).replace("_", "").replace("τ", "t")


def lines(view: View) -> list[str]:
    """The equations of a view, each that was broken put together again."""
    found: list[str] = []
    for word in view.words[1:]:
        if found and re.match(r"[+−=(|\d]", word):
            found[-1] += f" {word}"
        else:
            found.append(word)
    return found


_LETTER = re.compile(r"(?:[_^]\((?:[^()]|\([^()]*\))*\)|_−|[^\s·()\[\]+−/|])+")


def letters(text: str) -> list[str]:
    """The letters of a sum in the order written."""
    return _LETTER.findall(text)


def written(text: str, figures: Mapping[str, str]) -> str:
    """A sum by its letters with their figures put in, each as it was printed."""
    return _LETTER.sub(lambda found: figures[found[0]], text)


def signed(text: str) -> Iterator[tuple[int, list[str]]]:
    """The terms of a sum by letters: +1 or −1 before each, the letters that are multiplied in it."""
    names = iter(letters(text))
    bare = re.sub(r"[()\[\]]", "", _LETTER.sub("x", text))
    for sign, term in re.findall(r"(^|[+−])\s*([x·]+)", bare.replace(" ", "")):
        yield (-1 if sign == "−" else 1), [next(names) for _ in range(term.count("x"))]


class Figure(NamedTuple):
    """A number as it was written, and half of its last digit."""

    value: float
    half: float


def figure(text: str) -> Figure:
    """Read a number in any of the sheet's languages: 0,0025; 2.5·10⁻⁷; −78,48.

    A number without decimals is known to four figures, a longer one to its unit.
    """
    text = text.replace("−", "-").replace(",", ".")
    mantissa, _, power = text.partition("·10")
    scale = 10.0 ** int(power.translate(_RAISED)) if power else 1.0
    places, value = len(mantissa.partition(".")[2]), float(mantissa)
    if not places and value:
        places = max(0, 3 - math.floor(math.log10(abs(value))))
    return Figure(value * scale, 0.5 * 10.0**-places * scale)


_FIGURE = re.compile(r"\d+(?:[.,]\d+)?(?:·10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?")


def numbers_of(text: str) -> list[str]:
    """The figures of a sum in the order written."""
    return _FIGURE.findall(text)


def worked(text: str, exact: Collection[float] = ()) -> Figure:
    """Work out what is written: its value, and how far the digits that are not written may carry it.

    ``exact``: figures that are what they are, scale factors.
    """
    figures = [figure(found) for found in _FIGURE.findall(text)]
    figures = [one._replace(half=0.0) if one.value in exact else one for one in figures]
    signs = _FIGURE.sub("{}", text).replace("−", "-").replace("·", "*")
    signs = signs.replace("[", "(").replace("]", ")")
    signs = re.sub(r"\|([^|]*)\|", r"abs(\1)", signs)

    def at(moved: int | None) -> float:
        numbers = [
            f"({one.value + (one.half if k == moved else 0.0)!r})" for k, one in enumerate(figures)
        ]
        assert re.fullmatch(r"[\s()*/+\-.\dabse]+", signs.format(*numbers)), text
        return float(eval(signs.format(*numbers)))

    value = at(None)
    return Figure(value, sum(abs(at(k) - value) for k in range(len(figures))))


def result(text: str) -> Figure:
    """The number at the end of an equation, before its unit."""
    found = re.search(r"= (−?\d[\d.,]*(?:·10[⁻⁰¹²³⁴⁵⁶⁷⁸⁹]+)?) [^\s,]+(?:, .*)?$", text)
    assert found is not None, text
    return figure(found[1])
