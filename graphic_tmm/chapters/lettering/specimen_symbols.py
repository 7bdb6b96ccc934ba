"""The specimen of lines (ГОСТ 2.303) and of symbols of kinematic schemes (ГОСТ 2.770), with their names."""

from __future__ import annotations

import cmath

from graphic_tmm.paper.drawing import Bezier, Drawing, Label, Stroke, circle, line
from graphic_tmm.paper.symbols.gears import cam, gear, gear_side, wavy
from graphic_tmm.paper.symbols.kinematic import (
    fixed_pivot,
    guide,
    plate,
    rigid_joint,
    round_arrow,
    slider,
    stone,
    turning_pair,
)

LINES = (
    ("main", "сплошная основная, s", "main, s"),
    ("thin", "сплошная тонкая, s/3", "thin, s/3"),
    ("wavy", "сплошная волнистая, s/3", "wavy, s/3"),
    ("dashed", "штриховая", "dashed"),
    ("centre", "штрихпунктирная тонкая", "dash-dot, thin"),
    ("phantom", "штрихпунктирная с двумя точками", "dash and two dots"),
    ("thick", "разомкнутая", "thick"),
    ("medium", "векторы планов, s/2", "vectors of plans, s/2"),
)
WIDTH, PITCH = 70.0, 9.0
"""Length of a line shown, distance of two, mm."""
CELL, COLUMNS, TALL = 72.0, 5, 52.0
"""Width of a symbol's cell, how many stand in a row, height of a row, mm."""
TITLES = {
    "ru": ("Линии чертежа", "Условные обозначения кинематических схем"),
    "en": ("Lines", "Symbols of kinematic schemes"),
}


def specimen_symbols(language: str) -> list[Drawing]:
    """Return the view of the lines and that of the symbols."""
    titles = TITLES[language]
    return [_lines(titles[0], language), _symbols(titles[1], language)]


def _lines(title: str, language: str) -> Drawing:
    labels, strokes = [Label(title, 0j, 7.0)], list[Stroke | Bezier]()
    for k, (pen, russian, english) in enumerate(LINES):
        start = -1j * PITCH * (k + 1.5)
        strokes.append(
            wavy(start, start + WIDTH) if pen == "wavy" else line(pen, start, start + WIDTH)
        )
        text = russian if language == "ru" else english
        labels.append(Label(text, start + WIDTH + 5.0 - 1.7j, 5.0))
    return Drawing("lines", title, tuple(strokes), tuple(labels))


def _symbols(title: str, language: str) -> Drawing:
    labels, strokes = [Label(title, 0j, 7.0)], list[Stroke | Bezier]()
    for k, (russian, english, made) in enumerate(_gallery()):
        row, column = divmod(k, COLUMNS)
        at = complex(CELL * (column + 0.5), -TALL * row - 34.0)
        moved = Drawing("", "", made).moved(at)
        strokes += moved.strokes
        text = russian if language == "ru" else english
        labels.append(Label(text, at - 24j, 3.5, "middle"))
    return Drawing("symbols", title, tuple(strokes), tuple(labels))


def _gallery() -> list[tuple[str, str, tuple[Stroke, ...]]]:
    """Return the symbols about 0 with their names."""
    rod = (line("rod", -20 + 0j, 20 + 0j),)
    corner = (line("rod", -18 - 8j, 0j), line("rod", 0j, 18 - 8j))
    triangle = (-14 - 9j, 14 - 9j, 2 + 13j)
    pins = tuple(stroke for z in triangle for stroke in turning_pair(z))
    profile = [cmath.rect(9.0 + 4.0 * max(0.0, cmath.cos(t).real), t) for t in _turn(48)]
    return [
        ("неподвижная опора", "fixed pivot", fixed_pivot(0j)),
        ("вращательная пара", "turning pair", (*rod, *turning_pair(0j))),
        ("ползун в направляющей", "slider on a guide", (*guide(-22 + 0j, 22 + 0j), *slider(0j))),
        (
            "кулисный камень",
            "sliding block",
            (line("main", -20 - 8j, 20 + 8j), *stone(0j, 21.8)),
        ),
        (
            "жёсткое соединение",
            "rigid joint",
            (*corner, *rigid_joint(0j, -18 - 8j, 18 - 8j)),
        ),
        ("трёхпарное звено", "ternary link", (*plate(*triangle), *pins)),
        ("направление вращения", "sense of rotation", round_arrow(0j, 10.0, 20.0, 140.0)),
        ("зубчатая пара", "gear pair", (*gear(-12 + 0j, 9.0), *gear(12 + 0j, 15.0))),
        (
            "колесо на валу",
            "gear on a shaft",
            (line("main", -16 + 0j, 16 + 0j), *gear_side(0j, 13.0, 7.0)),
        ),
        (
            "кулачок с роликовым толкателем",
            "cam with a roller follower",
            (
                *cam(-6j, profile),
                circle("joint", 6.5j, 3.5),
                line("rod", 6.5j, 20j),
                *turning_pair(6.5j),
            ),
        ),
    ]


def _turn(count: int) -> list[float]:
    return [2 * cmath.pi * k / count for k in range(count)]
