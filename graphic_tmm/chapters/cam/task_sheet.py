"""What a task gives of a cam, its phases as a scheme, and what it asks, a sentence each."""

from __future__ import annotations

import math
from collections.abc import Iterator
from itertools import accumulate, pairwise

from graphic_tmm.chapters.cam import words_drum, words_plate
from graphic_tmm.chapters.cam.kinds import FlatRockerFollower, RollerFollower
from graphic_tmm.chapters.cam.task import (
    ASKED,
    CamTask,
    FlatFollower,
    RockerFollower,
)
from graphic_tmm.chapters.cam.task_motion import BY_TABLE, EVEN_SHARES, Stage, levels
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.units import unit as unit_of
from graphic_tmm.paper.drawing import Bezier, Drawing, Ink, Wanted, line
from graphic_tmm.paper.figure import added
from graphic_tmm.paper.formats import HEIGHTS
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.symbols.dimensions import ARROW, Dimension, dimension
from graphic_tmm.paper.symbols.kinematic import arrowhead
from graphic_tmm.readers.task_sheet import (
    SIZE,
    Given,
    Listed,
    Scheme,
    TaskSheet,
    given_figure,
    given_speed,
)
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield what a scene gives of its cam, lengths in mm; phases by their numbers, as the profile has them."""
    order = ASKED.of(scene)
    if order is None:
        return
    rocks = order.rocks
    if not order.phases:
        yield _stroke("", order.stroke, rocks)
    for number, stage in enumerate(order.stages, 1):
        if stage.angle:
            letter, of = ("s", SIZE) if order.slides else ("φ", "°")
            yield Given(f"{letter}_{number}", stage.angle, of)
        if stage.sign and order.phases:
            yield _stroke(f"_{number}", stage.stroke or 0.0, rocks)
    if order.speed is not None:
        yield given_speed("1", order.speed)
    yield from _laws(order)
    yield from _follower(order)
    yield from _spring(order)
    if not isinstance(order.follower, FlatFollower | FlatRockerFollower):
        yield Given("[α]", order.pressure, "°")
        if order.pressure_return is not None and order.pressure_return != order.pressure:
            yield Given("[α_f]", order.pressure_return, "°")


def _stroke(number: str, stroke: float, rocks: bool) -> Given:
    if rocks:
        return Given(f"β{number}", math.degrees(stroke), "°")
    return Given(f"h{number}", stroke, SIZE)


def _spring(order: CamTask) -> Iterator[Given]:
    """What the task gives of the follower's inertia, its load and its spring."""
    spring, rocks = order.spring, order.rocks
    if spring is None:
        return
    force = "N·m" if rocks else "N"
    yield Given("J_B", spring.inertia, "kg·m²") if rocks else Given("m_B", spring.inertia, "kg")
    if spring.load:
        yield Given("Q", spring.load, force)
    if spring.preload is not None and spring.rate is not None:
        yield Given("F_0", spring.preload, force)
        yield Given("c", spring.rate, "N·m/rad" if rocks else "N/m")
        return
    yield Given("k", spring.reserve, "")
    if spring.lead is not None:
        lead = (math.degrees(spring.lead), "°") if rocks else (spring.lead, SIZE)
        yield Given("S_0", *lead)


def stated(scene: Scene, language: str) -> Iterator[str]:
    """Tell the kind of follower."""
    order = ASKED.of(scene)
    if order is None:
        return
    follower = order.follower
    if isinstance(follower, RollerFollower):
        kinds = (_EDGE, _OFFSET_EDGE) if follower.edge else (_CENTRAL, _OFFSET)
        kind = kinds[bool(follower.offset)]
    else:
        kind = _ROCKER if isinstance(follower, RockerFollower) else _FLAT
        kind = _FLAT_ROCKER if isinstance(follower, FlatRockerFollower) else kind
    if order.slides:
        kind = words_plate.STATED[getattr(follower, "edge", False)]
    elif order.developed:
        kind = words_drum.STATED
    yield speaking(language)(kind)
    if order.groove:
        yield speaking(language)(words_drum.GROOVE)


_CENTRAL = said("The follower is central, with a roller.")
_OFFSET = said("The follower is offset, with a roller.")
_EDGE = said("The follower is central, with a knife edge.")
_OFFSET_EDGE = said("The follower is offset, with a knife edge.")
_ROCKER = said("The follower is a lever with a roller.")
_FLAT = said("The follower has a flat face.")
_FLAT_ROCKER = said("The follower is a lever with a flat face.")


_WAYS = {1: "rise", 3: "return"}


def _laws(order: CamTask) -> Iterator[Given]:
    laws = {k: one.law for k, one in enumerate(order.stages, 1) if one.law is not None}
    alike = len({(one.name, one.shares) for one in laws.values()}) == 1
    for k, law in laws.items():
        of = "" if alike else f" {k}" if order.phases else f" of the {_WAYS[k]}"
        yield Given(f"given law{of}", f"law {law.name}")
        if law.shares != EVEN_SHARES:
            name = "given shares" if alike else f"given shares {k}"
            yield Given(name, "{:g} : {:g}".format(*law.shares))
        if alike:
            return


def _follower(order: CamTask) -> Iterator[Given]:
    """The sizes of the follower that the task fixes."""
    follower = order.follower
    if isinstance(follower, RockerFollower):
        yield Given("l", follower.lever, SIZE)
        yield Given("a_w", follower.centres, SIZE)
    elif isinstance(follower, RollerFollower) and follower.offset:
        yield Given("e", follower.offset, SIZE)
    elif isinstance(follower, FlatRockerFollower):
        yield Given("a_w", follower.centres, SIZE)
        if follower.face:
            yield Given("d", follower.face, SIZE)
    if order.allowed_rho:
        yield Given("[ρ]", order.allowed_rho, SIZE)


LETTERS_SIZE = HEIGHTS["A4"].point
WIDEST, BESIDE = 130.0, 26.0
"""How wide a turn is drawn at most; what stands beside it, mm."""
HIGH, OVER = 26.0, 9.0
"""How high the stroke is drawn, how far axes go on, mm."""
ROWS = (8.0, 16.0)
"""How far below the axis the dimensions of wide phases and of narrow ones stand, mm."""
TITLE = said("Phases of the follower's motion", context="task")
LAW = said("the law of motion is given in the table")


def scheme(scene: Scene, room: complex) -> Scheme | None:
    """Return the phases of the cam within a width (of ``room``, complex, mm); None if there is no cam."""
    order = ASKED.of(scene)
    if order is None:
        return None
    wide = min(WIDEST, room.real - BESIDE)
    parts = list(_lines(order, wide))
    axes = (line("thin", 0j, complex(wide + OVER)), line("thin", 0j, 1j * (HIGH + OVER)))
    tips = ((complex(wide + OVER), 1 + 0j), (1j * (HIGH + OVER), 1j))
    strokes = [*added(axes, "axis")]
    for tip, way in tips:
        strokes += added(arrowhead(tip, way, pen="thin", length=ARROW), "axis")
    strokes += added(parts, "contour")
    labels = []
    for one in _sizes(order, wide):
        strokes += added(one.strokes, "dimension")
        labels.append(one.label)
    letters = ("ψ" if order.rocks else "S", "s_{c}" if order.slides else "φ")
    wanted = (
        Wanted(letters[0], tips[1][0], LETTERS_SIZE, 1.0, -1 + 0j),
        Wanted(letters[1], tips[0][0], LETTERS_SIZE, 1.0, 1j),
    )
    _ = speaking(scene.language)
    view = Drawing("scheme", _(TITLE), tuple(strokes), tuple(labels), wanted=wanted)
    return Scheme(finished(view), 0.0, (_(LAW),))


def _ends(order: CamTask, wide: float) -> list[float]:
    """Return where the phases begin and end, mm."""
    return [0.0, *(wide * at / order.whole for at in accumulate(one.angle for one in order.stages))]


def _lines(order: CamTask, wide: float) -> Iterator[Ink]:
    """Yield the follower at rest above and below, and a bow of no law between."""
    places = [HIGH * high / order.stroke for high in levels(order.stages)]
    spots = [complex(x, y) for x, y in zip(_ends(order, wide), places, strict=True)]
    for start, end in pairwise(spots):
        if start.imag == end.imag:
            if start != end:
                yield line("main", start, end)
            continue
        half = complex((end - start).real / 2.0)
        yield Bezier("main", (start, start + half, end - half, end))


def _sizes(order: CamTask, wide: float) -> Iterator[Dimension]:
    """Yield the dimensions: the phases below the axis, the stroke beside it."""
    for number, (start, end) in enumerate(pairwise(_ends(order, wide)), 1):
        if end - start < 1e-6:
            continue
        narrow = end - start < 4.0 * ARROW
        below = -ROWS[1 if narrow else 0]
        text = f"{'s' if order.slides else 'φ'}_{{{number}}}"
        yield dimension(complex(start), complex(end), below, text, LETTERS_SIZE)
    letter = "β" if order.rocks else "h"
    yield dimension(0j, 1j * HIGH, OVER, letter, LETTERS_SIZE)


def asks(scene: Scene, language: str) -> Iterator[str]:
    """Ask for the diagrams of the follower, the least radius, the profile."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    flat = isinstance(order.follower, FlatFollower | FlatRockerFollower)
    yield _(words_plate.DIAGRAMS if order.slides else _DIAGRAMS)
    if order.developed:
        yield from (_(one) for one in (words_plate if order.slides else words_drum).ASKS)
        return
    yield _(_CONVEX if flat else _RADIUS)
    edge = isinstance(order.follower, RollerFollower) and order.follower.edge
    yield _(_FACE if flat else _POINTED if edge else _PROFILE)
    if order.spring is not None:
        yield _(_CHOSEN if order.spring.rate is None else _JUDGED)


def listed(scene: Scene, language: str) -> Iterator[Listed]:
    """Yield the acceleration diagrams of laws that are given by points."""
    order = ASKED.of(scene)
    if order is None:
        return
    _ = speaking(language)
    seen = set[object]()
    for k, stage in enumerate(order.stages, 1):
        if stage.law is None or not stage.law.points or stage.law.points in seen:
            continue
        seen.add(stage.law.points)
        name = str(k) if order.phases else "rise" if stage.sign > 0 else "return"
        title = _(_PHASE, k=k) if order.phases else _(_RISE if stage.sign > 0 else _RETURN)
        if stage.law.name == BY_TABLE:
            yield _table_of(order, stage, f"law-{name}", k, language)
            continue
        heads = (
            "s/s_{0}" if order.slides else "φ/φ_{0}",
            *(given_figure(share, language) for share, _ in stage.law.points),
        )
        row = ("a", *(given_figure(size, language) for _, size in stage.law.points))
        yield Listed(f"law-{name}", title, heads, (row,))


def _table_of(order: CamTask, stage: Stage, name: str, k: int, language: str) -> Listed:
    """Return the table of displacements of a phase, from its beginning."""
    assert stage.law is not None
    letter, unit, per = ("ψ", "°", 180.0 / math.pi) if order.rocks else ("S", "mm", 1000.0)
    points = (
        stage.law.points if stage.sign > 0 else [(1.0 - u, y) for u, y in stage.law.points[::-1]]
    )
    angles = (given_figure(round(share * stage.angle, 9), language) for share, _ in points)
    sizes = (given_figure(round(y * (stage.stroke or 0.0) * per, 9), language) for _, y in points)
    title = speaking(language)(_LINES, k=k)
    rows = (f"{letter}, {unit_of(unit, language)}", *sizes)
    return Listed(name, title, ("φ, °", *angles), (rows,))


_LINES = said("Displacement of the follower in phase {k}")
_CHOSEN = said(
    "The spring is found by the line of its force over the inertia force; the force of contact and the moment "
    "on the camshaft are drawn over the turn."
)
_JUDGED = said(
    "The force of contact and the moment on the camshaft are drawn over the turn; whether the spring keeps the "
    "follower on the cam is judged."
)
_DIAGRAMS = said(
    "Diagrams of the follower's displacement, of dS/dφ and of d²S/dφ² over a turn of the cam are drawn."
)
_RADIUS = said(
    "The region of the cam's centre and the least radius are found by the largest pressure angle "
    "allowed; the radius is chosen."
)
_CONVEX = said(
    "The least radius is found at which the profile is convex everywhere; the radius is chosen."
)
_PROFILE = said(
    "The radius of the roller is chosen; the theoretical and the working profile of the cam are drawn."
)
_POINTED = said("The profile of the cam is drawn.")
_FACE = said("The profile of the cam and the width of the face are drawn.")
_PHASE = said("Acceleration of the follower by shares of phase {k} (in proportion)")
_RISE = said("Acceleration of the follower by shares of the rise (in proportion)")
_RETURN = said("Acceleration of the follower by shares of the return (in proportion)")


TASK_SHEET = TaskSheet(
    given=given,
    stated=stated,
    listed=listed,
    scheme=scheme,
    wanted={"cam": asks},
)
