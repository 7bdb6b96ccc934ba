"""A note is a reader: every number of it stands in the log; it speaks one language, of what is there only."""

from __future__ import annotations

import re

import pytest
from support.notes import looked_up, noted, spoken, stands_for, words_of, worth_of_a_last_digit

from graphic_tmm.note.document import (
    Paragraph,
    Picture,
    Ref,
    SideBySide,
    Table,
    Text,
    numbers,
    runs_of,
    walk,
)

CHEAP = ["slider-diagrams", "lever"]
LANGUAGES = ["ru", "en"]
SCENES = [
    *[(name, language) for name in CHEAP for language in LANGUAGES],
    *[
        pytest.param(name, "ru", marks=pytest.mark.slow)
        for name in ("windrower", "engine", "locomobile", "project")
    ],
]


@pytest.mark.turns(2)
@pytest.mark.parametrize(("name", "language"), SCENES)
def test_every_number_stands_in_the_log(name: str, language: str) -> None:
    made, found = spoken(name, language), list(numbers(noted(name, language)))
    assert len(found) > 100
    wrong = [
        (one.text, one.source, value)
        for one in found
        if not stands_for(one.text, value := looked_up(made, one), worth_of_a_last_digit(made, one))
    ]
    assert not wrong, wrong[:5]


@pytest.mark.parametrize(("name", "language"), SCENES)
def test_what_is_referred_to_is_there_once(name: str, language: str) -> None:
    blocks = list(walk(noted(name, language).blocks))
    ids = [block.id for block in blocks if isinstance(block, Picture | SideBySide | Table)]
    assert len(set(ids)) == len(ids)
    wanted = {run.to for block in blocks for run in runs_of(block) if isinstance(run, Ref)}
    assert wanted <= set(ids)


@pytest.mark.parametrize("language", LANGUAGES)
@pytest.mark.slow
def test_a_note_speaks_one_language(language: str) -> None:
    """English texts hold no Cyrillic letter but in what the scene itself is called."""
    words = [
        run.text
        for block in walk(noted("lever", language).blocks)
        for run in runs_of(block)
        if isinstance(run, Text)
    ]
    own = spoken("lever", language).scene
    told = " ".join(words).replace(own.title, "")
    for field in (*own.title_block.values(), *words_of(own.author)):
        told = told.replace(field, "")
    for link in own.mechanism.links if own.mechanism else ():
        told = told.replace(link.name, "")
    cyrillic = re.findall(r"[а-яё]{3,}", told, re.IGNORECASE)
    if language == "en":
        assert not cyrillic, cyrillic[:10]
    else:
        latin = re.findall(r"\b[a-z]{4,}\b", told)
        assert not latin, latin[:10]


def test_a_scene_without_forces_has_no_word_about_them() -> None:
    told = " ".join(
        run.text
        for block in walk(noted("slider-diagrams", "en").blocks)
        for run in runs_of(block)
        if isinstance(run, Text)
    ).lower()
    assert "velocity" in told
    assert not re.search(r"\b(?:forces?|lever|reactions?|balancing|flywheel)\b", told)


def test_numbers_that_are_not_there_are_found() -> None:
    """The judge of the walk can fail."""
    assert stands_for("39,79", 39.794)
    assert not stands_for("39,79", 39.83)
    assert stands_for("−4,2·10⁻³", -0.00423)
    assert not stands_for("0", 0.6)


def test_a_paragraph_of_a_note_is_never_empty() -> None:
    empty = [
        block
        for block in walk(noted("lever").blocks)
        if isinstance(block, Paragraph) and not block.style and not block.runs
    ]
    assert not empty
