"""What chance costs: 10 000 drawings of 12 positions by a student, against drawing the random numbers alone."""

from __future__ import annotations

import statistics
import time

import numpy as np
from clock import ROOT, Row, show
from support.boards import drawn_of

from graphic_tmm.board.execute import prepare
from graphic_tmm.board.hand import HANDS, Slip, Slipping
from graphic_tmm.board.values import Length, Number
from graphic_tmm.scene.read import read

TRIALS = 10_000
ROUNDS = 7


def rows() -> list[Row]:
    """Return the lines of the table."""
    made = drawn_of(read(ROOT / "sheets" / "windrower").asking(diagrams=None))
    log = made.project.construction
    wanted = [
        step.it
        for step in log.steps
        if step.it.view in ("velocities", "accelerations") and step.it.kind in (Length, Number)
    ]
    program = prepare(log, wanted)
    hand = HANDS["student"]._replace(trials=TRIALS, seed=3)
    shapes: list[tuple[int, int]] = []
    drawn = Slipping.normal

    def noted(self: Slipping, slip: Slip, width: int, part: slice, axes: int = 1) -> object:
        shapes.append((self.trials, axes * (width if width == 1 else self.whole)))
        return drawn(self, slip, width, part, axes)

    Slipping.normal = noted  # type: ignore[assignment, method-assign]
    program.run(made.given, hand=hand)
    Slipping.normal = drawn  # type: ignore[method-assign]
    ratios, seconds = [], []
    for _ in range(ROUNDS):
        start = time.perf_counter()
        generator = np.random.Generator(np.random.Philox(5))
        for shape in shapes:
            generator.standard_normal(shape)
        middle = time.perf_counter()
        program.run(made.given, hand=hand)
        end = time.perf_counter()
        ratios.append((end - middle) / (middle - start))
        seconds.append(end - middle)
    numbers = sum(a * b for a, b in shapes)
    ratio = statistics.median(ratios)
    positions = len(made.project.names)
    return [
        Row(
            f"windrower, {TRIALS} trials × {positions} positions, {len(program.strata[0][0])} steps, "
            f"{numbers / 1e6:.1f} M random numbers",
            f"{statistics.median(seconds):.2f} s",
        ),
        Row("the same / drawing these numbers alone", f"{ratio:.2f}", "≤ 2", ratio <= 2.0),
    ]


def main() -> None:
    """Print the table."""
    show("hands that slip", rows())


if __name__ == "__main__":
    main()
