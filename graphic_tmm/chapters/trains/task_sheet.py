"""What a task gives of a planetary train, its scheme in no proportions, and what it asks, a sentence each."""

from __future__ import annotations

import math
from collections.abc import Iterator, Mapping, Sequence

from graphic_tmm.chapters.trains.ink_bevel import draw_bevel_scheme, spots_of_bevel
from graphic_tmm.chapters.trains.ink_pairs import WIDTH, Side, SideRows
from graphic_tmm.chapters.trains.ink_scheme import ASIDE, Scheme2KH, draw_scheme, spots
from graphic_tmm.chapters.trains.motion import Motion, motion_of
from graphic_tmm.chapters.trains.plan import ARM, HOLLOW, ROW, SHAFT
from graphic_tmm.chapters.trains.rows import index, rows_of
from graphic_tmm.chapters.trains.task import ASKED, SCHEMES, PlanetaryTask, Scheme
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.paper.drawing import Drawing, Wanted
from graphic_tmm.paper.figure import added
from graphic_tmm.paper.formats import HEIGHTS
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.packing import bounds
from graphic_tmm.readers.task_sheet import SIZE, Given, TaskSheet, given_speed
from graphic_tmm.readers.task_sheet import Scheme as Shown
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield what a scene gives of its planetary train, modules in mm."""
    order = ASKED.of(scene)
    if order is None:
        return
    motion = motion_of(order)
    yield from _speeds(order, motion)
    if order.ratio is not None:
        yield Given(motion.ratio, order.ratio)
        yield Given("ΔU_{max}", 100.0 * order.tolerance, "%")
    if order.module_2 is None:
        yield Given("m_m" if SCHEMES[order.scheme].bevel else "m", order.module, SIZE)
    else:
        yield Given("m_{1-2}", order.module, SIZE)
        yield Given("m_{3-4}", order.module_2, SIZE)
    for number, teeth in enumerate(order.teeth, 1):
        if teeth is not None:
            yield Given(f"z_{number}", teeth)
    kind = SCHEMES[order.scheme]
    rows = [row for side in ("behind", "before", "closed") for row in rows_of(order, kind, side)]
    outside = {name: z for row in rows for name, z in zip(row.names, row.teeth, strict=True)}
    for name in sorted(outside, key=int):
        yield Given(f"z_{index(name)}", outside[name])
    yield Given("k", ", ".join(map(str, order.satellites)))
    if order.moment is not None:
        shared = motion.closing is not None and motion.closing.joint == motion.first
        yield Given(f"M_{'0' if shared else motion.first}", order.moment, "N·m")
        if order.mesh_efficiency < 1.0:
            yield Given("η_m", order.mesh_efficiency)


def _speeds(order: PlanetaryTask, motion: Motion) -> Iterator[Given]:
    """Yield the speeds that are given, with their signs: of what drives, or of the first wheel before it."""
    speeds = motion.driving
    if before := rows_of(order, SCHEMES[order.scheme], "before"):
        speeds = {before[-1].names[-1]: float(order.speed)}  # type: ignore[arg-type]
    for name, speed in speeds.items():
        told = given_speed(index(name), speed)
        yield told._replace(value=math.copysign(float(told.value), speed))


RADII: Mapping[str, tuple[float, ...]] = {
    "ring": (13.0, 9.0),
    "external-internal": (10.0, 13.0, 8.0),
    "external-external": (10.0, 15.0, 11.0),
    "internal-internal": (33.0, 14.0, 9.0),
    "external": (13.0, 16.0),
    "internal": (34.0, 15.0),
    "3K": (10.0, 13.0, 9.0),
    "bevel": (24.0, 17.0),
    "bevel-double": (17.0, 13.0, 20.0),
}
"""Radii of wheel 1 and of the rims of a scheme, mm: signs, all the same whatever the teeth."""
BEHIND = (7.0, 11.0)
"""Radii of the pair behind the train, mm."""
NEAR, WIDER = 30.0, 1.05
"""How far rows outside stand from the train where the room is less, mm; so much wider it may be."""
NEXT = 22.0
"""And from row to row there, mm."""
SMALLEST = 0.7
"""It is drawn no smaller than this."""
TITLE = said("Scheme of the planetary train", context="task")


def scheme(scene: Scene, room: complex) -> Shown | None:
    """Return the train along its axis, not to scale, as wide as its signs; None if there is none."""
    order = ASKED.of(scene)
    if order is None:
        return None
    view, apart = _drawing(order, 1.0, SHAFT), SHAFT
    left, low, right, top = bounds(view)
    if right - left > room.real and len((*order.before, *order.behind, *order.closed)) > 1:
        view, apart = _drawing(order, 1.0, NEAR), NEAR
        left, low, right, top = bounds(view)
        if right - left > WIDER * room.real:
            return None
    if top - low > room.imag:
        view = _drawing(order, max(room.imag / (top - low), SMALLEST), apart)
    return Shown(view._replace(title=speaking(scene.language)(TITLE)), 0.0)


def _drawing(order: PlanetaryTask, share: float, apart: float) -> Drawing:
    if SCHEMES[order.scheme].bevel:
        made = _placed_bevel(order, share)
        parts = draw_bevel_scheme(made, min(order.satellites) % 2 == 0)
        places = spots_of_bevel(made)
    else:
        made = _placed(order, share, apart)
        parts, places = draw_scheme(made), spots(made)
    strokes = tuple(
        stroke
        for name, some in parts
        for stroke in added(some, "carrier" if name == "H" else "wheel")
    )
    size = HEIGHTS["A4"].point
    wanted = [Wanted(name, at, size, ASIDE, toward) for name, (at, toward) in places.items()]
    return finished(Drawing("scheme", "", strokes, wanted=tuple(wanted)))


def _placed(order: PlanetaryTask, share: float, apart: float) -> Scheme2KH:
    """Return where everything stands, mm; ``share``: of the usual radii; ``apart``: rows outside the train."""
    kind: Scheme = SCHEMES[order.scheme]
    radii = [share * radius for radius in RADII[kind.name]]
    axis, last = radii[0] + kind.first * radii[1], ROW * (kind.rows - 1)
    rims = dict(zip(kind.rims, zip((0.0, last), radii[1:], strict=False), strict=True))
    wheels = {}
    for name, rim, sense, _ in kind.meshes:
        x, radius = rims[rim]
        wheels[name] = _central(x, axis - sense * radius)
        wheels.setdefault(rim, _satellite(x, axis, sense, radius))
    arm = last + (-ROW / 2.0 if kind.second > 0 and kind.rows > 1 else ARM)
    if "H" not in kind.members:
        arm = -ARM
    motion = motion_of(order)
    outside = []
    closed = zip(order.closed, rows_of(order, kind, "closed"), strict=True)
    sides = [
        (motion.driven, rows_of(order, kind, "behind")),
        (motion.first, rows_of(order, kind, "before")),
        *sorted(((member, (row,)) for (member, _), row in closed), key=lambda side: side[0] == "H"),
    ]
    # a last wheel that turns with nothing on it has its hollow shaft there
    beside = order.closed and motion.last not in (member for member, _ in order.closed)
    farther = HOLLOW if beside else 0.0
    for member, some in sides:
        onward = apart if apart == SHAFT else NEXT
        at, way = min(0.0, arm) - apart, -onward
        if member != "1":
            # the disc of a ring 5 stands between
            at, way = max(last + (0.0 if "H" in kind.members else WIDTH), arm) + apart, onward
            at, farther = at + farther, HOLLOW + onward if some else farther
        rows, y = [], 0.0
        for row in some:
            one_shaft = math.prod(_level(len(teeth)) for _, teeth in order.closed) ** 0.5
            wide = one_shaft / _level(len(row.names)) if order.closed else 1.0
            rows.append(_row(row.names, complex(at, y), share * wide))
            at, y = at + way, [*rows[-1].values()][-1].centre.imag
        if rows:
            outside.append(SideRows(member, tuple(rows)))
    return Scheme2KH(kind, wheels, (complex(arm, axis), complex(arm)), tuple(outside), motion)


def _placed_bevel(order: PlanetaryTask, share: float) -> Scheme2KH:
    """Return where bevel wheels stand, mm; O in 0; the last wheel is a half larger where there are two rims."""
    kind = SCHEMES[order.scheme]
    first, *rims = (share * radius for radius in RADII[kind.name])
    wheels = {}
    for mesh, radius, times in zip(kind.meshes, (rims[0], rims[-1]), (1.0, 1.5), strict=True):
        at = complex(-mesh.sense * radius, first * (times if len(rims) > 1 else 1.0))
        wheels[mesh.wheel] = Side(at, at.conjugate(), complex(at.real))
        wheels.setdefault(mesh.rim, Side(at, complex(-at.real, at.imag), 1j * at.imag))
    return Scheme2KH(kind, wheels, (1j * first, 0j), (), motion_of(order))


def _level(count: int) -> float:
    """Return how far below its first wheel the last one of a row stands, mm."""
    return BEHIND[0] + (2 * count - 3) * BEHIND[1]


def _row(names: Sequence[str], at: complex, share: float) -> dict[str, Side]:
    """Return wheels in mesh from their sides, each below the one before."""
    found = dict[str, Side]()
    top = at.imag + share * BEHIND[0]
    for k, name in enumerate(names):
        radius = share * BEHIND[min(k, 1)]
        centre = complex(at.real, top - radius)
        high, top = complex(at.real, top), top - 2 * radius
        low = complex(at.real, top)
        found[name] = Side(high, low, centre) if k else Side(low, high, centre)
    return found


def _central(x: float, radius: float) -> Side:
    return Side(complex(x, radius), complex(x, -radius), complex(x))


def _satellite(x: float, axis: float, sense: int, radius: float) -> Side:
    """Return a rim of the satellites; ``sense``: +1 where it meshes below its axis."""
    by = sense * radius
    return Side(complex(x, axis - by), complex(x, axis + by), complex(x, axis))


def stated(scene: Scene, language: str) -> Iterator[str]:
    """Say which member stands, or that none does, where it is not the last wheel as usual."""
    order = ASKED.of(scene)
    if order is not None and (motion := motion_of(order)).fixed != SCHEMES[order.scheme].usual[1]:
        yield _stands(motion, language)


def _stands(motion: Motion, language: str) -> str:
    _ = speaking(language)
    if (closing := motion.closing) is not None:
        return _(_CLOSED, one=closing.joint, other=closing.other, driven=motion.driven)
    if not motion.fixed:
        return _(_DIFFERENTIAL, driven=motion.driven)
    return _(_STANDS, member=motion.fixed)


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the train: its teeth, its scheme, its pictures; tell which scheme it is."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    motion = motion_of(order)
    yield _(_SCHEMES[order.scheme])
    yield _stands(motion, language)
    if order.ratio is not None:
        yield _(_TEETH)
    bevel = SCHEMES[order.scheme].bevel
    yield _(_DRAWN_BEVEL if bevel else _DRAWN)
    single = len(SCHEMES[order.scheme].meshes) == 1
    yield _(_PLANET if single else _PICTURES if motion.fixed or motion.closing else _THIRD)
    if bevel:
        yield _(_RELATIVE)
    if order.moment is not None:
        yield _(_TORQUES)
    if order.behind or order.before:
        yield _(_BEHIND if order.behind else _BEFORE)
    if order.rack:
        yield _(_RACK)


_SCHEMES = {
    "ring": said("The train has a single row: sun wheel 1, satellites 2, ring 3, carrier H."),
    "external-internal": said(
        "The train has two rows: wheel 1 and rim 2 of the satellites mesh externally, rim 3 and "
        "ring 4 internally; carrier H."
    ),
    "external-external": said(
        "The train has two rows, both meshing externally: wheel 1 with rim 2 of the satellites, "
        "their rim 3 with wheel 4; carrier H."
    ),
    "internal-internal": said(
        "The train has two rows, both meshing internally: ring 1 with rim 2 of the satellites, "
        "their rim 3 with ring 4; carrier H."
    ),
    "external": said("Satellite 2 rolls on wheel 1 from outside; the arm H carries it."),
    "internal": said("Satellite 2 rolls in ring 1; the arm H carries it."),
    "3K": said(
        "The train has three central wheels: wheel 1 and ring 3 mesh with rim 2 of the satellites, ring 5 with "
        "their rim 4; carrier H runs idle."
    ),
    "bevel": said(
        "The train is of bevel wheels: satellites 2 mesh with wheels 1 and 3; carrier H holds their axes."
    ),
    "bevel-double": said(
        "The train is of bevel wheels: wheel 1 meshes with rim 2 of the satellites, their rim 3 with wheel 4; "
        "carrier H holds their axes."
    ),
}
_DRAWN_BEVEL = said("The kinematic scheme of the train is drawn to scale by its mean radii.")
_RELATIVE = said(
    "The angular velocity of the satellites about their axis is found from the triangle of angular velocities."
)
_STANDS = said("Of its coaxial members {member} stands still.")
_DIFFERENTIAL = said("No member stands still: two of its shafts drive, {driven} is driven.")
_CLOSED = said(
    "No member stands still: wheels outside join {one} and {other}, so that one shaft drives; {driven} is "
    "driven."
)
_THIRD = said(
    "The picture of linear velocities and the plan of angular velocities are drawn; the angular velocity of "
    "the driven shaft is found from them and compared with Willis's formula."
)
_PLANET = said(
    "The picture of linear velocities and the plan of angular velocities are drawn; the angular velocity of "
    "satellite 2 is found from them and compared with Willis's formula."
)
_TORQUES = said("The torques on all shafts are found, with the losses in the meshes.")
_TEETH = said(
    "The numbers of teeth are found by the ratio wanted, the coaxiality, the assembly and the "
    "neighbourhood of the satellites."
)
_DRAWN = said("The pitch circles and the kinematic scheme of the train are drawn to scale.")
_PICTURES = said(
    "The picture of linear velocities and the plan of angular velocities are drawn; the ratio is "
    "found from them and compared with Willis's formula."
)
_BEHIND = said("The speed behind the following pair of wheels is found.")
_RACK = said("The last wheel drives a rack; its speed is found.")
_BEFORE = said(
    "The speed behind the pair of wheels before the train is found, and that of the driven shaft."
)


TASK_SHEET = TaskSheet(
    given=given,
    stated=stated,
    scheme=scheme,
    wanted={"planetary": asks},
)
