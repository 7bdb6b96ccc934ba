"""Works for tests of batches: small ones that count how often they are done, and those that go wrong."""

from __future__ import annotations

import os
import signal
import time
from collections.abc import Mapping
from hashlib import sha256
from pathlib import Path
from typing import NamedTuple

from graphic_tmm.classroom.batch.work import Done, Work
from graphic_tmm.errors import Fault, SceneError


class Sum(NamedTuple):
    """Numbers to be added; ``log``: a file that gets a line each time; ``pause``: s that it takes."""

    numbers: tuple[int, ...]
    log: str = ""
    pause: float = 0.0
    size: int = 1


def summed(given: Sum) -> Done:
    if given.log:
        with open(given.log, "a", encoding="utf-8") as stream:
            stream.write(f"{sum(given.numbers)}\n")
    time.sleep(given.pause)
    total = f"{sum(given.numbers)}\n" * given.size
    folder = f"{sum(given.numbers)}"
    return Done({f"{folder}/sum.txt": total, f"{folder}/sum.bin": total.encode()}, ("added",))


def dies(given: str) -> Done:
    """Dies, after so many s if that is given."""
    time.sleep(float(given or 0))
    os._exit(7)


def killed(given: str) -> Done:
    os.kill(os.getpid(), signal.SIGKILL)
    return Done({})


def dies_once(given: str) -> Done:
    """Dies if the file is not there, which it then is."""
    try:
        Path(given).touch(exist_ok=False)
    except FileExistsError:
        return Done({f"{Path(given).name}/alive.txt": "alive"})
    os._exit(7)


def hangs(given: str) -> Done:
    """Never ends, and lets others of its process go on."""
    while True:
        time.sleep(1.0)


def hangs_in_machine_code(given: str) -> Done:
    """Never ends, in one call that lets nothing of Python go on."""
    return Done({"never.txt": str(sum(range(10**18)))})


def hangs_once(given: str) -> Done:
    """Never ends if the file is not there, which it then is."""
    try:
        Path(given).touch(exist_ok=False)
    except FileExistsError:
        return Done({f"{Path(given).name}/ended.txt": "ended"})
    return hangs(given)


def bytes_of(given: tuple[str, ...], files: Mapping[str, bytes]) -> Done:
    return Done({f"{len(given)}.bin": b"".join(files[one] for one in given)})


def raises_once(given: str) -> Done:
    try:
        Path(given).touch(exist_ok=False)
    except FileExistsError:
        return Done({f"{Path(given).name}/fine.txt": "fine"})
    raise RuntimeError("not now")


def raises(given: str) -> Done:
    with open(given, "a", encoding="utf-8") as stream:
        stream.write("raised\n")
    raise RuntimeError("never")


def refused(given: str) -> Done:
    with open(given, "a", encoding="utf-8") as stream:
        stream.write("refused\n")
    raise SceneError("7.toml", (Fault("OA", 3, "is too long"),))


def named(given: tuple[str, ...]) -> Done:
    return Done({name: f"of {name}" for name in given})


def environment(given: tuple[str, ...]) -> Done:
    return Done({"env.txt": "\n".join(os.environ.get(name, "-") for name in given)})


def work(operation: object, name: str, given: object) -> Work:
    """Return the work of an operation of this module."""
    return Work(name, f"{__name__}:{operation.__name__}", given)  # type: ignore[attr-defined]


def bringing(*files: Path) -> Work:
    """Return the work of joining the bytes of files as they are now."""
    brings = tuple((str(one), sha256(one.read_bytes()).hexdigest()) for one in files)
    return work(bytes_of, "bytes", tuple(map(str, files)))._replace(brings=brings)


def sums(count: int, log: object = "", pause: float = 0.0, size: int = 1) -> list[Work]:
    """Return small works; number k makes ``k/sum.txt`` and ``k/sum.bin``."""
    return [work(summed, f"{k}", Sum((k,), str(log), pause, size)) for k in range(count)]


def files_of(folder: Path) -> dict[str, bytes]:
    """Return what stands in a folder but the records."""
    found = (path for path in folder.rglob("*") if path.is_file())
    named = {path.relative_to(folder).as_posix(): path for path in found}
    return {
        name: path.read_bytes()
        for name, path in sorted(named.items())
        if not name.startswith(".graphic-tmm/")
    }


def due(count: int, size: int = 1) -> dict[str, bytes]:
    """Return the files that `sums` makes."""
    told = {k: f"{k}\n".encode() * size for k in range(count)}
    both = [(f"{k}/sum.{end}", text) for k, text in told.items() for end in ("bin", "txt")]
    return dict(sorted(both))
