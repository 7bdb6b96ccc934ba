"""Captions: each name is told once, whoever asks for it; a chapter that is not there brings none."""

from __future__ import annotations

from collections import Counter
from pathlib import Path

import pytest
from support import triangle
from support.command import invoke
from support.each import each
from support.gallery import SHEETS

from graphic_tmm.readers.text import result_name
from graphic_tmm.scene.captions import COMMON, Named, captions, view_name
from graphic_tmm.scene.chapter import added, chapters


def test_no_name_has_two_captions() -> None:
    told = Counter([*COMMON, *(name for one in chapters() for name in Named.of(one).captions)])
    assert [name for name, times in told.items() if times > 1] == []


@each("language", ["en", "ru"])
def test_a_chapter_brings_its_captions_and_takes_them_along(language: str) -> None:
    before = set(captions(language))
    with added(triangle.CHAPTER):
        assert set(captions(language)) - before == {"triangle"}
        assert view_name("triangle", language) == "Triangle by its sides"
    assert set(captions(language)) == before
    assert view_name("triangle", language) == "triangle"


@pytest.mark.parametrize(
    ("view", "english", "russian"),
    [
        ("positions", "Plan of positions", "План положений механизма"),
        ("engine N", "Pressure N on the guide", "Давление на направляющую N"),
        ("forces 2-3", "Force polygon of group 2-3", "План сил группы 2-3"),
        ("group 1", "Link 1", "Звено 1"),
        ("diagram S", "Displacement diagram", "Диаграмма перемещений"),
        (
            "forces 4-5 2",
            "Force polygon of group 4-5, pass 2",
            "План сил группы 4-5, приближение 2",
        ),
    ],
)
def test_a_view_has_a_name_in_each_language(view: str, english: str, russian: str) -> None:
    assert (view_name(view, "en"), view_name(view, "ru")) == (english, russian)


@pytest.mark.parametrize(
    ("result", "english", "russian"),
    [
        ("planetary_z3", "z_3", "z_3"),
        ("contact_ratio_drawn", "ε_dr", "ε_чер"),
        ("r0_min_p95", "r_0min p95", "r_0min p95"),
        ("r_b1", "r_b1", "r_b1"),
    ],
)
def test_a_result_is_called_by_its_caption_or_its_letter(
    result: str, english: str, russian: str
) -> None:
    assert (result_name(result, "en"), result_name(result, "ru")) == (english, russian)


def test_a_warning_names_the_point_of_a_diagram(tmp_path: Path) -> None:
    """A rod shorter than its crank: two positions are missing, and so are the curves through them."""
    text = (SHEETS / "slider-diagrams" / "scene.toml").read_text(encoding="utf-8")
    text = text.replace('integral = "none"', 'integral = "drawn"').replace("750 mm", "140 mm")
    path = tmp_path / "scene.toml"
    path.write_text(text, encoding="utf-8")
    told = invoke("table", str(path), "-f", "json")
    assert "диаграмма перемещений точки B, шаг" in told.stderr
