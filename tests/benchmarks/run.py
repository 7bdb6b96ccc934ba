"""What everything costs: `python tests/benchmarks/run.py` prints the tables of tests/README.md.

Medians of one run, competitors in turns. The machine is noisy: trust the ratios, not the seconds. Each of
the scripts named below runs alone too.
"""

from __future__ import annotations

import importlib
import os
import platform
import sys
from importlib.metadata import version

SCRIPTS = (
    "kinematics",
    "two_threads",
    "motion",
    "small",
    "growth",
    "effects_cost",
    "slips",
    "speed_sheet",
    "letters",
)


def main() -> None:
    """Run all scripts, or those that are named."""
    packages = ", ".join(f"{name} {version(name)}" for name in ("numpy", "numba", "shapely"))
    print(f"Python {platform.python_version()}, {packages}, {os.cpu_count()} cores\n")
    for name in sys.argv[1:] or SCRIPTS:
        importlib.import_module(name).main()


if __name__ == "__main__":
    main()
