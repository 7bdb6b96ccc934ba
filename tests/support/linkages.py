"""Mechanisms of one group by their lengths: a four-bar, a slider-crank, a crank in a slotted rocker."""

from __future__ import annotations

from collections.abc import Mapping

from graphic_tmm.mechanism.records import Drive, Guide, Link, Mechanism, Side, Slide

Flips = tuple[float, ...] | None
NONE: Mapping[str, complex] = {}


def four_bar(
    r: float,
    rod: float,
    s: float,
    c: complex,
    *,
    sign: int = 1,
    flips: Flips = None,
    drive: tuple[float, float] = (1.0, 0.0),
    coupler: Mapping[str, complex] = NONE,
) -> Mechanism:
    """Crank r, coupler ``rod``, rocker s about C at ``c``; B to the left of AC for +1.

    ``drive``: speed and acceleration of the crank; ``coupler``: further points of link 2 in its own axes.
    """
    return Mechanism(
        Link(0, {"O": 0j, "C": complex(c)}),
        (
            Link(1, {"O": 0j, "A": complex(r, 0)}),
            Link(2, {"A": 0j, "B": complex(rod, 0), **coupler}, side=Side(sign, ("A", "C"), flips)),
            Link(3, {"C": 0j, "B": complex(s, 0)}),
        ),
        Drive(1, *drive),
    )


def slider_crank(
    r: float,
    rod: float,
    e: float = 0.0,
    *,
    sign: int = 1,
    flips: Flips = None,
    drive: tuple[float, float] = (1.0, 0.0),
    coupler: Mapping[str, complex] = NONE,
) -> Mechanism:
    """Crank r, rod, guide along x at the height e."""
    guide = Guide("x", complex(0, e), 0.0)
    return Mechanism(
        Link(0, {"O": 0j}, (guide,)),
        (
            Link(1, {"O": 0j, "A": complex(r, 0)}),
            Link(2, {"A": 0j, "B": complex(rod, 0), **coupler}),
            Link(3, {"B": 0j}, slides=(Slide(0, guide, side=Side(sign, flips_at=flips)),)),
        ),
        Drive(1, *drive),
    )


def coulisse(
    r: float,
    c: complex,
    h: float = 0.0,
    *,
    sign: int = 1,
    flips: Flips = None,
    drive: tuple[float, float] = (1.0, 0.0),
) -> Mechanism:
    """Crank r, rocker about C at ``c``, its guide h off the pivot."""
    guide = Guide("z", complex(0, h), 0.0)
    return Mechanism(
        Link(0, {"O": 0j, "C": complex(c)}),
        (
            Link(1, {"O": 0j, "A": complex(r, 0)}),
            Link(2, {"A": 0j}, slides=(Slide(3, guide, side=Side(sign, flips_at=flips)),)),
            Link(3, {"C": 0j, "D": complex(1.5 * r, 0.2 * r)}, (guide,)),
        ),
        Drive(1, *drive),
    )
