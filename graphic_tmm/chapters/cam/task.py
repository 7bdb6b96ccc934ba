"""What is asked of a cam: phases of its turn, laws of motion, the follower, limits, sizes of the drawing."""

from __future__ import annotations

from dataclasses import dataclass

from graphic_tmm.chapter import Asked

LAWS = ("sine", "cosine", "constant acceleration", "3-4-5", "diagram")
"""The laws of motion; "diagram" is given by points of its acceleration diagram."""


@dataclass(frozen=True)
class Law:
    """How the follower moves over one phase: one of `LAWS`.

    ``points`` of the law "diagram": (share of the phase, acceleration), in order, joined by straight lines; the
    acceleration is positive while the follower speeds up, in any unit, for its scale follows from the stroke.
    Two points with one share make a jump.
    """

    name: str
    points: tuple[tuple[float, float], ...] = ()


@dataclass(frozen=True)
class RollerFollower:
    """A roller on a translating rod.

    ``offset`` e (m) of its guide from the centre of the cam, positive to the side that lessens the pressure
    angle of the rise; 0 for a central follower.
    """

    offset: float = 0.0


@dataclass(frozen=True)
class RockerFollower:
    """A roller on a rocking lever: length of the lever and distance of the centres (m).

    ``same_sense``: on the rise the lever turns as the cam does.
    """

    lever: float
    centres: float
    same_sense: bool = False


@dataclass(frozen=True)
class FlatFollower:
    """A flat face square to its translation; ``least``: the least radius of curvature allowed (m)."""

    least: float = 0.0


Follower = RollerFollower | RockerFollower | FlatFollower


@dataclass(frozen=True)
class CamOrder:
    """A cam and its drawing. Angles in degrees; other quantities in SI, drawn lengths in mm.

    ``stroke`` h: m, or rad for a rocking roller. The four phases sum to 360°. ``pressure``: the largest
    pressure angle allowed towards the side of the rise, ``pressure_return`` towards that of the return (the
    same if None); 90° less the least transmission angle. ``r0``: the least radius of the theoretical profile
    (m), ``roller``: the radius of the roller (m); None: the least, and the largest, allowed in whole
    millimetres. ``share_of_r0`` and ``share_of_curvature`` bound the radius of the roller. A moving phase is
    divided into ``divisions`` parts, or the turn into about ``per_turn``. ``base`` and ``height``: the
    diagrams' length of a turn, and of the stroke unless ``mu_S`` says (m/mm or rad/mm). ``mu_V`` of dS/dφ is
    that of S, ``mu_A`` of d²S/dφ² a standard one, ``mu_l`` of centres and profile (m/mm) that of S (a
    standard one with a rocking roller), if not given. ``poles``: H of the two integrations of an acceleration
    diagram.
    """

    stroke: float
    rise: float
    upper_dwell: float
    fall: float
    lower_dwell: float
    rise_law: Law = Law("sine")
    return_law: Law = Law("sine")
    follower: Follower = RollerFollower()
    turns: str = "counterclockwise"
    pressure: float = 30.0
    pressure_return: float | None = None
    r0: float | None = None
    roller: float | None = None
    share_of_r0: float = 0.4
    share_of_curvature: float = 0.7
    divisions: int = 12
    per_turn: int | None = None
    base: float = 240.0
    height: float = 50.0
    mu_S: float | None = None
    mu_V: float | None = None
    mu_A: float | None = None
    mu_l: float | None = None
    poles: tuple[float, float] = (30.0, 30.0)


ASKED: Asked[CamOrder] = Asked("cam")
