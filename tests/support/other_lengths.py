"""Scenes whose links have other lengths, drawn to the same scales: what live ink is judged by."""

from __future__ import annotations

from dataclasses import replace

from graphic_tmm.drawn import Drawn
from graphic_tmm.fitting.given import drawn_as
from graphic_tmm.scene.records import Scene


def other(scene: Scene, share: float) -> Scene:
    """Return a scene whose moving links are longer or shorter by up to a share, each by another one."""
    mechanism = scene.mechanism
    assert mechanism is not None

    def size(number: int) -> float:
        return 1.0 + share * (((number * 37) % 11) / 5.0 - 1.0)

    links = tuple(
        replace(link, points={name: size(link.number) * at for name, at in link.points.items()})
        for link in mechanism.links
    )
    return replace(scene, mechanism=replace(mechanism, links=links))


def drawn_alike(scene: Scene, like: Drawn) -> Drawn:
    """Return the mechanism of a scene drawn in the sizes of another one, by the exact hand."""
    boards = drawn_as(scene, like.sizes, exact=True, wanted=None, mechanism=True)
    return next(one for one in boards if one.board == like.board)
