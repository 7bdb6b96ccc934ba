"""A setting: how accurately a scene is drawn; and what of a scene changes with it."""

from __future__ import annotations

from dataclasses import dataclass, replace

from graphic_tmm.board.hand import HANDS, Hand
from graphic_tmm.chapter import chapters
from graphic_tmm.drawn import hand_of
from graphic_tmm.scene.records import Scene

OWN = "scene"
"""The hand that a scene names, with the ruler that it names."""
EACH_SLIP = ("prick", "compass", "swing", "reading", "digits")
"""The five slips of a hand."""
GRID = ("exact", "cad", "careful", "student")
"""The named hands, from the most exact on."""


@dataclass(frozen=True)
class Setting:
    """How a scene is drawn.

    ``hand``: what the hand is called, ``who`` with ruler, seed and number of drawings; ``enlarged``: how many
    times larger than the scene asks for; ``pole``: how many times farther the poles of its graphs.
    """

    scene: Scene
    hand: str
    who: Hand
    enlarged: float = 1.0
    pole: float = 1.0

    def by(self, name: str, who: Hand) -> Setting:
        """Return the same, drawn by another hand."""
        return replace(self, hand=name, who=who)


def named(name: str, scene: Scene, trials: int) -> Hand:
    """Return a hand by its name, with the scene's seed; the exact one reads without a ruler.

    A hand that leaves nothing to chance draws once.
    """
    hand = hand_of(scene) if name == OWN else HANDS[name]
    return hand._replace(seed=scene.seed, trials=trials if hand.slips else 1)


def whole(scene: Scene) -> Scene:
    """Return the scene with its plans at all positions of the row; one without a mechanism has no row."""
    if scene.mechanism is not None:
        for chapter in chapters():
            scene = chapter.accuracy.whole(scene)
    return scene


def at_count(scene: Scene, count: int) -> Scene | None:
    """Return the scene with another number of positions in its row.

    Positions that the scene names keep their places in the turn; None if one of them is not a position of the
    new row. What is given position by position is taken to be straight between them.
    """
    if count == scene.row.count:
        return scene
    found: Scene | None = scene
    for chapter in chapters():
        found = chapter.accuracy.at_count(found, count) if found is not None else None
    return replace(found, row=replace(found.row, count=count)) if found is not None else None
