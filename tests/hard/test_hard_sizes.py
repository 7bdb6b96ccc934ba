"""Large files of every hostile shape: read or refused in a time that grows with their size.

What took the square of it needed minutes; a clock of the processor's own time ends it long before.
"""

from __future__ import annotations

import signal
from collections.abc import Callable, Iterator
from contextlib import contextmanager
from pathlib import Path
from typing import Any

import pytest
from support.each import each
from support.hostile import READINGS, SCENES

from graphic_tmm.accuracy.geometrography import MINUTES, read_minutes
from graphic_tmm.checking.readings.read import read_readings
from graphic_tmm.errors import SceneError
from graphic_tmm.scene.document import several
from graphic_tmm.scene.new import schema
from graphic_tmm.scene.packaged import SCENE
from graphic_tmm.scene.read import read

pytestmark = pytest.mark.skipif(
    not hasattr(signal, "SIGVTALRM"), reason="no clock of the processor"
)
BREAK_OFF = 2
"""Seconds of the processor; the slowest shape takes a tenth of that."""
SHARE = 4
"""So many times smaller than they may be the files are, and the square of their size sixteen times."""


@contextmanager
def clock() -> Iterator[None]:
    def ring(*_: Any) -> None:
        raise TimeoutError("it is broken off")

    before = signal.signal(signal.SIGVTALRM, ring)
    signal.setitimer(signal.ITIMER_VIRTUAL, BREAK_OFF)
    try:
        yield
    finally:
        signal.setitimer(signal.ITIMER_VIRTUAL, 0)
        signal.signal(signal.SIGVTALRM, before)


def cut(text: str, size: int) -> bytes:
    """Return the beginning of a text that is no larger than a file may be."""
    return text.encode("utf-8")[:size].decode("utf-8", "ignore").encode("utf-8")


def told(work: Callable[[], object]) -> str:
    """Return the message of what is refused, broken off if it takes too long; "" if it is not refused."""
    with clock():
        try:
            work()
        except SceneError as refused:
            return str(refused)
    return ""


@pytest.mark.slow
@each("what", SCENES, turns=3)
def test_a_large_scene_is_refused_in_few_words(what: str, tmp_path: Path) -> None:
    file = tmp_path / "scene.toml"
    file.write_bytes(cut(SCENES[what](SCENE.largest // SHARE), SCENE.largest // SHARE))
    said = told(lambda: read(str(file)))
    assert 0 < len(said) < 60_000
    assert "too large" not in said


@pytest.mark.slow
@each("what", READINGS, turns=3)
def test_many_readings_are_read_or_refused_in_few_words(what: str, tmp_path: Path) -> None:
    file = tmp_path / "r.csv"
    file.write_bytes(cut(READINGS[what](1_000_000 // SHARE), 1_000_000 // SHARE))
    assert len(told(lambda: read_readings(file))) < 60_000


@pytest.mark.slow
@each("what", SCENES, turns=3)
def test_a_large_table_of_minutes_is_refused_in_few_words(what: str, tmp_path: Path) -> None:
    file = tmp_path / "minutes.toml"
    file.write_bytes(cut(SCENES[what](MINUTES.largest // SHARE), MINUTES.largest // SHARE))
    assert len(told(lambda: read_minutes(str(file)))) < 60_000


def test_the_sections_that_may_stand_several_times_are_lists_of_the_scene() -> None:
    keys = schema()["properties"]
    several_times = {name for name in keys if keys[name].get("type") == "array"}
    either = {name for name in keys if {"anyOf", "oneOf"} & keys[name].keys()}
    assert several_times <= several() <= several_times | either
