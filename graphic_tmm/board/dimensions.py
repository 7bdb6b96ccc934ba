"""Units of formulas as dimensions: what may be added, and what follows from a product.

Board millimetres (mm) are a dimension of their own beside metres: a scale factor in m/mm turns one into the
other, and a formula that forgets it does not come out. So are degrees (°), which only a factor with ° or a
function of angles turns into a plain number, and kgf. A radian, a per cent and a count are plain numbers; so
is a mark without a unit. Turns a minute (rpm) differ from 1/s by a plain factor. A zero agrees with any unit.
"""

from __future__ import annotations

from collections.abc import Mapping
from functools import lru_cache

from graphic_tmm.board.formula import FORMULAS
from graphic_tmm.board.formula_text import FUNCTIONS, KEEPING, ORDERS, Node, names_of, tree_of
from graphic_tmm.board.values import Angle, Kind, Length

Dimension = tuple[tuple[str, float], ...]
"""Powers of base units, in the order of their names, none of them 0."""

PLAIN: Dimension = ()
_NAMED = {
    "N": "kg·m/s²",
    "J": "kg·m²/s²",
    "W": "kg·m²/s³",
    "Pa": "kg/(m·s²)",
    "rad": "1",
    "%": "1",
    "rpm": "1/s",
}
_KNOWN: dict[str, Dimension] = {base: ((base, 1.0),) for base in ("kg", "kgf", "m", "mm", "s", "°")}


class UnitError(ValueError):
    """Units of a formula do not go together; the message says which."""


def unit_of(kind: Kind, told: str) -> str:
    """Return the unit of a mark: that told, else mm of a length and degrees of an angle."""
    return told or {Length: "mm", Angle: "°"}.get(kind, "")


@lru_cache(maxsize=1024)
def fault(name: str, units: tuple[str, ...], unit: str) -> str:
    """Return what is wrong where a formula of marks with these units is to leave ``unit``; "" if nothing is."""
    try:
        found = derived(name, units)
        told = dimension(unit)
    except UnitError as error:
        return str(error)
    if found == told:
        return ""
    return (
        f"leaves {spoken(found)}, but '{unit}' is told"
        if unit
        else f"leaves {spoken(found)}: tell its unit"
    )


def derived(name: str, units: tuple[str, ...]) -> Dimension:
    """Return the dimension of what a formula makes of marks with these units.

    Raises
    ------
    UnitError
        If it adds or compares what has different units, or takes a function of what has one.
    """
    formula = FORMULAS[name]
    given = dict(zip(formula.arguments, map(dimension, units), strict=True))
    if formula.condition is not None:
        _of(formula.condition, given)
    found = _of(formula.tree, given)
    return PLAIN if found is None else found


@lru_cache(maxsize=1024)
def dimension(unit: str) -> Dimension:
    """Return the dimension of a unit, as it is written in the log: "(m/s)/mm", "kg·m²", "".

    Raises
    ------
    UnitError
        If it is no such unit.
    """
    if unit in _NAMED and unit not in _KNOWN:
        _KNOWN[unit] = dimension(_NAMED[unit])
    if not unit or unit in _KNOWN:
        return _KNOWN.get(unit, PLAIN)
    try:
        tree = tree_of(unit, ())
        if not tree.parts and tree.head == "name":
            raise ValueError(unit)
        return _of(tree, {name: dimension(name) for name in names_of(tree)}) or PLAIN
    except ValueError as error:
        raise UnitError(f"'{unit}' is no unit of the board") from error


def spoken(found: Dimension) -> str:
    """Return a dimension as a unit is written; mass in a force is told in newtons."""
    powers = dict(found)
    force = powers.get("kg", 0.0)
    if force and powers.get("s") == -2.0 * force:
        powers |= {"N": force, "kg": 0.0, "s": 0.0, "m": powers.get("m", 0.0) - force}
    order = ("N", "kg", "kgf", "m", "mm", "s", "°")
    above = [_raised(base, powers[base]) for base in order if powers.get(base, 0.0) > 0.0]
    below = [_raised(base, -powers[base]) for base in order if powers.get(base, 0.0) < 0.0]
    text = "·".join(above) or "1"
    if below:
        text += "/" + (below[0] if len(below) == 1 else f"({'·'.join(below)})")
    return text if text != "1" else "a plain number"


def _raised(base: str, power: float) -> str:
    return base if power == 1.0 else base + {2.0: "²", 3.0: "³", 4.0: "⁴"}.get(power, f"^{power:g}")


Known = Dimension | None
"""The dimension of a part of a formula; None of a zero, which agrees with all."""


def _of(node: Node, given: Mapping[str, Dimension]) -> Known:
    if not node.parts:
        return _of_leaf(node, given)
    parts = [_of(part, given) for part in node.parts]
    if node.head in ("·", "/"):
        return _product(parts, 1.0 if node.head == "·" else -1.0)
    if node.head == "^":
        return _power(parts, node.parts[1])
    if node.head == "sqrt":
        return _scaled(parts[0], 0.5)
    if node.head in FUNCTIONS and node.head not in KEEPING:
        return _function(node.head, parts)
    return None if node.head == "and" else _alike(node.head, parts)


def _of_leaf(node: Node, given: Mapping[str, Dimension]) -> Known:
    if node.head == "name":
        return given[node.word]
    if node.head == "°":
        return dimension("°")
    return None if node.head == "figure" and float(node.word) == 0.0 else PLAIN


def _function(name: str, parts: list[Known]) -> Known:
    takes = dimension("°") if name == "radians" else PLAIN
    for part in parts:
        if part not in (takes, None) and name != "sgn":
            raise UnitError(f"takes {name} of {spoken(part or PLAIN)}")
    return dimension("°") if name == "degrees" else PLAIN


def _alike(head: str, parts: list[Known]) -> Known:
    found = [part for part in parts if part is not None]
    for other in found[1:]:
        if other != found[0]:
            done = _DONE.get(head, "compares")
            raise UnitError(f"{done} {spoken(found[0])} and {spoken(other)}")
    return found[0] if found and head not in ORDERS else None


_DONE = {"+": "adds", "−": "subtracts", "±": "adds"}


def _power(parts: list[Known], exponent: Node) -> Known:
    if exponent.head == "figure":
        return _scaled(parts[0], float(exponent.word))
    for part in parts:
        if part not in (PLAIN, None):
            raise UnitError(
                f"raises to a power what has, or by what has, the unit {spoken(part or PLAIN)}"
            )
    return PLAIN


def _scaled(found: Known, by: float) -> Known:
    return None if found is None else tuple((base, power * by) for base, power in found)


def _product(parts: list[Known], sign: float) -> Known:
    if None in parts:
        return None
    powers: dict[str, float] = {}
    for part, by in zip(parts, (1.0, sign), strict=True):
        for base, power in part or ():
            powers[base] = powers.get(base, 0.0) + by * power
    return tuple(sorted((base, power) for base, power in powers.items() if power))
