"""A million positions: the executed and the compiled log against hand-written numpy and numba.

The log draws its plans with stable intersections and takes its rates from readings; the hand-written functions
of `bare` compute the same numbers in closed form. Both return new arrays; all are checked against one another
before anything is timed. A row is one mechanism; its ratios are of medians taken in turns.
"""

from __future__ import annotations

import os
import subprocess
import sys
import time
from collections.abc import Callable, Sequence
from tempfile import TemporaryDirectory
from typing import Any, NamedTuple

import numpy as np
from clock import Row, in_turns, show  # first: it finds the tests' other modules

import bare  # isort: skip
from support.drawn import Board, board  # isort: skip

from graphic_tmm.board.compile.machine import machine
from graphic_tmm.board.compile.run import shared
from graphic_tmm.board.execute import Program, Reading, prepare
from graphic_tmm.board.hand import EXACT, Hand
from graphic_tmm.board.record import Mark
from graphic_tmm.mechanism.records import Drive, Guide, Link, Mechanism, Side, Slide

COUNT, SOME = 1_000_000, 65_535
RULER = Hand(ruler=0.1)
SCALES = (0.002, 0.02, 0.2)
TOLERANCE = 1e-9
"""Of the largest number of its kind in the row: both roads are good to 1e-14 away from dead centres."""


def four_bar() -> Mechanism:
    """Return the crank-rocker of `bare.four_bar`."""
    links = (
        Link(1, {"O": 0j, "A": bare.OA}),
        Link(2, {"A": 0j, "B": bare.AB}, side=Side(1, ("A", "C"))),
        Link(3, {"C": 0j, "B": bare.CB}),
    )
    return Mechanism(Link(0, {"O": 0j, "C": bare.OC}), links, Drive(1, bare.OMEGA))


def slider_crank() -> Mechanism:
    """Return the offset slider-crank of `bare.slider_crank`."""
    guide = Guide("x", 1j * bare.OFF, 0.0)
    links = (
        Link(1, {"O": 0j, "A": bare.CRANK}),
        Link(2, {"A": 0j, "B": bare.ROD}),
        Link(3, {"B": 0j}, slides=(Slide(0, guide, side=Side(1)),)),
    )
    return Mechanism(Link(0, {"O": 0j}, (guide,)), links, Drive(1, bare.OMEGA))


def rocker() -> Mechanism:
    """Return the windrower's six links, as in `bare.rocker`."""
    along = Guide("BC", 0j, 0.0)
    guide = Guide("y", -1j * (bare.OB + 1.25 * bare.BC), 0.0)
    links = (
        Link(1, {"O": 0j, "A": bare.R}),
        Link(2, {"A": 0j}, slides=(Slide(3, along, side=Side(1)),)),
        Link(3, {"B": 0j, "C": -bare.BC}, (along,)),
        Link(4, {"C": 0j, "D": bare.BC}),
        Link(5, {"D": 0j}, slides=(Slide(0, guide, side=Side(1)),)),
    )
    frame = Link(0, {"O": 0j, "B": -1j * bare.OB}, (guide,))
    return Mechanism(frame, links, Drive(1, bare.OMEGA))


MECHANISMS = {"four-bar": four_bar, "slider-crank": slider_crank, "six-bar rocker": rocker}
ORDERS: dict[str, tuple[tuple[str, ...], tuple[int, ...]]] = {
    "four-bar": (("B2",), (2, 3)),
    "slider-crank": (("B2",), (2,)),
    "six-bar rocker": (("C3", "D4"), (3, 4)),
}
"""The points (with a link) and the links whose motion is asked for."""


class Case(NamedTuple):
    """A mechanism at many positions: hand-written, and as a log."""

    form: bare.Bare
    drawn: Board
    marks: list[Mark]
    program: Program
    given: dict[Mark, Any]
    phi: Any

    def log(self, program: Program, hand: Hand = EXACT, threads: int = 1) -> Reading:
        """Run the log, executed unless the program is compiled."""
        return program.run(self.given, hand=hand, fast=bool(program.fast), threads=threads)

    def at(self, angles: Any, program: Program) -> Reading:
        """Run the log at other angles."""
        phi = {self.drawn.positions.row[0]: np.asarray(angles)[None, :]}
        return program.run({**self.given, **phi}, fast=bool(program.fast))

    def numpy(self, block: int) -> Any:
        """Run the hand-written numpy."""
        out = np.empty((self.form.width, self.phi.size))
        bare.blocked(self.form.form, self.phi, out, block)
        return out

    def by_numba(self, loop: Callable[[Any, Any], None]) -> Any:
        """Run the hand-written numba."""
        out = np.empty((self.form.width, self.phi.size))
        loop(self.phi, out)
        return out


def case(form: bare.Bare, count: int = COUNT) -> Case:
    """Return a mechanism at ``count`` positions of a turn."""
    drawn = board(MECHANISMS[form.name](), mu=SCALES)
    points, links = ORDERS[form.name]
    plans = (drawn.velocities, drawn.accelerations)
    marks = []
    for letter, link in ((name[0], int(name[1])) for name in points):
        marks.append(drawn.positions.bodies[link].marks[letter])
        marks += [plan.images.by_letter[link][letter] for plan in plans]
    marks += [plan.rates[link] for link in links for plan in plans]
    degrees = np.linspace(0.0, 360.0, count, endpoint=False)
    given = drawn.given | {drawn.positions.row[0]: degrees[None, :]}
    return Case(form, drawn, marks, prepare(drawn.log, marks), given, np.radians(degrees))


def numbers(one: Case, reading: Reading) -> list[Any]:
    """Return what a reading says in SI, in the order of the hand-written function."""
    points, _ = ORDERS[one.form.name]
    found = []
    for k in range(0, 3 * len(points), 3):
        values = [reading[m][0] * mu for m, mu in zip(one.marks[k : k + 3], SCALES, strict=True)]
        both = [(value.real, value.imag) for value in values]
        # the slider's own ordinates do not change
        plane = one.form.name == "four-bar" or (k == 0 and one.form.name != "slider-crank")
        found += [part for pair in both for part in pair[: 2 if plane else 1]]
    rates = [reading[mark][0] for mark in one.marks[3 * len(points) :]]
    speeds, others = rates[::2], rates[1::2]
    return [*found, *speeds, *others]


def agree(first: Sequence[Any], second: Sequence[Any]) -> None:
    """Raise unless two roads lead to the same numbers."""
    for k, (one, other) in enumerate(zip(first, second, strict=True)):
        off = float(np.max(np.abs(one - other)) / np.max(np.abs(other)))
        if not off <= TOLERANCE:
            raise AssertionError(f"number {k} is off by {off:.1e}")


def worst(first: Reading, second: Reading, marks: Sequence[Mark]) -> float:
    """Return how far two readings are apart, in shares of the largest number of a mark."""
    return max(
        float(np.max(np.abs(first[m] - second[m])) / (np.max(np.abs(second[m])) or 1.0))
        for m in marks
    )


def rows(form: bare.Bare) -> list[Row]:
    """Return the lines of one mechanism."""
    one = case(form)
    loop = bare.looped(form.form)
    machine()
    start = time.process_time()
    fast = one.program.compiled()
    one.at(np.linspace(0.0, 9.0, 99), fast)
    compiling = time.process_time() - start
    due, plain = one.numpy(8192), one.log(one.program)
    agree(one.by_numba(loop), due)
    agree(numbers(one, plain), due)
    some = np.linspace(0.0, 360.0, SOME)
    off = worst(one.at(some, fast), one.at(some, one.program), one.marks)
    assert off < 1e-12, off
    del due, plain
    seconds = in_turns(
        {
            "numpy 4096": lambda: one.numpy(4096),
            "numpy 8192": lambda: one.numpy(8192),
            "numpy 16384": lambda: one.numpy(16384),
            "log": lambda: one.log(one.program),
            "log read": lambda: one.log(one.program, RULER),
            "numba": lambda: one.by_numba(loop),
            "fast": lambda: one.log(fast),
            "fast read": lambda: one.log(fast, RULER),
            "fast, 2 threads": lambda: one.log(fast, threads=2),
            "alone": _spin(1),
            "two at once": _spin(2),
        }
    )
    twelve = np.arange(0.0, 360.0, 30.0)
    few = in_turns(
        {"log": lambda: one.at(twelve, one.program), "fast": lambda: one.at(twelve, fast)},
        least=100,
    )
    numpy = min(each for name, each in seconds.items() if name.startswith("numpy"))
    numba = seconds["numba"]

    def line(what: str, name: str, against: float, wanted: float | None = None) -> Row:
        ratio = against / seconds[name]
        found = f"{COUNT / seconds[name] / 1e6:.1f} M/s, ratio {ratio:.2f}"
        if wanted is None:
            return Row(f"{form.name}: {what}", found)
        return Row(f"{form.name}: {what}", found, f"≥ {wanted}", ratio >= wanted)

    return [
        Row(f"{form.name}: hand-written numpy, blocked", f"{COUNT / numpy / 1e6:.1f} M/s"),
        line("log, exact / numpy", "log", numpy, 0.7),
        line("log with readings / numpy", "log read", numpy, 0.7),
        line("compiled log with readings / numpy", "fast read", numpy, 0.6),
        Row(f"{form.name}: hand-written numba", f"{COUNT / numba / 1e6:.1f} M/s"),
        line("compiled log, exact / numba", "fast", numba, 0.85),
        line("compiled log with readings / numba", "fast read", numba, 0.85),
        line("compiled log, two threads / one", "fast, 2 threads", seconds["fast"], 1.7),
        Row(
            f"{form.name}: what two threads of numpy gain on this machine now",
            f"ratio {seconds['alone'] / seconds['two at once']:.2f}",
        ),
        Row(
            f"{form.name}: 12 angles, compiled / executed",
            f"{few['fast'] * 1e6:.0f} µs, ratio {few['log'] / few['fast']:.2f}",
            "≥ 1",
            few["log"] >= few["fast"],
        ),
        Row(f"{form.name}: compiled against executed", f"{off:.0e}", "≤ 1e-12", off <= 1e-12),
        Row(f"{form.name}: compiling, nothing kept", f"{compiling * 1e3:.0f} ms of the processor"),
    ]


def _spin(threads: int) -> Callable[[], object]:
    """Return a call that works twice as long as one thread does, by so many threads: sines, in cache."""
    angles = np.linspace(0.0, 9.0, 4096)

    def half(start: int = 0, stop: int = 0) -> None:
        for _ in range(200):
            np.sin(angles)

    def alone() -> None:
        half()
        half()

    return alone if threads == 1 else lambda: shared(half, 2, 1, threads)


FIRST = """
import time
start = time.process_time()
import kinematics
one = kinematics.case(kinematics.bare.BARE[{k}], 999)
ready = time.process_time()
one.program.run(one.given, fast=True)
print(ready - start, time.process_time() - ready, time.process_time())
"""
"""A process of its own: seconds of the processor until the log is recorded, of its first run, and in all."""


def processes() -> list[Row]:
    """Return what the first compiled run costs in a process: with nothing kept, then with what that kept."""
    found = []
    for k, form in enumerate(bare.BARE):
        with TemporaryDirectory() as folder:
            env = {
                **os.environ,
                "GRAPHIC_TMM_CACHE": folder,
                "PYTHONPATH": os.pathsep.join(sys.path),
            }
            command = [sys.executable, "-c", FIRST.format(k=k)]
            runs = [
                [float(word) for word in subprocess.check_output(command, env=env).split()]
                for _ in range(4)
            ]
        first, second = runs[0], min(runs[1:], key=lambda run: run[1])
        found += [
            Row(
                f"{form.name}: first run, nothing kept",
                f"{first[1]:.2f} s, {first[2]:.2f} s in all",
            ),
            Row(
                f"{form.name}: first run in a second process",
                f"{second[1]:.2f} s, {second[2]:.2f} s in all",
                "≤ 0.4 s",
                second[1] <= 0.4,
            ),
        ]
    return found


def main() -> None:
    """Print the table: M positions/s, ratios of medians taken in turns."""
    show(
        "1 000 000 positions: places, velocities, accelerations",
        [row for form in bare.BARE for row in rows(form)],
    )
    show("seconds of the processor, a process of its own", processes())


if __name__ == "__main__":
    main()
