"""What the sections of effects, loads, forces and friction say against themselves and the mechanism."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from graphic_tmm.chapters.forces import task
from graphic_tmm.chapters.forces.task import GRAVITY
from graphic_tmm.scene import letters
from graphic_tmm.scene.declare import Found, Path, Said, Section
from graphic_tmm.scene.quantities import KGF, in_kgf
from graphic_tmm.scene.references import Outline, no_link

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts

TOLD = ("force", "moment", "by_position", "by_angle", "of")


def _effects(said: Said, parts: Parts) -> Iterator[Found]:
    if said.gas and "indicator" not in parts.doc:
        says = "no pressures are given; write a section [indicator], or leave gas out"
        yield Found(("effects", "gas"), says)
    if said.friction and "friction" not in parts.doc:
        says = "no coefficients are given; write a section [friction] with f = 0.1"
        yield Found(("effects", "friction"), says)


def _forces(said: Said, parts: Parts) -> Iterator[Found]:
    for number in said.single:
        if number not in parts.names.bodies:
            yield from no_link(("forces", "single"), number, parts.names)


def _loads(loads: list[tuple[Path, Said]], parts: Parts) -> Iterator[Found]:
    count = parts.drive.positions if parts.drive is not None else None
    for path, load in loads:
        yield from _load(path, load, parts.names, count)


def _load(path: Path, load: Said, names: Outline, count: int | None) -> Iterator[Found]:
    if load.link not in names.bodies:
        yield from no_link((*path, "link"), load.link, names)
        return
    if load.link == names.frame:
        yield Found((*path, "link"), f"link {load.link} is the frame; name a moving link")
    own = names.bodies[load.link].letters
    if load.point is not None and load.point not in own:
        hint = letters.unknown(load.point, own, f"letters of link {load.link}")
        yield Found((*path, "point"), f'"{load.point[:20]}" is no letter of link {load.link}{hint}')
    if load.of is not None and load.of not in names.moving:
        hint = letters.unknown(load.of, names.moving, "moving points")
        yield Found((*path, "of"), f'"{load.of[:20]}" is no moving point{hint}')
    yield from _size(path, load, count)


def _size(path: Path, load: Said, count: int | None) -> Iterator[Found]:
    told = [key for key in TOLD if getattr(load, key) is not None]
    if not told:
        says = (
            'nothing says how large it is; write force = "190 N", moment, by_position or by_angle'
        )
        yield Found((*path, "force"), says)
    for other in told[1:]:
        says = f"{told[0]} gives the size already; leave one of them out"
        yield Found((*path, other), says)
    if load.force is not None and load.point is None:
        yield Found((*path, "point"), 'a force acts at a point; write point = "D"')
    if load.moment is not None and load.point is not None:
        yield Found((*path, "point"), "a moment acts on the whole link; leave the point out")
    if load.by_position is not None and count is not None and len(load.by_position) != count:
        says = f"{len(load.by_position)} sizes for {count} positions; give one for each"
        yield Found((*path, "by_position"), says)
    strokes = load.out is not None or load.back is not None
    if load.of is None and strokes:
        says = 'by the travel of which point? write of = "D"'
        yield Found((*path, "of"), says)
    if load.of is not None and not strokes:
        says = 'it says no size; write out = [[0, "0 N"], [1, "190 N"]], or back'
        yield Found((*path, "of"), says)


def _friction(made: Said, parts: Parts) -> Iterator[Found]:
    names = parts.names
    bodies = names.bodies.values()
    pins = [x for x in names.letters if sum(x in body.letters for body in bodies) > 1]
    guides = [slide.along for link in parts.links if link is not None for slide in link.pairs]
    for key, told, known in (
        ("pairs", made.pairs, [*pins, *guides]),
        ("radii", made.radii, pins),
    ):
        for name in told:
            if name not in known:
                hint = letters.unknown(name, known, "pairs" if key == "pairs" else "pins")
                yield Found(("friction", key, name), f'"{name[:20]}" is none{hint}')
    rubs = made.f > 0 and made.radius is None and not made.radii
    if rubs and not guides:
        says = 'friction in a pin needs its radius; write radius = "15 mm"'
        yield Found(("friction", "radius"), says)


def _idle(name: str, written: str) -> Iterator[str]:
    yield f"{name}: nothing is computed of {written} without a section [forces]; add it, or take {written} out"


def _idle_loads(loads: object, parts: Parts) -> Iterator[str]:
    if "forces" not in parts.doc:
        yield from _idle("load", "[[load]]")


def _idle_effects(said: Said, parts: Parts) -> Iterator[str]:
    if parts.doc.get("effects") and "forces" not in parts.doc:
        yield from _idle("effects", "[effects]")


def _idle_friction(said: Said, parts: Parts) -> Iterator[str]:
    effects = parts.said["effects"]
    if parts.doc["friction"] and "forces" not in parts.doc:
        yield from _idle("friction", "[friction]")
    if "forces" in parts.doc and not (effects is not None and effects.friction):
        yield "friction: it does not act; write friction = true in [effects], or take [friction] out"


def _defaults(said: Said, parts: Parts) -> Iterator[str]:
    effects = parts.said["effects"]
    if effects is not None and effects.gravity and effects.g is None and in_kgf(parts.doc):
        yield (
            f"effects.g: it is left out, so weights are taken with {GRAVITY} m/s², while a kgf is {KGF} N; "
            f'write g = "{KGF} m/s^2", or the one that is meant'
        )


SECTIONS = (
    Section(
        "effects", task.Effects, always=True, alone=True, gives=True,
        check=_effects, idle=_idle_effects,
    ),
    Section(
        "load", task.Load, "forces and moments on links", several=True, gives=True,
        check=_loads, idle=_idle_loads,
    ),
    Section(
        "forces", task.ForcesOrder, "kinetostatics and the lever",
        begin="positions = [2]", weighs=True, check=_forces, joined=task.joined, defaults=_defaults,
    ),
    Section(
        "friction", task.Rubbed, "friction of the pairs", gives=True,
        check=_friction, idle=_idle_friction,
    ),
)  # fmt: skip
