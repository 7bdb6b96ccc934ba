"""What is asked of a cam: phases of its turn, laws of motion, the follower, limits, sizes of the drawing."""

from __future__ import annotations

import math
from collections.abc import Iterator
from dataclasses import dataclass, replace
from pkgutil import resolve_name
from typing import TYPE_CHECKING, Any

from graphic_tmm.board.bounds import POSITIVE, Bound
from graphic_tmm.chapters.cam.kinds import (
    KEYS,
    ROCKING,
    FlatRockerFollower,
    Follower,
    RollerFollower,
    flaws,
    follower_of,
)
from graphic_tmm.chapters.cam.kinds import FlatFollower as FlatFollower
from graphic_tmm.chapters.cam.kinds import RockerFollower as RockerFollower
from graphic_tmm.language.said import said
from graphic_tmm.scene import quantities
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Kind, Names, Said, Section, combined_key, key
from graphic_tmm.scene.misfits import fault_in_list, stands
from graphic_tmm.scene.tasks import SectionKey
from graphic_tmm.scene.units import Dimension

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts


CAM = "cam"
GRAPHS = "cam graphs"
"""The size of a cam's diagrams; that of its other views is called as the chapter is."""


BY_DIAGRAM = "diagram"
"""The law that is given by points of its acceleration diagram."""
RETURN, MIRRORED, AS_GIVEN = "return", "mirrored", "given"
"""The key that tells how the diagram of the return is meant: the rise run backwards, or by the sign of S″."""


def drawn_laws() -> dict[str, Any]:
    """Return the laws that have a file among ``laws``, by name: they stand above what is asked of a cam."""
    found: dict[str, Any] = resolve_name("graphic_tmm.chapters.cam.laws:laws")()
    return found


def names() -> tuple[str, ...]:
    """Return the laws of motion."""
    return (*drawn_laws(), BY_DIAGRAM)


@dataclass(frozen=True)
class Law:
    """How the follower moves over one phase: one of `names`.

    ``points`` of the law "diagram": (share of the phase, acceleration), in the order of time, joined by
    straight lines; the acceleration is positive while the follower speeds up, on the return too, in any unit,
    for its scale follows from the stroke. Points with one share make a jump, from the first to the last.
    """

    name: str
    points: tuple[tuple[float, float], ...] = ()


def _stroke(value: object, names: Names) -> float:
    """Return a stroke in m, or in rad for a rocking follower."""
    if is_angle(value):
        return math.radians(quantities.parse(value, "angle"))
    return quantities.parse(value, "length")


def is_angle(value: object, dimension: Dimension = "angle") -> bool:
    """Whether a stroke, or a scale factor, is written as one of angles."""
    try:
        quantities.parse(value, dimension)
    except ValueError:
        return False
    return isinstance(value, str)


def is_angle_scale(value: object) -> bool:
    """Whether a scale factor is written as one of angles."""
    return is_angle(value, "scale of angles")


_UNITS = {
    True: {"unit": "rad/mm", "example": "0.01 rad/mm"},
    False: {"unit": "m/mm", "example": "0.001 m/mm"},
}
"""How scale factors of a rocker's diagrams, and of others, are written."""


def _points(value: object, names: Names) -> tuple[tuple[float, float], ...]:
    if not isinstance(value, list) or len(value) < 2:
        raise ValueError(
            stands(value, said("write points of the acceleration, [[0, 0], [0.25, 1], ...]"))
        )
    found = []
    for item in value:
        plain = isinstance(item, list) and len(item) == 2
        if not plain or not all(
            isinstance(x, (int, float)) and not isinstance(x, bool) for x in item
        ):
            raise ValueError(
                fault_in_list(item, said("a point is a share of the phase and a number, [0.25, 1]"))
            )
        found.append((float(item[0]), float(item[1])))
    return tuple(found)


def _rest(said: Said) -> float:
    moving = said.rise + said.upper_dwell + said.fall
    return float(said.lower_dwell if said.lower_dwell is not None else 360.0 - moving)


def _rise_law(said: Said) -> Law:
    return Law(said.law, (said.law_points or ()) if said.law == BY_DIAGRAM else ())


def _return_law(said: Said) -> Law:
    name = said.return_law or said.law
    points = said.return_points or said.law_points or ()
    if name != BY_DIAGRAM:
        return Law(name)
    if getattr(said, RETURN) == MIRRORED:
        # run backwards the follower speeds up where it was braked
        return Law(name, tuple((1.0 - share, -value) for share, value in reversed(points)))
    sign = -1.0 if getattr(said, RETURN) == AS_GIVEN else 1.0
    return Law(name, tuple((share, sign * value) for share, value in points))


def _pressure(said: Said) -> float:
    angle = 90.0 - said.transmission if said.transmission is not None else said.pressure
    return 30.0 if angle is None else float(angle)


def _scale(value: object, names: Names) -> float:
    """Return what 1 mm of a diagram stands for, in m or, of a rocking follower, in rad."""
    return float((MU_ANGLE if is_angle_scale(value) else v.MU_L).read(value, names))


MU_ANGLE = v.mu("scale of angles")
_MU = replace(v.MU_L, read=_scale, unit="scale of lengths, or of angles")
_STROKE = Kind(_stroke, v.SCALE, POSITIVE, "length, or angle")
_POINTS = Kind(_points, {"type": "array"})
_MOVING = v.number(Bound(0, 360, above=True, below=True), "angle")
_DWELL = v.number(Bound(0, 360, below=True), "angle")
_LIMIT = v.number(Bound(0, 90, above=True, below=True), "angle")
_SHARE = v.number(v.SHARE)
_LAW = v.choice_of(names)


@dataclass(frozen=True)
class CamTask:
    """A disc cam: the law of motion, the follower, limits, sizes of the drawing.

    Angles in degrees; other quantities in SI, drawn lengths in mm.

    ``stroke`` h: m, or rad for a rocking roller. The four phases sum to 360°. ``pressure``: the largest
    pressure angle allowed towards the side of the rise, ``pressure_return`` towards that of the return (the
    same if None); 90° less the least transmission angle. ``r0``: the least radius of the theoretical profile
    (m), ``roller``: the radius of the roller (m); None: the least, and the largest, allowed in whole
    millimetres. ``share_of_r0`` and ``share_of_curvature`` bound the radius of the roller. A moving phase is
    divided into ``divisions`` parts, or the turn into about ``per_turn``. ``base`` and ``height``: the
    diagrams' length of a turn, and of the stroke unless ``mu_S`` says (m/mm or rad/mm). ``mu_V`` of dS/dφ is
    that of S, ``mu_A`` of d²S/dφ² a standard one, ``mu_l`` of centres and profile (m/mm) that of S (a
    standard one with a rocking roller), if not given. ``poles``: H of the two integrations of an acceleration
    diagram. ``speed``: of the cam (1/s), if velocities and accelerations of the follower are wanted. (A scene
    sets neither of ``per_turn``, ``mu_S``, ``poles``.)
    """

    stroke: float = key(_STROKE, "the stroke of the follower; an angle for a rocker", "28 mm")
    rise: float = key(_MOVING, "the angle of the rise", "100 deg")
    upper_dwell: float = combined_key(
        lambda said: said.upper_dwell,
        upper_dwell=key(_DWELL, "the angle of the upper dwell", "20 deg", 0.0),
    )
    fall: float = key(_MOVING, "the angle of the return", "90 deg")
    lower_dwell: float = combined_key(
        _rest,
        lower_dwell=key(
            _DWELL, "the angle of the lower dwell; the rest of the turn", "150 deg", None
        ),
    )
    rise_law: Law = combined_key(
        _rise_law,
        Law("sine"),
        law=key(_LAW, "the law of motion of the rise", "sine", "sine"),
        law_points=key(
            _POINTS,
            "points of the acceleration diagram of the rise, for the law diagram: share of the phase, "
            "acceleration, positive while the follower speeds up",
            [[0, 0], [0.25, 1]],
            None,
        ),
    )
    return_law: Law = combined_key(
        _return_law,
        Law("sine"),
        return_law=key(_LAW, "the law of the return, if it is another", "3-4-5", None),
        return_points=key(
            _POINTS,
            "points of the acceleration diagram of the return, positive while it speeds up",
            [[0, 0], [0.25, 1]],
            None,
        ),
        **{
            RETURN: key(
                v.choice(MIRRORED, AS_GIVEN),
                "the diagram of the return is that of the rise run backwards, or its points have the sign of "
                "d²S/dφ²: negative while the return speeds up; left out: that of the rise once more",
                MIRRORED,
                None,
            )
        },
    )
    follower: Follower = combined_key(follower_of, RollerFollower(), **KEYS)
    turns: str = key(v.TURNS, "which way the cam turns", "counterclockwise", v.COUNTERCLOCKWISE)
    pressure: float = combined_key(
        _pressure,
        30.0,
        pressure=key(_LIMIT, "largest pressure angle allowed", "30 deg", None),
        transmission=key(_LIMIT, "or the least transmission angle", "60 deg", None),
    )
    pressure_return: float | None = key(
        _LIMIT, "largest pressure angle of the return", "45 deg", None
    )
    r0: float | None = key(v.POSITIVE_LENGTH, "the least radius chosen", "52.1 mm", None)
    roller: float | None = key(
        replace(v.LENGTH, bound=Bound(0)), "the radius of the roller, 0 of a knife edge", "16.8 mm", None,
    )  # fmt: skip
    share_of_r0: float = key(_SHARE, "how much of r0 the roller may be", 0.4, 0.4)
    share_of_curvature: float = key(_SHARE, "how much of the least curvature radius", 0.7, 0.7)
    divisions: int = key(
        v.number(Bound(4, 360, whole=True)), "parts into which a moving phase is divided", 12, 12,
        written="parts",
    )  # fmt: skip
    per_turn: int | None = None
    base: float = key(
        v.DRAWN, "length of the diagrams' base for a turn", "240 mm", 240.0, fixes="size"
    )
    height: float = key(v.DRAWN, "drawn stroke", "50 mm", 50.0, fixes="size")
    mu_S: float | None = None
    mu_V: float | None = key(
        _MU, "m/mm (rad/mm) of dS/dφ, if not that of S", "0.001 m/mm", None, written="mu_dS"
    )
    mu_A: float | None = key(_MU, "m/mm (rad/mm) of d²S/dφ²", "0.002 m/mm", None, written="mu_ddS")
    mu_l: float | None = key(
        v.MU_L, 'm/mm of centre and profile, or "1:1"', "0.00056 m/mm", None, fixes="size"
    )
    speed: float | None = key(
        v.SPEED, "how fast the cam turns, if the follower's speeds are wanted", "120 rpm", None
    )
    poles: tuple[float, float] = (30.0, 30.0)

    @property
    def rocks(self) -> bool:
        """Whether the follower swings through an angle."""
        return isinstance(self.follower, RockerFollower | FlatRockerFollower)

    @property
    def letters(self) -> dict[str, str]:
        """The letters of the follower's displacement and its derivatives: S, or ψ where it rocks."""
        letter = "ψ" if self.rocks else "S"
        return {"S": letter, "V": f"{letter}′", "A": f"{letter}″"}


ASKED: SectionKey[CamTask] = SectionKey("cam")


def check(cam: Said, parts: Parts) -> Iterator[Flaw]:
    """Every contradiction of the section."""
    rocks = cam.follower in ROCKING
    yield from flaws(cam, is_angle(parts.doc["cam"]["stroke"]))
    if cam.pressure is not None and cam.transmission is not None:
        says = said("pressure says the same; leave one of them out")
        yield Flaw(("cam", "transmission"), says)
    for name in ("mu_dS", "mu_ddS"):
        if (
            name in parts.doc["cam"]
            and isinstance(parts.doc["cam"][name], str)
            and rocks != is_angle_scale(parts.doc["cam"][name])
        ):
            says = said(
                'it is told in {unit} here: write, for example, "{example}"', **_UNITS[rocks]
            )
            yield Flaw(("cam", name), says)
    yield from _laws(cam)


def _laws(cam: Said) -> Iterator[Flaw]:
    """The law diagram without points, and points of another law."""
    for law, points in (("law", "law_points"), ("return_law", "return_points")):
        given, name = getattr(cam, points) is not None, getattr(cam, law)
        others = points == "return_points" and cam.law_points
        if name == BY_DIAGRAM and not given and not others:
            says = said("the law diagram needs points, [[0, 0], [0.25, 1], ...]")
            yield Flaw(("cam", points), says)
        if given and name not in (BY_DIAGRAM, None):
            says = said('only {law} = "diagram" takes points; leave them out', law=law)
            yield Flaw(("cam", points), says)
    way = getattr(cam, RETURN)
    if way is None:
        return
    if BY_DIAGRAM not in (cam.return_law or cam.law, cam.law):
        yield Flaw(("cam", RETURN), said("the other laws are the same both ways; leave it out"))
    elif way == AS_GIVEN and cam.return_points is None:
        yield Flaw(("cam", RETURN), said("the return needs points of its own: write return_points"))
    elif way == MIRRORED and (cam.return_points is not None or cam.return_law is not None):
        says = said("the return is the rise run backwards: leave its own law and points out")
        yield Flaw(("cam", RETURN), says)


SECTIONS = (
    Section(
        "cam", CamTask, "a cam", alone=True, metric=True,
        begin='stroke = "28 mm", rise = "100 deg", fall = "90 deg"', check=check,
        refuse="graphic_tmm.chapters.cam.refusals:refuse",
    ),
)  # fmt: skip
