"""Scenes of random mechanisms with as few points as can be: groups that meet in one letter, loads and none.

Letters that stand in no pair go from most links, so stones and bars have one point or none of their own, groups
have no second point, and pins of several links share a letter.
"""

from __future__ import annotations

import random
import re
from collections.abc import Iterator
from dataclasses import replace

from graphic_tmm.mechanism.records import Link, Mechanism
from support.mechanisms import KINDS, Sampled, assemble
from support.rewritten import text_of

GROUPS = (
    *((("PRP",), (1, 3)), (("RPR", "RPP"), (1, 2)), (("PRP", "RPR", "RPP"), (1, 3))),
    *(((kind,), (1, 1)) for kind in KINDS),
    *((KINDS, (1, 3)),) * 3,
)
"""Kinds of dyads and how many of them, least and most, of which a mechanism has one in turn."""
TURN = ("against velocity", "against rotation")


def bare(pick: random.Random, mechanism: Mechanism) -> Mechanism:
    """Return a mechanism most of whose links have no letter but in their pairs; one letter at least is left."""
    counts: dict[str, int] = {}
    for link in (mechanism.frame, *mechanism.links):
        for letter in link.points:
            counts[letter] = counts.get(letter, 0) + 1

    def link_of(link: Link) -> Link:
        paired = {k: z for k, z in link.points.items() if counts[k] > 1}
        enough = paired and (link.number != mechanism.drive.link or len(paired) > 1)
        points = paired if enough and pick.random() < 0.8 else link.points
        weighs = pick.random() < 0.5
        return replace(
            link,
            points=points,
            mass=link.mass if weighs else None,
            inertia=link.inertia if weighs and pick.random() < 0.5 else None,
            centre=pick.choice(list(points)) if weighs else None,
        )

    return replace(mechanism, links=tuple(map(link_of, mechanism.links)))


def scene(number: int, seed: int = 0) -> str:
    """Return a scene as TOML, by its number and the seed alone."""
    pick = random.Random(f"{seed}:{number}")
    kinds, dyads = GROUPS[number % len(GROUPS)]
    drawn = assemble(lambda most: pick.randint(0, most), dyads, kinds)
    mechanism, count = bare(pick, drawn.mechanism), pick.choice((1, 1, 2, 2, 4, 6))
    text = text_of(mechanism, drawn.phi, count, "\n".join(_tail(pick, drawn, mechanism, count)))
    if number % 7 == 3:  # forces may need plans that the scene does not ask for
        text = re.sub(r"(?m)^accelerations = .*\n", "", text)
    for link in mechanism.links:
        if link.inertia is not None:
            mass = f"mass = {link.mass!r}"
            text = text.replace(mass, f"{mass}\nJ = {link.inertia!r}")
    return text.replace('language = "en"', f'language = "{pick.choice(("en", "ru"))}"')


def _tail(pick: random.Random, drawn: Sampled, mechanism: Mechanism, count: int) -> Iterator[str]:
    if mechanism.drive.acceleration:
        yield f"acceleration = {abs(mechanism.drive.acceleration)!r}"
    at = sorted(pick.sample(range(count), min(count, pick.randint(1, 2))))
    yield f"accelerations = {at}"
    if pick.random() < 0.3:
        yield "[plans]"
        yield f'velocities = "{pick.choice(("direct", "turned"))}"'
        yield f'velocity_pole = "{pick.choice(("own", "common"))}"'
    if pick.random() < 0.8:
        yield from _loaded(pick, mechanism, at)
    sliders = [
        next(iter(link.points))
        for link in mechanism.links
        if link.points and any(slide.on == mechanism.frame.number for slide in link.slides)
    ]
    if sliders and count > 3 and pick.random() < 0.5:
        yield f'[diagrams]\npoint = "{pick.choice(sliders)}"'
    if pick.random() < 0.3:
        yield '[hand]\nname = "student"\nseed = 5'
    if pick.random() < 0.5:
        yield f'[[sheet]]\nformat = "{pick.choice(("A1", "A2", "A3", "auto"))}"'


def _loaded(pick: random.Random, mechanism: Mechanism, at: list[int]) -> Iterator[str]:
    yield "[effects]"
    yield from (f"{name} = true" for name in ("gravity", "inertia") if pick.random() < 0.5)
    friction = pick.random() < 0.25
    if friction:
        yield "friction = true"
    for _ in range(pick.choice((0, 1, 1, 2))):
        link = pick.choice(mechanism.links)
        yield f"[[load]]\nlink = {link.number}"
        size = pick.choice((0.0, 100.0, 250.0, -40.0))
        if pick.random() < 0.3:
            yield f"moment = {size!r}"
        else:
            yield f'point = "{pick.choice(list(link.points))}"\nforce = {abs(size)!r}'
            yield f"direction = {pick.choice((0.0, 90.0, -37.5, TURN[0]))!r}"
    yield f"[forces]\npositions = {pick.choice((at, at[:1]))}"
    yield f'balance = "{pick.choice(("force", "moment"))}"'
    yield f'couples = "{pick.choice(("moment", "pair"))}"'
    if friction:
        yield f"[friction]\nf = {pick.choice((0.0, 0.1))}\nradius = 0.01"
