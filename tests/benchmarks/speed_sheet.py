"""What the paper costs: lettering, a full A1 sheet against plain svgwrite, and a cold start."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from itertools import islice, permutations
from pathlib import Path
from tempfile import TemporaryDirectory
from typing import NamedTuple
from xml.etree import ElementTree

import svgwrite
from clock import Row, median, process

from graphic_tmm.paper import letters, placing
from graphic_tmm.paper.compose import compose
from graphic_tmm.paper.svg import svg
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import SheetOrder
from graphic_tmm.studio import fitted

WINDROWER = Path(__file__).resolve().parent.parent.parent / "sheets" / "windrower"
NS = "{http://www.w3.org/2000/svg}"


def labels(count: int = 800) -> list[str]:
    """Return different labels as sheets bear them: vectors with indices, points, captions, figures."""
    pairs = ["".join(pair) for pair in permutations("ABCDEKMS", 2)]
    found = [form % pair for form in (r"\bar{v}_{%s}", "a_{%s}^{t}", "n_{%s}") for pair in pairs]
    found += [f"{letter}, s_{{{k}}}" for letter in "abcdek" for k in range(12)]
    found += [f"План скоростей, положение {k}*" for k in range(40)]
    found += [f"{k / 7:.2f}".replace(".", ",") for k in range(count)]
    return list(islice(dict.fromkeys(found), count))


def letter_all(texts: list[str], put: Callable[..., letters.Lettering]) -> None:
    """Turn texts into strokes and path data, as the placing and the SVG need them."""
    for k, text in enumerate(texts):
        written = put(text, size=3.5)
        assert written.strokes
        for pen in written.pens:
            letters.svg_path(written, 0.7 * k, 0.5 * k, pen=pen)


def lettering(unit: float) -> list[Row]:
    """Time 800 labels: each of them new, and all of them met before."""
    texts = labels()
    assert len(set(texts)) == 800
    new = median(lambda: letter_all(texts, letters.compose))
    again = median(lambda: letter_all(texts, letters.letter))
    return [
        ("800 different labels to strokes and path data", new, unit),
        ("   the same again, remembered whole", again, unit),
    ]


class Plain(NamedTuple):
    """The ink of a sheet: path data, and words with their places and sizes."""

    paths: list[str]
    words: list[tuple[str, tuple[str, str], str]]

    @classmethod
    def of(cls, text: str) -> Plain:
        """Take them from a sheet; the check of svgwrite wants a space before each minus sign."""
        root = ElementTree.fromstring(text)
        paths = [re.sub(r"(?<=\d)-", " -", e.attrib["d"]) for e in root.iter(f"{NS}path")]
        found = [(e.text or "", e.attrib) for e in root.iter(f"{NS}text")]
        return cls(paths, [(t, (a["x"], a["y"]), a["font-size"]) for t, a in found])

    def write(self, **options: bool) -> str:
        """Write them through bare svgwrite calls, all below the page itself."""
        page = svgwrite.Drawing(size=("841mm", "594mm"), profile="full", **options)
        for d in self.paths:
            page.add(page.path(d=d))
        for word, at, size in self.words:
            page.add(page.text(word, insert=at, font_size=size))
        return str(page.tostring())


def sheet() -> list[Row]:
    """Time the windrower's A1 sheet after its construction, against plain svgwrite."""
    scene = read(WINDROWER)
    full = (*scene.sheets[0].place, "results")
    scene = replace(scene, diagrams=None, sheets=(SheetOrder("A1", full),))
    made = fitted(scene)
    (composed,) = compose(made.scene, made)
    plain = Plain.of(svg(composed))
    paths, words = len(plain.paths), len(plain.words)
    bare = median(plain.write, 3.0)

    def whole(*forget: Callable[[], None]) -> None:
        for each in forget:
            each()
        for one in compose(made.scene, made):
            svg(one)

    forget = (letters.letter.cache_clear, placing.box.cache_clear)
    return [
        (f"{paths} paths, {words} texts through svgwrite, checked", bare, bare),
        ("   the same with debug=False", median(lambda: plain.write(debug=False)), bare),
        ("windrower's A1 sheet: composed, placed, written", median(whole, 3.0), bare),
        ("   the same, no label remembered", median(lambda: whole(*forget), 3.0), bare),
        ("   of it, composed and placed", median(lambda: compose(made.scene, made)), bare),
        ("   of it, written as SVG", median(lambda: svg(composed)), bare),
    ]


def cold() -> list[Row]:
    """Time fresh processes, down to a drawn sheet."""
    empty = process("-c", "pass")
    packages = process("-c", "import numpy, shapely, svgwrite")
    with TemporaryDirectory() as out:
        draw = process("-m", "graphic_tmm", "draw", "-o", out)
    light = process("-c", "import numpy, shapely, svgwrite, pydantic, click")
    return [
        ("python -c pass (the unit of what follows)", empty, empty),
        ("import numpy, shapely, svgwrite, pydantic, click", light, empty),
        ("graphic-tmm --help", process("-m", "graphic_tmm", "--help"), empty),
        ("graphic-tmm draw (windrower, A1)", draw, empty),
        ("import numpy, shapely, svgwrite", packages, packages),
        ("graphic-tmm draw (windrower, A1) against that", draw, packages),
    ]
