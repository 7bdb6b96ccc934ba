"""What the sections of effects, loads, forces and friction say against themselves and the mechanism."""

from __future__ import annotations

from collections.abc import Iterator
from typing import TYPE_CHECKING

from graphic_tmm.chapters.forces import task
from graphic_tmm.chapters.forces.kinds import AGAINST, Along, ends_on
from graphic_tmm.chapters.forces.sections_loads import bears, loads, turning
from graphic_tmm.chapters.indicator.task import ONE_TURN
from graphic_tmm.language.said import said
from graphic_tmm.scene import letters
from graphic_tmm.scene.declare import Flaw, Path, Said, Section
from graphic_tmm.scene.quantities import in_kgf
from graphic_tmm.scene.references import Outline, no_link
from graphic_tmm.scene.units import GRAVITY, KGF

if TYPE_CHECKING:
    from graphic_tmm.scene.sections import Parts


MASSES_USED = ("flywheel", "motion_law")
"""Sections that have a use of their own for masses and loads."""


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
    yield from bears(path, unknown, names, ("link",))
    if unknown.direction == AGAINST:
        says = said(
            'it may act either way along its line; write direction = "along BC", or an angle'
        )
        yield Flaw((*path, "direction"), says)
    if isinstance(unknown.direction, Along):
        yield from turning(path, unknown.direction, names)
    if effects is not None and effects.friction:
        says = said("friction is drawn for a drive that is balanced; leave friction or unknown out")
        yield Flaw(path, says)
    for other in (*ONE_TURN, *MASSES_USED):
        if other in parts.doc:
            says = said(
                "the graphs of [{other}] want all loads known; give it a scene of its own",
                other=other,
            )
            yield Flaw(path, says)


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
    still = effects is not None and not effects.gravity and not effects.inertia
    if (
        still
        and not any(name in parts.doc for name in MASSES_USED)
        and any(link.mass for link in parts.links if link is not None)
    ):
        yield said(
            "effects: masses are given, but neither gravity nor inertia is switched on: forces are those of "
            "the loads alone"
        )
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
        check=loads, idle=_idle_loads,
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
