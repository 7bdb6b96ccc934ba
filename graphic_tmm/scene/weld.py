"""Links welded to others: arms of one body, at an angle that stays."""

from __future__ import annotations

from collections.abc import Iterator, Mapping, Sequence
from dataclasses import replace

from graphic_tmm.language.said import joined, said
from graphic_tmm.mechanism.guides import turn
from graphic_tmm.mechanism.records import Arm
from graphic_tmm.scene.declare import Flaw, Path
from graphic_tmm.scene.mechanism import SAME_PLACE, Guide, Link, Slide
from graphic_tmm.scene.passive import driving
from graphic_tmm.scene.references import arm_only
from graphic_tmm.scene.sections import Parts, pairing

OF_BODY = ("side", "flips_at", "mass", "J", "rod", "centre")
"""Keys that are those of the whole body: they stand in the link that an arm is welded to."""


def one_body(links: Sequence[Link]) -> list[Link]:
    """Return links with those that are welded to them: points, guides and slides in the axes of the body."""
    bodies = {link.number: link for link in links if link.weld is None}
    host = {link.number: link.weld.to for link in links if link.weld is not None}
    for arm in (link for link in links if link.weld is not None):
        bodies[host[arm.number]] = _joined(bodies[host[arm.number]], arm)
    return [_slid(link, host) for link in bodies.values()] if host else list(links)


def arms_of(links: Sequence[Link], number: int) -> tuple[Arm, ...]:
    """Return the arms of a link: its own and those welded to it; none of a link without welds."""
    own = next(link for link in links if link.number == number)
    welded = [link for link in links if link.weld is not None and link.weld.to == number]
    found = [Arm(link.number, tuple(link.points), _pin(own, link), _angle(link)) for link in welded]
    return (Arm(number, tuple(own.points), found[0].at, 0.0), *found) if found else ()


def _pin(body: Link, arm: Link) -> str:
    """Return the letter at which an arm is welded to a body."""
    return next(letter for letter in arm.points if letter in body.points)


def _angle(arm: Link) -> float:
    assert arm.weld is not None
    return arm.weld.angle


def _joined(body: Link, arm: Link) -> Link:
    """Return a body with an arm: w = s + e^{iα}·(z − z_s) of its points."""
    pin, angle = _pin(body, arm), _angle(arm)
    at, own, way = body.points[pin], arm.points[pin], turn(angle)

    def moved(z: complex) -> complex:
        return at + way * (z - own)

    def slid(slide: Slide) -> Slide:
        lifted = (own * turn(slide.angle)).imag - (at * turn(slide.angle - angle)).imag
        return replace(slide, angle=slide.angle - angle, offset=slide.offset + lifted)

    guides = {
        name: Guide(moved(one.through), one.angle + angle) for name, one in arm.guides.items()
    }
    return replace(
        body,
        points={**body.points, **{k: moved(z) for k, z in arm.points.items() if k != pin}},
        guides={**body.guides, **guides},
        slides=(*body.pairs, *map(slid, arm.pairs)),
    )


def _slid(link: Link, host: Mapping[int, int]) -> Link:
    """Return a link whose slides name the bodies of the arms that they slide on."""
    slides = tuple(
        replace(one, on=host.get(one.on, one.on)) if isinstance(one.on, int) else one
        for one in link.pairs
    )
    return replace(link, slides=slides)


def weld_faults(parts: Parts) -> Iterator[Flaw]:
    """Yield what is wrong with welds, and with what takes an arm for a link."""
    links = pairing(parts.links, "link")
    bodies = {link.number: link for _, link in links}
    for path, link in links:
        if link.weld is not None:
            yield from _weld(path, link, bodies)
    for at, number in driving(parts):
        arm = bodies.get(number)
        if arm is not None and arm.weld is not None:
            yield Flaw(at, arm_only(number, arm.weld.to))


def _weld(path: Path, link: Link, bodies: Mapping[int, Link]) -> Iterator[Flaw]:
    assert link.weld is not None
    at, to = (*path, "weld", "to"), link.weld.to
    body = bodies.get(to)
    if body is None or to == link.number or body.passive:
        says = said("name another link that moves, which is not passive, by its number")
        yield Flaw(at, says)
        return
    if body.weld is not None:
        yield Flaw(at, arm_only(to, body.weld.to))
        return
    shared = [letter for letter in link.points if letter in body.points]
    if len(shared) != 1:
        says = said(
            "links {number} and {to} share {listed}: an arm is welded at one letter, at its angle",
            number=link.number,
            to=to,
            listed=joined(", ", shared) or said("no letter"),
        )
        yield Flaw((*path, "points"), says)
        return
    for name in OF_BODY:
        if getattr(link, name) is not None:
            says = said(
                "link {number} is welded to link {to} and one body with it; write {key} in link {to}, for both",
                number=link.number,
                to=to,
                key=name,
            )
            yield Flaw((*path, name), says)
    if link.passive:
        yield Flaw((*path, "passive"), said("an arm moves with its body; leave passive out"))
    points = _joined(body, link).points
    for letter in (one for one in link.points if one != shared[0]):
        for other in body.points:
            if abs(points[letter] - points[other]) < SAME_PLACE:
                says = said(
                    "welded at this angle, {letter} lies on {other} of link {to}; change the angle, or leave "
                    "{letter} out",
                    letter=letter,
                    other=other,
                    to=to,
                )
                yield Flaw((*path, "weld", "angle"), says)
