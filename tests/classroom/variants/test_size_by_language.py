"""How large a variant is drawn does not hang on the language that its sheets are told in."""

from __future__ import annotations

from dataclasses import replace

import pytest
from support.gallery import SHEETS

from graphic_tmm.classroom.marks.judging import Task, sizes_of
from graphic_tmm.classroom.variants.start import begun, start_of
from graphic_tmm.classroom.variants.variant import Value, Variant, base, scene_of, text_of


@pytest.mark.slow
def test_a_variant_is_as_large_in_another_language() -> None:
    of = base(SHEETS / "shaper")
    row = {"OA": "120", "OB": "335", "BC": "690", "CD": "190", "drive.speed": "40 rpm"}
    one = Variant("05", tuple(Value(key, value) for key, value in row.items()))
    scene, start = scene_of(of, one), start_of(of)
    english = replace(scene, language="en")
    _, due = begun(scene, start)
    _, found = begun(english, start, scene.language)
    assert found.composition.sizes == due.composition.sizes
    assert len(found.sheets) == len(due.sheets)
    assert all(sheet.language == "en" for sheet in found.sheets)
    task = Task(text_of(of, one), "05.toml", "en", start, lent=True)
    judged = sizes_of(task)
    assert judged is not None
    assert judged.sizes == due.composition.sizes
