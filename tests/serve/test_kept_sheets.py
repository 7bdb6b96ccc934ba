"""What is kept of a scene is bounded by number and by bytes; what is shown stays."""

from __future__ import annotations

import pytest

from graphic_tmm.serve import kept as keeping
from graphic_tmm.serve.kept import Kept, KeptSheet


def kept_of(sizes: list[int]) -> tuple[Kept, list[str]]:
    kept = Kept("scene")
    return kept, [kept.keep(bytes([k]) * size) for k, size in enumerate(sizes)]


def test_the_oldest_go_when_there_are_too_many_bytes(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(keeping, "KEPT_BYTES", 1000)
    kept, names = kept_of([400, 500, 300, 100])
    assert list(kept.contents) == names[1:]
    kept.keep(b"x" * 2000)  # what a browser is just told of is there, whatever its size
    assert len(kept.contents) == 1


def test_the_oldest_go_when_there_are_too_many(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(keeping, "KEPT", 3)
    kept, names = kept_of([1] * 6)
    assert list(kept.contents) == names[3:]


def test_what_is_shown_stays_however_old_it_is(monkeypatch: pytest.MonkeyPatch) -> None:
    monkeypatch.setattr(keeping, "KEPT_BYTES", 1000)
    kept, (sheet, page) = kept_of([300, 300])
    kept.sheets, kept.page = (KeptSheet("s", sheet, 1.0, 1.0),), page
    kept.keep(b"a" * 900)
    last = kept.keep(b"b" * 900)
    assert list(kept.contents) == [sheet, page, last]
