"""What the paper costs: lettering, and a full A1 sheet against plain svgwrite."""

from __future__ import annotations

import re
from collections.abc import Callable
from dataclasses import replace
from itertools import islice, permutations
from typing import NamedTuple
from xml.etree import ElementTree

import svgwrite
from clock import ROOT, Row, in_turns, show

from graphic_tmm.fitting.compose import compose
from graphic_tmm.fitting.fit import fitted
from graphic_tmm.paper import labels as places
from graphic_tmm.paper.lettering import letters
from graphic_tmm.paper.write.svg import svg
from graphic_tmm.scene.read import read
from graphic_tmm.scene.records import SheetOrder

WINDROWER = ROOT / "sheets" / "windrower"
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


def rows() -> list[Row]:
    """Return the lines of the table: the windrower's A1 sheet behind its construction, and plain svgwrite."""
    scene = read(WINDROWER)
    full = (*scene.sheets[0].place, "results")
    scene = replace(scene, sheets=(SheetOrder("A1", full),)).asking(diagrams=None)
    made = fitted(scene)
    (composed,) = compose(made.scene, (made,))
    plain = Plain.of(svg(composed))
    texts = labels()
    assert len(set(texts)) == 800

    def forgetting() -> None:
        letters.letter.cache_clear()
        places.box.cache_clear()
        svg(compose(made.scene, (made,))[0])

    def whole() -> None:
        svg(compose(made.scene, (made,))[0])

    names = {
        f"{len(plain.paths)} paths, {len(plain.words)} texts, svgwrite": lambda: plain.write(debug=False),
        "a full A1 sheet of the windrower: composed, placed, written": whole,
        "the same, no label remembered": forgetting,
        "of it, composed and placed": lambda: compose(made.scene, (made,)),
        "of it, written as SVG": lambda: svg(composed),
        "800 labels to strokes, each of them new": lambda: letter_all(texts, letters.compose),
        "the same labels remembered": lambda: letter_all(texts, letters.letter),
    }  # fmt: skip
    return [Row(name, f"{s * 1e3:.0f} ms") for name, s in in_turns(names, rounds=7).items()]


def main() -> None:
    """Print the table."""
    show("a sheet, warm", rows())


if __name__ == "__main__":
    main()
