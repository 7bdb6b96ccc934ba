"""Ctrl-C ends the server at once, whatever it does; nothing of it is left behind."""

from __future__ import annotations

import os
import signal
import time
from contextlib import closing
from http.client import HTTPConnection
from pathlib import Path

import pytest
from support.real_server import begun, serving
from support.served import copied, small

pytestmark = [
    pytest.mark.slow,
    pytest.mark.skipif(os.name != "posix", reason="a terminal tells Ctrl-C otherwise here"),
]
ENDED = 130
"""The status of what Ctrl-C has ended."""


def children(process: int) -> list[int]:
    """The processes that one has begun, by any of its threads, and those that these have."""
    told = Path(f"/proc/{process}/task").glob("*/children")
    own = [int(one) for file in told for one in file.read_text().split()]
    return [*own, *(far for one in own for far in children(one))]


def begun_below(process: int, wait: float = 10.0) -> list[int]:
    """The processes that one has begun, awaited: what it says first may come before it begins any."""
    until = time.monotonic() + wait
    while not (found := children(process)) and time.monotonic() < until:
        time.sleep(0.02)
    return found


def gone(process: int) -> bool:
    try:
        state = Path(f"/proc/{process}/stat").read_text().rpartition(") ")[2][0]
    except OSError:
        return True
    return state in "ZX"


def all_gone(processes: list[int]) -> bool:
    until = time.monotonic() + 10.0
    while not all(map(gone, processes)) and time.monotonic() < until:
        time.sleep(0.05)
    return all(map(gone, processes))


@pytest.mark.turns(1)
@pytest.mark.parametrize("after", [0.0, 0.5, 2.0])
def test_ctrl_c_ends_it_at_any_moment_also_while_it_draws(after: float, tmp_path: Path) -> None:
    """From where it has just told where it is to amid a drawing."""
    file = copied("windrower", tmp_path)
    before = file.read_bytes()
    with serving(file) as server:
        server.ask("/s/windrower/sheet/none.svg")  # from here on it draws
        time.sleep(after)
        # at the first moment none may have been begun
        below = begun_below(server.process.pid) if after else children(server.process.pid)
        begun_at = time.monotonic()
        status, errors = server.interrupted()
        taken = time.monotonic() - begun_at
    assert (status, errors.strip()) == (ENDED, "")
    assert taken < 5.0
    assert below or not after
    assert all_gone(below)
    assert file.read_bytes() == before
    assert [one.name for one in file.parent.iterdir()] == ["scene.toml"]


def test_ctrl_c_before_it_has_told_where_it_is_leaves_nothing(tmp_path: Path) -> None:
    file = small(tmp_path)
    with begun(file) as process:
        time.sleep(0.3)
        os.killpg(process.pid, signal.SIGINT)
        process.communicate(timeout=10)
    assert process.returncode
    assert [one.name for one in file.parent.iterdir()] == ["scene.toml"]


def test_ctrl_c_does_not_wait_for_who_follows(tmp_path: Path) -> None:
    with (
        serving(small(tmp_path)) as server,
        closing(HTTPConnection(server.host, server.port, timeout=60)) as line,
    ):
        line.request("GET", server.base + "/s/small/events")
        with line.getresponse() as following:
            assert following.readline() == b"event: state\n"
            below = begun_below(server.process.pid)
            assert below
            status, errors = server.interrupted()
            assert (status, errors.strip()) == (ENDED, "")
            assert all_gone(below)


def test_a_server_that_is_killed_leaves_no_process(tmp_path: Path) -> None:
    with serving(small(tmp_path)) as server:
        status, _ = server.ask("/s/small/form")
        assert status == 200
        below = begun_below(server.process.pid)
        assert below
        server.process.kill()
        server.process.communicate()
        assert all_gone(below)


def test_a_port_that_is_taken_is_told(tmp_path: Path) -> None:
    with serving(small(tmp_path)) as server:
        with begun(tmp_path / "small", "--port", str(server.port)) as second:
            _, errors = second.communicate(timeout=30)
        assert second.returncode == 2
        assert f"cannot listen at 127.0.0.1, port {server.port}" in errors
        assert errors.count("\n") == 1
