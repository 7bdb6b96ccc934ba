"""Shares of sources against switching each off: `python tests/benchmarks/sources.py [SCENE ...]`.

20,000 drawings with each source, by a seed of their own; a student's hand.
"""

from __future__ import annotations

import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parent.parent)]

SCENES = ("slider-diagrams", "windrower", "crank-rocker", "cam", "engine", "gear-pair")
TRIALS = 20_000


def main() -> None:
    """Print each share as told and as found, and how far the sums are off."""
    from support.gallery import scene
    from support.switched_off import brute, by_kind, sources_of, tasks, told_by_kind

    worst = 0.0
    for name in sys.argv[1:] or SCENES:
        for task in tasks(scene(name)):
            due = brute(task, "student", TRIALS)
            for quantity, found in sources_of(task, "student").items():
                cells = []
                for source, share in found.parts.items():
                    off = share - due[quantity][source]
                    worst = max(worst, abs(off))
                    cells.append(f"{source} {share:.3f} ({off:+.3f})")
                steps, told = by_kind(found), told_by_kind(found)
                apart = max(abs(steps[k] - told[k]) for k in told)
                print(f"{name:<16}{quantity:<12}" + ", ".join(cells))
                print(f"{'':<28}together {found.together:+.3f}, steps by kind off {apart:.3f}")
    print(f"largest difference {worst:.3f}")


if __name__ == "__main__":
    main()
