"""What the student reads off the plans: which two points each segment joins, as the task's form names them."""

from __future__ import annotations

from typing import NamedTuple

from .hand import Hand
from .machines import Machine
from .plans import Factors, Position

LENGTHS = {
    "slider": (
        {"pa": "a", "ab": "a b", "pb": "b", "ps2": "s2"},
        {"πa": "a", "an2": "a n2", "n2b": "n2 b", "πb": "b", "πs2": "s2"},
    ),
    "rocker": (
        {"pa": "a", "ab": "a b", "pb": "b", "pe": "e"},
        {"πa": "a", "an2": "a n2", "πn3": "n3", "n2b": "n2 b", "n3b": "n3 b", "πb": "b", "πe": "e"},
    ),
    "slot": (
        {"pa": "a", "aa3": "a a3", "pa3": "a3", "pc": "c"},
        {
            "πa": "a",
            "ak2": "a k2",
            "πn3": "n3",
            "k2a3": "k2 a3",
            "n3a3": "n3 a3",
            "πc": "c",
            "πa3": "a3",
        },
    ),
}
"""Of each kind of mechanism: velocities, accelerations."""


class Figure(NamedTuple):
    """One figure of the drawing: mm that were read, a quantity in its unit, or a place in mm from the pole."""

    plan: str
    position: int
    segment: str
    mm: float | None = None
    value: float | None = None
    unit: str = ""
    spot: complex | None = None


def _lengths(machine: Machine) -> tuple[dict[str, str], dict[str, str]]:
    v, a = (dict(one) for one in LENGTHS[machine.kind])
    if machine.CD:
        v |= {"cd": "c d", "pd": "d"}
        a |= {"cn4": "c n4", "n4d": "n4 d", "πd": "d"}
    if machine.S1:
        v["ps1"], a["πs1"] = "s1", "s1"
    if machine.S3:
        v["ps3"], a["πs3"] = "s3", "s3"
    return v, a


def measured(
    machine: Machine, mu: Factors, hand: Hand, k: int, drawn: Position, zero: Position
) -> list[Figure]:
    """Return all that is read of a position; ``zero``: the first one, from which the way is counted."""
    rows: list[Figure] = []
    v, a = _lengths(machine)
    places = drawn.places.points
    if machine.kind == "slot":
        mm = drawn.read["BA"]
        rows.append(Figure("positions", k, "BA", mm, mm * mu.l, "m"))
    if machine.travel:
        end = machine.travel[1]
        mm = hand.measure(places[end] - zero.places.points[end]) if drawn is not zero else 0.0
        rows.append(Figure("positions", k, machine.travel, mm, mm * mu.l, "m"))
    rows += [Figure("positions", k, name, spot=at) for name, at in places.items()]
    for plan, names, drawing, scale, unit in (
        ("velocities", v, drawn.velocities, mu.v, "m/s"),
        ("accelerations", a, drawn.accelerations, mu.a, "m/s²"),
    ):
        if drawing is None:
            continue
        for segment, ends in names.items():
            at = [0j, *(drawing.points[end] for end in ends.split())][-2:]
            laid = drawing.laid.get(segment)
            mm = hand.measure(at[1] - at[0]) if laid is None else round(laid, 1)
            mm = drawn.read.get(segment, mm)
            rows.append(Figure(plan, k, segment, mm, (mm if laid is None else laid) * scale, unit))
        rows += [Figure(plan, k, name, spot=at) for name, at in drawing.points.items()]
    for name, rate in drawn.rates.items():
        plan, unit = ("velocities", "1/s") if name[0] == "o" else ("accelerations", "1/s²")
        rows.append(Figure(plan, k, name, None, rate, unit))
    return rows
