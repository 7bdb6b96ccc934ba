"""Digits said to be left and those that are, beside hard places: judged by the same log run at 50 digits.

python tests/benchmarks/digits.py       # two minutes
"""

from __future__ import annotations

import sys
import time
from collections.abc import Iterator
from pathlib import Path

import numpy as np

sys.path.insert(0, str(Path(__file__).parent.parent))

from hard.test_hard_change_points import CASES
from judges.test_random_drives import WAYS, random_of
from support import gallery
from support.digits_left import Judged, judged, scene_of
from support.hard_mechanisms import weighed
from support.loaded import weighed as loaded
from support.mechanisms import sample

from graphic_tmm import read
from graphic_tmm.accuracy.hard.walk import walk
from graphic_tmm.scene.records import Scene

RANDOM, SEED = 100, 5000
DRIVEN = 8
"""Mechanisms of each kind of drives: slider, rod, open crank and two of them."""
SCENES = (
    *("windrower", "lever", "offset-slider", "toggle-press", "scotch-yoke", "shaper", "engine"),
    *("locomobile", "crank-press", "tangent-mechanism", "oscillating-cylinder", "crank-rocker"),
)


def _groups() -> Iterator[tuple[str, list[Scene], int]]:
    yield "scenes of sheets/", [gallery.scene(name) for name in SCENES], 1
    linkages = [scene_of(weighed(mechanism)) for mechanism, _ in CASES.values()]
    yield "change points, slotted levers", linkages, 1
    drawn = enumerate(sample(RANDOM, seed=SEED, dyads=(1, 3)))
    yield "random, up to their locks", [scene_of(loaded(one, k), one.phi) for k, one in drawn], 5
    seeds = [(kind, seed) for kind in WAYS for seed in range(1, DRIVEN + 1)]
    yield "random drives", [read(random_of(*one, forces=True)[1]) for one in seeds], 5


def _line(name: str, found: list[Judged], seconds: float) -> str:
    said, true, away = (
        np.concatenate([getattr(one, part) for one in found]) for part in ("said", "true", "away")
    )
    missing, lost = sum(one.missing for one in found), sum(one.lost for one in found)
    drawn = sum(len(one.drawn) for one in found)
    figures = [
        *(name, f"{len(found)}", f"{said.size:,}"),
        *(f"{np.median(said):.1f} / {said.min():.1f}", f"{np.median(true):.1f} / {true.min():.1f}"),
        " / ".join(f"{x:.1f}" for x in (away.min(), np.median(away), np.quantile(away, 0.95))),
        *(f"{missing:,} ({drawn:,})", f"{lost:,}", f"{seconds:.2f}"),
    ]
    return "| " + " | ".join(figures) + " |"


def main() -> None:
    """Print the rows of the table in tests/README."""
    for name, scenes, every in _groups():
        found, seconds = [], 0.0
        for scene in scenes:
            start = time.process_time()
            walked = walk(scene)
            seconds = max(seconds, time.process_time() - start)
            found.append(judged(walked, every))
        print(_line(name, found, seconds))


if __name__ == "__main__":
    main()
