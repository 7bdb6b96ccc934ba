"""Keys are right: the ram's speeds and accelerations of variants of the shaper against its vector loop."""

from __future__ import annotations

from pathlib import Path

import numpy as np
import pytest
from support.gallery import SHEETS
from support.shaper_keys import offs

from graphic_tmm.classroom.batch.work import done
from graphic_tmm.classroom.tasks.work import works
from graphic_tmm.classroom.variants.start import start_of
from graphic_tmm.classroom.variants.table import read_variants
from graphic_tmm.classroom.variants.variant import base

TABLE = """variant,"OA, mm","OB, mm","BC, mm","CD, mm","drive.speed, rpm","link 3, mass, kg","link 5, mass, kg"
01,105,340,540,200,75,27,40
02,115,355,670,170,65,26,55
"""
"""Two as `variants` draws them."""


@pytest.mark.slow
def test_keys_of_drawn_variants_are_those_of_the_loop(tmp_path: Path) -> None:
    """A length is read to 0.05 mm, and next to a dead centre of the stone several times as much comes of it."""
    table = tmp_path / "class.csv"
    table.write_text(TABLE, encoding="utf-8")
    of = base(SHEETS / "shaper")
    start = start_of(of)
    for one in read_variants(table):
        (_, key) = works(of, (one,), str(table), keys=("table",), start=start, language="en")
        (text,) = (text for name, text in done(key).files.items() if name.endswith(".csv"))
        file = tmp_path / "key.csv"
        file.write_text(str(text), "utf-8")
        values = {value.key: float(value.typed) for value in one.values}
        away = [one.off for one in offs(values, file)]
        assert len(away) >= 14
        assert max(away) <= 1.0, (one.name, max(away))
        assert np.median(away) <= 0.15
