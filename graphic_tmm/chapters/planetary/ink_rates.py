"""The picture of linear velocities of a planetary train and its plan of angular velocities in ink."""

from __future__ import annotations

from itertools import pairwise

from graphic_tmm.board.record import Mark
from graphic_tmm.chapters.planetary.ink_numbers import BESIDE, LEAST, NUMBER, OVER, TrainInk
from graphic_tmm.paper.drawing import Stroke, Wanted, circle, line
from graphic_tmm.paper.symbols.kinematic import ARROW_LENGTH, arrowhead, pole

TOGETHER = 1.0
"""Points nearer than this, mm, share one label."""
LETTERED = 8.0
"""A line shorter than this bears no number, mm."""
DOT = 0.5
"""Radius of a point, mm."""


def draw_picture(ink: TrainInk) -> list[Stroke]:
    """The velocities of A and B, and the straight lines of the three bodies."""
    o, a, b, c = ink.zeros
    high = max((o, a, b, c), key=lambda z: z.imag)
    strokes = [line("thin", o, high + 1j * OVER)]
    for foot, tip, key in ((a, ink.tips[0], "A"), (b, ink.tips[1], "B")):
        strokes += _vector(ink, foot, tip, key)
    return strokes + [line("main", spots[0], spots[-1]) for _, spots in _bodies(ink)]


def _bodies(ink: TrainInk) -> list[tuple[str, tuple[complex, ...]]]:
    """The straight lines by the numbers of their bodies, each by its points from below."""
    origin, (a, b), c = ink.zeros[0], ink.tips, ink.zeros[3]
    block = tuple(sorted((a, b, c), key=lambda z: z.imag))
    return [("1", (origin, a)), ("H", (origin, b)), (_block(ink), block)]


def _vector(ink: TrainInk, foot: complex, tip: complex, key: str) -> list[Stroke]:
    mm = abs(tip - foot)
    if mm < LEAST:
        return []
    head, way = min(ARROW_LENGTH, 0.45 * mm), (tip - foot) / mm
    picture = ink.made.picture
    stroke = line("medium", foot, tip - 0.5 * head * way)
    stroke = _told(ink, stroke, picture.readings[key], picture.speeds[key])
    return [stroke, *arrowhead(tip, way, pen="medium", length=head)]


def _told(ink: TrainInk, stroke: Stroke, segment: Mark, quantity: Mark) -> Stroke:
    """Return a stroke that tells a page the segment read, in mm, and what it stands for."""
    mm, value = (float(ink.reading[mark][0, 0]) for mark in (segment, quantity))
    data = (
        ("segment", segment.name),
        ("mm", f"{mm:.2f}"),
        ("value", f"{value:.6g}"),
        ("unit", quantity.unit),
    )
    title = f"{segment.name} = {mm:.1f} mm = {value:.4g} {quantity.unit}"
    return stroke._replace(title=title, data=data)


def draw_rates(ink: TrainInk) -> list[Stroke]:
    """The line of angular velocities with its points, the pole and its rays."""
    xs = [ink.foot.real, *(z.real for z in ink.ends.values())]
    y, rates = ink.foot.imag, ink.made.rates
    strokes = [line("main", complex(min(xs) - OVER, y), complex(max(xs) + OVER, y))]
    strokes.append(line("thin", ink.pole, ink.foot))
    strokes += [line("medium", ink.pole, spot) for spot in ink.ends.values()]
    strokes.append(circle("main", ink.foot, DOT, filled=True))
    for body, spot in ink.ends.items():
        dot = circle("main", spot, DOT, filled=True)
        strokes.append(_told(ink, dot, rates.segments[body], rates.values[body]))
    return [*strokes, *pole(ink.pole)]


def picture_letters(ink: TrainInk) -> list[Wanted]:
    """The letters of the zero line and of the ends of velocities, the bodies of the lines."""
    o, a, b, c = ink.zeros
    away = -1.0 if sum((tip - o).real for tip in ink.tips) > 0.0 else 1.0
    wanted = [Wanted("O", o, NUMBER, BESIDE, away - 1j)]
    for name, at in zip("ABC", (a, b, c), strict=True):
        wanted.append(Wanted(name, at, NUMBER, BESIDE, away + 1j))
    for text, at, foot in (("a", ink.tips[0], a), ("b", ink.tips[1], b)):
        if abs(at - foot) >= LEAST:
            wanted.append(Wanted(text, at, NUMBER, 0.8, at - foot))
    for text, spots in _bodies(ink):
        low, high = max(pairwise(spots), key=lambda part: round(abs(part[1] - part[0]), 6))
        if abs(high - low) > LETTERED:
            wanted.append(Wanted(text, (low + high) / 2, NUMBER, 0.8, -away + 0j))
    return wanted


def _block(ink: TrainInk) -> str:
    return ", ".join(ink.wheels[1:-1])


def rate_letters(ink: TrainInk) -> list[Wanted]:
    """The pole, the fixed wheel and the ends of the segments; ends that coincide share a label."""
    names = {"1": "1", "2": _block(ink), "H": "H"}
    groups: list[tuple[complex, list[str]]] = [(ink.foot, [ink.fixed])]
    for body, spot in ink.ends.items():
        near = next((texts for at, texts in groups if abs(at - spot) < TOGETHER), None)
        if near is None:
            groups.append((spot, [names[body]]))
        else:
            near.append(names[body])
    wanted = [Wanted(", ".join(texts), at, NUMBER, 0.8, 1j) for at, texts in groups]
    return [*wanted, Wanted("P", ink.pole, NUMBER, 0.8, -1j)]
