"""What placing letters costs: fields of 45 to 360 letters on the same paper, with as many lines."""

from __future__ import annotations

import cmath
import math
from functools import partial

from clock import Row, in_turns, show, slope

from graphic_tmm.paper.drawing import Ink, Wanted, circle, line
from graphic_tmm.paper.labels import interrupt, leaders, place

COUNTS = (45, 90, 180, 360)
RADIUS = 90.0
MOST = 1.15


def field(count: int) -> tuple[list[Wanted], list[Ink]]:
    """Return a plan of positions: cranks about a pivot, rods to a guide, a number at each pin."""
    pins = [cmath.rect(RADIUS, math.tau * k / count) for k in range(count)]
    rods = [line("thin", z, z.real + math.sqrt(260**2 - z.imag**2)) for z in pins]
    cranks = [line("thin", 0j, z) for z in pins]
    wanted = [Wanted(str(k), z, 3.5, 1.2, z) for k, z in enumerate(pins)]
    return wanted, [circle("thin", 0j, RADIUS), *cranks, *rods]


def lettered(wanted: list[Wanted], lines: list[Ink]) -> int:
    """Place the letters, draw their leaders, break the lines; return how many lines are left."""
    labels = place(wanted, lines)
    return len(interrupt([*lines, *leaders(wanted, labels)], labels))


def main() -> None:
    """Print the table."""
    calls = {str(count): partial(lettered, *field(count)) for count in COUNTS}
    seconds = in_turns(calls, rounds=5)
    found = slope(COUNTS, [seconds[str(count)] for count in COUNTS])
    each = ", ".join(f"{seconds[str(n)] / n * 1000:.2f} ms" for n in COUNTS)
    told = f"{found:.2f} ({each} a letter)"
    show(
        "Placing letters",
        [Row("time by letters, 45 to 360: slope in log–log", told, f"≤ {MOST}", found <= MOST)],
    )


if __name__ == "__main__":
    main()
