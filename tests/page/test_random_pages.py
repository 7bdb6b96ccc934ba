"""Pages of random mechanisms: every step told, every figure readable, every instrument laid or named."""

from __future__ import annotations

import json
from collections.abc import Callable
from pathlib import Path

import pytest
from support.readable import UNREADABLE, texts
from support.scenes import written
from support.sheets_of_random import scenes

from graphic_tmm.errors import SheetError
from graphic_tmm.page.page import page_data
from graphic_tmm.page.views import plays_of
from graphic_tmm.scene.read import read
from graphic_tmm.studio import sheets


@pytest.mark.slow
def test_random_mechanisms_play(tmp_path: Path, many: Callable[[int, int], int]) -> None:
    """One with its forces, one of four groups without them; six when measured."""
    played = 0
    for text in (text for seed in range(many(0, 2), 3) for text in scenes(2, seed)):
        try:
            made, found = sheets(read(written(tmp_path, text)))
        except SheetError:
            continue  # what no sheet holds is refused, and has no page
        played += 1
        data = page_data(made, found)
        json.dumps(data, allow_nan=False)
        assert data["views"]
        assert [one for one in texts(data["views"]) if UNREADABLE.search(one)] == []
        for view in data["views"]:
            for n, stop in enumerate(view["pictures"][1:], 1):
                assert stop["lines"] or stop.get("again"), (view["id"], n)
                for line in stop["lines"]:
                    assert "op" not in line or line.get("tool") or line.get("calc"), line
        for _, _, play in plays_of(made, found):
            told = {one.slot for stop in play.stops for one in stop.told}
            assert told >= {slot for one in play.shown for slot in one.marks}
    assert played
