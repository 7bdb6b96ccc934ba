"""What is asked of a cam: phases of its turn, laws of motion, the follower, limits, sizes of the drawing."""

from __future__ import annotations

from collections.abc import Iterator
from dataclasses import dataclass, replace
from typing import TYPE_CHECKING

from graphic_tmm.board.bounds import Bound
from graphic_tmm.chapters.cam.kinds import (
    DISC,
    DRUM,
    FLAT_FACED,
    KEYS,
    PLATE,
    ROCKING,
    FlatRockerFollower,
    Follower,
    RollerFollower,
    flaws,
    follower_of,
)
from graphic_tmm.chapters.cam.kinds import FlatFollower as FlatFollower
from graphic_tmm.chapters.cam.kinds import RockerFollower as RockerFollower
from graphic_tmm.chapters.cam.kinds_spring import KEYS as SPRING_KEYS
from graphic_tmm.chapters.cam.kinds_spring import SpringTask, spring_of
from graphic_tmm.chapters.cam.kinds_spring import flaws as flaws_of_spring
from graphic_tmm.chapters.cam.task_motion import (
    AS_GIVEN,
    BY_DIAGRAM,
    BY_TABLE,
    DWELL,
    EVEN_SHARES,
    EXAMPLE,
    LAW,
    MIRRORED,
    MOVING,
    POINTS,
    RETURN,
    SHARED,
    SHARES,
    STROKE,
    TABLE,
    TURN,
    UNSAID,
    Law,
    Stage,
    law_faults,
    law_of,
    levels,
    stroke_faults,
)
from graphic_tmm.language.said import said
from graphic_tmm.scene import values as v
from graphic_tmm.scene.declare import Flaw, Names, Said, Section, combined_key, key, keys_of
from graphic_tmm.scene.quantities import is_a
from graphic_tmm.scene.tables import DeclaredTable, Several
from graphic_tmm.scene.tasks import SectionKey

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts


CAM = "cam"
GRAPHS = "cam graphs"
"""The size of a cam's diagrams; that of its other views is called as the chapter is."""


_UNITS = {
    True: {"unit": "rad/mm", "example": "0.01 rad/mm"},
    False: {"unit": "m/mm", "example": "0.001 m/mm"},
}
"""How scale factors of a rocker's diagrams, and of others, are written."""


def _rest(said: Said) -> float:
    moving = (said.rise or 0.0) + said.upper_dwell + (said.fall or 0.0)
    rest = 0.0 if said.form == PLATE else TURN - moving
    return float(said.lower_dwell if said.lower_dwell is not None else rest)


def _rise_law(said: Said) -> Law:
    if said.law == BY_TABLE and said.law_table:
        return law_of(said.law_table, own=not said.phase)
    points = (said.law_points or ()) if said.law == BY_DIAGRAM else ()
    return Law(said.law, points, said.shares or EVEN_SHARES)


def _phases(said: Said) -> tuple[Stage, ...]:
    """Return the phases, with what the cam says where they say nothing."""
    usual = _rise_law(said)

    def law(own: Law | None) -> Law:
        if own is None or own == Law(usual.name, shares=UNSAID):
            return usual
        return replace(own, shares=EVEN_SHARES) if own.shares == UNSAID else own

    return tuple(
        replace(one, stroke=one.stroke or said.stroke, law=law(one.law)) if one.sign else one
        for one in said.phase
    )


def _stroke(said: Said) -> float:
    """Return how far the highest place of the follower is above the lowest."""
    return max(levels(_phases(said))) if said.phase else float(said.stroke)


def _return_law(said: Said) -> Law:
    name = said.return_law or said.law
    points = said.return_points or said.law_points or ()
    if name == BY_TABLE and (table := said.return_table or said.law_table):
        return law_of(table, own=bool(said.return_table))
    if name != BY_DIAGRAM:
        shares = said.return_shares or said.shares or EVEN_SHARES
        return Law(name, shares=shares if name == SHARED else EVEN_SHARES)
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
    return float((MU_ANGLE if is_a(value, "scale of angles") else v.MU_L).read(value, names))


MU_ANGLE = v.mu("scale of angles")
_MU = replace(v.MU_L, read=_scale, unit="scale of lengths, or of angles")
_LIMIT = v.number(Bound(0, 90, above=True, below=True), "angle")
_SHARE = v.number(v.SHARE)


@dataclass(frozen=True)
class CamTask:
    """A cam: the law of motion, the follower, limits, sizes of the drawing.

    Angles in degrees; other quantities in SI, drawn lengths in mm. Of a translating cam its travel stands for
    the angle: phases are lengths (m), with or without a fall.

    ``stroke`` h: m, or rad for a rocking roller. The four phases sum to 360°; ``phases`` stand instead
    of them (and their laws) where there are several lifts. ``pressure``: the largest
    pressure angle allowed towards the side of the rise, ``pressure_return`` towards that of the return (the
    same if None); 90° less the least transmission angle. ``least_rho``: the least radius of curvature
    allowed of the theoretical profile (m; 0: any), ``r0``: its least radius, of a drum the mean one (m),
    ``groove``: whether both sides of the roller are held, as on a drum they always are; ``roller``: the radius
    of the roller (m); None: the least, and the largest, allowed in whole millimetres. ``share_of_r0`` and
    ``share_of_curvature`` bound the radius of the roller. A moving phase is
    divided into ``divisions`` parts, or the turn into about ``per_turn``. ``base`` and ``height``: the
    diagrams' length of a turn, and of the stroke unless ``mu_S`` says (m/mm or rad/mm). ``mu_V`` of dS/dφ is
    that of S, ``mu_A`` of d²S/dφ² a standard one, ``mu_l`` of centres and profile (m/mm) that of S (a
    standard one with a rocking roller), if not given. ``poles``: H of the two integrations of an acceleration
    diagram. ``speed``: of the cam (1/s), if velocities and accelerations of the follower are wanted. (A scene
    sets neither of ``per_turn``, ``mu_S``, ``poles``.)
    """

    stroke: float = combined_key(
        _stroke,
        stroke=key(STROKE, "the stroke of the follower; an angle for a rocker", "28 mm", None),
    )
    rise: float = combined_key(
        lambda said: said.rise or 0.0, rise=key(MOVING, "the angle of the rise", "100 deg", None)
    )
    upper_dwell: float = combined_key(
        lambda said: said.upper_dwell,
        upper_dwell=key(DWELL, "the angle of the upper dwell", "20 deg", 0.0),
    )
    fall: float = combined_key(
        lambda said: said.fall or 0.0, fall=key(MOVING, "the angle of the return", "90 deg", None)
    )
    lower_dwell: float = combined_key(
        _rest,
        lower_dwell=key(
            DWELL, "the angle of the lower dwell; the rest of the turn", "150 deg", None
        ),
    )
    rise_law: Law = combined_key(
        _rise_law,
        Law("sine"),
        law=key(LAW, "the law of motion of the rise", "sine", "sine"),
        law_points=key(
            POINTS,
            "points of the acceleration diagram of the rise, for the law diagram: share of the phase, "
            "acceleration, positive while the follower speeds up",
            [[0, 0], [0.25, 1]],
            None,
        ),
        law_table=key(
            TABLE,
            "the table of the rise, for the law table: angle in the phase, displacement",
            EXAMPLE,
            None,
        ),
        shares=key(
            SHARES,
            "of constant acceleration: the shares of speeding up and of slowing down",
            [2, 1],
            None,
        ),
    )
    return_law: Law = combined_key(
        _return_law,
        Law("sine"),
        return_law=key(LAW, "the law of the return, if it is another", "3-4-5", None),
        return_points=key(
            POINTS,
            "points of the acceleration diagram of the return, positive while it speeds up",
            [[0, 0], [0.25, 1]],
            None,
        ),
        return_table=key(
            TABLE,
            "the table of the return, down to 0; left out: that of the rise backwards",
            [["0 deg", "28 mm"], ["10 deg", "27.2 mm"]],
            None,
        ),
        return_shares=key(SHARES, "those of the return, if they are others", [1, 2], None),
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
    phases: tuple[Stage, ...] = combined_key(
        _phases,
        (),
        phase=key(
            Several(DeclaredTable(Stage)),
            "several lifts and dwells in one turn, in order, instead of rise, upper_dwell, fall, lower_dwell",
            default=(),
        ),
    )
    follower: Follower = combined_key(follower_of, RollerFollower(), **KEYS)
    spring: SpringTask | None = combined_key(spring_of, None, **SPRING_KEYS)
    least_rho: float = combined_key(
        lambda said: 0.0 if said.follower in FLAT_FACED else said.least_curvature, 0.0
    )
    form: str = key(
        v.choice(DISC, DRUM, PLATE),
        "a disc, a drum with a groove for a roller whose rod moves along its axis, or a plate that slides: "
        "its phases are lengths of its travel, and may end with the rise",
        DRUM,
        DISC,
    )
    groove: bool = key(
        v.SWITCH, "whether a disc has a groove that holds the roller on both sides", True, False
    )
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
    r0: float | None = combined_key(
        lambda said: said.radius if said.form == DRUM else said.r0,
        None,
        r0=key(v.POSITIVE_LENGTH, "the least radius chosen", "52.1 mm", None),
        radius=key(v.POSITIVE_LENGTH, "the mean radius of a drum chosen", "60 mm", None),
    )
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
        v.SPEED_OF_CAM,
        "how fast the cam turns, if the follower's speeds are wanted",
        "120 rpm",
        None,
    )
    poles: tuple[float, float] = (30.0, 30.0)

    @property
    def developed(self) -> bool:
        """Whether the cam is drawn developed."""
        return self.form in (DRUM, PLATE)

    @property
    def slides(self) -> bool:
        """Whether the cam is a plate that slides."""
        return self.form == PLATE

    @property
    def whole(self) -> float:
        """A turn, degrees, or the travel of a cam that slides, m."""
        return sum(one.angle for one in self.stages) if self.slides else TURN

    @property
    def grooved(self) -> bool:
        """Whether both sides of the roller are held."""
        return self.groove or self.form == DRUM

    @property
    def rocks(self) -> bool:
        """Whether the follower swings through an angle."""
        return isinstance(self.follower, RockerFollower | FlatRockerFollower)

    @property
    def allowed_rho(self) -> float:
        """The least radius of curvature allowed (m): under a flat face, else of the theoretical profile."""
        if isinstance(self.follower, FlatFollower | FlatRockerFollower):
            return self.follower.least
        return self.least_rho

    @property
    def stages(self) -> tuple[Stage, ...]:
        """The phases of the turn in order; of the usual cam four, dwells that are none among them."""
        rise = Stage(rise=self.rise, stroke=self.stroke, law=self.rise_law)
        if self.slides and not self.phases and not self.fall:
            return rise, Stage(dwell=self.upper_dwell)
        return self.phases or (
            rise,
            Stage(dwell=self.upper_dwell),
            Stage(fall=self.fall, stroke=self.stroke, law=self.return_law),
            Stage(dwell=self.lower_dwell),
        )

    @property
    def letters(self) -> dict[str, str]:
        """The letters of the follower's displacement and its derivatives: S, or ψ where it rocks."""
        letter = "ψ" if self.rocks else "S"
        return {"S": letter, "V": f"{letter}′", "A": f"{letter}″"}

    @property
    def units(self) -> dict[str, str]:
        """Their units: a derivative by a travel is a slope."""
        unit = "rad" if self.rocks else "m"
        return {"S": unit} | ({"V": "", "A": "1/m"} if self.slides else {"V": unit, "A": unit})

    def scale_unit(self, which: str) -> str:
        """The unit of a scale of theirs."""
        unit = self.units[which] or "1"
        return f"({unit})/mm" if "/" in unit else f"{unit}/mm"


ASKED: SectionKey[CamTask] = SectionKey("cam")


def check(cam: Said, parts: Parts) -> Iterator[Flaw]:
    """Every contradiction of the section."""
    rocks, told = cam.follower in ROCKING, parts.doc["cam"]
    yield from stroke_faults(cam, told, rocks, keys_of(CamTask))
    yield from flaws(cam, parts.doc["cam"])
    yield from flaws_of_spring(cam, parts.doc["cam"])
    if cam.pressure is not None and cam.transmission is not None:
        says = said("pressure says the same; leave one of them out")
        yield Flaw(("cam", "transmission"), says)
    for name in ("mu_dS", "mu_ddS"):
        written = told.get(name)
        if isinstance(written, str) and rocks != is_a(written, "scale of angles"):
            says = said(
                'it is told in {unit} here: write, for example, "{example}"', **_UNITS[rocks]
            )
            yield Flaw(("cam", name), says)
    yield from law_faults(cam)


SECTIONS = (
    Section(
        "cam", CamTask, "a cam", alone=True, metric=True,
        begin='stroke = "28 mm", rise = "100 deg", fall = "90 deg"', check=check,
        refuse="graphic_tmm.chapters.cam.refusals:refuse",
    ),
)  # fmt: skip
