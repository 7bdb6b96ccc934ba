"""The table that a student fills in: what he writes down, in which columns, order, places and signs."""

from __future__ import annotations

from collections.abc import Callable, Sequence
from typing import NamedTuple

import numpy as np

from .hand import Hand, digits
from .measured import Figure
from .plans import Factors

WAYS = ("mm", "mm and rates", "mm and values", "values", "points")
"""What is written: lengths; lengths and ω, ε; length and quantity in each row; quantities and μ; points."""
POINTED = ("positions", "velocities", "accelerations")
UNIT = {
    "positions": "m/mm",
    "velocities": "(m/s)/mm",
    "accelerations": "(m/s²)/mm",
    "forces": "N/mm",
}
Move = Callable[[complex], complex]
MOVES: dict[str, dict[str, Move]] = {
    "as it is": {},
    "velocities turned by 90": {"velocities": lambda z: z * 1j},
    "turned by 180": dict.fromkeys(POINTED, lambda z: -z),
    "turned by -90": dict.fromkeys(POINTED, lambda z: z * -1j),
    "y downwards": dict.fromkeys(POINTED, lambda z: z.conjugate()),
    "x leftwards": dict.fromkeys(POINTED, lambda z: -z.conjugate()),
    "x and y exchanged": dict.fromkeys(POINTED, lambda z: complex(z.imag, z.real)),
    "sheet": {},
    "own origin": {},
}
"""How plans lie by his own axes; ``sheet``: from its corner; ``own origin``: so, and the pole is written."""


class Manner(NamedTuple):
    """How a student writes."""

    way: str
    move: str = "as it is"
    signed: bool = True
    count: int = 4
    by_position: bool = True
    russian: bool = False
    comma: bool = False
    separator: str = ","
    mu_rows: bool = False


def manner_of(rng: np.random.Generator, way: str | None = None) -> Manner:
    """Return a manner by chance."""
    way = way or str(rng.choice(WAYS))
    comma = bool(rng.random() < 0.5)
    return Manner(
        way,
        str(rng.choice(list(MOVES))) if way == "points" else "as it is",
        bool(rng.random() < 0.7),
        int(rng.choice([3, 4, 4])),
        bool(rng.random() < 0.5),
        bool(rng.random() < 0.5),
        comma,
        ";" if comma else str(rng.choice([",", ";", "\t"])),
        way == "values" or bool(rng.random() < 0.15),
    )


def written(figures: Sequence[Figure], manner: Manner, hand: Hand) -> list[Figure]:
    """Return the figures as they are written in a manner."""
    rows: list[Figure] = []
    origins: dict[tuple[str, int], complex] = {}
    for one in figures:
        if one.spot is None:
            rows += _figure(one, manner)
        elif manner.way == "points":
            rows.append(one._replace(spot=_moved(one, manner, hand, origins)))
    if manner.move == "own origin":
        names = {"positions": "O", "velocities": "p", "accelerations": "π"}
        rows += [
            Figure(plan, k, names[plan], spot=_read(at, hand)) for (plan, k), at in origins.items()
        ]
    return rows


def _figure(one: Figure, manner: Manner) -> list[Figure]:
    """Return a length or a quantity as it is written, if it is."""
    loads, rate = one.plan in ("forces", "diagrams"), one.mm is None
    value = digits(one.value, manner.count) if one.value is not None else None
    if value is not None and not manner.signed and one.plan != "diagrams":
        value = abs(value)
    full = one._replace(value=value)
    if loads or rate:
        if manner.way == "mm" and not loads:
            return []
        if manner.way == "values":
            return [full._replace(mm=None)]
        return [full if rate or manner.way == "mm and values" else full._replace(value=None)]
    written_as = {
        "mm": full._replace(value=None),
        "mm and rates": full._replace(value=None),
        "mm and values": full,
        "values": full._replace(mm=None),
    }
    return [written_as[manner.way]] if manner.way in written_as else []


def _read(at: complex, hand: Hand) -> complex:
    return complex(hand.coordinate(at.real), hand.coordinate(at.imag))


def _moved(
    one: Figure, manner: Manner, hand: Hand, origins: dict[tuple[str, int], complex]
) -> complex:
    """Return where a point lies by the student's own axes, as it is read."""
    assert one.spot is not None
    at = MOVES[manner.move].get(one.plan, complex)(one.spot)
    if manner.move in ("sheet", "own origin"):
        key = one.plan, one.position
        if key not in origins:
            first = next(
                (z for (plan, _), z in origins.items() if plan == one.plan == "positions"), None
            )
            drawn = complex(
                round(hand.rng.uniform(100, 700), 1), round(hand.rng.uniform(100, 450), 1)
            )
            origins[key] = drawn if first is None else first
        at += origins[key]
    return _read(at, hand)


def text(figures: Sequence[Figure], manner: Manner, mu: Factors, unit: str = "mm") -> str:
    """Return the table as a file of a spreadsheet."""
    head = ["plan", "position", "segment", unit, "value", "unit", "x", "y"]
    if manner.russian:
        head = ["план", "положение", "отрезок", "мм", "величина", "единица", "x", "y"]
    rows = [head]
    plans = list(dict.fromkeys(one.plan for one in figures))
    if manner.mu_rows:
        scale = {"positions": mu.l, "velocities": mu.v, "accelerations": mu.a, "forces": mu.F}
        rows += [
            [plan, "", "μ", "", _number(scale[plan], manner), UNIT[plan], "", ""]
            for plan in plans
            if plan in scale
        ]
    segments = list(dict.fromkeys((one.plan, one.segment) for one in figures))
    at = {key: i for i, key in enumerate(segments)}

    def order(one: Figure) -> tuple[int, ...]:
        place = at[one.plan, one.segment]
        return (
            (plans.index(one.plan), one.position, place)
            if manner.by_position
            else (place, one.position)
        )

    for one in sorted(figures, key=order):
        x, y = (
            ("", "")
            if one.spot is None
            else (_number(one.spot.real, manner), _number(one.spot.imag, manner))
        )
        mm = "" if one.mm is None else _number(one.mm, manner)
        value = "" if one.value is None else _number(one.value, manner)
        rows.append(
            [one.plan, str(one.position), one.segment, mm, value, one.unit if value else "", x, y]
        )
    return "\n".join(manner.separator.join(row) for row in rows) + "\n"


def _number(figure: float, manner: Manner) -> str:
    shown = f"{figure:.10g}"
    if "e" in shown:
        shown = f"{figure:.10f}".rstrip("0").rstrip(".")
    return shown.replace(".", ",") if manner.comma else shown
