"""How accurate the plans are: `python tests/benchmarks/accuracy.py`.

Random mechanisms against vector loops, and the engine's hand readings of the source document.
"""

from __future__ import annotations

import statistics
import sys
from pathlib import Path

HERE = Path(__file__).resolve().parent
sys.path[:0] = [str(HERE.parent), str(HERE.parent.parent)]


def main() -> None:
    """Print the table of the README."""
    from support.compare import errors
    from support.mechanisms import KINDS, sample

    print(f"{'mechanisms':<26}{'number':>7}   largest relative error against vector loops (median)")
    rows = [(kind, sample(300, seed=5, dyads=(1, 1), kinds=[kind])) for kind in KINDS]
    rows.append(("chains of 2 and 3 groups", sample(600, seed=6, dyads=(2, 3))))
    for name, drawn in rows:
        found = [errors(one, turned=False) for one in drawn]
        cells = []
        for quantity in ("r", "v", "a"):
            each = [row[quantity] for row in found]
            cells.append(f"{quantity} {max(each):.1e} ({statistics.median(each):.0e})")
        print(f"{name:<26}{len(drawn):>7}   {'   '.join(cells)}")


if __name__ == "__main__":
    main()
