"""What takes long is told on a terminal, and only then."""

from __future__ import annotations

import io
import sys
import threading

import pytest

from graphic_tmm.commands.shared import telling


class Terminal(io.StringIO):
    """A stream that takes itself for a terminal."""

    def isatty(self) -> bool:
        """Return that it is one."""
        return True


@pytest.mark.parametrize(
    ("stream", "patience"), [(Terminal, 0.0), (Terminal, 1e6), (io.StringIO, 0.0)]
)
def test_only_what_takes_long_is_told_and_only_on_a_terminal(
    monkeypatch: pytest.MonkeyPatch, stream: type[io.StringIO], patience: float
) -> None:
    shown = stream()
    monkeypatch.setattr(sys, "stderr", shown)
    monkeypatch.setattr(telling, "PATIENCE", patience)
    monkeypatch.setenv("TERM", "xterm")
    with telling.waiting("composing the sheets"):
        if patience == 0.0:
            for one in threading.enumerate():
                if isinstance(one, threading.Timer):
                    one.join()
    told = "composing the sheets" in shown.getvalue()
    assert told is (stream is Terminal and patience == 0.0)
