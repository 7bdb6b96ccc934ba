"""A setting: how accurately a scene is drawn; and what of a scene changes with it."""

from __future__ import annotations

from dataclasses import dataclass, replace

from graphic_tmm.board.hand import HANDS, Hand
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
