"""Budgets of random mechanisms: `python tests/benchmarks/budgets.py [NUMBER OF MECHANISMS]`.

Each by five budgets. What is taken is drawn 1000 times more, with its own scales and by a seed of its own.
"""

from __future__ import annotations

import statistics
import sys
import time
from itertools import pairwise
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parent.parent)]

BUDGETS = (20.0, 10.0, 5.0, 2.0, 1.0)
FRESH = 50_000


def main() -> None:
    """Print each budget and how it was kept, and the sums."""
    from support.drawn_at_random import errors, scenes

    from graphic_tmm.accuracy.budget import choose

    seconds, kept, over, dearer, nearest, count = [], 0, [], 0, 0, 0
    for one in scenes(int(sys.argv[1]) if sys.argv[1:] else 20):
        minutes, cells = [], []
        for percent in BUDGETS:
            start = time.process_time()
            taken = choose(one.scene, percent, nearest=True)
            seconds.append(time.process_time() - start)
            count += 1
            fresh = max(errors(taken.scene, FRESH).values())
            if taken.sentence.startswith("--budget"):
                nearest += 1
                cells.append(f"{percent:g}: nearest {fresh:.2f} ({taken.minutes:.0f})")
                continue
            minutes.append(taken.minutes)
            kept += fresh <= percent
            if fresh > percent:
                over.append(fresh / percent)
            cells.append(f"{percent:g}: {fresh:.2f} ({taken.minutes:.0f})")
        dearer += any(a > b for a, b in pairwise(minutes))
        print(f"{one.kind:<28}{'; '.join(cells)}", flush=True)
    claimed = count - nearest
    print(f"{kept} of {claimed} within, others by up to {max(over, default=1.0):.3f} of it")
    print(f"a looser one dearer: {dearer}; by the nearest: {nearest}")
    print(f"CPU s: median {statistics.median(seconds):.2f}, longest {max(seconds):.2f}")


if __name__ == "__main__":
    main()
