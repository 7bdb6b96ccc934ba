"""The sections of a scene that say how it is drawn: the plans, scales, the hand, the sheets."""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.board.bounds import Bound
from graphic_tmm.language.catalogue import languages
from graphic_tmm.language.said import said
from graphic_tmm.paper.formats import AUTO, FORMATS, USUAL, other_names
from graphic_tmm.scene import registry
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Kind, Names, Said, combined_key, key
from graphic_tmm.scene.misfits import stands
from graphic_tmm.scene.units import SI, SYSTEMS

DIVISIONS = {"exact": 0.1, "cad": 0.01, "careful": 0.1, "student": 0.5}
"""Divisions of the rulers of named hands, mm."""


@dataclass(frozen=True, kw_only=True)
class Plans:
    """What is drawn, and how."""

    turned: bool = combined_key(
        lambda said: said.velocities == "turned",
        False,
        velocities=key(
            v.choice("direct", "turned", повёрнутый="turned", прямой="direct"),
            "velocity plans as they are, or turned by 90°",
            None,
            "direct",
        ),
    )
    common_pole: bool = combined_key(
        lambda said: said.velocity_pole == "common",
        False,
        velocity_pole=key(
            v.choice("own", "common", свой="own", общий="common"),
            "a velocity plan for each position, or all of them from a common pole",
            None,
            "own",
        ),
    )
    trajectories: tuple[str, ...] = key(v.LETTERS, "points whose paths are drawn", ["C"], ())
    main: str | None = key(v.POSITION, "the position drawn in heavy lines", 2, None)


@dataclass(frozen=True)
class Scales:
    """Scale factors that are fixed; the rest are chosen from the standard row.

    ``mu_l`` in m/mm, ``mu_v`` in (m/s)/mm, ``mu_a`` in (m/s²)/mm; ``mu_v_is_mu_l_omega`` asks for
    μ_v = μ_l·ω1 (so that pa = OA). ``OA``, ``pa``, ``pi_a`` fix the drawn length in mm of the
    crank, of its pin's velocity and its acceleration instead. At most one of each family is set.
    """

    mu_l: float | None = key(v.MU_L, 'm/mm, or "1:5"', "0.005 m/mm", None)
    mu_v: float | None = combined_key(
        lambda said: None if said.mu_v == v.MU_L_OMEGA else said.mu_v,
        None,
        mu_v=key(v.MU_V, f'(m/s)/mm, or "{v.MU_L_OMEGA}"', "0.25 (m/s)/mm", None),
    )
    mu_a: float | None = key(v.MU_A, "(m/s²)/mm", "12.5 (m/s^2)/mm", None)
    mu_v_is_mu_l_omega: bool = combined_key(lambda said: said.mu_v == v.MU_L_OMEGA, False)
    OA: float | None = key(v.DRAWN, "drawn length of the crank, instead of mu_l", "60 mm", None)
    pa: float | None = key(
        v.DRAWN, "drawn velocity of the crank pin, instead of mu_v", "60 mm", None
    )
    pi_a: float | None = key(
        v.DRAWN, "drawn acceleration of the crank pin, instead of mu_a", "60 mm", None
    )


def _division(said: Said) -> float | None:
    """Return the division of the ruler, mm: as told, else the hand's own; None: read without rounding."""
    if said.ruler is None:
        return DIVISIONS[said.name]
    return None if said.ruler == "exact" else float(said.ruler)


@dataclass(frozen=True, kw_only=True)
class Hand:
    """How well lengths are read."""

    hand: str = key(
        v.choice("exact", "cad", "careful", "student", точная="exact", студент="student"),
        "who draws: exact, cad, careful, student",
        "student",
        "exact",
        written="name",
    )
    seed: int = key(v.number(Bound(0, 2**31, whole=True)), "which of that hand's drawings", 7, 0)
    ruler: float | None = combined_key(
        _division,
        0.1,
        ruler=key(
            v.RULER,
            'the division that lengths are read to, or "exact"; left out: the hand\'s own',
            "0.1 mm",
            None,
        ),
    )


def _listed(value: object, names: Names) -> tuple[str, ...]:
    known = list(registry.known_places())
    if not isinstance(value, list) or not value:
        raise ValueError(stands(value, said('a list of plans is wanted, ["positions"]')))
    for item in value:
        if item not in known:
            raise ValueError(v.no_choice(item, known, known))
    if len(set(value)) < len(value):
        raise ValueError(said("a plan is named twice; leave one of the two out"))
    return tuple(value)


_PLACES = Kind(
    _listed,
    lambda: {"type": "array", "items": {"type": "string", "enum": list(registry.known_places())}},
)


@dataclass(frozen=True)
class SheetOrder:
    """A sheet, and what is placed on it, in order.

    ``chosen``: its format was asked for as "auto", and has been found.
    """

    format: str = key(
        v.choice(*FORMATS, AUTO, **other_names()),
        "the format of the sheet; auto: the smallest that holds it",
        USUAL,
        USUAL,
    )
    place: tuple[str, ...] = combined_key(
        lambda said: said.place or (),
        ("positions", "velocities", "accelerations"),
        place=key(
            _PLACES,
            "the plans on it; left out: all that the scene calls for and no other sheet names",
            ["positions", "velocities"],
            None,
        ),
    )
    name: str = key(
        v.TEXT,
        "its name; left out: that of the title block, or the title of the scene",
        said("Force analysis"),
        "",
    )
    designation: str = key(
        v.TEXT,
        "its designation; left out: that of the title block, or one of the kind of the example",
        said("TMM.01.02.000"),
        "",
    )
    chosen: bool = False


@dataclass(frozen=True)
class TitleBlock:
    """What is written into the title block."""

    designation: str = key(
        v.TEXT, "of the project; of several documents each bears its number, 01 for 00", default=""
    )
    name: str = key(v.TEXT, "of all sheets that have none of their own", default="")
    organisation: str = key(v.TEXT, "", default="")
    drawn_by: str = key(v.TEXT, "", default="")
    checked_by: str = key(v.TEXT, "", default="")
    standards_by: str = key(v.TEXT, "", default="")
    approved_by: str = key(v.TEXT, "", default="")
    material: str = key(v.TEXT, "", default="")
    letter: str = key(v.TEXT, "", default="")
    mass: str = key(v.TEXT, "", default="")
    scale: str = key(v.TEXT, "", default="")
    print_check: bool = key(
        v.SWITCH, "a line of 100 mm above the frame, to lay a ruler on", False, True
    )


@dataclass(frozen=True)
class Head:
    """The keys before the first section."""

    title: str = key(v.TITLE, "what the mechanism is", said("Slider-crank mechanism"))
    language: str = key(
        v.choice(*sorted(languages(), reverse=True)), "the language of the sheets", "en", "ru"
    )
    units: str = key(
        v.choice(*SYSTEMS),
        "what sheets, tables and notes are printed in: imperial: ft, lbf, slug; numbers without a unit stay SI",
        "imperial",
        SI,
    )
