"""Random mechanisms as scenes of a person: other letters for their points, written as TOML.

Letters are drawn from a pool in which no letter speaks for a role: S, S1 and S2 join links, centres are called
anything, images look like poles and like rates of links.
"""

from __future__ import annotations

import random
from dataclasses import replace
from typing import Any

from graphic_tmm.mechanism.records import Guide, Link, Mechanism, Slide

POOL = (
    *("S", "S1", "S2", "S3", "S11", "P1", "P2", "N", "N2", "K", "K3", "T2", "M1", "Ω", "E1", "C′"),
    *("B", "B′", "D", "E", "F", "H", "L", "R", "V3", "Ж", "Д", "Б2", "Φ", "Z", "A3", "Q", "U", "W"),
)


def relettered(mechanism: Mechanism, seed: int) -> Mechanism:
    """Return the mechanism with its letters drawn from the pool; a mass centre may be left undeclared."""
    pick = random.Random(seed)
    told = list(dict.fromkeys(k for link in mechanism.by_number.values() for k in link.points))
    names = dict(zip(told, pick.sample(POOL, len(told)), strict=True))

    def link_of(link: Link) -> Link:
        side = link.side
        if side is not None and side.left_of is not None:
            a, c = side.left_of
            side = replace(side, left_of=(names[a], names[c]))
        declared = link.centre is not None and pick.random() < 0.7
        return replace(
            link,
            points={names[k]: z for k, z in link.points.items()},
            side=side,
            centre=names[link.centre] if declared and link.centre else None,
            mass=link.mass if declared else None,
            inertia=None,
        )

    return replace(
        mechanism, frame=link_of(mechanism.frame), links=tuple(map(link_of, mechanism.links))
    )


def text_of(mechanism: Mechanism, degrees: float, count: int, tail: str) -> str:
    """Return a scene of the mechanism from the crank angle ``degrees`` on; ``tail``: sheets and the rest."""
    frame, drive = mechanism.frame, mechanism.drive
    rows = ['title = "Drawn at random"', 'language = "en"', "[frame]", f"number = {frame.number}"]
    rows += [f'"{letter}" = {_point(z)}' for letter, z in frame.points.items()]
    rows += [f"{guide.name} = {_guide(guide)}" for guide in frame.guides]
    for link in mechanism.links:
        points = ", ".join(f'"{letter}" = {_point(z)}' for letter, z in link.points.items())
        rows += ["[[link]]", f"number = {link.number}", f"points = {{ {points} }}"]
        if link.guides:
            guides = ", ".join(f"{guide.name} = {_guide(guide)}" for guide in link.guides)
            rows.append(f"guides = {{ {guides} }}")
        if link.slides:
            rows.append(f"slides = [{', '.join(map(_slide, link.slides))}]")
        if link.side is not None and link.side.left_of is not None:
            way = "left" if link.side.sign > 0 else "right"
            rows.append(f'side = "{way} of {"".join(link.side.left_of)}"')
        rows += [f"mass = {link.mass!r}"] if link.mass is not None else []
        rows += [f'centre = "{link.centre}"'] if link.centre is not None else []
    turns = "counterclockwise" if drive.speed > 0 else "clockwise"
    rows += ["[drive]", f"link = {drive.link}", f"speed = {abs(drive.speed)!r}"]
    rows += [f'turns = "{turns}"', f"positions = {count}", f"zero = {degrees!r}"]
    return "\n".join([*rows, tail])


def _point(z: complex) -> str:
    return f"[{z.real!r}, {z.imag!r}]"


def _guide(guide: Guide) -> str:
    return f"{{ through = {_point(guide.through)}, angle = {guide.angle!r} }}"


def _slide(slide: Slide) -> str:
    told: dict[str, Any] = {"offset": slide.offset, "angle": slide.angle}
    rest = "".join(f", {key} = {value!r}" for key, value in told.items())
    side = f', side = "{"+" if slide.side.sign > 0 else "-"}"' if slide.side is not None else ""
    return f'{{ on = {slide.on}, along = "{slide.guide.name}"{rest}{side} }}'
