"""A scene drawn by another hand than its own, or in another of its hand's drawings."""

from __future__ import annotations

from dataclasses import replace

from graphic_tmm.scene.build import DIVISIONS
from graphic_tmm.scene.records import Scene


def drawn_by(scene: Scene, hand: str | None, seed: int | None) -> Scene:
    """Return the scene drawn by another hand, with that hand's own ruler."""
    if hand is not None:
        scene = replace(scene, hand=hand, ruler=DIVISIONS[hand])
    return scene if seed is None else replace(scene, seed=seed)
