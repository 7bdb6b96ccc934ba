"""The specimen shows every character of the alphabet, between its lines, and all sizes."""

from __future__ import annotations

from itertools import pairwise

import pytest
import shapely

from graphic_tmm.chapters.lettering.views import CAPITALS, LARGE, kinds, specimen
from graphic_tmm.paper.lettering.glyphs import characters
from graphic_tmm.paper.lettering.letters import (
    SIZES,
    plain,
)
from graphic_tmm.paper.shapes import box, shape

VIEWS = {view.name: view for view in specimen("ru", 7.0)}


@pytest.mark.parametrize(("name", "inclined"), [("upright", False), ("inclined", True)])
def test_every_character_of_the_alphabet_is_shown(name: str, inclined: bool) -> None:
    labels = [k for k in VIEWS[f"lettering-{name}"].labels if k.size == CAPITALS]
    assert {plain(label.text) for label in labels} == {c for c in characters() if c.strip()}
    assert {label.inclined for label in labels} == {inclined}


def test_characters_do_not_touch_each_other() -> None:
    for name in ("upright", "inclined"):
        labels = [k for k in VIEWS[f"lettering-{name}"].labels if k.size == CAPITALS]
        for first, second in pairwise(labels):
            if first.at.imag == second.at.imag:
                assert box(first).disjoint(box(second))


def test_the_alphabets_stand_in_their_order() -> None:
    rows = kinds()
    assert rows["1 cyrillic"] == "АБВГДЕЁЖЗИЙКЛМНОПРСТУФХЦЧШЩЪЫЬЭЮЯ"
    assert rows["2 cyrillic"] == rows["1 cyrillic"].lower()
    assert rows["3 latin"].startswith("ABCDEFGHIJKLMNOPQRSTUVWXYZ")
    assert rows["8 figures"] == "0123456789"
    assert all(sign in rows["9 signs"] for sign in "·×°′″±−≤≥≈≠→⊥∥∠√∫∞")


def test_all_sizes_of_the_sheets_are_shown() -> None:
    sizes = [label.size for label in VIEWS["lettering-sizes"].labels[1:]]
    assert sizes == list(SIZES)


@pytest.mark.parametrize("name", ["grid", "grid-inclined"])
def test_letters_on_the_grid_stand_inside_it(name: str) -> None:
    view = VIEWS[f"lettering-{name}"]
    grid = shapely.union_all([shape(stroke) for stroke in view.strokes]).convex_hull
    for label in view.labels[1:]:
        assert label.size == LARGE
        frame = box(label)
        assert grid.buffer(1e-6).covers(frame) or label.inclined


def test_the_specimen_speaks_english_too() -> None:
    titles = [view.title for view in specimen("en", 7.0)]
    assert titles[0].startswith("Letters on their grid")
