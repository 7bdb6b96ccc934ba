"""What the drawing board costs: `python tests/benchmarks/run.py`. Medians of one run, as ratios.

The machine is noisy: trust the ratios of one run, not the seconds.
"""

from __future__ import annotations

import statistics
import subprocess
import sys
import time
from collections.abc import Callable
from dataclasses import replace
from functools import partial
from pathlib import Path

import numpy as np

HERE = Path(__file__).resolve().parent
PATHS = [str(HERE), str(HERE.parent), str(HERE.parent.parent)]
sys.path[:0] = PATHS

from clock import Row, median, show  # noqa: E402


def reference() -> None:
    """A fixed piece of numpy: 100 products of small complex arrays."""
    a = np.full((1, 13), 1 + 1j)
    for _ in range(100):
        a = a * 1j


def closed_form(phi: np.ndarray) -> np.ndarray:
    """The windrower's positions, velocities and accelerations in bare numpy."""
    oa, ob, bc, omega = 0.13657, 0.48, 0.16694, 39.79
    a = oa * np.exp(1j * phi)
    z = a + 1j * ob
    u, d = z / np.abs(z), np.abs(z)
    v = 1j * omega * a
    w = (v * u.conj()).imag / d
    rel = (v * u.conj()).real
    eps = ((-(omega**2) * a * u.conj()).imag - 2 * w * rel) / d
    c = -1j * ob - bc * u
    vc, ac = 1j * w * (c + 1j * ob), (1j * eps - w**2) * (c + 1j * ob)
    y = -ob - 1.25 * bc
    dx = np.sqrt(bc**2 - (y - c.imag) ** 2)
    r = dx + 1j * (y - c.imag)
    w4 = -vc.imag / r.real
    e4 = (-ac.imag + w4**2 * r.imag) / r.real
    return np.concatenate([vc + 1j * w4 * r, ac + (1j * e4 - w4**2) * r])


def windrower() -> tuple[Callable[[], object], int]:
    """Return a run of all three plans of the windrower, and the number of its steps."""
    from graphic_tmm.board.execute import prepare
    from graphic_tmm.scene.read import read
    from graphic_tmm.work import work

    made = work(replace(read(HERE.parent.parent / "sheets" / "windrower"), diagrams=None))
    program = prepare(made.project.construction)
    return lambda: program.run(made.given), len(made.project.construction.steps)


def by_operation() -> list[tuple[str, int, float]]:
    """Return the operations of the windrower's plans: how often, and median seconds of one."""
    from graphic_tmm.board.execute import execute
    from graphic_tmm.scene.read import read
    from graphic_tmm.work import work

    made = work(replace(read(HERE.parent.parent / "sheets" / "windrower"), diagrams=None))
    log = made.project.construction
    reading = execute(log, made.given)
    spent: dict[str, list[float]] = {}
    with np.errstate(all="ignore"):
        for step in log.steps:
            run = partial(step.op.run, *[reading[mark] for mark in step.uses], **step.choice)
            spent.setdefault(step.op.name, []).append(median(run, 0.02))
    rows = [(name, len(times), statistics.mean(times)) for name, times in spent.items()]
    return sorted(rows, key=lambda row: -row[1] * row[2])


def million(count: int = 1_000_000) -> tuple[float, int]:
    """Run a four-bar at many positions; return seconds and how many values were kept."""
    from drawn import board

    from graphic_tmm.board.execute import execute
    from graphic_tmm.mechanism.records import Drive, Link, Mechanism, Side

    four_bar = Mechanism(
        Link(0, {"O": 0j, "C": 0.3}),
        (
            Link(1, {"O": 0j, "A": 0.1}),
            Link(2, {"A": 0j, "B": 0.28}, side=Side(1, ("A", "C"))),
            Link(3, {"C": 0j, "B": 0.22}),
        ),
        Drive(1, 10.0),
    )
    sheet = board(four_bar)
    angles = np.linspace(0.0, 360.0, count, endpoint=False)[None, :]
    wanted = [
        sheet.velocities.images.by_letter[2]["B"],
        sheet.accelerations.images.by_letter[2]["B"],
        sheet.velocities.rates[2],
        sheet.accelerations.rates[2],
    ]
    start = time.perf_counter()
    reading = execute(sheet.log, sheet.given | {sheet.positions.phi: angles}, wanted)
    return time.perf_counter() - start, len(reading.values)


def peak_memory() -> float:
    """Return the most memory this process has held, MB.

    Not ru_maxrss where there is better: a process starts with that of the one that started it.
    """
    status = Path("/proc/self/status")
    if status.exists():
        words = next(line for line in status.read_text().splitlines() if "VmHWM" in line).split()
        return int(words[1]) / 1024
    import resource

    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def peak_of_million() -> tuple[float, float]:
    """Return seconds and peak memory (MB) of the million positions, in a process of its own."""
    code = (
        f"import sys; sys.path[:0] = {PATHS!r}; import runpy;"
        f"m = runpy.run_path({str(HERE / 'run.py')!r}); s, _ = m['million']();"
        "print(s, m['peak_memory']())"
    )
    out = subprocess.run([sys.executable, "-c", code], capture_output=True, text=True, check=True)
    seconds, peak = map(float, out.stdout.split())
    return seconds, peak


def main() -> None:
    """Print the table of the README."""
    import speed_sheet

    phi = np.radians(np.arange(13) * 30.0)
    unit = median(reference)
    bare = median(lambda: closed_form(phi))
    run, steps = windrower()
    plans = median(run)
    rows: list[Row] = [
        ("100 products of small arrays (the unit)", unit, unit),
        ("windrower, 13 positions, closed form in numpy", bare, unit),
        (f"windrower, 13 positions, three plans ({steps} steps)", plans, unit),
        ("   of it, one step", plans / steps, unit),
        ("   the same, against the closed form", plans, bare),
    ]
    print(f"{'what':<58}{'ms':>10}{'ratio':>9}")
    show(rows + speed_sheet.lettering(unit) + speed_sheet.sheet() + speed_sheet.cold())
    print(f"{'operation':<26}{'times':>6}{'µs':>8}{'share':>8}")
    each = by_operation()
    total = sum(times * seconds for _, times, seconds in each)
    for name, times, seconds in each:
        share = times * seconds / total
        print(f"{name:<26}{times:>6}{seconds * 1e6:>8.2f}{share:>8.0%}")
    seconds, peak = peak_of_million()
    print(f"1 000 000 positions of a four-bar, v and a: {seconds:.2f} s, peak {peak:.0f} MB")
    print(f"Python {sys.version.split()[0]}, numpy {np.__version__}")


if __name__ == "__main__":
    main()
