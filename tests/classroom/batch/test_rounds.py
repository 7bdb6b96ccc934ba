"""Ctrl-C comes where it is looked for; the second one at once; nobody else's handler is touched."""

from __future__ import annotations

import signal
import threading
from collections.abc import Iterator

import pytest

from graphic_tmm.classroom.batch.rounds import hearing


@pytest.fixture(autouse=True)
def default() -> Iterator[None]:
    before = signal.signal(signal.SIGINT, signal.default_int_handler)
    yield
    signal.signal(signal.SIGINT, before)


def test_it_comes_where_it_is_looked_for() -> None:
    with hearing() as check:
        check()
        signal.raise_signal(signal.SIGINT)
        with pytest.raises(KeyboardInterrupt):
            check()
    assert signal.getsignal(signal.SIGINT) is signal.default_int_handler


def test_pressed_again_it_comes_at_once() -> None:
    with hearing():
        signal.raise_signal(signal.SIGINT)
        with pytest.raises(KeyboardInterrupt):
            signal.raise_signal(signal.SIGINT)


def test_another_listener_and_another_thread_are_left_alone() -> None:
    heard: list[int] = []
    signal.signal(signal.SIGINT, lambda number, frame: heard.append(number))
    with hearing() as check:
        signal.raise_signal(signal.SIGINT)
        check()
    assert heard == [signal.SIGINT]
    signal.signal(signal.SIGINT, signal.default_int_handler)
    found: list[object] = []

    def within() -> None:
        with hearing():
            found.append(signal.getsignal(signal.SIGINT))

    one = threading.Thread(target=within)
    one.start()
    one.join()
    assert found == [signal.default_int_handler]
