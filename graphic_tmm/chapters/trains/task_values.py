"""How values of a planetary train are written: teeth, rows of wheels, speeds, members, satellites."""

from __future__ import annotations

from typing import Any

from graphic_tmm.board.bounds import Bound
from graphic_tmm.language.said import said
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Kind, Names
from graphic_tmm.scene.misfits import stands

TEETH = Bound(1, 1000, whole=True)
_SATELLITES = Bound(1, 49, whole=True)
_BOUND = Bound(-10_000, 10_000)


def either(kind: Kind) -> dict[str, Any]:
    """Return the schema of a value, or of a list of two."""
    own = kind.schema({})
    return {"anyOf": [own, {"type": "array", "items": own, "minItems": 2, "maxItems": 2}]}


def _ratio(value: object, names: Names) -> float:
    if not _BOUND.holds(value) or value == 0:
        raise ValueError(stands(value, said("a ratio is a number, 4.55, negative if it reverses")))
    return float(value)  # type: ignore[arg-type]


def _teeth(value: object, names: Names) -> tuple[int | None, ...]:
    """Return tooth numbers; None for one that is to be found, written "?"."""

    def fine(z: object) -> bool:
        return z == "?" or (isinstance(z, int) and TEETH.holds(z))

    if not isinstance(value, list) or not all(fine(z) for z in value):
        raise ValueError(
            stands(
                value,
                said(
                    'a list of tooth numbers is wanted, [25, "?", "?"]: a "?" for one to be found'
                ),
            )
        )
    return tuple(None if z == "?" else z for z in value)


def _rows(value: object, names: Names) -> tuple[tuple[int, ...], ...]:
    several = isinstance(value, list) and any(isinstance(one, list) for one in value)
    try:
        rows = [_teeth(row, names) for row in (value if several else [value])]  # type: ignore[attr-defined]
    except ValueError:
        rows = [(None,)]
    if any(None in row for row in rows):
        says = said("tooth numbers of a pair that stands already are wanted, [15, 25]")
        raise ValueError(stands(value, says))
    return tuple(row for row in rows if row)  # type: ignore[misc]


def _speeds(value: object, names: Names) -> float | tuple[float, ...]:
    if not isinstance(value, list):
        return _SIGNED.read(value, names)  # type: ignore[no-any-return]
    if len(value) != 2:
        says = said('two shafts of a differential drive: write ["100 rpm", "-20 rpm"]')
        raise ValueError(stands(value, says))
    found = tuple(_SIGNED.read(one, names) for one in value)
    if 0.0 in found:
        says = said(
            "a shaft that stands does not drive: give the speed of the other alone, and what is fixed"
        )
        raise ValueError(stands(value, says))
    return found


def _drivers(value: object, names: Names) -> str | tuple[str, ...]:
    if not isinstance(value, list):
        return MEMBER.read(value, names)  # type: ignore[no-any-return]
    found = tuple(MEMBER.read(one, names) for one in value)
    if len(found) != 2 or found[0] == found[1]:
        raise ValueError(stands(value, said('two different members drive: write ["1", "H"]')))
    return found


def _closed(value: object, names: Names) -> tuple[tuple[str, tuple[int, ...]], ...]:
    says = said(
        "two shafts are wanted, each with the wheels on it and onward to a shaft of both; "
        'write [["H", 30, 20], ["3", 32, 18]]'
    )
    rows = value if isinstance(value, list) else []
    if value == []:
        return ()
    if len(rows) != 2 or not all(isinstance(row, list) and len(row) > 2 for row in rows):
        raise ValueError(stands(value, says))
    found = tuple((MEMBER.read(row[0], names), *_rows(row[1:], names)) for row in rows)
    if found[0][0] == found[1][0]:
        raise ValueError(stands(value, says))
    return found


def _satellites(value: object, names: Names) -> tuple[int, ...]:
    listed = value if isinstance(value, list) else [value]
    if not listed or not all(isinstance(k, int) and _SATELLITES.holds(k) for k in listed):
        raise ValueError(stands(value, said("write a number of satellites, 3, or [3, 4]")))
    return tuple(listed)


COUNT = v.number(TEETH)
_SIGNED = v.quantity("angular speed")
MEMBER = v.choice("1", "3", "4", "5", "H")
SPEEDS = Kind(_speeds, either(_SIGNED), unit="angular speed")
DRIVERS = Kind(_drivers, either(MEMBER))
RATIO = Kind(_ratio, v.bounded(_BOUND), _BOUND)
SOME_TEETH = Kind(
    _teeth,
    {
        "type": "array",
        "items": {"anyOf": [dict(TEETH.schema), {"type": "string", "const": "?"}]},
    },
    TEETH,
)
_ROW = {"type": "array", "items": dict(TEETH.schema)}
_SHAFT = {
    "type": "array",
    "items": {"anyOf": [dict(TEETH.schema), MEMBER.schema({})]},
    "minItems": 3,
}
CLOSED = Kind(_closed, {"type": "array", "items": _SHAFT, "maxItems": 2}, TEETH)
ROWS = Kind(_rows, {"type": "array", "items": {"anyOf": [dict(TEETH.schema), _ROW]}}, TEETH)
SATELLITES = Kind(
    _satellites,
    {
        "anyOf": [
            dict(_SATELLITES.schema),
            {"type": "array", "items": dict(_SATELLITES.schema), "minItems": 1},
        ]
    },
    _SATELLITES,
)
