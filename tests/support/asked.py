"""Scenes as students ask for them, as TOML text: own mechanisms and parts, any sheets, any row."""

from __future__ import annotations

from collections.abc import Sequence

import numpy as np

from graphic_tmm.board.values import Point
from graphic_tmm.drawn import Drawn

SLIDER = """
[frame]
O = [0, 0]
x = {{ through = [0, 0], angle = "0 deg" }}
[[link]]
number = 1
points = {{ O = [0, 0], A = ["90 mm", 0] }}
mass = "2 kg"
J = "0.01 kg*m^2"
centre = "O"
[[link]]
number = 2
points = {{ A = [0, 0], B = ["340 mm", 0], S2 = ["120 mm", 0] }}
mass = "3 kg"
centre = "S2"
J = "0.04 kg*m^2"
[[link]]
number = 3
points = {{ B = [0, 0] }}
slides = {{ on = "frame", along = "x", side = "right" }}
mass = "4 kg"
centre = "B"
[[load]]
link = 3
point = "B"
force = "900 N"
{common}
[indicator]
point = "B"
bore = "120 mm"
[indicator.cover_points]
out = [[0, "600 kPa"], [0.3, "600 kPa"], [1, "150 kPa"]]
back = [[1, "30 kPa"], [0, "60 kPa"]]
[engine]
point = "B"
{diagrams}
"""
"""A slider-crank that can be asked for everything, an engine's forces too."""

SIX = """
[frame]
O = [0, 0]
C = ["330 mm", "-40 mm"]
x = {{ through = [0, "150 mm"], angle = "0 deg" }}
[[link]]
number = 1
points = {{ O = [0, 0], A = ["70 mm", 0] }}
mass = "2 kg"
J = "0.01 kg*m^2"
centre = "O"
[[link]]
number = 2
points = {{ A = [0, 0], B = ["310 mm", 0], S2 = ["150 mm", 0] }}
mass = "3 kg"
centre = "S2"
J = "0.04 kg*m^2"
[[link]]
number = 3
points = {{ C = [0, 0], B = ["160 mm", 0], D = ["240 mm", 0], S3 = ["120 mm", 0] }}
side = "left of AC"
mass = "2 kg"
centre = "S3"
J = "0.02 kg*m^2"
[[link]]
number = 4
points = {{ D = [0, 0], E = ["400 mm", 0], S4 = ["150 mm", 0] }}
mass = "2.5 kg"
centre = "S4"
J = "0.05 kg*m^2"
[[link]]
number = 5
points = {{ E = [0, 0] }}
slides = {{ on = "frame", along = "x", side = "right" }}
mass = "6 kg"
centre = "E"
[[load]]
link = 5
point = "E"
force = "1200 N"
{common}
{diagrams}
"""
"""A rocker that drives a slider: five moving links."""

COMMON = """
[drive]
link = 1
speed = "300 rpm"
positions = {positions}
zero = "{zero}"
accelerations = [{at}]
{extra}
[effects]
gravity = true
inertia = true
[forces]
positions = [{at}]
[plans]
velocity_pole = "{pole}"
"""

DIAGRAMS = """
[diagrams]
point = "{point}"
[flywheel]
delta = 0.05
D_e = "0.5 m"
"""

CAM = """
[cam]
stroke = "40 mm"
rise = "110 deg"
upper_dwell = "30 deg"
fall = "120 deg"
"""
GEARS = """
[gears]
z1 = 17
z2 = 43
m = "5 mm"
x1 = 0.4
x2 = 0.2
"""
PLANETARY = """
[planetary]
scheme = "ring"
module = "4 mm"
speed = "1400 rpm"
ratio = 5.6
tolerance = "1 %"
satellites = 3
"""

MECHANISMS = {"slider": (SLIDER, "B", "0 deg"), "six": (SIX, "E", "15 deg")}
PARTS = {"cam": CAM, "gears": GEARS, "planetary": PLANETARY}


def sheet(format: str, places: Sequence[str]) -> str:
    """Return a section of a sheet."""
    listed = ", ".join(f'"{place}"' for place in places)
    return f'[[sheet]]\nformat = "{format}"\nplace = [{listed}]\n'


def mechanism(
    kind: str,
    positions: int,
    sheets: Sequence[tuple[str, Sequence[str]]],
    *,
    language: str = "ru",
    extra: bool = False,
    pole: str = "own",
    scales: str = "",
) -> str:
    """Return a scene of a mechanism: "slider" or "six". Diagrams need four positions at least."""
    body, point, zero = MECHANISMS[kind]
    at = ", ".join(str(k) for k in dict.fromkeys((0, positions // 3, (2 * positions) // 3)))
    further = 'extra = ["100 deg", "215 deg"]' if extra else ""
    common = COMMON.format(positions=positions, zero=zero, at=at, extra=further, pole=pole)
    diagrams = DIAGRAMS.format(point=point) if positions >= 4 else ""
    text = body.format(common=common, diagrams=diagrams)
    if positions < 4:
        text = text.partition("[indicator]")[0]
    orders = "".join(sheet(*one) for one in sheets)
    return f'title = "T"\nlanguage = "{language}"\n{text}\n{scales}\n{orders}'


def part(kind: str, format: str, *, language: str = "ru", divisions: int | None = None) -> str:
    """Return a scene of a part: "cam", "gears" or "planetary"."""
    more = f"divisions = {divisions}\n" if divisions is not None else ""
    return f'title = "T"\nlanguage = "{language}"\n{PARTS[kind]}{more}{sheet(format, [kind])}'


PLACES = (
    "positions",
    "velocities",
    "accelerations",
    "equations",
    "diagrams",
    "forces",
    "lever",
    "force table",
    "flywheel",
    "engine",
    "engine diagrams",
    "structure",
    "results",
    "velocity table",
    "acceleration table",
)
"""What a sheet of a mechanism can be asked for."""
PLANS = ("velocities", "accelerations")
WITH = {
    "equations": PLANS,
    "results": PLANS,
    "velocity table": PLANS[:1],
    "acceleration table": PLANS[1:],
}
"""What a place tells of, and so is placed with it."""
ENGINE = ("engine", "engine diagrams")
FOUR = ("diagrams", "flywheel", *ENGINE)
"""What needs four positions at least."""


def can(kind: str, place: str, positions: int) -> bool:
    """Whether a mechanism can be asked for a place at all."""
    return (positions >= 4 or place not in FOUR) and (kind == "slider" or place not in ENGINE)


def longest(work: Drawn, plan: str) -> float:
    """The longest absolute vector of a plan as drawn, mm; without end if there is no such plan."""
    log = work.project.construction
    reading = work.of("accelerations") if plan == "accelerations" else work.reading
    view = log.view(plan)
    if view is None or reading is None or plan not in work.scales:
        return float("inf")
    marks = [s.it for s in log.steps if s.it.view == plan and s.it.kind is Point]
    return float(max(np.nanmax(np.abs(reading[mark])) for mark in marks))
