"""What is asked of kinematic diagrams: the point, what is taken, scales (SI; drawn lengths in mm).

Standard scale factors stand in place of those that a base and pole distances lead to; these then follow.
"""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING, Any, NamedTuple

from graphic_tmm.board.charts import STANDARD, ScaleOrder
from graphic_tmm.board.grammar import Operation
from graphic_tmm.board.operations.formulas import scale_of_derivative, scale_of_integral
from graphic_tmm.board.scales import nearest
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Said, Section, combined_key, key
from graphic_tmm.scene.tasks import SectionKey

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts


DIAGRAMS = "diagrams"
VIEWS = {"S": "diagram S", "V": "diagram V", "a": "diagram a"}
BASE_VIEW = "base"
"""Under which the scale of the common base is told."""
CALCULATED = "diagrams-calculation"
"""The view of what is calculated beside."""


_START = v.choice("displacement", "velocity", перемещение="displacement", скорость="velocity")
_OVER = v.choice("time", "angle", время="time", угол="angle")
_INTEGRAL = v.choice("drawn", "none", строится="drawn", нет="none")
_METHOD = v.choice("chords", "tangents", хорды="chords", касательные="tangents")


@dataclass(frozen=True)
class KinematicTask:
    """Kinematic diagrams of a point that slides on the frame.

    ``start``: what is taken from the plans, "displacement" (differentiated twice) or "velocity"
    (differentiated once, and integrated once unless ``integral`` is "none"). ``over``: "time" or "angle".
    ``method``: "chords" or "tangents".
    The base is ``base`` mm long, or so long that 1 mm is ``mu_along`` (s or rad). ``standard``: the scale
    factors that base and pole distances lead to are rounded to standard ones, and these lengths follow.
    """

    point: str = key(v.LETTER, "the letter of the point", "D")
    start: str = key(_START, "what is taken from the plans", "displacement", "displacement")
    over: str = key(_OVER, "what the base stands for", "time", "time")
    method: str = key(_METHOD, "how it is differentiated", "chords", "chords")
    base: float | None = key(
        v.DRAWN, "length of the base; if none is given, 180 mm on an A1", "120 mm", None,
        fixes="size",
    )  # fmt: skip
    mu_along: float | None = combined_key(
        lambda said: said.mu_t or said.mu_phi,
        None,
        mu_t=key(
            v.mu("scale of times"), "time that 1 mm of the base stands for", "0.0025 s/mm", None,
            fixes="size",
        ),
        mu_phi=key(
            v.mu("scale of angles"), "angle that 1 mm of the base stands for", "0.05 rad/mm", None,
            fixes="size",
        ),
    )  # fmt: skip
    S: ScaleOrder = combined_key(
        lambda said: ScaleOrder(said.mu_S, said.H_S),
        STANDARD,
        mu_S=key(v.MU_L, "m/mm", "0.001 m/mm", None, fixes="size"),
        H_S=key(
            v.DRAWN,
            "pole distance of the integration, instead of mu_S",
            "20 mm",
            None,
            fixes="size",
        ),
    )
    V: ScaleOrder = combined_key(
        lambda said: ScaleOrder(said.mu_V, said.H_V),
        STANDARD,
        mu_V=key(v.mu("scale of velocities"), "(m/s)/mm", "0.075 (m/s)/mm", None, fixes="size"),
        H_V=key(
            v.DRAWN, "pole distance of the velocities, instead of mu_V", "20 mm", None, fixes="size"
        ),
    )
    a: ScaleOrder = combined_key(
        lambda said: ScaleOrder(said.mu_a, said.H_a),
        STANDARD,
        mu_a=key(v.MU_A, "(m/s²)/mm", "2 (m/s^2)/mm", None, fixes="size"),
        H_a=key(
            v.DRAWN, "pole distance of the accelerations, instead of mu_a", "15 mm", None,
            fixes="size",
        ),
    )  # fmt: skip
    integral: str = key(
        _INTEGRAL,
        "whether displacements are found from velocities by integration",
        "drawn",
        "drawn",
    )
    standard: bool = key(
        v.SWITCH,
        "whether base and pole distances are but wishes: the nearest standard scales are taken",
        True,
        False,
    )


ASKED: SectionKey[KinematicTask] = SectionKey("diagrams")


def check(asked: Said, parts: Parts) -> Iterator[Flaw]:
    """Every contradiction of the section: two keys that fix one size, a base that is another's."""
    yield from parts.moves(("diagrams", "point"), asked.point)
    yield from parts.intervals("diagrams")
    lengths = [name for name in ("base", "mu_t", "mu_phi") if getattr(asked, name) is not None]
    for name in lengths[1:]:
        says = said("{key} fixes the base already; leave one of them out", key=lengths[0])
        yield Flaw(("diagrams", name), says)
    other = {"time": ("mu_phi", "mu_t"), "angle": ("mu_t", "mu_phi")}[asked.over]
    if other[0] in lengths:
        says = said(
            'the diagrams are over {over}; write {key}, or over = "{instead}"',
            over=asked.over,
            key=other[1],
            instead={"time": "angle", "angle": "time"}[asked.over],
        )
        yield Flaw(("diagrams", other[0]), says)
    for symbol in ("S", "V", "a"):
        if getattr(asked, f"mu_{symbol}") is not None and getattr(asked, f"H_{symbol}") is not None:
            says = said(
                "{drawn} and {factor} both fix the same scale; leave one of them out",
                drawn=f"H_{symbol}",
                factor=f"mu_{symbol}",
            )
            yield Flaw(("diagrams", f"H_{symbol}"), says)
    first = {"displacement": "S", "velocity": "V"}[asked.start]
    if getattr(asked, f"H_{first}") is not None:
        says = said(
            "the diagram of {symbol} is laid off, not differentiated: it has no pole; write {key}, or leave "
            "it out",
            symbol=first,
            key=f"mu_{first}",
        )
        yield Flaw(("diagrams", f"H_{first}"), says)
    yield from _without_integral(asked)


def _without_integral(asked: Said) -> Iterator[Flaw]:
    """What contradicts the wish that nothing is integrated."""
    if asked.integral == "none" and asked.start == "displacement":
        says = said(
            'the displacements are laid off, not integrated; write start = "velocity", or leave it out'
        )
        yield Flaw(("diagrams", "integral"), says)
        return
    for name in ("mu_S", "H_S"):
        if asked.integral == "none" and getattr(asked, name) is not None:
            says = said("nothing is integrated, so {key} scales nothing; leave it out", key=name)
            yield Flaw(("diagrams", name), says)


SECTIONS = (
    Section(
        "diagrams", KinematicTask, "kinematic diagrams of a point",
        begin='point = "D"', check=check,
    ),
)  # fmt: skip


BASE = 120.0
"""Length of the base where the task does not say, mm."""


class Chained(NamedTuple):
    """A diagram found from another by a pole: both symbols, and the formula of its scale factor."""

    symbol: str
    source: str
    formula: Operation


def chain(order: KinematicTask) -> Iterator[Chained]:
    """Yield the diagrams that are found from others by a pole distance that the order tells."""
    found = [Chained("V", "S", scale_of_derivative), Chained("a", "V", scale_of_derivative)]
    if order.start == "velocity":
        found = [found[1], Chained("S", "V", scale_of_integral)]
    yield from (one for one in found if getattr(order, one.symbol).pole is not None)


def wanted_base(order: KinematicTask) -> float | None:
    """Return the length of the base that is wished for, mm; None where its scale is told."""
    return None if order.mu_along is not None else order.base or BASE


def settled(order: KinematicTask, whole: float) -> KinematicTask:
    """Return the order with standard scale factors, if it wants them; ``whole``: the base stands for it (SI).

    Raises
    ------
    StructureError
        If a pole distance is told, and not the scale of the diagram that rays are drawn for.
    """
    if not order.standard:
        return order
    length = wanted_base(order)
    if length is not None:
        order = replace(order, base=None, mu_along=nearest(whole / length))
    for one in chain(order):
        source: ScaleOrder = getattr(order, one.source)
        drawn: ScaleOrder = getattr(order, one.symbol)
        if source.mu is None:
            raise StructureError(
                said(
                    "standard: {drawn} leads to a standard scale only where that of the diagram before is "
                    "told: write {key}, too",
                    drawn=f"H_{one.symbol}",
                    key=f"mu_{one.source}",
                ),
                "diagrams.standard",
                head="diagrams",
            )
        exact = float(one.formula.run(source.mu, order.mu_along, drawn.pole))
        scale: dict[str, Any] = {one.symbol: ScaleOrder(nearest(exact), None)}
        order = replace(order, **scale)
    return order
