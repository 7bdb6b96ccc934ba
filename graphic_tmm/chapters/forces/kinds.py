"""The kinds of values of the sections of loads, effects, forces and friction."""

from __future__ import annotations

import re
from collections.abc import Callable, Container, Mapping, Sequence
from dataclasses import dataclass

from graphic_tmm.board.bounds import POSITIVE, Bound
from graphic_tmm.language.said import said
from graphic_tmm.scene import letters, quantities
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Kind, Names
from graphic_tmm.scene.misfits import fault_in_list, stands
from graphic_tmm.scene.units import Dimension

AGAINST = "against"
"""The direction of a load that resists: against the velocity of its point, or the rotation of its link."""
_SHARE = Bound(0, 100, above=True)
_RESISTING = (
    "against velocity",
    "against rotation",
    "against",
    "против скорости",
    "против вращения",
)
_SAYS = re.compile(
    r"(?:(?P<along>along|вдоль)|(?P<square>square to|перпендикулярно)|(?P<angle>.+?) (?:to|к)) (?P<line>\S+)"
)


@dataclass(frozen=True)
class Along:
    """A direction that turns with the links: of a line on the plan of positions, turned ``by`` degrees from it.

    ``line``: two letters, from the first to the second, or the name of a guide of any link.
    """

    line: str
    by: float = 0.0


def ends_on(
    between: tuple[str, str], links: Sequence[int], bodies: Mapping[int, Container[str]]
) -> tuple[int, int] | None:
    """Return the links that the ends of a spring are on, two of ``bodies``; None if there are no two.

    Those that are told, else the first that have the letters: the frame stands first.
    """
    first, last = ([n for n, own in bodies.items() if letter in own] for letter in between)
    if len(links) == 2:
        first, last = [links[0]], [links[1]]
    return next(((i, j) for i in first for j in last if i != j), None)


def _direction(value: object, names: Names) -> float | str | Along:
    if value in _RESISTING:
        return AGAINST
    told = _SAYS.fullmatch(value) if isinstance(value, str) else None
    try:
        if told is None:
            return quantities.parse(value, "angle")
        by = 90.0 if told["square"] else 0.0
        return Along(
            told["line"], quantities.parse(told["angle"], "angle") if told["angle"] else by
        )
    except ValueError:
        raise ValueError(
            stands(
                value,
                said(
                    'write "against velocity", "against rotation", the angle from the x axis, "-90 deg", or '
                    'what turns with a link: "along AC", "square to AC", "30 deg to AC"'
                ),
            )
        ) from None


def _size(value: object, names: Names) -> float:
    """Return a force or a moment: which of the two its unit tells, and the section asks for."""
    dimension: Dimension = "moment" if _is_moment(value) else "force"
    return quantities.parse(value, dimension)


def _is_moment(value: object) -> bool:
    try:
        quantities.parse(value, "force")
    except ValueError:
        return isinstance(value, str) and any(sign in value for sign in "*·⋅")
    return False


def _sizes(value: object, names: Names) -> tuple[float, ...]:
    if not isinstance(value, list) or not value:
        raise ValueError(stands(value, said('write the size in each position, ["190 N", "0 N"]')))
    return tuple(_size(item, names) for item in value)


_AT: Mapping[str, tuple[str, Callable[[object], float]]] = {
    "share": ("1", v.within),
    "angle": ('"90 deg"', lambda value: quantities.parse(value, "angle")),
    "time": ('"0.05 s"', lambda value: quantities.parse(value, "time")),
}
"""By what sizes are given: an example of it, what reads it."""


def _pairs(value: object, names: Names, by: str) -> tuple[tuple[float, float], ...]:
    """Return points of a table: a share of the travel, an angle or a time, and the size there."""
    last, read = _AT[by]
    example = f'[[0, "0 N"], [{last}, "190 N"]]'
    if not isinstance(value, list) or len(value) < 2:
        remedy = said("write points of the table, {example}", example=example)
        raise ValueError(stands(value, remedy))
    found = []
    for item in value:
        if not isinstance(item, list) or len(item) != 2:
            remedy = said("a point is a list of two, {example}", example=example)
            raise ValueError(fault_in_list(item, remedy))
        found.append((read(item[0]), _size(item[1], names)))
    v.follow([at for at, _ in found])
    if by == "angle" and not (found[0][0] >= 0 and found[-1][0] <= 720):
        raise ValueError(
            said("the angles go from 0 to 360°, from the zero position on, of two turns to 720°")
        )
    if by == "time" and found[0][0] < 0.0:
        raise ValueError(said("times are counted from the zero position on"))
    return tuple(found)


def _limit(value: object, names: Names) -> float:
    found = quantities.parse(value, "ratio") * 100 if isinstance(value, str) else value
    if not _SHARE.holds(found):
        raise ValueError(stands(value, said('write a share, "5 %"')))
    return float(found)  # type: ignore[arg-type]


def _links(value: object, names: Names) -> tuple[int, ...]:
    whole_numbers = isinstance(value, list) and all(
        isinstance(item, int) and not isinstance(item, bool) for item in value
    )
    if not isinstance(value, list) or not whole_numbers:
        raise ValueError(stands(value, said("a list of links is wanted, [3]")))
    return tuple(value)


def _stiffness(value: object, names: Names) -> float:
    """Return a rate, N/m; N/mm, which elsewhere tells a scale factor, is one for each millimetre of length."""
    try:
        return quantities.parse(value, "stiffness")
    except ValueError:
        text = str(value)
        for unit in ("N/mm", "Н/мм"):
            if isinstance(value, str) and text.rstrip().endswith(unit):
                longer = text.rstrip().removesuffix(unit) + unit[:3]
                return 1000.0 * quantities.parse(longer, "stiffness")
        raise


def _positive(read: Callable[[object, Names], float]) -> Callable[[object, Names], float]:
    def checked(value: object, names: Names) -> float:
        found = read(value, names)
        if not found > 0.0:
            raise ValueError(stands(value, said("{bound} is wanted", bound=POSITIVE.wanted)))
        return found

    return checked


def _ends(value: object, names: Names) -> tuple[str, str]:
    if not isinstance(value, list) or [type(one) for one in value] != [str, str]:
        raise ValueError(stands(value, said('write the letters of both ends, ["A", "C"]')))
    return value[0], value[1]


STIFFNESS = Kind(_positive(_stiffness), v.SCALE, POSITIVE, "stiffness")
DAMPING = v.quantity("damping", POSITIVE)
ENDS = Kind(
    _ends,
    {"type": "array", "items": {"type": "string"}, "minItems": 2, "maxItems": 2},
    renamed=letters.renamed,
)
FORCE = Kind(lambda value, names: quantities.parse(value, "force"), v.SCALE, unit="force")
MOMENT = Kind(
    lambda value, names: quantities.parse(value, "moment"),
    {"type": ["number", "string"]},
    unit="moment",
)
DIRECTION = Kind(
    _direction,
    {"type": ["number", "string"]},
    unit="angle",
    renamed=lambda value, names: (
        letters.last_renamed(value, names) if isinstance(_direction(value, {}), Along) else value
    ),
)
SIZES = Kind(_sizes, v.ROW, unit="force")
BY_ANGLE = Kind(lambda value, names: _pairs(value, names, "angle"), v.PAIRS)
BY_TIME = Kind(lambda value, names: _pairs(value, names, "time"), v.PAIRS)
BY_TRAVEL = Kind(lambda value, names: _pairs(value, names, "share"), v.PAIRS)
COEFFICIENT = v.number(Bound(0, 2))
LIMIT = Kind(_limit, v.bounded(_SHARE, "ratio"), _SHARE, "ratio")
OF = Kind(
    lambda value, names: (
        v.LINK_NUMBER.read(value, names) if isinstance(value, int) else v.TEXT.read(value, names)
    ),
    {"type": ["integer", "string"]},
    renamed=letters.renamed,
)
LINE = v.quantity("angle")
START = v.choice(
    "left", "right", "top", "bottom", v.CLOCKWISE, v.COUNTERCLOCKWISE,
    слева="left", справа="right", сверху="top", снизу="bottom",
    по_часовой_стрелке=v.CLOCKWISE, против_часовой_стрелки=v.COUNTERCLOCKWISE,
)  # fmt: skip
LINKS = Kind(_links, {"type": "array", "items": {"type": "integer"}}, renamed=letters.renamed)
BALANCE = v.choice("force", "moment", сила="force", момент="moment")
COUPLES = v.choice("moment", "pair", момент="moment", пара="pair")
PASSES = v.number(Bound(2, 50, whole=True))
