"""Springs and dampers as they are drawn: a zigzag, a piston in its cup, beside what slides along them."""

from __future__ import annotations

from collections.abc import Iterator

from graphic_tmm.chapters.forces.springs import constants, ends_of
from graphic_tmm.chapters.forces.task import Spring
from graphic_tmm.mechanism.records import Mechanism
from graphic_tmm.paper.drawing import Stroke, line
from graphic_tmm.paper.lettering.markup import markup

ASIDE, APART = 9.0, 3.5
"""How far beside what slides along it a spring stands, how far off their line a spring and a damper, mm."""
COILS, WIDE, COIL = 9, 2.4, 2.8
"""The coils of a spring, half its width, the longest of a coil, mm."""
CUP, FREE = 9.0, 2.2
"""How long the cup of a damper is, half its width, mm."""


def draw_ink(spring: Spring, mechanism: Mechanism, start: complex, end: complex) -> list[Stroke]:
    """Return the strokes of a spring or damper between two places; none where these are one."""
    if abs(end - start) < COIL:
        return []
    across = 1j * (end - start) / abs(end - start)
    by = ASIDE * across if _lies_along(spring, mechanism) else 0j
    found = [line("thin", at, at + by) for at in (start, end) if by]
    start, end = start + by, end + by
    both = spring.damping is not None and _pulls(spring)
    if both:
        ends = [(at + APART * across, at - APART * across) for at in (start, end)]
        found += [line("thin", *one) for one in ends]
    if _pulls(spring):
        off = APART * across * both
        found += _zigzag(start + off, end + off)
    if spring.damping is not None:
        off = -APART * across * both
        found += _dashpot(start + off, end + off)
    return found


def letter_of(spring: Spring, index: str) -> str:
    """Return the letters that stand beside a spring: of what pulls, of what damps (mark-up)."""
    stiffness, _, preload, damping = constants(index)
    pulls = [stiffness if spring.rate is not None else preload] if _pulls(spring) else []
    return ", ".join(
        markup(one) for one in (*pulls, *([damping] if spring.damping is not None else []))
    )


def middle(spring: Spring, mechanism: Mechanism, start: complex, end: complex) -> complex:
    """Return where the middle of a spring is drawn."""
    apart = end - start
    aside = abs(apart) >= COIL and _lies_along(spring, mechanism)
    return (start + end) / 2 + (ASIDE * 1j * apart / abs(apart) if aside else 0j)


def _pulls(spring: Spring) -> bool:
    return spring.rate is not None or bool(spring.force)


def _lies_along(spring: Spring, mechanism: Mechanism) -> bool:
    """Whether a link that bears one end slides on a link that bears the other: they lie along the spring."""
    first, last = (
        {number for number, link in mechanism.by_number.items() if letter in link.points}
        for letter in ends_of(spring, mechanism).letters
    )
    slides = [(link.number, slide.on) for link in mechanism.links for slide in link.slides]
    return any((i in first and j in last) or (i in last and j in first) for i, j in slides)


def _zigzag(start: complex, end: complex) -> Iterator[Stroke]:
    reach = abs(end - start)
    along = (end - start) / reach
    coil = min(COIL, 0.8 * reach / COILS)
    begin = (reach - COILS * coil) / 2
    spots = [start, start + begin * along]
    for k in range(COILS):
        side = 1j * (1 if k % 2 else -1) * WIDE
        spots.append(start + (begin + (k + 0.5) * coil + side) * along)
    yield line("thin", *spots, end - begin * along, end)


def _dashpot(start: complex, end: complex) -> Iterator[Stroke]:
    along = (end - start) / abs(end - start)
    half, at = min(CUP, 0.5 * abs(end - start)) / 2, (start + end) / 2
    open_, floor = at - half * along, at + half * along
    wall = 1j * FREE * along
    yield line("thin", open_ + wall, floor + wall, floor - wall, open_ - wall)
    yield line("thin", floor, end)
    yield line("thin", start, at)
    yield line("main", at + 0.7 * wall, at - 0.7 * wall)
