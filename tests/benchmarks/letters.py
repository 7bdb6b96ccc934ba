"""What placing letters costs: plans of 45 to 360 positions, each on paper of its own; as many on one paper."""

from __future__ import annotations

import cmath
import math
import tempfile
from collections.abc import Callable, Sequence
from functools import partial
from pathlib import Path

from clock import ROOT, Row, in_turns, show, slope

from graphic_tmm.chapters.kinematics.ink_plans import Place, draw_plan
from graphic_tmm.chapters.kinematics.task import VELOCITIES
from graphic_tmm.paper.drawing import Drawing, Ink, Wanted, circle, line
from graphic_tmm.paper.labels import finished
from graphic_tmm.paper.seen import Subject
from graphic_tmm.scene.read import read
from graphic_tmm.studio import make

COUNTS = (45, 90, 180, 360)
RADIUS, MU = 90.0, 0.05
"""Of the pins of the one plan, mm; of the others' scale, (m/s)/mm."""
MOST = 1.15


def plans(count: int) -> list[Drawing]:
    """Return the plans of velocities of the film feed in so many positions, their letters without places."""
    text = (ROOT / "sheets" / "crank-rocker" / "scene.toml").read_text(encoding="utf-8")
    with tempfile.TemporaryDirectory() as folder:
        file = Path(folder) / "scene.toml"
        file.write_text(text.replace("positions     = 8", f"positions     = {count}"), "utf-8")
        drawn = make(read(file)).boards[0]
    log, reading = drawn.construction, drawn.of(VELOCITIES)
    assert reading is not None
    return [
        draw_plan(Subject(log, reading, name=str(k)), VELOCITIES, [Place(k)], MU, "m/s")
        for k in range(count)
    ]


def field(count: int) -> list[Drawing]:
    """Return one plan of positions: cranks about a pivot, rods to a guide, a number at each pin."""
    pins = [cmath.rect(RADIUS, math.tau * k / count) for k in range(count)]
    rods = [line("thin", z, z.real + math.sqrt(260**2 - z.imag**2)) for z in pins]
    cranks = [line("thin", 0j, z) for z in pins]
    wanted = tuple(Wanted(str(k), z, 3.5, 1.2, z) for k, z in enumerate(pins))
    lines: tuple[Ink, ...] = (circle("thin", 0j, RADIUS), *cranks, *rods)
    return [Drawing("positions", "", lines, wanted=wanted)]


def lettered(views: Sequence[Drawing]) -> int:
    """Place the letters of views, draw their leaders, break the lines; return how many lines are left."""
    return sum(len(finished(view).strokes) for view in views)


def growth(views: Callable[[int], list[Drawing]], what: str, most: float | None) -> Row:
    """Return a line of the table: how the time grows."""
    seconds = in_turns({str(n): partial(lettered, views(n)) for n in COUNTS}, rounds=5)
    found = slope(COUNTS, [seconds[str(n)] for n in COUNTS])
    told = f"{found:.2f} ({', '.join(f'{seconds[str(n)] / n * 1000:.2f}' for n in COUNTS)} ms each)"
    if most is None:
        return Row(what, told)
    return Row(what, told, f"≤ {most}", found <= most)


def main() -> None:
    """Print the table."""
    show(
        "Placing letters, 45 to 360 positions: slope in log–log",
        [
            growth(plans, "a plan of velocities in each position", MOST),
            growth(field, "one plan of all positions on one paper, over-full from 180 on", None),
        ],
    )


if __name__ == "__main__":
    main()
