"""What a batch costs: variants of the shaper in one process and in two, in a cluster; what travels; who grows.

``python tests/benchmarks/batch.py [--variants 60] [--small 300] [--million]``. Seconds of the processor are
those of the works, told by who did them: the rest of what a process that works does is not in them.
"""

from __future__ import annotations

import argparse
import os
import resource
import sys
import tempfile
import time
from collections.abc import Sequence
from pathlib import Path

sys.path.insert(0, str(Path(__file__).parents[1]))

from support.batches import sums
from support.gallery import SHEETS

from graphic_tmm.classroom.batch.record import place
from graphic_tmm.classroom.batch.run import Ran, run
from graphic_tmm.classroom.batch.work import Done, Work, parcel
from graphic_tmm.classroom.making import Request, make_request
from graphic_tmm.classroom.variants.variant import Value, Variant, base, source_of, text_of
from graphic_tmm.fitting.composition import composition_file
from graphic_tmm.scene.read import read
from graphic_tmm.studio import sheet_files


def timed(given: tuple[str, Request]) -> Done:
    """Make what is asked, and tell what it cost: s of the processor, MB that the process has had at most."""
    begun = time.process_time()
    done = make_request(given)
    spent = time.process_time() - begun
    return done._replace(told=(f"{os.getpid()} {spent:.4f} {largest():.1f}",))


def largest() -> float:
    """Return how many MB this process has had at most."""
    return resource.getrusage(resource.RUSAGE_SELF).ru_maxrss / 1024


def variants(count: int, makes: tuple[str, ...]) -> list[Work]:
    """Return works of so many variants of the shaper: lengths of the crank and of the rocker."""
    scene = read(SHEETS / "shaper")
    own = sheet_files(scene, (), composition=True)[1][composition_file(scene.source).name]
    of = base(SHEETS / "shaper")
    asked = Request("", "", makes, composition=str(own), lent=True)
    found = []
    for k in range(count):
        lengths = Value("OA", f"{105 + k % 20}"), Value("BC", f"{590 + k // 20}")
        one = Variant(f"{k}", lengths)
        whole = asked._replace(text=text_of(of, one), source=source_of(of, one).name)
        found.append(Work(one.name, f"{timed.__module__}:timed", (one.name, whole)))
    return found


def ran(works: Sequence[Work], where: int | str) -> tuple[Ran, float, float, int]:
    """Do works in a new folder; return what came of it, s by the clock, s of this process, bytes written."""
    with tempfile.TemporaryDirectory() as folder:
        clock, own = time.perf_counter(), time.process_time()
        found = run(works, Path(folder), executor=where)
        clock, own = time.perf_counter() - clock, time.process_time() - own
        size = sum(path.stat().st_size for path in Path(folder).rglob("*") if path.is_file())
    assert not found.failed, found.failed
    return found, clock, own, size


def costs(found: Ran) -> tuple[float, dict[str, list[float]]]:
    """Return s of the processor of all works, and of each process the MB after each of its works."""
    spent, sizes = 0.0, dict[str, list[float]]()
    for lines in found.told.values():
        process, seconds, size = lines[-1].split()
        spent += float(seconds)
        sizes.setdefault(process, []).append(float(size))
    return spent, sizes


def told(name: str, works: Sequence[Work], where: int | str) -> float:
    """Print what works cost; return s by the clock."""
    found, clock, own, size = ran(works, where)
    spent, sizes = costs(found)
    count = len(works)
    grown = ", ".join(map(_grown, sizes.values()))
    print(
        f"{name:26s} {count:4d} works {clock:7.1f} s, {spent / count:6.3f} s CPU each, "
        f"parent {1000 * own / count:5.1f} ms each, {size / count / 1000:6.0f} kB each; MB: {grown}"
    )
    return clock


def _grown(sizes: Sequence[float]) -> str:
    """Return the MB of a process after its first work, after a third, two thirds, all of them."""
    inner = sorted(sizes)  # as the works are listed is not as they were done; it never shrinks
    last = len(inner) - 1
    return " ".join(f"{inner[last * k // 3]:.0f}" for k in range(4))


def main() -> None:
    """Print the tables."""
    asked = argparse.ArgumentParser()
    asked.add_argument("--variants", type=int, default=60)
    asked.add_argument("--small", type=int, default=300)
    asked.add_argument("--million", action="store_true")
    options = asked.parse_args()
    begun = time.process_time()
    works = variants(options.variants, ("draw",))
    print(f"texts of variants: {1000 * (time.process_time() - begun) / len(works):.1f} ms each")
    sent = [len(parcel(one, "ru")) for one in works]
    print(f"bytes that travel to a worker: {sum(sent) / len(sent):.0f} a variant")
    for makes in (("table",), ("note",), ("page",), ("draw", "table", "note", "page")):
        told(" ".join(makes), variants(6, makes), 1)
    one, two = told("draw, 1 process", works, 1), told("draw, 2 processes", works, 2)
    print(
        f"ratio {one / two:.2f} on {len(os.sched_getaffinity(0))} processors, load {os.getloadavg()[0]:.1f}"
    )
    small(options.small)
    if options.million:
        million()
    print(f"this process: {largest():.0f} MB at most")


def small(count: int) -> None:
    """Print what a piece of work costs that is nothing, by processes and by a cluster; and to find it made."""
    for where in (1, 2):
        _, clock, own, _ = ran(sums(count), where)
        print(
            f"nothing, {where} processes: {1000 * clock / count:.2f} ms each, parent {1000 * own / count:.2f}"
        )
    with tempfile.TemporaryDirectory() as folder:
        run(sums(count), Path(folder), executor=0)
        clock = time.perf_counter()
        assert len(run(sums(count), Path(folder), executor=0).kept) == count
        print(f"found made: {1000 * (time.perf_counter() - clock) / count:.2f} ms each")
    from distributed import LocalCluster

    with LocalCluster(
        n_workers=2, threads_per_worker=1, dashboard_address=None, silence_logs=50
    ) as cluster:
        _, clock, own, _ = ran(sums(count), cluster.scheduler_address)
        print(
            f"nothing, cluster: {1000 * clock / count:.2f} ms each, parent {1000 * own / count:.2f}"
        )


def million() -> None:
    """Print how long a record is found and written among many: 4096 folders hold them."""
    from graphic_tmm.classroom.batch.record import Record, read_record, write_record

    with tempfile.TemporaryDirectory() as folder:
        out = Path(folder)
        for there in (250, 2500):
            home = (out / place("7")).parent
            home.mkdir(parents=True, exist_ok=True)
            for k in range(there):
                (home / f"{k}.json").touch()
            begun = time.perf_counter()
            for _ in range(100):
                write_record(out, Record("7", "", {"7/a.svg": "0" * 64}))
            wrote = time.perf_counter() - begun
            begun = time.perf_counter()
            for _ in range(100):
                assert read_record(out, "7")
            found = time.perf_counter() - begun
            works = 4096 * there
            print(
                f"{works:,} works: a record is written in {10 * wrote:.2f} ms, read in {10 * found:.2f} ms"
            )


if __name__ == "__main__":
    from benchmarks import batch

    batch.main()
