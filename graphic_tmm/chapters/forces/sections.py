"""What the sections of effects, loads, forces and friction say against themselves and the mechanism."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from graphic_tmm.chapters.forces import task
from graphic_tmm.chapters.forces.kinds import AGAINST, Along, ends_on
from graphic_tmm.chapters.indicator.task import ONE_TURN
from graphic_tmm.language.said import said
from graphic_tmm.scene import letters
from graphic_tmm.scene.declare import Flaw, Path, Said, Section
from graphic_tmm.scene.drive_checks import goes_by_length
from graphic_tmm.scene.quantities import in_kgf
from graphic_tmm.scene.references import Outline, arm_only, no_link, no_moving, of_link
from graphic_tmm.scene.units import GRAVITY, KGF

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts

TOLD = ("force", "moment", "by_position", "by_angle", "of")


def _effects(asked: Said, parts: Parts) -> Iterator[Flaw]:
    if asked.gas and "indicator" not in parts.doc:
        says = said("no pressures are given; write a section [indicator], or leave gas out")
        yield Flaw(("effects", "gas"), says)
    if asked.friction and "friction" not in parts.doc:
        says = said("no coefficients are given; write a section [friction] with f = 0.1")
        yield Flaw(("effects", "friction"), says)


def _forces(asked: Said, parts: Parts) -> Iterator[Flaw]:
    for number in asked.single:
        if number not in parts.names.bodies:
            yield from no_link(("forces", "single"), number, parts.names)
    if asked.unknown is not None:
        yield from _unknown(("forces", "unknown"), asked.unknown, parts)


def _unknown(path: Path, unknown: task.Unknown, parts: Parts) -> Iterator[Flaw]:
    """Say what is wrong with an unknown force: where it acts, its direction, what it cannot go with."""
    names, effects = parts.names, parts.said["effects"]
    if unknown.link not in names.bodies:
        yield from no_link((*path, "link"), unknown.link, names)
        return
    yield from _bears(path, unknown, names, ("link",))
    if unknown.direction == AGAINST:
        says = said(
            'it may act either way along its line; write direction = "along BC", or an angle'
        )
        yield Flaw((*path, "direction"), says)
    if isinstance(unknown.direction, Along):
        yield from _turning(path, unknown.direction, names)
    if effects is not None and effects.friction:
        says = said("friction is drawn for a drive that is balanced; leave friction or unknown out")
        yield Flaw(path, says)
    for other in (*ONE_TURN, "flywheel"):
        if other in parts.doc:
            says = said(
                "the graphs of [{other}] want all loads known; give it a scene of its own",
                other=other,
            )
            yield Flaw(path, says)


def _loads(loads: list[tuple[Path, Said]], parts: Parts) -> Iterator[Flaw]:
    count = parts.drive.count if parts.drive is not None else None
    strokes = parts.drive is not None and goes_by_length(parts.drive, parts)
    for path, load in loads:
        yield from _load(path, load, parts.names, count)
        if load.by_angle is not None and strokes:
            says = said(
                "what drives slides and has no angle: write by_position, or of and out for a travel"
            )
            yield Flaw((*path, "by_angle"), says)
        for other in ONE_TURN:
            if other in parts.doc and task.turns_of(load.by_angle or ()) > 1:
                says = said(
                    "it goes over two turns, and the graphs of [{other}] over one; give it a scene of its own",
                    other=other,
                )
                yield Flaw((*path, "by_angle"), says)


def _load(path: Path, load: Said, names: Outline, count: int | None) -> Iterator[Flaw]:
    if load.link not in names.bodies:
        yield from no_link((*path, "link"), load.link, names)
        return
    yield from _bears(path, load, names, ("link", "from"))
    if load.of is not None and load.of not in names.moving:
        yield Flaw((*path, "of"), no_moving(load.of, names))
    if isinstance(load.direction, Along):
        if load.point is None:
            says = said("a moment has no line of action; leave the direction out")
            yield Flaw((*path, "direction"), says)
        yield from _turning(path, load.direction, names)
    yield from _pair(path, load, names)
    yield from _size(path, load, count)


def _bears(
    path: Path, load: Said | task.Unknown, names: Outline, keys: tuple[str, ...]
) -> Iterator[Flaw]:
    """Say what is wrong with the links that a load acts on, by ``keys``, and with its point."""
    if load.link == names.frame:
        says = said("link {number} is the frame; name a moving link", number=load.link)
        yield Flaw((*path, "link"), says)
    for key in keys:
        number = getattr(load, key)
        welded = names.bodies[number].welded if number in names.bodies else None
        if welded is not None:
            yield Flaw((*path, key), arm_only(number, welded))
        if number in names.bodies and names.bodies[number].passive:
            says = said(
                "link {number} is passive and carries no forces: let the load act on a link that holds it",
                number=number,
            )
            yield Flaw((*path, key), says)
    own = names.bodies[load.link].letters
    if load.point is not None and load.point not in own:
        of = of_link(load.link)
        says = said('"{letter}" is no letter of {of}', letter=load.point[:20], of=of)
        what = said("letters of {of}", of=of)
        yield Flaw((*path, "point"), letters.unknown(says, load.point, own, what))


def _pair(path: Path, load: Said, names: Outline) -> Iterator[Flaw]:
    """Say what is wrong with the opposite of a load: it acts on another link, along the same line."""
    other, at = getattr(load, "from"), load.from_point
    if other is None:
        if at is not None:
            yield Flaw((*path, "from"), said("of which link is that point? write from = 3"))
        return
    if other not in names.bodies:
        yield from no_link((*path, "from"), other, names)
        return
    if other == load.link:
        says = said("link {number} bears the load itself; name another link", number=other)
        yield Flaw((*path, "from"), says)
    if load.direction == AGAINST or (load.direction is None and load.point is not None):
        says = said('two links push each other along a line; write direction = "along AC"')
        if load.point is None:
            says = said(
                "two links turn each other by a moment with its sign; leave the direction out"
            )
        yield Flaw((*path, "direction"), says)
    if at is not None:
        yield from _other_point(path, load, names.bodies[other].letters)


def _other_point(path: Path, load: Said, own: tuple[str, ...]) -> Iterator[Flaw]:
    """Say what is wrong with the point where the opposite of a load acts."""
    other, at, along = getattr(load, "from"), load.from_point, load.direction
    if load.point is None:
        says = said("a moment acts on the whole link; leave the point out")
        yield Flaw((*path, "from_point"), says)
        return
    if at not in own:
        of = of_link(other)
        says = said('"{letter}" is no letter of {of}', letter=at[:20], of=of)
        what = said("letters of {of}", of=of)
        yield Flaw((*path, "from_point"), letters.unknown(says, at, own, what))
        return
    pair = letters.split(along.line) if isinstance(along, Along) else None
    joins = pair is not None and {*pair} == {load.point, at} and along.by % 180.0 == 0.0
    if along not in (None, AGAINST) and not joins:
        says = said(
            'a force and its opposite act along one line; write direction = "along {point}{at}", or leave '
            "from_point out",
            point=load.point,
            at=at,
        )
        yield Flaw((*path, "direction"), says)


def _turning(path: Path, along: Along, names: Outline) -> Iterator[Flaw]:
    """Say what is wrong with a direction that turns with the links: of two letters, or of a guide."""
    at, line = (*path, "direction"), along.line
    pair = letters.split(line)
    if pair is not None and set(pair) <= set(names.letters):
        if pair[0] == pair[1]:
            yield Flaw(at, said('"{line}" names one letter twice; name two letters', line=line))
        return
    owners = [number for number, body in names.bearing.items() if line in body.guides]
    if len(owners) > 1:
        says = said(
            'links {links} have guides called "{line}"; name two letters, "along AC", or call one otherwise',
            links=", ".join(map(str, owners)),
            line=line,
        )
        yield Flaw(at, says)
    elif not owners:
        known = [name for body in names.bearing.values() for name in body.guides]
        says = said('"{line}" is neither two letters of the mechanism nor a guide', line=line[:20])
        yield Flaw(at, letters.unknown(says, line, known, said("guides of the mechanism")))


def _size(path: Path, load: Said, count: int | None) -> Iterator[Flaw]:
    told = [key for key in TOLD if getattr(load, key) is not None]
    if not told:
        says = said(
            'nothing says how large it is; write force = "190 N", moment, by_position or by_angle'
        )
        yield Flaw((*path, "force"), says)
    for other in told[1:]:
        says = said("{key} gives the size already; leave one of them out", key=told[0])
        yield Flaw((*path, other), says)
    if load.force is not None and load.point is None:
        yield Flaw((*path, "point"), said('a force acts at a point; write point = "D"'))
    if load.moment is not None and load.point is not None:
        says = said("a moment acts on the whole link; leave the point out")
        yield Flaw((*path, "point"), says)
    if load.by_position is not None and count is not None and len(load.by_position) != count:
        says = said(
            "{n} sizes for {count} positions; give one for each",
            n=len(load.by_position),
            count=count,
        )
        yield Flaw((*path, "by_position"), says)
    strokes = load.out is not None or load.back is not None
    if load.of is None and strokes:
        says = said('by the travel of which point? write of = "D"')
        yield Flaw((*path, "of"), says)
    if load.of is None and load.start is not None and not strokes:
        says = said('the travel of which point begins there? write of = "D"')
        yield Flaw((*path, "start"), says)
    if load.of is not None and not strokes:
        says = said('it says no size; write out = [[0, "0 N"], [1, "190 N"]], or back')
        yield Flaw((*path, "of"), says)


def _springs(springs: list[tuple[Path, Said]], parts: Parts) -> Iterator[Flaw]:
    for path, spring in springs:
        yield from _spring(path, spring, parts.names)
        if spring.rate is None and spring.damping is None and not spring.force:
            says = said(
                'nothing says how strong it is; write rate = "2 kN/m", or damping = "150 N*s/m"'
            )
            yield Flaw((*path, "rate"), says)
        if (spring.rate is None) != (spring.free is None):
            missing = "free" if spring.free is None else "rate"
            says = said('its force goes by both; write free = "100 mm" and rate = "2 kN/m"')
            yield Flaw((*path, missing), says)


def _spring(path: Path, spring: Said, names: Outline) -> Iterator[Flaw]:
    """Say what is wrong with the ends of a spring and their links."""
    at = (*path, "between")
    unknown = [letter for letter in spring.between if letter not in names.letters]
    for letter in unknown:
        says = said('"{letter}" is no letter of the mechanism', letter=letter[:20])
        yield Flaw(
            at, letters.unknown(says, letter, names.letters, said("letters of the mechanism"))
        )
    bodies = {number: body.letters for number, body in names.bearing.items()}
    loose = [one for one in spring.between if not any(one in own for own in bodies.values())]
    if loose and not unknown:
        says = said(
            '"{letter}" stands on a passive link alone, which carries no forces; name a letter of another',
            letter=loose[0],
        )
        yield Flaw(at, says)
    if unknown or loose:
        return
    if spring.links:
        told = [
            n not in bodies or one not in bodies[n]
            for n, one in zip(spring.links, spring.between, strict=False)
        ]
        if len(spring.links) != 2 or any(told):
            says = said(
                "two links are wanted that have these letters, in their order; or leave links out"
            )
            yield Flaw((*path, "links"), says)
            return
    if (
        spring.between[0] == spring.between[1]
        or ends_on(spring.between, spring.links, bodies) is None
    ):
        says = said("both ends are on one link: it moves nothing; name letters of two links")
        yield Flaw(at, says)


def _friction(made: Said, parts: Parts) -> Iterator[Flaw]:
    names = parts.names
    bodies = names.bearing.values()
    pins = [x for x in names.letters if sum(x in body.letters for body in bodies) > 1]
    guides = [slide.along for link in parts.links if link is not None for slide in link.pairs]
    for key, told, known in (
        ("pairs", made.pairs, [*pins, *guides]),
        ("radii", made.radii, pins),
    ):
        for name in told:
            if name not in known:
                says = said('"{name}" is none', name=name[:20])
                what = (
                    said("pairs", context="known")
                    if key == "pairs"
                    else said("pins", context="known")
                )
                yield Flaw(("friction", key, name), letters.unknown(says, name, known, what))
    rubs = made.f > 0 and made.radius is None and not made.radii
    if rubs and not guides:
        says = said('friction in a pin needs its radius; write radius = "15 mm"')
        yield Flaw(("friction", "radius"), says)


def _idle(name: str, written: str) -> Iterator[str]:
    yield said(
        "{name}: nothing is computed of {written} without a section [forces]; add it, or take {written} "
        "out",
        name=name,
        written=written,
    )


def _idle_loads(loads: object, parts: Parts) -> Iterator[str]:
    if "forces" not in parts.doc:
        yield from _idle("load", "[[load]]")


def _idle_springs(springs: object, parts: Parts) -> Iterator[str]:
    if "forces" not in parts.doc:
        yield from _idle("spring", "[[spring]]")


def _idle_effects(asked: Said, parts: Parts) -> Iterator[str]:
    if parts.doc.get("effects") and "forces" not in parts.doc:
        yield from _idle("effects", "[effects]")


def _idle_friction(asked: Said, parts: Parts) -> Iterator[str]:
    effects = parts.said["effects"]
    if parts.doc["friction"] and "forces" not in parts.doc:
        yield from _idle("friction", "[friction]")
    if "forces" in parts.doc and not (effects is not None and effects.friction):
        yield said(
            "friction: it does not act; write friction = true in [effects], or take [friction] out"
        )


def _defaults(asked: Said, parts: Parts) -> Iterator[str]:
    effects = parts.said["effects"]
    if effects is not None and effects.gravity and effects.g is None and in_kgf(parts.doc):
        yield said(
            "effects.g: it is left out, so weights are taken with {gravity} m/s², while kgf and lbf are made "
            "by {kgf} m/s²; "
            'write g = "{kgf} m/s^2", or the one that is meant',
            gravity=GRAVITY,
            kgf=KGF,
        )
    if effects is not None and effects.inertia and (hidden := _hidden(asked, parts)):
        yield said(
            "forces: inertia is found from plans of accelerations, of which those of positions {positions} are "
            "not drawn; add these to accelerations in [drive] to see them",
            positions=", ".join(hidden),
        )


def _hidden(asked: Said, parts: Parts) -> list[str]:
    """Return the positions with forces whose plans of accelerations nobody asked for."""
    drive = parts.drive
    if drive is None or drive.accelerations == ("all",):
        return []
    every = [str(drive.first + k) for k in range(drive.count)]
    wanted = every if asked.positions == ("all",) else asked.positions
    return [name for name in wanted if name not in drive.accelerations]


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
        "spring", task.Spring, "springs and dampers between links", several=True, gives=True,
        check=_springs, idle=_idle_springs,
    ),
    Section(
        "forces", task.ForcesTask, "kinetostatics and the lever",
        begin="positions = [2]", weighs=True, check=_forces, joined=task.joined, defaults=_defaults,
    ),
    Section(
        "friction", task.Rubbed, "friction of the pairs", gives=True,
        check=_friction, idle=_idle_friction,
    ),
)  # fmt: skip
