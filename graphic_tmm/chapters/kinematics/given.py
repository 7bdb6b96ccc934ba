"""What a scene gives of its mechanism: the task, lengths, guides, how the crank turns, masses, positions."""

from __future__ import annotations

import math
from collections.abc import Iterator, Sequence

from graphic_tmm.board.draft import ROUNDING
from graphic_tmm.chapters.kinematics.drives import driven
from graphic_tmm.language.catalogue import speaking
from graphic_tmm.language.said import said
from graphic_tmm.language.symbols import plain, symbol
from graphic_tmm.language.units import small, unit
from graphic_tmm.mechanism.guides import turn
from graphic_tmm.mechanism.masses import inertia_letter
from graphic_tmm.mechanism.records import Arm, Extreme, Guide, Link, Mechanism, Sweep
from graphic_tmm.mechanism.structure import dissect
from graphic_tmm.mechanism.wheels import size_names
from graphic_tmm.readers.given_task import given_by_task
from graphic_tmm.readers.narration import remark
from graphic_tmm.readers.task_sheet import SIZE, Given, given_figure
from graphic_tmm.scene.records import Scene


def given(scene: Scene) -> Iterator[Given]:
    """Yield what a scene gives of its mechanism, lengths in mm."""
    mechanism = scene.mechanism
    if mechanism is None:
        return
    yield from given_by_task(scene)
    rows = [*_lengths(mechanism), *_fixed(scene, mechanism)]
    yield from dict.fromkeys(Given(name, size, SIZE) for name, size in rows)
    yield from _directions(mechanism)
    yield from _wheels(mechanism)
    pairs = driven(mechanism, dissect(mechanism))
    for pair in pairs:
        yield from pair.given(scene.language)
    for pair in pairs[1:]:
        own = pair.sweep
        yield Given(f"{own.letter}_{{{pair.link},0}}", pair.drive.start, "°" if own.turns else SIZE)
    if scene.row.open:
        yield _places(scene, pairs[0].sweep)
    yield from _masses(mechanism)
    yield Given("positions in a turn", scene.row.count)


def stroke(scene: Scene) -> Given:
    """Return what an open row goes through: from where to where (20…75°, 600…850 mm), or all its places."""
    ends = scene.row.ends
    return coordinates(scene, ends, "…") if ends else coordinates(scene, scene.row.places)


def _places(scene: Scene, sweep: Sweep) -> Given:
    """Return the stroke of an open row, with the lengths outside it; angles there are names of positions."""
    own, row = stroke(scene), scene.row
    outside = [one for one in row.extra if isinstance(one, float) and not sweep.turns]
    if not outside:
        return own
    return own._replace(value=f"{own.value}; {coordinates(scene, outside).value}")


def coordinates(scene: Scene, values: Sequence[float], between: str = "; ") -> Given:
    """Return coordinates of the first drive: angles, or lengths in the unit that shows them best."""
    assert scene.mechanism is not None
    sweep = driven(scene.mechanism, dissect(scene.mechanism))[0].sweep
    sizes = [(one, "°") if sweep.turns else small(one, scene.language) for one in values]
    figures = between.join(given_figure(size, scene.language) for size, _ in sizes)
    stem, _, index = (sweep.name or sweep.letter).partition("_")
    return Given(f"{stem}_{{{index}}}" if index else stem, figures, sizes[0][1])


def _lengths(mechanism: Mechanism) -> Iterator[tuple[str, float]]:
    """The lengths of the moving links, m: from the first point, and from the second where not in line."""
    for link in _ordered(mechanism):
        letters = list(link.points)
        if link.arms:
            yield from _arms(link)
            letters = letters[:1]
        for k, other in enumerate(letters[1:], start=1):
            yield from _between(link, letters[0], other)
            if k > 1 and _aside(link, letters[0], letters[1], other):
                yield from _between(link, letters[1], other)
        yield from _guides(link, link.points[letters[0]] if letters else 0j)
        for slide in link.slides:
            if abs(slide.offset) > ROUNDING:
                yield f"h_{{{link.number}}}", abs(slide.offset)


def _arms(link: Link) -> Iterator[tuple[str, float]]:
    """The lengths of the arms of a link, m, from the letter at which they are welded."""
    for arm in link.arms:
        for letter in (one for one in arm.letters if one != arm.at):
            yield from _between(link, arm.at, letter)


def _between(link: Link, first: str, second: str) -> Iterator[tuple[str, float]]:
    length = abs(link.points[second] - link.points[first])
    if length > ROUNDING:
        yield f"l_{{{first}{second}}}", length


def _aside(link: Link, first: str, second: str, other: str) -> bool:
    """Whether a point lies off the line of two others."""
    base, way = (link.points[k] - link.points[first] for k in (second, other))
    return abs((base.conjugate() * way).imag) > 1e-9 * abs(base) * abs(way)


def _guides(link: Link, origin: complex) -> Iterator[tuple[str, float]]:
    for guide in link.guides:
        off = ((origin - guide.through) * turn(-guide.angle)).imag
        if abs(off) > ROUNDING:
            yield f"e_{{{guide.name}}}", abs(off)


def _fixed(scene: Scene, mechanism: Mechanism) -> Iterator[tuple[str, float]]:
    """Where fixed pivots and guides stand; named as from the crank's where a task puts that not at its 0."""
    pivot = dissect(mechanism).origin
    elsewhere = scene.task is not None and abs(mechanism.frame.points[pivot]) > ROUNDING
    for name, size in frame_sizes(mechanism):
        if elsewhere and name[:3] in ("x_{", "y_{"):
            name = f"{name[:3]}{pivot}{name[3:]}"
        yield name, size


def frame_sizes(mechanism: Mechanism) -> Iterator[tuple[str, float]]:
    """Where the fixed pivots and guides stand, m, seen from the pivot of the crank."""
    frame, pivot = mechanism.frame, dissect(mechanism).origin
    for letter, at in frame.points.items():
        away = at - frame.points[pivot]
        if min(abs(away.real), abs(away.imag)) > ROUNDING:
            yield f"x_{{{letter}}}", away.real
            yield f"y_{{{letter}}}", away.imag
        elif letter != pivot:
            yield f"l_{{{pivot}{letter}}}", abs(away)
    yield from _guides(frame, frame.points[pivot])


def _directions(mechanism: Mechanism) -> Iterator[Given]:
    """The directions of guides that are neither level nor upright, or stand obliquely in their link."""
    for guide in mechanism.frame.guides:
        if guide.angle % 90.0:
            yield _direction(guide, 0.0)
    for link in _ordered(mechanism):
        first, *others = link.arms or (None,)
        for arm in others:
            yield from _between_arms(link, first, arm)
        spots: Sequence[complex] = [z for z in link.points.values()]
        base = math.degrees(math.atan2(*_sides(spots))) if len(spots) > 1 else 0.0
        for guide in link.guides:
            if abs(math.remainder(guide.angle - base, 90.0)) > 1e-9:
                yield _direction(guide, base)


def _between_arms(link: Link, first: Arm | None, second: Arm) -> Iterator[Given]:
    """The angle from the first arm of a link to another, by a point of each, if both have one elsewhere."""
    assert first is not None
    at = link.points[second.at]
    one, two = (next((k for k in arm.letters if k != second.at), None) for arm in (first, second))
    if one is None or two is None:
        return
    base, way = link.points[one] - at, link.points[two] - at
    angle = math.degrees(math.atan2(*_sides((0j, way * base.conjugate()))))
    yield Given(f"α_{{{one}{second.at}{two}}}", angle, "°")


def _sides(spots: Sequence[complex]) -> tuple[float, float]:
    away = spots[1] - spots[0]
    return away.imag, away.real


def _direction(guide: Guide, base: float) -> Given:
    """From the line that it is measured from, to the side that the author draws it."""
    angle = guide.angle - base
    if abs(angle) >= 360.0 or base:
        angle = math.remainder(angle, 360.0)
    return Given(f"α_{{{guide.name}}}", angle, "°")


def stated(scene: Scene, language: str) -> Iterator[str]:
    """Tell the rate of what stands, from where positions are counted, where accelerations are wanted."""
    _, zero = speaking(language), scene.row.zero
    if scene.mechanism is not None and scene.at_rest:
        pair = driven(scene.mechanism, dissect(scene.mechanism))[0]
        rate = plain(symbol(pair.speed_letter, language))
        yield _(_STANDS, rate=f"{rate} = 1 {unit('1/s' if pair.sweep.turns else 'm/s', language)}")
    if scene.mechanism is not None:
        for pair in driven(scene.mechanism, dissect(scene.mechanism)):
            yield from pair.stated(language)
        for mesh in scene.mechanism.meshes:
            (first, second), (centre, other) = mesh.links, mesh.centres
            yield _(
                _BELT if mesh.belted else _MESH,
                kind=_(_JOINED.get(mesh.by) or (_INTERNAL if mesh.internal else _EXTERNAL)),
                first=first,
                second=second,
                centre=centre,
                other=other,
                angle=f"{given_figure(mesh.start, language)}°",
            )
    if isinstance(zero, Extreme):
        yield _(_ZERO, extreme=remark(f"{zero.point}: {zero.at}", language))
    if told := wanted_accelerations(scene, language):
        yield told


def wanted_accelerations(scene: Scene, language: str) -> str:
    """Tell in which positions accelerations are wanted; "" if in all of them, or in none."""
    wanted = scene.row.accelerations
    if not wanted or len(wanted) >= scene.row.count:
        return ""
    return speaking(language)(_ACCELERATIONS, n=len(wanted), listed=", ".join(wanted))


_MESH = said(
    "Links {first} and {second} bear wheels in {kind} mesh, about {centre} and {other}; seen from the link "
    "that joins the centres, link {second} stands at {angle} where link {first} stands at 0°."
)
_BELT = said(
    "Links {first} and {second} bear wheels about {centre} and {other}, joined by {kind}; seen from the link "
    "that joins the centres, link {second} stands at {angle} where link {first} stands at 0°."
)
_JOINED = {
    "belt": said("an open belt", context="joined by"),
    "crossed belt": said("a crossed belt", context="joined by"),
    "chain": said("a chain", context="joined by"),
}
_EXTERNAL, _INTERNAL = said("external", context="mesh"), said("internal", context="mesh")
_STANDS = said("The mechanism stands; plans of possible velocities are drawn at {rate}.")
_ZERO = said("Positions are counted from the {extreme}.")
_ACCELERATIONS = said(
    "The plan of accelerations is wanted in position {listed}.",
    "Plans of accelerations are wanted in positions {listed}.",
)


def _wheels(mechanism: Mechanism) -> Iterator[Given]:
    """The teeth or pitch radii of wheels on links, and how one stands by the other."""
    for mesh in mechanism.meshes:
        for name, size in zip(size_names(mechanism, mesh), mesh.sizes, strict=True):
            yield Given(name, size, "" if mesh.toothed else SIZE)
        if mesh.start:
            yield Given(f"φ_{{{mesh.links[1]},0}}", mesh.start, "°")


def _masses(mechanism: Mechanism) -> Iterator[Given]:
    for link in _ordered(mechanism):
        if link.mass is not None:
            yield Given(f"m_{link.number}", link.mass, "kg")
    for link in _ordered(mechanism):
        if link.inertia is not None:
            if link.rod is not None:
                yield Given(f"l_{link.number}", link.rod, "m")
                continue
            yield Given(inertia_letter(link), link.inertia, "kg·m²")


def _ordered(mechanism: Mechanism) -> list[Link]:
    """Return the moving links by their numbers: in what order a scene writes them tells nothing."""
    return sorted(mechanism.drawn, key=lambda link: link.number)
