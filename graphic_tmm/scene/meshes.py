"""Wheels on links as a file gives them: two links, the letters about which they turn, teeth or pitch radii."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from graphic_tmm.language.said import said
from graphic_tmm.scene.declare import Flaw, Path
from graphic_tmm.scene.mechanism import Frame, Link, Mesh
from graphic_tmm.scene.references import arm_only, no_link, of_link, unknown_letters
from graphic_tmm.scene.sections import Parts, pairing
from graphic_tmm.scene.weld import one_body, weld_faults

APART = 1e-6
"""Pitch radii come to the distance of the centres within this share of it: lengths have few digits."""


def mesh_faults(parts: Parts) -> Iterator[Flaw]:
    """Yield what is wrong with wheels on links, where all links are in order."""
    links = [link for link in parts.links if link is not None]
    if not parts.meshes or len(links) < len(parts.links) or any(weld_faults(parts)):
        return
    welded = {link.number: link.weld.to for link in links if link.weld is not None}
    passive = {link.number for link in links if link.passive}
    bodies: dict[int, Frame | Link] = {link.number: link for link in one_body(links)}
    if parts.frame is not None:
        bodies[parts.frame.number] = parts.frame
    for path, mesh in pairing(parts.meshes, "mesh"):
        faults = list(_ends(path, mesh))
        for k, number in enumerate(() if faults else mesh.links):
            at: Path = (*path, "links", k)
            if number in welded:
                faults.append(Flaw(at, arm_only(number, welded[number])))
            elif number not in bodies:
                faults += no_link(at, number, parts.names)
            elif number in passive:
                says = said("link {number} is passive: nothing is held by it", number=number)
                faults.append(Flaw(at, says))
            else:
                known = tuple(bodies[number].points)
                letter = (mesh.centres[k],)
                faults += unknown_letters((*path, "centres", k), letter, known, of_link(number))
        yield from faults or _sizes(path, mesh, bodies)


def _ends(path: Path, mesh: Mesh) -> Iterator[Flaw]:
    """A list that does not name two; one link, or one letter, twice."""
    for name in ("links", "centres"):
        ends = getattr(mesh, name)
        if len(ends) != 2 or ends[0] == ends[1]:
            says = said("two wheels are in mesh: name two different ones, each once")
            yield Flaw((*path, name), says)
    if bool(mesh.teeth) == bool(mesh.radii):
        says = said(
            "give the teeth of both wheels, teeth = [20, 40], or their radii, one of the two"
        )
        yield Flaw((*path, "teeth"), says)
    elif mesh.teeth and mesh.by != "teeth":
        says = said(
            "a belt or a chain is drawn from wheel to wheel: give their radii; a sprocket with z teeth for a "
            "chain of the pitch t has z·t/2π"
        )
        yield Flaw((*path, "teeth"), says)
    elif len(mesh.sizes) != 2:
        says = said("two wheels are in mesh: write two numbers, in the order of links")
        yield Flaw((*path, "teeth" if mesh.teeth else "radii"), says)


def _sizes(path: Path, mesh: Mesh, bodies: Mapping[int, Frame | Link]) -> Iterator[Flaw]:
    """Centres that no link joins; wheels that do not fit between them, or turn as one."""
    first, second = mesh.centres
    arms = [
        body
        for number, body in bodies.items()
        if number not in mesh.links and first in body.points and second in body.points
    ]
    if not arms:
        says = said(
            "no link besides {links} has both {first} and {second}: what joins the centres of two wheels is "
            "rigid; give both letters to the arm, or to the frame",
            links=", ".join(map(str, mesh.links)),
            first=first,
            second=second,
        )
        yield Flaw((*path, "centres"), says)
        return
    one, other = mesh.sizes
    apart = abs(arms[0].points[first] - arms[0].points[second])
    if mesh.by != "teeth":
        yield from _belt(path, mesh, apart)
        return
    if mesh.internal and one == other:
        says = said(
            "a wheel with its teeth inside is larger than the one in it: give different sizes"
        )
        yield Flaw((*path, "teeth" if mesh.teeth else "radii"), says)
    wanted = abs(one - other) if mesh.internal else one + other
    if mesh.radii and abs(wanted - apart) > APART * apart:
        says = said(
            "the centres {first} and {second} are {apart:.6g} mm apart, but the radii come to {wanted:.6g} mm "
            "({rule}): change a radius, or give teeth, whose ratio alone counts",
            first=first,
            second=second,
            apart=1000.0 * apart,
            wanted=1000.0 * wanted,
            rule=said("their difference") if mesh.internal else said("their sum"),
        )
        yield Flaw((*path, "radii"), says)


def _belt(path: Path, mesh: Mesh, apart: float) -> Iterator[Flaw]:
    """Wheels of a belt that do not stand apart, or bear teeth inside."""
    if mesh.internal:
        says = said(
            'internal is said of teeth: by = "belt" keeps the sense of turning, by = "crossed belt" turns it'
        )
        yield Flaw((*path, "internal"), says)
    if sum(mesh.sizes) >= apart:
        says = said(
            "the centres {first} and {second} are {apart:.6g} mm apart, but the radii come to {wanted:.6g} mm: "
            "wheels that a belt or a chain joins stand apart; make a radius smaller",
            first=mesh.centres[0],
            second=mesh.centres[1],
            apart=1000.0 * apart,
            wanted=1000.0 * sum(mesh.sizes),
        )
        yield Flaw((*path, "radii"), says)
