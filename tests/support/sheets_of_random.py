"""Scenes of random mechanisms whose sheets choose their format themselves."""

from __future__ import annotations

import random
from collections.abc import Iterator

from support.mechanisms import sample
from support.rewritten import text_of

PLACES = ("positions", "velocities", "accelerations", "equations", "structure", "results")
FORCES = """
[effects]
gravity = true
inertia = true
[forces]
"""


def scenes(count: int, seed: int = 14) -> Iterator[str]:
    """Yield scenes: one to four groups, 8 to 24 positions, format auto; every third one with its forces."""
    pick = random.Random(seed)
    for k, one in enumerate(sample(count, seed, dyads=(1, 4))):
        positions = pick.randint(8, 24)
        at = ", ".join(map(str, sorted(pick.sample(range(positions), 3))))
        places = list(PLACES)
        tail = f"accelerations = [{at}]\n"
        if k % 3 == 0:
            tail += FORCES + f"positions = [{at.split(',')[0]}]\n"
        orders = [places, ["forces", "lever", "force table"]][: 1 + (k % 3 == 0)]
        for order in orders:
            listed = ", ".join(f'"{place}"' for place in order)
            tail += f'[[sheet]]\nformat = "auto"\nplace = [{listed}]\n'
        yield text_of(one.mechanism, one.phi, positions, tail)
