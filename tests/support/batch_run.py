"""A run of small works as a process of its own, to be broken off: ``out log count jobs pause``."""

from __future__ import annotations

import sys
from pathlib import Path

from graphic_tmm.classroom.batch.run import BrokenOff, run
from support.batches import sums

if __name__ == "__main__":
    out, log, count, jobs, pause = sys.argv[1:]
    works = sums(int(count), log, float(pause), 2000)
    try:
        ran = run(
            works,
            Path(out),
            executor=int(jobs),
            tell=lambda done, of, name: print(done, of, name, flush=True),
        )
    except BrokenOff as error:
        print("off", error.ran.done, error.ran.of, flush=True)
        sys.exit(130)
    print("end", len(ran.made), len(ran.kept), len(ran.failed), flush=True)
