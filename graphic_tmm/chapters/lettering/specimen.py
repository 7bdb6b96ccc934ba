"""The specimen of the lettering: every character at its place between the lines of its row, sizes, mark-up."""

from __future__ import annotations

import math
import unicodedata
from collections.abc import Iterable

from graphic_tmm.language.said import said
from graphic_tmm.language.tables import Tongues
from graphic_tmm.paper.drawing import Drawing, Label, line
from graphic_tmm.paper.lettering.glyphs import characters
from graphic_tmm.paper.lettering.letters import (
    SIZES,
    escape,
    letter,
)
from graphic_tmm.paper.lettering.notation import SLANT

SHOWN = 10.0
"""Height of the capitals in the rows of characters, mm."""
TOLD = 7.0
"""Height of the capitals of the notation, mm."""
LARGE = 28.0
"""Height of the capitals on the grid, mm."""
WIDEST = 385.0
"""A row of characters longer than this goes on in the next, mm."""
GAP = 0.5
"""Clear way between two characters, of the height of a capital."""
ROW = 2.2
"""From one base line to the next, of the height of a capital."""
WORDS = Tongues(
    {
        "upright": said("Lettering type B, upright"),
        "inclined": said("Lettering type B, inclined at 75°"),
        "sizes": said("Sizes of lettering"),
        "notation": said("Notation"),
        "grid": said("Letters on their grid, its pitch h/10"),
        "large": said("TMMag2ωμ"),
        "sample": said("Plans of velocities and accelerations 0123456789"),
    }
)
NOTATION = (
    r"\bar{v}_{B} = \uu{\bar{v}_{A}} + \u{\bar{v}_{BA}}",
    r"\bar{a}_{B} = \uu{\bar{a}_{A}} + \uu{\bar{a}_{BA}^{n}} + \u{\bar{a}_{BA}^{t}}",
    r"μ_v = 0,1 (м/с)/мм,  ω_1² = 39,8² с⁻²,  Σ M_{O} = 0,  \bar{AB} ⊥ \bar{CD}",
    r"∫ M dφ = ΔT,  √(x² + y²),  ∠ABC = 30°15′20″,  Δφ ≈ π/6,  x_{1}^{2} ≠ x_{max}^{(k+1)}",
)


def specimen(language: str, title_size: float) -> list[Drawing]:
    """Return the views of the specimen sheet; ``title_size``: how high their titles are, mm."""
    words = WORDS[language]
    sample = escape(words["sample"])
    views = [
        _on_grid("grid", words["grid"], words["large"], False),
        _on_grid("grid-inclined", words["grid"], words["large"], True),
        *(_characters(words[key], key, key == "inclined") for key in ("upright", "inclined")),
        _lines("sizes", words["sizes"], [(sample, size) for size in SIZES]),
        _lines("notation", words["notation"], [(text, TOLD) for text in NOTATION]),
    ]
    titles = (Label(view.title, 0j, title_size) for view in views)
    return [
        view._replace(labels=(title, *view.labels))
        for view, title in zip(views, titles, strict=True)
    ]


def _on_grid(name: str, title: str, text: str, inclined: bool) -> Drawing:
    """Return large letters on the grid whose pitch is the width of the pen."""
    pitch, lean = LARGE / 10, SLANT if inclined else 0.0
    labels, strokes, x, base = list[Label](), [], 6.0, -LARGE * 1.6
    low, high = base - 4 * pitch, base + LARGE + 2 * pitch
    for character in text:
        made = letter(escape(character), size=LARGE, inclined=inclined)
        at = complex(pitch * math.ceil(x / pitch) + pitch / 2, base)
        labels.append(Label(escape(character), at, LARGE, inclined=inclined))
        x = at.real + made.width + 2 * pitch
    count = math.ceil((x + 6.0) / pitch)
    for k in range(count + 1):
        foot = k * pitch
        ends = (complex(foot + lean * (y - base), y) for y in (low, high))
        strokes.append(line("thin", *ends))
    for k in range(round((high - low) / pitch) + 1):
        y = low + k * pitch
        shift = lean * (y - base)
        strokes.append(line("thin", complex(shift, y), complex(count * pitch + shift, y)))
    return Drawing(f"lettering-{name}", title, tuple(strokes), tuple(labels))


def kinds() -> dict[str, str]:
    """Return all characters of the alphabet by their kind: capitals, small letters, figures, signs."""
    found: dict[str, str] = {}
    for character in sorted(characters(), key=_order):
        if character.strip():
            kind = _kind(character)
            found[kind] = found.get(kind, "") + character
    return {kind: found[kind] for kind in sorted(found)}


def _order(character: str) -> tuple[str, bool]:
    """Return what characters are sorted by: their code points, but Ё stands after Е."""
    before = {"Ё": "Е", "ё": "е"}
    return before.get(character, character), character in before


def _kind(character: str) -> str:
    """Return what a character is, as words that sort in the order of a specimen."""
    if character.isdigit() and character.isascii():
        return "8 figures"
    script = unicodedata.name(character, "").split(" ")[0]
    order = {"CYRILLIC": 1, "LATIN": 3, "GREEK": 5}.get(script)
    if order is None or not character.isalpha():
        return "9 signs"
    return f"{order + character.islower()} {script.lower()}"


def _characters(title: str, name: str, inclined: bool) -> Drawing:
    labels, strokes, base = list[Label](), [], -8.0
    for text in kinds().values():
        x = WIDEST
        for character in text:
            made = letter(escape(character), size=SHOWN, inclined=inclined)
            if x + made.width > WIDEST:
                base, x = base - ROW * SHOWN, 0.0
                for height in (0.0, SHOWN):
                    ends = complex(0.0, base + height), complex(WIDEST, base + height)
                    strokes.append(line("thin", *ends))
            at = complex(x - min(made.left, 0.0), base)
            labels.append(Label(escape(character), at, SHOWN, inclined=inclined))
            x += made.width + GAP * SHOWN
    return Drawing(f"lettering-{name}", title, tuple(strokes), tuple(labels))


def _lines(name: str, title: str, rows: Iterable[tuple[str, float]]) -> Drawing:
    labels, base = list[Label](), -4.0
    for text, size in rows:
        made = letter(text, size=size)
        base -= made.ascent + 3.0
        labels.append(Label(text, complex(0.0, base), size))
        base -= made.descent
    return Drawing(f"lettering-{name}", title, labels=tuple(labels))
