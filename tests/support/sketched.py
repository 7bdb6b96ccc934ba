"""Mechanisms as they lie in one position, and the tables of their joints."""

from __future__ import annotations

import random
from collections.abc import Iterator
from typing import Any, NamedTuple

import numpy as np

import graphic_tmm
from graphic_tmm.mechanism.records import Link, Mechanism
from graphic_tmm.mechanism.sketch import lying
from graphic_tmm.readers.any_angles.motion import recorded
from graphic_tmm.scene.records import Scene
from support import gallery

PLANS = frozenset({"positions", "velocities"})
Places = dict[str, complex]


class Standing(NamedTuple):
    """A scene in one position: the coordinate of its drive, where its letters stand, m."""

    scene: Scene
    at: float
    places: Places

    @property
    def mechanism(self) -> Mechanism:
        assert self.scene.mechanism is not None
        return self.scene.mechanism

    @property
    def drawn(self) -> Mechanism:
        """The mechanism as it lies."""
        return lying(self.mechanism, self.places)

    @property
    def size(self) -> float:
        return max(abs(z - w) for z in self.places.values() for w in self.places.values())


def standing(name: str) -> Iterator[Standing]:
    """A scene of the gallery in three of its positions that can be drawn."""
    scene = gallery.scene(name)
    coordinates = recorded(scene, PLANS, exact=True).sheet.project.coordinates
    row = [one for one in coordinates if one is not None]
    for at in (row[0], row[len(row) // 3], row[-1]):
        found = graphic_tmm.motion(scene, [at], exact=True, plans=("positions",))
        places = {letter: complex(z[0]) for (letter, _), z in found.places.items()}
        if all(map(np.isfinite, places.values())):
            assert scene.mechanism is not None
            yield Standing(scene, float(at), {**places, **scene.mechanism.frame.points})


def apart(one: Scene, other: Scene, coordinates: list[float]) -> float:
    """How far places are apart in both scenes, of the size; NaN stands with NaN."""
    first, second = (
        graphic_tmm.motion(scene, coordinates, exact=True, plans=("positions",)).places
        for scene in (one, other)
    )
    assert first.keys() == second.keys()
    size = np.nanmax([np.nanmax(np.abs(row)) for row in first.values()])
    gone = [np.isnan(first[k]) != np.isnan(second[k]) for k in first]
    if np.any(gone):
        return float("inf")
    return float(max(np.nanmax(np.abs(first[k] - second[k])) for k in first) / size)


def by_joints(one: Standing, noise: float = 0.0, seed: int = 0) -> dict[str, Any]:
    """The tables of a mechanism by the places of its joints; each is off by a hand's error, m."""
    pick = random.Random(seed)
    frame = one.mechanism.frame

    def off(place: complex) -> list[float]:
        return [place.real + pick.gauss(0, noise), place.imag + pick.gauss(0, noise)]

    joints = {k: off(z) for k, z in one.places.items() if k not in frame.points}
    drawn = one.drawn
    fixed: dict[str, Any] = {k: [z.real, z.imag] for k, z in frame.points.items()}
    guides = {g.name: _guide(g) for g in frame.guides}
    links = [_link(link, drawn) for link in drawn.drawn]
    return {"frame": {"number": frame.number, **fixed, **guides}, "joints": joints, "link": links}


def _guide(guide: Any) -> dict[str, Any]:
    return {
        "through": [guide.through.real, guide.through.imag],
        "angle": f"{guide.angle!r} deg",
    }


def _link(link: Link, drawn: Mechanism) -> dict[str, Any]:
    told: dict[str, Any] = {"number": link.number, "points": list(link.points)}
    if link.guides:
        told["guides"] = {one.name: _guide(one) for one in link.guides}
    slides = [_slide(one, drawn) for one in link.slides]
    if slides:
        told["slides"] = slides
    if link.side is not None and link.side.flips_at is not None:
        told["flips_at"] = [f"{at!r} deg" for at in link.side.flips_at]
    return told


def _slide(slide: Any, drawn: Mechanism) -> dict[str, Any]:
    told: dict[str, Any] = {"on": slide.on, "along": slide.guide.name}
    if slide.cylinder:
        told["cylinder"] = slide.cylinder
    if slide.side is not None and slide.side.flips_at is not None:
        told["flips_at"] = [f"{at!r} deg" for at in slide.side.flips_at]
    return told
