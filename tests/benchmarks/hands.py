"""What checking tells: `python tests/benchmarks/hands.py --trials 10000`. Honest drawings, slips.

Every stream is fresh: no drawing here is one that the limits of a verdict were drawn from.
"""

from __future__ import annotations

import argparse
import sys
from collections.abc import Callable, Iterable, Iterator
from concurrent.futures import ProcessPoolExecutor
from functools import partial
from itertools import islice, product
from pathlib import Path
from typing import TypeVar

TESTS = Path(__file__).resolve().parent.parent
sys.path[:0] = [str(TESTS / "checking"), str(TESTS), str(TESTS.parent)]

from support.gallery import SHEETS, exact  # noqa: E402
from support.trials import Blamed, Honest, blamed, honest  # noqa: E402

from graphic_tmm.checking.cells import cells  # noqa: E402

HANDS = ("student", "careful")
Found = TypeVar("Found", Honest, Blamed)


def scenes() -> list[str]:
    """Return the scenes that have something to read."""
    names = sorted(path.parent.name for path in SHEETS.glob("*/scene.toml"))
    return [name for name in names if cells(exact(name))]


def percent(part: int, whole: int) -> str:
    return f"{100.0 * part / whole:.2f} %" if whole else "–"


def honest_table(found: Iterable[tuple[str, str, Honest]]) -> Iterator[str]:
    """Yield the table of honest drawings."""
    yield "| scene | hand | readings | doubtful | drawings | with a wrong reading |"
    yield "|---|---|---:|---:|---:|---:|"
    total = {hand: Honest(0, 0, 0, 0) for hand in HANDS}
    for name, hand, one in found:
        total[hand] = Honest(*(a + b for a, b in zip(total[hand], one, strict=True)))
        yield _honest_row(name, hand, one)
    for hand, whole in total.items():
        yield _honest_row("all", hand, whole)


def _honest_row(name: str, hand: str, one: Honest) -> str:
    doubtful = percent(one.doubtful, one.readings)
    broken = f"{one.broken} ({percent(one.broken, one.drawings)})"
    return f"| {name} | {hand} | {one.readings} | {doubtful} | {one.drawings} | {broken} |"


def blamed_table(found: Iterable[tuple[str, Blamed]]) -> Iterator[str]:
    """Yield the table of rays that were turned."""
    yield "| scene | drawings | that ray blamed | something blamed |"
    yield "|---|---:|---:|---:|"
    total = [0, 0, 0]
    for name, one in found:
        total = [a + b for a, b in zip(total, one, strict=True)]
        if one.drawings:
            yield _blamed_row(name, one)
    yield _blamed_row("all", Blamed(*total))


def _blamed_row(name: str, one: Blamed) -> str:
    ray, some = percent(one.ray, one.drawings), percent(one.some, one.drawings)
    return f"| {name} | {one.drawings} | {ray} | {some} |"


def main() -> None:
    parser = argparse.ArgumentParser(description=__doc__)
    parser.add_argument("--trials", type=int, default=10_000, help="honest drawings in all")
    parser.add_argument("--slips", type=int, default=2, help="drawings with each ray turned")
    parser.add_argument("--scene", action="append", help="only these")
    parser.add_argument("--jobs", type=int, default=2)
    given = parser.parse_args()
    names = given.scene or scenes()
    each = -(-given.trials // (len(names) * len(HANDS)))
    with ProcessPoolExecutor(given.jobs) as pool:
        run: Callable[..., Iterator[Found]] = partial(pool.map, chunksize=1)
        slips = run(partial(blamed, trials=given.slips), names)
        drawn = run(partial(honest, trials=each), *zip(*product(names, HANDS), strict=True))
        tables = (
            honest_table(
                (name, hand, one)
                for name in names
                for hand, one in zip(HANDS, islice(drawn, len(HANDS)), strict=True)
            ),
            blamed_table(zip(names, slips, strict=True)),
        )
        for table in tables:
            for line in table:
                print(line, flush=True)
            print(flush=True)


if __name__ == "__main__":
    main()
