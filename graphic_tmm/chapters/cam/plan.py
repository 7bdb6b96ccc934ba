"""A cam from its law of motion to its profile: diagrams, centre, pressure angle, curvature, profiles."""

from __future__ import annotations

from dataclasses import dataclass, replace

from graphic_tmm.board.charts import Chart
from graphic_tmm.board.draft import Draft
from graphic_tmm.board.record import Mark
from graphic_tmm.board.scales import standard_length
from graphic_tmm.board.values import Number
from graphic_tmm.chapters.cam import formulas as f
from graphic_tmm.chapters.cam.centre import Centre, Convexity, Path, draw_centre, draw_convexity
from graphic_tmm.chapters.cam.diagrams import Diagrams, draw_diagrams
from graphic_tmm.chapters.cam.drum import (
    DEVELOPMENT,
    SLIDING,
    Drum,
    draw_development,
    draw_drum_centre,
)
from graphic_tmm.chapters.cam.flat_rocker import (
    FaceLever,
    FaceRegion,
    draw_face_profile,
    draw_face_region,
)
from graphic_tmm.chapters.cam.kinds import FlatRockerFollower, RollerFollower
from graphic_tmm.chapters.cam.phases import divide
from graphic_tmm.chapters.cam.profile import VIEW as PROFILE
from graphic_tmm.chapters.cam.profile import Profile, draw_flat_profile, draw_profile
from graphic_tmm.chapters.cam.rocker import Lever, draw_rocker_centre
from graphic_tmm.chapters.cam.spring import Contact, Spring, draw_spring
from graphic_tmm.chapters.cam.task import (
    ASKED,
    CAM,
    GRAPHS,
    CamTask,
    FlatFollower,
    RockerFollower,
)
from graphic_tmm.chapters.cam.turn import (
    TurnDiagram,
    draw_contact,
    draw_curvature,
    draw_pressure,
    draw_radii,
)
from graphic_tmm.errors import StructureError
from graphic_tmm.language.said import said
from graphic_tmm.mechanism.records import Sweep
from graphic_tmm.project import Bench
from graphic_tmm.scene.chapter import Recorded


@dataclass(frozen=True)
class RollerSize:
    """The radius of the roller (Number, m): the limits by r0 and by the least curvature, the chosen one.

    A cam that slides has none by r0.
    """

    by_r0: Mark | None
    by_curvature: Mark
    radius: Mark


@dataclass(frozen=True)
class Cam:
    """A cam as drawn. ``sense``: 1 if it turns counter-clockwise, −1 clockwise.

    A flat face has a `Convexity` for its `Centre`; it has neither pressure angle nor roller. On a lever it has
    a `FaceRegion`, the places of its ``contact`` and the length of ``face`` that they want (Number, m).
    ``charts``: the diagrams whose scales stand on the sheet; that of the scales marked as chosen is found as
    with other graphs.
    """

    order: CamTask
    sense: int
    diagrams: Diagrams
    centre: Centre | Convexity | FaceRegion
    path: Path | Lever | FaceLever | Drum | None
    pressure: TurnDiagram | None
    curvature: TurnDiagram
    roller: RollerSize | None
    profile: Profile
    charts: tuple[Chart, ...]
    contact: TurnDiagram | None = None
    face: Mark | None = None
    spring: Spring | None = None

    @property
    def r0(self) -> Mark:
        """The radius r0 chosen (Number, m)."""
        return self.centre.r0

    @property
    def least(self) -> Mark:
        """The least r0 allowed (Number, m)."""
        return self.centre.least


MM = 1000.0
"""Millimetres in a metre."""
CAM_PLAN: Recorded[Cam] = Recorded(CAM)


def record(bench: Bench) -> Cam | None:
    """Draw the cam that the scene asks for, at a share of its usual size where there is one."""
    order = ASKED.of(bench.scene)
    if order is None:
        return None
    order = replace(order, base=order.base * bench.sizes.get(GRAPHS, 1.0))
    share = bench.sizes.get(CAM, 1.0)
    if bench.usual is not None and share != 1.0:
        mu = float(bench.usual.reading[CAM_PLAN.on(bench.usual).profile.mu][0, 0])
        order = replace(order, mu_l=standard_length(mu / share, 1.0))
    made = draw_cam(bench.draft, order)
    turn = made.diagrams.turn
    sweep = Sweep("s", "m", 0.0, turn.whole, False, "s_{c}") if order.slides else None
    bench.stand((str(k) for k in range(turn.positions)), turn.angles, 0, sweep)
    return made


def draw_cam(draft: Draft, order: CamTask) -> Cam:
    """Draw a cam from its diagrams to its profile.

    Raises
    ------
    StructureError
        If what is asked makes no sense; it says what to change. Limits that are passed are findings, see
        `cam_findings`.
    """
    cam = _draw_pair(draft, order)
    if order.spring is None:
        return cam
    lever = cam.path.lever if isinstance(cam.path, Lever) else None
    distance = cam.contact.chart.ordinates[0] if cam.contact is not None else None
    angle = cam.centre.pressure if isinstance(cam.centre, Centre) else None
    touch = Contact(cam.profile, angle, lever, distance)
    spring = draw_spring(draft, order, order.spring, cam.diagrams, touch, cam.sense)
    return replace(cam, spring=spring, charts=(*cam.charts, *spring.charts))


def _draw_pair(draft: Draft, order: CamTask) -> Cam:
    """Draw cam and follower without the spring."""
    turn = divide(order)
    _refuse_triangle(order)
    sense = 1 if order.turns == "counterclockwise" else -1
    diagrams = draw_diagrams(draft, order, turn)
    charts = tuple(diagram.chart for diagram in (diagrams.S, diagrams.V, diagrams.A))
    follower = order.follower
    if isinstance(follower, FlatFollower):
        convexity = draw_convexity(draft, order, diagrams, follower)
        radii = draw_radii(draft, diagrams, convexity)
        profile = draw_flat_profile(draft, diagrams, convexity, sense)
        charts = (*charts, radii.chart)
        return Cam(order, sense, diagrams, convexity, None, None, radii, None, profile, charts)
    if isinstance(follower, FlatRockerFollower):
        region, lever = draw_face_region(draft, order, diagrams, follower, sense)
        radii = draw_radii(draft, diagrams, region)
        profile, distance = draw_face_profile(draft, diagrams, region, lever, sense)
        contact, face = draw_contact(draft, diagrams, distance)
        charts = (*charts, lever.chart, radii.chart, contact.chart)
        return Cam(
            order, sense, diagrams, region, lever, None, radii, None, profile, charts, contact, face
        )
    centre: Centre
    path: Path | Lever | Drum
    if order.developed:
        centre, path = draw_drum_centre(draft, order, diagrams)
    elif isinstance(follower, RockerFollower):
        centre, path = draw_rocker_centre(draft, order, diagrams, follower, sense)
        charts = (*charts, path.chart)
    else:
        centre, path = draw_centre(draft, order, diagrams, follower.offset, sense)
    pressure = draw_pressure(draft, diagrams, centre)
    curvature = draw_curvature(
        draft, diagrams, centre, groove=order.grooved, straight=order.developed
    )
    edge = isinstance(follower, RollerFollower) and follower.edge
    size = diagrams.stroke if order.slides else centre.r0
    roller = None if edge else _roller(draft, order, curvature, size)
    radius = roller.radius if roller is not None else None
    if isinstance(path, Drum):
        profile, path = draw_development(draft, order, diagrams, centre, path, radius)
    else:
        profile = draw_profile(draft, diagrams, centre, path, radius, sense, groove=order.grooved)
    charts = (*charts, pressure.chart, curvature.chart)
    return Cam(order, sense, diagrams, centre, path, pressure, curvature, roller, profile, charts)


def _refuse_triangle(order: CamTask) -> None:
    """Refuse sizes at which the follower does not reach its lowest or its highest place."""
    follower, r0 = order.follower, order.r0
    if isinstance(follower, FlatRockerFollower):
        if (r0 or follower.least) + follower.face >= follower.centres:
            says = said(
                "r0 and the distance of the face are not less than the centres, {centres:g} mm apart: the "
                "lever's pivot would stand in the cam; increase centres",
                centres=MM * follower.centres,
            )
            raise StructureError(says, "cam.centres", "cam.r0", "cam.face", head="cam")
        return
    if r0 is None:
        return
    if isinstance(follower, RockerFollower):
        least, most = abs(follower.centres - follower.lever), follower.centres + follower.lever
        if not least < r0 < most:
            raise StructureError(
                said(
                    "with a lever of {lever:g} mm and centres {centres:g} mm apart r0 lies between "
                    "{least:.4g} and {most:.4g} mm, not at {r0:g} mm",
                    lever=MM * follower.lever,
                    centres=MM * follower.centres,
                    least=MM * least,
                    most=MM * most,
                    r0=MM * r0,
                ),
                "cam.r0",
                "cam.lever",
                "cam.centres",
                head="cam",
            )
    elif not isinstance(follower, FlatFollower) and abs(follower.offset) >= r0:
        raise StructureError(
            said(
                "the offset {offset:g} mm is not less than r0 = {r0:g} mm: take a smaller one",
                offset=MM * follower.offset,
                r0=MM * r0,
            ),
            "cam.offset",
            "cam.r0",
            head="cam",
        )


def _roller(draft: Draft, order: CamTask, curvature: TurnDiagram, size: Mark) -> RollerSize:
    """Calculate how large the roller may be, by r0 and by the least curvature; choose.

    ``size``: r0; of a cam that slides the stroke, whose share is no limit but taken where none is given.
    """
    draft.open(SLIDING if order.slides else DEVELOPMENT if order.developed else PROFILE)
    rows = [("ρ", order.share_of_curvature, curvature.extremes[0].value)]
    if not order.slides or order.roller is None:
        rows.insert(0, ("h" if order.slides else "r", order.share_of_r0, size))
    limits = []
    for name, share, whole in rows:
        k = draft.take(Number, f"k_{name}", share)
        limits.append(draft.draw(f.allowed_share, f"[r]_{name}", k, whole, unit="m"))
    if order.roller is not None:
        chosen = draft.take(Number, "r", order.roller, "m")
    else:
        lesser = draft.draw(f.lesser_radius, "[r]", *limits, unit="m")
        chosen = draft.draw(f.whole_mm_below, "r", lesser, unit="m")
    return RollerSize(None if order.slides else limits[0], limits[-1], chosen)
