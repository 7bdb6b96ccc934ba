"""The ink of a sheet read back from its SVG, without the package: polylines and labels, mm from above left."""

from __future__ import annotations

import math
import re
import xml.etree.ElementTree as ET
from collections.abc import Iterator
from dataclasses import dataclass, field
from pathlib import Path

Point = tuple[float, float]
NS = "{http://www.w3.org/2000/svg}"
TOKEN = re.compile(r"[MLHVAZmlhvazCc]|[-+]?(?:\d+\.?\d*|\.\d+)(?:[eE][-+]?\d+)?")


@dataclass
class Line:
    """A polyline: its points, pen, width of its stroke (mm), the drawing it belongs to."""

    points: list[Point]
    pen: str
    width: float
    drawing: str
    filled: bool


@dataclass
class Lettering:
    """A label: what it says, its strokes, their width (mm), the drawing it belongs to."""

    text: str
    strokes: list[list[Point]]
    width: float
    drawing: str


@dataclass
class Inked:
    """A sheet: its size in mm, labels and lines."""

    width: float
    height: float
    labels: list[Lettering] = field(default_factory=list)
    lines: list[Line] = field(default_factory=list)

    def framed(self) -> tuple[float, float, float, float]:
        """Return the frame: the largest main line of what is drawn round the views."""
        return max(
            (_box(one.points) for one in self.lines if border(one.drawing) and one.pen == "main"),
            key=lambda box: (box[2] - box[0]) * (box[3] - box[1]),
        )


@dataclass(frozen=True)
class _Context:
    drawing: str = ""
    pen: str = ""
    width: float = 0.0


def border(drawing: str) -> bool:
    """Whether a drawing is the frame and title block."""
    return drawing.endswith("-frame")


def inked(file: Path) -> Inked:
    """Return the ink of an SVG file."""
    root = ET.parse(file).getroot()
    width, height = (float(v) for v in root.get("viewBox", "").split()[2:])
    sheet = Inked(width, height)
    _walk(root, _Context(), sheet)
    return sheet


def _walk(element: ET.Element, at: _Context, sheet: Inked) -> None:
    if element.tag == f"{NS}path":
        filled = element.get("fill") == "black"
        for points in polylines(element.get("d", "")):
            sheet.lines.append(Line(points, at.pen, at.width, at.drawing, filled))
        return
    if element.tag == f"{NS}defs":
        return
    kinds = (element.get("class") or "").split()
    if "words" in kinds:
        return
    at = _Context(
        (element.get("id") or "") if "drawing" in kinds else at.drawing,
        kinds[1] if kinds[:1] == ["pen"] else at.pen,
        float(element.get("stroke-width") or at.width),
    )
    if "label" in kinds:
        strokes = [one for p in element.iter(f"{NS}path") for one in polylines(p.get("d", ""))]
        said = element.get("aria-label") or ""
        sheet.labels.append(Lettering(said, strokes, at.width, at.drawing))
        return
    for child in element:
        _walk(child, at, sheet)


def polylines(path: str) -> list[list[Point]]:
    """Return the polylines of a path; arcs and curves in short chords."""
    found: list[list[Point]] = []
    at = start = (0.0, 0.0)
    for command, numbers in _commands(path):
        if command in "Zz":
            if found:
                found[-1].append(start)
            at = start
            continue
        base = at if command.islower() else (0.0, 0.0)
        if command in "Mm":
            at = start = (numbers[0] + base[0], numbers[1] + base[1])
            found.append([at])
            continue
        points = _points(command, numbers, at, base)
        found[-1] += points
        at = points[-1]
    return [one for one in found if len(one) > 1]


def _commands(path: str) -> Iterator[tuple[str, list[float]]]:
    """Yield single commands with their numbers; what is repeated without its letter, too."""
    counts = {"M": 2, "L": 2, "H": 1, "V": 1, "A": 7, "C": 6, "Z": 0}
    command, waiting = "", list[float]()
    for token in TOKEN.findall(path):
        if token.isalpha():
            command = token
            if command in "Zz":
                yield command, []
            continue
        waiting.append(float(token))
        if len(waiting) == counts[command.upper()]:
            yield command, waiting
            command, waiting = {"M": "L", "m": "l"}.get(command, command), []


def _points(command: str, numbers: list[float], at: Point, base: Point) -> list[Point]:
    kind = command.upper()
    if kind == "H":
        return [(numbers[0] + base[0], at[1])]
    if kind == "V":
        return [(at[0], numbers[0] + base[1])]
    ends = [(x + base[0], y + base[1]) for x, y in zip(numbers[-6::2], numbers[-5::2], strict=True)]
    if kind == "C":
        return [_bezier(at, ends, k / 8) for k in range(1, 9)]
    if kind == "A":
        return _arc(at, numbers, (numbers[5] + base[0], numbers[6] + base[1]))
    return [(numbers[0] + base[0], numbers[1] + base[1])]


def _bezier(at: Point, rest: list[Point], u: float) -> Point:
    share = ((1 - u) ** 3, 3 * u * (1 - u) ** 2, 3 * u * u * (1 - u), u**3)
    knots = (at, *rest)
    return (
        sum(s * x for s, (x, _) in zip(share, knots, strict=True)),
        sum(s * y for s, (_, y) in zip(share, knots, strict=True)),
    )


def _arc(at: Point, numbers: list[float], to: Point) -> list[Point]:
    """Return points of an arc of a circle (SVG 1.1, appendix F.6, both radii equal)."""
    radius, long, clockwise = numbers[0], bool(numbers[3]), bool(numbers[4])
    one, two = complex(*at), complex(*to)
    chord = two - one
    if radius == 0 or chord == 0:
        return [to]
    radius = max(radius, abs(chord) / 2)
    off = math.sqrt(max(radius**2 - abs(chord) ** 2 / 4, 0.0))
    side = -1 if long == clockwise else 1
    centre = (one + two) / 2 + side * off * 1j * chord / abs(chord)
    sweep = math.remainder(math.atan2(*_xy((two - centre) / (one - centre))[::-1]), math.tau)
    if clockwise and sweep < 0:
        sweep += math.tau
    if not clockwise and sweep > 0:
        sweep -= math.tau
    count = max(3, int(abs(sweep) / (math.pi / 2) * 6 * (1 + radius / 20)))
    turned = [
        centre + (one - centre) * complex(math.cos(a), math.sin(a))
        for a in (sweep * k / count for k in range(1, count + 1))
    ]
    return [_xy(z) for z in turned]


def _xy(z: complex) -> Point:
    return z.real, z.imag


def _box(points: list[Point]) -> tuple[float, float, float, float]:
    xs, ys = zip(*points, strict=True)
    return min(xs), min(ys), max(xs), max(ys)
