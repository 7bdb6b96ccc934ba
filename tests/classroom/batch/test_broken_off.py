"""A run that is broken off leaves whole files, no process, and goes on where it was."""

from __future__ import annotations

import os
import random
import signal
import subprocess
import sys
import time
from collections import Counter
from pathlib import Path

import pytest
from support.batches import due, files_of
from support.gallery import ROOT

COUNT, SIZE, PAUSE = 24, 2000, 0.1


def begun(home: Path, pause: float = PAUSE) -> subprocess.Popen[str]:
    command = [sys.executable, "-m", "support.batch_run", home / "out", home / "log"]
    rest = [COUNT, 2, pause]
    return subprocess.Popen(
        [str(one) for one in (*command, *rest)],
        stdout=subprocess.PIPE,
        stderr=subprocess.PIPE,
        text=True,
        start_new_session=True,
        env={**os.environ, "PYTHONPATH": str(ROOT / "tests")},
    )


def left(session: int) -> list[str]:
    """Return the processes of a session that still live, by their command lines."""
    found = []
    for stat in Path("/proc").glob("[0-9]*/stat"):
        try:
            _, _, rest = stat.read_text().rpartition(")")
            if int(rest.split()[3]) == session and rest.split()[0] != "Z":
                found.append((stat.parent / "cmdline").read_text().replace("\0", " "))
        except (OSError, ValueError):
            continue
    return found


def none_left(session: int, within: float) -> bool:
    until = time.monotonic() + within
    while left(session):
        if time.monotonic() > until:
            return False
        time.sleep(0.05)
    return True


def after(process: subprocess.Popen[str], lines: int) -> None:
    assert process.stdout is not None
    for _ in range(lines):
        assert process.stdout.readline()


def finished(home: Path) -> list[str]:
    process = begun(home)
    told, errors = process.communicate(timeout=120)
    assert process.returncode == 0, errors
    return told.splitlines()[-1].split()


def whole(home: Path) -> int:
    """Assert that files are whole, and that a second run makes just the rest; return how many there were."""
    there = files_of(home / "out")
    parts = [name for name in there if name.endswith(".part")]
    full = due(COUNT, SIZE)
    assert all(full[name] == data for name, data in there.items() if name not in parts)
    done = Counter((home / "log").read_text().split()) if (home / "log").exists() else Counter()
    end, made, kept, failed = finished(home)
    assert (end, int(made) + int(kept), failed) == ("end", COUNT, "0")
    assert {name: data for name, data in files_of(home / "out").items()} == full
    again = Counter((home / "log").read_text().split()) - done
    assert sum(again.values()) == int(made)
    assert all(count == 1 for count in again.values())
    assert finished(home) == ["end", "0", str(COUNT), "0"]
    return int(kept)


pytestmark = pytest.mark.skipif(sys.platform != "linux", reason="processes are found in /proc")


@pytest.mark.slow
def test_killed_at_any_moment(tmp_path: Path) -> None:
    chance, kept = random.Random(5), []
    for trial in range(4):
        home = tmp_path / f"{trial}"
        home.mkdir()
        process = begun(home)
        after(process, chance.randrange(1, COUNT // 2))
        time.sleep(chance.uniform(0.0, 0.05))
        process.kill()
        process.communicate()
        assert none_left(process.pid, 5.0), left(process.pid)
        kept.append(whole(home))
    assert all(0 < count < COUNT for count in kept), kept


@pytest.mark.slow
def test_broken_off_by_the_terminal(tmp_path: Path) -> None:
    """Ctrl-C reaches every process of the terminal; only the first one hears it."""
    import os

    process = begun(tmp_path)
    after(process, 5)
    os.killpg(process.pid, signal.SIGINT)
    told, errors = process.communicate(timeout=30)
    assert process.returncode == 130
    assert errors == ""
    off, done, of = told.splitlines()[-1].split()
    assert (off, of) == ("off", str(COUNT))
    assert none_left(process.pid, 5.0), left(process.pid)
    assert whole(tmp_path) == int(done)


@pytest.mark.slow
def test_long_works_do_not_outlive_the_run(tmp_path: Path) -> None:
    process = begun(tmp_path, 0.4)
    after(process, 1)
    process.send_signal(signal.SIGINT)
    begun_at = time.monotonic()
    process.communicate(timeout=30)
    assert time.monotonic() - begun_at < 5.0
    assert none_left(process.pid, 2.0), left(process.pid)
