"""Passive links as a file gives them: what holds them, and what they cannot have."""

from __future__ import annotations

from collections.abc import Iterator, Mapping

from graphic_tmm.language.said import joined, said
from graphic_tmm.scene.declare import Flaw, Path
from graphic_tmm.scene.mechanism import Frame, Link
from graphic_tmm.scene.sections import Parts, pairing

LOADS = ("mass", "J", "rod")
SIDES = ("side", "flips_at")
"""Keys that a passive link cannot have: it carries no force; where it lies is told by what holds it."""


def passive_faults(parts: Parts) -> Iterator[Flaw]:
    """Yield what is wrong with passive links and with what hangs on them."""
    links = [(path, link) for path, link in pairing(parts.links, "link")]
    passive = {link.number for _, link in links if link.passive}
    bodies: dict[int, Frame | Link] = {link.number: link for _, link in links if not link.passive}
    if parts.frame is not None:
        bodies[parts.frame.number] = parts.frame
    for path, link in links:
        if link.passive:
            yield from _needless(path, link)
            yield from _held(path, link, bodies)
        for slide in link.pairs:
            if slide.on in passive:
                says = said(
                    "link {number} slides on link {on}, which is passive: nothing is held by a passive link; "
                    "leave passive out there",
                    number=link.number,
                    on=slide.on,
                )
                yield Flaw((*path, "slides"), says)
    for at, number in driving(parts):
        if number in passive:
            says = said(
                "link {number} is passive: a passive link cannot drive; name another, or leave passive out",
                number=number,
            )
            yield Flaw(at, says)


def driving(parts: Parts) -> Iterator[tuple[Path, int]]:
    """Yield the links that drive, each with the key that names it."""
    drives = [one for one in (parts.drive, *parts.further_drives) if one is not None]
    several = isinstance(parts.doc.get("drive"), list)
    for k, drive in enumerate(drives):
        yield (("drive", k, "link") if several else ("drive", "link")), drive.link


def _needless(path: Path, link: Link) -> Iterator[Flaw]:
    """Masses and sides of a passive link."""
    for name in LOADS:
        if getattr(link, name):
            says = said(
                "link {number} is passive and carries no forces: its pairs are more than equilibrium can "
                "tell reactions of; leave {key} out, or give its share to the links that hold it",
                number=link.number,
                key=name,
            )
            yield Flaw((*path, name), says)
    for name in SIDES:
        if getattr(link, name) is not None:
            says = said(
                "link {number} is passive: what holds it tells where it lies; leave {key} out",
                number=link.number,
                key=name,
            )
            yield Flaw((*path, name), says)


def _held(path: Path, link: Link, bodies: Mapping[int, Frame | Link]) -> Iterator[Flaw]:
    """A passive link that is held by too little, by one link only, or by too much."""
    on = {
        letter: [_whole(n, body) for n, body in bodies.items() if letter in body.points]
        for letter in link.points
    }
    shared = [letter for letter, numbers in on.items() if numbers]
    slides = link.pairs
    if any(slide.cylinder for slide in slides) or len(slides) > 1 or (slides and len(shared) > 1):
        says = said(
            "link {number} is passive: it is held by two letters of other links, or by a letter and a plain "
            "guide; leave the rest of its slides out",
            number=link.number,
        )
        yield Flaw((*path, "slides"), says)
    elif len(shared) + len(slides) < 2:
        says = said(
            "link {number} is passive and shares {listed} with links that move or stand: two letters hold it, "
            "or one letter and a guide",
            number=link.number,
            listed=joined(", ", shared) or said("no letter"),
        )
        yield Flaw((*path, "points"), says)
    elif not slides:
        first = set(on[shared[0]]).intersection(*(on[letter] for letter in shared[1:]))
        for other in sorted(first):
            says = said(
                "link {number} is passive, but all the letters that it shares, {listed}, stand on link "
                "{other}: make them one link",
                number=link.number,
                listed=joined(", ", shared),
                other=other,
            )
            yield Flaw((*path, "points"), says)


def _whole(number: int, body: Frame | Link) -> int:
    """Return the number of the link that a body is one with: its own, or that of an arm's."""
    return body.weld.to if isinstance(body, Link) and body.weld is not None else number
