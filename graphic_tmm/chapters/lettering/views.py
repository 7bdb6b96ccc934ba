"""Specimens, drawn of a scene alone: every character of the lettering, lines, symbols of kinematic schemes."""

from __future__ import annotations

import cmath
import math
import unicodedata
from collections.abc import Iterable

from graphic_tmm.fitting.views import Views
from graphic_tmm.language.catalogue import Speech, Tongues, speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Bezier, Drawing, Label, Stroke, circle, line
from graphic_tmm.paper.formats import Heights, heights
from graphic_tmm.paper.lettering.glyphs import SLANT, characters
from graphic_tmm.paper.lettering.letters import SIZES, escape, letter
from graphic_tmm.paper.symbols.kinematic import (
    cam,
    fixed_pivot,
    gear,
    gear_side,
    guide,
    plate,
    rigid_joint,
    round_arrow,
    slider,
    stone,
    turning_pair,
    wavy,
)
from graphic_tmm.scene.records import Scene

CAPITALS = 10.0
"""Height of the capitals in the rows of characters, mm."""
NOTATION_SIZE = 7.0
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
        _lines("notation", words["notation"], [(text, NOTATION_SIZE) for text in NOTATION]),
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
            made = letter(escape(character), size=CAPITALS, inclined=inclined)
            if x + made.width > WIDEST:
                base, x = base - ROW * CAPITALS, 0.0
                for height in (0.0, CAPITALS):
                    ends = complex(0.0, base + height), complex(WIDEST, base + height)
                    strokes.append(line("thin", *ends))
            at = complex(x - min(made.left, 0.0), base)
            labels.append(Label(escape(character), at, CAPITALS, inclined=inclined))
            x += made.width + GAP * CAPITALS
    return Drawing(f"lettering-{name}", title, tuple(strokes), tuple(labels))


def _lines(name: str, title: str, rows: Iterable[tuple[str, float]]) -> Drawing:
    labels, base = list[Label](), -4.0
    for text, size in rows:
        made = letter(text, size=size)
        base -= made.ascent + 3.0
        labels.append(Label(text, complex(0.0, base), size))
        base -= made.descent
    return Drawing(f"lettering-{name}", title, labels=tuple(labels))


LINES = (
    ("main", said("main, s")),
    ("thin", said("thin, s/3")),
    ("wavy", said("wavy, s/3")),
    ("dashed", said("dashed")),
    ("centre", said("dash-dot, thin")),
    ("phantom", said("dash and two dots")),
    ("thick", said("thick")),
    ("medium", said("vectors of plans, s/2")),
)
WIDTH, PITCH = 70.0, 9.0
"""Length of a line shown, distance of two, mm."""
OPEN = 15.0
"""Length of a stroke of the open line, mm (ГОСТ 2.303: 8…20)."""
CAM, NOSE, LIFT = 8.0, 3.0, 9.0
"""Radii of the base circle of the cam shown and of its nose, from one centre to the other, mm."""
ROLLER = 3.5
"""Radius of its roller, mm."""
CELL, COLUMNS, TALL = 72.0, 5, 52.0
"""Width of a symbol's cell, how many stand in a row, height of a row, mm."""


def specimen_symbols(language: str, high: Heights) -> list[Drawing]:
    """Return the view of the lines and that of the symbols."""
    _ = speaking(language)
    return [_line_kinds(_("Lines"), _, high), _symbols(_("Symbols of kinematic schemes"), _, high)]


def _line_kinds(title: str, speech: Speech, high: Heights) -> Drawing:
    labels, strokes = [Label(title, 0j, high.title)], list[Stroke | Bezier]()
    for k, (pen, name) in enumerate(LINES):
        start = -1j * PITCH * (k + 1.5)
        strokes += _line_sample(pen, start, start + WIDTH)
        labels.append(Label(speech(name), start + WIDTH + 5.0 - 1.7j, high.point))
    return Drawing("lines", title, tuple(strokes), tuple(labels))


def _line_sample(pen: str, start: complex, end: complex) -> list[Stroke | Bezier]:
    """Return a line as it is drawn; the open one is two strokes at the ends of a section's plane."""
    if pen == "wavy":
        return [wavy(start, end)]
    if pen == "thick":
        return [line(pen, start, start + OPEN), line(pen, end - OPEN, end)]
    return [line(pen, start, end)]


def _symbols(title: str, speech: Speech, high: Heights) -> Drawing:
    labels, strokes = [Label(title, 0j, high.title)], list[Stroke | Bezier]()
    for k, (name, made) in enumerate(_gallery()):
        row, column = divmod(k, COLUMNS)
        at = complex(CELL * (column + 0.5), -TALL * row - 34.0)
        moved = Drawing("", "", made).moved(at)
        strokes += moved.strokes
        labels.append(Label(speech(name), at - 24j, high.number, "middle"))
    return Drawing("symbols", title, tuple(strokes), tuple(labels))


def _gallery() -> list[tuple[str, tuple[Stroke, ...]]]:
    """Return the symbols about 0 with their names."""
    rod = (line("rod", -20 + 0j, 20 + 0j),)
    corner = (line("rod", -18 - 8j, 0j), line("rod", 0j, 18 - 8j))
    triangle = (-14 - 9j, 14 - 9j, 2 + 13j)
    pins = tuple(stroke for z in triangle for stroke in turning_pair(z))
    high = (CAM + ROLLER - 6.0) * 1j
    return [
        (said("fixed pivot"), fixed_pivot(0j)),
        (said("turning pair"), (*rod, *turning_pair(0j))),
        (said("slider on a guide"), (*guide(-22 + 0j, 22 + 0j), *slider(0j))),
        (
            said("sliding block"),
            (line("main", -20 - 8j, 20 + 8j), *stone(0j, 21.8)),
        ),
        (
            said("rigid joint"),
            (*corner, *rigid_joint(0j, -18 - 8j, 18 - 8j)),
        ),
        (said("ternary link"), (*plate(*triangle), *pins)),
        (said("sense of rotation"), round_arrow(0j, 10.0, 20.0, 140.0)),
        (said("gear pair"), (*gear(-12 + 0j, 9.0), *gear(12 + 0j, 15.0))),
        (
            said("gear on a shaft"),
            (line("main", -16 + 0j, 16 + 0j), *gear_side(0j, 13.0, 7.0)),
        ),
        (
            said("cam with a roller follower"),
            (
                *cam(-6j, _profile()),
                circle("joint", high, ROLLER),
                line("rod", high, 20j),
                *turning_pair(high),
            ),
        ),
    ]


def _profile(toward: float = math.radians(200.0), parts: int = 40) -> list[complex]:
    """Return a cam: base circle and nose with their common tangents; ``toward``: where the nose points, rad."""
    half = math.acos((CAM - NOSE) / LIFT)
    turns = (2.0 * (math.pi - half), 2.0 * half)
    starts = (toward + half, toward - half)
    centres = (0j, cmath.rect(LIFT, toward))
    return [
        centre + cmath.rect(radius, start + turn * k / parts)
        for centre, radius, start, turn in zip(centres, (CAM, NOSE), starts, turns, strict=True)
        for k in range(parts + 1)
    ]


def _characters_view(scene: Scene) -> list[Drawing]:
    return specimen(scene.language, heights(scene, "lettering").title)


def _symbols_view(scene: Scene) -> list[Drawing]:
    return specimen_symbols(scene.language, heights(scene, "symbols"))


SHOWN = Views(plain={"lettering": _characters_view, "symbols": _symbols_view})
